"""Running sums along the columns: what lies above each boundary, and what below."""

from __future__ import annotations

import numpy as np


def means_above_below(values, window_px):
    """Means of the `window_px` rows above each boundary and of those below it, edge rows repeated outside.

    Parameters
    ----------
    values : (H, W) or (H, W, C) array
    window_px : int

    Returns
    -------
    above, below : float32 arrays of the shape of `values`
        Row y of `above` covers rows y - window to y - 1, of `below` y to y + window - 1.
    """
    height = values.shape[0]
    window = int(window_px)
    total = np.zeros((height + 2 * window + 1,) + values.shape[1:])
    steps = np.arange(1, window + 1).reshape((-1,) + (1,) * (values.ndim - 1))
    # Cumulative sums of the column extended by its end rows; the ends are arithmetic, not stored.
    total[1 : window + 1] = steps * values[0]
    np.cumsum(values, 0, out=total[window + 1 : window + 1 + height], dtype=np.float64)
    total[window + 1 : window + 1 + height] += window * values[0]
    total[window + 1 + height :] = total[window + height] + steps * values[-1]
    at = total[window : window + height]
    above = (at - total[:height]) / window
    below = (total[2 * window : 2 * window + height] - at) / window
    return above.astype(np.float32), below.astype(np.float32)


def sum_above(values):
    """Sum of all rows above each row, (H, W)."""
    total = np.zeros_like(values)
    np.cumsum(values[:-1], 0, out=total[1:])
    return total


def strongest_above(values, gap_px=4):
    """Largest value at least `gap_px` rows above each row, 0 near the top, (H, W)."""
    strongest = np.zeros_like(values)
    if values.shape[0] > gap_px:
        np.maximum.accumulate(values[:-gap_px], 0, out=strongest[gap_px:])
    return strongest


def strongest_below(values, gap_px=4):
    """Largest value at least `gap_px` rows below each row, 0 near the bottom, (H, W)."""
    return strongest_above(values[::-1], gap_px)[::-1]
