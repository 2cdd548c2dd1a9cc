"""What a photograph says of its heading by itself: its candidates, and that it may be none of them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .circle import mixture

USUAL_SIGMA_DEG = 1.0
"""Of a candidate whose spread is not known."""
SURE = 0.999
"""Largest probability of a candidate: another place always stays possible."""


@dataclass(frozen=True, eq=False)
class Alone:
    """Candidates of one photograph.

    Attributes
    ----------
    candidates : tuple of Candidate
        Best first.
    probability : (K,) array
        What is missing to 1 is 'none of them'.
    """

    candidates: tuple
    probability: np.ndarray

    @property
    def heading_deg(self):
        """Headings (K,) of the candidates [degrees]."""
        return np.array([candidate.pose.heading_deg for candidate in self.candidates], float)

    @property
    def sigma_deg(self):
        """Standard deviations (K,) of the headings [degrees]."""
        return np.array([candidate.heading_sigma_deg or USUAL_SIGMA_DEG for candidate in self.candidates], float)

    def density(self):
        """Density of the heading on the grid of `circle`."""
        return mixture(self.heading_deg, self.sigma_deg, self.probability)

    def favoured(self, ratio):
        """Weigh the candidates by likelihood ratios (K,) against 'none of them'."""
        weighted = self.probability * ratio
        return replace(self, probability=weighted / (weighted.sum() + 1 - self.probability.sum()))

    def joined(self, candidate, temperature):
        """Add a candidate that was found near the heading that others predict.

        It gets the probability that it would have had from the start: among the candidates after the best one, by its
        score, at most as good as the best.

        Parameters
        ----------
        candidate : Candidate
        temperature : float
            What one unit of score is worth [nats].
        """
        if not self.candidates:
            return Alone((candidate,), np.array([candidate.probability or 0.0]))
        score = np.array([found.score for found in (*self.candidates, candidate)])
        likelihood = np.exp(np.minimum(temperature * (score - score[0]), 0.0))[1:]
        rest = (1 - self.probability[0]) * likelihood / (likelihood.sum() + 1.0)
        return Alone((*self.candidates, candidate), np.concatenate([self.probability[:1], rest]))


def alone_of(photo):
    """Give the `Alone` of an `OrientedPhoto`; None if its method gives no probabilities.

    An answer that something contradicts counts with the certainty that the contradiction leaves.
    """
    orientation = photo.orientation
    if any(candidate.probability is None for candidate in orientation.candidates):
        return None
    probability = np.array([candidate.probability for candidate in orientation.candidates], float)
    if len(probability):
        probability[0] = min(probability[0], 1.0 if orientation.p_correct is None else orientation.p_correct)
        probability = probability * min(1.0, SURE / max(float(probability.sum()), 1e-9))
    return Alone(orientation.candidates, probability)
