"""Offsets of a clock that have been tried: what a photograph can speak, and where the search goes on."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.track.clock import ClockOptions
from skyline_viewshed.core.track.offsets import COARSE, FINE, OffsetSearch, log_prior
from skyline_viewshed.core.track.track import TrackOptions, track_of

OPTIONS = ClockOptions()
METRE = np.degrees(1 / 6_371_000.0)
TIMES_S = (1000.0, 2000.0, 3000.0)


@pytest.fixture
def search():
    """Three photographs on a straight walk of 1 m/s, which fit best where they were taken."""
    time = np.arange(0.0, 4001.0, 50.0)
    track = track_of(time, 86.8 + 0 * time, 27.9 + time * METRE)

    def fit(number, place, kind):
        metres = (place.latitude_deg - 27.9) / METRE
        return -0.5 * ((metres - TIMES_S[number]) / 100.0) ** 2

    return OffsetSearch(list(enumerate(TIMES_S)), track, fit, (OPTIONS, TrackOptions()))


def test_one_photograph_speaks_no_more_than_the_probability_that_it_misleads_allows(search):
    search.look([0.0, 700.0], FINE, SILENT)
    shares = search.shares(FINE)
    assert np.allclose(shares[0], 0.0)
    assert np.allclose(shares[1], np.log(OPTIONS.misled), atol=1e-6)


def test_an_offset_off_the_track_is_no_answer_and_one_photograph_off_it_is_weighed(search):
    search.look([0.0, 1500.0, 9000.0], FINE, SILENT)
    total, shares = search.total(FINE), search.shares(FINE)
    assert np.isfinite(total[0]) and np.isneginf(total[1:]).all()
    assert shares[1, 0] == -OPTIONS.unplaced and (shares[2] == -OPTIONS.unplaced).all()


def test_the_search_goes_on_around_the_best_distinct_offsets(search):
    search.look(np.arange(-900.0, 901.0, 300.0), COARSE, SILENT)
    found = search.closer(COARSE, 1, (300.0, 100.0))
    assert np.allclose(found, np.arange(-300.0, 301.0, 100.0))
    assert len(search.closer(COARSE, 2, (300.0, 100.0))) > len(found)
    assert not len(search.offsets(FINE)) and not len(search.closer(FINE, 2, (100.0, 50.0)))


def test_no_place_is_fitted_twice_within_a_cell(search):
    calls = []
    fit = search.fit
    search.fit = lambda *given: calls.append(given) or fit(*given)
    search.look([0.0, 4.0], FINE, SILENT)
    search.look([0.0], FINE, SILENT)
    assert len(calls) == len(TIMES_S)


def test_the_prior_prefers_time_zones_and_integrates_to_one():
    offsets = np.arange(-4500.0, 4500.0, 1.0)
    density = np.exp(log_prior(offsets, OPTIONS))
    assert density.mean() == pytest.approx(1.0, rel=1e-3)
    assert density[offsets % 900 == 0].min() > 5 * density[(offsets + 450) % 900 == 0].max()
