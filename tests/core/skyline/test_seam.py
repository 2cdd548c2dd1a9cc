"""Chains along columns against brute force over all lines of a small picture."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.skyline.seam import best_line, row_marginals

HEIGHT, WIDTH = 5, 4


def all_lines():
    return np.array(list(product(range(HEIGHT), repeat=WIDTH)))


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000), st.floats(0, 3), st.integers(1, 4))
def test_the_best_line_is_the_best_of_all(seed, cost, cap):
    """Every one of the 625 lines is scored in full."""
    score = np.random.default_rng(seed).normal(size=(HEIGHT, WIDTH))
    lines = all_lines()
    steps = np.minimum(np.abs(np.diff(lines, axis=1)), cap)
    totals = score[lines, np.arange(WIDTH)].sum(1) - cost * steps.sum(1)
    found = best_line(score, cost, reach_px=HEIGHT, cap_px=cap)
    np.testing.assert_array_equal(found, lines[totals.argmax()])


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000), st.floats(0.1, 3), st.floats(0.01, 0.9))
def test_marginals_are_the_sums_over_all_lines(seed, cost, jump_share):
    """The chain's joint probability, summed line by line."""
    score = np.random.default_rng(seed).normal(size=(HEIGHT, WIDTH))
    kernel = np.exp(-cost * np.abs(np.arange(-HEIGHT, HEIGHT + 1)))
    kernel /= kernel.sum()
    own = np.exp(score) / np.exp(score).sum(0)
    lines = all_lines()
    step = kernel[np.diff(lines, axis=1) + HEIGHT] * (1 - jump_share) + jump_share / HEIGHT
    weight = own[lines, np.arange(WIDTH)].prod(1) * step.prod(1)
    expected = np.zeros((HEIGHT, WIDTH))
    for x in range(WIDTH):
        np.add.at(expected[:, x], lines[:, x], weight)
    found = row_marginals(score, cost, jump_share, reach_px=HEIGHT)
    np.testing.assert_allclose(found, expected / expected.sum(0), atol=1e-9)


def test_a_column_without_information_learns_from_its_neighbours():
    """Flat in the middle, sure on both sides: the row between is most likely."""
    score = np.zeros((40, 21))
    score[12, :10] = score[12, 11:] = 9
    marginals = row_marginals(score, 0.4, 0.01)
    assert marginals[:, 10].argmax() == 12
    assert marginals[12, 10] < marginals[12, 5]


def test_contradicting_certainties_do_not_divide_by_zero():
    """Two columns sure of rows too far apart to step between; every number stays finite."""
    score = np.full((200, 2), -4000.0)
    score[3, 0] = score[190, 1] = 0
    marginals = row_marginals(score, 0.4, 0.01)
    np.testing.assert_allclose(marginals.sum(0), 1)
    assert marginals[3, 0] == pytest.approx(1)


def test_one_column_is_a_line_too():
    """Nothing to step to."""
    assert best_line(np.array([[0.0], [2.0], [1.0]]), 1.0).tolist() == [1]
    assert row_marginals(np.log([[0.2], [0.5], [0.3]]), 1.0, 0.1)[:, 0] == pytest.approx([0.2, 0.5, 0.3])
