"""Branch and bound over the intervals of all rays: sample only where the horizon can be."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .horizon_refine import search_intervals
from .progress import SILENT, checkpoint, subtask

CHUNK_PAIRS = 30_000
"""(Ray, interval) pairs whose bounds are computed at once."""

NEAR_CELLS = 39
"""Ground this near is sampled twice as closely. Its bounds are too loose to tell where the horizon is likely."""

QUARTERS = 4


class Search:
    """Branch and bound over all (ray, interval) pairs."""

    def __init__(self, terrain, sight, blocks, summit_m, whole):
        self.terrain, self.sight, self.blocks, self.summit_m, self.whole = terrain, sight, blocks, summit_m, whole
        count = len(sight.rays.azimuth_deg)
        self.tangent, self.distance = np.full(count, -np.inf), np.full(count, np.nan)

    def run(self, cell_m, progress):
        """Search all rays.

        Returns
        -------
        tangent, distance_m : (A,) arrays
            -inf and NaN where nothing is known.
        void : (A,) bool array
        known_m : (A,) array
            Where the data end [m].
        """
        bound = self._bounds(progress)
        near = max(1, round(NEAR_CELLS * cell_m / (self.sight.edge_m[1] - self.sight.edge_m[0])))
        # The most promising intervals of the distance first: they raise the bar for all others.
        self._refine(_highest_two(bound, near) & (bound > -np.inf), bound, subtask(progress, 0.3, 0.5))
        # Close by, a cell's curved surface can stand well above all its crossings: look there twice as closely.
        close = replace(self.sight, lines_per_cell=2 * self.sight.lines_per_cell)
        nearby = self._alive(bound)
        nearby[:, near:] = False
        self._refine(nearby, bound, subtask(progress, 0.5, 0.6), close)
        self._refine(self._alive(bound), bound, subtask(progress, 0.6, 0.9))
        return (self.tangent, self.distance, *self._voids(progress))

    def _alive(self, bound):
        least = np.maximum(self.tangent + 1e-7, -1e30)  # what is known to be empty has a bound of -inf
        return bound > np.nextafter(least.astype(np.float32), np.float32(-np.inf))[:, None]

    def _bounds(self, progress):
        """(A, N) float32 upper bounds of the tangent; -inf where there is nothing to see."""
        edge = self.sight.edge_m
        count = len(self.sight.rays.azimuth_deg), len(edge) - 1
        bound = np.empty(count, np.float32)
        for rays, row, col in self._block_indices(progress):
            bound[rays] = _tangent_bound(
                self.blocks.highest_m[row, col] - self.sight.eye_m, edge[:-1], edge[1:], self.sight.drop_per_m2
            )
        bound[edge[:-1] >= self.sight.rays.reach_m[:, None]] = -np.inf
        return bound

    def _block_indices(self, progress=SILENT):
        """Yield (slice of rays, block rows, block columns) under the middles of the intervals."""
        middle = (self.sight.edge_m[:-1] + self.sight.edge_m[1:]) / 2
        total = len(self.sight.rays.azimuth_deg)
        size = max(1, CHUNK_PAIRS // len(middle))
        for first in range(0, total, size):
            checkpoint(progress, 0.3 * first / total)
            rays = slice(first, first + size)
            col, row = self.sight.rays.at(middle, rays)
            yield (rays, *self.blocks.index(col, row))

    def _refine(self, chosen, bound, progress, sight=None):
        """Sample the chosen pairs, raise the running maxima, and strike the pairs off the bounds."""
        ray, interval = np.nonzero(chosen)
        bound[ray, interval] = -np.inf
        if sight is None:
            alive = self._closer_bound(ray, interval) > self.tangent[ray] + 1e-7
            ray, interval = ray[alive], interval[alive]
        tangent, distance, _ = search_intervals(
            self.terrain,
            sight or self.sight,
            ray,
            interval,
            self.tangent[ray],
            self.blocks.block,
            self.whole,
            progress,
        )
        if len(ray) == 0:
            return
        order = np.lexsort((tangent, ray))
        last = order[np.append(np.diff(ray[order]) > 0, True)]
        better = tangent[last] > self.tangent[ray[last]]
        last = last[better]
        self.tangent[ray[last]], self.distance[ray[last]] = tangent[last], distance[last]

    def _closer_bound(self, ray, interval):
        """Upper bounds again, of the intervals' quarters and from no more blocks than lie around these: (J,)."""
        sight, block = self.sight, self.blocks.block
        start = sight.edge_m[interval]
        stop = np.minimum(sight.edge_m[interval + 1], sight.rays.reach_m[ray])
        edges = start + (stop - start) * np.linspace(0.0, 1.0, QUARTERS + 1)[:, None]
        col, row = sight.rays.at_pairs(ray, (edges[1:] + edges[:-1]) / 2)
        half_px = (block - 1.5) / QUARTERS + 1.01  # of a quarter, and the interpolation's stencil
        height = self.blocks.highest_around(col, row, half_px) - sight.eye_m
        return _tangent_bound(height, edges[:-1], edges[1:], sight.drop_per_m2).max(axis=0)

    def _voids(self, progress):
        """Per azimuth: a void might hide a higher horizon; and where the data end [m]."""
        reach = self.sight.rays.reach_m
        void, known_m = np.zeros(len(reach), bool), reach.copy()
        if not self.blocks.has_void.any():
            return void, known_m
        edge = self.sight.edge_m
        start, stop = edge[:-1], edge[1:]
        could = _tangent_bound(self.summit_m - self.sight.eye_m, start, stop, self.sight.drop_per_m2)
        unsure = np.zeros((len(reach), len(start)), bool)
        for rays, row, col in self._block_indices():
            within = start < reach[rays, None]
            empty = self.blocks.all_void[row, col]
            known = within & ~empty
            last = known.shape[1] - 1 - known[:, ::-1].argmax(axis=1)
            last = np.where(known.any(axis=1), last, -1)
            known_m[rays] = np.minimum(reach[rays], np.where(last < 0, start[0], stop[last]))
            before = (np.arange(len(start)) < last[:, None]) & (could > self.tangent[rays, None])
            void[rays] = (before & empty).any(axis=1)
            unsure[rays] = before & ~empty & self.blocks.has_void[row, col] & ~void[rays, None]
        ray, interval = np.nonzero(unsure)
        _, _, meets = search_intervals(
            self.terrain,
            self.sight,
            ray,
            interval,
            self.tangent[ray],
            self.blocks.block,
            self.whole,
            subtask(progress, 0.9, 1.0),
        )
        void[ray[meets]] = True
        return void, known_m


def _highest_two(bound, start):
    """Mask of the two highest values in each row, from a column on."""
    chosen, row = np.zeros(bound.shape, bool), np.arange(len(bound))
    if start >= bound.shape[1]:
        return chosen
    first = start + bound[:, start:].argmax(axis=1)
    kept = bound[row, first]
    bound[row, first] = -np.inf
    second = start + bound[:, start:].argmax(axis=1)
    bound[row, first] = kept
    chosen[row, first] = chosen[row, second] = True
    return chosen


def _tangent_bound(height_m, start_m, stop_m, drop_per_m2):
    """Highest tangent that terrain `height_m` above the eye can have between two distances."""
    bound = height_m * (1.0 / start_m)  # the higher of the two where the terrain stands above the eye
    np.maximum(bound, height_m * (1.0 / stop_m), out=bound)
    bound -= drop_per_m2 * start_m
    return bound
