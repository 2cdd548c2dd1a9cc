"""Write photographs as JPEG or HEIC files with position, direction and focal length recorded as by a phone."""

from __future__ import annotations

import io
import os
import secrets
from contextlib import suppress
from fractions import Fraction

import numpy as np

from ..base.errors import OutputError
from ..base.messages import Message
from ..base.optional import require

HEIC_SUFFIXES = (".heic", ".heif")
JPEG_SUFFIXES = (".jpg", ".jpeg")

MAKE, MODEL, ORIENTATION, SOFTWARE = 0x010F, 0x0110, 0x0112, 0x0131
EXIF_IFD, GPS_IFD = 0x8769, 0x8825
DATE_TIME_ORIGINAL, OFFSET_TIME_ORIGINAL, FOCAL_LENGTH, FOCAL_LENGTH_35MM = 0x9003, 0x9011, 0x920A, 0xA405
LATITUDE_REF, LATITUDE, LONGITUDE_REF, LONGITUDE, ALTITUDE_REF, ALTITUDE = 1, 2, 3, 4, 5, 6
DIRECTION_REF, DIRECTION, POSITIONING_ERROR = 16, 17, 31
"""Tags of Exif 2.32 (CIPA DC-008)."""

ALTITUDE_CODES = {"sea level": 0, "below sea level": 1, "ellipsoid": 2}

_STORED_AS = {
    1: lambda p: p,
    2: lambda p: p[:, ::-1],
    3: lambda p: p[::-1, ::-1],
    4: lambda p: p[::-1],
    5: lambda p: p.swapaxes(0, 1),
    6: lambda p: np.rot90(p, 1),
    7: lambda p: p[::-1, ::-1].swapaxes(0, 1),
    8: lambda p: np.rot90(p, -1),
}
"""Functions that turn upright pixels for storage, so that applying the Orientation tag makes them upright again."""


def write_photo(path, pixels, metadata, quality=92):
    """Write a photograph; the file appears complete or not at all.

    Parameters
    ----------
    path : str
        File to write, ending in .jpg, .jpeg, .heic or .heif.
    pixels : (H, W, 3) uint8 array
        RGB, upright.
    metadata : PhotoMetadata
        Values other than None are recorded. If `orientation` is not 1, a JPEG is stored rotated, as cameras do; a HEIC
        is always stored upright. The sizes are taken from the pixels.
    quality : int
        Quality of the compression, 1 to 100.

    Raises
    ------
    MissingPackageError
        If pillow-heif is missing for HEIC, or Pillow is missing.
    OutputError
        If the folder is missing or read-only, the disk is full, or the suffix is unknown.
    """
    path = os.fspath(path)
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in HEIC_SUFFIXES + JPEG_SUFFIXES:
        raise OutputError(Message("The photo {path} cannot be written: its name must end in .jpg or .heic.", path=path))
    pixels = np.asarray(pixels)
    if pixels.dtype != np.uint8 or pixels.ndim != 3 or pixels.shape[2] != 3:
        raise ValueError(f"pixels must be uint8 (height, width, 3), not {pixels.dtype} {pixels.shape}")
    image_module = _pillow()
    heif = require("pillow_heif", Message("Writing HEIC photographs")) if suffix in HEIC_SUFFIXES else None
    orientation = 1 if heif is not None else metadata.orientation
    stored = np.ascontiguousarray(_STORED_AS[orientation](pixels))
    picture = image_module.fromarray(stored)
    exif = _exif(image_module, metadata, orientation)
    part = os.path.join(os.path.dirname(path), f".skyline-{secrets.token_hex(6)}.part{suffix}")
    memory = io.BytesIO()  # Pillow would not notice an incomplete file on a full disk
    if heif is not None:
        heif.from_pillow(picture).save(memory, quality=quality, exif=exif)
    else:
        picture.save(memory, "JPEG", quality=quality, exif=exif, subsampling=2 if quality < 95 else 0)
    try:
        with open(part, "wb") as file:
            file.write(memory.getbuffer())
        os.replace(part, path)
    except OSError as error:
        raise OutputError(
            Message(
                "The photo {path} cannot be written: {reason}. Choose another folder or free some space.",
                path=path,
                reason=error.strerror or str(error),
            )
        ) from None
    finally:
        with suppress(OSError):
            os.remove(part)


def _pillow():
    return require("PIL.Image", Message("Writing photographs"))


def _exif(image_module, metadata, orientation):
    """Make the EXIF block as bytes."""
    exif = image_module.Exif()
    exif[ORIENTATION] = orientation
    exif[SOFTWARE] = "Skyline Viewshed simulation"
    if metadata.camera:
        maker, _, model = metadata.camera.partition(" ")
        exif[MAKE] = maker
        exif[MODEL] = model or maker
    exif[EXIF_IFD] = _camera_tags(metadata)
    exif[GPS_IFD] = _gps_tags(metadata)
    return exif.tobytes()


def _camera_tags(metadata):
    tags = {}
    if metadata.taken_at is not None:
        tags[DATE_TIME_ORIGINAL] = metadata.taken_at.strftime("%Y:%m:%d %H:%M:%S")
    if metadata.utc_offset_s is not None:
        minutes = round(abs(metadata.utc_offset_s) / 60)
        tags[OFFSET_TIME_ORIGINAL] = f"{'-' if metadata.utc_offset_s < 0 else '+'}{minutes // 60:02}:{minutes % 60:02}"
    if metadata.focal_length_mm is not None:
        tags[FOCAL_LENGTH] = _rational(metadata.focal_length_mm, 1000)
    if metadata.focal_length_35mm is not None:
        tags[FOCAL_LENGTH_35MM] = int(round(metadata.focal_length_35mm))  # the standard allows integers only
    return tags


def _gps_tags(metadata):
    tags = {}
    if metadata.latitude_deg is not None and metadata.longitude_deg is not None:
        tags[LATITUDE_REF] = "S" if metadata.latitude_deg < 0 else "N"
        tags[LATITUDE] = _degrees_minutes_seconds(metadata.latitude_deg)
        tags[LONGITUDE_REF] = "W" if metadata.longitude_deg < 0 else "E"
        tags[LONGITUDE] = _degrees_minutes_seconds(metadata.longitude_deg)
    if metadata.altitude_m is not None:
        below = metadata.altitude_m < 0
        code = 1 if below else ALTITUDE_CODES.get(metadata.altitude_reference, 0)
        tags[ALTITUDE_REF] = bytes([code])
        tags[ALTITUDE] = _rational(abs(metadata.altitude_m), 1000)
    if metadata.compass_heading_deg is not None:
        tags[DIRECTION_REF] = metadata.compass_reference or "T"
        tags[DIRECTION] = _rational(metadata.compass_heading_deg % 360, 1000)
    if metadata.position_error_m is not None:
        tags[POSITIONING_ERROR] = _rational(metadata.position_error_m, 1000)
    return tags


def _degrees_minutes_seconds(angle_deg):
    """Convert an angle to three rationals; seconds to 1/100000 (0.3 mm on the ground)."""
    units = round(abs(angle_deg) * 3600 * 100_000)
    minutes, seconds = divmod(units, 60 * 100_000)
    degrees, minutes = divmod(minutes, 60)
    return _rational(degrees, 1), _rational(minutes, 1), _rational(Fraction(seconds, 100_000), 100_000)


def _rational(value, denominator):
    from PIL.TiffImagePlugin import IFDRational

    return IFDRational(int(round(value * denominator)), denominator)
