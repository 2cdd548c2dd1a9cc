"""Extract the skyline as published: smooth pixels are sky, and the first rough one below them is terrain.

The steps are those of section 2 of the paper: grey, 9 x 9 box filter, 15 x 15 median, Laplacian below a threshold,
erosion, first transition per column, then removal of jumps and median smoothing. The paper numbers no equation here;
its angles of the skyline are equations 5 and 6 (`core.paper.match.skyline_angles`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ..base import imaging
from ..base.errors import SkylineNotFoundError
from ..base.messages import Message
from ..base.model import Skyline


@dataclass(frozen=True)
class PaperSkylineOptions:
    """Parameters of the published extraction; the defaults are the paper's.

    Attributes
    ----------
    box_px : int
        Side of the box filter, odd [pixels].
    median_px : int
        Side of the median filter of the picture, odd [pixels].
    laplacian_threshold : float
        A pixel is candidate sky if the absolute Laplacian is below this [grey levels].
    erosion_width_px, erosion_height_px : int
        Rectangle that erodes the sky, odd [pixels].
    max_jump_px : float
        A column whose row differs by more from its left neighbour's is flagged and interpolated [pixels].
    smoothing_px : int
        Width of the median filter along the skyline, odd [pixels].
    passes : int
        Number of times that jumps are removed and the line is smoothed.
    """

    box_px: int = 9
    median_px: int = 15
    laplacian_threshold: float = 6.0
    erosion_width_px: int = 9
    erosion_height_px: int = 3
    max_jump_px: float = 20.0
    smoothing_px: int = 15
    passes: int = 3

    def __post_init__(self):
        for name in ("box_px", "median_px", "erosion_width_px", "erosion_height_px", "smoothing_px"):
            value = getattr(self, name)
            if value < 1 or value % 2 == 0:
                raise ValueError(f"{name} must be an odd number of pixels, not {value}")
        if not self.laplacian_threshold > 0 or not self.max_jump_px > 0 or self.passes < 0:
            raise ValueError(f"threshold and jump must be positive and passes not negative, not {self}")


def extract_skyline_paper(pixels, options=PaperSkylineOptions()):  # noqa: B008 - frozen
    """Extract the skyline of a picture as the paper does.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
        Upright RGB at full resolution, for which the paper's parameters are meant.
    options : PaperSkylineOptions

    Returns
    -------
    Skyline
        One row per column of `pixels`. Confidence is 1 if the column had a transition of its own that survived the
        removal of jumps, and 0 if the row is interpolated.

    Raises
    ------
    SkylineNotFoundError
        No column has a transition from sky to terrain.
    """
    row_px = first_terrain_row(sky_mask(pixels, options))
    if not np.isfinite(row_px).any():
        raise SkylineNotFoundError(Message("The picture has no smooth region above a rough one."))
    row_px, kept = smooth_rows(row_px, options)
    height, width = pixels.shape[:2]
    return Skyline(row_px, kept.astype(float), width, height)


def sky_mask(pixels, options=PaperSkylineOptions()):  # noqa: B008 - frozen
    """Candidate sky, bool (H, W): pixels at which the smoothed grey picture's absolute Laplacian is small, eroded."""
    grey = imaging.box_mean(imaging.to_grey(pixels), options.box_px, options.box_px)
    grey = imaging.median(grey, options.median_px)
    smooth = np.abs(imaging.laplacian(grey)) < options.laplacian_threshold
    return imaging.erode(smooth, options.erosion_width_px, options.erosion_height_px)


def first_terrain_row(sky):
    """Row of the first sky-to-terrain transition per column of a bool (H, W) mask, NaN in columns without one.

    The row is that of the first terrain pixel below sky; everything below counts as terrain.
    """
    change = sky[:-1] & ~sky[1:]
    row_px = change.argmax(0) + 1.0 if change.shape[0] else np.zeros(sky.shape[1])
    return np.where(change.any(0), row_px, np.nan)


def smooth_rows(row_px, options=PaperSkylineOptions()):  # noqa: B008 - frozen
    """Interpolate over jumps and median-filter the line, `options.passes` times.

    Returns
    -------
    row_px : (W,) array
        Rows without NaN [pixels].
    kept : (W,) bool array
        True for columns that were never interpolated.
    """
    columns = np.arange(len(row_px))
    kept = np.isfinite(row_px)
    row_px = np.interp(columns, columns[kept], row_px[kept])
    for _ in range(options.passes):
        jump = np.abs(np.diff(row_px, prepend=row_px[0])) > options.max_jump_px
        if jump.all():
            break
        row_px = np.interp(columns, columns[~jump], row_px[~jump])
        row_px = ndimage.median_filter(row_px, options.smoothing_px, mode="nearest")
        kept &= ~jump
    return row_px, kept
