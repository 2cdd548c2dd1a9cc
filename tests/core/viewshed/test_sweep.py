"""Pieces of the sweep; whole sweeps are those of test_viewshed.py."""

from __future__ import annotations

import numpy as np
import pytest
from reference.landscapes import fractal
from reference.views import look, overlap
from skyline_viewshed.core.viewshed import sweep
from skyline_viewshed.core.viewshed.sector import FullCircle, Wedge
from skyline_viewshed.core.viewshed.sweep import EDGE, INSIDE, OUTSIDE


def test_cells_between_rays_are_inside_outside_or_asked_one_by_one():
    azimuth = np.arange(0.0, 90.0, 10.0)
    found = sweep._between(Wedge(45.0, 42.0), azimuth)  # from 24 to 66 degrees
    assert found.tolist() == [OUTSIDE, OUTSIDE, EDGE, INSIDE, INSIDE, INSIDE, EDGE, OUTSIDE]
    assert (sweep._between(FullCircle(), azimuth) == INSIDE).all()


def test_a_wedge_that_no_ray_meets_may_still_lie_between_two():
    assert (sweep._between(Wedge(45.0, 1.0), np.arange(0.0, 90.0, 10.0)) == EDGE).all()


def test_lengths_on_a_turned_grid_are_ground_lengths():
    j, k = np.array([[3.0, 4.0]]), np.array([[2.0], [5.0]])
    turn = np.radians(25.0)
    to_metres = 30.0 * np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    assert sweep._length(to_metres, j, k) == pytest.approx(30.0 * np.hypot(j, k))
    assert sweep._length(np.diag([10.0, 20.0]), j, k) == pytest.approx(np.hypot(10 * j, 20 * k))


def test_denser_rays_change_next_to_nothing():
    ground = fractal(161, seed=6)
    plain, dense = (look(ground, 30.0, 80.3, 79.8, 10.0, rays_per_cell=count) == 1 for count in (1.0, 4.0))
    assert overlap(plain, dense) > 0.98 and 0.05 < plain.mean() < 0.9


def test_a_void_makes_what_lies_behind_it_unknown_and_nothing_else():
    ground = np.zeros((61, 61), np.float32)
    ground[25, 30] = np.nan
    free = look(np.zeros((61, 61), np.float32), 10.0, 30, 30, curvature=False)
    values = look(ground, 10.0, 30, 30, curvature=False)
    unknown = values == sweep.UNKNOWN
    assert unknown[:25, 30].all() and unknown[25, 30]
    assert not unknown[26:].any() and np.array_equal(values[~unknown], free[~unknown])
    assert unknown.sum() < 0.1 * unknown.size
