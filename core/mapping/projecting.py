"""From the map to the picture: the positions of places in an oriented photograph, and whether anything hides them.

A place is visible if its own sight line, cast like any pixel's ray, reaches it. Lines are followed in steps of a pixel
or two and cut where their state changes. Areas are tested on a grid of sample places.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any

import numpy as np

from ..base.angles import in_wedge
from ..base.progress import SILENT
from ..base.surface import elevation_at
from .sightline import GROUND, VOID, SightLines, SightOptions, cast_rays


class PlaceState(IntEnum):
    """The state of a place in a photograph.

    `HIDDEN`: behind terrain. `OUTSIDE`: outside the picture, or too far away. `UNKNOWN`: the DEM has no elevation
    there, or a hole before it.
    """

    HIDDEN = 0
    VISIBLE = 1
    OUTSIDE = 2
    UNKNOWN = 3


STATE_NAMES: dict[int, str] = {state: state.name.lower() for state in PlaceState}


@dataclass(frozen=True, eq=False)
class Places:
    """Places to find in a picture.

    Attributes
    ----------
    east_m, north_m : (N,) arrays
        Positions in local metres around the eye [m].
    elevation_m : (N,) array or None
        Absolute elevation; NaN or None means on the surface [m]. To decide visibility, a place given below the surface
        is raised to it, so that a summit whose published height differs from that of a coarse DEM is judged correctly.
    height_above_m : float or (N,) array
        Height added to the elevation, for example of a tower or tree [m].
    own_ground_m : float, (N,) array or None
        Ground this close in front of a place belongs to it and does not hide it [m]; None means one cell. A summit
        needs more, because the edge of its top is still the summit.
    """

    east_m: Any
    north_m: Any
    elevation_m: Any = None
    height_above_m: Any = 0.0
    own_ground_m: Any = None


@dataclass(frozen=True, eq=False)
class ProjectedPlaces:
    """Places and their positions in the picture.

    Attributes
    ----------
    state : (N,) uint8 array
        Values of `PlaceState`.
    x_px, y_px : (N,) arrays
        Pixels of the full upright picture, also of hidden places and of places outside the picture; NaN behind the
        camera.
    azimuth_deg, elevation_deg : (N,) arrays
        Direction from the eye [degrees].
    distance_m : (N,) array
        Distance along the ground [m].
    elevation_m : (N,) array
        Elevation of the place as used [m].
    """

    state: np.ndarray
    x_px: np.ndarray
    y_px: np.ndarray
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    elevation_m: np.ndarray

    @property
    def visible(self):
        """(N,) bool array: places in state `VISIBLE`."""
        return self.state == PlaceState.VISIBLE


@dataclass(frozen=True, eq=False)
class ProjectedRun:
    """A stretch of a line in one state.

    Attributes
    ----------
    state : PlaceState
    x_px, y_px : (N,) arrays
        Pixels along the stretch.
    share : tuple of two floats
        Start and end on the line, as shares of the line's length, 0 to 1.
    distance_m : (N,) array
        Distance of its places from the eye [m].
    """

    state: int
    x_px: np.ndarray
    y_px: np.ndarray
    share: tuple
    distance_m: np.ndarray


def project_places(terrain, view, places, options=None, all_round=False, progress=SILENT):
    """Project places into the picture.

    Parameters
    ----------
    terrain : Terrain
    view : View
    places : Places
    options : SightOptions or None
    all_round : bool
        Ignore the picture's frame: no place is `OUTSIDE` because of its direction.
    progress : Progress

    Returns
    -------
    ProjectedPlaces
    """
    options = options or SightOptions(refraction_coefficient=view.refraction_coefficient)
    east_m, north_m = np.broadcast_arrays(np.asarray(places.east_m, float), np.asarray(places.north_m, float))
    surface = elevation_at(terrain, view.frame, east_m, north_m)
    given = surface
    if places.elevation_m is not None:
        given = np.where(np.isfinite(places.elevation_m), places.elevation_m, surface)
    shown = given + places.height_above_m
    azimuth, elevation, distance = view.direction_of(east_m, north_m, shown)
    x, y = view.pixel_of(east_m, north_m, shown)
    state = np.full(east_m.shape, PlaceState.OUTSIDE, np.uint8)
    near_enough = (distance >= options.min_distance_m) & (distance <= options.max_distance_m)
    asked = near_enough & (np.full(east_m.shape, True) if all_round else view.frames(x, y))
    ahead = in_wedge(azimuth, *view.wedge_deg) | all_round
    state[near_enough & ahead & ~np.isfinite(shown)] = PlaceState.UNKNOWN
    asked &= np.isfinite(shown)
    top = np.fmax(given, surface) + places.height_above_m
    own = view.frame.cell_m if places.own_ground_m is None else places.own_ground_m
    own = np.broadcast_to(own, east_m.shape)[asked]
    tops = Places(east_m[asked], north_m[asked], top[asked], own_ground_m=own)
    state[asked] = _states(terrain, view, tops, options, progress)
    return ProjectedPlaces(state, x, y, azimuth, elevation, distance, shown)


def _states(terrain, view, tops, options, progress):
    """State of places known to lie in the picture."""
    azimuth, elevation, distance = view.direction_of(tops.east_m, tops.north_m, tops.elevation_m)
    lines = SightLines(view.eye_elevation_m, azimuth, elevation, end_m=distance - tops.own_ground_m)
    state = cast_rays(terrain, view.frame, lines, options, progress).state
    hidden = [state == GROUND, state == VOID]
    return np.select(hidden, [int(PlaceState.HIDDEN), int(PlaceState.UNKNOWN)], int(PlaceState.VISIBLE))


def densify(east_m, north_m, view, step_px=2.0, elevation_m=None, longest=20_000):
    """Insert places along a line so that neighbours lie about `step_px` apart in the picture.

    Parameters
    ----------
    east_m, north_m : (N,) arrays
        Vertices in local metres [m].
    view : View
    step_px : float
        Desired step [pixels].
    elevation_m : (N,) array or None
        Elevations of the vertices, interpolated along the line [m].
    longest : int
        Approximate upper limit of the number of places.

    Returns
    -------
    east_m, north_m, elevation_m, share : arrays
        The last is the position along the line, 0 to 1; the elevation is NaN if none was given.
    """
    east_m, north_m = np.asarray(east_m, float), np.asarray(north_m, float)
    elevation_m = np.full(east_m.shape, np.nan) if elevation_m is None else np.asarray(elevation_m, float)
    length = np.hypot(np.diff(east_m), np.diff(north_m))
    total = length.sum()
    if east_m.size < 2 or total == 0:
        return east_m, north_m, elevation_m, np.zeros(east_m.shape)
    # A step across the line of sight never appears wider than this in the picture.
    nearest = np.maximum(_nearest_m(east_m, north_m), 0.5 * view.frame.cell_m)
    pieces = np.ceil(length * view.camera.focal_px / nearest / step_px)
    pieces = np.clip(pieces, 1, np.maximum(np.ceil(4 * length / view.frame.cell_m), 1))
    pieces = np.maximum(np.ceil(pieces * min(1.0, longest / pieces.sum())), 1).astype(int)
    t = np.concatenate([k + np.arange(n) / n for k, n in enumerate(pieces)] + [[float(len(pieces))]])
    vertex = np.arange(east_m.size, dtype=float)
    run = np.concatenate([[0.0], np.cumsum(length)]) / total
    return tuple(np.interp(t, vertex, value) for value in (east_m, north_m, elevation_m, run))


def _nearest_m(east_m, north_m):
    """Smallest distance of each segment from the origin [m]."""
    de, dn = np.diff(east_m), np.diff(north_m)
    t = -(east_m[:-1] * de + north_m[:-1] * dn) / np.maximum(de * de + dn * dn, 1e-12)
    t = np.clip(t, 0.0, 1.0)
    return np.hypot(east_m[:-1] + t * de, north_m[:-1] + t * dn)


def project_line(terrain, view, line, step_px=2.0, options=None, progress=SILENT):
    """Project a line and cut it where its state changes.

    Parameters
    ----------
    terrain : Terrain
    view : View
    line : Places
        Vertices of the line, which follows the surface unless elevations are given.
    step_px : float
        See `densify` [pixels].
    options : SightOptions or None
    progress : Progress

    Returns
    -------
    tuple of ProjectedRun
        In the line's order; neighbouring runs share a place, so that no gap shows.
    """
    east, north, height, share = densify(line.east_m, line.north_m, view, step_px, line.elevation_m)
    places = project_places(terrain, view, replace(line, east_m=east, north_m=north, elevation_m=height), options,
                            progress=progress)  # fmt: skip
    return _runs(places, share)


def _runs(places, share):
    change = np.flatnonzero(np.diff(places.state)) + 1
    runs = []
    for start, stop in zip(np.concatenate([[0], change]), np.concatenate([change, [places.state.size]])):
        part = slice(start, min(stop + 1, places.state.size))
        runs.append(
            ProjectedRun(
                PlaceState(int(places.state[start])),
                places.x_px[part],
                places.y_px[part],
                (float(share[start]), float(share[part][-1])),
                places.distance_m[part],
            )  # fmt: skip
        )
    return tuple(runs)


def sample_area(rings, spacing_m):
    """Sample places on a grid over an area, inside by the even-odd rule.

    Parameters
    ----------
    rings : sequence of (east_m, north_m) arrays
        Outer and inner rings in any order and direction, in local metres.
    spacing_m : float
        Spacing of the grid [m]; widened if it would give more than about 40,000 places.

    Returns
    -------
    east_m, north_m : arrays
    """
    all_east = np.concatenate([np.asarray(e, float) for e, _ in rings])
    all_north = np.concatenate([np.asarray(n, float) for _, n in rings])
    width, height = np.ptp(all_east), np.ptp(all_north)
    spacing = max(spacing_m, np.sqrt(width * height / 40_000), max(width, height) / 5_000, 1e-6)
    east = np.arange(all_east.min() + spacing / 2, all_east.max() + spacing / 2, spacing)
    north = np.arange(all_north.min() + spacing / 2, all_north.max() + spacing / 2, spacing)
    east, north = (grid.ravel() for grid in np.meshgrid(east, north))
    inside = np.zeros(east.shape, bool)
    for ring_east, ring_north in rings:
        inside ^= _inside_ring(east, north, np.asarray(ring_east, float), np.asarray(ring_north, float))
    return east[inside], north[inside]


def _inside_ring(east, north, ring_east, ring_north):
    inside = np.zeros(east.shape, bool)
    for e1, n1, e2, n2 in zip(ring_east, ring_north, np.roll(ring_east, -1), np.roll(ring_north, -1)):
        if n1 != n2:
            crosses = (n1 > north) != (n2 > north)
            inside ^= crosses & (east < e1 + (north - n1) / (n2 - n1) * (e2 - e1))
    return inside
