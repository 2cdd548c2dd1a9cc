"""Interpret EXIF tags as position, heading, focal length and time in the form that the rest of the program uses.

References
----------
.. [1] CIPA DC-008 / JEITA CP-3451, Exif 2.32 and 3.0.
"""

from __future__ import annotations

import re
from datetime import datetime
from math import isfinite

from ..base.camera import FOCAL_SIGMA
from ..base.messages import Message
from .lens_tags import focal_length_35mm, number, positive

ALTITUDE_REFERENCES = {0: "sea level", 1: "below sea level", 2: "ellipsoid", 3: "ellipsoid"}
RANGE_ERROR_M = 5.0
"""Error of one satellite range, which the dilution of precision (DOP) multiplies."""

POOR_DOP = 20.0
"""A larger dilution of precision is called poor; receivers without a fix write 50, 99 or 9999."""

NO_FIX_DOP = 99.0
"""Dilution of precision of a status of no fix; receivers that have no other way to say so write this value."""

STITCHED = ("equirectangular", "cylindrical", "spherical")
"""Values of GPano:ProjectionType whose pictures no lens makes."""

PANORAMA_RENDERED = 6
"""Value of CustomRendered that phones write for a panorama made by turning the camera."""

HALF_HOUR_S = 1800
QUARTER_HOUR_ZONES_S = (20_700, 31_500, 45_900)
"""Time zones that are no multiple of half an hour: Nepal, Eucla, Chatham Islands."""

LATEST_FIX_S = 120
"""Largest age of the fix whose time a camera records."""

STITCHERS = ("ptgui", "hugin", "autopano", "image composite editor", "panorama studio", "panoramastudio", "photostitch")

STITCHED_WIDER = 1.3
"""A picture of another shape whose long side is this much longer than the camera's own frame was stitched."""


def interpret(tags, width_px, height_px):
    """Convert tags to fields of `PhotoMetadata`.

    Parameters
    ----------
    tags : dict
        Tags as `exif.read_tags` gives them.
    width_px, height_px : int
        Size of the stored picture, before any rotation [pixels].

    Returns
    -------
    dict
        Keyword arguments of `PhotoMetadata`, without path and size.
    """
    notes = []
    panorama = _is_panorama(tags, width_px, height_px, notes)
    latitude_deg, longitude_deg = _position(tags, notes)
    altitude_m, altitude_reference = _altitude(tags)
    heading_deg, heading_reference = _heading(tags)
    orientation = number(tags, "Orientation")
    equivalent_mm, focal_sigma = None, FOCAL_SIGMA
    if not panorama:
        equivalent_mm, focal_sigma = focal_length_35mm(tags, width_px, height_px, notes)
    return {
        "latitude_deg": latitude_deg,
        "longitude_deg": longitude_deg,
        "altitude_m": altitude_m,
        "altitude_reference": altitude_reference,
        "focal_length_35mm": equivalent_mm,
        "focal_length_mm": positive(tags, "FocalLength"),
        "focal_sigma": focal_sigma,
        "orientation": int(orientation) if orientation in range(1, 9) else 1,
        "compass_heading_deg": heading_deg,
        "compass_reference": heading_reference,
        "gimbal_pitch_deg": number(tags, "GimbalPitch"),
        "gimbal_roll_deg": number(tags, "GimbalRoll"),
        "position_error_m": None if latitude_deg is None else _position_error_m(tags, notes),
        "taken_at": _time(tags),
        "utc_offset_s": _utc_offset_s(tags),
        "camera": _camera(tags),
        "software": tags.get("Software") or None,
        "make": tags.get("Make"),
        "model": tags.get("Model"),
        "lens": tags.get("LensModel"),
        "panorama": panorama,
        "notes": tuple(notes),
    }


def _position(tags, notes):
    if "GPSLatitude" not in tags or "GPSLongitude" not in tags:
        return None, None
    latitude_deg, longitude_deg = _degrees(tags["GPSLatitude"]), _degrees(tags["GPSLongitude"])
    if not (isfinite(latitude_deg) and isfinite(longitude_deg)):
        notes.append(Message("The recorded coordinates are not numbers (no GPS fix) and were ignored."))
        return None, None
    if abs(latitude_deg) > 90 or abs(longitude_deg) > 180:
        notes.append(
            Message("The recorded coordinates lie outside the range of latitude and longitude and were ignored.")
        )
        return None, None
    if latitude_deg == 0 and longitude_deg == 0:
        notes.append(Message("The recorded coordinates are 0, 0 (no GPS fix) and were ignored."))
        return None, None
    north, east = _reference(tags, "GPSLatitudeRef"), _reference(tags, "GPSLongitudeRef")
    if north not in ("N", "S") or east not in ("E", "W"):
        notes.append(Message("The hemisphere is not recorded; north and east were assumed where it is missing."))
    if _lacks_fix(tags):
        notes.append(
            Message("The GPS had no fix when the photo was taken, so the position may be that of another place.")
        )
    return _signed(latitude_deg, north, "NS"), _signed(longitude_deg, east, "EW")


def _lacks_fix(tags):
    return tags.get("GPSStatus", "").upper() == "V"


def _signed(value_deg, reference, letters):
    """Apply the hemisphere's letter to the size of a coordinate; without a letter its own sign counts.

    Writers that hand signed degrees to the tag record the sign twice, as ExifTool assumes too.
    """
    if reference not in tuple(letters):
        return value_deg
    return -abs(value_deg) if reference == letters[1] else abs(value_deg)


def _reference(tags, name):
    return tags.get(name, "")[:1].upper()


def _degrees(parts):
    """Convert degrees, minutes and seconds (the last ones may be missing) to decimal degrees, with any part's sign."""
    size = sum(abs(part) / 60**power for power, part in enumerate(parts[:3]))
    return -size if any(part < 0 for part in parts[:3]) else size


def _position_error_m(tags, notes):
    """Give the recorded standard deviation of the position, or that of a poor DOP or no fix [m]; None if unknown."""
    recorded, dop = positive(tags, "GPSHPositioningError"), positive(tags, "GPSDOP")
    if dop is None or dop < POOR_DOP:
        return max(recorded or 0.0, RANGE_ERROR_M * NO_FIX_DOP) if _lacks_fix(tags) else recorded
    error_m = max(recorded or 0.0, RANGE_ERROR_M * dop)
    notes.append(
        Message(
            "The GPS position is imprecise (DOP {dop}): an error of {metres} m was assumed.",
            dop=f"{dop:.0f}",
            metres=f"{error_m:.0f}",
        )
    )
    return error_m


def _altitude(tags):
    altitude_m = number(tags, "GPSAltitude")
    if altitude_m is None or abs(altitude_m) > 100_000:
        return None, None
    code = number(tags, "GPSAltitudeRef") or 0  # the default in the standard
    if code in (1, 3):
        altitude_m = -abs(altitude_m)
    return altitude_m, ALTITUDE_REFERENCES.get(code)


def _heading(tags):
    heading_deg = number(tags, "GPSImgDirection")
    if heading_deg is None or not 0 <= heading_deg <= 360:
        yaw_deg = number(tags, "GimbalYaw")
        return (None, None) if yaw_deg is None else (yaw_deg % 360, "T")
    reference = _reference(tags, "GPSImgDirectionRef")
    return heading_deg % 360, reference if reference in ("T", "M") else None


def _is_panorama(tags, width_px, height_px, notes):
    """Tell whether the file says that the picture is a panorama, or marks of stitching show it."""
    projection, rendered = tags.get("ProjectionType", "").lower(), number(tags, "CustomRendered")
    program = tags.get("Software", "").lower()
    recorded = positive(tags, "PixelXDimension"), positive(tags, "PixelYDimension")
    long, short = max(width_px, height_px), min(width_px, height_px)
    wider = (
        None not in recorded
        and long > STITCHED_WIDER * max(recorded)
        and long / short > STITCHED_WIDER * (max(recorded) / min(recorded))
    )
    full, cropped = positive(tags, "FullPanoWidthPixels"), positive(tags, "CroppedAreaImageWidthPixels")
    if not (
        projection in STITCHED
        or full is not None
        or rendered == PANORAMA_RENDERED
        or wider
        or any(name in program for name in STITCHERS)
    ):
        return False
    if full and cropped and cropped <= full:
        notes.append(
            Message(
                "The picture is a panorama of {angle} degrees, not that of one lens; its field of view is unknown.",
                angle=f"{360 * cropped / full:.0f}",
            )
        )
    else:
        notes.append(Message("The picture is a panorama, not that of one lens; its field of view is unknown."))
    return True


def _time(tags):
    for name in ("DateTimeOriginal", "DateTime"):
        try:
            return datetime.strptime(tags.get(name, "")[:19], "%Y:%m:%d %H:%M:%S")
        except ValueError:
            continue
    return None


def _utc_offset_s(tags):
    match = re.fullmatch(r"([+-])(\d\d):?(\d\d)", tags.get("OffsetTimeOriginal", "").strip())
    if match is None or int(match[2]) > 14 or int(match[3]) > 59:
        return _ahead_of_gps_s(tags)
    seconds = 3600.0 * int(match[2]) + 60.0 * int(match[3])
    return -seconds if match[1] == "-" else seconds


def _ahead_of_gps_s(tags):
    """How much the camera's clock is ahead of the GPS, which gives UTC, if the difference is that of a time zone."""
    taken, clock = _time(tags), tags.get("GPSTimeStamp", ())
    try:
        midnight = datetime.strptime(tags.get("GPSDateStamp", "").strip(), "%Y:%m:%d")
    except ValueError:
        return None
    if taken is None or len(clock) != 3 or not all(map(isfinite, clock)):
        return None
    seconds = (taken - midnight).total_seconds() - (3600 * clock[0] + 60 * clock[1] + clock[2])
    zones = (HALF_HOUR_S * round(seconds / HALF_HOUR_S), *QUARTER_HOUR_ZONES_S)
    zone = min(zones, key=lambda zone: abs(seconds - zone))
    return float(zone) if abs(seconds - zone) <= LATEST_FIX_S and abs(zone) <= 14 * 3600 else None


def _camera(tags):
    make, model = tags.get("Make", ""), tags.get("Model", "")
    if model.lower().startswith(make.lower()):
        return model or None
    return f"{make} {model}".strip()
