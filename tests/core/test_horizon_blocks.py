import numpy as np
import pytest
from skyline_viewshed.core.horizon_blocks import HeldTerrain, aligned, block_maxima
from skyline_viewshed.core.terrain import ArrayTerrain, Window


@pytest.mark.parametrize("block", [8, 16, 64])
@pytest.mark.parametrize("shape", [(1100, 90), (37, 41), (8, 8), (1, 1)])
def test_the_bound_holds_for_every_cell_within_a_block_of_any_cell(block, shape):
    rng = np.random.default_rng(1)
    ground = rng.normal(size=shape).astype(np.float32)
    ground[rng.random(shape) < 0.02] = np.nan
    window = aligned(Window(0, 0, *shape), block, shape)
    blocks = block_maxima(ArrayTerrain(ground, 1.0), window, block)
    for row, col in rng.integers(0, shape, (50, 2)):
        around = ground[max(row - block, 0) : row + block + 1, max(col - block, 0) : col + block + 1]
        bound = blocks.highest_m[blocks.index(col, row)]
        if np.isfinite(around).any():
            assert bound >= np.nanmax(around)
        if np.isnan(around).any():
            assert blocks.has_void[blocks.index(col, row)]
        if blocks.all_void[blocks.index(col, row)]:
            assert np.isnan(ground[row, col])
    known = ground[np.isfinite(ground)]
    assert blocks.summit_m == (known.max() if len(known) else -np.inf)


def test_windows_grow_to_whole_blocks_and_stay_inside():
    assert aligned(Window(13, 30, 10, 10), 8, (100, 35)) == Window(8, 24, 15, 11)
    assert aligned(Window(-3, -9, 20, 20), 8, (100, 100)) == Window(0, 0, 17, 11)


class Counted(ArrayTerrain):
    """A terrain that counts the cells read."""

    cells_read = 0

    def read(self, window):
        object.__setattr__(self, "cells_read", self.cells_read + window.rows * window.cols)
        return super().read(window)


@pytest.mark.parametrize("middle_row", [0.0, 640.0, 1150.0])
@pytest.mark.parametrize("memory_mb, kept_rows", [(1.0, 1050), (0.05, 512), (0.0, 0)])
def test_held_terrain_is_the_terrain_and_reads_what_it_keeps_once(memory_mb, kept_rows, middle_row):
    ground = np.arange(1200 * 30, dtype=np.float32).reshape(1200, 30)
    terrain, window = Counted(ground, 1.0), Window(104, 8, 1050, 20)
    held = HeldTerrain(terrain, window, middle_row, memory_mb)
    assert held.shape == ground.shape
    assert held.whole == (kept_rows == 1050)
    block_maxima(held, window, 8)
    assert terrain.cells_read == 1050 * 20
    for row in range(104, 1144, 10):
        assert np.array_equal(held.read(Window(row, 9, 10, 10)), ground[row : row + 10, 9:19])
    again = (terrain.cells_read - 1050 * 20) / 10
    assert 1050 - kept_rows - 20 <= again <= 1050 - min(kept_rows, 250) + 20, "rows read a second time"


@pytest.mark.parametrize("half_px", [1.0, 2.635, 4.0])
def test_no_cell_around_a_place_is_higher_than_its_bound(half_px):
    ground = np.random.default_rng(4).normal(0, 100, (90, 77)).astype(np.float32)
    ground[20:40, 30:50] = np.nan
    blocks = block_maxima(ArrayTerrain(ground, 1.0), Window(0, 0, 90, 77), 8)
    rng = np.random.default_rng(5)
    for row, col in zip(rng.uniform(-0.5, 89.5, 300), rng.uniform(-0.5, 76.5, 300)):
        top, left = max(int(np.ceil(row - half_px)), 0), max(int(np.ceil(col - half_px)), 0)
        around = ground[top : int(np.floor(row + half_px)) + 1, left : int(np.floor(col + half_px)) + 1]
        known = around[np.isfinite(around)]
        bound = blocks.highest_around(np.array([col]), np.array([row]), half_px)[0]
        assert bound >= known.max(initial=-np.inf)
        if len(known) == around.size:
            assert bound <= blocks.highest_m[blocks.index(col, row)]
