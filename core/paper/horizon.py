"""Compute the horizon exactly as published: 3,600 rays, nearest cell, one cell per step, 15 km, a flat earth.

This horizon serves for comparison only. Its rays follow the raster's grid: their azimuths are grid bearings, which the
paper treats as true bearings.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.angles import true_to_grid
from ..base.errors import NoElevationAtObserverError, ObserverOutsideDemError
from ..base.model import HorizonProfile
from ..base.progress import SILENT, checkpoint
from ..base.terrain import Window

BATCH_RAYS = 200


@dataclass(frozen=True)
class PaperHorizonOptions:
    """Parameters of the paper's ray casting (section on horizon extraction, eqs. 2-4).

    Attributes
    ----------
    azimuth_step_deg : float
        Step between rays [degrees].
    max_distance_m : float
        Length of the rays, R_max [m].
    eye_height_m : float
        Height of the eye above the observer's cell [m].
    """

    azimuth_step_deg: float = 0.1
    max_distance_m: float = 15_000.0
    eye_height_m: float = 1.7

    def __post_init__(self):
        if not (0 < self.azimuth_step_deg <= 90 and self.max_distance_m > 0):
            raise ValueError("the paper's rays need a step in (0, 90] degrees and a positive range")


def paper_horizon(terrain, observer, options=PaperHorizonOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Cast the paper's rays.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
        Its own eye height and elevation are not used: the paper uses z(cell) + 1.7 m only.
    options : PaperHorizonOptions
    progress : Progress

    Returns
    -------
    HorizonProfile
        Given at *true* azimuths, as elsewhere: the grid bearings are turned by the convergence at the observer
        (the paper does this for its wedge only, eq. 9), by the nearest ray. Slope alpha = (z - z_obs) / (s cell), s
        counting cells (eqs. 2-3); horizon = atan(max alpha) (eq. 4). `distance_m` is s times the cell size.
        `clipped` marks rays that leave the raster before R_max, `void` those that meet cells without data.

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
        The observer is outside the DEM, or the DEM has a void there.
    """
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, 1.5 * options.max_distance_m)
    position = observer.longitude_deg, observer.latitude_deg
    row, col = int(np.floor(frame.row_px + 0.5)), int(np.floor(frame.col_px + 0.5))
    if not (0 <= row < terrain.shape[0] and 0 <= col < terrain.shape[1]):
        raise ObserverOutsideDemError(*position)
    cell_m = frame.cell_m
    steps = max(int(options.max_distance_m / cell_m + 1e-6), 1)
    window = Window(row - steps, col - steps, 2 * steps + 1, 2 * steps + 1).clipped(terrain.shape)
    cells = terrain.read(window)
    eye_m = float(cells[row - window.row, col - window.col]) + options.eye_height_m
    if not np.isfinite(eye_m):
        raise NoElevationAtObserverError(*position)
    count = int(round(360.0 / options.azimuth_step_deg))
    azimuth = np.arange(count) * (360.0 / count)
    grid_azimuth = np.round(true_to_grid(azimuth, frame.convergence_deg) * count / 360.0) * (360.0 / count)
    alpha, step, inside, void = (np.empty(count) for _ in range(4))
    for first in range(0, count, BATCH_RAYS):
        checkpoint(progress, first / count)
        part = slice(first, first + BATCH_RAYS)
        eye = row - window.row, col - window.col, eye_m
        alpha[part], step[part], inside[part], void[part] = _cast(cells, eye, grid_azimuth[part], steps, frame)
    known = np.isfinite(alpha)
    return HorizonProfile(
        azimuth_deg=azimuth,
        elevation_deg=np.where(known, np.degrees(np.arctan(np.where(known, alpha, 0.0))), np.nan),
        distance_m=np.where(known, step * cell_m, np.nan),
        clipped=inside < steps,
        void=void > 0,
        eye_elevation_m=eye_m,
        cell_m=cell_m,
        reach_m=inside * cell_m,
    )


def _cast(cells, eye, grid_azimuth_deg, steps, frame):
    """Highest slope of each ray, the step at which it lies, the steps inside the raster, and the voids on the ray.

    The eye is its row and column among the cells and its elevation [m]. The frame gives the cell size and the direction
    of the rows.
    """
    eye_row, eye_col, eye_m = eye
    down = -1.0 if frame.row_goes_south else 1.0
    s = np.arange(1, steps + 1)
    theta = np.radians(grid_azimuth_deg)[:, None]
    row = np.floor(eye_row + down * s * np.cos(theta) + 0.5).astype(np.intp)
    col = np.floor(eye_col + s * np.sin(theta) + 0.5).astype(np.intp)
    inside = (row >= 0) & (row < cells.shape[0]) & (col >= 0) & (col < cells.shape[1])
    inside = np.logical_and.accumulate(inside, axis=1)
    elevation = cells[np.where(inside, row, 0), np.where(inside, col, 0)]
    alpha = (elevation.astype(float) - eye_m) / (s * frame.cell_m)
    unknown = np.isnan(alpha)
    alpha[unknown | ~inside] = -np.inf
    best = alpha.argmax(axis=1)
    pick = np.arange(len(row))
    return alpha[pick, best], s[best], inside.sum(axis=1), (unknown & inside).sum(axis=1)
