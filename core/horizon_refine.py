"""Sample the few ray intervals that may hold the horizon, at a fraction of a cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .horizon_pieces import one_piece, read_pieces
from .horizon_rays import Rays
from .progress import SILENT, checkpoint

BULGE = 5e-4
"""Samples between those on grid lines are tried where the best of these comes this near to the floor [tangent]."""

BATCH = 512
"""Intervals sampled at once: some ten thousand samples stay in the processor's cache."""


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
    for jobs, pieces in _pieces(terrain, sight, ray, interval, margin_px, whole):
        for first in range(0, len(jobs), BATCH):
            checkpoint(progress, done / len(ray))
            here = slice(first, first + BATCH)
            part = jobs[here]
            done += len(part)
            tangent[part], distance[part], void[part] = _sample(
                pieces.part(here), sight, ray[part], interval[part], floor[part]
            )
    return tangent, distance, void


def _pieces(terrain, sight, ray, interval, margin_px, whole):
    """Yield jobs and the terrain around them."""
    if whole is not None:
        yield np.arange(len(ray)), one_piece(terrain.read(whole), whole, len(ray))
        return
    middle = (sight.edge_m[interval] + sight.edge_m[interval + 1]) / 2
    col, row = sight.rays.at_pairs(ray, middle)
    yield from read_pieces(terrain, row, col, margin_px)


def _sample(pieces, sight, ray, interval, floor):
    start = sight.edge_m[interval]
    end = np.minimum(sight.edge_m[interval + 1], sight.rays.reach_m[ray])
    ends = *sight.rays.at_pairs(ray, start), *sight.rays.at_pairs(ray, end)
    share = _shares(sight, *ends)
    tangent, void = _tangents(pieces, sight, ends, start, end, share)
    best = tangent.argmax(axis=1)
    pick = np.arange(len(ray))
    top, where = tangent[pick, best], share[pick, best]
    # Once more around the best sample: between two lines the surface may bulge.
    near = np.flatnonzero(top > floor - BULGE)
    if len(near):
        gap = sight.cell_m / (sight.lines_per_cell * np.maximum(end - start, sight.cell_m))[near]
        around = where[near, None] + gap[:, None] * (np.arange(-7, 8) / 8)
        around = np.minimum(np.maximum(around, 0.0), 1.0)
        close = [place[near] for place in ends]
        finer, _ = _tangents(pieces.part(near), sight, close, start[near], end[near], around)
        again = finer.argmax(axis=1)
        pick = np.arange(len(near))
        better = finer[pick, again] > top[near]
        top[near] = np.where(better, finer[pick, again], top[near])
        where[near] = np.where(better, around[pick, again], where[near])
    return top, np.where(np.isfinite(top), start + where * (end - start), np.nan), void


def _shares(sight, col0, row0, col1, row1):
    """Shares of each interval at which it crosses grid lines and their subdivisions: (J, K), unsorted, in [0, 1].

    Between two crossings the interpolated surface has no kink, so the highest tangent seldom lies elsewhere.
    """
    shares = [np.zeros((len(col0), 1)), np.ones((len(col0), 1))]
    for first, last in ((col0, col1), (row0, row1)):
        first, last = first * sight.lines_per_cell, last * sight.lines_per_cell
        lowest = np.ceil(np.minimum(first, last))
        count = int((np.maximum(first, last) - lowest).max(initial=0.0)) + 1
        with np.errstate(divide="ignore", invalid="ignore"):
            share = ((lowest - first)[:, None] + np.arange(count)) / (last - first)[:, None]
        shares.append(np.fmin(np.fmax(share, 0.0), 1.0))  # no crossing: NaN becomes 0
    return np.concatenate(shares, axis=1)


def _tangents(pieces, sight, ends, start, end, share):
    """Tangents of samples between the intervals' ends, -inf where unknown, and which intervals meet a void."""
    col0, row0, col1, row1 = ends
    distance = start[:, None] + (end - start)[:, None] * share
    col = col0[:, None] + (col1 - col0)[:, None] * share
    row = row0[:, None] + (row1 - row0)[:, None] * share
    tangent = sight.tangent(pieces.elevation_m(row, col), distance)
    unknown = np.isnan(tangent)
    tangent[unknown] = -np.inf
    return tangent, unknown.any(axis=1)
