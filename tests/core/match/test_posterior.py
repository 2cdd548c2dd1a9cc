from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.model import Candidate
from skyline_viewshed.core.match.finding import Finding
from skyline_viewshed.core.match.posterior import (
    answer_probabilities,
    doubt,
    features,
    interval,
    p_correct,
    table,
    verdict,
    weigh,
)
from skyline_viewshed.core.match.prior import HeadingPrior


def finding(heading=(100.0, 250.0), score=(4.5, 3.0), sigma=(0.3, 0.3), relief=1.2, residual=1.0, hfov=45.0):
    return Finding(np.array(heading), np.array(score), np.array(sigma), relief, 0.9, residual, 2.5, 0.9, hfov)


def width_of(arc):
    return (arc[1] - arc[0]) % 360


@settings(max_examples=30, deadline=None)
@given(st.floats(0, 359.99), st.floats(0.1, 3.0))
def test_a_sure_answer_s_interval_is_the_gaussian_one(heading, sigma):
    lo, hi = arc = interval(finding((heading,), (4.5,), (sigma,)), np.array([1.0]))
    expected = 2 * 1.645 * sigma * table()["sigma_factor"]
    assert width_of(arc) == pytest.approx(expected, abs=0.2)
    assert abs(((lo + width_of(arc) / 2) - heading + 180) % 360 - 180) < 0.11


def test_a_doubtful_answer_s_interval_reaches_to_its_rival():
    arc = interval(finding(), np.array([0.6, 0.4]))
    lo, hi = arc
    assert (100 - lo) % 360 <= width_of(arc)
    assert (250 - lo) % 360 <= width_of(arc)
    assert width_of(arc) < 215  # the shorter way round


def test_what_no_answer_explains_widens_the_interval():
    narrow = interval(finding(), np.array([0.95, 0.04]))
    wide = interval(finding(), np.array([0.5, 0.04]))
    assert width_of(wide) > 10 * width_of(narrow)


def test_probabilities_of_the_answers_stay_below_one_in_sum():
    found = finding((10.0, 20.0, 30.0), (4.0, 3.9, 2.0), (0.3, 0.3, 0.3))
    share = answer_probabilities(found, 0.6)
    assert share[0] == 0.6
    assert share[1] > share[2] > 0
    assert share.sum() < 1


def test_a_larger_gap_a_closer_fit_and_more_relief_are_surer():
    base = p_correct(finding())
    assert p_correct(finding(score=(4.5, 4.4))) < base
    assert p_correct(finding(residual=8.0)) < base
    assert p_correct(finding(relief=0.1)) < base


def test_one_answer_without_a_rival_is_no_proof():
    assert p_correct(finding((100.0,), (4.5,), (0.3,))) < p_correct(finding())


def test_nothing_beyond_what_the_table_has_seen_becomes_surer():
    assert p_correct(finding(residual=1e-9)) == p_correct(finding(residual=0.01))


def test_the_table_names_only_features_that_exist_and_says_where_it_comes_from():
    assert set(table()["features"]) <= set(features(finding()))
    assert len(table()["origin"]) > 20


@pytest.mark.parametrize(
    ("probability", "relief", "status", "words"),
    [
        ((0.97, 0.02), 1.0, "accepted", "no other heading"),
        ((0.55, 0.40), 1.0, "ambiguous", "A heading of 250 degrees fits nearly as well"),
        ((0.50, 0.05), 1.0, "ambiguous", "The fit is weak"),
        ((0.04, 0.03), 1.0, "rejected", "Check the position and the field of view"),
        ((0.97, 0.02), 0.05, "rejected", "almost straight"),
    ],
)
def test_the_status_says_why_and_what_to_do(probability, relief, status, words):
    found, message = verdict(finding(relief=relief), np.array(probability))
    assert found == status
    assert words in message


def test_a_belief_is_joined_by_the_rule_of_bayes():
    """Against the rule written out: Gaussian core and uniform share, 'none of them' uniform over the circle."""
    prior = HeadingPrior(100.0, 10.0, outlier_share=0.2, faults=())
    density = 0.2 + 0.8 * 360 / (np.sqrt(2 * np.pi) * 10) * np.exp(-0.5 * (np.array([0.0, 150.0]) / 10) ** 2)
    joint = np.array([0.3, 0.6]) * density
    found = weigh(np.array([0.3, 0.6]), np.array([100.0, 250.0]), prior)
    assert found == pytest.approx(joint / (joint.sum() + 0.1))
    assert found[0] > 0.8


def test_no_belief_changes_nothing():
    probability = np.array([0.3, 0.6])
    assert weigh(probability, np.array([100.0, 250.0]), None) == pytest.approx(probability)


@settings(max_examples=30, deadline=None)
@given(st.integers(2, 5), st.floats(3.0, 9.0), st.floats(0.3, 9.0))
def test_of_equal_answers_none_is_surer_than_its_share(answers, score, relief):
    """Whatever the picture's other qualities: n twins are right one time in n."""
    twins = finding(np.arange(answers) * 60.0, np.full(answers, score), np.full(answers, 0.2), relief)
    assert p_correct(twins) <= 1 / answers + 1e-9


def test_a_horizon_of_few_cells_of_the_dem_is_believed_less():
    far = finding()
    shares = [p_correct(replace(far, horizon_cells=cells)) / p_correct(far) for cells in (0.1, 3.0, 20.0, 200.0)]
    assert shares == sorted(shares)
    assert shares[0] == pytest.approx(0.5, abs=0.001)
    assert shares[1] == pytest.approx(0.75)
    assert shares[3] > 0.999


def answer(heading_deg, probability):
    return Candidate(Pose(heading_deg), Camera(400, 300, 400.0), 3.0, probability)


def test_an_answer_that_does_not_follow_the_skyline_is_doubted():
    assert "skyline" in doubt([answer(10.0, 0.99)], 0.1, None)
    assert doubt([answer(10.0, 0.99)], 0.6, None) is None
    assert doubt([answer(10.0, 0.99)], None, None) is None


def test_a_compass_that_contradicts_raises_a_doubt_unless_the_picture_is_very_certain():
    assert "190 degrees" in doubt([answer(10.0, 0.9)], 0.9, 190.4)
    assert doubt([answer(10.0, 0.998)], 0.9, 190.4) is None
    assert doubt([answer(10.0, 0.9)], 0.9, 352.0) is None
    assert doubt([answer(10.0, 0.9)], 0.9, None) is None
