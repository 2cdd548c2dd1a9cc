"""Compute features that indicate a boundary between sky and ground above each pixel, fifty-seven per row and column.

Row y stands for "the first terrain pixel of this column is y", so the boundary lies between y - 1 and y; row 0 means
that the ridge leaves the frame at the top. All features are meant for a picture of about 512 pixels on the long side;
at a finer scale, terrain texture competes with the skyline.

`boundary_features` gathers them from the windows, sums and maxima along the columns that are defined below it.
"""

from __future__ import annotations

import numpy as np

from ..base import imaging

RATIO_WINDOWS_PX = (3, 9, 27, 81)
CONTRAST_WINDOWS_PX = (4, 16)
LEVEL_WINDOWS_PX = (8, 32)


def boundary_features(appearance, ratio):
    """Return all features that the weights table refers to, by name.

    Parameters
    ----------
    appearance : Appearance
    ratio : (H, W) array
        Log-likelihood ratio of sky against ground, from `colour.learn_sky`.

    Returns
    -------
    dict of str to (H, W) float32 array
    """
    return {
        **_edge_features(appearance),
        **_long_edge_features(appearance),
        **_colour_features(ratio),
        **_contrast_features(appearance),
        **_level_features(appearance),
        **_column_features(appearance, ratio),
    }


def log_probability(features, weights):
    """Log of p(row | column) from each column's own features, (H, W): weighted sum and softmax over the rows."""
    score = sum(np.float32(weight) * features[name] for name, weight in weights.items())
    return normalised(score)


def normalised(score):
    """Log-probabilities of the rows of each column, from their scores."""
    score = score - score.max(0)
    return score - np.log(np.exp(score).sum(0))


def _edge_features(appearance):
    """Edge strength at four scales, and its difference from the column's local maximum."""
    features = {}
    for sigma, edge in appearance.edges.items():
        features[f"edge_{sigma}"] = edge
        features[f"peak_{sigma}"] = edge - imaging.maximum_down(edge, 2 * (round(2 * sigma) | 1) + 1)
    sharp = np.maximum(appearance.edges[0.8], appearance.edges[1.6])
    features["stronger_above"] = np.maximum(strongest_above(sharp) - sharp, 0)
    features["stronger_below"] = np.maximum(strongest_below(sharp) - sharp, 0)
    return features


def _long_edge_features(appearance):
    """Edge strength along lines, and its contrast with the rows above (sky) and below (terrain)."""
    features = {}
    for half, edge in appearance.long_edges.items():
        features[f"line_{half}"] = edge
        features[f"line_peak_{half}"] = edge - imaging.maximum_down(edge, half + 1 | 1)
        features[f"line_stronger_above_{half}"] = np.maximum(strongest_above(edge) - edge, 0)
        linear = np.expm1(edge)
        above, below = means_above_below(linear, 24)
        features[f"line_over_above_{half}"] = np.log((linear + 0.2) / (above + 0.2))
        features[f"line_over_below_{half}"] = np.log((linear + 0.2) / (below + 0.2))
    return features


def _colour_features(ratio):
    """Sky-like colours above and ground-like colours below, in windows and over the whole column."""
    height = ratio.shape[0]
    features = {}
    for window in RATIO_WINDOWS_PX:
        above, below = means_above_below(ratio, window)
        features[f"sky_over_ground_{window}"] = above - below
    sky = 1 / (1 + np.exp(-ratio))
    ground_above = sum_above(1 - sky)
    features["ground_above"] = np.log1p(ground_above / 5)
    features["ground_above_share"] = ground_above / height
    features["sky_below"] = np.log1p((sky.sum(0) - sum_above(sky)) / 5)
    return features


def _contrast_features(appearance):
    """Steps of brightness, colour and texture across the boundary."""
    lightness, yellow = appearance.lab[..., 0], appearance.lab[..., 2]
    features = {}
    for window in CONTRAST_WINDOWS_PX:
        above, below = means_above_below(lightness, window)
        features[f"darker_below_{window}"] = np.clip((above - below) / 10, -2, 2)
        features[f"brightness_step_{window}"] = np.minimum(np.abs(above - below) / 10, 2)
        above, below = means_above_below(yellow, window)
        features[f"bluer_above_{window}"] = np.clip((below - above) / 8, -2, 2)
        above, below = means_above_below(appearance.texture, window)
        features[f"rougher_below_{window}"] = below - above
    return features


def _level_features(appearance):
    """Levels of texture and colour: sky is smooth, terrain is not, cloud is pale, and steps do not show any of it."""
    lightness, yellow = appearance.lab[..., 0] / 50, appearance.lab[..., 2] / 20
    chroma = np.hypot(appearance.lab[..., 1], appearance.lab[..., 2]) / 20
    levels = np.dstack([appearance.texture, lightness, yellow, chroma])
    features = {}
    for window in LEVEL_WINDOWS_PX:
        above, below = means_above_below(levels, window)
        for index, name in enumerate(("rough", "light", "yellow", "chroma")):
            features[f"{name}_above_{window}"] = above[..., index]
            features[f"{name}_below_{window}"] = below[..., index]
    return features


def _column_features(appearance, ratio):
    """Position in the column, clutter above, and indicators that the ridge leaves the frame (row 0)."""
    height, width = ratio.shape
    row = np.broadcast_to(np.arange(height, dtype=np.float32)[:, None], (height, width))
    features = {
        "row": row / max(height - 1, 1),
        "edges_above": np.log1p(sum_above(np.clip(appearance.edge - 0.7, 0, 1.5))),
        "top_rows": ((row == 1) | (row == 2)).astype(np.float32),
    }
    for name, value in (
        ("", np.ones(width)),
        ("_ground", ratio[:8].mean(0) / 5),
        ("_rough", appearance.texture[:8].mean(0)),
    ):
        features["leaves_frame" + name] = np.zeros((height, width), np.float32)
        features["leaves_frame" + name][0] = value
    return features


def means_above_below(values, window_px):
    """Means of the `window_px` rows above each boundary and of those below it, with the edge rows repeated outside.

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
    # Cumulative sums of the column extended by its end rows; the extensions are computed, not stored.
    total[1 : window + 1] = steps * values[0]
    total[window + 1 : window + 1 + height] = imaging.accumulate_down(np.add, values.astype(float))
    total[window + 1 : window + 1 + height] += window * values[0]
    total[window + 1 + height :] = total[window + height] + steps * values[-1]
    at = total[window : window + height]
    above = (at - total[:height]) / window
    below = (total[2 * window : 2 * window + height] - at) / window
    return above.astype(np.float32), below.astype(np.float32)


def sum_above(values):
    """Sum of all rows above each row, (H, W)."""
    total = np.zeros_like(values)
    total[1:] = imaging.accumulate_down(np.add, values[:-1])
    return total


def strongest_above(values, gap_px=4):
    """Largest value at least `gap_px` rows above each row, 0 near the top, (H, W)."""
    strongest = np.zeros_like(values)
    if values.shape[0] > gap_px:
        strongest[gap_px:] = imaging.accumulate_down(np.maximum, values[:-gap_px])
    return strongest


def strongest_below(values, gap_px=4):
    """Largest value at least `gap_px` rows below each row, 0 near the bottom, (H, W)."""
    return strongest_above(values[::-1], gap_px)[::-1]
