"""Poses changed by hand: what is held stays where it is held, and landmarks give back the pose that placed them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scenes import mountain_scene
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, project, unproject
from skyline_viewshed.core.base.curvature import apparent_drop_m
from skyline_viewshed.core.base.model import Skyline
from skyline_viewshed.core.horizon.horizon import horizon_profile
from skyline_viewshed.core.mapping import adjust

CAMERA = Camera(4000, 3000, focal_of_fov_px(4000, 65.0))
pixels = st.tuples(st.floats(0, 3999), st.floats(0, 2999))
poses = st.builds(Pose, st.floats(0, 359.9), st.floats(-25, 25), st.floats(-8, 8))


@given(poses, pixels, pixels)
def test_a_drag_takes_the_direction_along_and_leaves_the_roll(pose, start, stop):
    direction = unproject(CAMERA, pose, *start)
    moved = adjust.dragged(CAMERA, pose, start, stop)
    assert np.allclose(project(CAMERA, moved, *direction), stop, atol=0.5)
    assert moved.roll_deg == pose.roll_deg


@given(poses, pixels, st.floats(-10, 10))
def test_a_turn_keeps_its_pivot_and_the_right_side_climbs(pose, pivot, turn):
    direction = unproject(CAMERA, pose, *pivot)
    turned = adjust.rolled(CAMERA, pose, pivot, turn)
    assert np.allclose(project(CAMERA, turned, *direction), pivot, atol=0.5)
    assert turned.roll_deg == pytest.approx(pose.roll_deg + turn)


def test_dragging_the_right_side_up_is_a_positive_turn():
    assert adjust.turn_between_deg((0, 0), (100, 0), (100, -100)) == pytest.approx(45)
    level = Pose(10.0)
    turned = adjust.rolled(CAMERA, level, (2000, 1500), 5.0)
    _, left = project(CAMERA, turned, 0.0, 0.0)
    _, right = project(CAMERA, turned, 20.0, 0.0)
    assert right < left


@given(poses, pixels, st.floats(0.5, 2.0))
def test_a_zoom_keeps_the_direction_under_the_mouse(pose, pivot, factor):
    direction = unproject(CAMERA, pose, *pivot)
    camera, moved = adjust.zoomed(CAMERA, pose, factor, pivot)
    assert camera.focal_px == pytest.approx(factor * CAMERA.focal_px)
    assert np.allclose(project(camera, moved, *direction), pivot, atol=0.5)


def test_a_zoom_ends_at_a_possible_field_of_view():
    camera, _ = adjust.zoomed(CAMERA, Pose(0.0), 1e-6, (2000, 1500))
    assert camera.hfov_deg == pytest.approx(adjust.WIDEST_DEG)


@pytest.mark.parametrize("known, hfov", [(True, 65.0), (False, 48.0)])
def test_landmarks_give_back_the_pose(known, hfov):
    truth, camera = Pose(297.0, -8.0, 1.0), Camera(4000, 3000, focal_of_fov_px(4000, hfov))
    azimuth, elevation = np.array([275.0, 300.0, 315.0]), np.array([-3.0, 2.0, -6.0])
    x, y = project(camera, truth, azimuth, elevation)
    marks = np.column_stack([x, y, azimuth, elevation])
    lens, pose = adjust.fitted_to_landmarks(CAMERA, Pose(0.0), marks, 0.025 if known else 0.5)
    assert abs(difference(pose.heading_deg, truth.heading_deg)) < 0.2
    assert (pose.pitch_deg, pose.roll_deg) == pytest.approx((truth.pitch_deg, truth.roll_deg), abs=0.3)
    assert lens.hfov_deg == pytest.approx(hfov, abs=0.6)


def test_one_landmark_decides_heading_and_pitch():
    lens, pose = adjust.fitted_to_landmarks(CAMERA, Pose(0.0, 3.0, 4.0), [(1000, 1000, 200.0, 5.0)], 0.025)
    assert np.allclose(project(lens, pose, 200.0, 5.0), (1000, 1000), atol=5)
    assert pose.roll_deg == pytest.approx(0.0, abs=0.1)


def test_levelling_puts_the_horizon_on_the_skyline():
    scene = mountain_scene(1)
    horizon = horizon_profile(scene.terrain, scene.observer)
    row = np.asarray(scene.view.skyline_row_px, float)
    skyline = Skyline(np.nan_to_num(row), np.isfinite(row).astype(float), scene.camera.width_px, scene.camera.height_px)
    off = Pose(scene.pose.heading_deg, scene.pose.pitch_deg - 6.0, scene.pose.roll_deg)
    assert adjust.levelled(scene.camera, off, horizon, skyline).pitch_deg == pytest.approx(
        scene.pose.pitch_deg, abs=0.15
    )
    nothing = Skyline(np.zeros(640), np.zeros(640), 640, 480)
    assert adjust.levelled(scene.camera, off, horizon, nothing) == off


def test_a_hand_is_a_three_hundredth_of_the_picture():
    assert adjust.hand_sigma_deg(CAMERA) == pytest.approx(65 / 300, rel=0.15)
    assert adjust.assumed_camera(300, 200).hfov_deg == pytest.approx(60.0)


def test_marks_lie_on_the_horizon_and_lead_back_to_it():
    scene = mountain_scene(1)
    terrain, eye = scene.terrain, scene.observer
    horizon = horizon_profile(terrain, eye)
    frame = terrain.frame(eye.longitude_deg, eye.latitude_deg, 40_000.0)
    marks = adjust.horizon_marks(terrain, horizon, frame, scene.camera, scene.pose)
    assert 3 <= len(marks) <= 5
    for x, y, longitude, latitude, elevation_m in marks:
        east, north = terrain.local_of(eye, longitude, latitude)
        distance = np.hypot(east, north)
        rise = elevation_m - apparent_drop_m(distance) - horizon.eye_elevation_m
        direction = np.degrees(np.arctan2(east, north)), np.degrees(np.arctan2(rise, distance))
        assert np.allclose(project(scene.camera, scene.pose, *direction), (x, y), atol=0.5)
    assert adjust.horizon_marks(terrain, horizon, frame, scene.camera, Pose(0.0, 80.0)) == []
