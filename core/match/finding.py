"""The answers of a fit: what speaks for and against each of them, and how probable it is that they are right.

`examine` gathers a `Finding`, the quantities that tell right answers from wrong ones; `judge` turns it into
probabilities, by the calibration and by what is believed of the heading.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .geometry import horizon_rows
from .posterior import answer_probabilities, p_correct, weigh
from .refine import Objective
from .search import CoarseResult

LANDMARK_LIMIT = 3.0
"""Standard deviations within which a landmark counts as met."""

LANDMARK_PROBABILITY = 0.95
"""Least p_correct of an answer that meets every landmark: a person's word, slips of the hand set aside."""


@dataclass(frozen=True, eq=False)
class Finding:
    """The answers and what speaks for and against them.

    Attributes
    ----------
    heading_deg, score : (K,) arrays
        Distinct answers, best first; the scores include priors and inner crests.
    sigma_deg : (K,) array
        Standard deviation of each heading: curvature of the score, DEM, position.
    relief_deg : float
        Spread of the horizon inside the frame about a straight line, at the best answer [degrees].
    explained : float
        Share of the columns that the best answer explains.
    residual_px : float
        Median distance of the likeliest rows from the best answer's horizon [pixels of the reduced picture].
    terrain_px : float
        Median tolerance that the DEM's and the position's errors ask for at the best answer [pixels of the reduced
        picture].
    sureness : float
        Mean over the columns of the probability near each column's likeliest row: how decided the evidence is.
    hfov_deg : float
    """

    heading_deg: np.ndarray
    score: np.ndarray
    sigma_deg: np.ndarray
    relief_deg: float
    explained: float
    residual_px: float = 1.0
    terrain_px: float = 1.0
    sureness: float = 0.5
    hfov_deg: float = 45.0

    @property
    def gap(self):
        """Score of the best above the second answer; 0 where there is no second one to compare with."""
        return float(self.score[0] - self.score[1]) if len(self.score) > 1 else 0.0


@dataclass(frozen=True, eq=False)
class Answers:
    """Distinct answers before they are judged.

    Attributes
    ----------
    objective : Objective
    coarse : CoarseResult
    trials : (K, 5) array
        See `geometry.PARAMETERS`; best first.
    scale : (K,) array
        Multiple of the expected tolerance at which each fits best.
    finding : Finding
    floor_deg : float
        Smallest standard deviation that a heading is credited with [degrees].
    """

    objective: Objective
    coarse: CoarseResult
    trials: np.ndarray
    scale: np.ndarray
    finding: Finding
    floor_deg: float

    def reordered(self, order):
        """The same answers, with another one first."""
        trials, scale = self.trials[order], self.scale[order]
        finding = examine(self.objective, trials, self.finding.score[order], scale, self.floor_deg)
        return replace(self, trials=trials, scale=scale, finding=finding)


def examine(objective, trials, score, scale, floor_deg):
    """Gather a `Finding` from distinct trials, best first.

    Parameters
    ----------
    objective : refine.Objective
    trials : (K, 5) array
        See `geometry.PARAMETERS`.
    score, scale : (K,) arrays
        `scale` is the multiple of the expected tolerance at which a trial fits best.
    floor_deg : float
        Smallest standard deviation that a heading is credited with [degrees].
    """
    columns, probability = objective.columns(1), objective.stack.probability
    row, tolerance = objective.rows(trials[:1], columns)
    row, tolerance = row[0], tolerance[0]
    value = objective.stack.look_up(columns, row, tolerance * 1.5)
    inside = np.isfinite(row) & (row >= 0) & (row <= objective.stack.shape[0] - 1)
    likeliest = probability[:, columns].argmax(axis=0)
    miss = np.abs(likeliest - 0.5 - row)[inside]
    return Finding(
        trials[:, 0],
        score,
        heading_sigma_deg(objective, trials, scale, objective.position_error_m, floor_deg),
        float(np.degrees(relief_px(columns[inside], row[inside]) / objective.camera.focal_px)),
        float(np.mean(value > np.log(3.0))),
        float(np.median(miss)) if len(miss) else float(objective.stack.shape[0]),
        float(np.median(tolerance)),
        _sureness(probability[:, columns], likeliest),
        objective.camera.hfov_deg,
    )


def heading_sigma_deg(objective, trials, scale, position_error_m, floor_deg):
    """Standard deviation of each trial's heading [degrees], at most 30.

    The inverse curvature of the score gives what the picture leaves open. Two errors shift the whole horizon and do
    not show in it: the DEM's, c cells, and the position's, both over the terrain's distance. A trial that fits best
    at a wider tolerance (`scale`) says that the DEM, or the lens, is so much worse here than expected.

    Parameters
    ----------
    objective : refine.Objective
    trials : (K, 5) array
        See `geometry.PARAMETERS`.
    scale : (K,) array
        Multiple of the expected tolerance at which each trial fits best.
    position_error_m : float
        Standard deviation of the position [m].
    floor_deg : float
        Smallest standard deviation that a heading is credited with [degrees].
    """
    _, _, curvature = objective.expand(trials, 1.5 * scale)
    free = np.flatnonzero(objective.free)
    information = curvature[np.ix_(range(len(trials)), free, free)] * objective.options.effective_columns
    covariance = np.linalg.pinv(information + 1e-6 * np.eye(len(free)))
    _, azimuth, _ = horizon_rows(objective.curve, objective.camera, trials, objective.columns(4))
    distance = np.median(objective.curve.distance_m[objective.curve.nearest(azimuth)], axis=1)
    terrain = np.degrees(scale * objective.options.terrain_error_cells * objective.curve.cell_m / distance)
    shift = np.degrees(position_error_m / distance)
    return np.minimum(np.sqrt(covariance[:, 0, 0] + terrain**2 + shift**2 + floor_deg**2), 30.0)


def relief_px(columns, row):
    """Standard deviation of rows about a straight line [pixels]; 0 where there are too few."""
    if len(columns) < 20:
        return 0.0
    return float(np.std(row - np.polyval(np.polyfit(columns, row, 1), columns)))


def _sureness(probability, likeliest, reach_px=2):
    height, width = probability.shape
    columns = np.arange(width)
    near = [probability[np.clip(likeliest + d, 0, height - 1), columns] for d in range(-reach_px, reach_px + 1)]
    return float(np.minimum(np.sum(near, axis=0), 1).mean()) if width else 0.0


def judge(answers, heading_prior=None):
    """Probability of each answer, by the picture and by the belief in a heading; both come back best first.

    The picture speaks first and alone, since its probabilities are calibrated so; then the belief is joined to it.
    """
    best_probability = p_correct(answers.finding)
    if _landmarks_met(answers):
        best_probability = max(best_probability, LANDMARK_PROBABILITY)
    probability = answer_probabilities(answers.finding, best_probability)
    if heading_prior is None:
        return answers, probability
    probability = weigh(probability, answers.trials[:, 0], heading_prior)
    order = np.argsort(-probability, kind="stable")
    return answers.reordered(order), probability[order]


def _landmarks_met(answers):
    """Whether there are landmarks and the best answer meets all of them."""
    miss = answers.objective.landmark_residual(answers.trials[:1])
    return miss.size > 0 and bool((np.abs(miss) < LANDMARK_LIMIT).all())
