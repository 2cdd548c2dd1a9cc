"""What the elevation model shows from one eye: places behind pixels, spots of the map, summits. Arrays, no widgets."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from ...core.base.angles import difference
from ...core.base.directions import Directions
from ...core.base.overlay_lines import HorizonLines
from ...core.base.posed import PosedPhoto
from ...core.base.terrain import Observer
from ...core.base.uncertainty import PoseUncertainty

REACH_M = 100_000.0
"""Nothing farther from the eye is looked at [m]."""

ELLIPSE_CORNERS = 48


@dataclass(frozen=True, eq=False)
class Ground:
    """The terrain around one eye.

    Attributes
    ----------
    terrain : core.io.raster.Dem
    observer : Observer
        With the elevation of the eye.
    horizon : HorizonProfile
    ridges : RidgeEdges
        Crests below the horizon.
    """

    terrain: Any
    observer: Observer
    horizon: Any
    ridges: Any

    @cached_property
    def frame(self):
        """Frame around the eye, as far as anything is looked at."""
        return self.terrain.frame(self.observer.longitude_deg, self.observer.latitude_deg, 1.01 * REACH_M)

    @cached_property
    def lines(self):
        """The horizon, ready for one pose after another."""
        return HorizonLines(self.horizon)

    @cached_property
    def crests(self):
        """The crests, ready for one pose after another."""
        return Directions.of(self.ridges.azimuth_deg, self.ridges.elevation_deg)


@dataclass(frozen=True, eq=False)
class Place:
    """What a pixel shows.

    Attributes
    ----------
    state : str
        'ground', 'sky', 'void' or 'beyond'.
    azimuth_deg, elevation_deg : float
        Direction from the eye [degrees].
    longitude_deg, latitude_deg, elevation_m, distance_m : float
        NaN unless on the ground.
    near_m, far_m : float
        5 % and 95 % quantiles of the distance [m].
    ellipse : (lon, lat) arrays or None
        Outline of the area that holds the true place with a probability of 90 %.
    """

    state: str
    azimuth_deg: float
    elevation_deg: float
    longitude_deg: float = np.nan
    latitude_deg: float = np.nan
    elevation_m: float = np.nan
    distance_m: float = np.nan
    near_m: float = np.nan
    far_m: float = np.nan
    ellipse: tuple | None = None

    @property
    def on_ground(self):
        """Whether the pixel shows known ground."""
        return self.state == "ground"


@dataclass(frozen=True)
class Spot:
    """Where a place of the map appears.

    Attributes
    ----------
    state : str
        'visible', 'hidden', 'outside' or 'unknown'.
    x_px, y_px : float
        NaN behind the camera.
    turn_deg : float
        Azimuth minus heading, + to the right [degrees].
    distance_m : float
    hidden_at_m : float
        Distance of the terrain that hides it; NaN if nothing does [m].
    """

    state: str
    x_px: float
    y_px: float
    turn_deg: float
    distance_m: float
    hidden_at_m: float = np.nan


def ground_of(terrain, observer, cache, progress):
    """Compute what the DEM shows from an eye.

    Parameters
    ----------
    terrain : core.io.raster.Dem
    observer : Observer
    cache : core.eyes.HorizonCache
    progress : Progress

    Raises
    ------
    PhotoError
        The eye is not on the DEM.
    """
    from ...core.pipeline import OrientOptions

    options = OrientOptions()
    horizon = cache.profile(terrain, observer, options.horizon, progress)
    inner = cache.inner(terrain, observer, options.inner, progress)
    return Ground(terrain, replace(observer, eye_elevation_m=horizon.eye_elevation_m), horizon, inner.ridges)


def posed_photo(ground, camera, pose, uncertainty=None):
    """Place a camera with a pose at the eye."""
    return PosedPhoto(camera, pose, ground.observer, uncertainty or PoseUncertainty())


def _options():
    from ...core.mapping.sightline import SightOptions

    return SightOptions(max_distance_m=REACH_M)


def view_of(ground, posed):
    """Open the view of a posed photograph."""
    from ...core.base.view import View

    return View(posed, ground.frame, ground.observer.eye_elevation_m)


def place_of(ground, posed, x_px, y_px):
    """Find what a pixel shows.

    Parameters
    ----------
    ground : Ground
    posed : PosedPhoto
    x_px, y_px : float

    Returns
    -------
    Place
    """
    from ...core.mapping.monoplot import ground_ellipses, place_pixels
    from ...core.mapping.sightline import STATE_NAMES

    view, options = view_of(ground, posed), _options()
    placed = place_pixels(ground.terrain, view, [x_px], [y_px], options)
    hits, direction = placed.hits, (float(placed.azimuth_deg[0]), float(placed.elevation_deg[0]))
    state = STATE_NAMES[int(hits.state[0])]
    if state != "ground":
        return Place(state, *direction)
    errors = ground_ellipses(ground.terrain, view, placed, options=options)
    east, north = float(hits.east_m[0]), float(hits.north_m[0])
    ring = _ring(errors.semi_major_m[0], errors.semi_minor_m[0], errors.azimuth_deg[0])
    longitude, latitude = _positions(ground.terrain, view.frame, east, north)
    ellipse = None if ring is None else _positions(ground.terrain, view.frame, east + ring[0], north + ring[1])
    numbers = hits.elevation_m[0], hits.distance_m[0], errors.near_m[0], errors.far_m[0]
    values: list[Any] = [*direction, float(longitude), float(latitude), *map(float, numbers), ellipse]
    return Place(state, *values)


def _ring(major_m, minor_m, azimuth_deg):
    if not np.isfinite([major_m, minor_m, azimuth_deg]).all():
        return None
    turn, angle = np.linspace(0, 2 * np.pi, ELLIPSE_CORNERS), np.radians(azimuth_deg)
    along, across = major_m * np.cos(turn), minor_m * np.sin(turn)
    return along * np.sin(angle) + across * np.cos(angle), along * np.cos(angle) - across * np.sin(angle)


def _positions(terrain, frame, east_m, north_m):
    return terrain.position_of(*frame.to_pixel(np.asarray(east_m, float), np.asarray(north_m, float)))


def spot_of(ground, posed, longitude_deg, latitude_deg):
    """Find where a place of the map appears in the picture.

    Parameters
    ----------
    ground : Ground
    posed : PosedPhoto
    longitude_deg, latitude_deg : float

    Returns
    -------
    Spot
    """
    from ...core.mapping.projecting import STATE_NAMES, Places, project_places
    from ...core.mapping.sightline import SightLines, cast_rays

    view, options = view_of(ground, posed), _options()
    east, north = (np.atleast_1d(v) for v in ground.terrain.local_of(ground.observer, longitude_deg, latitude_deg))
    shown = project_places(ground.terrain, view, Places(east, north), options)
    state, hidden_at = STATE_NAMES[int(shown.state[0])], np.nan
    if state == "hidden":
        lines = SightLines(view.eye_elevation_m, shown.azimuth_deg, shown.elevation_deg, end_m=shown.distance_m)
        hidden_at = float(cast_rays(ground.terrain, view.frame, lines, options).distance_m[0])
    turn = float(difference(shown.azimuth_deg[0], posed.pose.heading_deg))
    return Spot(state, float(shown.x_px[0]), float(shown.y_px[0]), turn, float(shown.distance_m[0]), hidden_at)


def wedge_of(ground, posed, length_m):
    """Outline of the ground that the picture can show, as (lon, lat) arrays.

    Parameters
    ----------
    ground : Ground
    posed : PosedPhoto
    length_m : float
    """
    centre, width = view_of(ground, posed).wedge_deg
    azimuth = np.radians(np.linspace(centre - width / 2, centre + width / 2, 25))
    east = np.r_[0.0, length_m * np.sin(azimuth), 0.0]
    north = np.r_[0.0, length_m * np.cos(azimuth), 0.0]
    return _positions(ground.terrain, ground.frame, east, north)


def places_of(ground, posed, points):
    """Find what several pixels show, without their errors.

    Parameters
    ----------
    ground : Ground
    posed : PosedPhoto
    points : sequence of (x_px, y_px)

    Returns
    -------
    list of Place
    """
    from ...core.mapping.monoplot import place_pixels
    from ...core.mapping.sightline import STATE_NAMES

    view = view_of(ground, posed)
    x, y = np.asarray(points, float).reshape(-1, 2).T
    placed = place_pixels(ground.terrain, view, x, y, _options())
    hits = placed.hits
    longitude, latitude = _positions(ground.terrain, view.frame, hits.east_m, hits.north_m)
    columns = (
        placed.azimuth_deg, placed.elevation_deg, longitude, latitude, hits.elevation_m, hits.distance_m
    )  # fmt: skip
    rows: list[list[Any]] = [[float(column[k]) for column in columns] for k in range(len(x))]
    return [Place(STATE_NAMES[int(state)], *row) for state, row in zip(hits.state, rows)]
