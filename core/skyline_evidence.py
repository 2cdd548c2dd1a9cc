"""Skyline evidence: for each column, how likely the boundary between sky and terrain lies at each row.

A conditional logit per column: score = weights . features, softmax over the rows. Neighbouring columns see much the
same pixels, so the log-probabilities are tempered before they are joined along the columns by forward-backward.
The matcher should use the whole distribution: a column with two likely rows (snow edge, cloud edge) then helps
whichever heading explains one of them. `best` is for drawing.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from . import imaging
from .errors import SkylineNotFoundError
from .model import Skyline, SkylineEvidence
from .skyline_appearance import measure
from .skyline_colour import learn_sky
from .skyline_crop import find_crop
from .skyline_features import boundary_features
from .skyline_seam import best_line, row_marginals

WEIGHTS_PATH = Path(__file__).with_name("skyline_weights.json")
SMALLEST_PX = 24


@dataclass(frozen=True)
class EvidenceOptions:
    """Parameters of the extraction.

    Attributes
    ----------
    work_px : int
        Long side of the reduced picture; the weights belong to this scale [pixels].
    colour_passes : int
        Rounds of learning the colours of sky and ground from the picture.
    temper : float
        Exponent of each column's probabilities before they are joined: about one over the number of columns that
        see the same pixels.
    step_cost_per_px : float
        Cost of a step between neighbouring columns, in log-probability per row.
    jump_share : float
        Probability of a jump to any row between neighbouring columns.
    seam_cost_per_px : float
        The same for the single best line, in units of the untempered score per row.
    """

    work_px: int = 512
    colour_passes: int = 3
    temper: float = 0.3
    step_cost_per_px: float = 0.4
    jump_share: float = 0.01
    seam_cost_per_px: float = 0.5

    def __post_init__(self):
        if self.work_px < 64 or self.colour_passes < 1:
            raise ValueError(f"work_px must be at least 64 and colour_passes at least 1, not {self}")
        if not (0 < self.temper <= 1 and 0 < self.jump_share < 1 and self.step_cost_per_px > 0):
            raise ValueError(f"temper and jump_share must lie in (0, 1), costs above 0, not {self}")


def skyline_evidence(pixels, options=EvidenceOptions(), width_px=None, height_px=None):  # noqa: B008 - frozen
    """Estimate where the skyline lies in a picture.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
        Upright RGB, at full size or reduced.
    options : EvidenceOptions
    width_px, height_px : int, optional
        Size of the full picture where `pixels` is a reduced copy [pixels].

    Returns
    -------
    SkylineEvidence
        Row y of `probability` stands for "the first terrain pixel is y": the boundary is the upper edge of that
        pixel, at y - 0.5 when pixel centres are whole numbers.

    Raises
    ------
    SkylineNotFoundError
        The picture is too small or shows nothing at all.
    """
    height, width = pixels.shape[:2]
    reduced = _reduce(pixels, options.work_px)
    crop = top, bottom, left, right = find_crop(reduced)
    inner = reduced[top : reduced.shape[0] - bottom, left : reduced.shape[1] - right]
    if min(inner.shape[:2]) < SMALLEST_PX:
        raise SkylineNotFoundError(f"The picture is only {width} x {height} pixels.")
    if float(inner.max() - inner.min()) < 3:
        raise SkylineNotFoundError("The picture has a single colour.")
    appearance = measure(inner)
    ratio = learn_sky(appearance, options.colour_passes)
    score = log_probability(boundary_features(appearance, ratio))
    probability = row_marginals(score * options.temper, options.step_cost_per_px, options.jump_share)
    line = best_line(score, options.seam_cost_per_px)
    return _assemble(probability, line, ratio, appearance, crop, (width_px or width, height_px or height))


def log_probability(features):
    """Log of p(row | column) from each column's own features, (H, W), by the shipped weights."""
    score = sum(np.float32(weight) * features[name] for name, weight in _weights().items())
    score = score - score.max(0)
    return score - np.log(np.exp(score).sum(0))


@lru_cache(maxsize=1)
def _weights():
    return json.loads(WEIGHTS_PATH.read_text(encoding="utf-8"))["weights"]


def _reduce(pixels, work_px):
    height, width = pixels.shape[:2]
    factor = min(1.0, work_px / max(height, width, 1))
    if min(height, width) * factor < SMALLEST_PX:
        raise SkylineNotFoundError(f"The picture is only {width} x {height} pixels.")
    return imaging.shrink(pixels[..., :3], max(1, round(width * factor)), max(1, round(height * factor)))


def _assemble(probability, line, ratio, appearance, crop, full_size):
    """Put the inner picture's results back into the frame that was cut off."""
    top, bottom, left, right = crop
    inner_height, inner_width = ratio.shape
    height, width = inner_height + top + bottom, inner_width + left + right
    inside = (slice(top, top + inner_height), slice(left, left + inner_width))
    whole = np.full((height, width), 1 / height, np.float32)
    whole[:, inside[1]] = 0
    whole[inside] = probability
    sky_score, ridge_score = np.zeros((height, width), np.float32), np.zeros((height, width), np.float32)
    sky_score[inside] = ratio
    ridge_score[inside] = appearance.edges[1.6]
    columns = np.arange(inner_width)
    near = sum(probability[np.clip(line + step, 0, inner_height - 1), columns] for step in (-2, -1, 0, 1, 2))
    row_px = np.interp(np.arange(width), columns + left, line + float(top))
    confidence = np.zeros(width)
    confidence[inside[1]] = np.clip(near, 0, 1)
    best = Skyline(row_px, confidence, width, height)
    return SkylineEvidence(whole, best, *full_size, crop, sky_score, ridge_score)
