"""What all eyes at one place share: rays, their intervals, and the cells that are read once."""

from __future__ import annotations

import numpy as np
import pytest
from reference.landscapes import fractal, stand
from skyline_viewshed.core.base.errors import ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import eye_elevation_m
from skyline_viewshed.core.horizon import surroundings
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_from, horizon_profile
from skyline_viewshed.core.horizon.surroundings import Surroundings

OPTIONS = HorizonOptions(azimuth_step_deg=2.0)


@pytest.fixture
def hills():
    return stand(fractal(240, 3), 30.0, 121.3, 118.6, 20.0)


def around(terrain, observer, options=OPTIONS):
    return Surroundings(terrain, observer.longitude_deg, observer.latitude_deg, options)


def test_intervals_run_from_the_near_ground_to_the_farthest_ray(hills):
    place = around(*hills)
    assert place.edge_m[0] == pytest.approx(OPTIONS.near_skip_cells * 30.0)
    assert place.edge_m[-1] == place.rays.reach_m.max()
    assert (np.diff(place.edge_m) > 0).all()


def test_the_terrain_is_read_when_it_is_first_needed_and_once(hills, monkeypatch):
    read, block_maxima = [], surroundings.block_maxima
    monkeypatch.setattr(surroundings, "block_maxima", lambda *given: read.append(1) or block_maxima(*given))
    place = around(*hills)
    assert not read
    assert place.blocks() is place.blocks()
    assert len(read) == 1


def test_larger_blocks_bound_the_memory_and_change_no_horizon(hills, monkeypatch):
    terrain, observer = hills
    fine = horizon_profile(terrain, observer, OPTIONS)
    monkeypatch.setattr(surroundings, "MAX_PAIRS", 2_000)
    coarse = around(terrain, observer)
    assert coarse.blocks().block > surroundings.BLOCK
    profile = horizon_from(coarse, eye_elevation_m(terrain, coarse.frame, observer))
    assert profile.elevation_deg == pytest.approx(fine.elevation_deg, abs=1e-4)


def test_a_place_outside_the_dem_is_refused_before_anything_is_read(hills):
    terrain, observer = hills
    with pytest.raises(ObserverOutsideDemError):
        Surroundings(terrain, observer.longitude_deg + 1.0, observer.latitude_deg, OPTIONS)
