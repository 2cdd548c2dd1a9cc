"""Angles wrap, differ and turn between true and grid north in the standard sense."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.base import angles

ANGLE = st.floats(-1e4, 1e4)


@given(ANGLE)
def test_wrapped_angles_stay_in_range_and_keep_their_direction(angle):
    wrapped = angles.wrap_360(angle)
    assert 0 <= wrapped < 360
    assert np.sin(np.radians(wrapped)) == pytest.approx(np.sin(np.radians(angle)), abs=1e-9)
    assert -180 <= angles.wrap_180(angle) < 180


@given(ANGLE, ANGLE)
def test_reference_plus_difference_is_the_angle(angle, reference):
    turned = reference + angles.difference(angle, reference)
    assert angles.difference(turned, angle) == pytest.approx(0, abs=1e-8)


@given(ANGLE, st.floats(-180, 180))
def test_grid_azimuth_plus_convergence_is_the_true_one(azimuth, convergence):
    found = angles.true_to_grid(azimuth, convergence) + convergence
    assert angles.difference(found, azimuth) == pytest.approx(0, abs=1e-8)


def test_a_tiny_negative_angle_does_not_become_360():
    assert angles.wrap_360(-1e-20) == 0


def test_true_north_of_a_grid_turned_clockwise_lies_left_of_its_columns():
    # Convergence +2: grid north points 2 degrees east of true north, so true north is at grid bearing 358.
    assert angles.true_to_grid(0.0, 2.0) == 358.0


@pytest.mark.parametrize(
    "azimuth, centre, width, inside",
    [(350, 10, 40, True), (30, 10, 40, True), (31, 10, 40, False), (180, 0, 360, True), (349, 10, 40, False)],
)
def test_wedges_include_their_edges_and_straddle_north(azimuth, centre, width, inside):
    assert bool(angles.in_wedge(azimuth, centre, width)) is inside
