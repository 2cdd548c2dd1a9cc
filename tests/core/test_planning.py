"""Predictions and simulated photographs of a small range."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from scenes import mountain_scene
from skyline_viewshed.core.base.errors import ObserverError
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.locate.unique import orientability
from skyline_viewshed.core.planning import TrialOptions, _errors, predict, simulate_trial, summarise


@pytest.fixture(scope="module")
def place():
    scene = mountain_scene(1)
    return scene.terrain, Observer(scene.observer.longitude_deg, scene.observer.latitude_deg, 2.0)


def test_a_prediction_is_that_of_the_exact_horizon(place):
    horizon, (narrow, wide) = predict(*place, (20.0, 60.0))
    again = orientability(horizon.elevation_deg, horizon.distance_m, 60.0, horizon.cell_m)
    assert wide.probability == pytest.approx(again.probability, nan_ok=True)
    assert 0 < narrow.mean < wide.mean < 1
    assert horizon.azimuth_deg[1] == 0.5 and np.nanmax(horizon.distance_m) <= 80_000


def test_a_place_outside_the_dem_is_refused(place):
    with pytest.raises(ObserverError):
        predict(place[0], Observer(20.0, 10.0), (50.0,))


def test_the_same_number_gives_the_same_photograph(place):
    options = TrialOptions("clear", hfov_deg=(50.0, 60.0), seed=3)
    first, again, other = (simulate_trial(*place, number, options) for number in (0, 0, 1))
    assert (first.heading_deg, first.hfov_deg, first.error_deg) == (again.heading_deg, again.hfov_deg, again.error_deg)
    assert other.heading_deg != first.heading_deg
    for trial in (first, other):
        assert 50 <= trial.hfov_deg <= 60 and 0 <= trial.predicted <= 1
        # The camera stands at the true place, and the recorded one is off by metres.
        away_deg = abs(trial.oriented.latitude_deg - place[1].latitude_deg)
        assert 0 < away_deg < 40 / 111_195
    clear = [abs(trial.error_deg) for trial in (first, other) if trial.oriented.status == "accepted"]
    assert all(error < 3 for error in clear)


@pytest.mark.parametrize("wrong", [{"weather": "snow"}, {"hfov_deg": (60.0, 50.0)}, {"hfov_deg": (50.0, 150.0)}])
def test_unusable_options_are_refused(wrong):
    with pytest.raises(ValueError, match="weather must be"):
        TrialOptions(**wrong)


@pytest.mark.parametrize(
    ("found", "interval", "truth", "error", "covered"),
    [
        (10.0, (8.0, 12.0), 9.0, 1.0, True),
        (1.0, (359.0, 3.0), 359.5, 1.5, True),
        (1.0, (359.0, 3.0), 358.5, 2.5, False),
        (1.0, (359.0, 3.0), 4.0, -3.0, False),
        (1.0, None, 359.0, 2.0, None),
        (None, None, 10.0, None, None),
    ],
)
def test_errors_and_intervals_across_north(found, interval, truth, error, covered):
    oriented = SimpleNamespace(heading_deg=found, heading_interval_deg=interval)
    assert _errors(oriented, truth) == (error, covered)


def test_the_summary_counts_photographs_without_an_answer_as_wrong():
    def trial(status, error_deg, covered=None):
        return SimpleNamespace(error_deg=error_deg, covered=covered, oriented=SimpleNamespace(status=status))

    trials = [trial("accepted", 0.2, True), trial("accepted", -5.0, False), trial("rejected", 0.8, True),
              trial("failed", None)]  # fmt: skip
    found = summarise(trials)
    assert (found.photos, found.accepted, found.accepted_wrong) == (4, 2, 1)
    assert dict(found.within) == {0.5: 0.25, 1.0: 0.5, 3.0: 0.5}
    assert found.median_deg == pytest.approx(2.6) and found.covered == 0.5
    none = summarise(trials[2:])
    assert none.accepted == 0 and none.median_deg is None and none.covered is None
