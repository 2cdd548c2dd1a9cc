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
from ..base.model import HorizonProfile
from ..base.progress import SILENT, subtask
from ..base.terrain import eye_elevation_m
from .rays import EyeRays
from .search import Search, nothing_found
from .surroundings import Surroundings


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
    around = Surroundings(terrain, observer.longitude_deg, observer.latitude_deg, options)
    return horizon_from(around, eye_elevation_m(terrain, around.frame, observer), progress)


def horizon_from(around, eye_m, progress=SILENT):
    """Find the horizon from one of the eyes at a place; see `horizon_profile`.

    Parameters
    ----------
    around : Surroundings
    eye_m : float
        Elevation of the eye in the DEM's height system [m].
    progress : Progress

    Returns
    -------
    HorizonProfile
    """
    cell_m, options = around.frame.cell_m, around.options
    sight = EyeRays(around.rays, around.edge_m, eye_m, options.drop_per_m2, options.lines_per_cell, cell_m)
    if len(around.edge_m) < 2:
        return _profile(sight, options, -np.inf, nothing_found(around.rays))
    blocks = around.blocks(subtask(progress, 0.0, 0.7))
    summit_m = blocks.summit_m if options.summit_m is None else options.summit_m
    found = Search(around.cells, sight, blocks, summit_m).run(cell_m, subtask(progress, 0.7, 1.0))
    return _profile(sight, options, summit_m, found)


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
