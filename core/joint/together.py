"""The headings of all photographs of a walk as one problem, and the marginal of each.

The heading of each photograph is an unknown on the circle. By itself it has the candidates of the skyline, and the
possibility that it is none of them. Ties by features give the turns between photographs from nearly one place, as a
tree, so that no information returns to its source; the compass's error of each device and hour is an unknown that
joins the trees. So the problem is a forest, and its marginals are exact.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.camera import Pose
from .circle import CELLS, best_heading, mixture, probability_near
from .compass import device_hours, reading_error, reading_of_tree
from .forest import Turn, marginals
from .pairs import trees
from .shares import evidence_weights
from .ties import turned

WRONG_TIES = 0.05
"""Share of the ties that are wrong although many features agree: repeated or moving things, near terrain."""
WIDE_TIES, WIDE = 0.2, 3.0
"""Share of the ties whose error spreads so many times as far."""
RIGHT_DEG = 3.0
"""`p_correct` is the probability that the truth is within this distance of the answer."""
HELPED = 2.0
"""A neighbour helped if it makes the answer this many times as likely."""


@dataclass(frozen=True, eq=False)
class Belief:
    """Marginal of one photograph's heading.

    Attributes
    ----------
    density : (CELLS,) array
        On the grid of `circle`, relative to the uniform one.
    heading_deg : float
        The answer [degrees].
    probability : float
        That the truth is within `RIGHT_DEG` of it.
    weight : float
        Share of the photograph's own evidence that counts.
    pose : Pose or None
        Predicted by the ties at that heading; None without ties.
    tied, by_compass : tuple of int
        Photographs that helped, through a tie or through the compass.
    """

    density: np.ndarray
    heading_deg: float
    probability: float
    weight: float = 1.0
    pose: Pose | None = None
    tied: tuple = ()
    by_compass: tuple = ()

    def probability_of(self, heading_deg):
        """Probability that the truth is within `RIGHT_DEG` of a heading."""
        return float(probability_near(self.density, heading_deg, RIGHT_DEG))


def beliefs(photos, alones, ties, with_compass=True):
    """Solve the problem.

    Parameters
    ----------
    photos : list of OrientedPhoto
    alones : list of Alone or None
        None takes no part.
    ties : list of Tie
    with_compass : bool
        Whether the common error of the compass takes part; not if each photograph has used its compass already.

    Returns
    -------
    list of Belief or None
    """
    ties = [tie for tie in ties if alones[tie.one] is not None and alones[tie.other] is not None]
    trust = [-1.0 if alone is None or not len(alone.probability) else float(alone.probability[0]) for alone in alones]
    own, turns, groups = np.ones((len(photos), CELLS)), [], device_hours(photos) if with_compass else {}
    weights: dict = {}
    poses: dict = {}
    readings: dict = {}
    root_of: dict = {}
    for tree in trees(len(photos), ties, trust):
        order = [number for number, _ in tree]
        poses.update(_poses(alones, tree))
        root_of.update(dict.fromkeys(order, order[0]))
        if len(order) > 1:
            weights.update(evidence_weights(photos, poses, sorted(order, key=lambda number: -trust[number])))
            turns += [_turn(tie, poses, number) for number, tie in tree[1:]]
        known = None if alones[order[0]] is None else reading_of_tree(
            photos, order, {number: poses[number].heading_deg for number in order}, groups
        )  # fmt: skip
        if known is not None:
            readings.setdefault(known[0], []).append((order[0], *known[1:]))
    for number, alone in enumerate(alones):
        if alone is not None:
            density = alone.density() ** weights.get(number, 1.0)
            own[number] = density / density.mean()
    shared = [(len(photos) + k, told) for k, told in enumerate(t for t in readings.values() if len(t) > 1)]
    error = reading_error()
    for bias, told in shared:
        turns += [Turn(bias, root, reading, error) for root, reading, _ in told]
    found, heard = marginals(np.concatenate([own, np.ones((len(shared), CELLS))]), turns)
    answers: list = []
    for number, alone in enumerate(alones):
        if alone is None:
            answers.append(None)
            continue
        heading = best_heading(found[number], RIGHT_DEG)
        belief = Belief(found[number], heading, 0.0, weights.get(number, 1.0))
        belief = replace(belief, probability=belief.probability_of(heading))
        if number in weights:
            belief = replace(belief, pose=_at_heading(poses[number], heading))
        answers.append(_with_helpers(belief, number, heard, (shared, root_of, trust)))
    return answers


def tie_error(sigma_deg):
    """Density of the error of a tie on the grid of `circle`."""
    right = 1 - WRONG_TIES
    return mixture([0.0, 0.0], [sigma_deg, WIDE * sigma_deg], [right * (1 - WIDE_TIES), right * WIDE_TIES])


def _poses(alones, tree):
    """Poses that are consistent with the ties, from the best candidate of the root."""
    root = tree[0][0]
    first = alones[root].candidates if alones[root] is not None else ()
    poses = {root: first[0].pose if first else Pose(0.0, 0.0, 0.0)}
    for number, tie in tree[1:]:
        before = tie.one if number == tie.other else tie.other
        poses[number] = turned(poses[before], tie.towards(number))
    return poses


def _turn(tie, poses, number):
    before = tie.one if number == tie.other else tie.other
    turn_deg = float(difference(poses[number].heading_deg, poses[before].heading_deg))
    steep = max(np.cos(np.radians(poses[number].pitch_deg)), 0.1)
    return Turn(before, number, turn_deg, tie_error(tie.sigma_deg / steep))


def _at_heading(pose, heading_deg):
    """Same tilt at another heading; the ties hold whatever the heading of the first photograph is."""
    return replace(pose, heading_deg=float(wrap_360(heading_deg)))


def _with_helpers(belief, number, heard, around):
    shared, root_of, trust = around
    tied, by_compass = [], []
    for (teller, listener), density in heard.items():
        if listener != number or probability_near(density, belief.heading_deg, RIGHT_DEG) * 180 / RIGHT_DEG < HELPED:
            continue
        told = [roots for bias, roots in shared if bias == teller]
        if told:
            others = [other for root, _, members in told[0] if root != root_of[number] for other in members]
            by_compass += sorted(others, key=lambda other: -trust[other])
        else:
            tied.append(teller)
    return replace(belief, tied=tuple(sorted(tied)), by_compass=tuple(by_compass))
