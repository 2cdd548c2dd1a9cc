"""How one photograph shows given places, so that many photographs can be ranked for each place.

A place is a set of sample points: one for a point, a chain for a line, a grid for an area. The ranking depends on how
much of it is visible, how many pixels a metre of it covers, and how squarely it faces the camera.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.camera import to_camera_axes
from ..base.progress import SILENT
from ..base.summit_heights import contradicts
from ..base.surface import elevation_at, incidence_deg, normal_at
from .peaks import HEIGHT_WEIGHT, own_ground_m, snap_to_summit
from .projecting import Places, ProjectedPlaces, project_places


@dataclass(frozen=True)
class Sighting:
    """How one photograph shows one place.

    Attributes
    ----------
    place : int
        Index of the place.
    visible_share : float
        Share of its sample points that are visible, 0 to 1.
    framed_share : float
        Share of its sample points that lie within the frame, visible or hidden.
    x_px, y_px : float
        Middle of its visible points in the picture [pixels].
    distance_m : float
        Median distance of the visible points along the ground [m].
    azimuth_deg, elevation_deg : float
        Direction from the camera to the visible point nearest the middle [degrees].
    pixels_per_metre : float
        Median number of pixels per metre across the line of sight.
    incidence_deg : float
        Median angle between line of sight and surface normal; 0 head-on, 90 grazing [degrees].
    quality : float
        visible_share x pixels_per_metre x cos(incidence): pixels per metre of ground in the less favourable direction.
    """

    place: int
    visible_share: float
    framed_share: float
    x_px: float
    y_px: float
    distance_m: float
    azimuth_deg: float
    elevation_deg: float
    pixels_per_metre: float
    incidence_deg: float
    quality: float


def place_of_height(terrain, frame, place, elevation_m, radius_m=500.0, doubted=contradicts):
    """Place of a point with a published height: on the DEM's own top if it is a summit, else where it is published.

    It is a summit if position and height together agree better with a top of the DEM nearby than with the ground at the
    published position. A hut or a village has the height of the ground on which it stands.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
    place : (east_m, north_m) floats
        Published place in local metres [m].
    elevation_m : float
        Published height [m].
    radius_m : float
        Search radius; 0 or less leaves every point at its place [m].
    doubted : callable
        Tells from the published height and that of the top [m] whether the DEM contradicts the height; it is asked if
        the ground at the place does. Such a height is not used: the place is then the highest one nearby, as for a
        summit without a height.

    Returns
    -------
    Places
        One place.
    """
    here = float(elevation_at(terrain, frame, *map(np.asarray, place)))
    published = Places(np.array([place[0]]), np.array([place[1]]))
    if radius_m <= 0 or not np.isfinite(here):
        return published
    east, north, top = snap_to_summit(terrain, frame, place[0], place[1], elevation_m, radius_m)
    if contradicts(elevation_m, here) and doubted(elevation_m, top):
        east, north, _ = snap_to_summit(terrain, frame, place[0], place[1], None, radius_m)
        return Places(np.array([east]), np.array([north]), own_ground_m=own_ground_m(frame))
    moved = float(np.hypot(east - place[0], north - place[1]))
    if not HEIGHT_WEIGHT * abs(here - elevation_m) > moved + HEIGHT_WEIGHT * abs(top - elevation_m):
        return published
    return Places(np.array([east]), np.array([north]), np.array([elevation_m]), own_ground_m=own_ground_m(frame))


def find_sightings(terrain, view, places, options=None, height_above_m=0.0, progress=SILENT):
    """Find which places a photograph shows.

    Parameters
    ----------
    terrain : Terrain
    view : View
    places : sequence of Places or of (east_m, north_m) arrays
        Sample points of each place, in local metres around the eye [m]; arrays alone lie on the ground.
    options : SightOptions or None
    height_above_m : float
        Height of the target above the ground [m].
    progress : Progress

    Returns
    -------
    tuple of Sighting
        Sightings of the places that are visible at all, best quality first.
    """
    places = [place if isinstance(place, Places) else Places(*place) for place in places]
    sizes = [np.size(place.east_m) for place in places]
    if not sum(sizes):
        return ()
    owner = np.repeat(np.arange(len(places)), sizes)
    east = np.concatenate([np.ravel(np.asarray(place.east_m, float)) for place in places])
    north = np.concatenate([np.ravel(np.asarray(place.north_m, float)) for place in places])
    height = [_filled(place.elevation_m, size, np.nan) for place, size in zip(places, sizes)]
    own = [_filled(place.own_ground_m, size, view.frame.cell_m) for place, size in zip(places, sizes)]
    wanted = Places(east, north, np.concatenate(height), height_above_m, np.concatenate(own))
    shown = project_places(terrain, view, wanted, options, progress=progress)
    framed = view.frames(shown.x_px, shown.y_px)
    seen = np.flatnonzero(shown.visible)
    incidence = np.full(east.size, np.nan)
    normal = normal_at(terrain, view.frame, east[seen], north[seen])
    incidence[seen] = incidence_deg(normal, shown.azimuth_deg[seen], shown.elevation_deg[seen])
    _, _, depth = to_camera_axes(view.pose, east, north, view.rise_of(east, north, shown.elevation_m))
    samples = _Samples(shown, framed, depth, incidence)
    found = [_sighting(view, place, owner == place, samples) for place in np.unique(owner[seen])]
    return tuple(sorted(found, key=lambda sighting: (-sighting.quality, sighting.place)))


def _filled(value, size, otherwise):
    """Values of the sample points of a place, (size,); a value that is not given is `otherwise`."""
    return np.broadcast_to(np.ravel(otherwise if value is None else value), size).astype(float)


@dataclass(frozen=True, eq=False)
class _Samples:
    """Sample points of all places: how they appear, whether in the frame, depth [m] and incidence [degrees]."""

    shown: ProjectedPlaces
    framed: np.ndarray
    depth_m: np.ndarray
    incidence_deg: np.ndarray


def _sighting(view, place, mine, samples):
    """Summarise one place, whose sample points are `mine`."""
    shown = samples.shown
    visible, framed_share = mine & shown.visible, samples.framed[mine].mean()
    share = visible.sum() / mine.sum()
    per_metre = float(np.median(view.camera.focal_px / np.maximum(samples.depth_m[visible], 1e-6)))
    incidence = samples.incidence_deg[visible]
    known = incidence[np.isfinite(incidence)]
    angle = float(np.median(known)) if known.size else float("nan")
    middle_x, middle_y = shown.x_px[visible].mean(), shown.y_px[visible].mean()
    off = np.where(visible, np.hypot(shown.x_px - middle_x, shown.y_px - middle_y), np.inf)
    nearest = int(np.argmin(off))
    squarely = max(np.cos(np.radians(angle)), 0.0) if np.isfinite(angle) else 0.0
    return Sighting(
        int(place), float(share), float(framed_share), float(middle_x), float(middle_y),
        float(np.median(shown.distance_m[visible])), float(shown.azimuth_deg[nearest]),
        float(shown.elevation_deg[nearest]), per_metre, angle, float(share * per_metre * squarely),
    )  # fmt: skip
