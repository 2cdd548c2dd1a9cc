"""Learn the appearance of sky and ground from the picture itself, as two mixtures.

Sky and ground are each a mixture of a few elliptical clusters with heavy tails, fitted to the pixels above and below
a first guess of the skyline. Nothing is carried over from other pictures, so that the model works alike on a sepia
print, at dusk and at noon.
"""

from __future__ import annotations

import numpy as np

from ..base import imaging
from .features import means_above_below, sum_above
from .seam import best_line

NOISE_FLOOR = (2.0, 1.0, 1.0, 0.02)
"""Variance added per feature (L*, a*, b*, log texture): a cluster is never narrower than rounding and grain."""

SAMPLE = 4000
FEWEST = 200
FEWEST_IN_CLUSTER = 15

RATIO_LIMIT = 5.0
"""Log-likelihood ratios are clipped at this value, so that a lake or a snowfield cannot decide a whole column."""

MARGIN_PX = 3
"""Pixels within this distance of the boundary count neither as sky nor as ground."""

REACH = 0.5
"""Ground farther below the skyline than this share of the height (a lake, a meadow) is not learned from."""

DOUBT = 0.1
"""A pixel is learned from if the probability that it is of the other kind is below this."""

SEAM_COST_PER_PX = 0.15
SEAM_WINDOWS_PX = (6, 18, 54)


def learn_sky(appearance, passes=3):
    """Log-likelihood ratio of sky against ground by a model learned from this picture, clipped, (H, W) float32.

    A first seam follows edges with few edges above it. The mixtures are fitted to the pixels on both its sides. This
    gives a better seam, and so on. The ratio is zero if nothing can be learned.

    Parameters
    ----------
    appearance : Appearance
    passes : int
        Rounds of learning.
    """
    height, width = appearance.texture.shape
    rows = np.arange(height)[:, None]
    edge = np.minimum(appearance.edge, 3)
    clutter = sum_above(np.clip(edge - 0.7, 0, 1.5))
    line = best_line(edge - 0.02 * np.minimum(clutter, 60) - 0.4 * (rows < 2), SEAM_COST_PER_PX)
    ratio = np.zeros((height, width), np.float32)
    for turn in range(passes):
        if turn:
            line = best_line(_seam_score(edge, ratio), SEAM_COST_PER_PX)
        is_sky = rows < line - MARGIN_PX
        is_ground = (rows > line + MARGIN_PX) & (rows < line + REACH * height)
        learned = sky_log_ratio(appearance.colour, is_sky, is_ground)
        if learned is None:
            break
        ratio = np.clip(learned, -RATIO_LIMIT, RATIO_LIMIT)
    return ratio


def relearn_sky(appearance, probability, ratio):
    """Log-likelihood ratio learned from the pixels that a first extraction classifies as sky and as ground, likewise.

    Parameters
    ----------
    appearance : Appearance
    probability : (H, W) array
        p(first terrain row | column).
    ratio : (H, W) array
        Returned if nothing can be learned.
    """
    height = len(probability)
    ground = imaging.accumulate_down(np.add, probability)
    above = np.pad(ground[:-MARGIN_PX], ((MARGIN_PX, 0), (0, 0)))
    below = np.pad(ground[MARGIN_PX:], ((0, MARGIN_PX), (0, 0)), constant_values=1)
    likeliest = probability.argmax(0)
    near = np.arange(height)[:, None] < likeliest + REACH * height
    learned = sky_log_ratio(appearance.colour, below < DOUBT, (above > 1 - DOUBT) & near)
    return ratio if learned is None else np.clip(learned, -RATIO_LIMIT, RATIO_LIMIT)


def _seam_score(edge, ratio):
    """Score of an edge with sky-like pixels above it, ground-like ones below, and little ground anywhere above."""
    contrast = 0
    for window in SEAM_WINDOWS_PX:
        above, below = means_above_below(ratio, window)
        contrast = contrast + (above - below) / len(SEAM_WINDOWS_PX)
    ground_above = sum_above(np.clip(-ratio, 0, 2))
    return 0.5 * edge + 0.35 * contrast - 0.02 * np.minimum(ground_above, 100)


def sky_log_ratio(features, is_sky, is_ground, clusters=4):
    """Log-likelihood ratio of sky against ground for each pixel.

    Parameters
    ----------
    features : (H, W, 4) float32 array
        Colour and texture per pixel.
    is_sky, is_ground : (H, W) bool arrays
        Pixels to learn from.
    clusters : int
        Number of clusters in each mixture.

    Returns
    -------
    (H, W) float32 array, or None if either side has too few pixels to learn from.
    """
    height, width, count = features.shape
    # The values are centred so that the quadratic forms below keep their precision in float32.
    flat = features.reshape(-1, count) - features.reshape(-1, count).mean(0)
    samples = []
    for mask in (is_sky, is_ground):
        chosen = np.flatnonzero(mask)
        if len(chosen) < FEWEST:
            return None
        samples.append(flat[chosen[np.linspace(0, len(chosen) - 1, min(len(chosen), SAMPLE)).astype(int)]])
    monomials = _monomials(flat)
    sky, ground = (_mixture_density(monomials, sample, k_means(sample, clusters)) for sample in samples)
    return (np.log(sky) - np.log(ground)).reshape(height, width)


def k_means(points, clusters, rounds=15):
    """Label each point with one of at most `clusters` clusters; deterministic.

    The start is equal slices along the direction of largest spread. Clusters that lose all their points stay empty, so
    that one colour repeated a thousand times is a valid input.

    Parameters
    ----------
    points : (N, F) array
    clusters, rounds : int

    Returns
    -------
    (N,) int array of labels.
    """
    centred = points - points.mean(0)
    _, directions = np.linalg.eigh(centred.T @ centred)
    order = np.argsort(centred @ directions[:, -1], kind="stable")
    label = np.empty(len(points), int)
    label[order] = np.arange(len(points)) * clusters // len(points)
    for _ in range(rounds):
        size = np.bincount(label, minlength=clusters)
        sums = np.stack([np.bincount(label, points[:, f], minlength=clusters) for f in range(points.shape[1])], 1)
        centres = sums / np.maximum(size, 1)[:, None]
        distance = (centres * centres).sum(1) - 2 * points @ centres.T
        distance[:, size == 0] = np.inf
        new = distance.argmin(1)
        if (new == label).all():
            break
        label = new
    return label


def _monomials(flat):
    """(N, 1 + F + F (F + 1) / 2) array of 1, x_i, x_i x_j: every quadratic form of x is linear in them."""
    first, second = np.triu_indices(flat.shape[1])
    return np.concatenate([np.ones((len(flat), 1), np.float32), flat, flat[:, first] * flat[:, second]], 1)


def _mixture_density(monomials, sample, label):
    """Density up to a constant of clusters with the tails of a t-distribution, (N,) float32, above 0."""
    count = sample.shape[1]
    first, second = np.triu_indices(count)
    forms, heights = [], []
    for cluster in np.unique(label):
        own = sample[label == cluster].astype(float)
        if len(own) < FEWEST_IN_CLUSTER:
            continue
        precision = np.linalg.inv(np.cov(own.T) + np.diag(NOISE_FLOOR[:count]))
        centre = own.mean(0)
        cross = precision[first, second] * np.where(first == second, 1, 2)
        forms.append(np.concatenate([[centre @ precision @ centre], -2 * precision @ centre, cross]))
        heights.append(np.sqrt(np.linalg.det(precision)) * len(own) / len(sample))
    distance2 = np.maximum(monomials @ np.array(forms, np.float32).T, 0)
    tail = 1 / (1 + distance2 / 6)
    return (tail**2) ** 2 @ np.array(heights, np.float32) + np.float32(1e-30)
