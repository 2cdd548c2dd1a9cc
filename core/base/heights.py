"""Compare recorded altitudes with a DEM, which shows wrong units, height systems and positions.

An altitude of exactly 0 m counts as unknown, because cameras write it if they have none.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .messages import Message

if TYPE_CHECKING:
    from .model import OrientedPhoto, PhotoMetadata

REMARKABLE_M = 30.0
"""Differences below this are usual for phones and are not mentioned."""

GEOID_M = 110.0
"""Largest distance between the ellipsoid and sea level."""

SUSPICIOUS_MEDIAN_M = 100.0
"""A median difference beyond this, over the photos of a run, is no error of GPS receivers."""

SAME_PLACE_SPREAD_M = 40.0
"""Median absolute deviation up to which differences count as one and the same shift."""

UNIT_MATCHES = 60.0, 0.03
"""How well a unit must explain the altitudes: metres, or share of the altitude."""

UNITS = (
    (0.3048, Message("feet")),
    (0.1, Message("decimetres")),
    (0.01, Message("centimetres")),
    (0.001, Message("millimetres")),
    (1000.0, Message("kilometres")),
)


def altitude_limit_m(metadata: PhotoMetadata, cell_m: float, gps_limit_m: float, position_error_m: float) -> float:
    """Give the largest difference between the recorded altitude and the DEM that both may have if the place is right.

    Parameters
    ----------
    metadata : PhotoMetadata
    cell_m : float
        Size of the DEM's cells on the ground [m].
    gps_limit_m : float
        Largest error of a recorded altitude [m].
    position_error_m : float
        Standard deviation of the position [m]; the ground may rise by as much.
    """
    geoid_m = GEOID_M if metadata.altitude_reference == "ellipsoid" else 0.0
    return gps_limit_m + geoid_m + cell_m / 2 + position_error_m


def contradiction(request: Any, metadata: PhotoMetadata, oriented: OrientedPhoto, limit_m: float) -> Message | None:
    """Say why the heights do not allow an answer to be accepted, or None.

    Parameters
    ----------
    request : core.batch.PhotoRequest
    metadata : PhotoMetadata
    oriented : OrientedPhoto
    limit_m : float
        From `altitude_limit_m`.
    """
    ground_m, altitude_m = oriented.ground_elevation_m, metadata.altitude_m
    if ground_m is None:
        return None
    if request.eye_elevation_m is not None:
        below_m = ground_m - request.eye_elevation_m
        if below_m <= limit_m:
            return None
        return Message(
            "The given elevation of the camera lies {metres} m below the DEM's surface, so the answer is not accepted. "
            "Check HEIGHT_FIELD, and the unit of the DEM's heights (DEM_UNIT).",
            metres=f"{below_m:.0f}",
        )
    if not altitude_m or abs(altitude_m - ground_m) <= limit_m:
        return None
    metres = f"{abs(altitude_m - ground_m):.0f}"
    if altitude_m < ground_m:
        return Message(
            "The recorded altitude lies {metres} m below the DEM's surface, more than GPS and DEM allow, so the answer "
            "is not accepted. Check the photo's position, and the unit of the DEM's heights (DEM_UNIT).",
            metres=metres,
        )
    if request.use_altitude:  # a drone or an aeroplane
        return None
    return Message(
        "The recorded altitude lies {metres} m above the DEM's surface, more than GPS and DEM allow, so the answer is "
        "not accepted. Check the photo's position and the DEM; for a drone, set USE_ALTITUDE.",
        metres=metres,
    )


def eye_notes(request: Any, metadata: PhotoMetadata, oriented: OrientedPhoto) -> tuple[Message, ...]:
    """Give the note on an eye that is not where the DEM has it, or on a recorded altitude that contradicts the DEM.

    Parameters
    ----------
    request : core.batch.PhotoRequest
    metadata : PhotoMetadata
    oriented : OrientedPhoto
    """
    if oriented.ground_elevation_m is None:
        return ()
    if oriented.orientation.eye and oriented.eye_elevation_m is not None:
        above = oriented.eye_elevation_m - oriented.ground_elevation_m
        metres = f"{abs(above):.0f}"
        if above > 0:
            return (
                Message(
                    "The skyline fits best from {metres} m above the DEM's surface, which was used.", metres=metres
                ),
            )
        return (
            Message("The skyline fits best from {metres} m below the DEM's surface, which was used.", metres=metres),
        )
    if not metadata.altitude_m:
        return ()
    trusted = request.use_altitude and request.eye_elevation_m is None
    if trusted and metadata.altitude_reference == "ellipsoid":
        return (Message("The recorded altitude refers to the ellipsoid, not to sea level; the DEM was used."),)
    above = metadata.altitude_m - oriented.ground_elevation_m
    if abs(above) < REMARKABLE_M:
        return ()
    metres = f"{abs(above):.0f}"
    if trusted and above > 0:
        note = Message("The recorded altitude lies {metres} m above the DEM's surface and was used.", metres=metres)
    elif trusted:
        note = Message("The recorded altitude lies {metres} m below the DEM's surface and was used.", metres=metres)
    elif above > 0:
        note = Message(
            "The recorded altitude lies {metres} m above the DEM's surface; the DEM was used.", metres=metres
        )
    else:
        note = Message(
            "The recorded altitude lies {metres} m below the DEM's surface; the DEM was used.", metres=metres
        )
    return (note,)


def doubt_of_run(altitudes_m: Sequence[float], grounds_m: Sequence[float]) -> Message | None:
    """Say what is likely wrong if the altitudes of a run and the DEM disagree as no GPS receiver errs, or None.

    Parameters
    ----------
    altitudes_m : sequence of float
        As the photographs record them [m].
    grounds_m : sequence of float
        Elevations of the DEM at the same places [m].
    """
    recorded = np.asarray(altitudes_m, float)
    known = recorded != 0
    recorded, ground = recorded[known], np.asarray(grounds_m, float)[known]
    if not len(recorded) or abs(np.median(recorded - ground)) <= SUSPICIOUS_MEDIAN_M:
        return None
    shift = recorded - ground
    metres, count = f"{abs(np.median(shift)):.0f}", len(recorded)
    for factor, unit in UNITS:
        if _explains(recorded, factor * ground, shift):
            return Message(
                "The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if its "
                "heights were in {unit}. Set the unit of the DEM's heights (DEM_UNIT).",
                unit=unit,
                metres=metres,
                count=count,
            )
    if _explains(0.3048 * recorded, ground, shift):
        return Message(
            "The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if these were in "
            "feet. The program that wrote them is wrong; the DEM is used for the camera's elevation.",
            metres=metres,
            count=count,
        )
    spread_m = np.median(np.abs(shift - np.median(shift)))
    if len(shift) >= 3 and spread_m <= SAME_PLACE_SPREAD_M and abs(np.median(shift)) <= 1.5 * GEOID_M:
        return Message(
            "The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, nearly the same "
            "everywhere, as if one of them counted from the ellipsoid or another vertical datum. Use a DEM with "
            "heights above sea level.",
            metres=metres,
            count=count,
        )
    return Message(
        "The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes. Check that the DEM "
        "holds heights, their unit (DEM_UNIT) and vertical datum, and the positions of the photos.",
        metres=metres,
        count=count,
    )


def _explains(recorded: np.ndarray, ground: np.ndarray, shift: np.ndarray) -> bool:
    miss = float(np.median(np.abs(recorded - ground)))
    metres, share = UNIT_MATCHES
    return miss <= max(metres, share * float(np.median(np.abs(recorded)))) and miss < 0.3 * np.median(np.abs(shift))
