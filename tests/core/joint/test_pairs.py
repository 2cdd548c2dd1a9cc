"""Which photographs are tied, and the trees of the most certain ties."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from joint_walks import photo
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.joint import pairs
from skyline_viewshed.core.joint.pairs import Tie, consistent, near_pairs, ties_between, trees
from skyline_viewshed.core.joint.ties import axes_of

POSES = [Pose(10.0, 2.0, 1.0), Pose(25.0, 4.0, -2.0), Pose(40.0, -1.0, 3.0), Pose(300.0)]


def tie(one, other, sigma=0.5, turn=0.0):
    there = replace(POSES[other], heading_deg=POSES[other].heading_deg + turn)
    return Tie(one, other, axes_of(there) @ axes_of(POSES[one]).T, sigma)


def at(east_m, minutes=0.0, name="a.jpg"):
    return replace(
        photo(name, "accepted", [(10.0, 0.9)], minutes=minutes), longitude_deg=8 + east_m / 111_195, latitude_deg=0.0
    )


def test_photographs_near_one_another_are_compared_with_the_nearest_in_time():
    assert near_pairs([at(0), at(150, 1), at(300, 2), at(5000, 3)]) == [(0, 1), (1, 2)]
    many = near_pairs([at(0, minutes) for minutes in range(30)])
    assert (0, 1) in many and (0, 29) not in many and len(many) < 30 * pairs.MOST_TIES
    assert near_pairs([photo("a.jpg", "accepted"), photo("b.jpg", "accepted")]) == []


def test_a_tie_is_less_certain_over_a_distance_and_near_terrain(monkeypatch):
    monkeypatch.setattr(pairs, "features", lambda *known: "features")
    monkeypatch.setattr(pairs, "turn_between", lambda *known: (np.eye(3), 99))
    picture = np.zeros((6, 8, 3), np.uint8)

    def sigma_deg(*photos):
        return [found.sigma_deg for found in ties_between([replace(p, preview=picture) for p in photos], SILENT)]

    (burst,), (walked,) = sigma_deg(at(0), at(0, 0.02)), sigma_deg(at(0), at(150, 2))
    assert pairs.TIE_SIGMA_DEG < burst < 0.45 < walked < 1.2
    monkeypatch.setattr(pairs, "USUAL_DISTANCE_M", 500.0)
    assert sigma_deg(at(0), at(150, 2)) == [], "the parallax is too large"


@pytest.mark.parametrize("wrong, left", [(0.0, 3), (20.0, 0)])
def test_a_triangle_that_does_not_close_is_dropped(wrong, left):
    assert len(consistent([tie(0, 1), tie(1, 2), tie(0, 2, turn=wrong)])) == left


def test_a_tie_without_a_triangle_stays_and_one_of_several_triangles_decides():
    assert len(consistent([tie(0, 1)])) == 1
    kept = consistent([tie(0, 1), tie(1, 2), tie(0, 2), tie(0, 3), tie(1, 3, turn=30.0)])
    assert {(t.one, t.other) for t in kept} == {(0, 1), (1, 2), (0, 2)}


def test_trees_lead_from_the_most_trusted_over_the_most_certain_ties():
    found = trees(5, [tie(0, 1), tie(1, 2), tie(0, 2, 2.0)], [0.3, 0.2, 0.9, 0.5, 0.1])
    assert [[number for number, _ in tree] for tree in found] == [[2, 1, 0], [3], [4]]
    assert [(t.one, t.other) for _, t in found[0][1:]] == [(1, 2), (0, 1)]
    assert found[0][0][1] is None
