"""The boundary of sky and terrain around one observer, exact to a fraction of a cell, for a DEM of any size and CRS.

Rays run at true azimuths and true ground distances. Each ray is cut into intervals of a few cells. The highest cell
of the blocks around an interval bounds every elevation angle in it, so that nearly all intervals are dismissed
without examining their terrain. The remaining intervals are sampled wherever the ray crosses a grid line.
It is a true upper bound: dropping intervals by it never changes the answer.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.errors import ObserverOutsideDemError
from ..base.model import HorizonProfile
from ..base.progress import SILENT, subtask
from ..base.terrain import Window, eye_elevation_m
from .blocks import STRIP_ROWS, HeldTerrain, aligned, block_maxima
from .rays import EyeRays, lay_rays
from .search import Search, nothing_found

BLOCK = 8
"""Side of the blocks whose maxima bound the rays' intervals [cells]."""

MAX_PAIRS = 32_000_000
"""Most (ray, interval) pairs in memory at once; above this, blocks and intervals are doubled."""


@dataclass(frozen=True)
class HorizonOptions:
    """How to search the horizon.

    Attributes
    ----------
    azimuth_step_deg : float
        Spacing of the azimuths; rounded so that it divides the circle [degrees].
    max_distance_m : float
        Search range; it ends earlier if the DEM does [m].
    refraction_coefficient : float
        k of `apparent_drop_m`.
    curvature : bool
        Account for the earth's curvature and refraction; False assumes a plane earth and straight rays.
    near_skip_cells : float
        The search starts this far from the observer [cells]: any nearer, the DEM does not describe what the eye sees.
    lines_per_cell : int
        Samples lie where a ray crosses grid lines, and this many lines count as one cell: 1 for the cells' centre
        lines only, where an interpolated surface has its kinks, 2 also half-way.
    summit_m : float or None
        Highest elevation to expect where the DEM has no data (beyond its edge, in voids) [m]; None takes the highest
        cell within range. It decides only `HorizonProfile.clipped` and `void`.
    memory_mb : float
        Most terrain that is held in memory, around the observer; the rest is read twice, in strips and in small
        pieces [MB]. The result is the same.
    """

    azimuth_step_deg: float = 0.1
    max_distance_m: float = 100_000.0
    refraction_coefficient: float = REFRACTION_COEFFICIENT
    curvature: bool = True
    near_skip_cells: float = 1.5
    lines_per_cell: int = 1
    summit_m: float | None = None
    memory_mb: float = 64.0

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
        DEM's data end. `clipped` is set if they end before `max_distance_m` and a summit of `summit_m` just
        beyond (or farther, if it would look higher there) would stand above the horizon found. `void` is set if cells
        without data lie on the ray before that end and a summit of that height in them would stand above the horizon.

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
    sight = EyeRays(rays, edge_m, eye_m, options.drop_per_m2, options.lines_per_cell, frame.cell_m)
    if len(edge_m) < 2:
        return _profile(sight, options, -np.inf, nothing_found(rays))

    window = aligned(_window(rays, terrain.shape), block, terrain.shape)
    terrain = HeldTerrain(terrain, window, frame.row_px, options.memory_mb)
    margin_px = 3 * block

    def columns(first_row, last_row):
        return rays.columns(first_row, last_row, margin_px)

    blocks = block_maxima(terrain, window, block, subtask(progress, 0.0, 0.7), columns)
    summit_m = blocks.summit_m if options.summit_m is None else options.summit_m
    found = Search(terrain, sight, blocks, summit_m).run(frame.cell_m, subtask(progress, 0.7, 1.0))
    return _profile(sight, options, summit_m, found)


def _intervals(rays, start_m):
    """Edges of the rays' intervals [m], and the block size whose bound covers the intervals."""
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


def _profile(sight, options, summit_m, found):
    """Assemble the result and determine where the DEM ends too early."""
    tangent = found.tangent
    return HorizonProfile(
        azimuth_deg=sight.rays.azimuth_deg,
        elevation_deg=np.degrees(np.arctan(np.where(np.isfinite(tangent), tangent, np.nan))),
        distance_m=found.distance_m,
        clipped=_clipped(found.known_m, tangent, summit_m - sight.eye_m, options),
        void=found.void,
        eye_elevation_m=sight.eye_m,
        cell_m=sight.cell_m,
        reach_m=found.known_m,
    )


def _clipped(reach, tangent, height_m, options):
    """Return whether a summit beyond the reach but within range would rise above the horizon found."""
    ends_early = reach < options.max_distance_m * (1 - 1e-9)
    at = np.maximum(reach, 1e-3)
    if height_m < 0 and options.drop_per_m2 > 0:  # low ground looks highest where the curvature term begins to dominate
        at = np.clip(np.sqrt(-height_m / options.drop_per_m2), at, np.maximum(at, options.max_distance_m))
    elif height_m < 0:
        at = np.maximum(at, options.max_distance_m)
    highest = height_m / at - options.drop_per_m2 * at if np.isfinite(height_m) else np.full(len(at), -np.inf)
    return ends_early & ((highest > tangent) | ~np.isfinite(tangent))
