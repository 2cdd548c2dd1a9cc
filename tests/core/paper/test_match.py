from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.model import Skyline
from skyline_viewshed.core.paper.match import PaperMatchOptions, correlate, match_paper, skyline_angles

HFOV, VFOV = 60.0, 40.0


def linear_skyline(horizon, heading_deg, tilt_deg, width=301, height=201):
    """The skyline that the paper's linear camera would see."""
    offset = (2 * np.arange(width) - (width - 1)) / (width - 1) * HFOV / 2
    elevation = np.interp(heading_deg + offset, horizon.azimuth_deg, horizon.elevation_deg, period=360) - tilt_deg
    half = (height - 1) / 2
    return Skyline(half - elevation / (VFOV / 2) * half, np.ones(width), width, height)


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 719), st.floats(-6, 6))
def test_heading_and_tilt_of_a_linear_picture_are_found_on_the_grid(match_scenes, step, tilt):
    horizon = match_scenes.random_horizon(11)
    found = match_paper(linear_skyline(horizon, step * 0.5, tilt), HFOV, VFOV, horizon)
    assert found.best.pose.heading_deg == step * 0.5
    assert found.best.pose.pitch_deg == pytest.approx(tilt, abs=1e-6)
    assert found.ncc == pytest.approx(1.0, abs=1e-6)


def test_ncc_is_blind_to_offset_and_scale_of_the_skyline(match_scenes):
    horizon = match_scenes.random_horizon(12)
    offset = np.linspace(-30, 30, 200)
    elevation = np.interp(200 + offset, horizon.azimuth_deg, horizon.elevation_deg)
    one, _ = correlate(np.arange(0, 360, 5.0), offset, elevation, horizon)
    two, tilt = correlate(np.arange(0, 360, 5.0), offset, 3 * elevation + 7, horizon)
    assert np.allclose(one, two)
    assert tilt[40] == pytest.approx(np.mean(elevation) - np.mean(3 * elevation + 7))


def test_equations_five_and_six_at_the_picture_s_corners():
    skyline = Skyline(np.array([0.0, 50.0, 100.0]), np.ones(3), 3, 101)
    offset, elevation = skyline_angles(skyline, 74.0, 53.0)
    assert offset.tolist() == [-37.0, 0.0, 37.0]
    assert elevation.tolist() == [26.5, 0.0, -26.5]


def test_the_whole_curve_is_kept_and_the_second_peak_is_another_hill(match_scenes):
    horizon = match_scenes.random_horizon(13)
    found = match_paper(linear_skyline(horizon, 90.0, 1.0), HFOV, VFOV, horizon, PaperMatchOptions(1.0))
    assert len(found.curve_score) == 360
    second = found.candidates[1].pose.heading_deg
    assert abs((second - 90.0 + 180) % 360 - 180) >= 5.0
    assert found.ncc_second == pytest.approx(found.candidates[1].score)
    assert found.sharpness > 1


def test_the_method_never_calls_its_own_answer_sure(match_scenes):
    horizon = match_scenes.random_horizon(14)
    found = match_paper(linear_skyline(horizon, 10.0, 0.0), HFOV, VFOV, horizon)
    assert found.status == "ambiguous"
    assert found.p_correct is None
    assert found.heading_lo_deg is None


def test_too_short_a_skyline_is_rejected_with_advice(match_scenes):
    horizon = match_scenes.random_horizon(14)
    whole = linear_skyline(horizon, 10.0, 0.0)
    confidence = np.zeros(301)
    confidence[:50] = 1
    found = match_paper(Skyline(whole.row_px, confidence, 301, 201), HFOV, VFOV, horizon)
    assert found.status == "rejected"
    assert "sky mask" in found.message


def test_a_straight_skyline_cannot_be_matched(match_scenes):
    horizon = match_scenes.random_horizon(15)
    found = match_paper(Skyline(np.full(301, 80.0), np.ones(301), 301, 201), HFOV, VFOV, horizon)
    assert found.status == "rejected"


def test_unknown_horizon_leaves_gaps_in_the_curve(match_scenes):
    horizon = match_scenes.random_horizon(16)
    elevation = horizon.elevation_deg.copy()
    elevation[:1800] = np.nan
    found = match_paper(linear_skyline(horizon, 270.0, 0.0), HFOV, VFOV, replace(horizon, elevation_deg=elevation))
    assert found.best.pose.heading_deg == 270.0
    assert np.isnan(found.curve_score[found.curve_heading_deg == 90.0]).all()
