import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.locate.many import CellGrid, ManyOptions, many_horizons
from skyline_viewshed.core.simulate.example import example_terrain


def horizons(terrain, grid, options):
    longitude, latitude = terrain.position_of(*grid.middle_px)
    frame = terrain.frame(float(longitude), float(latitude), options.max_distance_m)
    return many_horizons(terrain, frame, grid, 1.7, options)


def test_they_agree_with_the_exact_engine():
    terrain, options = example_terrain(size=160), ManyOptions(azimuths=720, max_distance_m=5_000.0)
    grid = CellGrid(70, 72, 5, 4, 3, 2)
    found = horizons(terrain, grid, options)
    difference = []
    for place, (col, row) in enumerate(zip(*grid.places_px)):
        longitude, latitude = terrain.position_of(float(col), float(row))
        observer = Observer(float(longitude), float(latitude))
        exact = horizon_profile(terrain, observer, HorizonOptions(0.5, 5_000.0))
        difference.append(found.elevation_deg[place] - exact.elevation_deg)
    difference = np.array(difference)
    assert np.abs(difference).mean() < 0.12
    assert np.percentile(np.abs(difference), 95) < 0.5


def test_a_plain_looks_down_by_the_curvature_and_the_eye_height():
    terrain = ArrayTerrain(np.full((200, 200), 500.0, np.float32), 100.0, 8.0, 46.0)
    found = horizons(terrain, CellGrid(100, 100, 2, 2), ManyOptions(azimuths=36, max_distance_m=8_000.0))
    # From 1.7 m, the horizon of a smooth earth lies 5 km away, at a dip of sqrt(2 h (1 - k) / R).
    dip = np.degrees(np.sqrt(2 * 1.7 * 0.87 / 6_371_000.0))
    assert found.elevation_deg == pytest.approx(-dip, abs=0.002)
    assert found.ground_m == pytest.approx(500.0)


def test_beyond_the_edge_and_in_voids_nothing_is_known():
    height = np.full((60, 60), 100.0, np.float32)
    height[:, :20] = np.nan
    terrain = ArrayTerrain(height, 100.0, 8.0, 46.0)
    found = horizons(terrain, CellGrid(30, 18, 1, 4), ManyOptions(azimuths=360, max_distance_m=3_000.0))
    assert np.isnan(found.ground_m).tolist() == [True, True, False, False]
    assert np.isnan(found.elevation_deg[:2]).all()
    assert np.isnan(found.elevation_deg[3, 270]) and np.isfinite(found.elevation_deg[3, :180]).all()


def test_the_distance_is_that_of_the_summit():
    height = np.zeros((120, 120), np.float32)
    height[20, 60] = 900.0
    terrain = ArrayTerrain(height, 100.0, 8.0, 46.0)
    found = horizons(terrain, CellGrid(80, 60, 1, 1), ManyOptions(azimuths=720, max_distance_m=9_000.0))
    assert found.distance_m[0, 0] == pytest.approx(6_000.0, abs=60)
    assert found.elevation_deg[0, 0] == pytest.approx(np.degrees(np.arctan(898.3 / 6_000)), abs=0.15)


def test_strips_of_any_height_give_the_same(monkeypatch):
    terrain, options = example_terrain(size=160), ManyOptions(azimuths=72, max_distance_m=9_000.0)
    grid = CellGrid(70, 72, 5, 4, 3, 2)
    whole = horizons(terrain, grid, options)
    monkeypatch.setattr("skyline_viewshed.core.locate.many.STRIP_CELLS", 2_500)
    strips = horizons(terrain, grid, options)
    assert np.array_equal(whole.elevation_deg, strips.elevation_deg, equal_nan=True)
    assert np.array_equal(whole.distance_m, strips.distance_m, equal_nan=True)
