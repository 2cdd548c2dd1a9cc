"""The answers of a search, and how they are judged: by the picture first, then together with a belief."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from .match_calibration import p_correct
from .match_finding import Finding
from .match_posterior import answer_probabilities, weigh
from .match_refine import Objective
from .match_search import CoarseResult

LANDMARK_LIMIT = 3.0
"""Standard deviations within which a landmark counts as met."""

LANDMARK_PROBABILITY = 0.95
"""Least p_correct of an answer that meets every landmark: a person's word, slips of the hand set aside."""


@dataclass(frozen=True, eq=False)
class Answers:
    """Distinct answers before they are judged.

    Attributes
    ----------
    objective : Objective
    coarse : CoarseResult
    trials : (K, 5) array
        See `match_geometry.PARAMETERS`; best first.
    scale : (K,) array
        Multiple of the expected tolerance at which each fits best.
    finding : Finding
    look : callable
        Trials, best first, their scores and scales -> Finding.
    """

    objective: Objective
    coarse: CoarseResult
    trials: np.ndarray
    scale: np.ndarray
    finding: Finding
    look: Callable

    def reordered(self, order):
        """The same answers, with another one first."""
        trials, scale = self.trials[order], self.scale[order]
        return replace(self, trials=trials, scale=scale, finding=self.look(trials, self.finding.score[order], scale))


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
