"""The horizons of one place: the same as one by one, and the terrain is read once for all eyes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import Cancelled, NoElevationAtObserverError
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.eyes import HorizonCache, other_eyes
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.horizon.inner import InnerOptions, inner_terrain
from skyline_viewshed.core.pipeline import OrientOptions
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains


class Counted(ArrayTerrain):
    """A terrain that counts the cells that are read."""

    @property
    def cells(self):
        """Cells read so far."""
        return self.__dict__.get("read_cells", 0)

    def read(self, window):
        """See `Terrain.read`."""
        self.__dict__["read_cells"] = self.cells + window.rows * window.cols
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


def inner_same(first, second):
    ridges = np.array_equal(first.ridges.elevation_deg, second.ridges.elevation_deg)
    return ridges and np.array_equal(first.ground.planes, second.ground.planes, equal_nan=True)


@pytest.mark.parametrize("memory_mb", [64.0, 0.32, 0.05], ids=["all held", "some rows held", "none held"])
def test_each_eye_sees_what_it_sees_alone(mountains, place, memory_mb):
    cache, options = HorizonCache(), OrientOptions(horizon=HorizonOptions(azimuth_step_deg=1.0, memory_mb=memory_mb))
    with cache.station():
        horizon = cache.profile(mountains, place, options.horizon)
        eyes = other_eyes(mountains, place, horizon, horizon.eye_elevation_m + 40.0, options, cache)
    assert len(eyes) >= 2
    for eye in eyes:
        observer = replace(place, eye_elevation_m=eye.horizon.eye_elevation_m)
        assert same(eye.horizon, horizon_profile(mountains, observer, options.horizon))
        assert inner_same(eye.inner, inner_terrain(mountains, observer, options.inner))


def read_by_four_eyes(terrain, place, cache):
    """Cells read for the first of four eyes at a place, and for the other three."""
    options = OrientOptions(horizon=HorizonOptions(azimuth_step_deg=1.0))
    counts = [terrain.cells]
    for up_m in (2.0, 20.0, 60.0, 100.0):
        cache.profile(terrain, replace(place, eye_height_m=up_m), options.horizon)
        cache.inner(terrain, replace(place, eye_height_m=up_m), options.inner)
        counts.append(terrain.cells)
    return counts[1] - counts[0], counts[-1] - counts[1]


def test_the_terrain_of_a_station_is_read_once_for_all_eyes_and_then_released(mountains, place):
    cache = HorizonCache()
    with cache.station():
        first, others = read_by_four_eyes(mountains, place, cache)
        assert others < 0.1 * first
    first, others = read_by_four_eyes(mountains, place, HorizonCache())
    assert others > 2.5 * first  # outside the block nothing is kept


def test_terrain_of_another_place_dem_or_range_is_not_taken(mountains, place):
    options, inner = HorizonOptions(azimuth_step_deg=1.0), InnerOptions()
    turned = Counted(mountains.elevation_m[::-1].copy(), mountains.cell_m, place.longitude_deg, place.latitude_deg)
    moved = replace(place, longitude_deg=place.longitude_deg + 0.01)
    nearer = replace(options, max_distance_m=3_000.0)
    cache, higher = HorizonCache(), replace(place, eye_height_m=50.0)
    with cache.station():
        cache.profile(mountains, place, options)
        for case in ((mountains, moved, options), (turned, place, options), (mountains, place, nearer),
                     (mountains, higher, options)):  # fmt: skip
            assert same(cache.profile(*case), horizon_profile(*case))
            assert inner_same(cache.inner(*case[:2], inner), inner_terrain(*case[:2], inner))


class Stop:
    """`Progress` that cancels when it is asked for the `count`th time."""

    def __init__(self, count):
        self.left = count

    def report(self, fraction):
        """Do nothing."""

    def cancelled(self):
        """Count down."""
        self.left -= 1
        return self.left <= 0


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_cancelled_search_leaves_nothing_half_read(mountains, place, count):
    cache, options = HorizonCache(), HorizonOptions(azimuth_step_deg=1.0)
    with cache.station():
        with pytest.raises(Cancelled):
            cache.profile(mountains, place, options, Stop(count))
        assert same(cache.profile(mountains, place, options), horizon_profile(mountains, place, options))


def test_an_eye_of_known_elevation_sees_where_the_dem_has_no_ground(mountains, place):
    cache, options = HorizonCache(), HorizonOptions(azimuth_step_deg=1.0)
    longitude, latitude = mountains.position_of(215.0, 50.0)
    nowhere = replace(place, longitude_deg=float(longitude), latitude_deg=float(latitude))
    with cache.station():
        with pytest.raises(NoElevationAtObserverError):
            cache.profile(mountains, nowhere, options)
        known = replace(nowhere, eye_elevation_m=4_000.0)
        assert same(cache.profile(mountains, known, options), horizon_profile(mountains, known, options))


def test_the_cache_is_bounded(mountains, place):
    cache, options = HorizonCache(size=2), HorizonOptions(azimuth_step_deg=30.0, max_distance_m=2000.0)
    places = [replace(place, eye_height_m=float(height)) for height in range(2, 9)]
    profiles = [cache.profile(mountains, each, options) for each in places]
    assert cache.profile(mountains, places[-1], options) is profiles[-1]
    assert cache.profile(mountains, places[0], options) is not profiles[0]
