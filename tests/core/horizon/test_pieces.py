"""Terrain around scattered places, read piece by piece: the same elevations as from the whole, read economically."""

import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window, bilinear
from skyline_viewshed.core.horizon import pieces as horizon_pieces
from skyline_viewshed.core.horizon.pieces import one_piece, read_transient_pieces


class Counted(ArrayTerrain):
    """A terrain that remembers what was read."""

    def __init__(self, cells):
        super().__init__(cells, 30.0)
        object.__setattr__(self, "windows", [])

    def read(self, window):
        assert window.clipped(self.shape) == window
        self.windows.append(window)
        return super().read(window)


def rough(shape, seed=3, voids=0.0):
    rng = np.random.default_rng(seed)
    cells = rng.normal(1000, 50, shape).astype(np.float32)
    cells[rng.random(shape) < voids] = np.nan
    return cells


def places(shape, count=400, seed=5):
    rng = np.random.default_rng(seed)
    return (rng.uniform(-0.5, size - 0.5, count) for size in shape)


@pytest.mark.parametrize("voids", [0.0, 0.1])
@pytest.mark.parametrize("shape", [(700, 900), (1, 50), (50, 1), (1, 1)])
def test_samples_are_bilinear_whatever_piece_they_come_from(shape, voids, monkeypatch):
    monkeypatch.setattr(horizon_pieces, "HELD_CELLS", 20_000)
    terrain = Counted(rough(shape, voids=voids))
    row, col = places(shape)
    offsets = np.linspace(-3, 3, 7)
    found = np.full((len(row), len(offsets)), np.nan)
    whole = one_piece(terrain.elevation_m, Window(0, 0, *shape), len(row))
    around = [np.clip(place[:, None] + offsets, -0.5, size - 0.5) for place, size in zip((row, col), shape)]
    for jobs, pieces in read_transient_pieces(terrain, row, col, 8):
        found[jobs] = pieces.elevation_m(around[0][jobs], around[1][jobs])
    np.testing.assert_array_equal(found, whole.elevation_m(*around))
    np.testing.assert_allclose(found, bilinear(terrain.elevation_m.astype(float), *around), atol=1e-3)


@pytest.mark.parametrize("shape", [(40, 60), (1, 50), (50, 1), (1, 1)])
def test_on_a_grid_line_two_cells_tell_what_four_do(shape):
    cells, rng = rough(shape), np.random.default_rng(1)
    whole = one_piece(cells, Window(0, 0, *shape), 30)
    for columns in (True, False):
        across, along = shape[::-1] if columns else shape
        line = rng.integers(0, across, (30, 9)).astype(float)
        place = np.sort(rng.uniform(-0.5, along - 0.5, (30, 9)), axis=1)
        row, col = (place, line) if columns else (line, place)
        assert np.allclose(whole.on_lines_m(line, place, columns), whole.elevation_m(row, col), atol=1e-9)


def test_only_what_lies_around_the_places_is_read():
    terrain = Counted(rough((3000, 3000)))
    row, col = np.array([100.0, 110.0, 2500.0]), np.array([200.0, 190.0, 2600.0])
    jobs = np.concatenate([found for found, _ in read_transient_pieces(terrain, row, col, 8)])
    assert sorted(jobs) == [0, 1, 2]
    assert len(terrain.windows) == 2
    assert sum(window.rows * window.cols for window in terrain.windows) < 3000


def test_no_place_reads_nothing():
    terrain = Counted(rough((20, 20)))
    assert list(read_transient_pieces(terrain, np.zeros(0), np.zeros(0), 8)) == []
    assert terrain.windows == []
