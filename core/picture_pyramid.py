"""A colour picture at halved sizes, so that a large cell takes the mean of the many pixels that it covers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class PicturePyramid:
    """Levels of a picture; level k has pixels 2^k times as large.

    Attributes
    ----------
    levels : tuple of uint8 (h, w, 3) arrays
    """

    levels: tuple

    @property
    def size_px(self):
        """(width, height) of the full picture."""
        height, width = self.levels[0].shape[:2]
        return width, height

    def sample(self, x_px, y_px, footprint_px):
        """Colours at places of the full picture.

        Parameters
        ----------
        x_px, y_px : (N,) arrays
            The centre of the first pixel at 0.
        footprint_px : (N,) array
            Side of the patch of the picture to be averaged [pixels]; 1 or less interpolates between pixels.

        Returns
        -------
        (N, 3) float32 array
            0 to 255.
        """
        with np.errstate(divide="ignore"):
            level = np.rint(np.log2(np.maximum(footprint_px, 1e-6)))
        level = np.clip(level, 0, len(self.levels) - 1).astype(np.intp)
        colour = np.empty((np.size(x_px), 3), np.float32)
        for k in np.unique(level):
            pick = np.flatnonzero(level == k)
            size = 2.0**k
            at_x, at_y = (x_px[pick] + 0.5) / size - 0.5, (y_px[pick] + 0.5) / size - 0.5
            colour[pick] = _bilinear_colour(self.levels[k], at_x, at_y)
        return colour


def build_picture_pyramid(pixels, smallest_px=16):
    """Halve a uint8 (H, W, 3) picture until its shorter side falls below `smallest_px`."""
    levels = [np.ascontiguousarray(np.asarray(pixels)[..., :3], dtype=np.uint8)]
    while min(levels[-1].shape[:2]) >= 2 * smallest_px:
        fine = levels[-1]
        height, width = fine.shape[0] // 2 * 2, fine.shape[1] // 2 * 2
        total = fine[0:height:2, 0:width:2].astype(np.uint16)
        for dy, dx in ((0, 1), (1, 0), (1, 1)):
            total += fine[dy:height:2, dx:width:2]
        levels.append(((total + 2) >> 2).astype(np.uint8))
    return PicturePyramid(tuple(levels))


def _bilinear_colour(picture, x, y):
    height, width = picture.shape[:2]
    x, y = np.clip(x, 0, width - 1), np.clip(y, 0, height - 1)
    left, top = np.minimum(x.astype(np.intp), width - 2), np.minimum(y.astype(np.intp), height - 2)
    fx, fy = (x - left).astype(np.float32)[:, None], (y - top).astype(np.float32)[:, None]
    flat, first = picture.reshape(-1, 3), top * width + left
    upper = flat[first].astype(np.float32)
    upper += (flat[first + 1] - upper) * fx
    lower = flat[first + width].astype(np.float32)
    lower += (flat[first + width + 1] - lower) * fx
    upper += (lower - upper) * fy
    return upper
