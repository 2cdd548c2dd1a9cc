"""Least squares of tied poses: exact turns, weights, outliers and covariances."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.joint.adjust import KnownPose, adjusted
from skyline_viewshed.core.joint.pairs import Tie
from skyline_viewshed.core.joint.ties import axes_of

POSES = Pose(350.0, 2.0, 1.0), Pose(12.0, 9.0, -6.0), Pose(40.0, 1.0, 12.0)


def tie(one, other, sigma=0.3):
    return Tie(one, other, axes_of(POSES[other]) @ axes_of(POSES[one]).T, sigma)


def angles(pose):
    return pose.heading_deg, pose.pitch_deg, pose.roll_deg


def test_a_photograph_without_a_skyline_gets_the_pose_of_the_ties():
    known = {0: KnownPose(POSES[0], (0.2, 0.2, 0.2)), 5: KnownPose(Pose(14.0, 7.0, -3.0), (np.inf,) * 3)}
    turn = Tie(0, 5, tie(0, 1).rotation, 0.3)
    found = adjusted(known, [turn])
    assert angles(found[5].pose) == pytest.approx(angles(POSES[1]), abs=0.01)
    assert found[5].sigma_deg[1] == pytest.approx(np.hypot(0.2, 0.3), rel=0.05)
    assert found[0].sigma_deg == pytest.approx((0.2,) * 3, rel=0.01)


def test_errors_are_shared_by_their_weights():
    """Heading errors of +0.3 and -0.3 degrees of equal weight, and an exact tie: both move to the truth."""
    shifted = [Pose(p.heading_deg + e, p.pitch_deg, p.roll_deg) for p, e in zip(POSES, (0.3, -0.3))]
    known = {k: KnownPose(pose, (0.3, 0.3, 0.3)) for k, pose in enumerate(shifted)}
    found = adjusted(known, [tie(0, 1, 0.01)])
    for number in (0, 1):
        assert angles(found[number].pose) == pytest.approx(angles(POSES[number]), abs=0.03)
        assert found[number].sigma_deg[0] == pytest.approx(0.3 / np.sqrt(2), rel=0.15)


@pytest.mark.parametrize("wrong", [2.0, 5.0, 15.0])
def test_one_wrong_skyline_has_little_influence(wrong):
    known = {k: KnownPose(pose, (0.3, 0.3, 0.3)) for k, pose in enumerate(POSES)}
    known[2] = KnownPose(Pose(POSES[2].heading_deg + wrong, 4.0, 0.0), (0.3, 0.3, 0.3))
    found = adjusted(known, [tie(0, 1), tie(1, 2), tie(0, 2)])
    for number, pose in enumerate(POSES):
        assert angles(found[number].pose) == pytest.approx(angles(pose), abs=0.15)


def test_one_wrong_tie_has_little_influence():
    known = {k: KnownPose(pose, (0.3, 0.3, 0.3)) for k, pose in enumerate(POSES)}
    wrong = Tie(0, 2, axes_of(Pose(70.0, 0.0, 0.0)) @ axes_of(POSES[0]).T, 0.3)
    found = adjusted(known, [tie(0, 1), tie(1, 2), wrong])
    for number, pose in enumerate(POSES):
        assert angles(found[number].pose) == pytest.approx(angles(pose), abs=0.05)
