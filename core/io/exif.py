"""Read the EXIF tags that the method needs, whichever reader is installed.

Three readers know the same few tags and give them in one form, so that nothing after this module depends on the
one that happened to be there: ExifRead, else Pillow (with pillow-heif for HEIC), else GDAL. A reader that fails or
finds nothing hands over to the next; damaged metadata is no reason to refuse a picture.
"""

from __future__ import annotations

import logging
import re
import warnings

from ..base.optional import available
from .formats import GDAL_DRIVERS
from .gdal_quiet import open_quietly, quiet_gdal

TAGS = {
    ("Image", 0x010F): "Make",
    ("Image", 0x0110): "Model",
    ("Image", 0x0112): "Orientation",
    ("Image", 0x0132): "DateTime",
    ("EXIF", 0x9003): "DateTimeOriginal",
    ("EXIF", 0x920A): "FocalLength",
    ("EXIF", 0xA002): "PixelXDimension",
    ("EXIF", 0xA003): "PixelYDimension",
    ("EXIF", 0xA20E): "FocalPlaneXResolution",
    ("EXIF", 0xA20F): "FocalPlaneYResolution",
    ("EXIF", 0xA210): "FocalPlaneResolutionUnit",
    ("EXIF", 0xA404): "DigitalZoomRatio",
    ("EXIF", 0xA405): "FocalLengthIn35mmFilm",
    ("GPS", 0x0001): "GPSLatitudeRef",
    ("GPS", 0x0002): "GPSLatitude",
    ("GPS", 0x0003): "GPSLongitudeRef",
    ("GPS", 0x0004): "GPSLongitude",
    ("GPS", 0x0005): "GPSAltitudeRef",
    ("GPS", 0x0006): "GPSAltitude",
    ("GPS", 0x0010): "GPSImgDirectionRef",
    ("GPS", 0x0011): "GPSImgDirection",
    ("GPS", 0x001F): "GPSHPositioningError",
}
"""(directory, number) to the name in Exif 2.32."""

TEXT_TAGS = frozenset(("Make", "Model", "DateTime", "DateTimeOriginal", *(n for n in TAGS.values() if n[-3:] == "Ref")))
TEXT_TAGS -= {"GPSAltitudeRef"}
MAX_VALUES = 16
"""No tag we know has more values; damaged counts are cut here."""

IFD_POINTERS = {"EXIF": 0x8769, "GPS": 0x8825}


def read_tags(path, kind):
    """Read the known tags of a picture.

    Parameters
    ----------
    path : str
    kind : str
        As `format_of` gives it.

    Returns
    -------
    dict
        Name to str, or to a tuple of floats (NaN where a fraction's denominator is 0). Empty without metadata.
    """
    for reader in (_by_exifread, _by_pillow, _by_gdal):
        tags = reader(path, kind)
        if tags:
            return tags
    return {}


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
    except Exception:  # ExifRead meets damaged files with AssertionError, KeyError, struct.error, ...
        return {}
    return _normal(raw)


def _silence(name):
    """Keep a library's log messages off stderr where the host has not asked for them."""
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
    except Exception:  # Pillow's plugins meet damaged files with SyntaxError, struct.error, OSError, ...
        return {}
    return _normal(raw)


def _pillow_exif(pil, path, kind):
    if kind == "jpeg":
        with available("PIL.JpegImagePlugin").JpegImageFile(path) as picture:  # no bomb check: nothing is decoded
            return picture.getexif()
    if kind == "heif":
        exif = pil.Exif()
        exif.load(available("pillow_heif").open_heif(path).info.get("exif") or b"")
        return exif
    with pil.open(path) as picture:
        return picture.getexif()


def _by_gdal(path, kind):
    """GDAL prints six digits and calls 0/0 zero: enough for a place to some metres, and the last resort."""
    if kind == "heif" and available("pillow_heif") is not None:
        return {}  # see pixels._chain
    dataset = open_quietly(path, [GDAL_DRIVERS[kind]])
    if dataset is None:
        return {}
    with quiet_gdal():
        found = dataset.GetMetadata("EXIF") or dataset.GetMetadata() or {}
    raw = {tag: found["EXIF_" + tag] for tag in TAGS.values() if "EXIF_" + tag in found}
    return _normal({tag: text if tag in TEXT_TAGS else _numbers(text) for tag, text in raw.items()})


def _numbers(text):
    """Undo GDAL's printing: "(43) (28) (2.8)", "112" or "0x00"; a tag that holds no numbers gives none."""
    text = text.decode("ascii", "replace") if isinstance(text, bytes) else text  # what is no UTF-8 comes as bytes
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
    """Turn a number or a fraction of any reader into a float; x/0 is NaN."""
    if isinstance(value, tuple) and len(value) == 1:  # how ExifRead gives the floating point types
        value = value[0]
    try:
        return float(value)
    except ZeroDivisionError:
        return float("nan")
