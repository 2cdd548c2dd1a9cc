"""What speaks for a boundary between sky and ground above each pixel: some thirty numbers per row and column.

Row y stands for "the first terrain pixel of this column is y", so the boundary lies between y - 1 and y. All numbers
belong to a picture of about 512 pixels on the long side; at finer scale terrain texture competes with the skyline.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import imaging
from .skyline_colour import sky_log_ratio
from .skyline_seam import best_line

EDGE_SIGMAS_PX = (0.8, 1.6, 3.2, 6.4)
RATIO_WINDOWS_PX = (3, 9, 27, 81)
CONTRAST_WINDOWS_PX = (4, 16)
RATIO_LIMIT = 5.0
"""Log-likelihood ratios are clipped here, lest a lake or a snowfield decide a whole column."""


@dataclass(frozen=True, eq=False)
class Appearance:
    """Per-pixel measurements of one reduced picture, each (H, W) unless said otherwise.

    Attributes
    ----------
    lab : (H, W, 3) array
        CIE L*a*b*.
    texture : array
        Log of the local contrast.
    edges : dict of float to array
        Log of the colour gradient in units of the picture's own noise, by the blur's sigma [pixels].
    colour : (H, W, 4) array
        What the colour model learns from: slightly blurred L*a*b* and texture.
    """

    lab: np.ndarray
    texture: np.ndarray
    edges: dict
    colour: np.ndarray


def measure(rgb):
    """Measure edges, texture and colour of a reduced RGB picture, (H, W, 3), 0 to 255."""
    lab = imaging.rgb_to_lab(rgb)
    edges = {sigma: _edge_strength(lab, sigma) for sigma in EDGE_SIGMAS_PX}
    lightness = np.ascontiguousarray(lab[..., 0])
    fine = lightness - imaging.gaussian_blur(lightness, 2.0)
    texture = np.log(np.sqrt(np.maximum(imaging.box_mean(fine * fine, 7, 7), 0)) + 0.15)
    colour = np.dstack([imaging.gaussian_blur(lab, 1.0), texture]).astype(np.float32)
    return Appearance(lab, texture, edges, colour)


def _edge_strength(lab, sigma_px):
    """Log of the gradient across a nearly level boundary, in units of the quietest tenth of the picture."""
    blurred = imaging.gaussian_blur(lab, sigma_px)
    down = np.zeros_like(blurred)
    down[1:] = blurred[1:] - blurred[:-1]
    across = np.zeros_like(blurred)
    across[:, 1:-1] = (blurred[:, 2:] - blurred[:, :-2]) / 2
    strength = np.sqrt((down**2 + 0.5 * across**2).sum(2)) * sigma_px
    noise = np.percentile(strength, 10) + 0.3
    return np.log1p(strength / (noise + 1.0)).astype(np.float32)


def means_above_below(values, window_px):
    """Means of the `window_px` rows above each boundary and of those below it, edge rows repeated outside."""
    padded = np.pad(values, ((window_px, window_px), (0, 0)), mode="edge")
    total = np.zeros((padded.shape[0] + 1, padded.shape[1]))
    np.cumsum(padded, 0, out=total[1:], dtype=np.float64)
    height = values.shape[0]
    before, at, after = total[:height], total[window_px:][:height], total[2 * window_px :][:height]
    return ((at - before) / window_px).astype(np.float32), ((after - at) / window_px).astype(np.float32)


def sum_above(values):
    """Sum of all rows above each row, (H, W)."""
    total = np.zeros_like(values)
    np.cumsum(values[:-1], 0, out=total[1:])
    return total


def learn_sky(appearance, passes=3):
    """Log-likelihood ratio of sky against ground by a model learned from this picture, clipped, (H, W) float32.

    A first seam follows edges with few edges above it; the mixtures learn from both its sides, a better seam follows,
    and so on. Zero where nothing can be learned.
    """
    height = appearance.texture.shape[0]
    rows = np.arange(height)[:, None]
    edge = np.minimum(sum(appearance.edges[s] for s in EDGE_SIGMAS_PX[:3]) / 3, 3)
    clutter = sum_above(np.clip(edge - 0.7, 0, 1.5))
    line = best_line(edge - 0.02 * np.minimum(clutter, 60) - 0.4 * (rows < 2), 0.15)
    ratio = None
    for turn in range(passes):
        if turn:
            line = best_line(_seam_score(edge, ratio), 0.15)
        is_sky = rows < line - 3
        is_ground = (rows > line + 3) & (rows < line + 0.5 * height)
        learned = sky_log_ratio(appearance.colour, is_sky, is_ground)
        if learned is None:
            break
        ratio = np.clip(learned, -RATIO_LIMIT, RATIO_LIMIT)
    return np.zeros(appearance.texture.shape, np.float32) if ratio is None else ratio


def _seam_score(edge, ratio):
    contrast = 0
    for window in (6, 18, 54):
        above, below = means_above_below(ratio, window)
        contrast = contrast + (above - below) / 3
    ground_above = sum_above(np.clip(-ratio, 0, 2))
    return 0.5 * edge + 0.35 * contrast - 0.02 * np.minimum(ground_above, 100)


def boundary_features(appearance, ratio):
    """Everything the weights table refers to, by name.

    Parameters
    ----------
    appearance : Appearance
    ratio : (H, W) array
        From `learn_sky`.

    Returns
    -------
    dict of str to (H, W) float32 array
    """
    height, width = ratio.shape
    features = {}
    for sigma, edge in appearance.edges.items():
        features[f"edge_{sigma}"] = edge
        features[f"peak_{sigma}"] = edge - imaging.maximum_down(edge, 2 * (int(round(2 * sigma)) | 1) + 1)
    for window in RATIO_WINDOWS_PX:
        above, below = means_above_below(ratio, window)
        features[f"sky_over_ground_{window}"] = above - below
    lab, texture = appearance.lab, appearance.texture
    for window in CONTRAST_WINDOWS_PX:
        above, below = means_above_below(lab[..., 0], window)
        features[f"darker_below_{window}"] = np.clip((above - below) / 10, -2, 2)
        features[f"brightness_step_{window}"] = np.minimum(np.abs(above - below) / 10, 2)
        above, below = means_above_below(lab[..., 2], window)
        features[f"bluer_above_{window}"] = np.clip((below - above) / 8, -2, 2)
        above, below = means_above_below(texture, window)
        features[f"rougher_below_{window}"] = below - above
    sky = 1 / (1 + np.exp(-ratio))
    ground_above = sum_above(1 - sky)
    features["ground_above"] = np.log1p(ground_above / 5)
    features["ground_above_share"] = ground_above / height
    features["sky_below"] = np.log1p((sky.sum(0) - sum_above(sky)) / 5)
    edge = sum(appearance.edges[s] for s in EDGE_SIGMAS_PX[:3]) / 3
    features["edges_above"] = np.log1p(sum_above(np.clip(edge - 0.7, 0, 1.5)))
    sharp = np.maximum(appearance.edges[0.8], appearance.edges[1.6])
    features["stronger_above"] = np.maximum(_strongest_above(sharp) - sharp, 0)
    features["stronger_below"] = np.maximum(_strongest_above(sharp[::-1])[::-1] - sharp, 0)
    features["row"] = np.repeat(np.linspace(0, 1, height, dtype=np.float32)[:, None], width, 1)
    features["top"] = np.broadcast_to((np.arange(height) < 3)[:, None], (height, width)).astype(np.float32)
    return features


def _strongest_above(edge, gap_px=4):
    """Largest value at least `gap_px` rows above each row, 0 near the top."""
    strongest = np.zeros_like(edge)
    if edge.shape[0] > gap_px:
        strongest[gap_px:] = np.maximum.accumulate(edge, 0)[:-gap_px]
    return strongest
