"""Exact marginals: two photographs, two candidates each and one tie in closed form; a tree against brute force."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.joint.circle import CELLS, GRID_DEG, mixture, probability_near
from skyline_viewshed.core.joint.forest import Turn, marginals

WRONG = 0.05


def gaussian(away, sigma):
    return np.exp(-0.5 * (away / sigma) ** 2) * 360 / (np.sqrt(2 * np.pi) * sigma)


@pytest.mark.parametrize("turn", [15.0, -340.0])
@pytest.mark.parametrize("apart", [0.0, 1.0])
def test_two_photographs_with_two_candidates_and_one_tie(turn, apart):
    """The first pair of candidates agrees with the tie to `apart`, the other pairs do not."""
    first, second = np.array([40.0, 200.0]), np.array([40.0 + turn + apart, 300.0])
    p, q, sigma, tie_sigma = np.array([0.3, 0.5]), np.array([0.25, 0.6]), 0.5, 0.7
    own = np.array([mixture(first, [sigma] * 2, p), mixture(second, [sigma] * 2, q)])
    found, _ = marginals(own, [Turn(0, 1, turn, mixture([0.0], [tie_sigma], [1 - WRONG]))])
    total_sigma = np.sqrt(2 * sigma**2 + tie_sigma**2)
    ratio = WRONG + (1 - WRONG) * gaussian(difference(second[None], first[:, None] + turn), total_sigma)
    p0, q0 = 1 - p.sum(), 1 - q.sum()
    total = (p[:, None] * q * ratio).sum() + p.sum() * q0 + p0 * q.sum() + p0 * q0
    # The other ones of each photograph lie where the tie predicts them from the candidates, or anywhere.
    for k in range(2):
        exact = p[k] * ((q * ratio[k]).sum() + q0) / total
        uniform = p0 * (q * (WRONG * 6 / 360)).sum() / total + p0 * q0 * 6 / 360 / total
        predicted = (1 - WRONG) * p0 * q[(np.abs(difference(second - turn, first[k])) < 3)].sum() / total
        assert probability_near(found[0], first[k], 3.0) == pytest.approx(exact + uniform + predicted, abs=4e-3)
    assert found.mean(axis=1) == pytest.approx(1.0)


def test_a_photograph_that_knows_nothing_gets_the_heading_of_its_neighbour():
    own = np.array([mixture([350.0], [0.5], [0.9]), np.ones(CELLS)])
    found, heard = marginals(own, [Turn(0, 1, 30.0, mixture([0.0], [0.5], [0.95]))])
    assert probability_near(found[1], 20.0, 3.0) == pytest.approx(0.9 * 0.95, abs=0.01)
    assert found[0] == pytest.approx(own[0]), "nothing comes back"
    assert probability_near(heard[0, 1], 20.0, 3.0) == pytest.approx(0.9 * 0.95, abs=0.01)


def test_a_tree_agrees_with_brute_force():
    generator, step = np.random.default_rng(4), 20
    coarse = np.exp(generator.normal(0, 1.5, (4, CELLS // step)))
    own = np.repeat(coarse, step, axis=1)
    own /= own.mean(axis=1, keepdims=True)
    error = mixture([0.0, 90.0], [3.0, 5.0], [0.6, 0.2])
    links = [(0, 1, 12.0), (2, 1, -47.0), (1, 3, 161.0)]
    found, _ = marginals(own, [Turn(*link, error) for link in links])
    pair = {}
    for one, other, turn in links:
        cells = np.rint(np.mod(GRID_DEG[None] - GRID_DEG[:, None] - turn, 360) * 10).astype(int) % CELLS
        pair[one, other] = error[cells]
    middle = own[1] * (own[0] @ pair[0, 1]) * (own[2] @ pair[2, 1]) * (pair[1, 3] @ own[3])
    assert found[1] == pytest.approx(middle / middle.mean(), rel=1e-6)
    end = (own[1] * (own[0] @ pair[0, 1]) * (own[2] @ pair[2, 1])) @ pair[1, 3] * own[3]
    assert found[3] == pytest.approx(end / end.mean(), rel=1e-6)


@pytest.mark.parametrize("links", [[(0, 1), (1, 2), (2, 0)], [(0, 1), (1, 0)]])
def test_loops_are_refused(links):
    with pytest.raises(ValueError, match="loop"):
        marginals(np.ones((3, CELLS)), [Turn(*link, 0.0, np.ones(CELLS)) for link in links])
