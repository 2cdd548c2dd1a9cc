"""The camera: fields of view by rule, and pixels against directions."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import (
    Camera,
    Pose,
    focal_from_35mm_px,
    focal_of_fov_px,
    folds,
    fov_of_focal_deg,
    in_frame,
    project,
    unproject,
)


@pytest.mark.parametrize(
    "size, f35, hfov",
    [((4032, 3024), 24, 71.59), ((3024, 4032), 24, 56.80), ((6000, 4000), 52, 38.19), ((4032, 3024), 26, 67.29)],
)
def test_diagonal_rule_gives_the_fields_of_view_of_a_43_27_mm_diagonal(size, f35, hfov):
    # Independent form: the sensor with a 43.267 mm diagonal and this aspect has this width.
    width_mm = 43.2666 * size[0] / np.hypot(*size)
    assert 2 * np.degrees(np.arctan(width_mm / 2 / f35)) == pytest.approx(hfov, abs=0.02)
    assert fov_of_focal_deg(size[0], focal_from_35mm_px(*size, f35)) == pytest.approx(hfov, abs=0.02)


def test_the_principal_ray_is_the_picture_s_centre():
    camera = Camera(4000, 3000, 3200.0)
    assert np.allclose(project(camera, Pose(123.0, 7.0, 3.0), 123.0, 7.0), camera.centre_px)


def test_level_camera_follows_the_tangent_of_the_offset():
    camera = Camera(1001, 501, 700.0)
    x, y = project(camera, Pose(0.0), np.array([-20.0, 0.0, 20.0]), 0.0)
    assert np.allclose(x, 500 + 700 * np.tan(np.radians([-20, 0, 20])))
    assert np.allclose(y, 250)


def test_looking_up_moves_the_horizon_down_in_the_picture():
    assert project(Camera(1000, 800, 900.0), Pose(0, pitch_deg=5), 0.0, 0.0)[1] > 399.5


def test_right_side_down_lets_the_horizon_climb_to_the_right():
    camera = Camera(1000, 800, 900.0)
    _, y = project(camera, Pose(0, 0, roll_deg=4), np.array([-10.0, 10.0]), 0.0)
    assert y[1] < y[0]
    slope = (y[0] - y[1]) / (2 * 900 * np.tan(np.radians(10)) * np.cos(np.radians(4)))
    assert np.degrees(np.arctan(slope)) == pytest.approx(4, abs=0.01)


@given(
    st.floats(0, 359.9),
    st.floats(-60, 60),
    st.floats(-45, 45),
    st.floats(300, 20000),
    st.floats(0, 3999),
    st.floats(0, 2999),
    st.sampled_from([(0.0, 0.0), (-0.1, 0.08), (0.05, -0.01)]),
)
def test_pixels_and_directions_are_inverse(heading, pitch, roll, focal, x, y, distortion):
    # Wide lenses only without distortion: the polynomial is meant for radii below about one focal length.
    k1, k2 = distortion if focal > 2600 else (0.0, 0.0)
    camera, pose = Camera(4000, 3000, focal, 12.0, -20.0, k1, k2), Pose(heading, pitch, roll)
    back = project(camera, pose, *unproject(camera, pose, x, y))
    assert np.allclose(back, (x, y), atol=1e-3)


def test_directions_behind_the_camera_have_no_pixel():
    assert np.isnan(project(Camera(1000, 800, 900.0), Pose(0), 180.0, 0.0)).all()


def test_scaling_keeps_the_field_of_view_and_the_directions():
    camera = Camera(4000, 3000, 3200.0, 30.0, -15.0, -0.1)
    small = camera.scaled(400, 300)
    assert small.hfov_deg == pytest.approx(camera.hfov_deg)
    pose = Pose(10, 2, 1)
    # Pixel centres: x of the small picture covers ten of the large one.
    assert np.allclose(unproject(small, pose, 37.0, 55.0), unproject(camera, pose, 374.5, 554.5), atol=1e-9)


def test_frame_includes_the_outer_half_pixels_and_excludes_the_unknown():
    camera = Camera(10, 8, 20.0)
    x = np.array([-0.5, 9.5, 9.6, np.nan])
    assert in_frame(camera, x, np.zeros(4)).tolist() == [True, True, False, False]


@pytest.mark.parametrize("bad", [0, 180, -3])
def test_an_impossible_field_of_view_is_refused(bad):
    with pytest.raises(ValueError, match="field of view"):
        focal_of_fov_px(1000, bad)


def test_a_camera_without_size_is_refused():
    with pytest.raises(ValueError, match="positive"):
        Camera(0, 10, 5.0)


@pytest.mark.parametrize(("k1", "k2", "folded"), [(0, 0, False), (-0.1, 0.01, False), (0.3, 0, False), (-2, 0, True)])
def test_a_lens_folds_if_its_corners_would_show_nothing(k1, k2, folded):
    camera = Camera(4000, 3000, 3500.0, k1=k1, k2=k2)
    assert folds(camera) is folded
    azimuth, elevation = unproject(camera, Pose(10.0), [0.0], [0.0])
    there = np.array(project(camera, Pose(10.0), azimuth, elevation))
    assert bool((np.abs(there) < 0.01).all()) is not folded
