"""Draws from a pose's doubt have exactly the moments that were asked for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.base.uncertainty import PARAMETERS, Z_90, PoseUncertainty, pose_draws

DOUBT = PoseUncertainty(0.4, 0.2, 0.3, 0.02, 6.0, 3.0, 4.0)


@pytest.mark.parametrize("pairs", [7, 24, 100])
def test_draws_have_the_pose_as_mean_and_the_covariance_asked(pairs):
    draws = pose_draws(DOUBT, pairs)
    assert draws.shape == (2 * pairs, 7)
    assert draws.mean(axis=0) == pytest.approx(np.zeros(7), abs=1e-12)
    assert draws.T @ draws / len(draws) == pytest.approx(np.diag(DOUBT.sigmas**2), abs=1e-9)


def test_draws_are_seeded_and_fewer_pairs_than_parameters_are_refused():
    assert np.array_equal(pose_draws(DOUBT, seed=3), pose_draws(DOUBT, seed=3))
    assert not np.array_equal(pose_draws(DOUBT, seed=3), pose_draws(DOUBT, seed=4))
    with pytest.raises(ValueError, match="7 pairs"):
        pose_draws(DOUBT, 6)


def test_eye_and_dem_add_up_as_independent_errors():
    assert len(PARAMETERS) == 7
    assert DOUBT.sigmas == pytest.approx([0.4, 0.2, 0.3, 0.02, 6.0, 6.0, 5.0])


@given(low=st.floats(-720, 720), width=st.floats(0, 359))
def test_the_heading_s_deviation_comes_from_its_interval_across_north_too(low, width):
    found = DOUBT.with_heading_interval(low, low + width)
    assert found.heading_deg == pytest.approx(width / 2 / Z_90, abs=1e-6)
    assert replace(found, heading_deg=0.4) == DOUBT


@pytest.mark.parametrize(
    "name", ["heading_deg", "pitch_deg", "roll_deg", "focal_relative", "position_m", "eye_m", "dem_m"]
)
def test_negative_deviations_are_refused(name):
    with pytest.raises(ValueError, match="negative"):
        replace(DOUBT, **{name: -0.1})


def test_a_radius_of_places_gives_the_spread_along_each_axis():
    sigma = PoseUncertainty().with_position_radius(10.0).position_m
    places = np.random.default_rng(3).normal(0, sigma, (200_000, 2))
    assert (np.hypot(*places.T) < 10.0).mean() == pytest.approx(0.68, abs=0.005)


def test_a_focal_length_in_percent_is_refused():
    with pytest.raises(ValueError, match="share"):
        PoseUncertainty(focal_relative=1.0)
