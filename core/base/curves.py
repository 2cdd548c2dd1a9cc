"""Curves over a full circle of headings, and measures of how well two curves agree."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

SIDELOBE_EXCLUSION_DEG = 5.0
"""Headings this close to the peak do not count as sidelobes [degrees]."""


def row_ncc(image: np.ndarray, seen: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Give the normalised cross-correlation along the last axis where `seen` is known, and the mean difference."""
    known = np.isfinite(seen)
    count = np.maximum(known.sum(axis=-1), 1)
    seen = np.where(known, seen, 0.0)
    image = np.where(known, image, 0.0)
    mean_seen, mean_image = seen.sum(axis=-1) / count, image.sum(axis=-1) / count
    a = np.where(known, image - mean_image[..., None], 0.0)
    b = np.where(known, seen - mean_seen[..., None], 0.0)
    norm = np.sqrt(np.square(a).sum(axis=-1) * np.square(b).sum(axis=-1))
    usable = (norm > 1e-9 * count) & (2 * count > seen.shape[-1])
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(usable, (a * b).sum(axis=-1) / norm, np.nan), mean_seen - mean_image


def correlation(a: Sequence[float] | np.ndarray, b: Sequence[float] | np.ndarray) -> float | None:
    """Give the normalised cross-correlation of two curves, or None if one is constant or they have under 10 points."""
    if len(a) < 10:
        return None
    ncc, _ = row_ncc(np.asarray(a, float), np.asarray(b, float))
    return float(ncc) if np.isfinite(ncc) else None


def curve_peaks(heading_deg: np.ndarray, curve: np.ndarray, separation_deg: float) -> list[int]:
    """Give the indices of a curve's highest point and of further local maxima, highest first.

    Parameters
    ----------
    heading_deg, curve : (N,) arrays
        Headings [degrees] over the whole circle and the values there; NaN where the curve is unknown.
    separation_deg : float
        Smallest angle between two of the maxima [degrees].
    """
    filled = np.where(np.isfinite(curve), curve, -np.inf)
    local = (filled >= np.roll(filled, 1)) & (filled >= np.roll(filled, -1)) & np.isfinite(curve)
    tops = np.flatnonzero(local)
    return [int(tops[index]) for index in distinct_headings(heading_deg[tops], filled[tops], separation_deg)]


def distinct_headings(heading_deg: np.ndarray, score: ArrayLike, separation_deg: float) -> list[int]:
    """Give the indices of headings that differ by `separation_deg` or more, best first.

    Parameters
    ----------
    heading_deg, score : (N,) arrays
        Headings [degrees] and their scores, in any order; equal scores keep their order.
    separation_deg : float
        Smallest angle between two headings, also across north [degrees].
    """
    kept: list[int] = []
    for index in np.argsort(-np.asarray(score), kind="stable"):
        turn = np.abs((heading_deg[kept] - heading_deg[index] + 180) % 360 - 180) if kept else np.zeros(0)
        if (turn >= separation_deg).all():
            kept.append(int(index))
    return kept


def sharpness(heading_deg: np.ndarray, curve: np.ndarray, peak_deg: float) -> float | None:
    """Give the peak-to-sidelobe ratio of a curve over the circle, or None if it has no sidelobes.

    Parameters
    ----------
    heading_deg, curve : (N,) arrays
        Headings [degrees] over the whole circle and the values there; NaN where the curve is unknown.
    peak_deg : float
        Heading of the peak [degrees].

    Returns
    -------
    float or None
        Peak minus the mean of the sidelobes, divided by their standard deviation.
    """
    away = np.abs((heading_deg - peak_deg + 180) % 360 - 180) > SIDELOBE_EXCLUSION_DEG
    lobes = curve[away & np.isfinite(curve)]
    if len(lobes) < 2 or lobes.std() == 0:
        return None
    peak = np.nanmax(np.where(away, np.nan, curve))
    return float((peak - lobes.mean()) / lobes.std())
