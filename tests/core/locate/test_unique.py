import numpy as np
import pytest
from skyline_viewshed.core.locate.unique import ambiguities, orientability, probability_of


def waves(number, height_deg=2.0, distance_m=12_000.0):
    """A horizon of regular waves, which repeats itself `number` times."""
    azimuth = np.arange(0, 360, 0.5)
    return 5 + height_deg * np.cos(np.radians(number * azimuth)), np.full(len(azimuth), distance_m)


def test_a_horizon_that_repeats_itself_is_ambiguous_and_a_random_one_is_not(match_scenes):
    own, *_ = ambiguities(*waves(6), 50.0, 90.0)
    assert own == pytest.approx(5.0, abs=0.3)  # five other directions look alike
    horizon = match_scenes.random_horizon(3, step_deg=0.5)
    other, *_ = ambiguities(horizon.elevation_deg, horizon.distance_m, 50.0, 90.0)
    assert np.median(other) < 0.1


def test_a_flat_horizon_cannot_be_oriented():
    angle, distance = waves(1, height_deg=0.0)
    found = orientability(angle, distance, 50.0, 90.0)
    steep = orientability(*waves(7.3), 50.0, 90.0)
    assert found.mean < 0.3
    assert found.relief_deg.max() < 1e-9 and found.typical_error_deg == 30.0
    assert steep.typical_error_deg < 1.0


def test_near_terrain_makes_the_heading_less_exact(match_scenes):
    horizon = match_scenes.random_horizon(3, step_deg=0.5)
    far = orientability(horizon.elevation_deg, np.full(720, 20_000.0), 50.0, 90.0)
    near = orientability(horizon.elevation_deg, np.full(720, 500.0), 50.0, 90.0)
    assert near.typical_error_deg > 3 * far.typical_error_deg


def test_a_wider_view_is_easier(match_scenes):
    horizon = match_scenes.random_horizon(4, step_deg=0.5)
    wide, narrow = (orientability(horizon.elevation_deg, horizon.distance_m, hfov, 90.0) for hfov in (60.0, 10.0))
    assert wide.mean > narrow.mean


def test_unknown_directions_stay_unknown():
    angle, distance = waves(5.3)
    angle[100:300] = np.nan
    found = orientability(angle, distance, 40.0, 90.0)
    assert np.isnan(found.probability[100]) and np.isfinite(found.probability[300])
    assert np.isnan(found.towards(100.0, 10.0)) and 0 <= found.towards(300.0) <= 1


def test_the_probability_falls_with_the_ambiguity():
    weights = {"bias": 2.0, "log_unique": 1.0, "log_relief": 0.5, "log_hfov": 0.2}
    values = probability_of(np.array([0.0, 1.0, 10.0]), 1.0, 50.0, weights)
    assert (np.diff(values) < 0).all()
