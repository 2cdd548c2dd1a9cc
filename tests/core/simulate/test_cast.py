"""Sight lines of simulated pixels against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.simulate.cast import (
    UNSEEN_TAN,
    Fan,
    first_hits_m,
    pixel_directions,
    ring_distances_m,
    row_blocks,
    skyline_row_px,
    turns_deg,
)

CAMERA = Camera(401, 301, 300.0)
MIDDLE_X, MIDDLE_Y = 200.0, 150.0


def fan_of(tangent, distance=None, first_deg=-60.0, step_deg=0.25, planes=481):
    """The same profile on every plane."""
    distance = np.arange(10.0, 2010.0, 10.0) if distance is None else distance
    tangent = np.broadcast_to(np.asarray(tangent, np.float32), (planes, distance.size))
    azimuth = first_deg + step_deg * np.arange(planes)
    return Fan(azimuth, distance, tangent, np.maximum.accumulate(tangent, axis=1))


def test_pixels_of_a_level_camera_look_by_the_pinhole_s_geometry():
    turn, tangent = pixel_directions(CAMERA, Pose(123.0))
    x, y = np.meshgrid(np.arange(401) - MIDDLE_X, np.arange(301) - MIDDLE_Y)
    assert turn == pytest.approx(np.degrees(np.arctan(x / 300.0)), abs=1e-9)
    assert tangent == pytest.approx(-y / np.hypot(300.0, x), abs=1e-9)


def test_rows_come_alike_alone_and_together():
    pose = Pose(350.0, 7.0, 4.0)
    whole = pixel_directions(CAMERA, pose)
    some = pixel_directions(CAMERA, pose, range(40, 60))
    assert np.array_equal(some, np.array(whole)[:, 40:60])


def test_blocks_of_rows_hold_every_row_once():
    rows = [row for block in row_blocks(Camera(4000, 3001, 3000.0)) for row in block]
    assert rows == list(range(3001))
    assert [len(block) for block in row_blocks(Camera(900_000, 2, 3000.0))] == [1, 1]


def test_the_frame_s_edges_lie_half_the_field_of_view_to_either_side():
    low, high = turns_deg(CAMERA, Pose(40.0))
    assert (low, high) == pytest.approx((-np.degrees(np.arctan(200 / 300)), np.degrees(np.arctan(200 / 300))))


def test_rings_are_close_by_the_eye_and_never_farther_apart_than_a_pixel_or_half_a_cell():
    rings = ring_distances_m(30.0, 1000.0, 20_000.0)
    gaps = np.diff(rings)
    assert 0 < rings[0] < 1 and rings[-1] < 20_000.0 <= rings[-1] + 15.0
    assert (gaps <= 0.02 * rings[:-1] + 1e-9).all()
    assert (gaps <= np.maximum(15.0, 0.7 * rings[:-1] / 1000.0) + 1e-9).all()


def test_sight_lines_meet_level_ground_where_the_tangent_says():
    fan = fan_of(-10.0 / np.arange(10.0, 2010.0, 10.0))
    wanted = np.array([15.0, 155.0, 1234.5])
    assert first_hits_m(fan, np.zeros(3), -10.0 / wanted) == pytest.approx(wanted, rel=1e-3)
    assert first_hits_m(fan, np.zeros(1), np.array([-10.0 / 5000.0])) == np.inf


def test_a_wall_hides_the_ground_behind_it_up_to_its_shadow():
    distance = np.arange(10.0, 2010.0, 10.0)
    height = np.where(np.abs(distance - 500) < 1, 5.0, 0.0)
    fan = fan_of((height - 10.0) / distance)  # from 10 m up: the shadow of 5 m at 500 m ends at 1000 m
    assert first_hits_m(fan, np.zeros(1), np.array([-10.0 / 400.0])) == pytest.approx([400.0], rel=1e-3)
    behind = first_hits_m(fan, np.zeros(3), -10.0 / np.array([600.0, 900.0, 1400.0]))
    assert behind[:2] == pytest.approx([495.0, 495.0], abs=5.1)
    assert behind[2] == pytest.approx(1400.0, rel=1e-3)


@pytest.mark.parametrize("tangent", [0.0, 0.2, -0.15])
def test_a_horizon_of_one_elevation_is_the_hyperbola_of_its_cone(tangent):
    row = skyline_row_px(fan_of(np.full(200, tangent)), CAMERA, Pose(0.0))
    x = np.arange(401) - MIDDLE_X
    assert row == pytest.approx(MIDDLE_Y - tangent * np.hypot(300.0, x), abs=0.02)


def test_a_horizon_beyond_the_frame_or_unknown_has_no_row():
    assert np.isnan(skyline_row_px(fan_of(np.full(200, 0.9)), CAMERA, Pose(0.0))).all()
    assert np.isnan(skyline_row_px(fan_of(np.full(200, UNSEEN_TAN)), CAMERA, Pose(0.0))).all()
