"""Estimate, for each column, the probability that the boundary between sky and terrain lies at each row.

The model is a conditional logit per column: score = weights . features, softmax over the rows. Neighbouring columns
see much the same pixels, so the log-probabilities are tempered before they are joined along the columns by
forward-backward. The matcher should use the whole distribution: a column with two likely rows (snow edge, cloud edge)
then helps whichever heading explains one of them. `best` is for drawing and lies between the rows. A frame around the
picture (a scan's border, letterbox bars) is cut off first and put back around the result.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy.special import expit

from ..base import imaging
from ..base.errors import SkylineNotFoundError
from ..base.messages import Message
from ..base.model import Skyline, SkylineEvidence
from .appearance import measure
from .border import find_crop
from .colour import learn_sky, relearn_sky
from .features import boundary_features, log_probability, means_above_below, normalised
from .network import SOFTNESS, resized, row_probability, sky_log_odds
from .placing import placed_between_rows
from .seam import best_line, row_marginals

WEIGHTS_PATH = Path(__file__).with_name("weights.json")
SMALLEST_PX = 24

BELIEVABLE = 0.1
"""Columns of the best line that are less likely than this to be right are masked."""

TOP_ROWS = 2
"""A line that is no lower than this row is the edge of the frame, not a skyline."""

RIVAL_GAP_PX = 4
"""A rival line lies farther than this above the best line, outside the uncertainty of the best line."""

RIVAL_LEAST = 0.02
"""A rival line holds more than this share of a column's probability."""

RIVAL_SHARE = 0.2
"""A rival line exists if it holds that probability in at least this share of the columns."""

SKY_MAP_PX = 128
"""Long side of the map of sky, which is what the network resolves [pixels]."""

NOWHERE = -100.0
"""Log-score of a row that is ruled out."""


@dataclass(frozen=True)
class SkylineOptions:
    """Options of the extraction.

    Attributes
    ----------
    work_px : int
        Long side of the reduced picture; the weights belong to this scale [pixels].
    colour_passes : int
        Rounds of learning the colours of sky and ground from the picture's edges alone.
    refits : int
        Rounds of learning them again from the result of the whole extraction.
    temper : float
        Exponent of each column's probabilities before they are joined: about one over the number of columns that
        see the same pixels.
    step_cost_per_px : float
        Cost of a step between neighbouring columns, in log-probability per row.
    jump_share : float
        Probability of a jump to any row between neighbouring columns.
    seam_cost_per_px : float
        Cost of a step for the single best line, in units of the untempered score per row.
    weights : dict of str to float, optional
        Weight per feature name; replaces the shipped table.
    use_network : bool
        Learn the first colours of sky and ground from what the sky network takes for them, and let it vote on the row.
    network_softness : float
        See `network.row_probability`: the network sees the whole picture and knows clouds, but it is misled by whole
        regions, so that its vote is soft, and the edges place the boundary.
    """

    work_px: int = 512
    colour_passes: int = 1
    refits: int = 1
    temper: float = 0.3
    step_cost_per_px: float = 0.4
    jump_share: float = 0.01
    seam_cost_per_px: float = 0.5
    weights: dict | None = None
    use_network: bool = True
    network_softness: float = SOFTNESS

    def __post_init__(self):
        if self.work_px < 64 or self.colour_passes < 1:
            raise ValueError(f"work_px must be at least 64 and colour_passes at least 1, not {self}")
        if not (0 < self.temper <= 1 and 0 < self.jump_share < 1 and self.step_cost_per_px > 0):
            raise ValueError(f"temper and jump_share must lie in (0, 1), costs above 0, not {self}")


def skyline_evidence(pixels, options=SkylineOptions(), width_px=None, height_px=None):  # noqa: B008 - frozen
    """Estimate where the skyline lies in a picture.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
        Upright RGB, at full size or reduced.
    options : SkylineOptions
    width_px, height_px : int, optional
        Size of the full picture, if `pixels` is a reduced copy [pixels].

    Returns
    -------
    SkylineEvidence
        Row y of `probability` stands for "the first terrain pixel is y": the boundary is the upper edge of that
        pixel, at y - 0.5 when pixel centres are whole numbers.

    Raises
    ------
    SkylineNotFoundError
        The picture is too small or has a single colour.
    """
    height, width = pixels.shape[:2]
    reduced = _reduce(pixels, options.work_px)
    crop = top, bottom, left, right = find_crop(reduced)
    inner = reduced[top : reduced.shape[0] - bottom, left : reduced.shape[1] - right]
    if min(inner.shape[:2]) < SMALLEST_PX:
        raise SkylineNotFoundError(_too_small(width, height))
    if float(inner.max() - inner.min()) < 3:
        raise SkylineNotFoundError(Message("The picture has a single colour."))
    appearance = measure(inner)
    log_odds = resized(sky_log_odds(inner), *inner.shape[:2]) if options.use_network else None
    ratio = _first_colours(log_odds, appearance, options)
    edges, score, probability = _believe(appearance, ratio, log_odds, options)
    for _ in range(options.refits):
        ratio = relearn_sky(appearance, probability, ratio)
        edges, score, probability = _believe(appearance, ratio, log_odds, options)
    line = best_line(score, options.seam_cost_per_px)
    evidence = SkylineEvidence(
        **_laid_out(appearance, probability, line, crop, reduced.shape),
        width_px=width_px or width,
        height_px=height_px or height,
        crop=crop,
        sky_score=_framed(ratio, crop, reduced.shape, 0),
        ridge_score=_framed(_ridges(appearance, probability), crop, reduced.shape, 0),
        thumbnail=imaging.thumbnail(reduced, crop),
        sky_map=None if log_odds is None else _sky_map(log_odds, crop, reduced.shape),
    )
    rival = _rival(edges, probability, line, options)  # the network takes a pale range for sky
    if rival is None:
        return evidence
    laid_out = _laid_out(appearance, *rival, crop, reduced.shape)
    return replace(evidence, rival=replace(evidence, sky_map=None, **laid_out))


def _first_colours(log_odds, appearance, options):
    """Log-likelihood ratio of sky against ground before the extraction has any result of its own, (H, W).

    The colours are learned from what the network takes for sky and for ground. Without it they are learned along the
    edges of the picture, which mistake cloud for ground.
    """
    if log_odds is None:
        return learn_sky(appearance, options.colour_passes)
    probability = row_probability(log_odds, options.network_softness)
    return relearn_sky(appearance, probability, np.zeros_like(probability))


def _laid_out(appearance, probability, line, crop, shape):
    """Fields of `SkylineEvidence` that describe one line, in the frame of the whole reduced picture."""
    inside, leaves_frame = _cut_ridges_apart(probability)
    placed = placed_between_rows(line, appearance)
    # At the edge of the frame there is no sky above the line, and so no whole ramp.
    placed = np.where(line > TOP_ROWS, placed, line)
    return {
        "probability": _framed(inside, crop, shape),
        "best": _skyline(line, placed, probability, crop, shape),
        "leaves_frame": np.pad(leaves_frame, crop[2:]),
    }


def _rival(score, probability, line, options):
    """Probability and line from the rows above the best line alone; None if they hold little probability."""
    rows = np.arange(len(score))[:, None]
    above = (rows < line - RIVAL_GAP_PX) & (rows > 0)
    held = np.where(above, np.exp(score), 0).sum(0) > RIVAL_LEAST
    if held.mean() < RIVAL_SHARE:
        return None
    score = np.where(above, score, NOWHERE)
    marginal = row_marginals(score * options.temper, options.step_cost_per_px, options.jump_share)
    rival = best_line(score, options.seam_cost_per_px)
    return np.where(held, marginal, probability), np.where(held, rival, line)


def _believe(appearance, ratio, log_odds, options):
    """Score of each row from its column alone, without and with the network, and probability from all columns."""
    edges = score = log_probability(boundary_features(appearance, ratio), options.weights or shipped_weights())
    if log_odds is not None:
        score = normalised(edges + np.log(row_probability(log_odds, options.network_softness)))
    return edges, score, row_marginals(score * options.temper, options.step_cost_per_px, options.jump_share)


@lru_cache(maxsize=1)
def shipped_weights():
    """Read the table written by `tools/fit_skyline.py`: weight per feature name."""
    return json.loads(WEIGHTS_PATH.read_text(encoding="utf-8"))["weights"]


def _too_small(width, height):
    return Message("The picture is only {width} x {height} pixels.", width=width, height=height)


def _reduce(pixels, work_px):
    height, width = pixels.shape[:2]
    factor = min(1.0, work_px / max(height, width, 1))
    if min(height, width) * factor < SMALLEST_PX:
        raise SkylineNotFoundError(_too_small(width, height))
    return imaging.shrink_to(pixels[..., :3], work_px)


def _cut_ridges_apart(probability):
    """Probability of the rows inside the frame, and the probability per column that the ridge leaves it (row 0)."""
    inside = probability.copy()
    inside[0] = 0
    return inside, probability[0].astype(np.float32)


def _skyline(line, placed, probability, crop, shape):
    """Line as placed between the rows, with the probability per column that it is right to half a per cent or so."""
    top, _, left, _ = crop
    inner_height, inner_width = probability.shape
    reach = max(2, round(0.005 * inner_height))
    total = np.vstack([np.zeros(inner_width), imaging.accumulate_down(np.add, probability)])
    columns = np.arange(inner_width)
    low, high = np.maximum(line - reach, 0), np.minimum(line + reach + 1, inner_height)
    inside = total[high, columns] - total[low, columns]
    believed = (inside >= BELIEVABLE) & (line > TOP_ROWS) & (probability[0] < 0.5)
    row_px = np.interp(np.arange(shape[1]), columns + left, placed + float(top))
    confidence = np.zeros(shape[1])
    confidence[left : left + inner_width] = np.where(believed, np.clip(inside, 0, 1), 0)
    return Skyline(row_px, confidence, shape[1], shape[0])


def _ridges(appearance, probability):
    """Long edges that stand out from their surroundings, weighted by the probability of lying below the skyline."""
    strength = np.expm1(appearance.long_edges[6])
    above, below = means_above_below(strength, 24)
    standing_out = np.log((strength + 0.2) / ((above + below) / 2 + 0.2))
    return np.maximum(standing_out, 0) * np.clip(imaging.accumulate_down(np.add, probability), 0, 1)


def _sky_map(log_odds, crop, shape):
    """Probability of sky, as coarse as the network gives it, with NaN where the picture was cut off."""
    top, bottom, left, right = crop
    whole = np.full(shape[:2], np.nan, np.float32)
    whole[top : shape[0] - bottom, left : shape[1] - right] = expit(log_odds)
    return imaging.shrink_to(whole, SKY_MAP_PX)


def _framed(inner, crop, shape, rows_outside=None):
    """Put a map back into the frame that was cut off, with flat probability beside it and 0 above and below it."""
    top, bottom, left, right = crop
    height, width = shape[:2]
    whole = np.full((height, width), 1 / height if rows_outside is None else rows_outside, np.float32)
    whole[:, left : width - right] = 0
    whole[top : height - bottom, left : width - right] = inner
    return whole
