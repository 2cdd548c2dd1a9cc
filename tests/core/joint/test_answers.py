"""From marginals to answers: which pose, status, interval and message; nothing gets worse."""

from __future__ import annotations

from dataclasses import replace

import pytest
from joint_walks import horizon_at, photo
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.base.uncertainty import Z_90
from skyline_viewshed.core.joint.alone import alone_of
from skyline_viewshed.core.joint.answers import Limits, answers_together
from skyline_viewshed.core.joint.pairs import Tie
from skyline_viewshed.core.joint.ties import axes_of
from skyline_viewshed.core.joint.together import beliefs

LIMITS = Limits(0.85, 0.1)


def tie(one, other, turn_deg):
    return Tie(one, other, axes_of(Pose(turn_deg, 2.0)) @ axes_of(Pose(0.0, 2.0)).T, 0.4)


def answered(photos, ties=(), again=None):
    known = beliefs(photos, [alone_of(photo) for photo in photos], list(ties))
    return answers_together(photos, again or {}, known, list(ties), LIMITS)


SURE = photo("sure.jpg", "accepted", [(40.0, 0.99)])


def test_without_neighbours_the_answers_are_the_same_objects():
    photos = [SURE, photo("b.jpg", "ambiguous", [(250.0, 0.4)]), photo("c.jpg", "rejected")]
    assert all(after is before for before, after in zip(photos, answered(photos)))


def test_an_answer_that_a_tie_confirms_is_accepted_and_names_its_helper():
    photos = [SURE, photo("b.jpg", "ambiguous", [(60.4, 0.5)])]
    sure, helped = answered(photos, [tie(0, 1, 20.0)])
    assert sure is SURE and helped.status == "accepted" and helped.p_correct > 0.95
    assert 60.0 < helped.heading_deg < 60.4, "between its skyline and the tie"
    low, high = helped.heading_interval_deg
    assert difference(low, helped.heading_deg) == pytest.approx(-difference(high, helped.heading_deg))
    assert 0 < high - low < 2 * Z_90 * 0.5, "more certain than the skyline alone"
    assert "sure.jpg" in helped.orientation.notes[-1] and "decide the heading" in helped.message


def test_a_photograph_without_an_answer_gets_the_pose_of_the_tie():
    photos = [SURE, photo("b.jpg", "rejected")]
    helped = answered(photos, [tie(0, 1, 20.0)])[1]
    assert helped.status == "accepted" and helped.heading_deg == pytest.approx(60.0, abs=0.05)
    assert helped.pitch_deg == pytest.approx(2.0, abs=0.05) and helped.orientation.residual_px is None
    assert helped.orientation.uncertainty.pitch_deg > 0.4


def test_another_look_that_found_the_predicted_heading_gives_the_answer():
    photos = [SURE, photo("b.jpg", "ambiguous", [(250.0, 0.3)])]
    again = replace(photo("b.jpg", "ambiguous", [(60.2, 0.5)]), eye_elevation_m=1234.0)
    helped = answered(photos, [tie(0, 1, 20.0)], {1: again})[1]
    assert helped.eye_elevation_m == 1234.0 and helped.heading_deg == pytest.approx(60.1, abs=0.15)


def test_accepted_answers_that_contradict_one_another_are_not_left_accepted():
    for probability, heading in ((0.99, 250.0), (0.9, 90.0)):
        other = photo("other.jpg", "accepted", [(250.0, probability)])
        sure, doubted = answered([SURE, other], [tie(0, 1, 50.0)])
        assert sure is SURE and doubted.status == "ambiguous" and doubted.p_correct < 0.85
        assert doubted.heading_deg == pytest.approx(heading, abs=0.1) and "contradict" in doubted.message


def test_an_accepted_answer_that_almost_certainly_is_elsewhere_moves():
    moved = answered([SURE, photo("other.jpg", "accepted", [(250.0, 0.86)])], [tie(0, 1, 20.0)])[1]
    assert moved.status == "accepted" and moved.heading_deg == pytest.approx(60.0, abs=0.1)


def test_an_uncertain_neighbour_changes_no_status():
    photos = [SURE, photo("b.jpg", "ambiguous", [(250.0, 0.6)])]
    photos[0] = photo("weak.jpg", "ambiguous", [(40.0, 0.3)])
    first, second = answered(photos, [tie(0, 1, 20.0)])
    assert first.status == second.status == "ambiguous"
    assert second.heading_deg == pytest.approx(250.0, abs=0.1) and second.p_correct < 0.7


def test_an_answer_that_others_decide_has_a_wider_interval_before_a_near_ridge():
    width = []
    for distance_m in (400.0, 20_000.0):
        near = photo("b.jpg", "ambiguous", [(60.4, 0.5)], horizon=horizon_at(distance_m))
        helped = answered([SURE, near], [tie(0, 1, 20.0)])[1]
        low, high = helped.heading_interval_deg
        assert helped.status == "accepted"
        width.append((high - low) % 360)
    assert width[0] > 1.2 * width[1]
