"""Limit the certainty of an answer by what is known of the position and the heights beside the picture."""

from __future__ import annotations

from dataclasses import replace
from math import erf, sqrt

from .angles import wrap_360
from .messages import Message
from .model import Orientation
from .uncertainty import Z_90

RIGHT_DEG, ACCEPTED_PROBABILITY = 3.0, 0.85
"""An accepted heading is within this distance of the truth with at least this probability, as `status` promises."""

DOUBTED_PROBABILITY = 0.5
"""Largest p_correct of an answer that rests on contradictory input: the picture alone cannot outweigh it."""

PRECISE_POSITION_M = 50.0
"""Position errors below this are usual for phones in the mountains."""


def position_doubt(orientation: Orientation, position_error_m: float) -> Message | None:
    """Say that the position is too imprecise for an accepted answer, or None.

    Parameters
    ----------
    orientation : Orientation
    position_error_m : float
        Standard deviation of the position [m].
    """
    lo, hi = orientation.heading_lo_deg, orientation.heading_hi_deg
    if position_error_m <= PRECISE_POSITION_M or lo is None or hi is None:
        return None
    sigma_deg = max(float(wrap_360(hi - lo)) / 2 / Z_90, 1e-6)
    if erf(RIGHT_DEG / sigma_deg / sqrt(2)) >= ACCEPTED_PROBABILITY:
        return None
    return Message(
        "The position is uncertain by {metres} m, which leaves the heading uncertain by more than 3 degrees. Correct "
        "the position.",
        metres=f"{position_error_m:.0f}",
    )


def doubted(orientation: Orientation, doubt: Message | None, keep_interval: bool = False) -> Orientation:
    """Turn an accepted answer into an ambiguous one if there is a doubt, and limit the certainty of an ambiguous one.

    Parameters
    ----------
    orientation : Orientation
    doubt : Message or None
        Why the answer cannot be accepted.
    keep_interval : bool
        Whether the interval already contains the doubt.

    Returns
    -------
    Orientation
        With the doubt as its message, and without an interval unless that is kept.
    """
    probability = min(orientation.p_correct or 0.0, DOUBTED_PROBABILITY)
    certain = orientation.status == "ambiguous" and probability < (orientation.p_correct or 0.0)
    if doubt is None or not (orientation.status == "accepted" or certain):
        return orientation
    changed = replace(orientation, status="ambiguous", message=doubt, p_correct=probability)
    return changed if keep_interval else replace(changed, heading_lo_deg=None, heading_hi_deg=None)
