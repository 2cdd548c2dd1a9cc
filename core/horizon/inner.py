"""Everything that the matcher needs to know about the terrain below the horizon, from one set of rays."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..base.progress import SILENT
from .ground_rays import RayOptions, cast_ground_rays
from .ridges import RidgeEdges, RidgeOptions, occlusion_edges


@dataclass(frozen=True)
class InnerOptions:
    """Where to sample, and which crests count."""

    rays: RayOptions = field(default_factory=RayOptions)
    ridges: RidgeOptions = field(default_factory=RidgeOptions)


@dataclass(frozen=True, eq=False)
class InnerTerrain:
    """The terrain below the horizon around one observer.

    Attributes
    ----------
    ridges : RidgeEdges
    ground : GroundView or None
        None if the DEM holds no ground that far from the observer.
    """

    ridges: RidgeEdges
    ground: GroundView | None


def inner_terrain(terrain, observer, options=InnerOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Sample the terrain around an observer and find the ridges and the ground in view.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : InnerOptions
    progress : Progress

    Returns
    -------
    InnerTerrain

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    return inner_from(cast_ground_rays(terrain, observer, options.rays, progress), options)


def inner_from(rays, options=InnerOptions()):  # noqa: B008 - frozen
    """Find the ridges and the ground in view; see `inner_terrain`.

    Parameters
    ----------
    rays : GroundRays
    options : InnerOptions

    Returns
    -------
    InnerTerrain
    """
    return InnerTerrain(occlusion_edges(rays, options.ridges), ground_view(rays))


ATTRIBUTES = ("normal_east", "normal_north", "normal_up", "log_distance", "elevation_km")
"""Planes of a `GroundView`: unit normal of the surface, log of the distance in metres, elevation in kilometres."""

LOWEST_DEG, HIGHEST_DEG = -60.0, 80.0
"""Range of elevation angles that is kept [degrees]."""


@dataclass(frozen=True, eq=False)
class GroundView:
    """Visible ground on a grid of directions.

    Attributes
    ----------
    azimuth_step_deg : float
        Columns start at true north and run clockwise [degrees].
    first_elevation_deg, elevation_step_deg : float
        Elevation angle of the first row, and spacing of the rows, upwards [degrees].
    planes : (F, E, A) float16 array
        See `ATTRIBUTES`; NaN in the sky, and where the ground is too near or unknown.
    """

    azimuth_step_deg: float
    first_elevation_deg: float
    elevation_step_deg: float
    planes: np.ndarray

    def at(self, azimuth_deg, elevation_deg):
        """Attributes of the ground in the nearest direction of the grid: (F, ...) float32 for any shape."""
        _, rows, columns = self.planes.shape
        column = np.rint(np.mod(azimuth_deg, 360.0) / self.azimuth_step_deg).astype(np.intp) % columns
        row = np.rint((elevation_deg - self.first_elevation_deg) / self.elevation_step_deg).astype(np.intp)
        inside = (row >= 0) & (row < rows)
        found = self.planes[:, np.where(inside, row, 0), column].astype(np.float32)
        return np.where(inside, found, np.float32(np.nan))


def ground_view(rays):
    """Find the ground that is seen in each direction.

    Parameters
    ----------
    rays : GroundRays

    Returns
    -------
    GroundView or None
        None if the rays reach no ground at all. The rows are as far apart as the rays.
    """
    step = float(rays.azimuth_deg[1] - rays.azimuth_deg[0])
    known = np.isfinite(rays.tangent)
    if not known.any():
        return None
    highest = np.maximum.accumulate(np.where(known, rays.tangent, -np.inf), axis=1)
    low = np.degrees(np.arctan(rays.tangent[:, 0][known[:, 0]].min(initial=0.0)))
    high = np.degrees(np.arctan(highest[:, -1].max()))
    first = max(np.floor(low), LOWEST_DEG)
    elevation = np.arange(first, min(high, HIGHEST_DEG) + step, step)
    tangent = np.tan(np.radians(elevation))
    sample = np.stack([np.searchsorted(line, tangent) for line in highest], axis=1)
    # The first sample of a ray hides whatever lies nearer, so the ground there is not known.
    seen = (sample > 0) & (sample < len(rays.distance_m))
    sample = np.where(seen, sample, 0)
    ray = np.arange(len(rays.azimuth_deg))[None, :]
    surface = (*rays.samples.normals, np.log(rays.distance_m)[None, :], rays.elevation_m / 1000)
    planes = [np.broadcast_to(plane, rays.tangent.shape)[ray, sample] for plane in surface]
    return GroundView(step, float(first), step, np.where(seen, planes, np.nan).astype(np.float16))
