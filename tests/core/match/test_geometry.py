from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, project
from skyline_viewshed.core.match.geometry import HorizonCurve, horizon_rows, project_trials


def trial(pose, log_focal=0.0, k1=0.0):
    return np.array([[pose.heading_deg, pose.pitch_deg, pose.roll_deg, log_focal, k1]])


@settings(max_examples=25, deadline=None)
@given(st.floats(0, 360), st.floats(-20, 20), st.floats(-8, 8), st.floats(8, 70))
def test_rows_agree_with_a_dense_projection(match_scenes, heading, pitch, roll, hfov):
    horizon = match_scenes.random_horizon(3)
    camera = Camera(256, 192, 128 / np.tan(np.radians(hfov) / 2))
    pose = Pose(heading, pitch, roll)
    found, _, _ = horizon_rows(HorizonCurve(horizon), camera, trial(pose), np.arange(256))
    assert np.abs(found[0] - match_scenes.seen_rows(horizon, camera, pose)).max() < 0.3


def test_trials_project_as_the_camera_does():
    camera = Camera(400, 300, 350.0, k1=-0.05)
    pose = Pose(350.0, 5.0, -3.0)
    azimuth, elevation = np.array([340.0, 355.0, 10.0]), np.array([1.0, 8.0, 12.0])
    x, y = project_trials(camera, trial(pose, np.log(1.03), -0.04), azimuth, elevation)
    x0, y0 = project(Camera(400, 300, 350.0 * 1.03, k1=-0.09), pose, azimuth, elevation)
    assert np.allclose(x[0], x0)
    assert np.allclose(y[0], y0)


def test_unknown_azimuths_are_filled_across_north_and_marked(match_scenes):
    horizon = match_scenes.random_horizon(1)
    elevation = horizon.elevation_deg.copy()
    elevation[:50] = np.nan
    elevation[-50:] = np.nan
    curve = HorizonCurve(replace(horizon, elevation_deg=elevation))
    assert not curve.known[:50].any()
    assert np.isfinite(curve.elevation_deg).all()
    low, high = sorted([elevation[50], elevation[-51]])
    assert low <= curve.elevation_at(0.0) <= high


def test_a_horizon_without_any_known_azimuth_is_refused(match_scenes):
    horizon = match_scenes.random_horizon(1)
    with pytest.raises(ValueError, match="known azimuth"):
        HorizonCurve(replace(horizon, elevation_deg=np.full(3600, np.nan)))


@settings(max_examples=25, deadline=None)
@given(st.floats(-15, 15), st.floats(-8, 8), st.floats(10, 60))
def test_derivatives_of_rows_are_those_of_finite_differences(match_scenes, pitch, roll, hfov):
    curve = HorizonCurve(match_scenes.random_horizon(5))
    camera = Camera(256, 192, 128 / np.tan(np.radians(hfov) / 2))
    columns = np.arange(256)
    centre = np.array([[77.0, pitch, roll, 0.01, -0.02]])
    _, _, jacobian = horizon_rows(curve, camera, centre, columns, derivatives=True)
    for parameter, step in enumerate([2e-2, 2e-2, 2e-2, 1e-3, 1e-2]):
        up, down = centre.copy(), centre.copy()
        up[0, parameter] += step
        down[0, parameter] -= step
        rows = [horizon_rows(curve, camera, trials, columns)[0][0] for trials in (up, down)]
        slope = (rows[0] - rows[1]) / (2 * step)
        # The horizon is a polygon and distortion's own slope is left out: near, not exact.
        assert np.median(np.abs(slope - jacobian[0, :, parameter])) < 0.02 * np.abs(slope).max() + 0.02
