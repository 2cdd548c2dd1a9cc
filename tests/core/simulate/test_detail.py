from __future__ import annotations

import numpy as np
import pytest
from scenes import small_mountains
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window
from skyline_viewshed.core.simulate.detail import DetailedTerrain


def test_without_detail_a_smooth_surface_is_only_sampled_finer():
    axis = np.arange(40) * 50.0
    terrain = ArrayTerrain((0.3 * axis[:, None] + 0.1 * axis[None, :]).astype(np.float32), 50.0)
    fine = DetailedTerrain(terrain, 4, strength=0.0, sharpening=0.0)
    frame = fine.frame(0.0, 0.0, 900.0)
    east, north = np.array([12.5, -300.0]), np.array([40.0, 200.0])
    col, row = frame.to_pixel(east, north)
    coarse_col, coarse_row = terrain.frame(0.0, 0.0, 900.0).to_pixel(east, north)
    elevation = fine.read(Window(0, 0, *fine.shape))
    for c, r, cc, cr in zip(col, row, coarse_col, coarse_row):
        lower = elevation[int(np.floor(r)) : int(np.floor(r)) + 2, int(np.floor(c)) : int(np.floor(c)) + 2]
        assert lower.min() <= 0.3 * 50 * cr + 0.1 * 50 * cc <= lower.max()
    assert frame.cell_m == pytest.approx(12.5)


def test_a_window_is_the_same_as_that_part_of_the_whole():
    fine = DetailedTerrain(small_mountains(), 3, seed=4)
    whole = fine.read(Window(120, 150, 240, 210))
    part = fine.read(Window(201, 205, 70, 80))
    np.testing.assert_allclose(part, whole[81:151, 55:135], atol=0.5)


def test_detail_is_small_against_a_cell_and_higher_on_crests():
    terrain = small_mountains()
    fine = DetailedTerrain(terrain, 4, seed=4, strength=0.3)
    elevation = fine.read(Window(0, 0, *fine.shape)).astype(float)
    means = elevation.reshape(256, 4, 256, 4).mean(axis=(1, 3))
    change = means - terrain.elevation_m
    assert 1.0 < change.std() < 0.5 * terrain.cell_m
    crest = terrain.elevation_m > np.percentile(terrain.elevation_m, 99)
    highest = elevation.reshape(256, 4, 256, 4).max(axis=(1, 3)) - terrain.elevation_m
    assert highest[crest].mean() > highest.mean()


def test_voids_stay_voids_and_do_not_spread():
    elevation = small_mountains().elevation_m[:60, :60].copy()
    elevation[20:30, 20:30] = np.nan
    fine = DetailedTerrain(ArrayTerrain(elevation, 90.0), 2).read(Window(0, 0, 120, 120))
    assert np.isnan(fine[40:60, 40:60]).all()
    assert np.isnan(fine).sum() == 400


def test_positions_go_through_the_coarse_raster():
    terrain = small_mountains()
    fine = DetailedTerrain(terrain, 4)
    np.testing.assert_allclose(fine.position_of(1.5, 1.5), terrain.position_of(0.0, 0.0))
    with pytest.raises(ValueError, match="factor"):
        DetailedTerrain(terrain, 0)
