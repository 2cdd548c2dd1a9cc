r"""Rays from an eye to the ground: the point of the terrain that lies in a given direction.

Seen from the eye, a point at ground distance d and elevation z has the elevation angle
atan((z - drop(d) - eye) / d), where the drop is curvature less refraction. A ray of one elevation angle is therefore
the parabola eye + d tan(elevation) + drop(d) over the map, and it reaches the terrain where the bilinear surface of
the DEM first meets it. That crossing is found exactly, patch by patch; block maxima skip the air before it::

    eye *-.__
             `--.__        ________
                   `--.__ / ridge  \      the parabola stays above the block's bound: one step
                         X          \__   first patch that it can touch: solve a quadratic
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..base.curvature import EARTH_RADIUS_M, REFRACTION_COEFFICIENT
from ..base.progress import SILENT, checkpoint, subtask
from ..base.terrain import Window
from .march import BEYOND, GROUND, SKY, VOID, MarchingRays, build_pyramid, march

STATE_NAMES = {GROUND: "ground", SKY: "sky", VOID: "void", BEYOND: "beyond"}

MAX_WINDOW_CELLS = 24_000_000
"""Cells read at once: about 100 MB, and half as much again for the bounds."""

BATCH_RAYS = 200_000


@dataclass(frozen=True)
class SightOptions:
    """The range of the rays.

    Attributes
    ----------
    min_distance_m : float
        Nothing nearer than this stops a ray [m].
    max_distance_m : float
        Nothing farther than this is examined [m].
    refraction_coefficient : float
        See `core.base.curvature`.
    """

    min_distance_m: float = 0.0
    max_distance_m: float = 60_000.0
    refraction_coefficient: float = REFRACTION_COEFFICIENT

    def __post_init__(self):
        if not 0 <= self.min_distance_m < self.max_distance_m:
            raise ValueError(f"distances must satisfy 0 <= min < max, not {self}")


@dataclass(frozen=True, eq=False)
class GroundHits:
    """End points of rays.

    Attributes
    ----------
    state : (N,) uint8 array
        `GROUND`, `SKY`, `VOID` or `BEYOND`.
    east_m, north_m : (N,) arrays
        Local metres in the observer's frame, NaN unless `GROUND` [m].
    elevation_m : (N,) array
        Elevation of the surface there [m].
    distance_m : (N,) array
        Distance along the ground from the ray's origin [m].
    """

    state: np.ndarray
    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray
    distance_m: np.ndarray

    @property
    def on_ground(self):
        """(N,) bool array: rays that reach known terrain."""
        return self.state == GROUND


@dataclass(frozen=True, eq=False)
class SightLines:
    """Rays to cast; all arrays broadcast together to (N,).

    Attributes
    ----------
    eye_elevation_m : float or array
        Elevation of the rays' origins [m].
    azimuth_deg, elevation_deg : float or array
        True azimuth and elevation angle above the horizontal [degrees].
    east_m, north_m : float or array
        Origins in local metres, 0 at the observer [m].
    end_m : float or array
        Distance at which the ray ends [m].
    """

    eye_elevation_m: Any
    azimuth_deg: Any
    elevation_deg: Any
    east_m: Any = 0.0
    north_m: Any = 0.0
    end_m: Any = np.inf


def cast_rays(terrain, frame, lines, options=None, progress=SILENT):
    """Find where rays first reach the terrain.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
        Frame around the observer, reaching at least as far as the rays.
    lines : SightLines
    options : SightOptions or None
    progress : Progress

    Returns
    -------
    GroundHits

    Notes
    -----
    A ray that starts inside the terrain (an eye below the DEM's coarse surface, or `min_distance_m` behind a hill)
    passes out of it: only a surface reached from above stops a ray.
    """
    options = options or SightOptions()
    given = lines.azimuth_deg, lines.elevation_deg, lines.eye_elevation_m, lines.east_m, lines.north_m, lines.end_m
    azimuth, elevation, eye, east, north, end = (np.array(a, float) for a in np.broadcast_arrays(*given))
    shape = azimuth.shape
    rays = MarchingRays(
        east.ravel(),
        north.ravel(),
        np.sin(np.radians(azimuth.ravel())),
        np.cos(np.radians(azimuth.ravel())),
        np.tan(np.radians(elevation.ravel())),
        eye.ravel(),
        np.minimum(end.ravel(), options.max_distance_m),
        (1 - options.refraction_coefficient) / (2 * EARTH_RADIUS_M),
        np.full(azimuth.size, options.min_distance_m),
    )
    count = azimuth.size
    state, reach = np.full(count, SKY, np.uint8), np.full(count, np.nan)
    for start in range(0, count, BATCH_RAYS):
        part = slice(start, min(start + BATCH_RAYS, count))
        share = subtask(progress, start / count, part.stop / count)
        state[part], reach[part] = _cast_batch(terrain, frame, rays.take(part), share)
    hit = state == GROUND
    place_east, place_north = rays.place(reach)
    columns = (state, place_east, place_north, np.where(hit, rays.height(reach), np.nan), reach)
    return GroundHits(*(column.reshape(shape) for column in columns))


def _cast_batch(terrain, frame, rays, progress):
    """March rays outwards through windows of bounded size and return (state, distance)."""
    count = rays.distance_m.size
    state, reach = np.full(count, SKY, np.uint8), np.full(count, np.nan)
    alive = np.flatnonzero((rays.end_m > rays.distance_m) & np.isfinite(rays.slope))
    above = np.zeros(count, bool)
    lowest_ground = np.inf
    while alive.size:
        done = rays.distance_m[alive].min() / rays.end_m[alive].max()
        checkpoint(progress, float(np.clip(done, 0, 1)))
        stop, window = _next_window(terrain.shape, frame, rays.take(alive))
        if window is None:
            break
        pyramid = build_pyramid(terrain.read(window))
        lowest_ground = min(lowest_ground, float(np.nanmin(pyramid.elevation_m, initial=np.inf)))
        part = rays.take(alive)
        part_above = above[alive]
        part_stop = np.minimum(part.end_m, stop)
        found, left = march(pyramid, window, frame, part, part_above, part_stop)
        state[alive], above[alive] = found, part_above
        reach[alive] = np.where(found == GROUND, part.distance_m, np.nan)
        rays.distance_m[alive] = part.distance_m
        alive = alive[(found == SKY) & ~left & (part.distance_m < part.end_m)]
    state[(state == SKY) & _must_land(rays, lowest_ground)] = BEYOND
    return state, reach


def _must_land(rays, lowest_ground_m):
    """Rays that were still free at the end of the DEM but would later pass below the lowest ground seen."""
    vertex = np.minimum(-rays.slope / (2 * rays.bend_per_m + 1e-300), 1e9)
    return (vertex > rays.distance_m) & (rays.height(vertex) < lowest_ground_m)


def _next_window(shape, frame, rays):
    """Choose how far to go next, and the window of patches that all rays cross up to there."""
    start, end = rays.distance_m.min(), rays.end_m.max()
    stop = end
    for _ in range(40):
        window = _window_between(shape, frame, rays, start, stop)
        if window is None or window.rows * window.cols <= MAX_WINDOW_CELLS:
            break
        stop = start + (stop - start) / 2
    return stop, window


def _window_between(shape, frame, rays, start, stop, nodes=9):
    start_m, stop_m = np.maximum(rays.distance_m, start), np.minimum(rays.end_m, stop)
    steps = np.linspace(0.0, 1.0, nodes)[:, None]
    distance = start_m + (np.maximum(stop_m, start_m) - start_m) * steps
    col, row = frame.to_pixel(*rays.place(distance))
    low_row, low_col = int(np.floor(row.min())) - 2, int(np.floor(col.min())) - 2
    high_row, high_col = int(np.ceil(row.max())) + 3, int(np.ceil(col.max())) + 3
    window = Window(low_row, low_col, high_row - low_row, high_col - low_col).clipped(shape)
    return window if window.rows >= 2 and window.cols >= 2 else None
