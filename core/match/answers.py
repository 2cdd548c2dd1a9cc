"""Weigh the answers of a fit against one another and against what is known of the heading beforehand."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.special import ndtr

from ..base.angles import difference
from .finding import Finding, examine
from .posterior import answer_probabilities, p_correct, weigh
from .search import CoarseResult

LANDMARK_LIMIT = 3.0
"""Largest miss at which an answer still fits a landmark [standard deviations]."""

LANDMARK_PROBABILITY = 0.95
"""Smallest p_correct of an answer that fits every landmark; the remainder allows for slips of the hand."""

RIGHT_DEG = 3.0
"""An answer is right within this distance of the truth; `p_correct` is the probability of that."""

DENSITY_DEG = 0.5
"""Reach within which the density of the posterior is compared."""

REGION_DEG = 10.0
"""Answers within this distance support one another when a region of the circle is chosen."""


@dataclass(frozen=True, eq=False)
class Answers:
    """Distinct answers before they are judged.

    Attributes
    ----------
    objectives : tuple of Objective
        One for each hypothesis of the eye.
    coarse : CoarseResult
    trials : (K, 5) array
        See `geometry.PARAMETERS`; best first.
    eye : (K,) int array
        Hypothesis of the eye to which each answer belongs.
    scale : (K,) array
        Multiple of the expected tolerance at which each fits best.
    finding : Finding
    floor_deg : float
        Lower limit of the standard deviation of a heading [degrees].
    hint : int or None
        Index of the answer that is the heading known beforehand itself.
    hint_sigma_deg : float
        Its standard deviation [degrees].
    """

    objectives: tuple
    coarse: CoarseResult
    trials: np.ndarray
    eye: np.ndarray
    scale: np.ndarray
    finding: Finding
    floor_deg: float
    hint: int | None = None
    hint_sigma_deg: float = 0.0

    @property
    def objective(self):
        """The objective of the best answer."""
        return self.objectives[self.eye[0]]

    def curve(self):
        """Headings [degrees] and scores of the whole circle that agree with the fitted answers.

        The coarse search tries rolls in steps and at one tolerance, so its scores of a rolled photograph fall short of
        those of the fits. The difference at the fitted headings is interpolated between them. No heading scores more
        than the best fit.

        Returns
        -------
        heading_deg, score : (N,) arrays
            On the grid of the coarse search.
        """
        fitted = np.arange(len(self.trials)) != (-1 if self.hint is None else self.hint)
        at, score = np.mod(self.trials[fitted, 0], 360.0), self.finding.score[fitted]
        around = self.coarse
        near = [around.score[np.abs(difference(around.heading_deg, heading)) <= RIGHT_DEG].max() for heading in at]
        shift = np.interp(around.heading_deg, at[np.argsort(at)], (score - near)[np.argsort(at)], period=360.0)
        value = np.minimum(around.score + shift, score.max()).astype(float)
        for heading, own in zip(at[::-1], score[::-1]):  # the best one last
            value[np.abs(difference(around.heading_deg, heading)).argmin()] = own
        return around.heading_deg, value

    def with_hint(self, heading_prior):
        """Append the pose at a heading that is known beforehand, with the pitch and roll that fit the picture best."""
        around = self.coarse
        at = int(np.abs(difference(around.heading_deg, heading_prior.heading_deg)).argmin())
        trial = np.array([heading_prior.heading_deg, around.pitch_deg[at], around.roll_deg[at], 0.0, 0.0])
        return replace(
            self,
            trials=np.vstack([self.trials, trial]),
            eye=np.append(self.eye, self.eye[0]),
            scale=np.append(self.scale, self.scale.max()),
            finding=replace(self.finding, score=np.append(self.finding.score, around.score[at])),
            hint_sigma_deg=heading_prior.spread_deg,
            hint=len(self.trials),
        )

    def reordered(self, order):
        """Return the answers in another order, examined again for the new first one."""
        trials, eye, scale = self.trials[order], self.eye[order], self.scale[order]
        finding = examine(self.objectives, Fits(trials, eye, self.finding.score[order], scale), self.floor_deg)
        hint = None
        if self.hint is not None:
            hint = int(np.flatnonzero(order == self.hint)[0])
            finding.sigma_deg[hint] = self.hint_sigma_deg
        return replace(self, trials=trials, eye=eye, scale=scale, finding=finding, hint=hint)


@dataclass(frozen=True, eq=False)
class Fits:
    """Fitted trials, best first.

    Attributes
    ----------
    trials : (K, 5) array
        See `geometry.PARAMETERS`.
    eye : (K,) int array
        Hypothesis of the eye under which each was fitted.
    score, scale : (K,) arrays
        `scale` is the multiple of the expected tolerance at which a trial fits best.
    """

    trials: np.ndarray
    eye: np.ndarray
    score: np.ndarray
    scale: np.ndarray

    def take(self, index):
        """Return some of the fits, in the order of `index`."""
        return Fits(self.trials[index], self.eye[index], self.score[index], self.scale[index])


def judge(answers, heading_prior=None):
    """Weigh the answers, by the picture and by what is known of the heading beforehand.

    The probabilities are first computed from the picture alone, since they are calibrated that way; the heading prior
    is applied afterwards. The prior's own heading is an answer too: it gets the probability that none of the picture's
    answers is right, so that the result falls back to it if the skyline decides little.

    Parameters
    ----------
    answers : Answers
    heading_prior : HeadingPrior or None

    Returns
    -------
    answers : Answers
        The best one first.
    probability : (K,) array
        Of each answer; what is missing to 1 is spread over the circle.
    right : float
        Probability that the truth is within `RIGHT_DEG` of the best answer.
    """
    best_probability = p_correct(answers.finding)
    if _landmarks_met(answers):
        best_probability = max(best_probability, LANDMARK_PROBABILITY)
    probability = answer_probabilities(answers.finding, best_probability)
    if heading_prior is None:
        return answers, probability, float(probability[0])
    probability = weigh(probability, answers.trials[:, 0], heading_prior)
    left = max(1 - probability.sum(), 0.0) * heading_prior.core_share
    heading = np.append(answers.trials[:, 0], heading_prior.heading_deg)
    sigma = np.append(answers.finding.sigma_deg, heading_prior.spread_deg)
    probability = np.append(probability, left)
    # The region of the circle is chosen first, and then the answer in it at which the posterior is densest.
    region = heading[probability_near(heading, sigma, probability, REGION_DEG).argmax()]
    density = probability_near(heading, sigma, probability, DENSITY_DEG)
    first = int(np.where(np.abs(difference(heading, region)) <= REGION_DEG, density, -1.0).argmax())
    right = probability_near(heading, sigma, probability, RIGHT_DEG)
    rest = np.argsort(-probability, kind="stable")
    order = np.concatenate([[first], rest[rest != first]])
    answers = answers.with_hint(heading_prior).reordered(order)
    return answers, probability[order], float(min(right[first], 1.0))


def probability_near(heading_deg, sigma_deg, probability, reach_deg):
    """Probability (K,) that the truth is within a distance of each answer, if every answer is a Gaussian.

    Parameters
    ----------
    heading_deg, sigma_deg, probability : (K,) arrays
        Of the answers [degrees].
    reach_deg : float
    """
    turn = difference(heading_deg[:, None], heading_deg[None, :])
    inside = ndtr((turn + reach_deg) / sigma_deg) - ndtr((turn - reach_deg) / sigma_deg)
    return inside @ probability


def _landmarks_met(answers):
    """Whether there are landmarks and the best answer fits all of them."""
    miss = answers.objective.landmark_residual(answers.trials[:1])
    return miss.size > 0 and bool((np.abs(miss) < LANDMARK_LIMIT).all())
