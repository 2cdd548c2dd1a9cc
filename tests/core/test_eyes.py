"""The horizons of one place: the same as one by one, and the terrain is read once for all eyes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.eyes import HorizonCache, other_eyes
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.horizon.inner import inner_terrain
from skyline_viewshed.core.pipeline import OrientOptions
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains


class Counted(ArrayTerrain):
    """A terrain that counts the cells that are read."""

    def read(self, window):
        """See `Terrain.read`."""
        self.__dict__["cells"] = self.__dict__.get("cells", 0) + window.rows * window.cols
        return super().read(window)


@pytest.fixture
def mountains():
    made = make_mountains(5, MountainOptions(size=300, cell_m=60.0, relief_m=1500.0))
    heights = made.elevation_m.copy()
    heights[40:60, 200:230] = np.nan
    return Counted(heights, made.cell_m, made.longitude_deg, made.latitude_deg)


@pytest.fixture
def place(mountains):
    return Observer(mountains.longitude_deg, mountains.latitude_deg, 10.0)


def same(first, second):
    return all(
        np.array_equal(getattr(first, name), getattr(second, name), equal_nan=True)
        for name in ("elevation_deg", "distance_m", "clipped", "void", "reach_m")
    )


@pytest.mark.parametrize("memory_mb", [64.0, 0.05], ids=["all held", "some rows held"])
def test_each_eye_sees_what_it_sees_alone(mountains, place, memory_mb):
    cache, options = HorizonCache(), OrientOptions(horizon=HorizonOptions(azimuth_step_deg=1.0, memory_mb=memory_mb))
    horizon = cache.profile(mountains, place, options.horizon)
    eyes = other_eyes(mountains, place, horizon, horizon.eye_elevation_m + 40.0, options, cache)
    assert len(eyes) >= 2
    for eye in eyes:
        observer = replace(place, eye_elevation_m=eye.horizon.eye_elevation_m)
        assert same(eye.horizon, horizon_profile(mountains, observer, options.horizon))
        alone = inner_terrain(mountains, observer, options.inner)
        assert np.array_equal(eye.inner.ground.planes, alone.ground.planes, equal_nan=True)
        assert np.array_equal(eye.inner.ridges.elevation_deg, alone.ridges.elevation_deg)


def test_the_terrain_is_read_once_for_all_eyes(mountains, place):
    cache, options = HorizonCache(), OrientOptions(horizon=HorizonOptions(azimuth_step_deg=1.0))
    cache.profile(mountains, place, options.horizon)
    cache.inner(mountains, place, options.inner)
    once = mountains.cells
    for up_m in (20.0, 60.0, 100.0):
        other = replace(place, eye_height_m=up_m)
        cache.profile(mountains, other, options.horizon)
        cache.inner(mountains, other, options.inner)
    assert mountains.cells - once < 0.1 * once


def test_another_place_another_dem_and_other_options_are_read_anew(mountains, place):
    cache, options = HorizonCache(), HorizonOptions(azimuth_step_deg=1.0)
    cache.profile(mountains, place, options)
    moved = replace(place, longitude_deg=place.longitude_deg + 0.01)
    raised = Counted(mountains.elevation_m + 100.0, mountains.cell_m, place.longitude_deg, place.latitude_deg)
    nearer = replace(options, max_distance_m=3_000.0)
    for case in ((mountains, moved, options), (raised, place, options), (mountains, place, nearer)):
        assert same(cache.profile(*case), horizon_profile(*case))


def test_the_cache_is_bounded(mountains, place):
    cache, options = HorizonCache(size=2), HorizonOptions(azimuth_step_deg=30.0, max_distance_m=2000.0)
    places = [replace(place, eye_height_m=float(height)) for height in range(2, 9)]
    profiles = [cache.profile(mountains, each, options) for each in places]
    assert cache.profile(mountains, places[-1], options) is profiles[-1]
    assert cache.profile(mountains, places[0], options) is not profiles[0]
