"""Determine where a photograph was taken, and how certain that is, from its file and from what was given."""

from __future__ import annotations

from typing import Any

import numpy as np

from .errors import MissingMetadataError
from .messages import Message
from .model import PhotoMetadata
from .terrain import Observer, Terrain, ground_elevation_m
from .uncertainty import TYPICAL_POSITION_ERROR_M

USELESS_POSITION_ERROR_M = 1_000.0
"""A position of this or a larger standard deviation is refused: the horizon there is not that of the photograph [m]."""

FAR_BELOW_M, FAR_ABOVE_M = 100.0, 1_000.0
"""An eye this far below the DEM's surface, or above it, is more likely a wrong number than a place [m]."""

SAME_PLACE_DEG = 5e-5
"""A given position this close to the recorded one is the recorded one [degrees of latitude, 5 m]."""


def position_of(request: Any, metadata: PhotoMetadata) -> tuple[float, float]:
    """Choose the position: the given one, or the recorded one if none is given or it is preferred.

    Parameters
    ----------
    request : core.batch.PhotoRequest
    metadata : PhotoMetadata

    Returns
    -------
    longitude_deg, latitude_deg : float

    Raises
    ------
    MissingMetadataError
    """
    if _given_counts(request, metadata):
        return float(request.longitude_deg), float(request.latitude_deg)
    if _usable(metadata.longitude_deg, metadata.latitude_deg):
        return float(metadata.longitude_deg or 0.0), float(metadata.latitude_deg or 0.0)
    raise MissingMetadataError(Message("The photo has no GPS position. Supply it as a point in a photo point layer."))


def position_error_of(request: Any, metadata: PhotoMetadata) -> float:
    """Give the standard deviation of the position [m]: as given, as recorded, or the usual one.

    Parameters
    ----------
    request : core.batch.PhotoRequest
    metadata : PhotoMetadata

    Raises
    ------
    MissingMetadataError
        The position is so uncertain that it decides nothing.
    """
    error = request.position_error_m
    if error is None and (not _given_counts(request, metadata) or _is_recorded(request, metadata)):
        error = metadata.position_error_m
    if error is not None and error >= USELESS_POSITION_ERROR_M:
        raise MissingMetadataError(
            Message(
                "The GPS position is uncertain by {km} km, too much for a horizon, so the right one is needed. "
                "Supply it as a point in a photo point layer.",
                km=f"{error / 1000:.1f}",
            )
        )
    return float(error or TYPICAL_POSITION_ERROR_M)


def doubts_of_place(terrain: Terrain, observer: Observer, position_error_m: float | None = None) -> tuple[Message, ...]:
    """Say what is unlikely about the place of an eye from which terrain is about to be computed.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    position_error_m : float or None
        Recorded radius or standard deviation of the position [m].

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
        The eye has an elevation of its own, and the DEM has none there.
    """
    doubts = []
    if position_error_m is not None and position_error_m >= USELESS_POSITION_ERROR_M:
        doubts.append(
            Message(
                "The position is uncertain by {km} km (h_acc), so the result may hold for another place than the "
                "camera's. Move the point to where the camera was, and clear h_acc.",
                km=f"{position_error_m / 1000:.1f}",
            )
        )
    above_m = observer.eye_height_m
    if observer.eye_elevation_m is not None:
        frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, 1_000.0)
        above_m = observer.eye_elevation_m - ground_elevation_m(terrain, frame)
    if above_m < -FAR_BELOW_M:
        doubts.append(
            Message(
                "The eye lies {metres} m below the DEM's surface, so the result is not what a camera sees. Check the "
                "camera's elevation (HEIGHT_FIELD), and the unit of the DEM's heights (DEM_UNIT).",
                metres=f"{-above_m:.0f}",
            )
        )
    elif above_m > FAR_ABOVE_M:
        doubts.append(
            Message(
                "The eye lies {metres} m above the DEM's surface. Unless the camera flew so high, check its elevation "
                "(HEIGHT_FIELD), its height above the ground (EYE_HEIGHT), and the unit of the DEM's heights "
                "(DEM_UNIT).",
                metres=f"{above_m:.0f}",
            )
        )
    return tuple(doubts)


def _given_counts(request: Any, metadata: PhotoMetadata) -> bool:
    recorded = _usable(metadata.longitude_deg, metadata.latitude_deg)
    return _usable(request.longitude_deg, request.latitude_deg) and not (recorded and request.prefer_photo_position)


def _is_recorded(request: Any, metadata: PhotoMetadata) -> bool:
    """Tell whether the given position is the one in the file, as in layers made from photographs."""
    longitude, latitude = metadata.longitude_deg, metadata.latitude_deg
    if longitude is None or latitude is None or not _usable(longitude, latitude):
        return False
    east_deg = abs(request.longitude_deg - longitude) * np.cos(np.radians(latitude))
    return bool(east_deg < SAME_PLACE_DEG and abs(request.latitude_deg - latitude) < SAME_PLACE_DEG)


def _usable(longitude_deg: float | None, latitude_deg: float | None) -> bool:
    if longitude_deg is None or latitude_deg is None or not np.isfinite([longitude_deg, latitude_deg]).all():
        return False
    return abs(latitude_deg) <= 90 and (longitude_deg, latitude_deg) != (0, 0)
