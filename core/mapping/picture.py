"""The picture that is draped: at several resolutions, with the pixels that show sky."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class PicturePyramid:
    """Levels of a picture; the pixels of level k are 2^k times as large.

    Attributes
    ----------
    levels : tuple of uint8 (h, w, 3) arrays
    sky : (h', w') bool array or None
        Which pixels show sky, at any size; None if that is not known.
    """

    levels: tuple
    sky: np.ndarray | None = None

    @property
    def size_px(self):
        """(width, height) of the full picture."""
        height, width = self.levels[0].shape[:2]
        return width, height

    def is_sky(self, across, down):
        """Tell which positions show sky.

        Parameters
        ----------
        across, down : (N,) arrays
            Position in the picture, 0 at its left or upper edge and 1 at the other.

        Returns
        -------
        (N,) bool array
        """
        if self.sky is None:
            return np.zeros(np.shape(across), bool)
        height, width = self.sky.shape
        column = np.clip((across * width).astype(np.intp), 0, width - 1)
        return self.sky[np.clip((down * height).astype(np.intp), 0, height - 1), column]

    def sample(self, x_px, y_px, footprint_px):
        """Sample colours at positions of the full picture.

        Parameters
        ----------
        x_px, y_px : (N,) arrays
            Pixels, with the centre of the first pixel at 0.
        footprint_px : (N,) array
            Side of the patch of the picture to average over [pixels]; 1 or less interpolates between pixels.

        Returns
        -------
        (N, 3) float32 array
            Colours, 0 to 255.
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


def sky_of(evidence):
    """Pixels of the reduced picture that show sky, a bool array of the shape of `evidence.probability`.

    They lie above the skyline, more probably than not, and look like sky themselves. Above a crest before a fainter
    line (`evidence.rival`), only what lies above both lines is sky.
    """
    lines = [evidence] if evidence.rival is None else [evidence, evidence.rival]
    sky = np.ones(evidence.probability.shape, bool) if evidence.sky_score is None else evidence.sky_score > 0
    for line in lines:
        leaves = 0.0 if line.leaves_frame is None else line.leaves_frame
        sky &= np.cumsum(line.probability, axis=0) + leaves < 0.5
    return sky


def build_picture_pyramid(pixels, smallest_px=16, sky=None):
    """Halve a uint8 (H, W, 3) picture until its shorter side falls below `smallest_px`.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    smallest_px : int
    sky : (h', w') bool array or None
        See `PicturePyramid`.

    Returns
    -------
    PicturePyramid
    """
    levels = [np.ascontiguousarray(np.asarray(pixels)[..., :3], dtype=np.uint8)]
    while min(levels[-1].shape[:2]) >= 2 * smallest_px:
        fine = levels[-1]
        height, width = fine.shape[0] // 2 * 2, fine.shape[1] // 2 * 2
        total = fine[0:height:2, 0:width:2].astype(np.uint16)
        for dy, dx in ((0, 1), (1, 0), (1, 1)):
            total += fine[dy:height:2, dx:width:2]
        levels.append(((total + 2) >> 2).astype(np.uint8))
    return PicturePyramid(tuple(levels), sky)


def _bilinear_colour(picture, x, y):
    """Interpolate three colours at once in single precision.

    This is several times faster than `bilinear`, but cannot handle voids.
    """
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
