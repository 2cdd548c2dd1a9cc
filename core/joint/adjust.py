"""Least squares of the poses of tied photographs: what each skyline says of its own pose, and the turns between them.

Each pose gets a small rotation about east, north and up. In those axes a tie is the difference of two rotations, so
that the normal equations are those of a network of differences. Ties and skylines that disagree with the rest lose
weight (Cauchy), from a wide limit to a narrow one, so that the start does not decide who disagrees.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference
from .ties import axes_of, pose_of

ITERATIONS = 20
WIDEST = 6
"""The limit begins at 2 to this power times its final value, and is halved at each iteration."""
CAUCHY = 2.0
"""A residual of so many standard deviations has half its weight."""
LOOSE_DEG = 60.0
"""Standard deviation of a pose of which only the ties tell."""


@dataclass(frozen=True)
class KnownPose:
    """Pose of a photograph before the adjustment.

    Attributes
    ----------
    pose : Pose
    sigma_deg : tuple of float
        Standard deviations of heading, pitch and roll by its own skyline [degrees]; infinite without one.
    """

    pose: object
    sigma_deg: tuple


def adjusted(known, ties):
    """Adjust the poses.

    Parameters
    ----------
    known : dict of int to KnownPose
    ties : sequence of Tie
        Between photographs in `known`.

    Returns
    -------
    dict of int to KnownPose
        Adjusted poses with the standard deviations of the joint covariance.
    """
    numbers = sorted(known)
    place = {number: k for k, number in enumerate(numbers)}
    poses = {number: known[number].pose for number in numbers}
    normal = np.eye(3 * len(numbers))
    for iteration in range(ITERATIONS):
        limit = CAUCHY * 2.0 ** max(WIDEST - iteration, 0)
        normal, right = np.zeros((3 * len(numbers),) * 2), np.zeros(3 * len(numbers))
        for number in numbers:
            _add_own(normal, right, place[number], poses[number], known[number], limit)
        for tie in ties:
            _add_tie(normal, right, (place[tie.one], place[tie.other]), poses, tie, limit)
        step = np.linalg.solve(normal, right).reshape(-1, 3)
        for number in numbers:
            poses[number] = pose_of(axes_of(poses[number]) @ _turned_by(step[place[number]]))
        if iteration > WIDEST and np.abs(step).max() < 1e-7:
            break
    covariance = np.linalg.inv(normal)
    found = {}
    for number in numbers:
        here = slice(3 * place[number], 3 * place[number] + 3)
        to_angles = np.linalg.inv(_angle_axes(poses[number]))
        spread = np.sqrt(np.diag(to_angles @ covariance[here, here] @ to_angles.T))
        found[number] = KnownPose(poses[number], tuple(float(value) for value in np.degrees(spread)))
    return found


def _add_own(normal, right, k, pose, known, limit):
    sigma = np.radians(np.minimum(known.sigma_deg, LOOSE_DEG))
    axes = _angle_axes(pose)
    away = np.radians(
        [
            float(difference(known.pose.heading_deg, pose.heading_deg)),
            known.pose.pitch_deg - pose.pitch_deg,
            known.pose.roll_deg - pose.roll_deg,
        ]
    )
    to_angles = np.linalg.inv(axes)
    scaled = away / sigma
    information = np.diag(1 / sigma**2) / (1 + np.square(scaled).max() / limit**2)
    here = slice(3 * k, 3 * k + 3)
    normal[here, here] += to_angles.T @ information @ to_angles
    right[here] += to_angles.T @ information @ away


def _add_tie(normal, right, places, poses, tie, limit):
    one, other = axes_of(poses[tie.one]), axes_of(poses[tie.other])
    error = tie.rotation @ one @ other.T
    miss = other.T @ (0.5 * np.array([error[2, 1] - error[1, 2], error[0, 2] - error[2, 0], error[1, 0] - error[0, 1]]))
    sigma = np.radians(tie.sigma_deg)
    weight = 1 / sigma**2 / (1 + (miss @ miss) / (limit * sigma) ** 2)
    a, b = (slice(3 * k, 3 * k + 3) for k in places)
    block = weight * np.eye(3)
    normal[a, a] += block
    normal[b, b] += block
    normal[a, b] -= block
    normal[b, a] -= block
    # The turn from one to other is too small by the rotations of other minus one.
    right[a] += weight * miss
    right[b] -= weight * miss


def _angle_axes(pose):
    """Columns: rotations about east, north and up per unit of heading, pitch and roll."""
    level = axes_of(replace(pose, pitch_deg=0.0, roll_deg=0.0))
    return np.column_stack([[0.0, 0.0, -1.0], level[0], axes_of(pose)[2]])


def _turned_by(rotation):
    """Matrix that turns rows of axes by a small rotation vector."""
    angle = float(np.linalg.norm(rotation))
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = rotation / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return turn.T
