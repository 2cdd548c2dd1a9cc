"""Branch and bound over the intervals of all rays: only intervals that can hold the horizon are sampled."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.progress import SILENT, checkpoint, subtask
from ..base.terrain import Window
from .blocks import highest_close_by
from .rays import IntervalJobs
from .refine import search_intervals

CHUNK_PAIRS = 30_000
"""(Ray, interval) pairs whose bounds are computed at once."""

NEAR_CELLS = 39
"""Ground within this distance is sampled twice as closely. Its bounds are too loose to predict the horizon."""

QUARTERS = 4

LEAST_GAIN = 1e-7
"""An interval is not examined if its bound exceeds the horizon found by no more than this [tangent]."""


@dataclass(frozen=True, eq=False)
class FoundHorizon:
    """The result of a search.

    Attributes
    ----------
    tangent, distance_m : (A,) arrays
        -inf and NaN where nothing is known.
    void : (A,) bool array
        True if a void might hide a higher horizon.
    known_m : (A,) array
        Distance at which the data end [m].
    """

    tangent: np.ndarray
    distance_m: np.ndarray
    void: np.ndarray
    known_m: np.ndarray


def nothing_found(rays):
    """Return the `FoundHorizon` of rays along which there is no terrain."""
    count = len(rays.azimuth_deg)
    return FoundHorizon(np.full(count, -np.inf), np.full(count, np.nan), np.zeros(count, bool), rays.reach_m)


class Search:
    """Branch and bound over all (ray, interval) pairs."""

    def __init__(self, terrain, sight, blocks, summit_m):
        self.terrain, self.sight, self.blocks, self.summit_m = terrain, sight, blocks, summit_m
        nothing = nothing_found(sight.rays)
        self.tangent, self.distance = nothing.tangent, nothing.distance_m

    def run(self, cell_m, progress):
        """Search all rays and return a `FoundHorizon`."""
        near = max(1, round(NEAR_CELLS * cell_m / (self.sight.edge_m[1] - self.sight.edge_m[0])))
        near = min(near, len(self.sight.edge_m) - 1)
        bound, likely = self._bounds(near, progress)
        # Take the most promising distant interval first: it raises the bar for all others.
        ray = np.flatnonzero(likely >= 0)
        self._refine(ray, likely[ray], bound, subtask(progress, 0.3, 0.5))
        # Near the eye, a cell's curved surface can stand well above all its crossings, so sample twice as closely
        # there.
        close = replace(self.sight, lines_per_cell=2 * self.sight.lines_per_cell)
        ray, interval = self._alive(bound[:, :near])
        self._refine(ray, interval, bound, subtask(progress, 0.5, 0.6), close, self._close_by(near))
        self._refine(*self._alive(bound), bound, subtask(progress, 0.6, 0.9))
        return FoundHorizon(self.tangent, self.distance, *self._voids(progress))

    def _alive(self, bound):
        """(ray, interval) pairs that may still hold a horizon, ray by ray."""
        least = np.maximum(self.tangent + LEAST_GAIN, -1e30)  # known empty intervals have a bound of -inf
        alive = bound > np.nextafter(least.astype(np.float32), np.float32(-np.inf))[:, None]
        return np.divmod(np.flatnonzero(alive), bound.shape[1])  # faster than np.nonzero in two dimensions

    def _bounds(self, near, progress):
        """Compute upper bounds of all tangents, and where the horizon is likely.

        Returns
        -------
        bound : (A, N) float32 array
            -inf if there is nothing to see.
        likely : (A,) int array
            For each ray, the interval, not before the `near`th, whose midpoint's block looks highest; -1 for none.
        """
        edge, drop = self.sight.edge_m, self.sight.drop_per_m2
        middle, count = (edge[:-1] + edge[1:]) / 2, len(self.sight.rays.azimuth_deg)
        # In single precision; a margin of one centimetre more than makes up for it.
        eye_m = np.float32(self.sight.eye_m - 0.01)
        inverse, drop_per_m = (1 / edge).astype(np.float32), (drop * edge[:-1]).astype(np.float32)
        inverse_middle, drop_middle = (1 / middle).astype(np.float32), (drop * middle).astype(np.float32)
        highest, own = self.blocks.highest_m.reshape(-1), self.blocks.own_m.reshape(-1)
        bound, likely = np.empty((count, len(middle)), np.float32), np.empty(count, np.intp)
        for rays, block in self._blocks_on_rays(progress):
            beyond = edge[:-1] >= self.sight.rays.reach_m[rays, None]
            height = highest.take(block)
            height -= eye_m
            part = np.multiply(height, inverse[1:], out=bound[rays])
            height *= inverse[:-1]  # the higher of the two if the terrain stands above the eye
            np.maximum(part, height, out=part)
            part -= drop_per_m
            part[beyond] = -np.inf
            height = own.take(block)
            height -= eye_m
            height *= inverse_middle
            height -= drop_middle
            height[beyond] = -np.inf
            height[:, :near] = -np.inf
            best = height.argmax(axis=1)
            likely[rays] = np.where(height[np.arange(len(best)), best] > -np.inf, best, -1)
        return bound, likely

    def _blocks_on_rays(self, progress=SILENT):
        """Yield (slice of rays, positions of the intervals' midpoints in the blocks' flattened tables)."""
        rays, middle = self.sight.rays, (self.sight.edge_m[:-1] + self.sight.edge_m[1:]) / 2
        weights = rays.weights(middle).astype(np.float32)
        row, col = (
            self.blocks.scaled(place, axis).astype(np.float32) for axis, place in enumerate((rays.row_px, rays.col_px))
        )
        total = len(rays.azimuth_deg)
        size = max(1, CHUNK_PAIRS // len(middle))
        for first in range(0, total, size):
            checkpoint(progress, 0.3 * first / total)
            some = slice(first, first + size)
            yield some, self.blocks.flat_index_in_place(row[some] @ weights, col[some] @ weights)

    def _refine(self, ray, interval, bound, progress, sight=None, highest_around=None):
        """Sample pairs in the order of their rays, raise the running maxima, and remove the pairs from the bounds."""
        bound[ray, interval] = -np.inf
        closer = self._closer_bound(ray, interval, highest_around or self._highest_around)
        alive = closer > self.tangent[ray] + LEAST_GAIN
        ray, interval = ray[alive], interval[alive]
        if len(ray) == 0:
            return
        jobs = IntervalJobs(ray, interval, self.tangent[ray], self._doubtful(ray, interval))
        tangent, distance, _ = search_intervals(self.terrain, sight or self.sight, jobs, self.blocks.block, progress)
        starts = np.flatnonzero(np.diff(ray, prepend=-1))
        highest = np.maximum.reduceat(tangent, starts)
        better = highest > self.tangent[ray[starts]]
        highest = np.where(better, highest, np.inf)
        best = np.flatnonzero(tangent == np.repeat(highest, np.diff(starts, append=len(ray))))
        self.tangent[ray[best]], self.distance[ray[best]] = tangent[best], distance[best]

    def _doubtful(self, ray, interval):
        """Return which intervals may have cells without data around them."""
        if not self.blocks.has_void.any():
            return np.zeros(len(ray), bool)
        middle = (self.sight.edge_m[interval] + self.sight.edge_m[interval + 1]) / 2
        return self.blocks.has_void[self.blocks.index(*self.sight.rays.at_pairs(ray, middle))]

    def _closer_bound(self, ray, interval, highest_around):
        """Recompute the upper bounds from the intervals' quarters, with no more blocks than lie around these: (J,)."""
        sight = self.sight
        start = sight.edge_m[interval]
        stop = np.minimum(sight.edge_m[interval + 1], sight.rays.reach_m[ray])
        edges = start + (stop - start) * np.linspace(0.0, 1.0, QUARTERS + 1)[:, None]
        col, row = sight.rays.at_pairs(ray, (edges[1:] + edges[:-1]) / 2)
        height = highest_around(col, row) - sight.eye_m
        return _tangent_bound(height, edges[:-1], edges[1:], sight.drop_per_m2).max(axis=0)

    def _highest_around(self, col_px, row_px):
        return self.blocks.highest_around(col_px, row_px, self._quarter_px)

    @property
    def _quarter_px(self):
        """Distance that a quarter of an interval reaches from its middle, with the interpolation's stencil [cells]."""
        return (self.blocks.block - 1.5) / QUARTERS + 1.01

    def _close_by(self, near):
        """`BlockMaxima.highest_around` of the first intervals, to the nearest cell."""
        rays, end_m = self.sight.rays, self.sight.edge_m[near]
        reach = int(end_m * rays.pixels_per_metre + 2 * self._quarter_px) + 2
        middle = (int(round(float(place[0, 0]))) for place in (rays.row_px, rays.col_px))
        row, col = (place - reach for place in middle)
        window = Window(row, col, 2 * reach + 1, 2 * reach + 1).clipped(self.terrain.shape)
        return highest_close_by(self.terrain, window, self._quarter_px)

    def _voids(self, progress):
        """Determine for each azimuth whether a void might hide a higher horizon, and where the data end [m]."""
        reach = self.sight.rays.reach_m
        void, known_m = np.zeros(len(reach), bool), reach.copy()
        if not self.blocks.has_void.any():
            return void, known_m
        edge = self.sight.edge_m
        start, stop = edge[:-1], edge[1:]
        could = _tangent_bound(self.summit_m - self.sight.eye_m, start, stop, self.sight.drop_per_m2)
        unsure = np.zeros((len(reach), len(start)), bool)
        for rays, block in self._blocks_on_rays():
            within = start < reach[rays, None]
            empty = self.blocks.all_void.reshape(-1)[block]
            known = within & ~empty
            last = known.shape[1] - 1 - known[:, ::-1].argmax(axis=1)
            last = np.where(known.any(axis=1), last, -1)
            known_m[rays] = np.minimum(reach[rays], np.where(last < 0, start[0], stop[last]))
            before = (np.arange(len(start)) < last[:, None]) & (could > self.tangent[rays, None])
            void[rays] = (before & empty).any(axis=1)
            unsure[rays] = before & ~empty & self.blocks.has_void.reshape(-1)[block] & ~void[rays, None]
        ray, interval = np.nonzero(unsure)
        jobs = IntervalJobs(ray, interval, self.tangent[ray], np.ones(len(ray), bool))
        _, _, meets = search_intervals(self.terrain, self.sight, jobs, self.blocks.block, subtask(progress, 0.9, 1.0))
        void[ray[meets]] = True
        return void, known_m


def _tangent_bound(height_m, start_m, stop_m, drop_per_m2):
    """Highest tangent that terrain `height_m` above the eye can have between two distances."""
    bound = height_m * (1.0 / start_m)  # the higher of the two if the terrain stands above the eye
    np.maximum(bound, height_m * (1.0 / stop_m), out=bound)
    bound -= drop_per_m2 * start_m
    return bound
