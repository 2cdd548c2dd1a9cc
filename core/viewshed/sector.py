"""The part of the view that counts: the full circle, a wedge around the heading, or the photograph's true frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.angles import difference, in_wedge
from ..base.camera import Camera, Pose, in_frame, project, unproject


class Sector:
    """The interface of a sector of the view, as the sweep uses it; all sectors derive from this class.

    Several threads may ask at once, so no method may change the sector.

    Attributes
    ----------
    selective : bool
        Some directions lie outside the sector.
    azimuth_only : bool
        Only the azimuth decides.
    includes_observer : bool
        The observer's own cell lies in the sector.
    gives_marks : bool
        The sweep calls `marks` for each cell, and not `accepts`.
    azimuth_range_deg : (float, float)
        First azimuth and width of a wedge that contains the sector [degrees].
    """

    selective, azimuth_only = True, False
    includes_observer = True
    gives_marks = False
    azimuth_range_deg = (0.0, 360.0)

    def touches(self, azimuth_deg, margin_deg):
        """Return which azimuths lie in the sector, or within a margin of it [degrees]."""
        raise NotImplementedError

    def accepts(self, azimuth_deg, elevation_deg, distance_m):
        """Return which directions lie in the sector.

        Parameters
        ----------
        azimuth_deg : array
            True azimuths [degrees].
        elevation_deg : array or None
            Apparent elevation angles, NaN where the terrain is unknown; None if `azimuth_only` [degrees].
        distance_m : array or None
            Ground distances; None if `azimuth_only` [m].
        """
        raise NotImplementedError

    def marks(self, azimuth_deg, elevation_deg, distance_m):
        """Return the bits to add to the values of cells in these directions, 0 for those outside: uint32.

        Parameters
        ----------
        azimuth_deg, elevation_deg, distance_m : array
            As for `accepts`.
        """
        raise NotImplementedError


@dataclass(frozen=True)
class FullCircle(Sector):
    """All directions around the observer."""

    selective, azimuth_only = False, True

    def touches(self, azimuth_deg, margin_deg):
        """See `Sector.touches`."""
        return np.ones(np.shape(azimuth_deg), bool)

    def accepts(self, azimuth_deg, elevation_deg, distance_m):
        """See `Sector.accepts`."""
        return np.ones(np.shape(azimuth_deg), bool)


@dataclass(frozen=True)
class Wedge(Sector):
    """Azimuths within half the width of the heading, including the edges.

    Attributes
    ----------
    heading_deg : float
        Clockwise from true north [degrees].
    width_deg : float
        Full angle, usually the horizontal field of view [degrees].
    """

    heading_deg: float
    width_deg: float

    azimuth_only = True

    def __post_init__(self):
        if not 0 < self.width_deg <= 360:
            raise ValueError(f"a wedge must be wider than 0 and at most 360 degrees, not {self.width_deg}")

    @property
    def azimuth_range_deg(self):
        """First azimuth and width [degrees]."""
        return self.heading_deg - self.width_deg / 2, self.width_deg

    def touches(self, azimuth_deg, margin_deg):
        """See `Sector.touches`."""
        return in_wedge(azimuth_deg, self.heading_deg, self.width_deg + 2 * margin_deg)

    def accepts(self, azimuth_deg, elevation_deg, distance_m):
        """See `Sector.accepts`."""
        # A tolerance of a tenth of a microdegree keeps cells on an edge inside, whatever the rounding.
        return in_wedge(azimuth_deg, self.heading_deg, self.width_deg + 2e-7)


@dataclass(frozen=True, eq=False)
class PhotoFrame(Sector):
    """Directions that project into the photograph, by the exact pinhole camera.

    Attributes
    ----------
    camera : Camera
        Camera of the full upright picture.
    pose : Pose
    skyline_row_px : (width_px,) array or None
        First ground row of each column of the full picture, NaN if unknown. Ground that would appear above it is not
        claimed: something that the DEM does not contain hides it in the photograph, or the pose is inaccurate.
    tolerance_px : float
        Ground may appear this far above the skyline [pixels].
    """

    camera: Camera
    pose: Pose
    skyline_row_px: np.ndarray | None = None
    tolerance_px: float = 0.0

    includes_observer = False

    @property
    def azimuth_range_deg(self):
        """First azimuth and width of the narrowest wedge that holds the frame [degrees]."""
        centre, half = self._wedge()
        return centre - half, 2 * half

    def _wedge(self):
        width, height = self.camera.width_px - 0.5, self.camera.height_px - 0.5
        x, y = np.linspace(-0.5, width, 200), np.linspace(-0.5, height, 200)
        border_x = np.concatenate([x, x, np.full(200, -0.5), np.full(200, width)])
        border_y = np.concatenate([np.full(200, -0.5), np.full(200, height), y, y])
        azimuth, _ = unproject(self.camera, self.pose, border_x, border_y)
        for elevation in (-90.0, 90.0):  # a frame that contains the zenith or nadir covers all azimuths
            if in_frame(self.camera, *project(self.camera, self.pose, self.pose.heading_deg, elevation)):
                return self.pose.heading_deg, 180.0
        turn = difference(azimuth, self.pose.heading_deg)
        return self.pose.heading_deg, min(float(np.abs(turn).max()) + 0.01, 180.0)

    def touches(self, azimuth_deg, margin_deg):
        """See `Sector.touches`."""
        centre, half = self._wedge()
        return in_wedge(azimuth_deg, centre, min(2 * (half + margin_deg), 360.0))

    def accepts(self, azimuth_deg, elevation_deg, distance_m):
        """See `Sector.accepts`; a direction without elevation angle (a void) is accepted within the wedge."""
        x, y = project(self.camera, self.pose, azimuth_deg, elevation_deg)
        accepted = in_frame(self.camera, x, y)
        if self.skyline_row_px is not None:
            column = np.clip(np.nan_to_num(x), 0, self.camera.width_px - 1)
            row = np.interp(column, np.arange(self.camera.width_px), self.skyline_row_px)
            with np.errstate(invalid="ignore"):
                accepted &= ~(y < row - self.tolerance_px)
        unknown = np.isnan(elevation_deg)
        if unknown.any():
            centre, half = self._wedge()
            accepted[unknown] = in_wedge(np.asarray(azimuth_deg)[unknown], centre, 2 * half)
        return accepted


LEAST_CONFIDENCE = 0.5
"""Columns of an extracted skyline with less confidence set no limit."""


def skyline_rows(column_px, row_px, confidence, width_px):
    """Convert a skyline to one row per column of the full picture, as `PhotoFrame.skyline_row_px` needs it.

    Parameters
    ----------
    column_px, row_px, confidence : (N,) arrays
        The extracted skyline, on the full upright picture [pixels]; confidence 0 to 1.
    width_px : int
        Width of the picture [pixels].

    Returns
    -------
    (width_px,) array
        Rows [pixels]; NaN where the line is unknown or its confidence is below `LEAST_CONFIDENCE`.
    """
    column, row, sure = (np.asarray(values, float) for values in (column_px, row_px, confidence))
    order = np.argsort(column, kind="stable")
    column, row = column[order], np.where(sure >= LEAST_CONFIDENCE, row, np.nan)[order]
    if not len(column):
        return np.full(width_px, np.nan)
    wanted = np.arange(width_px)
    line = np.interp(wanted, column, row)
    gap = np.diff(column).max(initial=1.0)
    line[(wanted < column[0] - gap) | (wanted > column[-1] + gap)] = np.nan
    return line
