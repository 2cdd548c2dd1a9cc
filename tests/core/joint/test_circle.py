"""Densities over the circle against closed forms of Gaussians."""

from __future__ import annotations

from math import erf, sqrt

import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.joint.circle import (
    CELLS,
    best_heading,
    mirrored,
    mixture,
    moved,
    probability_near,
    shortest_arc,
)


def test_a_mixture_has_the_given_probabilities():
    density = mixture([359.5, 120.0], [0.5, 2.0], [0.6, 0.3])
    assert density.mean() == pytest.approx(1.0)
    uniform = 0.1 * 6 / 360
    assert probability_near(density, 359.5, 3.0) == pytest.approx(0.6 + uniform, abs=1e-6)
    assert probability_near(density, 120.0, 3.0) == pytest.approx(0.3 * erf(1.5 / sqrt(2)) + uniform, abs=2e-3)
    assert best_heading(density, 3.0) == pytest.approx(359.5, abs=0.02)


@pytest.mark.parametrize("turn", [0.0, 33.33, -170.05, 340.0])
def test_a_turn_with_an_error_moves_and_widens(turn):
    found = moved(mixture([10.0], [0.6], [1.0]), turn, mixture([0.0], [0.8], [1.0]))
    assert found == pytest.approx(mixture([10.0 + turn], [1.0], [1.0]), abs=0.5)
    assert abs(difference(best_heading(found, 3.0), 10.0 + turn)) < 0.02


def test_the_mirror_image_of_a_density():
    assert mirrored(mixture([20.0], [1.0], [0.9])) == pytest.approx(mixture([340.0], [1.0], [0.9]))


def test_the_shortest_arc_of_a_gaussian_and_of_nothing():
    low, high = shortest_arc(mixture([0.3], [2.0], [1.0]), 0.3)
    assert difference(low, 0.3) == pytest.approx(-1.645 * 2, abs=0.15)
    assert difference(high, 0.3) == pytest.approx(1.645 * 2, abs=0.15)
    low, high = shortest_arc(np.ones(CELLS), 90.0)
    assert (high - low) % 360 == pytest.approx(324.0, abs=0.2) and difference((low + 162) % 360, 90.0) < 0.2
