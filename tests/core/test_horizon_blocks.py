import numpy as np
import pytest
from skyline_viewshed.core.horizon_blocks import HeldTerrain, aligned, block_maxima
from skyline_viewshed.core.progress import SILENT
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


def test_held_terrain_serves_what_was_read_once():
    ground = np.arange(1200 * 30, dtype=np.float32).reshape(1200, 30)
    held = HeldTerrain(ArrayTerrain(ground, 1.0), Window(100, 5, 1050, 20), SILENT)
    assert np.array_equal(held.read(Window(600, 8, 30, 10)), ground[600:630, 8:18])
    assert held.shape == ground.shape
