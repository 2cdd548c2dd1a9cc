"""Approximate headings that the photographs of a walk predict for one another, where to look again."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..base.angles import difference
from .circle import shortest_arc

LEAST_PROBABILITY = 0.3
"""Probability of a predicted heading that is worth another look."""
ELSEWHERE_DEG = 3.0
"""A predicted heading farther than this from the photograph's answer is another one."""
MASS = 0.9
Z_90 = 1.645


@dataclass(frozen=True, eq=False)
class NeighbourHint:
    """An approximate heading from other photographs.

    Attributes
    ----------
    heading_deg, sigma_deg : float
        True heading and its standard deviation [degrees].
    """

    heading_deg: float
    sigma_deg: float

    def applied(self, request):
        """Give a `PhotoRequest` that heading; a tolerance counts as two standard deviations."""
        return replace(request, heading_deg=self.heading_deg, heading_tolerance_deg=2 * self.sigma_deg)

    def found_in(self, photo):
        """Best candidate of an `OrientedPhoto` near the hint; None if there is only the hint itself."""
        near = [
            candidate
            for candidate in photo.orientation.candidates
            if 1e-6 < abs(difference(candidate.pose.heading_deg, self.heading_deg)) <= max(3 * self.sigma_deg, 1.5)
        ]
        return max(near, key=lambda candidate: candidate.score) if near else None


def predictions(photos, beliefs):
    """Find where a photograph must be looked at again: where others predict another heading than its own.

    Parameters
    ----------
    photos : list of OrientedPhoto
    beliefs : list of Belief or None

    Returns
    -------
    dict of int to NeighbourHint
        By the photograph's number.
    """
    hints = {}
    for number, (photo, belief) in enumerate(zip(photos, beliefs)):
        if belief is None or belief.probability < LEAST_PROBABILITY or not (belief.tied or belief.by_compass):
            continue
        own = photo.heading_deg
        if own is None or abs(difference(own, belief.heading_deg)) > ELSEWHERE_DEG:
            low, high = shortest_arc(belief.density, belief.heading_deg, MASS * belief.probability)
            sigma = max(((high - low) % 360) / 2 / Z_90, 0.3)
            hints[number] = NeighbourHint(belief.heading_deg, min(sigma, 10.0))
    return hints
