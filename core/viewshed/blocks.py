"""Blocks of cells, and the bounds by which the sweep leaves out those that nobody can see.

The arrays here are short, so that the number of NumPy's calls decides the time, not the number of values.
"""

from __future__ import annotations

import numpy as np

BAND = 32
"""Lines per band, aligned to the raster; slabs hold whole multiples of this number of cells per line."""

WIDE = 8
"""Cells per block along a line; a power of two that divides `BAND`. Narrow blocks have tighter bounds."""

LOW = np.float32(-1e25)
"""Elevation that never obstructs and is never seen, used beyond the raster's edge."""

NEVER, CLOSED = np.float32(-1e9), np.float32(1e9)
"""Tangents of a ray that nothing obstructs yet, and of a ray outside the sector."""

CHUNK = 16
"""Number of rays whose minimum is taken together; a power of two."""


class Blocks:
    """The blocks of a slab, and what bounds them; only `of_band` depends on what the rays have passed before.

    Parameters
    ----------
    sweep : QuarterSweep
    bands : list of slices
        Lines of the bands within the slab.
    k : (lines,) array
        Distance of each line from the observer [lines].
    cells : (lines, N) array
        Elevations [m].
    start : int
        First cell along the lines, counted through the raster.
    """

    def __init__(self, sweep, bands, k, cells, start):
        self.sweep = sweep
        options, quarter = sweep.options, sweep.quarter
        near, far = k[[band.start for band in bands], None], k[[band.stop - 1 for band in bands], None]
        low = np.arange(start, start + cells.shape[1], WIDE) - (1 + quarter.origin_along)
        of_rays = () if quarter.plane else (quarter.ray_bend, quarter.ray_stretch)
        of_cells = () if quarter.plane else (quarter.bend,)
        self.curves = [
            np.array([table.lines(end) for table in tables for end in (near, far)]) for tables in (of_rays, of_cells)
        ]
        self.first, self.last, matters = self._rays_between(near, far, low)
        self.nearest, self.farthest = self._distances(near, far, low + (WIDE + 1) / 2)
        matters &= self.nearest <= options.max_distance_m
        top, self.void = _highest([cells[band] for band in bands])
        height = top.astype(np.float64)
        height += options.target_height_m - options.eye_m
        bound = height / np.where(height >= 0, self.nearest, self.farthest)
        bound -= options.drop_per_m2 * self.nearest
        bound += 1e-6 * (1 + np.abs(bound))
        if self.void is not None:
            bound[self.void] = np.inf
        if sweep.sink.wants_clearance:
            bound[:] = np.inf
        bound[~matters] = -np.inf
        self.bound = bound

    def of_band(self, number):
        """Choose the blocks of a band that must be examined now."""
        first, last = self.first[number], self.last[number]
        lowest = range_minimum(self.sweep.highest, first, last)
        active = ((self.bound[number] >= lowest) & (lowest < CLOSED)).nonzero()[0]
        voids = self.void is not None and bool(self.void[number].any())
        reach = self.nearest[number].take(active), self.farthest[number].take(active)
        curves = [lines[:, number] for lines in self.curves if len(lines)]
        return BandBlocks(self.sweep, active, (first.take(active), last.take(active)), reach, voids, curves)

    def _rays_between(self, near, far, low):
        """First and last ray that crosses each block of each band, with a margin of two, and whether there is any."""
        sweep, bend = self.sweep, self.sweep.quarter.bend
        ends = []
        for j, extreme, rounded, margin in (
            (low, np.minimum, np.floor, -2),
            (low + (WIDE + 1), np.maximum, np.ceil, 2),
        ):
            u = extreme(j / near, j / far)
            if not sweep.quarter.plane:
                ends_of_bend = [bend.each(line, u) for line in (near, far)]
                u += extreme(*ends_of_bend)
            u -= sweep.u_first
            u /= sweep.spacing
            rounded(u, out=u)
            u += margin
            ends.append(u)
        last_ray = len(sweep.u) - 1
        touched = (ends[1] >= 0) & (ends[0] <= last_ray)
        for ray in ends:  # np.clip takes far longer
            np.maximum(ray, 0, out=ray)
            np.minimum(ray, last_ray, out=ray)
        return ends[0].astype(np.intp), ends[1].astype(np.intp), touched

    def _distances(self, near, far, centre):
        """Ground distances that enclose each block [m]."""
        quarter = self.sweep.quarter
        middle = (near + far) / 2
        w = centre / middle
        distance = middle * quarter.rho_m(w)
        if not quarter.plane:
            distance *= 1 + quarter.stretch.each(middle, w)
        half = 0.6 * ((WIDE + 2) * quarter.side_m[0] + (far - near + 1) * quarter.side_m[1])
        return np.maximum(distance - half, 1e-3), distance + half


class BandBlocks:
    """The blocks of one band that must be examined.

    Attributes
    ----------
    active : (n,) int array
        The blocks.
    rays : (m,) int array
        Open rays that pass them, with a margin.
    compact : (R,) int array
        Position of every ray of the quarter among `rays`, or that of its left neighbour.
    nearest_m, farthest_m : float
        Ground distances between which the blocks lie [m].
    voids : bool
        Whether any cell of the band has no data.
    curves : list of a (4, W) and a (2, W) array
        The quarter's tables for rays, and that for cells, each at the first and the last line; empty if it has none.
    """

    def __init__(self, sweep, active, ends, reach, voids, curves):
        self.active, self.voids, self.curves = active, voids, curves
        self.nearest_m, self.farthest_m = reach[0].min(initial=np.inf), reach[1].max(initial=0.0)
        size = len(sweep.u)
        change = np.bincount(ends[0], minlength=size + 1)
        change -= np.bincount(ends[1] + 1, minlength=size + 1)
        chosen = change[:size].cumsum() > 0
        chosen &= sweep.open
        self.rays = chosen.nonzero()[0]
        compact = chosen.cumsum(dtype=np.int32)
        compact -= 1
        np.maximum(compact, 0, out=compact)
        self.compact = np.minimum(compact, max(len(self.rays) - 2, 0), out=compact)


def bands_of(lines):
    """Slices of a slab's lines that lie in one band each."""
    change = np.flatnonzero(np.diff(lines // BAND)) + 1
    edges = [0, *change, len(lines)]
    return [slice(a, b) for a, b in zip(edges[:-1], edges[1:])]


def _highest(bands):
    """Highest known elevation of each block of each band, and which blocks have voids (None if none has)."""
    columns = np.array([cells.max(axis=0) for cells in bands])
    top = _halved(np.maximum, columns, WIDE)
    void = np.isnan(top)
    if not void.any():
        return top, None
    columns = np.array([np.fmax.reduce(cells, axis=0) for cells in bands])
    columns[np.isnan(columns)] = LOW
    return _halved(np.maximum, columns, WIDE), void


def _halved(function, values, count):
    """Reduce each `count` neighbours along the last axis, a power of two: far faster than a reduction of short axes."""
    while count > 1:
        values, count = function(values[..., ::2], values[..., 1::2]), count // 2
    return values


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
    whole = len(values) // CHUNK * CHUNK
    chunks = -(-len(values) // CHUNK)
    first, last = first // CHUNK, last // CHUNK
    level = np.frexp((last - first + 1).astype(np.float32))[1]
    level -= 1
    table = np.empty((int(level.max(initial=0)) + 1, chunks), values.dtype)
    table[0, : whole // CHUNK] = _halved(np.minimum, values[:whole], CHUNK)
    table[0, whole // CHUNK :] = values[whole:].min(initial=CLOSED)
    for step in range(len(table) - 1):
        half = 1 << step
        np.minimum(table[step, :-half], table[step, half:], out=table[step + 1, :-half])
        table[step + 1, -half:] = table[step, -half:]
    row = level * chunks
    flat = table.reshape(-1)
    lowest = flat.take(row + first)
    last += 1
    last -= np.left_shift(1, level)
    last += row
    return np.minimum(lowest, flat.take(last), out=lowest)
