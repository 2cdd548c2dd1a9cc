import numpy as np
import pytest
from skyline_viewshed.core.locate.unique import Traits, UniqueOptions, orientability, probability_of, table, traits_of


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
    assert np.median(other.twins) < 0.1 and np.median(other.gap) > 0.8


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


def test_the_probability_rises_with_the_gap_and_falls_with_twins():
    weights = {"bias": 1.0, "features": {"log_gap": {"mean": 0.0, "spread": 0.5, "weight": 0.3}}}
    values, same, none = np.array([0.5, 1.0, 2.0]), np.full(3, 1.0), np.zeros(3)
    for change, sign in (("gap", 1), ("twins", -1)):
        given = {"relief_deg": same, "gap": same, "twins": none, "error_deg": none, change: values}
        assert (sign * np.diff(probability_of(Traits(none, none + 1, **given), weights)) > 0).all()


def test_nearer_terrain_and_a_worse_position_make_a_direction_less_sure():
    angle, _ = peaks((90.0, 4.0, 12.0), (118.0, 2.0, 5.0))
    found = [orientability(angle, np.full(720, far_m), 60.0, 90.0).probability[104] for far_m in (200.0, 1e3, 5e3, 4e4)]
    assert (np.diff(found) > 0).all() and found[0] < found[-1] - 0.15
    worse = [UniqueOptions(position_error_m=error_m) for error_m in (2.0, 50.0, 200.0)]
    found = [orientability(angle, np.full(720, 3e3), 60.0, 90.0, options).probability[104] for options in worse]
    assert (np.diff(found) < 0).all()


def test_a_tilt_that_no_roll_explains_tells_directions_apart():
    angle, distance = peaks((90.0, 4.0, 10.0), (270.0, 4.0, 10.0))
    offset = np.arange(0, 360, 0.5) - 270
    for slope, twins in ((0.05, 1.0), (0.36, 0.0)):  # 3 and 20 degrees
        tilted = angle + np.where(np.abs(offset) <= 30, slope * offset, 0)
        found = traits_of(tilted, distance, 30.0, 90.0, only=[90, 270])
        assert found.twins[[90, 270]] == pytest.approx(twins, abs=0.01)


def test_a_narrow_frame_is_compared_at_more_azimuths_than_the_directions():
    # Between whole degrees, the teeth of a comb tell two stretches apart that are alike at whole degrees.
    azimuth = np.arange(0, 360, 0.5)
    angle, distance = peaks((90.0, 2.0, 4.0), (270.0, 2.0, 4.0))
    comb = angle + np.where((azimuth % 1 != 0) & (np.abs(azimuth - 270) < 5), 0.5, 0.0)
    narrow, wide = (traits_of(comb, distance, hfov, 90.0, only=[90]).twins[90] for hfov in (8.0, 60.0))
    assert narrow < 0.01 and wide == pytest.approx(1.0, abs=0.01)
