"""Terrain sampled along rays around one observer: elevations and sight-line tangents by azimuth and distance.

Terrain below the horizon needs no bounded search. Samples whose spacing grows with the distance suffice, and all
questions about that terrain are answered from the same samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.frame import LocalFrame
from ..base.progress import SILENT, checkpoint
from ..base.terrain import Window, bilinear, check_inside, eye_elevation_m


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
class GroundSamples:
    """Terrain along rays around one place, independent of the elevation of the eye.

    Attributes
    ----------
    frame : LocalFrame
        Frame around the place.
    azimuth_deg : (A,) array
        Regular over the circle, clockwise from true north [degrees].
    distance_m : (D,) array
        Increasing [m]; empty if fewer than three samples fit into the range.
    elevation_m : (A, D) array
        Elevations [m]; NaN outside the DEM and in voids.
    drop_m : (D,) array
        Apparent drop by curvature and refraction [m].
    """

    frame: LocalFrame
    azimuth_deg: np.ndarray
    distance_m: np.ndarray
    elevation_m: np.ndarray
    drop_m: np.ndarray

    @cached_property
    def normals(self):
        """East, north and up components of the surface's unit normal at every sample, three (A, D) arrays."""
        turn = np.radians(self.azimuth_deg)[:, None]
        outwards = np.gradient(self.elevation_m, self.distance_m, axis=1)
        neighbours = np.roll(self.elevation_m, -1, axis=0) - np.roll(self.elevation_m, 1, axis=0)
        across = neighbours / (2 * np.radians(self.azimuth_deg[1] - self.azimuth_deg[0]) * self.distance_m)
        east = -(outwards * np.sin(turn) + across * np.cos(turn))
        north = -(outwards * np.cos(turn) - across * np.sin(turn))
        length = np.sqrt(1 + east**2 + north**2)
        return east / length, north / length, 1 / length

    def seen_from(self, eye_m):
        """Return the `GroundRays` of an eye at an elevation [m]."""
        return GroundRays(self, (self.elevation_m - eye_m - self.drop_m) / self.distance_m)


@dataclass(frozen=True, eq=False)
class GroundRays:
    """Samples along rays, as seen from one eye.

    Attributes
    ----------
    samples : GroundSamples
    tangent : (A, D) array
        Tangent of the elevation angle at which the sample would be seen if nothing stood before it; NaN where its
        elevation is.
    """

    samples: GroundSamples
    tangent: np.ndarray

    @property
    def azimuth_deg(self):
        """(A,) azimuths, clockwise from true north [degrees]."""
        return self.samples.azimuth_deg

    @property
    def distance_m(self):
        """(D,) distances [m]."""
        return self.samples.distance_m

    @property
    def elevation_m(self):
        """(A, D) elevations [m]; NaN outside the DEM and in voids."""
        return self.samples.elevation_m


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
    samples = ground_samples(terrain, observer.longitude_deg, observer.latitude_deg, options, progress)
    return samples.seen_from(eye_elevation_m(terrain, samples.frame, observer))


# parameters: a position, and how to sample around it
def ground_samples(
    terrain, longitude_deg, latitude_deg, options=RayOptions(), progress=SILENT  # noqa: B008 - frozen
):  # fmt: skip
    """Sample the terrain all around a place.

    Parameters
    ----------
    terrain : Terrain
    longitude_deg, latitude_deg : float
        WGS 84 position [degrees].
    options : RayOptions
    progress : Progress

    Returns
    -------
    GroundSamples

    Raises
    ------
    ObserverOutsideDemError
    """
    frame = terrain.frame(longitude_deg, latitude_deg, options.max_distance_m)
    check_inside(terrain, frame)
    reach = min(options.max_distance_m, options.max_cells * min(frame.cell_size_m))
    distance = _distances(frame.cell_m, reach, options)
    azimuth = np.arange(0, 360, options.azimuth_step_deg)
    if len(distance) < 3:
        return GroundSamples(frame, azimuth, np.zeros(0), np.zeros((len(azimuth), 0)), np.zeros(0))
    checkpoint(progress, 0.0)
    turn = np.radians(azimuth)[:, None]
    elevation = _sample(terrain, *frame.to_pixel(distance * np.sin(turn), distance * np.cos(turn)))
    checkpoint(progress, 0.9)
    drop = apparent_drop_m(distance, options.refraction_coefficient)
    return GroundSamples(frame, azimuth, distance, elevation, drop)


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
