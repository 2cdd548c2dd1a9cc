"""The crest between grid lines, against samples every thousandth of the way."""

import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.horizon.pieces import one_piece
from skyline_viewshed.core.horizon.rays import EyeRays, Stretches
from skyline_viewshed.core.horizon.refine import crest

CELL_M = 30.0


def sight(drop_per_m2=6.8e-8, eye_m=1000.0):
    return EyeRays(None, np.zeros(0), eye_m, drop_per_m2, 1, CELL_M)


def stretches(count=300, seed=3):
    """Terrain of 12 x 12 cells, and intervals of about two cells in it, in all directions."""
    rng = np.random.default_rng(seed)
    cells = rng.normal(1000, 15, (12, 12)).astype(np.float32)
    turn, (col, row) = rng.uniform(0, 2 * np.pi, count), rng.uniform(4, 7, (2, count))
    start = rng.uniform(200, 3000, count)
    ends = col, row, col + 2 * np.sin(turn), row - 2 * np.cos(turn)
    return one_piece(cells, Window(0, 0, 12, 12), count), ends, start, start + 2 * CELL_M


def tangents(pieces, sight, ends, start, end, share):
    col0, row0, col1, row1 = (place[:, None] for place in ends)
    height = pieces.elevation_m(row0 + (row1 - row0) * share, col0 + (col1 - col0) * share)
    return sight.tangent(height, start[:, None] + (end - start)[:, None] * share)


@pytest.mark.parametrize("drop_per_m2", [0.0, 6.8e-8, 1e-4])
def test_the_crest_around_the_best_line_is_the_highest_of_dense_samples(drop_per_m2):
    pieces, ends, start, end = stretches()
    seen = sight(drop_per_m2)
    dense = np.linspace(0, 1, 2001) * np.ones((len(start), 1))
    every = tangents(pieces, seen, ends, start, end, dense)
    # From the highest sample itself the crest lies in the same cell, however the line that bounds it was found.
    top, where = crest(
        pieces, seen, Stretches(ends, start, end), np.full(len(start), -np.inf), dense[0, every.argmax(axis=1)]
    )
    assert (top >= every.max(axis=1) - 1e-12).all()
    assert np.allclose(top, every.max(axis=1), atol=1e-4)  # between samples 3 cm apart a kink may hide
    again = tangents(pieces, seen, ends, start, end, where[:, None])[:, 0]
    assert np.allclose(top, again, atol=1e-9)
    assert ((where >= 0) & (where <= 1)).all()


def test_an_interval_within_a_cell_has_a_crest_too():
    pieces, (col, row, _, _), start, _ = stretches(40)
    col, row = np.floor(col) + 0.1, np.floor(row) + 0.2
    ends, end = (col, row, col + 0.7, row + 0.6), start + 20.0
    nothing = np.full(40, -np.inf), np.full(40, np.nan)
    top, where = crest(pieces, sight(), Stretches(ends, start, end), *nothing)
    every = tangents(pieces, sight(), ends, start, end, np.linspace(0, 1, 2001) * np.ones((40, 1)))
    assert np.allclose(top, every.max(axis=1), atol=1e-6)
    assert np.isfinite(where).all()


def test_a_saddle_bulges_above_its_edges_by_a_quarter_of_its_twist():
    cells = np.array([[0, 8], [8, 0]], np.float32)
    pieces = one_piece(cells, Window(0, 0, 2, 2), 1)
    ends = tuple(np.array([value]) for value in (0.0, 0.0, 1.0, 1.0))
    far = np.array([1e6]), np.array([1e6 + 1])
    top, where = crest(pieces, sight(0.0, 0.0), Stretches(ends, *far), np.array([-np.inf]), np.array([0.0]))
    assert top[0] * 1e6 == pytest.approx(4.0, rel=1e-5)
    assert where[0] == pytest.approx(0.5, abs=1e-5)


def test_unknown_cells_leave_what_is_known():
    pieces, ends, start, end = stretches(20)
    unknown = one_piece(np.full((12, 12), np.nan, np.float32), Window(0, 0, 12, 12), 20)
    top, where = crest(unknown, sight(), Stretches(ends, start, end), np.full(20, 0.25), np.full(20, 0.5))
    assert (top == 0.25).all()
    assert (where == 0.5).all()
