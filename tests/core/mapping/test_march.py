"""Block maxima that rays leap over, and the crossing of one patch; whole marches are those of test_sightline.py."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference.landscapes import fractal
from skyline_viewshed.core.mapping.march import MAX_LEVEL, _first_rise, build_pyramid


@pytest.mark.parametrize("shape", [(2, 2), (9, 9), (17, 30), (33, 5), (2, 40)])
def test_every_level_holds_the_highest_corner_of_its_blocks(shape):
    ground = fractal(64, seed=2)[: shape[0], : shape[1]]
    pyramid = build_pyramid(ground)
    assert pyramid.void_patch is None and pyramid.bound_m[-1].shape == (1, 1)
    for level, bound in enumerate(pyramid.bound_m):
        size = 2**level
        for row, col in np.ndindex(bound.shape):
            block = ground[row * size : (row + 1) * size + 1, col * size : (col + 1) * size + 1]
            assert bound[row, col] == block.max()


def test_levels_end_where_larger_blocks_are_no_longer_worth_it():
    assert len(build_pyramid(np.zeros((4, 6000), np.float32)).bound_m) == MAX_LEVEL + 1


def test_a_void_is_as_high_as_the_highest_cell_on_its_rim():
    ground = np.zeros((12, 20), np.float32)
    ground[4, 8] = 70.0  # on the rim of the first void
    ground[9, 15] = 900.0  # and one that is not
    ground[5:7, 8:11] = np.nan
    ground[2, 2] = np.nan
    pyramid = build_pyramid(ground)
    assert pyramid.bound_m[0][5, 9] == 70.0
    assert pyramid.bound_m[0][2, 2] == 0.0
    assert pyramid.void_patch[5, 9] and pyramid.void_patch[4, 7] and not pyramid.void_patch[8, 14]
    assert np.isnan(pyramid.elevation_m[5, 8])


def test_where_nothing_is_known_nothing_can_be_met():
    pyramid = build_pyramid(np.full((5, 5), np.nan, np.float32))
    assert (pyramid.bound_m[0] == -np.inf).all() and pyramid.void_patch.all()


def test_corners_are_those_of_the_patch():
    ground = np.arange(20, dtype=np.float32).reshape(4, 5)
    row, col = np.array([0, 2]), np.array([0, 3])
    assert np.array(build_pyramid(ground).corners(row, col)).T.tolist() == [[0, 1, 5, 6], [13, 14, 18, 19]]


def rise(quadratic, begins_above=True):
    values = (np.array([np.polyval(quadratic, t)]) for t in (0.0, 0.5, 1.0))
    return _first_rise(*values, np.array([begins_above]))[0]


@settings(max_examples=200, deadline=None)
@given(root=st.floats(0.01, 0.99), slope=st.floats(0.1, 50), bend=st.floats(-60, 60))
def test_the_first_rise_is_a_root_at_which_the_surface_comes_up(root, slope, bend):
    quadratic = np.poly1d([bend, slope - 2 * bend * root, bend * root**2 - slope * root])  # rises by `slope` at root
    found = rise(quadratic, quadratic(0) < 0)
    assert found <= root + 1e-9
    assert quadratic(found) == pytest.approx(0, abs=1e-7) or (found == 0 and quadratic(0) >= 0)
    assert np.polyder(quadratic)(found) >= -1e-6


def test_a_surface_that_stays_below_or_only_falls_is_not_met():
    assert np.isnan(rise([0.0, 0.0, -5.0]))
    assert np.isnan(rise([0.0, -3.0, 1.0], begins_above=False))


def test_a_ray_that_begins_below_the_surface_meets_it_when_it_comes_up_again():
    # 4 t^2 - 4 t + 0.9: above the ray until 0.342, below it until 0.658.
    assert rise([4.0, -4.0, 0.9], begins_above=False) == pytest.approx(0.5 + np.sqrt(0.025))


def test_a_ray_known_to_be_above_hits_at_once_where_rounding_put_it_below():
    assert rise([0.0, 1.0, 1e-9], begins_above=True) == 0.0
