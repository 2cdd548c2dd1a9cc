"""Branch and bound finds what sampling every interval finds, and its bounds are bounds."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from reference.landscapes import fractal, stand
from skyline_viewshed.core.horizon import search
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile

OPTIONS = HorizonOptions(azimuth_step_deg=2.0)


def everywhere(monkeypatch):
    """Let the search look into every interval that holds terrain."""
    bounds = search.Search._bounds

    def loose(self, near, progress):
        bound, likely = bounds(self, near, progress)
        bound[bound > -np.inf] = 1e9
        return bound, likely

    monkeypatch.setattr(search.Search, "_bounds", loose)
    monkeypatch.setattr(search.Search, "_closer_bound", lambda self, ray, interval, around: np.full(len(ray), np.inf))


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("height_m", [2.0, 400.0])
def test_nothing_is_lost_by_leaving_intervals_out(monkeypatch, seed, height_m):
    terrain, observer = stand(fractal(240, seed), 30.0, 121.3, 118.6, height_m)
    quick = horizon_profile(terrain, observer, OPTIONS)
    everywhere(monkeypatch)
    whole = horizon_profile(terrain, observer, OPTIONS)
    least_deg = np.degrees(search.LEAST_GAIN)
    assert np.abs(quick.elevation_deg - whole.elevation_deg).max() <= 2 * least_deg
    same = quick.elevation_deg == whole.elevation_deg
    assert same.mean() > 0.95
    assert np.array_equal(quick.distance_m[same], whole.distance_m[same])


def test_most_intervals_are_left_out(monkeypatch):
    terrain, observer = stand(fractal(400, 4), 30.0, 200.0, 200.0, 20.0)
    sampled, search_intervals = [], search.search_intervals

    def counted(*arguments, **options):
        found = search_intervals(*arguments, **options)
        sampled.append(len(found[0]))
        return found

    monkeypatch.setattr(search, "search_intervals", counted)
    horizon_profile(terrain, observer, OPTIONS)
    quick = sum(sampled)
    sampled.clear()
    everywhere(monkeypatch)
    horizon_profile(terrain, observer, OPTIONS)
    assert 0 < quick < 0.35 * sum(sampled)


@given(
    height=st.floats(-3000, 3000),
    start=st.floats(1, 5e4),
    length=st.floats(0.1, 5e3),
    share=st.floats(0, 1),
    below=st.floats(0, 4000),
)
def test_no_terrain_below_a_height_rises_above_its_bound(height, start, length, share, below):
    drop = 6.8e-8
    distance = start + share * length
    tangent = (height - below) / distance - drop * distance
    bound = search._tangent_bound(np.array([height]), np.array([start]), np.array([start + length]), drop)
    assert tangent <= bound[0] + 1e-9 * max(abs(tangent), 1)


def test_the_bound_is_reached_at_an_interval_s_ends():
    ends = np.array([100.0]), np.array([200.0])
    assert search._tangent_bound(np.array([50.0]), *ends, 0.0)[0] == pytest.approx(50 / 100)
    assert search._tangent_bound(np.array([-50.0]), *ends, 0.0)[0] == pytest.approx(-50 / 200)
