"""What an error sideways does to a heading, in closed form."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from joint_walks import horizon_at, photo
from skyline_viewshed.core.base.uncertainty import TYPICAL_POSITION_ERROR_M
from skyline_viewshed.core.joint.sideways import DEM_ERROR_CELLS, sideways_deg

CELL_M = 90.0
ERROR_M = np.hypot(DEM_ERROR_CELLS * CELL_M, TYPICAL_POSITION_ERROR_M)


def before(distance_m):
    """A photograph before a horizon at a distance."""
    return photo("near.jpg", "ambiguous", [(60.0, 0.5)], horizon=horizon_at(distance_m, CELL_M))


@pytest.mark.parametrize("distance_m", [300.0, 3_000.0, 30_000.0])
def test_a_ridge_at_one_distance_turns_by_its_error_over_the_distance(distance_m):
    assert sideways_deg(before(distance_m)) == pytest.approx(np.degrees(np.arctan(ERROR_M / distance_m)), rel=1e-6)


def test_only_what_the_picture_shows_counts_and_its_far_part_counts_most():
    distance = np.full(360, 200.0)
    distance[30:91] = 20_000.0
    assert sideways_deg(before(distance)) < 0.1, "all that is in the picture is far"
    distance[30:60] = 200.0
    assert sideways_deg(before(distance)) < 0.2, "the far half decides the heading"


def test_a_worse_position_makes_the_heading_less_certain():
    near = before(1_000.0)
    worse = replace(near, metadata=replace(near.metadata, position_error_m=60.0))
    assert sideways_deg(worse) > 2 * sideways_deg(near)


def test_without_a_horizon_nothing_is_added():
    assert sideways_deg(photo("none.jpg", "ambiguous", [(60.0, 0.5)])) == 0.0
    assert sideways_deg(before(np.nan)) == 0.0
