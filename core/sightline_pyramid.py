"""The bilinear surface of a DEM window, and upper bounds over ever larger blocks of its patches.

A *patch* (r, c) is the surface between the cell centres r, r + 1 and c, c + 1. No ray that stays above a block's
bound can touch any patch in it, which lets a ray cross kilometres of air in one step.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

MAX_LEVEL = 10
"""Blocks of 2^10 patches are the largest worth keeping."""


@dataclass(frozen=True, eq=False)
class SurfacePyramid:
    """A window's elevations and its block maxima.

    Attributes
    ----------
    elevation_m : (R, C) float32 array
        [m], NaN in voids.
    bound_m : tuple of arrays
        Level k holds the highest possible elevation of each block of 2^k x 2^k patches [m]; a void counts as
        `void_bound_m` where it is, so that a ray may pass high above it.
    void_patch : (R - 1, C - 1) bool array or None
        Patches with an unknown corner; None where there is none.
    """

    elevation_m: np.ndarray
    bound_m: tuple
    void_patch: np.ndarray | None = None

    def corners(self, row, col):
        """Elevations at (r, c), (r, c + 1), (r + 1, c), (r + 1, c + 1) of patches [m], as float64."""
        z = self.elevation_m
        width = z.shape[1]
        flat, first = z.reshape(-1), row * width + col
        return tuple(flat[first + step].astype(float) for step in (0, 1, width, width + 1))


def build_pyramid(elevation_m):
    """Build a `SurfacePyramid` of a window with at least 2 x 2 cells.

    Voids get the height of the highest known cell on their rim: what hides in a void is taken to be no higher.
    """
    elevation_m = np.ascontiguousarray(elevation_m, dtype=np.float32)
    unknown = ~np.isfinite(elevation_m)
    void_patch = None
    filled = elevation_m
    if unknown.any():
        filled = np.where(unknown, _rim_height(elevation_m, unknown), elevation_m)
        void_patch = _any_of_corners(unknown)
    patch = np.maximum(filled[:-1], filled[1:])
    bound = [np.maximum(patch[:, :-1], patch[:, 1:])]
    while max(bound[-1].shape) > 1 and len(bound) <= MAX_LEVEL:
        bound.append(_halve(bound[-1]))
    return SurfacePyramid(elevation_m, tuple(bound), void_patch)


def _any_of_corners(mask):
    pair = mask[:-1] | mask[1:]
    return pair[:, :-1] | pair[:, 1:]


def _halve(bound):
    rows, cols = bound.shape
    if rows % 2 or cols % 2:
        bound = np.pad(bound, ((0, rows % 2), (0, cols % 2)), constant_values=-np.inf)
    pair = np.maximum(bound[::2], bound[1::2])
    return np.maximum(pair[:, ::2], pair[:, 1::2])


def _rim_height(elevation_m, unknown):
    """Highest known elevation beside each void, per void, spread over its cells; -inf where nothing is known."""
    label, count = ndimage.label(unknown, structure=np.ones((3, 3)))
    around = ndimage.maximum_filter(np.where(unknown, -np.inf, elevation_m), size=3, mode="nearest")
    highest = ndimage.maximum(around, label, index=np.arange(count + 1))
    return np.asarray(highest, dtype=np.float32)[label]
