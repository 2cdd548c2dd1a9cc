"""Summits: found in a DEM by their prominence, or given with names and moved to the DEM's own tops.

Prominence is the height of a summit above the highest saddle that joins it to higher ground. Every cell is assigned to
the top that it reaches going uphill. Where two hills touch, their highest pass is their saddle. Hills are merged from
the highest saddle down, and each merger determines the prominence of the lower summit.

References
----------
.. [1] Kirmse, A., de Ferranti, J., Calculating the prominence and isolation of every mountain in the world,
   Progress in Physical Geography 41 (2017) 788-802, doi:10.1177/0309133317738163.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ..base.terrain import Window

HEIGHT_WEIGHT = 3.0
"""One metre of elevation difference counts as much as this many metres of distance when summits are matched."""

OWN_CELLS, OWN_M = 3.0, 100.0
"""Ground this close to a summit, in cells or metres, whichever is more, belongs to its top."""


def own_ground_m(frame):
    """Distance within which ground belongs to a summit on this DEM [m]; see `Places.own_ground_m`."""
    return max(OWN_CELLS * frame.cell_m, OWN_M)


@dataclass(frozen=True, eq=False)
class Summits:
    """Summits of a window, highest prominence first.

    Attributes
    ----------
    row, col : (N,) int arrays
        Cells of the window.
    elevation_m : (N,) array
        Elevations [m].
    prominence_m : (N,) array
        Height above the key saddle [m]; for the window's highest ground, and for ground that voids cut off, above the
        lowest cell that belongs to it.
    """

    row: np.ndarray
    col: np.ndarray
    elevation_m: np.ndarray
    prominence_m: np.ndarray


def find_summits(elevation_m, min_prominence_m=100.0):
    """Find the summits of a window by prominence.

    Parameters
    ----------
    elevation_m : (R, C) array
        Elevations [m], NaN in voids.
    min_prominence_m : float
        Smallest prominence that is kept [m].

    Returns
    -------
    Summits
        Terrain beyond the window is unknown: a summit near its edge may be less prominent than stated here.
    """
    z = np.asarray(elevation_m, np.float32)
    top = _tops(z)
    saddle, left, right = _saddles(z, top)
    summit, prominence = _merge(z.ravel(), top, saddle, left, right)
    keep = prominence >= min_prominence_m
    summit, prominence = summit[keep], prominence[keep]
    order = np.lexsort((-z.ravel()[summit], -prominence))
    row, col = np.divmod(summit[order], z.shape[1])
    return Summits(row, col, z.ravel()[summit[order]].astype(float), prominence[order])


def _neighbours(shape):
    """Pairs of slices that compare each cell with four of its eight neighbours, with the offset in flat cells."""
    whole, first, last = slice(None), slice(None, -1), slice(1, None)
    return (
        ((whole, first), (whole, last), 1),
        ((first, whole), (last, whole), shape[1]),
        ((first, first), (last, last), shape[1] + 1),
        ((first, last), (last, first), shape[1] - 1),
    )


def _tops(z):
    """Flat index of the top that each cell reaches along the steepest ascent, -1 in voids.

    Equal neighbours are ranked by their index, so that a plateau has one top.
    """
    flat = np.arange(z.size).reshape(z.shape)
    best, best_z = flat.copy(), np.where(np.isfinite(z), z, -np.inf)
    known = best_z.copy()
    for a, b, step in _neighbours(z.shape):
        for here, there, sign in ((a, b, step), (b, a, -step)):
            higher = (known[there] > best_z[here]) | ((known[there] == best_z[here]) & (flat[there] > best[here]))
            higher &= np.isfinite(known[there])
            best[here] = np.where(higher, flat[here] + sign, best[here])
            best_z[here] = np.where(higher, known[there], best_z[here])
    target = best.ravel()
    while True:
        further = target[target]
        if np.array_equal(further, target):
            break
        target = further
    return np.where(np.isfinite(z).ravel(), target, -1)


def _saddles(z, top):
    """Highest pass between each pair of touching hills: (elevation, top, top), highest first."""
    top = top.reshape(z.shape)
    passes, lower, upper = [], [], []
    for a, b, _ in _neighbours(z.shape):
        meet = (top[a] != top[b]) & (top[a] >= 0) & (top[b] >= 0)
        passes.append(np.minimum(z[a], z[b])[meet])
        lower.append(np.minimum(top[a], top[b])[meet])
        upper.append(np.maximum(top[a], top[b])[meet])
    passes, lower, upper = (np.concatenate(part) for part in (passes, lower, upper))
    order = np.lexsort((-passes, upper, lower))
    passes, lower, upper = passes[order], lower[order], upper[order]
    first = np.ones(passes.size, bool)
    first[1:] = (lower[1:] != lower[:-1]) | (upper[1:] != upper[:-1])
    passes, lower, upper = passes[first], lower[first], upper[first]
    order = np.argsort(-passes, kind="stable")
    return passes[order], lower[order], upper[order]


def _merge(z, top, saddle, left, right):
    """Merge hills from the highest saddle down (union-find) and return each summit and its prominence.

    `scipy.sparse.csgraph` cannot replace this: its spanning tree gives the saddles that join hills, but not which hill
    was the lower at the merger, and that determines the prominence.
    """
    summits = np.unique(top[top >= 0])
    number = np.full(z.size, -1)
    number[summits] = np.arange(summits.size)
    parent = list(range(summits.size))
    height = z[summits].astype(float)
    prominence = np.full(summits.size, np.nan)

    def root(k):
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    for pass_m, a, b in zip(saddle.tolist(), number[left].tolist(), number[right].tolist()):
        a, b = root(a), root(b)
        if a != b:
            low, high = (a, b) if (height[a], a) < (height[b], b) else (b, a)
            prominence[low] = height[low] - pass_m
            parent[low] = high
    foot = np.full(summits.size, np.inf)
    member = top >= 0
    roots = np.array([root(k) for k in range(summits.size)], dtype=np.intp)
    np.minimum.at(foot, roots[number[top[member]]], z[member])
    last = ~np.isfinite(prominence)
    prominence[last] = (height - foot)[last]
    return summits, prominence


def snap_to_summit(terrain, frame, east_m, north_m, elevation_m=None, radius_m=500.0):
    """Move a named summit to the DEM's own top; published places and coarse DEMs differ by hundreds of metres.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
    east_m, north_m : float
        Published place in local metres [m].
    elevation_m : float or None
        Published height [m]. With it, the top within `radius_m` that is closest in place and height is taken; without
        it, the highest cell within a third of `radius_m`.
    radius_m : float
        Search radius [m].

    Returns
    -------
    east_m, north_m, elevation_m : float
        Place and elevation of the DEM's cell; the elevation is NaN if no cell is known.
    """
    known = elevation_m is not None and np.isfinite(elevation_m)
    reach = max(radius_m if known else radius_m / 3, 0.71 * frame.cell_m)
    east, north, z, is_top = _cells_around(terrain, frame, east_m, north_m, reach)
    distance = np.hypot(east - east_m, north - north_m)
    near = np.isfinite(z) & (distance <= reach)
    if not near.any():
        return float(east_m), float(north_m), float("nan")
    if known:
        tops = near & is_top if (near & is_top).any() else near
        cost = np.where(tops, distance + HEIGHT_WEIGHT * np.abs(z - elevation_m), np.inf)
    else:
        cost = np.where(near, -z, np.inf)
    best = np.unravel_index(np.argmin(cost), cost.shape)
    return float(east[best]), float(north[best]), float(z[best])


def _cells_around(terrain, frame, east_m, north_m, reach_m):
    """Local positions and elevations of the cells around a place, and which are as high as their neighbours."""
    col, row = (float(value) for value in frame.to_pixel(east_m, north_m))
    side_col, side_row = (int(np.ceil(reach_m / size)) + 2 for size in frame.cell_size_m)
    window = Window(round(row) - side_row, round(col) - side_col, 2 * side_row + 1, 2 * side_col + 1)
    window = window.clipped(terrain.shape)
    if window.rows < 1 or window.cols < 1:
        return (np.zeros((0, 0)),) * 3 + (np.zeros((0, 0), bool),)
    z = terrain.read(window)
    rows, cols = np.mgrid[window.row : window.row + window.rows, window.col : window.col + window.cols]
    filled = np.where(np.isfinite(z), z, -np.inf)
    return (*frame.to_local(cols, rows), z, filled >= ndimage.maximum_filter(filled, size=3, mode="nearest"))


def summits_around(terrain, frame, max_distance_m, min_prominence_m, most_cells=4_000_000):
    """Find the summits around an eye.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
    max_distance_m : float
        Search radius [m].
    min_prominence_m : float
        Smallest prominence that is kept [m].
    most_cells : int
        A larger window is searched in block maxima, and its summits are then placed within their blocks.

    Returns
    -------
    list of (east_m, north_m, elevation_m, prominence_m)
        Highest prominence first; positions in local metres.
    """
    window = _window_around(terrain, frame, max_distance_m)
    if window.rows < 1 or window.cols < 1:
        return []
    block = int(np.ceil(np.sqrt(window.rows * window.cols / most_cells)))
    summits = find_summits(_block_maxima(terrain, window, block), min_prominence_m)
    found = []
    for row, col, top, prominence in zip(summits.row, summits.col, summits.elevation_m, summits.prominence_m):
        r, c = window.row + row * block, window.col + col * block
        if block > 1:
            cells = terrain.read(Window(int(r), int(c), block, block).clipped(terrain.shape))
            inner = np.unravel_index(np.nanargmax(cells), cells.shape)
            r, c = r + inner[0], c + inner[1]
        east, north = (float(v) for v in frame.to_local(c, r))
        if np.hypot(east, north) <= max_distance_m:
            found.append((east, north, float(top), float(prominence)))
    return found


def _window_around(terrain, frame, max_distance_m):
    turn = np.radians(np.arange(0, 360, 2))
    col, row = frame.to_pixel(max_distance_m * np.sin(turn), max_distance_m * np.cos(turn))
    top, left = int(np.floor(row.min())), int(np.floor(col.min()))
    return Window(top, left, int(np.ceil(row.max())) + 1 - top, int(np.ceil(col.max())) + 1 - left).clipped(
        terrain.shape
    )


def _block_maxima(terrain, window, block):
    """Highest known cell of each block, NaN if there is none; read in strips."""
    if block == 1:
        return terrain.read(window)
    out = np.full((-(-window.rows // block), -(-window.cols // block)), np.nan, np.float32)
    columns = np.arange(0, window.cols, block)
    for k in range(out.shape[0]):
        rows = min(block, window.rows - k * block)
        strip = terrain.read(Window(window.row + k * block, window.col, rows, window.cols))
        highest = np.fmax.reduce(strip, axis=0)
        out[k] = np.fmax.reduceat(highest, columns)
    return out
