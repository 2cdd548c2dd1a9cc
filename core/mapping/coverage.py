"""The joint coverage of a collection of photographs: how often and how well ground is seen, and by which photos.

Finding the fewest photographs that cover an area is a set cover problem. Cells seen by the same photographs form one
question, and few such questions remain. A greedy choice gives a good answer, and a bounded search proves or improves
it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..base.surface import local_places, normal_of, patch_around, sampling_distance_m
from ..base.terrain import Window
from ..base.viewed import VISIBLE

BLOCK_ROWS = 256
SEARCH_NODES = 20_000
"""Number of steps after which the search for a smaller cover stops and the greedy answer stands."""


@dataclass(eq=False)
class Coverage:
    """Counts over a window of the DEM.

    Attributes
    ----------
    window : Window
    count : uint16 (R, C) array
        Photographs that see the cell.
    best_gsd_m : float32 (R, C) array
        Smallest ground sampling distance across the line of sight [m]; NaN where unseen.
    names : list
        Names of the photographs, in the order in which they were added.
    area : (R, C) bool array or None
        Cells that matter; None means all.
    """

    window: Window
    area: Any = None
    count: Any = None
    best_gsd_m: Any = None
    names: list = field(default_factory=list)
    _seen: list = field(default_factory=list)

    def __post_init__(self):
        shape = self.window.rows, self.window.cols
        self.area = np.ones(shape, bool) if self.area is None else self.area
        self.count = np.zeros(shape, np.uint16)
        self.best_gsd_m = np.full(shape, np.nan, np.float32)

    def add(self, name, terrain, view, seen):
        """Add a photograph.

        Parameters
        ----------
        name : str
        terrain : Terrain
        view : View
        seen : Viewshed
            Viewshed of the photograph.

        Returns
        -------
        int
            Number of cells of the area that the photograph sees.
        """
        here, there = _overlap(self.window, seen.window)
        part = np.zeros(self.count.shape, bool)
        part[here] = seen.values[there] == VISIBLE
        part &= self.area
        self.count += part
        for top in range(0, self.window.rows, BLOCK_ROWS):
            row, col = np.nonzero(part[top : top + BLOCK_ROWS])
            if row.size:
                gsd = _gsd_across(terrain, view, row + top + self.window.row, col + self.window.col)
                self.best_gsd_m[row + top, col] = np.fmin(self.best_gsd_m[row + top, col], gsd)
        self.names.append(name)
        self._seen.append(np.packbits(part))
        return int(part.sum())

    @property
    def blind(self):
        """(R, C) bool array: cells of the area that no photograph sees."""
        return self.area & (self.count == 0)

    def fewest_photos(self):
        """Choose as few photographs as possible that together see every cell that any of them sees.

        Returns
        -------
        chosen : list of int
            Indices into `names`, in greedy order: each adds the most cells that are still missing.
        proven : bool
            No smaller choice exists; False if the search was cut short.
        gains : list of int
            Number of cells that each adds.
        """
        sets, cells = self._questions()
        chosen = _prune(_greedy(sets, cells, len(self.names)), sets)
        better, proven = _search(sets, len(chosen))
        chosen = _greedy(sets, cells, len(self.names), only=better or chosen)
        return chosen, proven, _gains(chosen, sets, cells)

    def _questions(self):
        """Distinct sets of photographs that see a cell, as bit masks, and the number of cells of each set."""
        if not self._seen:
            return [], []
        columns = np.unpackbits(np.array(self._seen), axis=1, count=self.count.size)
        columns = columns[:, self.count.ravel() > 0]
        packed = np.packbits(columns, axis=0)
        signature, cells = np.unique(packed, axis=1, return_counts=True)
        bits = np.unpackbits(signature, axis=0, count=len(self._seen)).T
        return [sum(1 << int(k) for k in np.flatnonzero(row)) for row in bits], cells.tolist()


def _overlap(window, other):
    """Slices of both windows' arrays where they overlap."""
    top, left = max(window.row, other.row), max(window.col, other.col)
    bottom = min(window.row + window.rows, other.row + other.rows)
    right = min(window.col + window.cols, other.col + other.cols)
    bottom, right = max(bottom, top), max(right, left)

    def slices(origin):
        return slice(top - origin.row, bottom - origin.row), slice(left - origin.col, right - origin.col)

    return slices(window), slices(other)


def _gsd_across(terrain, view, row, col):
    z, r, c = patch_around(terrain, row.astype(float), col.astype(float))
    east, north = local_places(view.frame, row.astype(float), col.astype(float))
    rise = view.rise_of(east, north, z[r.astype(np.intp), c.astype(np.intp)])
    return sampling_distance_m(view, east, north, rise, normal_of(z, r, c, view.frame))[0].astype(np.float32)


def _greedy(sets, cells, photos, only=None):
    """Choose photographs by the cells that each adds to those before, until none is missing."""
    left = list(zip(sets, cells))
    allowed = list(range(photos)) if only is None else list(only)
    chosen = []
    while left:
        gain = {k: sum(n for mask, n in left if mask >> k & 1) for k in allowed}
        best = max(allowed, key=lambda k: (gain[k], -k))
        chosen.append(best)
        left = [(mask, n) for mask, n in left if not mask >> best & 1]
    return chosen


def _prune(chosen, sets):
    """Drop choices that later ones have made redundant, the smallest gain first."""
    for k in list(reversed(chosen)):
        rest = sum(1 << j for j in chosen if j != k)
        if all(mask & rest for mask in sets):
            chosen = [j for j in chosen if j != k]
    return chosen


def _gains(chosen, sets, cells):
    gains, have = [], 0
    for k in chosen:
        gains.append(sum(n for mask, n in zip(sets, cells) if mask >> k & 1 and not mask & have))
        have |= 1 << k
    return gains


def _search(sets, size):
    """Look for a cover smaller than `size`: (cover or None, whether the search was completed)."""
    minimal = [mask for mask in set(sets) if not any(other != mask and other & mask == other for other in set(sets))]
    budget = [SEARCH_NODES]
    best = [None, size]

    def visit(left, taken):
        budget[0] -= 1
        if budget[0] < 0:
            return
        if not left:
            best[:] = [taken, len(taken)]
            return
        if len(taken) + _apart(left) >= best[1]:
            return
        hardest = min(left, key=lambda mask: bin(mask).count("1"))
        photos = [k for k in range(hardest.bit_length()) if hardest >> k & 1]
        photos.sort(key=lambda k: -sum(mask >> k & 1 for mask in left))
        for k in photos:
            visit([mask for mask in left if not mask >> k & 1], [*taken, k])

    visit(minimal, [])
    return best[0], budget[0] >= 0


def _apart(left):
    """Questions that share no photograph: each needs its own, which gives a lower bound."""
    used = count = 0
    for mask in sorted(left, key=lambda m: bin(m).count("1")):
        if not mask & used:
            used |= mask
            count += 1
    return count
