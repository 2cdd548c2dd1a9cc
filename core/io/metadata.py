"""Interpret EXIF tags as position, heading, focal length and time in the form that the rest of the program uses.

References
----------
.. [1] CIPA DC-008 / JEITA CP-3451, Exif 2.32 and 3.0.
"""

from __future__ import annotations

from datetime import datetime
from math import hypot, isfinite

from ..base.camera import DIAGONAL_35MM, DOUBTFUL_FOCAL_SIGMA, FOCAL_SIGMA
from ..base.messages import Message

MILLIMETRES_PER_UNIT = {1: 25.4, 2: 25.4, 3: 10.0, 4: 1.0, 5: 0.001}
"""Values of FocalPlaneResolutionUnit: 2 inch, 3 centimetre; 1, 4 and 5 (none, mm, um) are read as ExifTool does."""

ALTITUDE_REFERENCES = {0: "sea level", 1: "below sea level", 2: "ellipsoid", 3: "ellipsoid"}
SENSOR_DIAGONALS_MM = (2.0, 80.0)
"""Range from the smallest phone to medium format; a value outside it means a wrong FocalPlaneXResolution."""

SENSOR_SHAPES = (4 / 3, 3 / 2)
"""Usual shapes of sensors. For pictures of other shapes phones still record the equivalent of the whole sensor, and the
diagonal rule does not account for that."""

SAME_SHAPE = 0.01
"""Relative difference between two shapes that rounding can explain."""

LEAST_CROP = 0.5
"""A picture whose shape differs from the recorded one was cropped, not reduced, if its sides are at least this share of
the recorded sides."""


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
    latitude_deg, longitude_deg = _position(tags, notes)
    altitude_m, altitude_reference = _altitude(tags)
    heading_deg, heading_reference = _heading(tags)
    orientation = _number(tags, "Orientation")
    focal_length_35mm, focal_sigma = _focal_length_35mm(tags, width_px, height_px, notes)
    return {
        "latitude_deg": latitude_deg,
        "longitude_deg": longitude_deg,
        "altitude_m": altitude_m,
        "altitude_reference": altitude_reference,
        "focal_length_35mm": focal_length_35mm,
        "focal_length_mm": _positive(tags, "FocalLength"),
        "focal_sigma": focal_sigma,
        "orientation": int(orientation) if orientation in range(1, 9) else 1,
        "compass_heading_deg": heading_deg,
        "compass_reference": heading_reference,
        "position_error_m": _positive(tags, "GPSHPositioningError"),
        "taken_at": _time(tags),
        "camera": _camera(tags),
        "notes": tuple(notes),
    }


def _number(tags, name):
    """Give a tag's first value if it is finite, else None."""
    value = tags.get(name, (float("nan"),))[0]
    return value if isfinite(value) else None


def _positive(tags, name):
    value = _number(tags, name)
    return value if value is not None and value > 0 else None


def _position(tags, notes):
    if "GPSLatitude" not in tags or "GPSLongitude" not in tags:
        return None, None
    latitude_deg = _degrees(tags["GPSLatitude"])
    longitude_deg = _degrees(tags["GPSLongitude"])
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
    south, west = _reference(tags, "GPSLatitudeRef"), _reference(tags, "GPSLongitudeRef")
    if south not in ("N", "S") or west not in ("E", "W"):
        notes.append(Message("The hemisphere is not recorded; north and east were assumed where it is missing."))
    return (-latitude_deg if south == "S" else latitude_deg), (-longitude_deg if west == "W" else longitude_deg)


def _reference(tags, name):
    return tags.get(name, "")[:1].upper()


def _degrees(parts):
    """Convert degrees, minutes and seconds (the last ones may be missing) to decimal degrees."""
    return sum(part / 60**power for power, part in enumerate(parts[:3]))


def _altitude(tags):
    altitude_m = _number(tags, "GPSAltitude")
    if altitude_m is None or abs(altitude_m) > 100_000:
        return None, None
    code = _number(tags, "GPSAltitudeRef") or 0  # the default in the standard
    if code in (1, 3):
        altitude_m = -abs(altitude_m)
    return altitude_m, ALTITUDE_REFERENCES.get(code)


def _heading(tags):
    heading_deg = _number(tags, "GPSImgDirection")
    if heading_deg is None or not 0 <= heading_deg <= 360:
        return None, None
    reference = _reference(tags, "GPSImgDirectionRef")
    return heading_deg % 360, reference if reference in ("T", "M") else None


def _focal_length_35mm(tags, width_px, height_px, notes):
    """Give the 35 mm equivalent of the picture in its present crop (None if unknown), and its relative sigma."""
    recorded = _positive(tags, "FocalLengthIn35mmFilm")
    length = recorded or _from_focal_plane(tags, width_px, height_px)
    if length is None:
        return None, FOCAL_SIGMA
    if recorded is None:
        notes.append(Message("The 35 mm equivalent was derived from the focal length and the focal plane resolution."))
    size = max(width_px, height_px), min(width_px, height_px)
    enlarged = _crop_factor(*_recorded_size(tags, size), *size)
    if enlarged > 1:
        notes.append(
            Message(
                "The picture is cropped: a 35 mm equivalent of {used} mm was used instead of "
                "{recorded} mm. If you know the horizontal field of view, give it in HFOV_FIELD.",
                used=f"{length * enlarged:.0f}",
                recorded=f"{length:.0f}",
            )
        )
    zoomed = (_positive(tags, "DigitalZoomRatio") or 1.0) > 1
    usual = any(_same_shape(size[0] / size[1], shape) for shape in SENSOR_SHAPES)
    return length * enlarged, DOUBTFUL_FOCAL_SIGMA if enlarged > 1 or zoomed or not usual else FOCAL_SIGMA


def _recorded_size(tags, size):
    """Give the long and short side of the picture as the camera stored it; `size` if that is not recorded."""
    sides = _positive(tags, "PixelXDimension"), _positive(tags, "PixelYDimension")
    return size if None in sides else (max(sides), min(sides))


def _crop_factor(recorded_long, recorded_short, long, short):
    """Give the factor by which cropping narrowed the recorded field of view; 1 if the picture was not cropped.

    A copy of another shape that is not much smaller was cropped without resampling. A much smaller one is taken for a
    reduced copy of the largest crop of its shape.
    """
    kept = max(long / recorded_long, short / recorded_short)
    if _same_shape(recorded_long / recorded_short, long / short) or kept > 1:
        return 1.0
    scale = 1.0 if kept >= LEAST_CROP else kept
    return hypot(recorded_long, recorded_short) * scale / hypot(long, short)


def _same_shape(one, other):
    return abs(one - other) <= SAME_SHAPE * other


def _from_focal_plane(tags, width_px, height_px):
    """Derive the 35 mm equivalent of the recorded frame by the diagonal rule from the sensor; None if unknown."""
    focal_mm, unit_mm = (
        _positive(tags, "FocalLength"),
        MILLIMETRES_PER_UNIT.get(_number(tags, "FocalPlaneResolutionUnit") or 2),
    )
    x_resolution, y_resolution = _positive(tags, "FocalPlaneXResolution"), _positive(tags, "FocalPlaneYResolution")
    if None in (focal_mm, unit_mm, x_resolution, y_resolution):
        return None
    # The resolution refers to the picture as the camera stored it; a resampled copy shows the same field of view.
    stored_width = _positive(tags, "PixelXDimension") or width_px
    stored_height = _positive(tags, "PixelYDimension") or height_px
    sensor_mm = hypot(stored_width / x_resolution, stored_height / y_resolution) * unit_mm
    if not SENSOR_DIAGONALS_MM[0] <= sensor_mm <= SENSOR_DIAGONALS_MM[1]:
        return None
    zoom = _positive(tags, "DigitalZoomRatio") or 1.0
    return focal_mm * max(zoom, 1.0) * DIAGONAL_35MM / sensor_mm


def _time(tags):
    for name in ("DateTimeOriginal", "DateTime"):
        try:
            return datetime.strptime(tags.get(name, "")[:19], "%Y:%m:%d %H:%M:%S")
        except ValueError:
            continue
    return None


def _camera(tags):
    make, model = tags.get("Make", ""), tags.get("Model", "")
    if model.lower().startswith(make.lower()):
        return model or None
    return f"{make} {model}".strip()
