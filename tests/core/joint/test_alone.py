"""What a photograph says by itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from joint_walks import CAMERA, photo
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.base.model import Candidate
from skyline_viewshed.core.joint.alone import SURE, alone_of
from skyline_viewshed.core.joint.circle import probability_near


def test_candidates_and_none_of_them():
    alone = alone_of(photo("a.jpg", "ambiguous", [(10.0, 0.5), (200.0, 0.2)]))
    assert probability_near(alone.density(), np.array([10.0, 200.0]), 3.0) == pytest.approx([0.505, 0.205], abs=1e-3)


def test_an_answer_that_something_contradicts_counts_less():
    doubted = photo("a.jpg", "ambiguous", [(10.0, 0.95), (200.0, 0.01)])
    doubted = replace(doubted, orientation=replace(doubted.orientation, p_correct=0.5))
    assert alone_of(doubted).probability[0] == 0.5


def test_no_photograph_is_certain_and_one_without_candidates_knows_nothing():
    assert alone_of(photo("a.jpg", "accepted", [(10.0, 1.0)])).probability.sum() == pytest.approx(SURE)
    assert (alone_of(photo("a.jpg", "rejected")).density() == 1).all()
    assert alone_of(photo("a.jpg", "accepted", [(10.0, None)])) is None, "the published method"


def test_likelihood_ratios_weigh_against_none_of_them():
    alone = alone_of(photo("a.jpg", "ambiguous", [(10.0, 0.4), (200.0, 0.2)])).favoured(np.array([3.0, 1.0]))
    assert alone.probability == pytest.approx([1.2 / 1.8, 0.2 / 1.8])


@pytest.mark.parametrize("score, more", [(1.0, 1.0), (5.0, 1.0), (0.5, np.exp(-3.25)), (-9.0, 0.0)])
def test_a_candidate_found_later_gets_what_its_score_would_have_given(score, more):
    alone = alone_of(photo("a.jpg", "ambiguous", [(10.0, 0.4), (200.0, 0.2)]))
    found = alone.joined(Candidate(Pose(90.0), CAMERA, score, None, 0.5), 6.5)
    second = np.exp(-0.65)
    assert found.probability[0] == 0.4
    assert found.probability[1:] == pytest.approx(0.6 * np.array([second, more]) / (second + more + 1), abs=1e-6)
