"""Decode a picture's pixels as they are stored, with any installed decoder."""

from __future__ import annotations

import warnings
from contextlib import contextmanager

import numpy as np

from ..base.errors import UnreadablePhotoError
from ..base.messages import Message
from ..base.optional import available, install_hint
from .formats import GDAL_DRIVERS, check_size
from .gdal_quiet import open_quietly, quiet_gdal

DAMAGED = Message("it is damaged or incomplete. Copy it again from its source.")


def stored_size(path, kind):
    """Read the width and height of the decoded picture from its header [pixels].

    HEIC decoders apply the container's rotation, so this is the upright size for HEIC and the stored size for JPEG.
    """
    for sizer in _chain(kind, _heif_size, _pillow_size, _gdal_size):
        size = sizer(path, kind)
        if size is not None:
            check_size(path, *size)
            return size
    raise _undecodable(path, kind)


def decode(path, kind, max_side_px=None):
    """Decode to RGB, without applying any EXIF orientation.

    Parameters
    ----------
    path : str
    kind : str
        Format as `formats.format_of` gives it.
    max_side_px : int or None
        Hint that fewer pixels suffice: a JPEG may be averaged by 2, 4 or 8 if that divides the picture's sides, but
        never below twice this length [pixels].

    Returns
    -------
    pixels : uint8 (H, W, 3) array
        RGB.
    size : (int, int)
        Width and height of the full picture [pixels].

    Raises
    ------
    UnreadablePhotoError
    """
    size = stored_size(path, kind)
    try:
        for decoder in _chain(kind, _decode_heif, _decode_pillow, _decode_gdal):
            pixels = decoder(path, kind, max_side_px)
            if pixels is not None:
                return pixels, size
    except MemoryError:
        reason = Message("it is too large for this computer's memory. Reduce its size.")
        raise UnreadablePhotoError(path, reason) from None
    raise _undecodable(path, kind)


def _chain(kind, by_heif, by_pillow, by_gdal):
    """Give the decoders in order. A HEIC that pillow-heif refuses is not passed to GDAL, whose libheif is older."""
    if kind != "heif":
        return by_pillow, by_gdal
    return (by_gdal,) if available("pillow_heif") is None else (by_heif,)


def _undecodable(path, kind):
    heif_driver = available("osgeo.gdal") is not None and available("osgeo.gdal").GetDriverByName("HEIF")
    if kind == "heif" and available("pillow_heif") is None and not heif_driver:
        hint = install_hint("pillow_heif")
        return UnreadablePhotoError(
            path, Message("HEIC needs the Python package pillow-heif. {hint}, or export it as JPEG.", hint=hint)
        )
    return UnreadablePhotoError(path, DAMAGED)


@contextmanager
def _opened_by_pillow(path, kind):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # damaged metadata and large pictures are handled elsewhere
        if kind == "jpeg":
            # The class is used directly, because Image.open has a process-wide pixel limit that phone pictures exceed.
            picture = available("PIL.JpegImagePlugin").JpegImageFile(path)
        else:
            picture = available("PIL.Image").open(path)
        with picture:
            yield picture


def _pillow_size(path, kind):
    if available("PIL.Image") is None:
        return None
    try:
        with _opened_by_pillow(path, kind) as picture:
            return picture.size
    except Exception:  # on damaged files plugins raise SyntaxError, struct.error, OSError, ...
        return None


def _decode_pillow(path, kind, max_side_px):
    if available("PIL.Image") is None:
        return None
    try:
        with _opened_by_pillow(path, kind) as picture:
            if picture.mode.startswith(("I", "F")):
                return None  # deeper than 8 bits: GDAL keeps the values
            if kind == "jpeg" and max_side_px is not None:
                step = _draft_step(picture.size, max_side_px)
                picture.draft(None, (picture.width // step, picture.height // step))
            return np.asarray(picture.convert("RGB"))
    except MemoryError:
        raise
    except Exception:  # see `_pillow_size`
        return None


def _draft_step(size, max_side_px):
    """Give the factor by which libjpeg may average: an exact divisor, else its last pixels reach beyond the picture."""
    for step in (8, 4, 2):
        if size[0] % step == size[1] % step == 0 and max(size) >= 2 * step * max_side_px:
            return step
    return 1


def _heif_size(path, kind):
    heif = available("pillow_heif")
    if heif is None:
        return None
    try:
        return heif.open_heif(path).size
    except Exception:
        return None


def _decode_heif(path, kind, max_side_px):
    heif = available("pillow_heif")
    if heif is None:
        return None
    try:
        picture = heif.open_heif(path, convert_hdr_to_8bit=True)
        pixels = np.asarray(picture)
    except MemoryError:
        raise
    except Exception:
        return None
    return _rgb(pixels)


def _gdal_size(path, kind):
    dataset = open_quietly(path, [GDAL_DRIVERS[kind]])
    return None if dataset is None else (dataset.RasterXSize, dataset.RasterYSize)


def _decode_gdal(path, kind, max_side_px):
    dataset = open_quietly(path, [GDAL_DRIVERS[kind]])
    if dataset is None or dataset.GetRasterBand(1).GetColorTable() is not None:
        return None  # palette indices are not colours
    with quiet_gdal(warnings=True) as messages:
        try:
            bands = dataset.ReadAsArray()
        except RuntimeError:
            return None
    if bands is None or any("remature end" in text for text in messages):
        return None  # libjpeg would fill the missing part with grey
    return _rgb(bands if bands.ndim == 2 else np.moveaxis(bands, 0, -1))


def _rgb(pixels):
    """Convert grey, grey + alpha, RGB or RGBA of 8 or 16 bits to uint8 RGB; None for other types."""
    if pixels.dtype == np.uint16:
        pixels = (pixels // 257).astype(np.uint8)
    if pixels.dtype != np.uint8:
        return None
    if pixels.ndim == 2:
        pixels = pixels[:, :, None]
    if pixels.shape[2] < 3:
        return np.repeat(pixels[:, :, :1], 3, axis=2)
    return np.ascontiguousarray(pixels[:, :, :3])
