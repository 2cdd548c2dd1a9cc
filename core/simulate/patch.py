"""The part of a terrain that a simulated view needs, in memory as one array."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import map_coordinates

from ..base.terrain import Window

VOID_M = -2.0e4
"""Elevation given to voids, so that they hide nothing and show nothing."""


@dataclass(frozen=True, eq=False)
class TerrainPatch:
    """The part of a terrain that a view needs, as one array.

    Attributes
    ----------
    elevation_m : (r, c) float32 array
        Elevations [m]; voids are set to `VOID_M`.
    window : Window
        Position of the patch in the raster.
    """

    elevation_m: np.ndarray
    window: Window

    def sample(self, field, frame, east_m, north_m, outside):
        """Sample a field at local metres.

        Parameters
        ----------
        field : (r, c) array
            Field over the patch.
        frame : LocalFrame
        east_m, north_m : array
            Positions [m].
        outside : float
            Value beyond the patch.
        """
        col, row = frame.to_pixel(east_m, north_m)
        return sample_field(field, row - self.window.row, col - self.window.col, outside)


def sample_field(field, row_px, col_px, outside=None):
    """Interpolate an (r, c) field of a simulated scene bilinearly, in single precision.

    All of `simulate` samples with this function, and not with `core.base.terrain.bilinear`: scenes have no voids, and
    their pictures, on which the published accuracy is based, must stay the same to the last bit.

    Parameters
    ----------
    field : (r, c) array
    row_px, col_px : array
        Positions, with the first cell's centre at 0 [pixels].
    outside : float or None
        Value beyond the field; None extends the outer cells.
    """
    place = np.array([row_px, col_px])
    if outside is None:
        return map_coordinates(field, place, order=1, mode="nearest", output=np.float32)
    return map_coordinates(field, place, order=1, mode="constant", cval=outside, output=np.float32)


def read_patch(terrain, frame, eye_turns_deg, heading_deg, range_m):
    """Read the bounding window of a view's wedge.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
        Around the eye.
    eye_turns_deg : (float, float)
        Azimuths of the wedge's edges relative to the heading [degrees].
    heading_deg : float
    range_m : float
        Radius of the wedge [m].

    Returns
    -------
    TerrainPatch
    """
    azimuth = np.radians(heading_deg + np.linspace(eye_turns_deg[0] - 1, eye_turns_deg[1] + 1, 181))
    east = np.append(range_m * np.sin(azimuth), 0.0)
    north = np.append(range_m * np.cos(azimuth), 0.0)
    col, row = frame.to_pixel(east, north)
    low_col, low_row = int(np.floor(col.min())) - 3, int(np.floor(row.min())) - 3
    window = Window(low_row, low_col, int(np.ceil(row.max())) + 4 - low_row, int(np.ceil(col.max())) + 4 - low_col)
    window = window.clipped(terrain.shape)
    elevation = np.asarray(terrain.read(window), np.float32)
    return TerrainPatch(np.where(np.isfinite(elevation), elevation, np.float32(VOID_M)), window)
