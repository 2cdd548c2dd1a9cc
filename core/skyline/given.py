"""Build skyline evidence from what a person or another program supplies: a sky mask or a drawn line."""

from __future__ import annotations

import numpy as np

from ..base.errors import SkylineNotFoundError
from ..base.messages import Message
from ..base.model import Skyline, SkylineEvidence
from .evidence import SkylineOptions

MASK_SIGMA_PX = 1.0
"""Standard deviation of a mask's edge [pixels of the reduced picture]."""

HAND_SHARE = 300
"""A line drawn by hand is precise to the long side of the picture divided by this."""

TRACE_SIGMA_PX = 1.0
"""Best precision of a line traced by a program [pixels of the full picture]."""

OUTLIER_SHARE = 0.02
"""Share of a given column's probability spread over all rows."""


def evidence_from_mask(mask, width_px=None, height_px=None):
    """Turn a sky mask into evidence.

    Parameters
    ----------
    mask : (H, W) or (H, W, C) array
        Sky is bright (above half of the range) or True. Any resolution of the upright picture.
    width_px, height_px : int, optional
        Size of the full picture, if the mask is smaller [pixels].

    Returns
    -------
    SkylineEvidence
        The boundary of a column is its first change from sky to not-sky from the top down; columns without one are
        flat.

    Raises
    ------
    SkylineNotFoundError
        No column has such a change.
    """
    sky = np.asarray(mask)
    sky = sky[..., :3].max(2) if sky.ndim == 3 else sky
    sky = sky if sky.dtype == bool else sky > (np.iinfo(sky.dtype).max if sky.dtype.kind in "ui" else 1.0) / 2
    height, width = sky.shape
    # The additional row keeps a one-row mask valid; it never holds a change.
    change = np.vstack([sky[:-1] & ~sky[1:], np.zeros((1, width), bool)])
    row_px = np.where(change.any(0), change.argmax(0) + 1.0, np.nan)
    return _evidence_from_rows(row_px, height, width_px or width, height_px or height, MASK_SIGMA_PX)


def evidence_from_line(x_px, row_px, width_px, height_px, sigma_px=None):
    """Turn a drawn skyline into evidence.

    Parameters
    ----------
    x_px, row_px : (N,) arrays
        Vertices on the full upright picture, in any order, joined by straight lines in order of x [pixels].
    width_px, height_px : int
        Size of the full picture [pixels].
    sigma_px : float, optional
        Precision of the drawing [pixels of the full picture]. By default it is a 300th of the long side, as for a line
        drawn by hand, but never coarser than the spacing of the vertices, since a line with a row for every column is
        meant to be exact.

    Returns
    -------
    SkylineEvidence
        Columns beyond the line's ends are flat.

    Raises
    ------
    SkylineNotFoundError
        Fewer than two vertices, or none of the line lies on the picture.
    """
    x_px, row_px = np.asarray(x_px, float), np.asarray(row_px, float)
    known = np.isfinite(x_px) & np.isfinite(row_px)
    if known.sum() < 2:
        raise SkylineNotFoundError(Message("The drawn skyline has fewer than two points."))
    order = np.argsort(x_px[known], kind="stable")
    columns = np.arange(width_px)
    line = np.interp(columns, x_px[known][order], row_px[known][order], left=np.nan, right=np.nan)
    with np.errstate(invalid="ignore"):
        line = np.where((line >= 0) & (line <= height_px - 1), line, np.nan)
    scale = _reduction(width_px, height_px)
    if sigma_px is None:
        sigma_px = _drawing_sigma_px(x_px[known][order], max(width_px, height_px))
    sigma = sigma_px * scale
    return _evidence_from_rows(line, height_px, width_px, height_px, max(sigma, 0.5))


def _drawing_sigma_px(x_px, long_side_px):
    """Precision of a line from the spacing of its vertices, which are in order of x [pixels]."""
    spacing = float(np.median(np.diff(x_px)))
    return min(max(spacing, TRACE_SIGMA_PX), long_side_px / HAND_SHARE)


def _reduction(width_px, height_px):
    """Scale factor to the size of extracted evidence."""
    return min(1.0, SkylineOptions.work_px / max(width_px, height_px))


def _evidence_from_rows(row_px, rows_height, width_px, height_px, sigma):
    """Evidence on the reduced picture from one row (NaN: none) per column of a line or mask of any width."""
    if not np.isfinite(row_px).any():
        raise SkylineNotFoundError(Message("The supplied skyline or sky mask has no change from sky to terrain."))
    scale = _reduction(width_px, height_px)
    width, height = max(1, round(width_px * scale)), max(2, round(height_px * scale))
    centre = (np.arange(width) + 0.5) * (len(row_px) / width) - 0.5
    known = np.isfinite(row_px)
    # The rows of first terrain pixels are edges, which scale without the half-pixel offset of pixel centres.
    line = np.interp(centre, np.flatnonzero(known), row_px[known]) * (height / rows_height)
    known = known[np.clip(np.rint(centre).astype(int), 0, len(row_px) - 1)]
    distance = (np.arange(height)[:, None] - line) / sigma
    bell = np.exp(-0.5 * np.minimum(distance**2, 80))
    probability = (1 - OUTLIER_SHARE) * bell / bell.sum(0) + OUTLIER_SHARE / height
    probability = np.where(known, probability, 1 / height).astype(np.float32)
    best = Skyline(line, known.astype(float), width, height)
    return SkylineEvidence(probability, best, width_px, height_px)
