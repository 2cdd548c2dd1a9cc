"""Lines of an overlay in pixels of the full upright picture: the extracted skyline and projected DEM horizons."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .angles import difference
from .camera import Camera, Pose, project_vectors
from .directions import OUTSIDE, Directions
from .model import HorizonProfile, OrientedPhoto, Skyline


@dataclass(frozen=True, eq=False)
class OverlayLine:
    """A line drawn over a picture.

    Attributes
    ----------
    x_px, y_px : (N,) arrays
        Vertices [pixels of the full upright picture]; NaN breaks the line.
    doubtful : (N,) bool array
        True where the line is a lower bound or a guess: at the DEM's edge or a void for a horizon, without a
        plausible boundary for a skyline.
    """

    x_px: np.ndarray
    y_px: np.ndarray
    doubtful: np.ndarray

    def part(self, doubtful: bool) -> tuple[np.ndarray, np.ndarray]:
        """Give (x, y) [pixels] of the doubtful or of the reliable parts; all other points are NaN."""
        keep = self.doubtful == doubtful
        # A doubtful part includes the point that follows it, so that reliable and doubtful parts join.
        keep = keep | np.r_[False, keep[:-1]] if doubtful else keep
        return np.where(keep, self.x_px, np.nan), np.where(keep, self.y_px, np.nan)


def horizon_line(horizon: HorizonProfile, camera: Camera, pose: Pose) -> OverlayLine:
    """Project a DEM horizon into the picture of a camera; see `HorizonLines.line`.

    Parameters
    ----------
    horizon : HorizonProfile
    camera : Camera
        Camera of the full upright picture.
    pose : Pose
    """
    return HorizonLines(horizon).line(camera, pose)


class HorizonLines:
    """Lines of one DEM horizon in pictures of one pose after another.

    Parameters
    ----------
    horizon : HorizonProfile
    """

    def __init__(self, horizon: HorizonProfile) -> None:
        self.azimuth_deg = np.asarray(horizon.azimuth_deg, float)
        self.directions = Directions.of(self.azimuth_deg, horizon.elevation_deg)
        self.doubtful = np.asarray(horizon.clipped, bool) | np.asarray(horizon.void, bool)

    def line(self, camera: Camera, pose: Pose) -> OverlayLine:
        """Project the horizon.

        Parameters
        ----------
        camera : Camera
            Camera of the full upright picture.
        pose : Pose

        Returns
        -------
        OverlayLine
            Line from left to right, ordered by azimuth about the heading; it breaks at directions behind the camera,
            far outside the frame, or without a known horizon.
        """
        ahead = self.directions.ahead(camera, pose)
        for _ in range(2):  # the vertex beyond the margin, and one more at which the line breaks
            ahead = ahead | np.roll(ahead, 1) | np.roll(ahead, -1)
        chosen = np.flatnonzero(ahead)
        chosen = chosen[np.argsort(difference(self.azimuth_deg[chosen], pose.heading_deg), kind="stable")]
        x, y = project_vectors(camera, pose, *self.directions.vectors[:, chosen])
        margin_x, margin_y = OUTSIDE * camera.width_px, OUTSIDE * camera.height_px
        with np.errstate(invalid="ignore"):
            near = (x > -margin_x) & (x < camera.width_px + margin_x)
            near &= (y > -margin_y) & (y < camera.height_px + margin_y)
        near = _with_neighbours(near) & np.isfinite(x) & np.isfinite(y)
        return _trimmed(np.where(near, x, np.nan), np.where(near, y, np.nan), self.doubtful[chosen])


def skyline_line(skyline: Skyline, width_px: int, height_px: int) -> OverlayLine:
    """Convert an extracted skyline to pixels of the full upright picture.

    The line is the upper edge of the first terrain pixels.

    Parameters
    ----------
    skyline : Skyline
    width_px, height_px : int
        Size of the full upright picture [pixels].
    """
    row = np.asarray(skyline.row_px, float)
    x = (np.arange(len(row)) + 0.5) * (width_px / skyline.width_px) - 0.5
    y = row * (height_px / skyline.height_px) - 0.5
    return OverlayLine(x, y, ~np.asarray(skyline.valid, bool))


def photo_lines(photo: OrientedPhoto) -> tuple[OverlayLine | None, list[OverlayLine]]:
    """Give all lines of an `OrientedPhoto`.

    Returns
    -------
    extracted : OverlayLine or None
    horizons : list of OverlayLine
        Lines of the best answer and up to two alternatives, best first; empty without a DEM horizon or an answer.
    """
    extracted = None
    if photo.skyline is not None:
        extracted = skyline_line(photo.skyline, *full_size(photo))
    horizons = []
    if photo.horizon is not None:
        horizons = [
            horizon_line(photo.horizon, candidate.camera, candidate.pose)
            for candidate in photo.orientation.candidates[:3]
        ]
    return extracted, horizons


def skyline_residuals_px(photo: OrientedPhoto) -> np.ndarray | None:
    """Give the extracted skyline minus the best answer's horizon along the columns of the skyline.

    Returns
    -------
    (w,) array or None
        Residuals [pixels of the full picture], positive where the extracted skyline is lower in the picture; NaN where
        either is unknown. If the matcher gave residuals, they are returned.
    """
    if photo.orientation.residual_px is not None:
        return photo.orientation.residual_px
    extracted, horizons = photo_lines(photo)
    if extracted is None or not horizons or not np.isfinite(horizons[0].x_px).any():
        return None
    known = np.isfinite(horizons[0].x_px)
    x, y = horizons[0].x_px[known], horizons[0].y_px[known]
    order = np.argsort(x, kind="stable")
    row = np.interp(extracted.x_px, x[order], y[order], left=np.nan, right=np.nan)
    return np.where(extracted.doubtful, np.nan, extracted.y_px - row)


def full_size(photo: OrientedPhoto) -> tuple[int, int]:
    """Give (width, height) of the full upright picture [pixels] from the best source in an `OrientedPhoto`."""
    if photo.camera is not None:
        return photo.camera.width_px, photo.camera.height_px
    if photo.metadata is not None:
        return photo.metadata.width_px, photo.metadata.height_px
    if photo.preview is not None:
        return photo.preview.shape[1], photo.preview.shape[0]
    if photo.skyline is not None:
        return photo.skyline.width_px, photo.skyline.height_px
    raise ValueError("the photo has neither camera, metadata, preview nor skyline")


def _with_neighbours(mask: np.ndarray) -> np.ndarray:
    return mask | np.r_[False, mask[:-1]] | np.r_[mask[1:], False]


def _trimmed(x: np.ndarray, y: np.ndarray, doubtful: np.ndarray) -> OverlayLine:
    """Drop unknown points, except one between known parts."""
    known = np.isfinite(x)
    keep = known | np.r_[False, known[:-1]]
    return OverlayLine(x[keep], y[keep], doubtful[keep])
