"""Read the metadata and upright pixels of photographs."""

from __future__ import annotations

import os

import numpy as np

from ..base.imaging import shrink
from ..base.model import Photo, PhotoMetadata
from .exif import read_tags
from .formats import format_of
from .metadata import interpret
from .pixels import decode, stored_size


def read_metadata(path):
    """Read the metadata of a photograph's file without decoding its pixels.

    Raises
    ------
    UnreadablePhotoError

    Examples
    --------
    >>> read_metadata("north.jpg").focal_length_35mm
    28.0
    """
    path = os.fspath(path)
    kind = format_of(path)
    return _metadata(path, kind, stored_size(path, kind))


def stored_orientation(path):
    """Give the EXIF Orientation that the stored pixels still need, 1 to 8; 1 for HEIC, whose decoder applies it.

    Raises
    ------
    UnreadablePhotoError
    """
    return 1 if format_of(path) == "heif" else read_metadata(path).orientation


def _metadata(path, kind, size):
    fields = interpret(read_tags(path, kind), *size)
    if kind != "heif" and fields["orientation"] >= 5:
        size = size[::-1]
    return PhotoMetadata(path, *size, **fields)


def read_photo(path, max_side_px=None):
    """Read a photograph's metadata and its upright pixels.

    Parameters
    ----------
    path : str
    max_side_px : int or None
        Reduce a larger picture by area averaging until its longer side has this length [pixels].

    Returns
    -------
    Photo
        Pixels are rotated only once: JPEG, PNG, TIFF and WebP by their tag, HEIC by its decoder, so that its tag is
        not applied. The sizes in the metadata are always those of the full upright picture.

    Raises
    ------
    UnreadablePhotoError

    Examples
    --------
    >>> read_photo("north.jpg", max_side_px=400).pixels.shape
    (300, 400, 3)
    """
    path = os.fspath(path)
    kind = format_of(path)
    pixels, size = decode(path, kind, max_side_px)
    metadata = _metadata(path, kind, size)
    if max_side_px is not None and max(size) > max_side_px:
        pixels = _reduced(pixels, size, max_side_px)
    if kind != "heif":
        pixels = _upright(pixels, metadata.orientation)
    return Photo(metadata, np.ascontiguousarray(pixels))


def _upright(pixels, orientation):
    """Rotate and mirror stored pixels as EXIF Orientation 1 to 8 specifies."""
    if orientation >= 5:
        pixels = pixels.swapaxes(0, 1)  # 5; the others follow by mirroring
    if orientation in (2, 3, 6, 7):
        pixels = pixels[:, ::-1]
    if orientation in (3, 4, 7, 8):
        pixels = pixels[::-1]
    return pixels


def _reduced(pixels, size, max_side_px):
    """Reduce a picture of full size `size` to `max_side_px` by area averaging, one channel at a time to save memory."""
    factor = max_side_px / max(size)
    width, height = (max(round(side * factor), 1) for side in size)
    planes = [shrink(np.ascontiguousarray(pixels[:, :, channel]), width, height) for channel in range(3)]
    return np.rint(np.stack(planes, axis=-1)).astype(np.uint8)
