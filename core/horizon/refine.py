"""Sampling of the few ray intervals that may hold the horizon, at a fraction of a cell."""

from __future__ import annotations

import numpy as np

from ..base.progress import SILENT, checkpoint
from .pieces import by_tiles, one_piece, read_transient_pieces
from .rays import Stretches

BULGE = 0.25
"""The surface between grid lines is examined unless the best sample on them is this far below the floor [cells]."""

BATCH = 2048
"""Intervals sampled at once: some ten thousand samples stay in the processor's cache."""


def search_intervals(terrain, sight, wanted, margin_px, progress=SILENT):
    """Find the highest tangent within each of many (ray, interval) pairs.

    Parameters
    ----------
    terrain : HeldTerrain
    sight : EyeRays
    wanted : IntervalJobs
    margin_px : int
        Distance that an interval reaches from its midpoint, with the interpolation's stencil [cells].
    progress : Progress

    Returns
    -------
    tangent, distance_m : (J,) arrays
        -inf and NaN where no sample is known.
    void : (J,) bool array
        True if a sample of the interval falls on cells without data.
    """
    ray, interval = wanted.ray, wanted.interval
    tangent, distance = np.full(len(ray), -np.inf), np.full(len(ray), np.nan)
    void = np.zeros(len(ray), bool)
    plain = sight.lines_per_cell == 1
    done = 0
    for jobs, pieces in _pieces(terrain, sight, ray, interval, margin_px):
        for first in range(0, len(jobs), BATCH):
            checkpoint(progress, done / len(ray))
            here = np.arange(first, min(first + BATCH, len(jobs)))
            done += len(here)
            unsure = wanted.doubtful[jobs[here]] if plain else np.ones(len(here), bool)
            for place, sample in ((here[~unsure], _sample_crossings), (here[unsure], _sample_all)):
                if len(place) == 0:
                    continue
                part = jobs[place]
                stretches = _stretches(sight, ray[part], interval[part])
                tangent[part], distance[part], void[part] = _sample(
                    sample, pieces.part(place), sight, stretches, wanted.floor[part]
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
    for jobs, pieces in read_transient_pieces(terrain, row[others], col[others], margin_px):
        yield others[jobs], pieces


def _stretches(sight, ray, interval):
    start = sight.edge_m[interval]
    end = np.minimum(sight.edge_m[interval + 1], sight.rays.reach_m[ray])
    return Stretches((*sight.rays.at_pairs(ray, start), *sight.rays.at_pairs(ray, end)), start, end)


def _sample(sample, pieces, sight, stretches, floor):
    start, end = stretches.start_m, stretches.end_m
    top, where, void = sample(pieces, sight, stretches)
    near = np.flatnonzero((top > floor - BULGE * sight.cell_m / end) | np.isnan(where))
    if len(near):
        top[near], where[near] = crest(pieces.part(near), sight, stretches.part(near), top[near], where[near])
    return top, np.where(np.isfinite(top), start + where * (end - start), np.nan), void


def _sample_crossings(pieces, sight, stretches):
    """Find the highest tangent on the lines of cell centres that each interval crosses, if every cell is known.

    Between two crossings the interpolated surface has no kink, so the highest tangent seldom lies elsewhere.

    Returns
    -------
    tangent, share : (J,) arrays
        -inf and NaN if no line is crossed.
    void : (J,) bool array
        Always False.
    """
    col0, row0, col1, row1 = stretches.ends
    start = stretches.start_m
    length = (stretches.end_m - start)[:, None]
    top, where = np.full(len(start), -np.inf), np.full(len(start), np.nan)
    for columns, first, last, aside, aside_end in ((True, col0, col1, row0, row1), (False, row0, row1, col0, col1)):
        lowest, highest = np.ceil(np.minimum(first, last)), np.floor(np.maximum(first, last))
        none = highest < lowest
        count = int((highest - lowest).max(initial=-1)) + 1
        if count == 0:
            continue
        with np.errstate(divide="ignore"):
            per_line = np.where(none | (first == last), 0.0, 1 / (last - first))
        highest = np.where(none, np.rint(first), highest)  # some cell of the piece; it is removed below
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


def _sample_all(pieces, sight, stretches):
    """Find the same with any number of lines per cell, at the intervals' ends too, and with cells that are unknown."""
    ends, start, end = stretches.ends, stretches.start_m, stretches.end_m
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


HAIR = 1e-9
"""A sample this close to a grid line counts as lying on it [cells]."""


def crest(pieces, sight, stretches, top, where):
    """Find the highest tangent between the two grid lines around each interval's best sample.

    Along a ray the bilinear surface of one cell is a parabola. Three samples determine it, and the point at which a
    line from the eye touches it follows in closed form.

    Parameters
    ----------
    pieces : Pieces
    sight : EyeRays
    stretches : Stretches
    top, where : (J,) arrays
        Highest tangent so far, and the share of the interval at which it lies; NaN if the interval crosses no line.

    Returns
    -------
    top, where : (J,) arrays
    """
    ends, start, end = stretches.ends, stretches.start_m, stretches.end_m
    nodes = _lines_around(ends, where)
    share = np.empty((len(top), 2 * nodes.shape[1] - 1))
    share[:, ::2], share[:, 1::2] = nodes, (nodes[:, 1:] + nodes[:, :-1]) / 2
    col0, row0, col1, row1 = (place[:, None] for place in ends)
    distance = start[:, None] + (end - start)[:, None] * share
    height = pieces.elevation_m(row0 + (row1 - row0) * share, col0 + (col1 - col0) * share) - sight.eye_m
    three = slice(0, -2, 2), slice(1, None, 2), slice(2, None, 2)
    heights, distances = (tuple(values[:, part] for part in three) for values in (height, distance))
    along, between = _touch(heights, distances, sight.drop_per_m2)
    share = np.concatenate([share, nodes[:, :-1] + np.diff(nodes) * along], axis=1)
    tangent = np.concatenate([height / distance - sight.drop_per_m2 * distance, between], axis=1)
    tangent[np.isnan(tangent)] = -np.inf
    pick = np.arange(len(top)), tangent.argmax(axis=1)
    better = tangent[pick] > top
    return np.where(better, tangent[pick], top), np.where(better, share[pick], where)


def _lines_around(ends, where):
    """Shares of each interval at which grid lines are crossed around one share: (J, 5), itself in the middle."""
    middle = np.where(np.isnan(where), 0.5, where)
    lines = [middle]
    for way in (1, -1):
        nearest, next_one = np.full(len(middle), np.inf), np.full(len(middle), np.inf)
        for first, last in zip(ends[:2], ends[2:]):
            step = (last - first) * way
            place = first + (last - first) * middle
            with np.errstate(divide="ignore"):
                line = np.where(step > 0, np.floor(place + HAIR) + 1 - place, place - np.ceil(place - HAIR) + 1)
                line, again = line / np.abs(step), 1 / np.abs(step)
            next_one = np.minimum(np.maximum(nearest, line), np.minimum(next_one, line + again))
            nearest = np.minimum(nearest, line)
        lines.append(middle + way * nearest)
        lines.append(middle + way * next_one)
    first, ahead, far_ahead, behind, far_behind = lines
    return np.clip(np.stack([far_behind, behind, first, ahead, far_ahead], axis=1), 0.0, 1.0)


def _touch(heights_m, distances_m, drop_per_m2):
    """Find the point at which the line of sight over a parabola touches it.

    Parameters
    ----------
    heights_m, distances_m : three arrays each
        Heights above the eye at the start, the middle and the end of a stretch, and the distances there [m].
    drop_per_m2 : float

    Returns
    -------
    along, tangent : arrays
        Share of the stretch, and tangent of the elevation angle there; NaN if no line touches it from above.
    """
    (first, middle, last), (near, _, far) = heights_m, distances_m
    reach = far - near
    slope, bend = 4 * middle - 3 * first - last, 2 * (first + last - 2 * middle)
    # (first + slope u + bend u^2) / d - drop d with d = near + reach u has its extremes where the numerator of its
    # derivative, written in d, is zero: (bend - drop reach^2) (reach u^2 + 2 near u) + rest = 0.
    bent = bend - drop_per_m2 * reach**2
    rest = slope * near - reach * first - drop_per_m2 * reach * near**2
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = -rest / np.where(bent < 0, bent, np.nan)  # if it bends upwards, the highest point is one of the ends
        along = ratio / (np.sqrt(near**2 + reach * ratio) + near)
        along = np.where((along > 0) & (along < 1), along, np.nan)
        at = near + reach * along
        return along, (first + (slope + bend * along) * along) / at - drop_per_m2 * at
