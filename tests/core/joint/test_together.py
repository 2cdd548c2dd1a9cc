"""The headings of a walk as one problem: ties, the compass, evidence in common, wrong ties."""

from __future__ import annotations

import numpy as np
import pytest
from joint_walks import photo
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.joint.alone import alone_of
from skyline_viewshed.core.joint.pairs import Tie
from skyline_viewshed.core.joint.ties import axes_of
from skyline_viewshed.core.joint.together import WRONG_TIES, beliefs

SURE = [(40.0, 0.99), (100.0, 0.005)]


def tie(one, other, turn_deg, sigma=0.4):
    return Tie(one, other, axes_of(Pose(turn_deg, 2.0)) @ axes_of(Pose(0.0, 2.0)).T, sigma)


def solved(photos, ties=(), **how):
    return beliefs(photos, [alone_of(photo) for photo in photos], list(ties), **how)


def right(belief, heading_deg):
    return abs(difference(belief.heading_deg, heading_deg)) < 0.5


def test_without_ties_and_compass_each_photograph_keeps_its_own_probability():
    photos = [photo("a.jpg", "accepted", SURE), photo("b.jpg", "ambiguous", [(250.0, 0.4), (80.0, 0.3)])]
    first, second = solved(photos)
    assert first.probability == pytest.approx(0.99, abs=1e-3) and second.probability == pytest.approx(0.4, abs=0.01)
    assert right(second, 250.0) and first.tied == second.tied == first.by_compass == ()
    assert first.pose is None


def test_a_tie_decides_between_two_candidates():
    photos = [photo("a.jpg", "accepted", SURE), photo("b.jpg", "ambiguous", [(250.0, 0.4), (60.0, 0.3)])]
    first, second = solved(photos, [tie(0, 1, 20.0)])
    assert right(second, 60.0) and second.probability > 0.95 and second.tied == (0,)
    assert first.probability > 0.985 and second.pose.pitch_deg == pytest.approx(2.0, abs=0.1)


def test_a_heading_that_is_no_candidate_is_predicted_but_no_more_certain_than_the_tie():
    photos = [photo("a.jpg", "accepted", SURE), photo("b.jpg", "ambiguous", [(250.0, 0.3)])]
    first, second = solved(photos, [tie(0, 1, 20.0)])
    assert right(second, 60.0) and 0.8 < second.probability < 0.99 * (1 - WRONG_TIES) + 0.01
    photos[1] = photo("b.jpg", "rejected")
    assert solved(photos, [tie(0, 1, 20.0)])[1].probability == pytest.approx(0.99 * (1 - WRONG_TIES), abs=0.02)


def test_two_uncertain_photographs_that_agree_become_certain_unless_they_show_the_same():
    photos = [photo("a.jpg", "ambiguous", [(40.0, 0.6)]), photo("b.jpg", "ambiguous", [(90.0, 0.5)])]
    apart = solved(photos, [tie(0, 1, 50.0)])
    assert min(belief.probability for belief in apart) > 0.95
    photos[1] = photo("b.jpg", "ambiguous", [(42.0, 0.5)])
    same = solved(photos, [tie(0, 1, 2.0)])
    assert max(belief.probability for belief in same) < 0.9 and same[1].weight < 0.4


def test_two_certain_photographs_that_contradict_each_other_lose_their_certainty():
    photos = [photo("a.jpg", "accepted", SURE), photo("b.jpg", "accepted", [(250.0, 0.99)])]
    first, second = solved(photos, [tie(0, 1, 50.0)])
    assert right(first, 40.0) and first.probability < 0.95 and 0.4 < second.probability < 0.8


def test_the_compass_tells_of_differences_only():
    """One accepted photograph gives the error of the compass, which decides between the candidates of another."""
    answers = [(250.0, 0.4), (60.0, 0.3)]
    photos = [photo("a.jpg", "accepted", SURE, 55.0), photo("b.jpg", "ambiguous", answers, 76.0, 10)]
    first, second = solved(photos)
    assert right(second, 60.0) and second.by_compass == (0,) and 0.7 < second.probability < 0.97
    assert solved(photos[1:])[0].probability == pytest.approx(0.4, abs=0.01)
    assert right(solved(photos, with_compass=False)[1], 250.0)
    later = [photos[0], photo("b.jpg", "ambiguous", answers, 76.0, 90)]
    assert right(solved(later)[1], 250.0), "more than an hour later"


def test_no_compass_alone_accepts_a_photograph():
    photos = [photo(f"{k}.jpg", "accepted", [(10.0 * k, 0.99)], 10.0 * k + 5) for k in range(6)]
    found = solved([*photos, photo("x.jpg", "rejected", compass=205.0)])[-1]
    assert abs(difference(found.heading_deg, 200.0)) < 1 and found.probability < 0.6


def test_a_photograph_of_the_published_method_takes_no_part():
    photos = [photo("a.jpg", "accepted", SURE), photo("b.jpg", "accepted", [(60.0, None)])]
    assert solved(photos, [tie(0, 1, 20.0)])[1] is None


def test_more_ties_than_a_tree_do_not_count_twice():
    photos = [photo(f"{k}.jpg", "ambiguous", [(40.0 + 50 * k, 0.4)]) for k in range(3)]
    tree = solved(photos, [tie(0, 1, 50.0), tie(1, 2, 50.0)])
    loop = solved(photos, [tie(0, 1, 50.0), tie(1, 2, 50.0), tie(0, 2, 100.0)])
    assert [b.probability for b in loop] == pytest.approx([b.probability for b in tree], abs=0.02)
    assert all(np.isfinite(belief.density).all() for belief in loop)
