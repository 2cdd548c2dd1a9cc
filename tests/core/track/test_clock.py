"""The offset of a clock from skylines: known fits with known offsets, and cases in which nobody can know."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import Cancelled
from skyline_viewshed.core.base.uncertainty import Z_90
from skyline_viewshed.core.track.clock import ClockOptions, solve_clock, spread_over_walk
from skyline_viewshed.core.track.track import local_m, place_at, track_of

T0 = 1_700_000_000.0
TRUE_S = T0 + np.array([4000.0, 9000, 14000, 21000, 26000, 30000])


@pytest.fixture(scope="module")
def track():
    """A winding walk of ten hours at 1 m/s."""
    time = T0 + np.arange(0, 36_000, 30.0)
    turn = 2 * np.sin((time - T0) / 3000.0)
    north, east = np.cumsum(30 * np.cos(turn)), np.cumsum(30 * np.sin(turn))
    metre = np.degrees(1 / 6_371_000.0)
    return track_of(time, 86.8 + east * metre, 27.9 + north * metre)


def fit_around(track, sigma_m=150.0, strength=6.0, bad=(), wrong_m=0.0):
    """Fits that fall off with the distance from the true place, or from one beside it; the `bad` ones are noise."""
    places = [place_at(track, time) for time in TRUE_S]
    true = [np.array(local_m(track, place.longitude_deg, place.latitude_deg)) + wrong_m for place in places]

    def fit(number, place, kind):
        here = np.array(local_m(track, place.longitude_deg, place.latitude_deg))
        if number in bad:
            return 3.0 * np.sin(np.sum(here) / 400.0)
        return strength * np.exp(-0.5 * np.sum((here - true[number]) ** 2) / sigma_m**2)

    return fit


@pytest.mark.parametrize("offset_s", [0.0, 1800.0, -3 * 3600.0, 5.75 * 3600.0, 200.0])
def test_offsets_are_found_to_well_within_fifty_metres(track, offset_s):
    answer = solve_clock(TRUE_S + offset_s, track, fit_around(track))
    assert abs(answer.offset_s - offset_s) < 40 and answer.probability > 0.95
    assert abs(answer.offset_s - offset_s) < 3 * answer.sigma_s and answer.sigma_s < 60
    assert answer.message.facts["count"] >= 5


def test_one_bad_photograph_in_six_does_not_mislead(track):
    answer = solve_clock(TRUE_S + 3600.0, track, fit_around(track, bad=(2,)))
    assert abs(answer.offset_s - 3600.0) < 40


def test_one_photograph_however_sure_of_a_wrong_place_does_not_decide(track):
    right = fit_around(track)
    wrong = np.array(
        local_m(track, *[getattr(place_at(track, TRUE_S[1] + 5000), n) for n in ("longitude_deg", "latitude_deg")])
    )

    def fit(number, place, kind):
        here = np.array(local_m(track, place.longitude_deg, place.latitude_deg))
        return 500 * np.exp(-0.5 * np.sum((here - wrong) ** 2) / 150**2) if number == 1 else right(number, place, kind)

    answer = solve_clock(TRUE_S + 3600.0, track, fit)
    assert abs(answer.offset_s - 3600.0) < 40


def test_the_fine_fit_decides_where_the_coarse_one_is_off(track):
    coarse, fine = fit_around(track, wrong_m=150.0), fit_around(track)
    answer = solve_clock(TRUE_S + 1800.0, track, lambda *given: (coarse, fine)[given[2]](*given))
    assert abs(answer.offset_s - 1800.0) < 40


def test_the_interval_holds_the_truth_as_often_as_it_says(track):
    """Fits whose best places scatter by what they claim."""
    generator, inside, sigma_m = np.random.default_rng(5), 0, 120.0
    places = [place_at(track, time) for time in TRUE_S]
    true = np.array([local_m(track, place.longitude_deg, place.latitude_deg) for place in places])
    for trial in range(40):
        offset_s, seen = 900.0 * trial - 18_000, true + generator.normal(0, sigma_m, true.shape)

        def fit(number, place, kind, seen=seen):
            here = np.array(local_m(track, place.longitude_deg, place.latitude_deg))
            return -0.5 * np.sum((here - seen[number]) ** 2) / sigma_m**2

        drift_s = generator.normal(0, 60)
        answer = solve_clock(TRUE_S + offset_s + drift_s, track, fit)
        inside += answer.offset_s is not None and abs(answer.offset_s - offset_s - drift_s) < Z_90 * answer.sigma_s
    assert inside >= 34


def test_photographs_within_a_minute_count_as_one(track):
    answer = solve_clock(TRUE_S[0] + np.array([0.0, 20.0, 50.0, 70.0]), track, lambda number, place, kind: 0.0)
    assert answer.offset_s is None and answer.message.facts["count"] == 2


def test_the_photographs_that_are_used_are_spread_over_the_walk():
    options = ClockOptions(photos=4)
    times = 100.0 * np.arange(12)[::-1]
    chosen = spread_over_walk(times, options)
    assert sorted(chosen) == list(range(12))
    assert np.ptp(times[chosen[:4]]) >= 900 and np.diff(np.sort(times[chosen[:4]])).min() == 300


def test_a_weaker_fit_is_less_certain(track):
    strong, weak = (solve_clock(TRUE_S, track, fit_around(track, strength=s)).sigma_s for s in (6.0, 4.0))
    assert weak > strong


@pytest.mark.parametrize(
    "fit",
    [
        lambda number, place, kind: 0.0,
        lambda number, place, kind: None,
        lambda number, place, kind: 6.0 if number == 0 and place.latitude_deg > 28.0 else 0.0,
    ],
    ids=["flat", "outside the DEM", "one photograph alone"],
)
def test_where_nothing_tells_the_clock_is_refused(track, fit):
    answer = solve_clock(TRUE_S, track, fit)
    assert answer.offset_s is None and answer.sigma_s is None and "cannot be determined" in answer.message


def test_noise_alone_is_refused(track):
    for seed in range(5):
        answer = solve_clock(TRUE_S, track, noise(seed))
        assert answer.offset_s is None, seed


def noise(seed):
    generator = np.random.default_rng(seed)
    values = {}

    def fit(number, place, kind):
        key = number, round(place.latitude_deg * 700), round(place.longitude_deg * 700)
        return values.setdefault(key, generator.normal(0.0, 1.0))

    return fit


def test_two_photographs_are_too_few(track):
    answer = solve_clock(TRUE_S[:2], track, fit_around(track))
    assert answer.offset_s is None and "only 2 photos" in answer.message


def test_a_camp_where_all_were_taken_at_one_place_is_refused():
    camp = track_of(T0 + np.arange(0, 36_000, 60.0), np.full(600, 86.8), np.full(600, 27.9))
    answer = solve_clock(TRUE_S, camp, lambda number, place, kind: 5.0)
    assert answer.offset_s is None


def test_cancelling(track):
    class Stopped:
        def report(self, fraction):
            pass

        def cancelled(self):
            return True

    with pytest.raises(Cancelled):
        solve_clock(TRUE_S, track, fit_around(track), ClockOptions(), progress=Stopped())
