"""The sky-terrain boundary around one observer, exact to a fraction of a cell, for a DEM of any size and CRS.

Rays run at true azimuths and true ground distances. Each is cut into intervals of a few cells; the highest cell of
the blocks around an interval bounds every elevation angle in it, so that nearly all intervals are dismissed without
a look at their terrain, and the survivors are sampled wherever the ray crosses a grid line.
The bound is a true one: dropping intervals by it never changes the answer.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from .errors import ObserverOutsideDemError
from .horizon_blocks import STRIP_ROWS, aligned, block_maxima
from .horizon_rays import lay_rays
from .horizon_refine import Sight, search_intervals
from .model import HorizonProfile
from .progress import SILENT, checkpoint, subtask
from .terrain import Window, eye_elevation_m

BLOCK = 8
MAX_PAIRS = 32_000_000
CHUNK_PAIRS = 400_000
NEAR_CELLS = 64


@dataclass(frozen=True)
class HorizonOptions:
    """How to search the horizon.

    Attributes
    ----------
    azimuth_step_deg : float
        Spacing of the azimuths; rounded so that it divides the circle [degrees].
    max_distance_m : float
        Search range; ends earlier where the DEM does [m].
    refraction_coefficient : float
        k of `apparent_drop_m`.
    curvature : bool
        Account for the earth's curvature and refraction; False for a plane earth with straight rays.
    near_skip_cells : float
        The search starts this far from the observer [cells]: nearer, the DEM says nothing about what the eye sees.
    lines_per_cell : int
        Samples lie where a ray crosses grid lines, and this many lines count as one cell: 1 for the cells' centre
        lines only, where an interpolated surface has its kinks, 2 also half-way.
    summit_m : float or None
        Highest elevation to expect where the DEM is silent (beyond its edge, in voids) [m]; None takes the highest
        cell within range. It decides `HorizonProfile.clipped` and `void` and nothing else.
    memory_mb : float
        Hold the terrain in memory where it takes no more than this, else read it in strips and tiles [MB]. The
        result is the same.
    """

    azimuth_step_deg: float = 0.1
    max_distance_m: float = 100_000.0
    refraction_coefficient: float = REFRACTION_COEFFICIENT
    curvature: bool = True
    near_skip_cells: float = 1.5
    lines_per_cell: int = 2
    summit_m: float | None = None
    memory_mb: float = 160.0

    def __post_init__(self):
        if not 0 < self.azimuth_step_deg <= 90:
            raise ValueError(f"the azimuth step must lie in (0, 90] degrees, not {self.azimuth_step_deg}")
        if not self.max_distance_m > 0:
            raise ValueError(f"the maximum distance must be positive, not {self.max_distance_m}")
        if not 0 <= self.refraction_coefficient < 1:
            raise ValueError(f"the refraction coefficient must lie in [0, 1), not {self.refraction_coefficient}")
        if self.near_skip_cells < 0.25 or self.lines_per_cell < 1:
            raise ValueError("near_skip_cells must be at least 0.25 and lines_per_cell at least 1")

    @property
    def drop_per_m2(self):
        """Apparent drop over distance squared [1/m]."""
        return float(apparent_drop_m(1.0, self.refraction_coefficient)) if self.curvature else 0.0

    @property
    def azimuth_deg(self):
        """(A,) azimuths from 0, clockwise from true north [degrees]."""
        count = int(round(360.0 / self.azimuth_step_deg))
        return np.arange(count) * (360.0 / count)


DEFAULT = HorizonOptions()


def horizon_profile(terrain, observer, options=DEFAULT, progress=SILENT):
    """Find the horizon around an observer.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : HorizonOptions
    progress : Progress

    Returns
    -------
    HorizonProfile
        `elevation_deg` and `distance_m` are NaN in directions in which nothing is known. `reach_m` ends where the
        DEM's data end. `clipped` is set where they end before `max_distance_m` and a summit of `summit_m` just
        beyond (or farther, where it would look higher) would stand above the horizon found; `void` where cells
        without data lie on the ray before that end and such a summit in them would.

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, options.max_distance_m)
    rows, cols = terrain.shape
    if not (-0.5 <= frame.row_px <= rows - 0.5 and -0.5 <= frame.col_px <= cols - 0.5):
        raise ObserverOutsideDemError(observer.longitude_deg, observer.latitude_deg)
    eye_m = eye_elevation_m(terrain, frame, observer)
    rays = lay_rays(frame, terrain.shape, options.azimuth_deg, options.max_distance_m)
    edge_m, block = _intervals(rays, options.near_skip_cells * frame.cell_m)
    if len(edge_m) < 2:
        return _profile(rays, options, eye_m, frame.cell_m, -np.inf)

    window = aligned(_window(rays, terrain.shape), block, terrain.shape)
    held = window.rows * window.cols * 4e-6 <= options.memory_mb
    if held:
        terrain = _Held(terrain, window, subtask(progress, 0.0, 0.5))
    blocks = block_maxima(terrain, window, block, subtask(progress, 0.5 if held else 0.0, 0.7))
    sight = Sight(rays, edge_m, eye_m, options.drop_per_m2, options.lines_per_cell, frame.cell_m)
    summit_m = blocks.summit_m if options.summit_m is None else options.summit_m
    search = _Search(terrain, sight, blocks, summit_m, window if held else None)
    return search.run(options, frame.cell_m, subtask(progress, 0.7, 1.0))


def _intervals(rays, start_m):
    """Edges of the rays' intervals [m], and the block size whose bound covers them."""
    furthest = float(rays.reach_m.max())
    if furthest <= start_m:
        return np.array([start_m]), BLOCK
    block = BLOCK
    while True:
        # Half an interval and the interpolation's stencil fit into one block's width.
        length = 2 * (block - 1.5) / rays.pixels_per_metre
        count = int(np.ceil((furthest - start_m) / length))
        if count * len(rays.azimuth_deg) <= MAX_PAIRS or block >= STRIP_ROWS:
            break
        block *= 2
    edge = start_m + length * np.arange(count + 1)
    edge[-1] = furthest
    return edge, block


def _window(rays, shape):
    """Rectangle of cells that the rays touch."""
    col, row = rays.at_pairs(np.arange(len(rays.reach_m)), rays.reach_m)
    inside = rays.node_m <= rays.reach_m[:, None]
    col = np.concatenate([col, rays.col_px[inside]])
    row = np.concatenate([row, rays.row_px[inside]])
    top, left = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    bottom, right = int(np.ceil(row.max())) + 2, int(np.ceil(col.max())) + 2
    return Window(top, left, bottom - top, right - left).clipped(shape)


class _Held:
    """A window of a terrain, read once and served from memory."""

    def __init__(self, terrain, window, progress):
        self.shape, self._window = terrain.shape, window
        self._cells = np.empty((window.rows, window.cols), np.float32)
        for row in range(0, window.rows, STRIP_ROWS):
            checkpoint(progress, row / window.rows)
            count = min(STRIP_ROWS, window.rows - row)
            self._cells[row : row + count] = terrain.read(Window(window.row + row, window.col, count, window.cols))

    def read(self, window):
        row, col = window.row - self._window.row, window.col - self._window.col
        return self._cells[row : row + window.rows, col : col + window.cols]


class _Search:
    """Branch and bound over all (ray, interval) pairs."""

    def __init__(self, terrain, sight, blocks, summit_m, whole):
        self.terrain, self.sight, self.blocks, self.summit_m, self.whole = terrain, sight, blocks, summit_m, whole
        count = len(sight.rays.azimuth_deg)
        self.tangent, self.distance = np.full(count, -np.inf), np.full(count, np.nan)

    def run(self, options, cell_m, progress):
        bound = self._bounds(progress)
        near = max(1, int(NEAR_CELLS * cell_m / (self.sight.edge_m[1] - self.sight.edge_m[0])))
        first = np.zeros(bound.shape, bool)
        first[:, :near] = bound[:, :near] > -np.inf
        first[np.arange(len(bound)), bound.argmax(axis=1)] = True
        first &= bound > -np.inf
        self._refine(first, bound, subtask(progress, 0.3, 0.5))
        best_left = np.zeros_like(first)
        best_left[np.arange(len(bound)), bound.argmax(axis=1)] = True
        self._refine(best_left & self._alive(bound), bound, subtask(progress, 0.5, 0.6))
        self._refine(self._alive(bound), bound, subtask(progress, 0.6, 0.9))
        void, known_m = self._voids(progress)
        profile = _profile(
            self.sight.rays, options, self.sight.eye_m, cell_m, self.summit_m, self.tangent, self.distance, known_m
        )
        profile.void[:] = void
        return profile

    def _alive(self, bound):
        return bound > (self.tangent + 1e-7)[:, None]

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

    def _refine(self, chosen, bound, progress):
        """Sample the chosen pairs, raise the running maxima, and strike the pairs off the bounds."""
        ray, interval = np.nonzero(chosen)
        tangent, distance, _ = search_intervals(
            self.terrain, self.sight, ray, interval, self.blocks.block, self.whole, progress
        )
        bound[chosen] = -np.inf
        if len(ray) == 0:
            return
        order = np.lexsort((tangent, ray))
        last = order[np.append(np.diff(ray[order]) > 0, True)]
        better = tangent[last] > self.tangent[ray[last]]
        last = last[better]
        self.tangent[ray[last]], self.distance[ray[last]] = tangent[last], distance[last]

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
            self.terrain, self.sight, ray, interval, self.blocks.block, self.whole, subtask(progress, 0.9, 1.0)
        )
        void[ray[meets]] = True
        return void, known_m


def _tangent_bound(height_m, start_m, stop_m, drop_per_m2):
    """Highest tangent that terrain `height_m` above the eye can have between two distances."""
    return np.where(height_m >= 0, height_m / start_m, height_m / stop_m) - drop_per_m2 * start_m


def _profile(rays, options, eye_m, cell_m, summit_m, tangent=None, distance=None, known_m=None):
    """Put the result together and judge where the DEM ends too early."""
    count = len(rays.azimuth_deg)
    tangent = np.full(count, -np.inf) if tangent is None else tangent
    distance = np.full(count, np.nan) if distance is None else distance
    reach = rays.reach_m if known_m is None else known_m
    return HorizonProfile(
        azimuth_deg=rays.azimuth_deg,
        elevation_deg=np.degrees(np.arctan(np.where(np.isfinite(tangent), tangent, np.nan))),
        distance_m=distance,
        clipped=_clipped(reach, tangent, summit_m - eye_m, options),
        void=np.zeros(count, bool),
        eye_elevation_m=eye_m,
        cell_m=cell_m,
        reach_m=reach,
    )


def _clipped(reach, tangent, height_m, options):
    """Whether a summit beyond the reach but within range would rise above the horizon found."""
    ends_early = reach < options.max_distance_m * (1 - 1e-9)
    at = np.maximum(reach, 1e-3)
    if height_m < 0 and options.drop_per_m2 > 0:  # low ground looks highest where the earth's bend begins to win
        at = np.clip(np.sqrt(-height_m / options.drop_per_m2), at, np.maximum(at, options.max_distance_m))
    elif height_m < 0:
        at = np.maximum(at, options.max_distance_m)
    highest = height_m / at - options.drop_per_m2 * at if np.isfinite(height_m) else np.full(len(at), -np.inf)
    return ends_early & ((highest > tangent) | ~np.isfinite(tangent))
