"""Change an extracted skyline by hand: leave parts of the picture out, and replace stretches of the line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.overlay_lines import skyline_line

LEAST_SHARE = 0.2
"""A column whose line is brushed over takes its next likely row if that holds this share of its probability."""

REACH_ROWS = 3
"""Rows on either side that count as one place when the probability of a row is summed."""


@dataclass(frozen=True)
class BrushStroke:
    """A stroke of the brush over a picture.

    Attributes
    ----------
    points : tuple of (x_px, y_px)
        Its path [pixels of the full upright picture].
    radius_px : float
        Half the brush's width [pixels of the full upright picture].
    """

    points: tuple
    radius_px: float


def brushed(strokes, size_px, shape):
    """Rasterise strokes.

    Parameters
    ----------
    strokes : sequence of BrushStroke
    size_px : (width, height)
        Of the full upright picture [pixels].
    shape : (rows, columns)
        Of the result, which may be smaller.

    Returns
    -------
    (rows, columns) bool array
    """
    rows, columns = shape
    x = (np.arange(columns) + 0.5) * (size_px[0] / columns) - 0.5
    y = (np.arange(rows) + 0.5) * (size_px[1] / rows) - 0.5
    found = np.zeros(shape, bool)
    for stroke in strokes:
        points = np.asarray(stroke.points, float).reshape(-1, 2)
        for start, stop in zip(points, points[1:] if len(points) > 1 else points):
            low, high = np.minimum(start, stop) - stroke.radius_px, np.maximum(start, stop) + stroke.radius_px
            c = slice(np.searchsorted(x, low[0]), np.searchsorted(x, high[0], "right"))
            r = slice(np.searchsorted(y, low[1]), np.searchsorted(y, high[1], "right"))
            found[r, c] |= _distance(x[None, c], y[r, None], start, stop) <= stroke.radius_px
    return found


def _distance(x, y, start, stop):
    """Distance of a grid of places from a segment."""
    along = stop - start
    length = float(along @ along)
    t = ((x - start[0]) * along[0] + (y - start[1]) * along[1]) / length if length else np.zeros(())
    t = np.clip(t, 0.0, 1.0)
    return np.hypot(x - start[0] - t * along[0], y - start[1] - t * along[1])


def line_without(evidence, left_out):
    """Find the skyline outside the parts of a picture that are left out.

    Parameters
    ----------
    evidence : SkylineEvidence
    left_out : (h, w) bool array
        Of the size of `evidence.probability`.

    Returns
    -------
    (w,) array
        Row of the first terrain pixel on the evidence's picture; NaN where no plausible row remains.
    """
    best, height = evidence.best, evidence.probability.shape[0]
    row = np.where(best.valid, np.asarray(best.row_px, float), np.nan)
    for column in np.flatnonzero(left_out.any(axis=0)):
        at = row[column]
        if np.isfinite(at) and not left_out[int(np.clip(round(at), 0, height - 1)), column]:
            continue
        likely = np.where(left_out[:, column], 0.0, evidence.probability[:, column])
        near = np.convolve(likely, np.ones(2 * REACH_ROWS + 1), mode="same")
        middle = int(near.argmax())
        around = slice(max(middle - REACH_ROWS, 0), middle + REACH_ROWS + 1)
        row[column] = around.start + float(likely[around].argmax()) if near[middle] >= LEAST_SHARE else np.nan
    return row


def joined(strokes):
    """Join strokes to one line; each replaces what earlier ones drew between its left and right end.

    Parameters
    ----------
    strokes : sequence of sequences of (x_px, y_px)
        In the order in which they were drawn.

    Returns
    -------
    tuple of (x_px, y_px)
        From left to right.
    """
    x, y = np.zeros(0), np.zeros(0)
    for stroke in strokes:
        points = np.asarray(stroke, float).reshape(-1, 2)
        keep = (x < points[:, 0].min()) | (x > points[:, 0].max())
        x, y = np.concatenate([x[keep], points[:, 0]]), np.concatenate([y[keep], points[:, 1]])
    order = np.argsort(x, kind="stable")
    return tuple(zip(x[order].tolist(), y[order].tolist()))


def full_size_line(evidence, row_px):
    """Give x and y of a row per column of the evidence [pixels of the full upright picture]; see `skyline_line`."""
    height, width = evidence.probability.shape
    moved = type(evidence.best)(np.asarray(row_px, float), np.ones(width), width, height)
    line = skyline_line(moved, evidence.width_px, evidence.height_px)
    return line.x_px, line.y_px


def sky_mask(row_px, rows):
    """Draw a sky mask as `given.evidence_from_mask` reads it, white above a line.

    Parameters
    ----------
    row_px : (w,) array
        Row of the first terrain pixel; a column of NaN becomes black, which gives no boundary.
    rows : int
        Height of the mask [pixels].

    Returns
    -------
    (rows, w) uint8 array
    """
    with np.errstate(invalid="ignore"):
        sky = np.arange(rows)[:, None] < np.round(row_px)[None, :]
    return np.where(sky, 255, 0).astype(np.uint8)


def edited_rows(evidence, strokes, brush):
    """Give the skyline with everything that a person did to it.

    Parameters
    ----------
    evidence : SkylineEvidence
        As extracted.
    strokes : sequence of sequences of (x_px, y_px)
        Drawn over the line, in order [pixels of the full upright picture].
    brush : sequence of BrushStroke
        Parts of the picture to leave out.

    Returns
    -------
    (w,) array
        Row of the first terrain pixel on the evidence's picture; NaN where none is known.
    """
    height, width = evidence.probability.shape
    size = evidence.width_px, evidence.height_px
    row = line_without(evidence, brushed(brush, size, (height, width)))
    x = (np.arange(width) + 0.5) * (size[0] / width) - 0.5
    for stroke in strokes:
        points = np.asarray(stroke, float).reshape(-1, 2)
        points = points[np.argsort(points[:, 0], kind="stable")]
        inside = (x >= points[0, 0]) & (x <= points[-1, 0])
        row[inside] = (np.interp(x[inside], points[:, 0], points[:, 1]) + 0.5) * (height / size[1])
    return row
