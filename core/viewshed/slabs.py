"""Slabs: the lines of a quarter in the order in which the sweep processes them, read a few at a time."""

from __future__ import annotations

from dataclasses import dataclass
from threading import Lock

import numpy as np

from ..base.terrain import Terrain, Window

SLAB = 256
"""Number of lines read at once; slabs start at its multiples, as the tiles of usual files do."""


@dataclass(frozen=True, eq=False)
class SweptGround:
    """The ground that one sweep covers.

    Attributes
    ----------
    terrain : Terrain
    quarter : Quarter
    window : Window
        Part of the raster; nothing outside is read.
    k_max : float
        Distance of the quarter's last line [lines].
    """

    terrain: object
    quarter: object
    window: object
    k_max: float


class OneAtATime(Terrain):
    """A terrain that several threads read, one at a time."""

    def __init__(self, terrain):
        self.shape, self._terrain, self._lock = terrain.shape, terrain, Lock()

    def read(self, window):
        """See `Terrain.read`."""
        with self._lock:
            return self._terrain.read(window)

    def read_into(self, window, out):
        """See `Terrain.read_into`."""
        with self._lock:
            self._terrain.read_into(window, out)

    def frame(self, longitude_deg, latitude_deg, radius_m):
        """See `Terrain.frame`."""
        return self._terrain.frame(longitude_deg, latitude_deg, radius_m)


class Slabs:
    """Reads a quarter's lines.

    Parameters
    ----------
    ground : SweptGround
    u : (R,) array
        Rays, by their coordinate u.
    open_rays : (R,) bool array
        Rays that lie in the sector.
    """

    def __init__(self, ground, u, open_rays):
        self.terrain, self.quarter, self.window = ground.terrain, ground.quarter, ground.window
        self._ends = u[np.flatnonzero(open_rays)[[0, -1]]]
        self._memory = np.empty(0, np.float32)

    def lines(self):
        """Lines of the quarter, outwards, in groups that start at multiples of `SLAB`."""
        first, count = self.extent(self.quarter.by_rows)
        sign, origin = self.quarter.sign, self.quarter.origin_line
        if sign > 0:
            start = max(int(np.floor(origin)) + 1, first)
            edges = [start, *range((start // SLAB + 1) * SLAB, first + count, SLAB), first + count]
            edges = [edge for edge in edges if edge <= first + count]
            pairs = zip(edges[:-1], edges[1:])
            return [np.arange(a, b) for a, b in pairs if b > a]
        start = min(int(np.ceil(origin)) - 1, first + count - 1)
        edges = [start + 1, *range((start // SLAB) * SLAB, first, -SLAB), first]
        return [np.arange(a - 1, b - 1, -1) for a, b in zip(edges[:-1], edges[1:]) if a > b]

    def extent(self, of_rows):
        """First index and number of the window's rows or columns."""
        window = self.window
        return (window.row, window.rows) if of_rows else (window.col, window.cols)

    def read_transient(self, lines):
        """Cells of a slab as (lines outwards, along) and the first column, or None if no open ray passes.

        Reading the next slab overwrites them.
        """
        low, high = self._along_range(np.abs(lines[[0, -1]] - self.quarter.origin_line))
        first, count = self.extent(not self.quarter.by_rows)
        start = (max(low, first - 1) - 1) // BAND * BAND
        stop = -(-(min(high, first + count) + 2) // BAND) * BAND
        inner, end = max(start, first), min(stop, first + count)
        if inner >= end:
            return None
        top = int(min(lines[0], lines[-1]))
        by_rows = self.quarter.by_rows
        window = Window(top, inner, len(lines), end - inner) if by_rows else Window(inner, top, end - inner, len(lines))
        cells = self._blank(len(lines), stop - start)
        cells[:, : inner - start], cells[:, end - start :] = LOW, LOW
        place = cells[:: self.quarter.sign, inner - start : end - start]
        if by_rows:
            self.terrain.read_into(window, place)
        else:
            values = self.terrain.read(window)
            for row in range(0, len(values), 512):  # transposing piecewise stays in the cache
                place[:, row : row + 512] = values[row : row + 512].T
        # The outer half cells belong to the raster, and a cell on its edge is judged by a ray outside the edge too.
        if inner > start:
            cells[:, max(inner - start - 2, 0) : inner - start] = cells[:, inner - start, None]
        if end < stop:
            cells[:, end - start : end - start + 2] = cells[:, end - start - 1, None]
        return cells, start

    def _blank(self, rows, cols):
        """Reuse memory, as new memory costs more than the cells that are read into it."""
        if len(self._memory) < rows * cols:
            self._memory = np.empty(rows * cols, np.float32)
        return self._memory[: rows * cols].reshape(rows, cols)

    def _along_range(self, k):
        """Columns (rows) between which the open rays cross the lines `k`: whole pixels (low, high)."""
        w = self._ends + np.zeros((len(k), 1))
        if not self.quarter.plane:
            w = w + self.quarter.ray_bend.at(k, self.quarter.ray_bend.place(self._ends))
        j = w * np.asarray(k)[:, None]
        return (
            int(np.floor(j.min() + self.quarter.origin_along)) - 2,
            int(np.ceil(j.max() + self.quarter.origin_along)) + 2,
        )

    def place(self, lines, start, width):
        """Find the position of a part of a slab on the raster.

        Parameters
        ----------
        lines : int array
            Lines of the slab.
        start, width : int
            First cell along the lines, and number of cells.

        Returns
        -------
        window : Window
            Part of the raster.
        inner : slice
            Part of the slab that lies inside the raster's window.
        """
        first, count = self.extent(not self.quarter.by_rows)
        inner, end = max(start, first), min(start + width, first + count)
        top = int(min(lines[0], lines[-1]))
        by_rows = self.quarter.by_rows
        window = Window(top, inner, len(lines), end - inner) if by_rows else Window(inner, top, end - inner, len(lines))
        return window, slice(inner - start, end - start)


BAND = 32
"""Lines per band and cells per block, aligned to the raster so that the result does not depend on how it is read."""

LOW = np.float32(-1e25)
"""Elevation that never obstructs and is never seen, used beyond the raster's edge."""

NEVER, CLOSED = np.float32(-1e9), np.float32(1e9)
"""Tangents of a ray that nothing obstructs yet, and of a ray outside the sector."""

CHUNK = 16
"""Number of rays whose minimum is taken together; a power of two."""


class Blocks:
    """The blocks of one band, their bounds and the rays that pass them.

    Attributes
    ----------
    active : (n,) int array
        Blocks that must be examined.
    first_ray, last_ray : (n,) int arrays
        Rays that touch the blocks, with a margin.
    """

    def __init__(self, sweep, k, cells, start):
        self.sweep = sweep
        options, quarter = sweep.options, sweep.quarter
        top, void = _highest(cells)
        count = len(top)
        low = start + BAND * np.arange(count) - 1 - quarter.origin_along
        first, last = self._rays_between(k, low, low + BAND + 1)
        rays = len(sweep.u)
        touched = (last >= 0) & (first < rays)
        first, last = (np.minimum(np.maximum(ray, 0), rays - 1) for ray in (first, last))  # np.clip takes far longer
        nearest, farthest = self._distances(k, low + (BAND + 1) / 2)
        lowest = range_minimum(sweep.highest, first, last)
        height = top.astype(np.float64) + (options.target_height_m - options.eye_m)
        bound = np.where(height >= 0, height / nearest, height / farthest) - options.drop_per_m2 * nearest
        matters = (bound + 1e-6 * (1 + np.abs(bound)) >= lowest) | void | sweep.sink.wants_clearance
        matters &= touched & (nearest <= options.max_distance_m) & (lowest < CLOSED)
        self.active = np.flatnonzero(matters)
        self.first_ray, self.last_ray = first[self.active], last[self.active]

    def rays(self):
        """Open rays of the active blocks, and for every ray its position among them (or its left neighbour's)."""
        size = len(self.sweep.u)
        change = np.bincount(self.first_ray, minlength=size + 1) - np.bincount(self.last_ray + 1, minlength=size + 1)
        chosen = (np.cumsum(change)[:size] > 0) & self.sweep.open
        compact = np.cumsum(chosen) - 1
        return np.flatnonzero(chosen), np.minimum(np.maximum(compact, 0), max(int(compact[-1]) - 1, 0))

    def _rays_between(self, k, low, high):
        """First and last ray that crosses each block, with a margin of two; they may lie outside the list."""
        sweep, quarter = self.sweep, self.sweep.quarter
        u_low = np.minimum(low / k[0], low / k[-1])
        u_high = np.maximum(high / k[0], high / k[-1])
        if not quarter.plane:
            lines = [quarter.bend.line(k[0]), quarter.bend.line(k[-1])]
            bends = [quarter.bend.along(line, quarter.bend.place(u)) for line in lines for u in (u_low, u_high)]
            u_low = u_low + np.minimum.reduce(bends)
            u_high = u_high + np.maximum.reduce(bends)
        limit = 4.0 * len(sweep.u)
        first = np.maximum((u_low - sweep.u_first) / sweep.spacing, -limit)
        last = np.minimum((u_high - sweep.u_first) / sweep.spacing, limit)
        np.minimum(first, limit, out=first)
        np.maximum(last, -limit, out=last)
        return np.floor(first).astype(np.intp) - 2, np.ceil(last).astype(np.intp) + 2

    def _distances(self, k, centre):
        """Ground distances that enclose each block [m]."""
        quarter = self.sweep.quarter
        middle = (k[0] + k[-1]) / 2
        w = centre / middle
        distance = middle * quarter.rho_m(w)
        if not quarter.plane:
            distance = distance * (1 + quarter.stretch.along(quarter.stretch.line(middle), quarter.stretch.place(w)))
        half = 0.6 * ((BAND + 2) * quarter.side_m[0] + (k[-1] - k[0] + 1) * quarter.side_m[1])
        return np.maximum(distance - half, 1e-3), distance + half


def _highest(cells):
    """Highest known elevation of each block, and which blocks have voids."""
    top = cells.max(axis=0)
    void = np.isnan(top)
    if void.any():
        top = np.fmax.reduce(cells, axis=0)
        top[np.isnan(top)] = LOW
    top = top.reshape(-1, BAND).max(axis=1)
    return top, void.reshape(-1, BAND).any(axis=1)


def range_minimum(values, first, last):
    """Compute the minimum of `values[first:last + 1]` for many ranges, rounded outwards to whole chunks.

    Parameters
    ----------
    values : (N,) array
    first, last : (M,) int arrays

    Returns
    -------
    (M,) array

    Notes
    -----
    A sparse table over the chunks' minima: each range is covered by two overlapping powers of two.
    """
    padded = np.full(-(-len(values) // CHUNK) * CHUNK, CLOSED, values.dtype)
    padded[: len(values)] = values
    for _ in range(CHUNK.bit_length() - 1):  # halving is several times faster than a reduction over a short axis
        padded = np.minimum(padded[::2], padded[1::2])
    tables = [padded]
    first, last = first // CHUNK, last // CHUNK
    level = np.frexp((last - first + 1).astype(float))[1] - 1
    for step in range(int(level.max(initial=0))):
        table = tables[-1]
        tables.append(np.minimum(table, np.append(table[1 << step :], np.full(min(1 << step, len(table)), CLOSED))))
    stack = np.array(tables)
    return np.minimum(stack[level, first], stack[level, last - (1 << level) + 1])
