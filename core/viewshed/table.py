"""Smooth functions on coarse grids, and the interpolation between neighbouring values of long arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

QUICK = "wrap"
"""Mode of `numpy.take` that needs two thirds of the time of the others; no index here lies outside."""


@dataclass(frozen=True, eq=False)
class Table:
    """A smooth function over (k, w) on regular nodes; zero if `values` is None.

    Attributes
    ----------
    values : (K, W) array or None
    k_max : float
        Last node in k; the first is 0 [lines].
    w_min, w_max : float
        First and last node in w.
    """

    values: Any
    k_max: float
    w_min: float
    w_max: float

    def line(self, k):
        """(W,) values at one distance, ready for `along`."""
        return self.lines(np.array([[k]]))[0]

    def lines(self, k):
        """(M, W) values at M distances, given as (M, 1)."""
        place = np.minimum(np.maximum(k / self.k_max, 0.0), 1.0) * (len(self.values) - 1)
        low = np.minimum(place.astype(np.intp), len(self.values) - 2)
        first, last = self.values[low[:, 0]], self.values[low[:, 0] + 1]
        return first + (last - first) * (place - low).astype(np.float32)

    def place(self, w):
        """(node, share) of each w, ready for `along`."""
        nodes = self.values.shape[1]
        place = w - self.w_min
        place *= (nodes - 1) / (self.w_max - self.w_min)
        np.maximum(place, 0, out=place)
        np.minimum(place, nodes - 1, out=place)
        node = place.astype(np.intp)
        np.minimum(node, nodes - 2, out=node)
        place -= node
        return node, place.astype(np.float32, copy=False)

    def each(self, k, w):
        """(M, n) values at M distances, given as (M, 1), and n places at each."""
        lines = self.lines(k)
        node, share = self.place(w)
        node += np.arange(len(k))[:, None] * lines.shape[1]
        return beside(lines.reshape(-1), node, share)

    @staticmethod
    def along(lines, place):
        """Interpolate (M, W) `lines` at n places on each, or one line."""
        node, share = place
        low = lines.take(node, axis=-1, mode=QUICK)
        values = lines[..., 1:].take(node, axis=-1, mode=QUICK)
        values -= low
        values *= share
        values += low
        return values


def between(low, high, shares):
    """Interpolate between the values of two lines, whose `high` is overwritten.

    Parameters
    ----------
    low, high : (n,) arrays
        Values on the first and the last line.
    shares : (K,) array
        See the function of this name.

    Returns
    -------
    (K, n) array
    """
    high -= low
    values = high * shares[:, None]
    values += low
    return values


def shares(k):
    """Position of each distance between the first (0) and the last (1): float32."""
    return ((k - k[0]) / max(k[-1] - k[0], 1e-9)).astype(np.float32)


def beside(values, index, share):
    """Interpolate between neighbouring values.

    Parameters
    ----------
    values : (N,) array
    index : integer array
        The first of both neighbours.
    share : array
        Weight of the second neighbour, 0 to 1.
    """
    low = values.take(index, mode=QUICK)
    between = values[1:].take(index, mode=QUICK)
    between -= low
    between *= share
    between += low
    return between


def held_places(whole, first, last):
    """Turn whole numbers into indices that stay within an array.

    Parameters
    ----------
    whole : (lines, N) float array
        Whole numbers that grow along each line; those outside are clamped in place.
    first : int
        Added to each.
    last : int
        Largest index.

    Returns
    -------
    index : (lines, N) int32 array
        `first + whole`, clamped to 0 to `last`.
    held : bool
        Whether any had to be clamped.
    """
    ends = whole[:, [0, -1]]
    held = not (ends.min() + first >= 1 and ends.max() + first < last)  # rounding can make them decrease by one
    if held:
        np.maximum(whole, -first, out=whole)  # `np.clip` takes four times as long
        np.minimum(whole, last - first, out=whole)
    index = whole.astype(np.int32)
    if first:
        index += first
    if held:  # floats of this size may be rounded
        np.minimum(index, last, out=index)
    return index, held
