"""Read the EXIF tags that the method needs, with any of three readers.

The readers give the same few tags in the same form, so that nothing outside this module depends on which of them is
installed. They are tried in this order: ExifRead, Pillow (with pillow-heif for HEIC), GDAL. If one fails or finds
nothing, the next one is tried. Damaged metadata is not a reason to refuse a picture.
"""

from __future__ import annotations

import logging
import re
import warnings

from ..base.optional import available
from .formats import GDAL_DRIVERS
from .gdal_quiet import open_quietly, quiet_gdal
from .gimbal import PREFIXES, gimbal_tags
from .xmp import xmp_properties

TAGS = {
    ("Image", 0x010F): "Make",
    ("Image", 0x0110): "Model",
    ("Image", 0x0112): "Orientation",
    ("Image", 0x0131): "Software",
    ("Image", 0x0132): "DateTime",
    ("EXIF", 0x9003): "DateTimeOriginal",
    ("EXIF", 0x9011): "OffsetTimeOriginal",
    ("EXIF", 0x920A): "FocalLength",
    ("EXIF", 0xA002): "PixelXDimension",
    ("EXIF", 0xA003): "PixelYDimension",
    ("EXIF", 0xA20E): "FocalPlaneXResolution",
    ("EXIF", 0xA20F): "FocalPlaneYResolution",
    ("EXIF", 0xA210): "FocalPlaneResolutionUnit",
    ("EXIF", 0xA401): "CustomRendered",
    ("EXIF", 0xA404): "DigitalZoomRatio",
    ("EXIF", 0xA405): "FocalLengthIn35mmFilm",
    ("EXIF", 0xA434): "LensModel",
    ("GPS", 0x0001): "GPSLatitudeRef",
    ("GPS", 0x0002): "GPSLatitude",
    ("GPS", 0x0003): "GPSLongitudeRef",
    ("GPS", 0x0004): "GPSLongitude",
    ("GPS", 0x0005): "GPSAltitudeRef",
    ("GPS", 0x0006): "GPSAltitude",
    ("GPS", 0x0007): "GPSTimeStamp",
    ("GPS", 0x0009): "GPSStatus",
    ("GPS", 0x000B): "GPSDOP",
    ("GPS", 0x0010): "GPSImgDirectionRef",
    ("GPS", 0x0011): "GPSImgDirection",
    ("GPS", 0x001D): "GPSDateStamp",
    ("GPS", 0x001F): "GPSHPositioningError",
}
"""Names in Exif 2.32 by (directory, number)."""

TEXT_TAGS = {"Make", "Model", "Software", "ProjectionType", "DateTime", "DateTimeOriginal",
             "OffsetTimeOriginal", "GPSStatus", "GPSDateStamp", "LensModel"}  # fmt: skip
TEXT_TAGS |= {name for name in TAGS.values() if name.endswith("Ref")} - {"GPSAltitudeRef"}
PANORAMA_TAGS = ("ProjectionType", "FullPanoWidthPixels", "CroppedAreaImageWidthPixels")
"""Names in the XMP namespace GPano, which describes stitched panoramas."""

MAX_VALUES = 16
"""Largest number of values that is read for a tag; no known tag has more, but a damaged count may be larger."""

IFD_POINTERS = {"EXIF": 0x8769, "GPS": 0x8825}


def read_tags(path, kind):
    """Read the known tags of a picture.

    Parameters
    ----------
    path : str
    kind : str
        Format as `formats.format_of` gives it.

    Returns
    -------
    dict
        Tags by name, each a str or a tuple of floats (NaN if a fraction's denominator is 0). Empty without metadata.
    """
    for reader in (_by_exifread, _by_pillow, _by_gdal):
        tags = reader(path, kind)
        if tags:
            return {**tags, **_xmp_tags(path)}
    return _xmp_tags(path)


def _xmp_tags(path):
    """Tags of panoramas, and the angles of a drone's camera."""
    found = xmp_properties(path, ("GPano", *PREFIXES))
    raw = {name: text for name, text in found["GPano"].items() if name in PANORAMA_TAGS}
    panorama = _normal({name: text if name in TEXT_TAGS else _numbers(text) for name, text in raw.items()})
    return {**panorama, **gimbal_tags(found)}


def _by_exifread(path, kind):
    exifread = available("exifread")
    if exifread is None:
        return {}
    _silence("exifread")
    try:
        with open(path, "rb") as file:
            found = exifread.process_file(file, details=False)
        raw = {
            TAGS[key.split()[0], tag.tag]: tag.values
            for key, tag in found.items()
            if (key.split()[0], getattr(tag, "tag", None)) in TAGS
        }
    except Exception:  # damaged files: AssertionError, KeyError, struct.error, ...
        return {}
    return _normal(raw)


def _silence(name):
    """Keep a library's log messages off stderr if the host application has not asked for them."""
    logger = logging.getLogger(name)
    if not logger.handlers:
        logger.addHandler(logging.NullHandler())


def _by_pillow(path, kind):
    pil = available("PIL.Image")
    if pil is None:
        return {}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # "Corrupt EXIF data"
            exif = _pillow_exif(pil, path, kind)
            directories = {"Image": dict(exif)}
            for name, pointer in IFD_POINTERS.items():
                directories[name] = exif.get_ifd(pointer)
        raw = {tag: directories[key[0]][key[1]] for key, tag in TAGS.items() if key[1] in directories[key[0]]}
    except Exception:  # damaged files: SyntaxError, struct.error, OSError, ...
        return {}
    return _normal(raw)


def _pillow_exif(pil, path, kind):
    if kind == "jpeg":
        with available("PIL.JpegImagePlugin").JpegImageFile(path) as picture:  # nothing is decoded, so no bomb check
            return picture.getexif()
    if kind == "heif":
        exif = pil.Exif()
        exif.load(available("pillow_heif").open_heif(path).info.get("exif") or b"")
        return exif
    with pil.open(path) as picture:
        return picture.getexif()


def _by_gdal(path, kind):
    """Read the tags by GDAL as the last resort: six digits, so positions to some metres, and 0/0 as 0."""
    if kind == "heif" and available("pillow_heif") is not None:
        return {}  # see `pixels._chain`
    dataset = open_quietly(path, [GDAL_DRIVERS[kind]])
    if dataset is None:
        return {}
    with quiet_gdal():
        found = dataset.GetMetadata("EXIF") or dataset.GetMetadata() or {}
    raw = {tag: found["EXIF_" + tag] for tag in TAGS.values() if "EXIF_" + tag in found}
    return _normal({tag: text if tag in TEXT_TAGS else _numbers(text) for tag, text in raw.items()})


def _numbers(text):
    """Parse GDAL's text of numbers, "(43) (28) (2.8)", "112" or "0x00"; empty if the tag contains no numbers."""
    text = (
        text.decode("ascii", "replace") if isinstance(text, bytes) else text
    )  # text that is not UTF-8 is given as bytes
    words = re.findall(r"0x[0-9A-Fa-f]+|[-+.\w]+", text)
    try:
        return [int(word, 16) if word[:2] == "0x" else float(word) for word in words]
    except ValueError:
        return []


def _normal(raw):
    tags = {}
    for tag, value in raw.items():
        try:
            value = _text(value) if tag in TEXT_TAGS else _floats(value)
        except (TypeError, ValueError, OverflowError):
            continue
        if value:
            tags[tag] = value
    return tags


def _text(value):
    if isinstance(value, bytes):
        value = value.decode("utf-8", "replace")
    if isinstance(value, (list, tuple)):
        value = "".join(str(part) for part in value[:MAX_VALUES])
    value = str(value).split("\0")[0]
    return "".join(character for character in value if character.isprintable()).strip()[:200]


def _floats(value):
    if isinstance(value, (str, int, float)) or not hasattr(value, "__iter__"):
        value = (value,)
    return tuple(_float(part) for part in tuple(value)[:MAX_VALUES])


def _float(value):
    """Convert a number or a fraction from any reader to a float; x/0 is NaN."""
    if isinstance(value, tuple) and len(value) == 1:  # ExifRead gives floating-point types like this
        value = value[0]
    try:
        return float(value)
    except ZeroDivisionError:
        return float("nan")
