"""Sample the few ray intervals that may hold the horizon, at a fraction of a cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .horizon_rays import Rays
from .progress import SILENT, checkpoint
from .terrain import Window, bilinear

TILE = 512
"""Side of the pieces in which surviving terrain is read again [cells]."""

BULGE = 5e-4
"""Samples between those on grid lines are tried where the best of these comes this near to the floor [tangent]."""

BATCH = 2048
"""Intervals sampled at once: a few hundred thousand samples stay in the processor's cache."""


@dataclass(frozen=True, eq=False)
class Sight:
    """What every tangent needs: rays, interval edges, eye and curvature.

    Attributes
    ----------
    rays : Rays
    edge_m : (N + 1,) array
        Ground distances that divide each ray into intervals [m].
    eye_m : float
        Elevation of the eye [m].
    drop_per_m2 : float
        Apparent drop over distance squared [1/m].
    lines_per_cell : int
        Grid lines per cell, in columns and in rows, on which samples lie.
    cell_m : float
        Ground size of a cell [m].
    """

    rays: Rays
    edge_m: np.ndarray
    eye_m: float
    drop_per_m2: float
    lines_per_cell: int
    cell_m: float

    def tangent(self, elevation_m, distance_m):
        """Tangent of the elevation angle under which terrain at a distance is seen."""
        return (elevation_m - self.eye_m) / distance_m - self.drop_per_m2 * distance_m


def search_intervals(terrain, sight, ray, interval, floor, margin_px, whole=None, progress=SILENT):
    """Find the highest tangent within each of many (ray, interval) pairs.

    Parameters
    ----------
    terrain : Terrain
    sight : Sight
    ray, interval : (J,) int arrays
    floor : (J,) array
        Tangents that the caller has already: intervals that stay well below are not looked at more closely.
    margin_px : int
        How far an interval reaches from its middle, with the interpolation's stencil [cells].
    whole : Window or None
        Take all cells from this one window (they are in memory); otherwise read tile by tile.
    progress : Progress

    Returns
    -------
    tangent, distance_m : (J,) arrays
        -inf and NaN where no sample is known.
    void : (J,) bool array
        A sample of the interval falls on cells without data.
    """
    tangent, distance = np.full(len(ray), -np.inf), np.full(len(ray), np.nan)
    void = np.zeros(len(ray), bool)
    done = 0
    for jobs, window in _by_tile(terrain, sight, ray, interval, margin_px, whole):
        cells = terrain.read(window)
        for first in range(0, len(jobs), BATCH):
            checkpoint(progress, done / len(ray))
            part = jobs[first : first + BATCH]
            done += len(part)
            tangent[part], distance[part], void[part] = _sample(
                cells, window, sight, ray[part], interval[part], floor[part]
            )
    return tangent, distance, void


def _by_tile(terrain, sight, ray, interval, margin_px, whole):
    """Group jobs by the tile under their middle: yields (job indices, window to read)."""
    if len(ray) == 0:
        return
    if whole is not None:
        yield np.arange(len(ray)), whole
        return
    middle = (sight.edge_m[interval] + sight.edge_m[interval + 1]) / 2
    col, row = sight.rays.at_pairs(ray, middle)
    rows, cols = terrain.shape
    tile_row = np.clip(row, 0, rows - 1).astype(np.intp) // TILE
    tile_col = np.clip(col, 0, cols - 1).astype(np.intp) // TILE
    key = tile_row * (cols // TILE + 1) + tile_col
    order = np.argsort(key, kind="stable")
    for jobs in np.split(order, np.flatnonzero(np.diff(key[order])) + 1):
        # The smallest rectangle that holds the jobs, so that a lone ridge does not cost a whole tile.
        top, bottom = row[jobs].min() - margin_px, row[jobs].max() + margin_px + 1
        left, right = col[jobs].min() - margin_px, col[jobs].max() + margin_px + 1
        window = Window(int(top) - 1, int(left) - 1, int(bottom - top) + 3, int(right - left) + 3)
        yield jobs, window.clipped(terrain.shape)


def _sample(cells, window, sight, ray, interval, floor):
    start = sight.edge_m[interval]
    end = np.minimum(sight.edge_m[interval + 1], sight.rays.reach_m[ray])
    share = _shares(sight, ray, start, end)
    tangent, void = _tangents(cells, window, sight, ray, start, end, share)
    best = tangent.argmax(axis=1)
    pick = np.arange(len(ray))
    top, where = tangent[pick, best], share[pick, best]
    # Once more around the best sample: between two lines the surface may bulge.
    near = np.flatnonzero(top > floor - BULGE)
    if len(near):
        gap = sight.cell_m / (sight.lines_per_cell * np.maximum(end - start, sight.cell_m))[near]
        around = np.clip(where[near, None] + gap[:, None] * (np.arange(-7, 8) / 8), 0.0, 1.0)
        finer, _ = _tangents(cells, window, sight, ray[near], start[near], end[near], around)
        again = finer.argmax(axis=1)
        pick = np.arange(len(near))
        better = finer[pick, again] > top[near]
        top[near] = np.where(better, finer[pick, again], top[near])
        where[near] = np.where(better, around[pick, again], where[near])
    return top, np.where(np.isfinite(top), start + where * (end - start), np.nan), void


def _shares(sight, ray, start, end):
    """Shares of each interval at which it crosses grid lines and their subdivisions: (J, K), unsorted, in [0, 1].

    Between two crossings the interpolated surface has no kink, so the highest tangent seldom lies elsewhere.
    """
    ends = zip(sight.rays.at_pairs(ray, start), sight.rays.at_pairs(ray, end))
    shares = [np.zeros((len(ray), 1)), np.ones((len(ray), 1))]
    for first, last in ends:
        first, last = first * sight.lines_per_cell, last * sight.lines_per_cell
        lowest = np.ceil(np.minimum(first, last))
        count = int((np.maximum(first, last) - lowest).max(initial=0.0)) + 2
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (lowest[:, None] + np.arange(count) - first[:, None]) / (last - first)[:, None]
        shares.append(np.nan_to_num(np.clip(share, 0.0, 1.0), nan=0.0))
    return np.concatenate(shares, axis=1)


def _tangents(cells, window, sight, ray, start, end, share):
    """Tangents of samples between the intervals' ends, -inf where unknown, and which intervals meet a void."""
    col0, row0 = sight.rays.at_pairs(ray, start)
    col1, row1 = sight.rays.at_pairs(ray, end)
    distance = start[:, None] + (end - start)[:, None] * share
    col = col0[:, None] + (col1 - col0)[:, None] * share
    row = row0[:, None] + (row1 - row0)[:, None] * share
    tangent = sight.tangent(_interpolate(cells, window, row, col), distance)
    unknown = np.isnan(tangent)
    tangent[unknown] = -np.inf
    return tangent, unknown.any(axis=1)


def _interpolate(cells, window, row, col):
    """`bilinear` at pixels of the whole raster, faster where the window has at least two rows and columns.

    Shares are taken before the window's origin is subtracted: the result is the same to the last bit whichever
    window the cells come from.
    """
    rows, cols = cells.shape
    if rows < 2 or cols < 2:
        return bilinear(cells, row - window.row, col - window.col)
    row0, col0 = np.floor(row), np.floor(col)
    r0, c0 = (row0 - window.row).astype(np.intp), (col0 - window.col).astype(np.intp)
    row_share, col_share = row - row0, col - col0
    for first, share, count in ((r0, row_share, rows), (c0, col_share, cols)):
        before, after = first < 0, first > count - 2  # half a cell beyond the outer centres, or just on the last
        share[before], first[before] = 0.0, 0
        share[after], first[after] = 1.0, count - 2
    if cells.flags.c_contiguous:
        flat, corner = cells.reshape(-1), r0 * cols + c0
        values = [flat.take(corner + offset) for offset in (0, 1, cols, cols + 1)]
    else:
        values = [cells[r0, c0], cells[r0, c0 + 1], cells[r0 + 1, c0], cells[r0 + 1, c0 + 1]]
    upper = values[0] + (values[1] - values[0]) * col_share
    lower = values[2] + (values[3] - values[2]) * col_share
    elevation = upper + (lower - upper) * row_share
    unknown = np.isnan(elevation)
    if unknown.any():  # a cell without weight does not make the sample unknown
        elevation[unknown] = bilinear(cells, row[unknown] - window.row, col[unknown] - window.col)
    return elevation
