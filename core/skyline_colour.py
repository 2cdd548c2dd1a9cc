"""What sky and ground look like in this one picture: two mixtures learned from the picture itself.

Sky and ground are each a mixture of a few elliptical clusters with heavy tails, fitted to the pixels above and below
a first guess of the skyline. Nothing is carried over from other pictures, so a sepia print, dusk and noon all serve.
"""

from __future__ import annotations

import numpy as np

NOISE_FLOOR = (2.0, 1.0, 1.0, 0.02)
"""Variance added per feature (L*, a*, b*, log texture): a cluster is never narrower than rounding and grain."""

SAMPLE = 4000
FEWEST = 200


def sky_log_ratio(features, is_sky, is_ground, clusters=4):
    """Log-likelihood ratio of sky against ground for each pixel.

    Parameters
    ----------
    features : (H, W, F) float32 array
        Colour and texture per pixel.
    is_sky, is_ground : (H, W) bool arrays
        Pixels to learn from.
    clusters : int
        Of each mixture.

    Returns
    -------
    (H, W) float32 array, or None where either side has too few pixels to learn from.
    """
    height, width, count = features.shape
    flat = features.reshape(-1, count)
    log_density = []
    for mask in (is_sky, is_ground):
        chosen = np.flatnonzero(mask)
        if len(chosen) < FEWEST:
            return None
        sample = flat[chosen[np.linspace(0, len(chosen) - 1, min(len(chosen), SAMPLE)).astype(int)]]
        log_density.append(_mixture_log_density(flat, sample, k_means(sample, clusters)))
    return (log_density[0] - log_density[1]).reshape(height, width)


def k_means(points, clusters, rounds=15):
    """Label each point with one of at most `clusters` clusters; deterministic.

    Starts from equal slices along the direction of largest spread. Clusters that lose all their points stay empty,
    so one colour repeated a thousand times is a valid input.

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


def _mixture_log_density(flat, sample, label):
    """Log-density up to a constant of Student-like clusters (tails of a t-distribution with 4 degrees of freedom)."""
    best = np.full(len(flat), -60.0, np.float32)
    for cluster in np.unique(label):
        own = sample[label == cluster]
        if len(own) < 15:
            continue
        precision = np.linalg.inv(np.cov(own.T) + np.diag(NOISE_FLOOR[: flat.shape[1]]))
        whitening = np.linalg.cholesky(precision).astype(np.float32)
        offset = (flat - own.mean(0, dtype=np.float32)) @ whitening
        distance2 = np.einsum("ij,ij->i", offset, offset)
        height = np.float32(np.log(np.diag(whitening)).sum() + np.log(len(own) / len(sample)))
        best = np.logaddexp(best, height - 4 * np.log1p(distance2 / 6))
    return best
