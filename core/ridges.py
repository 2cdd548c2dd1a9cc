r"""Inner ridges: where the terrain in view hides farther terrain, around one observer.

Along each ray the surface is visible where its tangent exceeds all nearer ones. It stops being visible behind a
crest and comes back farther away::

      eye *            crest
           `-..      _/\  hidden   _ - - seen again: the distance jumps
               `--../    \_______/

Crests are what a photograph shows as lines inside the terrain, the sharper the larger the jump in distance, since
haze, light and texture change with it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import imaging
from .curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from .progress import SILENT, checkpoint
from .terrain import Window, eye_elevation_m


@dataclass(frozen=True)
class RidgeOptions:
    """How to look for crests.

    Attributes
    ----------
    azimuth_step_deg : float
        Spacing of the rays [degrees].
    near_cells, near_m : float
        The search starts at the larger of both [cells, m].
    max_distance_m : float
        And ends here [m].
    max_cells : int
        Half the side of the window read, so that memory and time are bounded; shortens the search in fine DEMs.
    growth : float
        Samples lie at least this share of their distance apart, and at least a cell.
    least_jump : float
        Crests are kept where the terrain seen next is this many times farther.
    least_depth_deg : float
        And where what is hidden lies this far below the line of sight [degrees].
    refraction_coefficient : float
        See `core.curvature`.
    """

    azimuth_step_deg: float = 0.25
    near_cells: float = 5.0
    near_m: float = 300.0
    max_distance_m: float = 60_000.0
    max_cells: int = 2000
    growth: float = 0.008
    least_jump: float = 1.1
    least_depth_deg: float = 0.05
    refraction_coefficient: float = REFRACTION_COEFFICIENT

    def __post_init__(self):
        if not (0 < self.azimuth_step_deg <= 10 and self.growth > 0 and self.least_jump > 1 and self.max_cells > 1):
            raise ValueError(f"unusable search for ridges {self}")


@dataclass(frozen=True, eq=False)
class RidgeEdges:
    """Crests around one observer; (N,) arrays.

    Attributes
    ----------
    azimuth_deg, elevation_deg : clockwise from true north, and above the horizontal [degrees].
    distance_m : of the crest [m].
    jump : distance of what is seen above it over its own.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    jump: np.ndarray


def occlusion_edges(terrain, observer, options=RidgeOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Find the crests in view of an observer, the horizon itself excepted.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : RidgeOptions
    progress : Progress

    Returns
    -------
    RidgeEdges
        Sorted by azimuth. Voids end a ray.

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
        return RidgeEdges(*np.zeros((4, 0)))
    checkpoint(progress, 0.0)
    turn = np.radians(azimuth)[:, None]
    col, row = frame.to_pixel(distance * np.sin(turn), distance * np.cos(turn))
    elevation = _sample(terrain, col, row)
    checkpoint(progress, 0.7)
    drop = apparent_drop_m(distance, options.refraction_coefficient)
    tangent = (elevation - eye_m - drop) / distance
    return _crests(azimuth, distance, tangent, options)


def _distances(cell_m, reach_m, options):
    near = max(options.near_cells * cell_m, options.near_m)
    linear_end = min(max(cell_m / options.growth, near), reach_m)
    linear = np.arange(near, linear_end, cell_m)
    count = int(np.log(max(reach_m / linear_end, 1.0)) / np.log1p(options.growth)) + 1
    return np.concatenate([linear, linear_end * (1 + options.growth) ** np.arange(count)])


def _sample(terrain, col, row):
    """Elevations at pixels of the whole raster, NaN outside and in voids."""
    first_row, first_col = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    last_row, last_col = int(np.ceil(row.max())) + 2, int(np.ceil(col.max())) + 2
    window = Window(first_row, first_col, last_row - first_row, last_col - first_col).clipped(terrain.shape)
    cells = terrain.read(window)
    return imaging.sample_bilinear(cells, col - window.col, row - window.row, outside=np.nan)


def _crests(azimuth, distance, tangent, options):
    tangent = np.where(np.isfinite(tangent), tangent, -np.inf)
    highest = np.maximum.accumulate(tangent, axis=1)
    visible = np.isfinite(tangent)
    visible[:, 1:] &= tangent[:, 1:] >= highest[:, :-1]
    # Index of the next visible sample at or behind each one; len(distance) where there is none.
    index = np.where(visible, np.arange(len(distance)), len(distance))
    following = np.minimum.accumulate(index[:, ::-1], axis=1)[:, ::-1]
    crest = np.zeros_like(visible)
    crest[:, :-1] = visible[:, :-1] & ~visible[:, 1:]
    ray, near = np.nonzero(crest)
    far = following[ray, near + 1]
    seen_again = far < len(distance)
    ray, near, far = ray[seen_again], near[seen_again], far[seen_again]
    jump = distance[far] / distance[near]
    depth = tangent[ray, near] - _lowest_between(tangent, ray, near, far)
    kept = (jump >= options.least_jump) & (depth >= np.tan(np.radians(options.least_depth_deg)))
    ray, near = ray[kept], near[kept]
    elevation = np.degrees(np.arctan(tangent[ray, near]))
    return RidgeEdges(azimuth[ray], elevation, distance[near], jump[kept])


def _lowest_between(tangent, ray, near, far):
    """Lowest tangent strictly between two samples of a ray; the hidden ground's deepest point."""
    if len(ray) == 0:
        return np.zeros(0)
    bounds = np.stack([ray * tangent.shape[1] + near + 1, ray * tangent.shape[1] + far], axis=1).ravel()
    flat = np.append(np.where(np.isfinite(tangent), tangent, np.inf).ravel(), np.inf)
    return np.minimum.reduceat(flat, bounds)[::2]
