"""A map of the scores of the places of an area, as an array."""

from __future__ import annotations

import numpy as np

from ..base.curvature import METRES_PER_DEGREE
from .raster import TypeStyle, draw_dot, draw_words

LOW, MIDDLE, HIGH = np.array([[38, 44, 58], [64, 120, 140], [250, 214, 110]], float)
"""Colours of the lowest scores, of those at `MIDDLE_AT` of the range, and of the best."""

MIDDLE_AT = 0.85

NOTHING = (232, 232, 228)
RED, WHITE = (214, 40, 57), (255, 255, 255)

LONG_SIDE_PX = 900


# parameters: the places, their scores, and what is marked
def score_map(longitude_deg, latitude_deg, score, spacing_m, places=()):
    """Draw the scores of all places, with numbered marks.

    Parameters
    ----------
    longitude_deg, latitude_deg, score : (P,) arrays
        Of the places; a score of -inf is not drawn.
    spacing_m : float
        Distance between neighbouring places [m].
    places : sequence of (longitude_deg, latitude_deg)
        Marked and numbered from 1.

    Returns
    -------
    uint8 (h, w, 3) array
    """
    scale = np.cos(np.radians(np.mean(latitude_deg)))
    step = spacing_m / METRES_PER_DEGREE
    west, north = float(np.min(longitude_deg)), float(np.max(latitude_deg))
    col = np.rint((np.asarray(longitude_deg) - west) * scale / step).astype(int)
    row = np.rint((north - np.asarray(latitude_deg)) / step).astype(int)
    known = np.isfinite(score)
    cells = np.full((row.max() + 1, col.max() + 1), np.nan)
    cells[row[known], col[known]] = np.asarray(score)[known]
    pixels = _coloured(cells)
    size = max(LONG_SIDE_PX // max(cells.shape), 1)
    pixels = np.ascontiguousarray(pixels.repeat(size, axis=0).repeat(size, axis=1))
    for number, (longitude, latitude) in reversed(list(enumerate(places, start=1))):
        x = ((longitude - west) * scale / step + 0.5) * size
        y = ((north - latitude) / step + 0.5) * size
        draw_dot(pixels, x, y, 9.0, RED if number == 1 else WHITE)
        draw_words(pixels, x + 12, y, str(number), WHITE, TypeStyle(size_px=18, anchor="lm"))
    return pixels


def _coloured(cells):
    """RGB of scores; the best ones stand out."""
    known = np.isfinite(cells)
    pixels = np.empty((*cells.shape, 3), np.uint8)
    pixels[:] = NOTHING
    if not known.any():
        return pixels
    low, high = np.percentile(cells[known], 1), cells[known].max()
    share = np.clip((cells[known] - low) / max(high - low, 1e-9), 0, 1)
    colour = np.stack([np.interp(share, [0, MIDDLE_AT, 1], [LOW[c], MIDDLE[c], HIGH[c]]) for c in range(3)], axis=1)
    pixels[known] = np.rint(colour)
    return pixels
