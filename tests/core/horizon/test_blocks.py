import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window
from skyline_viewshed.core.horizon.blocks import HeldTerrain, aligned, block_maxima, highest_close_by


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


@pytest.mark.parametrize("half_px", [1.0, 2.635, 4.0])
def test_close_by_the_bound_is_that_of_the_cells(half_px):
    ground = np.random.default_rng(6).normal(0, 100, (60, 70)).astype(np.float32)
    ground[20:30, 30:40] = np.nan
    at = highest_close_by(ArrayTerrain(ground, 1.0), Window(10, 5, 45, 60), half_px)
    rng, radius = np.random.default_rng(7), int(half_px + 0.5)
    for row, col in zip(rng.uniform(9.5, 54.5, 300), rng.uniform(4.5, 64.5, 300)):
        sides = [
            (max(int(np.ceil(place - half_px)), first), min(int(np.floor(place + half_px)), last))
            for place, first, last in ((row, 10, 54), (col, 5, 64))
        ]
        around = ground[sides[0][0] : sides[0][1] + 1, sides[1][0] : sides[1][1] + 1]
        bound = at(np.array([col]), np.array([row]))[0]
        assert bound >= around[np.isfinite(around)].max(initial=-np.inf)
        middle = int(np.rint(row)), int(np.rint(col))
        more = ground[max(middle[0] - radius, 0) : middle[0] + radius + 1, max(middle[1] - radius, 0) :]
        assert bound <= np.nan_to_num(more[:, : 2 * radius + 1], nan=-np.inf).max()


@pytest.mark.parametrize("memory_mb", [1.0, 0.05, 0.0])
def test_what_counts_as_held_is_in_memory_with_all_around_it(memory_mb):
    ground = np.random.default_rng(8).normal(size=(1200, 30)).astype(np.float32)
    terrain = Counted(ground, 1.0)
    held = HeldTerrain(terrain, Window(0, 0, 1200, 30), 600.0, memory_mb)
    block_maxima(held, Window(0, 0, 1200, 30), 8, columns=lambda first, last: (4, 20 if first < 512 else 27))
    read, (kept, cells) = terrain.cells_read, held.kept()
    rng = np.random.default_rng(9)
    row, col = rng.uniform(-0.5, 1199.5, 500), rng.uniform(-0.5, 29.5, 500)
    known = held.held(row, col, 3)
    for place in np.flatnonzero(known):
        top, left = max(int(row[place]) - 3, 0), max(int(col[place]) - 3, 0)
        bottom, right = min(int(row[place]) + 5, 1200), min(int(col[place]) + 5, 30)
        window = Window(top, left, bottom - top, right - left)
        there = cells[top - kept.row : bottom - kept.row, left - kept.col : right - kept.col]
        assert np.array_equal(there, ground[top:bottom, left:right])
        assert np.array_equal(held.read(window), there)
    assert terrain.cells_read == read, "what is held is not read again"
    assert {1.0: 100, 0.05: 30, 0.0: 0}[memory_mb] <= known.sum() <= (0 if memory_mb == 0 else 500)


def test_a_window_beside_what_is_held_does_not_make_it_forgotten():
    terrain = Counted(np.arange(512 * 30, dtype=np.float32).reshape(512, 30), 1.0)
    held = HeldTerrain(terrain, Window(0, 0, 512, 30), 200.0, 1.0)
    held.read_transient(Window(0, 10, 256, 10))
    assert np.array_equal(held.read(Window(5, 15, 10, 10)), terrain.elevation_m[5:15, 15:25])
    out = np.empty((256, 10), np.float32)
    held.read_into(Window(0, 10, 256, 10), out)
    assert np.array_equal(out, terrain.elevation_m[:256, 10:20])
    assert terrain.cells_read == 2560 + 100
