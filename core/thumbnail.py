"""The picture much reduced: what is compared with the look of the ground."""

from __future__ import annotations

import numpy as np

from . import imaging

THUMBNAIL_PX = 64
"""Long side: coarser than trees and gullies, fine enough for the faces of mountains [pixels]."""


def thumbnail(pixels, crop=(0, 0, 0, 0)):
    """Reduce a picture.

    Parameters
    ----------
    pixels : (H, W, 3) array
        Upright RGB, 0 to 255.
    crop : (top, bottom, left, right) ints
        Rows and columns of `pixels` that are border or caption.

    Returns
    -------
    (h, w, 3) float32 array
        Long side `THUMBNAIL_PX`, or the picture's own where that is smaller; NaN where any of it is cropped.
    """
    height, width = pixels.shape[:2]
    top, bottom, left, right = crop
    if any(crop):
        shown = np.full(pixels.shape, np.nan, np.float32)
        inside = slice(top, height - bottom), slice(left, width - right)
        shown[inside] = pixels[inside]
        pixels = shown
    return imaging.shrink_to(pixels[..., :3], THUMBNAIL_PX)
