"""Sample the few ray intervals that may hold the horizon, at a fraction of a cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .horizon_crest import crest
from .horizon_pieces import by_tiles, one_piece, read_pieces
from .horizon_rays import Rays
from .progress import SILENT, checkpoint

BULGE = 0.25
"""The surface between grid lines is looked at where the best sample on them is not this far below the floor [cells]."""

BATCH = 2048
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


def search_intervals(terrain, sight, ray, interval, floor, margin_px, doubtful, progress=SILENT):
    """Find the highest tangent within each of many (ray, interval) pairs.

    Parameters
    ----------
    terrain : HeldTerrain
    sight : Sight
    ray, interval : (J,) int arrays
    floor : (J,) array
        Tangents that the caller has already: intervals that stay well below are not looked at more closely.
    margin_px : int
        How far an interval reaches from its middle, with the interpolation's stencil [cells].
    doubtful : (J,) bool array
        Around which intervals there may be cells without data; around all others there are none.
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
    plain = sight.lines_per_cell == 1
    done = 0
    for jobs, pieces in _pieces(terrain, sight, ray, interval, margin_px):
        for first in range(0, len(jobs), BATCH):
            checkpoint(progress, done / len(ray))
            here = np.arange(first, min(first + BATCH, len(jobs)))
            done += len(here)
            unsure = doubtful[jobs[here]] if plain else np.ones(len(here), bool)
            for place, sample in ((here[~unsure], _sample_crossings), (here[unsure], _sample_all)):
                if len(place) == 0:
                    continue
                part = jobs[place]
                tangent[part], distance[part], void[part] = _sample(
                    sample, pieces.part(place), sight, ray[part], interval[part], floor[part]
                )
    return tangent, distance, void


def _pieces(terrain, sight, ray, interval, margin_px):
    """Yield jobs and the terrain around them."""
    middle = (sight.edge_m[interval] + sight.edge_m[interval + 1]) / 2
    col, row = sight.rays.at_pairs(ray, middle)
    held = terrain.held(row, col, margin_px)
    known, others = np.flatnonzero(held), np.flatnonzero(~held)
    if len(known):
        window, cells = terrain.kept()
        yield known[by_tiles(row[known], col[known], terrain.shape)[0]], one_piece(cells, window, len(known))
    for jobs, pieces in read_pieces(terrain, row[others], col[others], margin_px):
        yield others[jobs], pieces


def _sample(sample, pieces, sight, ray, interval, floor):
    start = sight.edge_m[interval]
    end = np.minimum(sight.edge_m[interval + 1], sight.rays.reach_m[ray])
    ends = *sight.rays.at_pairs(ray, start), *sight.rays.at_pairs(ray, end)
    top, where, void = sample(pieces, sight, ends, start, end)
    near = np.flatnonzero((top > floor - BULGE * sight.cell_m / end) | np.isnan(where))
    if len(near):
        ahead = [place[near] for place in ends], start[near], end[near]
        top[near], where[near] = crest(pieces.part(near), sight, *ahead, top[near], where[near])
    return top, np.where(np.isfinite(top), start + where * (end - start), np.nan), void


def _sample_crossings(pieces, sight, ends, start, end):
    """Highest tangent on the lines of cell centres that each interval crosses, where every cell is known.

    Between two crossings the interpolated surface has no kink, so the highest tangent seldom lies elsewhere.

    Returns
    -------
    tangent, share : (J,) arrays
        -inf and NaN where no line is crossed.
    void : (J,) bool array
        False.
    """
    col0, row0, col1, row1 = ends
    length = (end - start)[:, None]
    top, where = np.full(len(start), -np.inf), np.full(len(start), np.nan)
    for columns, first, last, aside, aside_end in ((True, col0, col1, row0, row1), (False, row0, row1, col0, col1)):
        lowest, highest = np.ceil(np.minimum(first, last)), np.floor(np.maximum(first, last))
        none = highest < lowest
        count = int((highest - lowest).max(initial=-1)) + 1
        if count == 0:
            continue
        with np.errstate(divide="ignore"):
            per_line = np.where(none | (first == last), 0.0, 1 / (last - first))
        highest = np.where(none, np.rint(first), highest)  # some cell of the piece; it is struck out below
        line = np.minimum(lowest[:, None] + np.arange(count), highest[:, None])
        share = (line - first[:, None]) * per_line[:, None]
        distance = length * share
        distance += start[:, None]
        place = (aside_end - aside)[:, None] * share
        place += aside[:, None]
        tangent = sight.tangent(pieces.on_lines_m(line, place, columns), distance)
        tangent[none] = -np.inf
        best = tangent.argmax(axis=1) + np.arange(0, tangent.size, count)
        found = tangent.take(best)
        better = found > top
        top, where = np.where(better, found, top), np.where(better, share.take(best), where)
    return top, where, np.zeros(len(start), bool)


def _sample_all(pieces, sight, ends, start, end):
    """The same on any number of lines per cell, at the intervals' ends too, and with cells that are unknown."""
    share = _shares(sight, *ends)
    col0, row0, col1, row1 = (place[:, None] for place in ends)
    elevation = pieces.elevation_m(row0 + (row1 - row0) * share, col0 + (col1 - col0) * share)
    tangent = sight.tangent(elevation, start[:, None] + (end - start)[:, None] * share)
    unknown = np.isnan(tangent)
    tangent[unknown] = -np.inf
    pick = np.arange(len(start)), tangent.argmax(axis=1)
    return tangent[pick], share[pick], unknown.any(axis=1)


def _shares(sight, col0, row0, col1, row1):
    """Shares of each interval at which it crosses grid lines and their subdivisions: (J, K), unsorted, in [0, 1]."""
    shares = [np.zeros((len(col0), 1)), np.ones((len(col0), 1))]
    for first, last in ((col0, col1), (row0, row1)):
        first, last = first * sight.lines_per_cell, last * sight.lines_per_cell
        lowest = np.ceil(np.minimum(first, last))
        count = int((np.maximum(first, last) - lowest).max(initial=0.0)) + 1
        with np.errstate(divide="ignore", invalid="ignore"):
            share = ((lowest - first)[:, None] + np.arange(count)) / (last - first)[:, None]
        shares.append(np.fmin(np.fmax(share, 0.0), 1.0))  # no crossing: NaN becomes 0
    return np.concatenate(shares, axis=1)
