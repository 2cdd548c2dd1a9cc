"""Turn the best answer to the heading at which skyline and ground together agree best.

The fit places an answer by its skyline alone. Near, rounded ridges that a coarse DEM misses, or a lens that is not a
pinhole, then shift it by some tenths of a degree, while crests and slopes all over the picture still indicate the right
heading. Their evidence has no useful derivatives, so nearby headings are tried instead, each with pitch, roll and focal
length fitted again.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .refine import refine

HEADING = (0,)
"""Parameters that are held fixed while the others are fitted, as indices in `geometry.PARAMETERS`."""

STRIDE = 2
"""Step between the columns that are used to compare headings."""


@dataclass(frozen=True)
class TurnOptions:
    """Range and spacing of the headings that are tried.

    Attributes
    ----------
    reach_deg, step_deg : float
        Headings within `reach_deg` of the fitted heading are tried, `step_deg` apart; a reach of 0 switches the turn
        off [degrees].
    share : float
        Share of the inner evidence's weight that counts here. That evidence is better at choosing between answers than
        at placing one, since its picture is 64 pixels wide. Of 0.25, 0.5 and 1 this was the best on 147 views cut from
        photographs and did no harm on 120 simulated ones.
    """

    reach_deg: float = 1.5
    step_deg: float = 0.15
    share: float = 0.5

    def __post_init__(self):
        if not (self.reach_deg >= 0 and self.step_deg > 0 and 0 <= self.share <= 1):
            raise ValueError(f"the turn's reach, step and share make no sense: {self}")


def turn(objective, second, trial, scale, options=TurnOptions()):  # noqa: B008 - frozen
    """Turn one answer to the heading at which all evidence agrees best.

    Parameters
    ----------
    objective : Objective
    second : InnerEvidence
    trial : (5,) array
        See `geometry.PARAMETERS`.
    scale : float
        Multiple of the expected tolerance at which the trial fits best.
    options : TurnOptions

    Returns
    -------
    (5,) array
        The given trial if no other agrees better.
    """
    count = round(options.reach_deg / options.step_deg)
    trials = np.repeat(trial[None], 2 * count + 1, axis=0)
    trials[:, 0] += options.step_deg * np.arange(-count, count + 1)
    trials, skyline = refine(objective, trials, scale, STRIDE, held=HEADING)
    total = skyline + options.share * second.score(trials)
    best = trials[total.argmax()].copy()
    best[0] += options.step_deg * _peak(total)
    best, _ = refine(objective, best[None], scale, held=HEADING)
    both = np.stack([trial, best[0]])
    skyline, inside = objective.score(both, scale), second.score(both)
    chosen = int(np.argmax(skyline + options.share * inside))
    return both[chosen]


def _peak(total):
    """Top of the parabola through the highest value and its neighbours, in steps from it (at most half a step)."""
    top = int(total.argmax())
    if not 0 < top < len(total) - 1:
        return 0.0
    before, highest, after = total[top - 1 : top + 2]
    bend = before - 2 * highest + after
    return 0.0 if bend >= 0 else float(np.clip(0.5 * (before - after) / bend, -0.5, 0.5))
