"""Pixels of the stored picture, or of a reduced copy, as pixels of the full upright one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .errors import PhotoError
from .messages import Message
from .pixel_features import PixelFeature


def on_upright(
    feature: PixelFeature, width_px: int, height_px: int, orientation: int = 1
) -> tuple[PixelFeature, Message | None]:
    """Convert a feature to pixels of the full upright picture, whatever copy of it the feature was drawn on.

    Parameters
    ----------
    feature : PixelFeature
    width_px, height_px : int
        Size of the upright picture [pixels].
    orientation : int
        EXIF Orientation by which the stored picture becomes upright, 1 to 8.

    Returns
    -------
    feature : PixelFeature
    note : Message or None
        What was converted.

    Raises
    ------
    PhotoError
        It was drawn on a picture of another shape, a crop for example.
    """
    stored_px = (height_px, width_px) if orientation >= 5 else (width_px, height_px)
    if feature.size_px is None:
        if not feature.as_stored or orientation == 1 or not _fits(feature.parts, stored_px):
            return feature, None
        return _rotated(feature, feature.parts, stored_px, orientation), Message(
            "Its features were drawn on the picture as it is stored; they were rotated with it."
        )
    if _same_shape(feature.size_px, (width_px, height_px)):
        if tuple(feature.size_px) == (width_px, height_px):
            return feature, None
        parts = _scaled(feature.parts, feature.size_px, (width_px, height_px))
        return replace(feature, parts=parts, size_px=None), Message(
            "Its features were drawn on a copy of {width} x {height} pixels; they were scaled to the photo.",
            width=round(feature.size_px[0]),
            height=round(feature.size_px[1]),
        )
    if orientation >= 5 and _same_shape(feature.size_px, stored_px):
        parts = _scaled(feature.parts, feature.size_px, stored_px)
        return _rotated(feature, parts, stored_px, orientation), Message(
            "Its features were drawn on the picture as it is stored; they were rotated with it."
        )
    raise PhotoError(
        Message(
            "Its features were drawn on a picture of {width} x {height} pixels, which is no reduced copy of this photo "
            "of {photo_width} x {photo_height} pixels. Draw them on the photo itself.",
            width=round(feature.size_px[0]),
            height=round(feature.size_px[1]),
            photo_width=width_px,
            photo_height=height_px,
        )
    )


def _same_shape(one: tuple[float, float], other: tuple[float, float]) -> bool:
    """Tell whether one size is the other one reduced or enlarged and rounded to whole pixels."""
    small, large = sorted((one, other), key=sum)
    factor = max(large) / max(small)
    return abs(large[0] - factor * small[0]) <= factor + 1 and abs(large[1] - factor * small[1]) <= factor + 1


def _fits(parts: Sequence[np.ndarray], size_px: tuple[float, float]) -> bool:
    """Tell whether all vertices lie on a picture of this size, a pixel beyond its edges included."""
    xy = np.vstack(parts)
    return bool((xy >= -1.5).all() and (xy <= np.asarray(size_px) + 0.5).all())


def _scaled(
    parts: Sequence[np.ndarray], from_px: tuple[float, float], to_px: tuple[float, float]
) -> tuple[np.ndarray, ...]:
    factor = np.asarray(to_px, float) / np.asarray(from_px, float)
    return tuple((part + 0.5) * factor - 0.5 for part in parts)


def _rotated(
    feature: PixelFeature, parts: Sequence[np.ndarray], stored_px: tuple[float, float], orientation: int
) -> PixelFeature:
    turned = tuple(upright_of_stored(part, stored_px, orientation) for part in parts)
    return replace(feature, parts=turned, size_px=None, as_stored=False)


def upright_of_stored(xy: np.ndarray, stored_px: tuple[float, float], orientation: int) -> np.ndarray:
    """Move pixels of a stored picture to the upright one, as EXIF Orientation 1 to 8 prescribes.

    Parameters
    ----------
    xy : (N, 2) array
        [pixels of the stored picture]
    stored_px : (width, height)
        Size of the stored picture [pixels].
    orientation : int

    Returns
    -------
    (N, 2) array
        [pixels of the upright picture]
    """
    xy, size = np.asarray(xy, float), np.asarray(stored_px, float)
    if orientation >= 5:
        xy, size = xy[:, ::-1], size[::-1]
    mirrored = np.array([orientation in (2, 3, 6, 7), orientation in (3, 4, 7, 8)])
    return np.where(mirrored, size - 1 - xy, xy)


def stored_of_upright(xy: np.ndarray, upright_px: tuple[float, float], orientation: int) -> np.ndarray:
    """Move pixels of an upright picture to the stored one; the inverse of `upright_of_stored`.

    Parameters
    ----------
    xy : (N, 2) array
        [pixels of the upright picture]
    upright_px : (width, height)
        Size of the upright picture [pixels].
    orientation : int
    """
    xy, size = np.asarray(xy, float), np.asarray(upright_px, float)
    mirrored = np.array([orientation in (2, 3, 6, 7), orientation in (3, 4, 7, 8)])
    xy = np.where(mirrored, size - 1 - xy, xy)
    return xy[:, ::-1] if orientation >= 5 else xy
