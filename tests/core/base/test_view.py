from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, project, project_vectors, to_camera_axes
from skyline_viewshed.core.base.errors import ObserverOutsideDemError
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.view import open_view, outline_px

CAMERA = Camera(400, 300, 350.0)


POSE = Pose(30.0, 2.0, 1.0)


def view(pose=POSE, camera=CAMERA, elevation_m=0.0):
    terrain = ArrayTerrain(np.full((101, 101), elevation_m, np.float32), 30.0)
    return open_view(terrain, PosedPhoto(camera, pose, Observer(0, 0, 50.0)), 1500.0)


@settings(max_examples=60, deadline=None)
@given(st.floats(0, 360), st.floats(-30, 30), st.floats(-20, 20), st.floats(0, 399), st.floats(0, 299))
def test_a_pixels_ray_comes_back_to_the_pixel(heading_deg, pitch_deg, roll_deg, x, y):
    seen = view(Pose(heading_deg, pitch_deg, roll_deg))
    azimuth, elevation = (np.radians(angle) for angle in seen.ray_of(x, y))
    far = 800.0
    height = 50.0 + far * np.tan(elevation) + 0.87 * far**2 / (2 * 6_371_000)
    back = seen.pixel_of(far * np.sin(azimuth), far * np.cos(azimuth), height)
    assert back == pytest.approx((x, y), abs=1e-6)


def test_vectors_and_angles_project_alike():
    rng = np.random.default_rng(0)
    azimuth, elevation = rng.uniform(0, 360, 500), rng.uniform(-80, 80, 500)
    camera, pose = Camera(400, 300, 350.0, 3.0, -2.0, 0.05, 0.01), Pose(20, 5, -7)
    a, e = np.radians(azimuth), np.radians(elevation)
    vectors = 7.5 * np.cos(e) * np.sin(a), 7.5 * np.cos(e) * np.cos(a), 7.5 * np.sin(e)
    one, other = project(camera, pose, azimuth, elevation), project_vectors(camera, pose, *vectors)
    assert np.isfinite(one[0]).any()
    assert np.array(one) == pytest.approx(np.array(other), rel=1e-9, nan_ok=True)


def test_turning_to_the_cameras_axes_keeps_lengths_and_senses():
    right, down, forward = to_camera_axes(Pose(90.0), np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), np.array([0, 0, 1]))
    assert forward == pytest.approx([1, 0, 0], abs=1e-12)
    assert right == pytest.approx([0, -1, 0], abs=1e-12)
    assert down == pytest.approx([0, 0, -1], abs=1e-12)
    vector = np.array([1.0]), np.array([2.0]), np.array([3.0])
    turned = to_camera_axes(Pose(12, 34, 56), *vector)
    assert float(sum(v**2 for v in turned)[0]) == pytest.approx(14.0)


def test_the_outline_runs_around_the_outer_edge():
    x, y = outline_px(CAMERA)
    assert (x.min(), x.max(), y.min(), y.max()) == (-0.5, 399.5, -0.5, 299.5)
    assert (x[0], y[0]) == (x[-1], y[-1]) == (-0.5, -0.5)


def test_the_wedge_holds_every_pixels_azimuth_and_is_a_circle_when_the_zenith_shows():
    seen = view(Pose(350.0, 20.0, 8.0))
    centre, width = seen.wedge_deg
    azimuth, _ = seen.ray_of(*(v.ravel() for v in np.meshgrid(np.arange(400), np.arange(300))))
    off = np.abs((azimuth - centre + 180) % 360 - 180)
    assert off.max() <= width / 2 + 1e-6 and width < 100
    assert view(Pose(0.0, 80.0)).wedge_deg[1] == 360.0


def test_a_place_off_the_dem_is_refused():
    terrain = ArrayTerrain(np.zeros((11, 11), np.float32), 30.0)
    with pytest.raises(ObserverOutsideDemError):
        open_view(terrain, PosedPhoto(CAMERA, Pose(0.0), Observer(1.0, 1.0)), 1000.0)
