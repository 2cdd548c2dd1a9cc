"""Refuse pictures in which no line can be a mountain skyline: documents, rooms, pictures of the night."""

from __future__ import annotations

import numpy as np

from ..base.errors import SkylineNotFoundError
from ..base.messages import Message

LEAST_LIKELY_SHARE = 0.15
"""Share of the columns in which the line must be more likely right than wrong; less of a skyline decides no heading.
For 250 mountain photographs, clouded ones included, it is 0.43 or more, and 0.33 or more for 280 narrower views cut
from them; for a page of text and for the night it is 0.02 or less."""

LEVEL_RUN_SHARE, LEVEL_SHARE = 0.05, 0.8
"""A piece of the line that keeps its row over this share of the width is level; this share of the line in level pieces
makes steps, as walls and furniture do. Of the same pictures none has more than 0.59 of its line in such pieces, nor two
jumps between them; a room has 0.96."""

JUMP_SHARE, LEAST_JUMPS = 0.05, 2
"""A vertical jump of this share of the height, and how many of them steps need; the sea's horizon has none."""


def check_skyline(evidence, needed=True):
    """Raise `SkylineNotFoundError` if the extracted line cannot be a mountain skyline.

    Parameters
    ----------
    evidence : SkylineEvidence
    needed : bool
        False if landmarks decide the answer without a skyline; then nothing is refused.
    """
    line = evidence.best
    if not needed:
        return
    if float(np.mean(line.confidence > 0.5)) < LEAST_LIKELY_SHARE:
        raise SkylineNotFoundError(Message("The picture shows no skyline: no line separates sky from terrain."))
    if _has_steps(line.row_px, evidence.probability.shape[0]):
        raise SkylineNotFoundError(
            Message(
                "The picture shows no mountain skyline: its lines are level and upright, as in a room or on a page."
            )
        )


def _has_steps(row_px, height):
    """Tell whether nearly all of a line is level, with upright jumps between its pieces."""
    row_px, width = np.round(row_px), len(row_px)
    starts = np.concatenate([[0], np.flatnonzero(np.abs(np.diff(row_px)) > 0.5) + 1])
    runs = np.diff(np.append(starts, width))
    level = runs >= LEVEL_RUN_SHARE * width
    jumps = np.count_nonzero(np.abs(np.diff(row_px[starts[level]])) >= JUMP_SHARE * height)
    return bool(runs[level].sum() >= LEVEL_SHARE * width and jumps >= LEAST_JUMPS)
