import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.match.likelihood import EvidenceStack, LikelihoodOptions


def single_row(row, height=101, width=7):
    probability = np.zeros((height, width), np.float32)
    probability[row] = 1
    return probability


def test_a_certain_row_gives_the_mixture_of_a_gaussian_and_a_flat_outlier():
    stack = EvidenceStack(single_row(50), LikelihoodOptions(outlier_share=0.2, above_share=1.0))
    offset = np.arange(-10, 11)
    found = stack.look_up(np.full(21, 3), 49.5 + offset, 3.0 * np.ones(21))
    bell = np.exp(-0.5 * (offset / 3) ** 2) / np.sqrt(2 * np.pi) / 3
    # Between two tolerances of the table the value is interpolated, hence not exact.
    assert np.allclose(found, np.log1p(4 * 101 * bell), atol=0.1)
    exact = stack.at_tolerance(3.0)[40:61, 3]
    assert np.allclose(exact, np.log1p(4 * 101 * bell), atol=1e-3)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.5, 40))
def test_evidence_is_bounded_on_both_sides(seed, tolerance):
    rng = np.random.default_rng(seed)
    probability = rng.dirichlet(np.full(60, 0.1), size=8).T.astype(np.float32)
    stack = EvidenceStack(probability)
    value = stack.look_up(rng.integers(0, 8, 200), rng.uniform(-20, 80, 200), np.full(200, tolerance))
    assert (value >= np.log(0.5) - 1e-6).all()
    assert (value <= np.log1p(4 * 60)).all()


def test_rows_outside_the_picture_earn_nothing():
    stack = EvidenceStack(single_row(0))
    value = stack.look_up(np.zeros(3, int), np.array([-1.0, np.nan, 101.0]), np.ones(3))
    assert value.tolist() == [0, 0, np.log(0.5)]


def test_a_ridge_that_leaves_the_frame_speaks_for_a_horizon_above_it():
    probability = np.zeros((100, 2), np.float32)
    probability[60, 0] = 1
    options = LikelihoodOptions(outlier_share=0.2, leaving_share=0.1)
    stack = EvidenceStack(probability, options, np.array([0.0, 1.0]))
    rows, tolerance = np.array([-40.0, 5.0, 60.0]), np.full(3, 2.0)
    seen, cut = stack.look_up(np.zeros(3, int), rows, tolerance), stack.look_up(np.ones(3, int), rows, tolerance)
    assert seen[0] == 0
    assert cut[0] == pytest.approx(np.log(4 / 0.1))
    # Just inside the frame the tolerance still reaches over its edge; far inside a cut ridge counts as one too high.
    assert cut[0] > cut[1] > cut[2] == pytest.approx(np.log(options.above_share))
    assert stack.informative.tolist() == [0, 1]


def test_a_boundary_below_the_horizon_costs_less_than_one_above():
    stack = EvidenceStack(single_row(50))
    hidden, obstructed = stack.look_up(np.zeros(2, int), np.array([20.0, 80.0]), np.ones(2))
    assert hidden == pytest.approx(0, abs=0.01)
    assert obstructed == pytest.approx(np.log(0.5), abs=0.01)


def test_evidence_does_not_wrap_from_the_last_row_to_the_first():
    stack = EvidenceStack(single_row(100))
    assert stack.at_tolerance(30.0)[0].max() < stack.at_tolerance(30.0)[60].min()


def test_columns_without_information_are_told_apart():
    probability = np.full((50, 4), 1 / 50, np.float32)
    probability[:, 2] = single_row(20, 50, 1)[:, 0]
    assert EvidenceStack(probability).informative.tolist() == [2]


def test_impossible_options_are_refused():
    with pytest.raises(ValueError, match="outlier share"):
        LikelihoodOptions(outlier_share=0)
    with pytest.raises(ValueError, match="tolerances"):
        LikelihoodOptions(finest_px=5, coarsest_px=2)
