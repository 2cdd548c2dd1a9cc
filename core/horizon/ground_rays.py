"""Terrain sampled along rays around one observer: elevations and sight-line tangents by azimuth and distance.

Terrain below the horizon needs no bounded search. Samples whose spacing grows with the distance suffice, and all
questions about that terrain are answered from the same samples.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.progress import SILENT, checkpoint
from ..base.terrain import Window, bilinear, eye_elevation_m


@dataclass(frozen=True)
class RayOptions:
    """Where to sample the terrain.

    Attributes
    ----------
    azimuth_step_deg : float
        Spacing of the rays [degrees].
    near_cells, near_m : float
        Rays start at the larger of both [cells, m].
    max_distance_m : float
        Rays end at this distance [m].
    max_cells : int
        Half the side of the window that is read, which bounds memory and time; it shortens the rays in fine DEMs.
    growth : float
        Samples lie at least this share of their distance apart, and at least one cell.
    refraction_coefficient : float
        See `core.base.curvature`.
    """

    azimuth_step_deg: float = 0.25
    near_cells: float = 5.0
    near_m: float = 300.0
    max_distance_m: float = 60_000.0
    max_cells: int = 2000
    growth: float = 0.008
    refraction_coefficient: float = REFRACTION_COEFFICIENT

    def __post_init__(self):
        if not (0 < self.azimuth_step_deg <= 10 and self.growth > 0 and self.max_cells > 1):
            raise ValueError(f"unusable rays {self}")


@dataclass(frozen=True, eq=False)
class GroundRays:
    """Samples along rays.

    Attributes
    ----------
    azimuth_deg : (A,) array
        Regular over the circle, clockwise from true north [degrees].
    distance_m : (D,) array
        Increasing [m]; fewer than three values if the terrain does not reach that far.
    elevation_m : (A, D) array
        Elevations [m]; NaN outside the DEM and in voids.
    tangent : (A, D) array
        Tangent of the elevation angle at which the sample would be seen if nothing stood before it; NaN as above.
    """

    azimuth_deg: np.ndarray
    distance_m: np.ndarray
    elevation_m: np.ndarray
    tangent: np.ndarray


def cast_ground_rays(terrain, observer, options=RayOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Sample the terrain all around an observer.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : RayOptions
    progress : Progress

    Returns
    -------
    GroundRays

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, options.max_distance_m)
    eye_m = eye_elevation_m(terrain, frame, observer)
    reach = min(options.max_distance_m, options.max_cells * min(frame.cell_size_m))
    distance = _distances(frame.cell_m, reach, options)
    azimuth = np.arange(0, 360, options.azimuth_step_deg)
    if len(distance) < 3:
        return GroundRays(azimuth, np.zeros(0), *np.zeros((2, len(azimuth), 0)))
    checkpoint(progress, 0.0)
    turn = np.radians(azimuth)[:, None]
    elevation = _sample(terrain, *frame.to_pixel(distance * np.sin(turn), distance * np.cos(turn)))
    checkpoint(progress, 0.9)
    drop = apparent_drop_m(distance, options.refraction_coefficient)
    return GroundRays(azimuth, distance, elevation, (elevation - eye_m - drop) / distance)


def _distances(cell_m, reach_m, options):
    near = max(options.near_cells * cell_m, options.near_m)
    linear_end = min(max(cell_m / options.growth, near), reach_m)
    linear = np.arange(near, linear_end - 0.5 * cell_m, cell_m)
    count = int(np.log(max(reach_m / linear_end, 1.0)) / np.log1p(options.growth)) + 1
    return np.concatenate([linear, linear_end * (1 + options.growth) ** np.arange(count)])


def _sample(terrain, col, row):
    """Elevations at pixels of the whole raster, NaN outside and in voids."""
    first_row, first_col = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    last_row, last_col = int(np.ceil(row.max())) + 2, int(np.ceil(col.max())) + 2
    window = Window(first_row, first_col, last_row - first_row, last_col - first_col).clipped(terrain.shape)
    # Exact interpolation, not an image remapping: its steps of 1/32 pixel would become slopes between neighbouring
    # rays.
    return bilinear(terrain.read(window), row - window.row, col - window.col)
