"""What the stages ask of an elevation model, wherever it is stored.

`core.io.raster` gives a `Terrain` that reads windows of a file; `ArrayTerrain` holds an array in memory, for
tests, simulated scenes and callers that have the elevations already.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from .errors import NoElevationAtObserverError, ObserverOutsideDemError
from .frame import LocalFrame, tabulate_frame


@dataclass(frozen=True)
class Window:
    """A rectangle of whole cells: first row and column, and how many."""

    row: int
    col: int
    rows: int
    cols: int

    def clipped(self, shape):
        """Cut to a raster of `shape` (rows, columns); may come out empty (rows or cols 0)."""
        row, col = max(self.row, 0), max(self.col, 0)
        rows = max(min(self.row + self.rows, shape[0]) - row, 0)
        cols = max(min(self.col + self.cols, shape[1]) - col, 0)
        return Window(row, col, rows, cols)


class Terrain(Protocol):
    """An elevation model: its size, its cells by window, and the local frame around a position."""

    shape: tuple[int, int]

    def read(self, window: Window) -> np.ndarray:
        """Elevations of the window as float32 (rows, cols) [m]; NaN where the raster has no data.

        The window must lie inside the raster.
        """

    def frame(self, longitude_deg: float, latitude_deg: float, radius_m: float) -> LocalFrame:
        """Local frame around a WGS 84 position, reaching `radius_m` [m]."""


def read_into(terrain, window, out):
    """Read a window of a terrain into a (rows, cols) float32 array, whose memory may lie in any order.

    New memory costs more than the cells that come into it, so who reads much uses it again. A terrain with a
    `read_into(window, out)` of its own saves the copy, too.
    """
    if hasattr(terrain, "read_into"):
        terrain.read_into(window, out)
    else:
        out[...] = terrain.read(window)


@dataclass(frozen=True)
class Observer:
    """Where the camera stands.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 [degrees].
    eye_height_m : float
        Above the terrain model's surface [m]; used where `eye_elevation_m` is None.
    eye_elevation_m : float or None
        Absolute elevation of the eye in the DEM's height system [m].
    """

    longitude_deg: float
    latitude_deg: float
    eye_height_m: float = 1.7
    eye_elevation_m: float | None = None


@dataclass(frozen=True, eq=False)
class ArrayTerrain:
    """Elevations in memory on a plane grid whose columns point to true north: distances are exact.

    Attributes
    ----------
    elevation_m : (R, C) float32 array
        Row 0 is the northernmost [m].
    cell_m : float
        Side of a cell [m].
    longitude_deg, latitude_deg : float
        WGS 84 position given to the centre of the array [degrees]. Longitudes and latitudes of other places
        follow by the plate carree of this latitude, which is all that synthetic terrain needs.
    """

    elevation_m: np.ndarray
    cell_m: float
    longitude_deg: float = 0.0
    latitude_deg: float = 0.0

    METRES_PER_DEGREE = 6_371_000.0 * np.pi / 180

    @property
    def shape(self):
        """(rows, columns)."""
        return self.elevation_m.shape

    def read(self, window):
        """See `Terrain.read`."""
        rows = slice(window.row, window.row + window.rows)
        return self.elevation_m[rows, window.col : window.col + window.cols].astype(np.float32)

    def frame(self, longitude_deg, latitude_deg, radius_m):
        """See `Terrain.frame`."""
        col, row = self.pixel_of(longitude_deg, latitude_deg)
        return tabulate_frame(
            longitude_deg,
            latitude_deg,
            lambda east, north: (col + east / self.cell_m, row - north / self.cell_m),
            radius_m,
            size=3,
        )

    def pixel_of(self, longitude_deg, latitude_deg):
        """(col, row) of a position [pixels]."""
        rows, cols = self.shape
        per_degree = self.METRES_PER_DEGREE / self.cell_m
        col = (cols - 1) / 2 + (longitude_deg - self.longitude_deg) * per_degree * np.cos(np.radians(self.latitude_deg))
        return col, (rows - 1) / 2 - (latitude_deg - self.latitude_deg) * per_degree

    def position_of(self, col_px, row_px):
        """(longitude, latitude) of a pixel [degrees]; inverse of `pixel_of`."""
        rows, cols = self.shape
        per_degree = self.METRES_PER_DEGREE / self.cell_m
        longitude = self.longitude_deg + (col_px - (cols - 1) / 2) / per_degree / np.cos(np.radians(self.latitude_deg))
        return longitude, self.latitude_deg - (row_px - (rows - 1) / 2) / per_degree


def bilinear(elevation_m, row_px, col_px):
    """Sample an array between its cell centres.

    Parameters
    ----------
    elevation_m : (R, C) array
        [m], NaN where unknown.
    row_px, col_px : array
        Pixels, the first cell's centre at 0.

    Returns
    -------
    array
        [m]; NaN outside the cell centres' hull (half a cell of tolerance at the edge, where the nearest row or
        column is held) and where any cell with weight is unknown.
    """
    rows, cols = elevation_m.shape
    row_px, col_px = np.asarray(row_px, float), np.asarray(col_px, float)
    outside = ~((row_px >= -0.5) & (row_px <= rows - 0.5) & (col_px >= -0.5) & (col_px <= cols - 0.5))
    row = np.clip(np.where(outside, 0.0, row_px), 0, rows - 1)
    col = np.clip(np.where(outside, 0.0, col_px), 0, cols - 1)
    r0 = np.minimum(row.astype(np.intp), max(rows - 2, 0))
    c0 = np.minimum(col.astype(np.intp), max(cols - 2, 0))
    r1, c1 = np.minimum(r0 + 1, rows - 1), np.minimum(c0 + 1, cols - 1)
    fr, fc = row - r0, col - c0
    total = np.zeros(row.shape)
    for r, wr in ((r0, 1 - fr), (r1, fr)):
        for c, wc in ((c0, 1 - fc), (c1, fc)):
            weight = wr * wc
            total += np.where(weight > 0, weight * elevation_m[r, c], 0.0)
    return np.where(outside, np.nan, total)


def ground_elevation_m(terrain, frame):
    """Elevation of the terrain under the frame's observer [m].

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    rows, cols = terrain.shape
    position = frame.longitude_deg, frame.latitude_deg
    if not (-0.5 <= frame.row_px <= rows - 0.5 and -0.5 <= frame.col_px <= cols - 0.5):
        raise ObserverOutsideDemError(*position)
    window = Window(int(np.floor(frame.row_px)), int(np.floor(frame.col_px)), 2, 2).clipped(terrain.shape)
    patch = terrain.read(window)
    elevation = float(bilinear(patch, frame.row_px - window.row, frame.col_px - window.col))
    if not np.isfinite(elevation):
        elevation = float(patch[np.isfinite(patch)].mean()) if np.isfinite(patch).any() else np.nan
    if not np.isfinite(elevation):
        raise NoElevationAtObserverError(*position)
    return elevation


def eye_elevation_m(terrain, frame, observer):
    """Absolute elevation of the observer's eye [m]: as given, else the terrain's surface plus the eye height."""
    if observer.eye_elevation_m is not None:
        return float(observer.eye_elevation_m)
    return ground_elevation_m(terrain, frame) + observer.eye_height_m
