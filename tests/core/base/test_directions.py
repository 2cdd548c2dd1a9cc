"""Directions as vectors give the same pixels as `project`, and leave out none that the picture shows."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, in_frame, project
from skyline_viewshed.core.base.directions import Directions, corner_deg

SPHERE = np.random.default_rng(1)
AZIMUTH = SPHERE.uniform(0.0, 360.0, 4_000)
ELEVATION = np.degrees(np.arcsin(SPHERE.uniform(-1.0, 1.0, 4_000)))


@given(
    heading=st.floats(0.0, 360.0),
    pitch=st.floats(-85.0, 85.0),
    roll=st.floats(-180.0, 180.0),
    focal=st.floats(150.0, 5_000.0),
    k1=st.sampled_from([0.0, -0.05, 0.05]),
)
def test_no_direction_of_the_picture_is_left_out(heading, pitch, roll, focal, k1):
    camera, pose = Camera(640, 480, focal, k1=k1), Pose(heading, pitch, roll)
    directions = Directions.of(AZIMUTH, ELEVATION)
    ahead = directions.ahead(camera, pose)
    x, y = project(camera, pose, AZIMUTH, ELEVATION)
    assert not (in_frame(camera, x, y) & ~ahead).any()
    found = directions.project(camera, pose)
    np.testing.assert_allclose(found[0], x[ahead], atol=1e-6)
    np.testing.assert_allclose(found[1], y[ahead], atol=1e-6)


def test_unknown_directions_are_left_out():
    directions = Directions.of([10.0, 20.0], [np.nan, 0.0])
    assert directions.ahead(Camera(640, 480, 500.0), Pose(15.0)).tolist() == [False, True]


def test_the_cone_reaches_a_quarter_beyond_the_corner():
    assert corner_deg(Camera(800, 600, 750.0)) == pytest.approx(45.0, abs=0.2)  # 1.5 * 500 pixels from the middle
