import numpy as np
import pytest
from skyline_viewshed.core.locate.unique import Traits, orientability, probability_of, table, traits_of


def waves(number, height_deg=2.0, distance_m=12_000.0):
    """A horizon of regular waves, which repeats itself `number` times."""
    azimuth = np.arange(0, 360, 0.5)
    return 5 + height_deg * np.cos(np.radians(number * azimuth)), np.full(len(azimuth), distance_m)


def peaks(*shapes, base_deg=1.0):
    """A level horizon with peaks of (azimuth, height, half width), all in degrees."""
    azimuth = np.arange(0, 360, 0.5)
    angle = np.full(len(azimuth), base_deg)
    for at, height, half_width in shapes:
        away = np.abs((azimuth - at + 180) % 360 - 180)
        angle += height * np.clip(1 - away / half_width, 0, None)
    return angle, np.full(len(azimuth), 12_000.0)


def test_a_horizon_that_repeats_itself_is_ambiguous_and_a_random_one_is_not(match_scenes):
    own = traits_of(*waves(6), 50.0, 90.0)
    assert own.twins == pytest.approx(5.0, abs=0.3)  # five other directions look alike
    assert orientability(*waves(6), 50.0, 90.0).probability.max() < 1 / 5.5
    horizon = match_scenes.random_horizon(3, step_deg=0.5)
    other = traits_of(horizon.elevation_deg, horizon.distance_m, 50.0, 90.0)
    assert np.median(other.twins) < 0.1 and np.median(other.gap) > 1


def test_two_unlike_peaks_are_oriented_and_equal_ones_are_not():
    unlike = orientability(*peaks((90.0, 8.0, 12.0), (118.0, 4.0, 5.0)), 60.0, 90.0)
    equal = orientability(*peaks(*((at, 8.0, 12.0) for at in (0, 90, 180, 270))), 60.0, 90.0)
    assert unlike.probability[104] > 0.8
    assert equal.probability.max() < 0.26  # four directions share it
    assert unlike.probability[280] < 0.1  # the level part of the same horizon


def test_the_summit_of_a_cone_and_the_middle_of_a_ring_are_ambiguous_by_symmetry():
    for angle_deg in (-12.0, 15.0):
        assert orientability(*peaks(base_deg=angle_deg), 60.0, 90.0).probability.max() < 0.05


def test_more_relief_never_makes_a_direction_harder():
    shape = (90.0, 1.0, 12.0), (118.0, 0.5, 5.0)
    found = [
        orientability(*peaks(*((at, factor * height, width) for at, height, width in shape)), 60.0, 90.0)
        for factor in (0.02, 0.1, 0.5, 2.0, 8.0)
    ]
    assert (np.diff([one.probability[104] for one in found]) >= 0).all()
    assert found[-1].probability[104] > found[0].probability[104] + 0.5


def test_the_shipped_weights_have_an_origin_and_none_is_negative():
    assert table()["origin"].startswith("tools/fit_orientability.py")
    assert all(entry["weight"] >= 0 and entry["spread"] > 0 for entry in table()["features"].values())


def test_only_some_directions_are_described_if_asked():
    whole, some = (traits_of(*waves(5.3), 40.0, 90.0, only=only) for only in (None, [7, 90]))
    assert np.flatnonzero(np.isfinite(some.gap)).tolist() == [7, 90]
    assert some.gap[90] == whole.gap[90] and some.relief_deg[7] == whole.relief_deg[7]


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


def test_the_probability_rises_with_each_quantity_and_falls_with_twins():
    entry = {"mean": 1.0, "spread": 0.5, "weight": 0.3}
    weights = {"bias": 1.0, "features": dict.fromkeys(("gap", "log_relief"), entry)}
    values = np.array([1.0, 2.0, 4.0])
    same, none = np.full(3, 2.0), np.zeros(3)
    for change in ("relief_deg", "gap", "twins"):
        given = {"relief_deg": same, "gap": same / 2, "twins": none, "error_deg": none}
        traits = Traits(none, none + 1, **{**given, change: values / 2 if change == "gap" else values})
        steps = np.diff(probability_of(traits, weights))
        assert (steps < 0).all() if change == "twins" else (steps > 0).all()
