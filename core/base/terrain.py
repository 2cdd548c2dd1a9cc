"""Interface of an elevation model, independent of its storage.

`core.io.raster.Dem` is a `Terrain` that reads windows of a file. `ArrayTerrain` holds an array in memory, for tests,
simulated scenes and callers that already have the elevations.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .arrays import FloatOrArray
from .curvature import METRES_PER_DEGREE
from .errors import NoElevationAtObserverError, ObserverOutsideDemError
from .frame import LocalFrame, tabulate_frame

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True)
class Window:
    """A rectangle of whole cells, given by its first row and column and the numbers of rows and columns."""

    row: int
    col: int
    rows: int
    cols: int

    def clipped(self, shape: tuple[int, int]) -> Window:
        """Clip to a raster of `shape` (rows, columns); the result may be empty (rows or cols 0)."""
        row, col = max(self.row, 0), max(self.col, 0)
        rows = max(min(self.row + self.rows, shape[0]) - row, 0)
        cols = max(min(self.col + self.cols, shape[1]) - col, 0)
        return Window(row, col, rows, cols)


class Terrain:
    """An elevation model, which gives its size, its cells by window, and the local frame around a position.

    Other kinds of terrain derive from this class and provide `shape`, `read` and `frame`. Terrains are compared and
    hashed by identity, so that results can be cached for the terrain to which they belong.
    """

    shape: tuple[int, int]

    def read(self, window: Window) -> np.ndarray:
        """Read the elevations of a window as float32 (rows, cols) [m]; NaN where the raster has no data.

        The window must lie inside the raster.
        """
        raise NotImplementedError

    def frame(self, longitude_deg: float, latitude_deg: float, radius_m: float) -> LocalFrame:
        """Make the local frame around a position.

        Parameters
        ----------
        longitude_deg, latitude_deg : float
            WGS 84 position [degrees].
        radius_m : float
            Distance to which the frame must reach [m].
        """
        raise NotImplementedError

    def read_into(self, window: Window, out: np.ndarray) -> None:
        """Read a window into a (rows, cols) float32 array, whose memory may be in any order.

        Allocating memory costs more than filling it, so callers that read often pass the same array again. A terrain
        that can fill the array directly overrides this method and saves the copy.
        """
        out[...] = self.read(window)

    def read_transient(self, window: Window) -> np.ndarray:
        """Read like `read`, but into memory that the next call may overwrite; the caller must not write to it."""
        return self.read(window)


@dataclass(frozen=True)
class Observer:
    """Position of the camera.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 position [degrees].
    eye_height_m : float
        Height of the eye above the surface of the terrain model [m]; used if `eye_elevation_m` is None.
    eye_elevation_m : float or None
        Absolute elevation of the eye in the DEM's height system [m].
    """

    longitude_deg: float
    latitude_deg: float
    eye_height_m: float = 1.7
    eye_elevation_m: float | None = None


@dataclass(frozen=True, eq=False)
class ArrayTerrain(Terrain):
    """Elevations in memory on a plane grid whose columns point to true north: distances are exact.

    Attributes
    ----------
    elevation_m : (R, C) float32 array
        Elevations [m]; row 0 is the northernmost.
    cell_m : float
        Side of a cell [m].
    longitude_deg, latitude_deg : float
        WGS 84 position of the centre of the array [degrees]. Longitudes and latitudes of other places follow from
        the plate carree projection at this latitude, which is sufficient for synthetic terrain.
    """

    elevation_m: np.ndarray
    cell_m: float
    longitude_deg: float = 0.0
    latitude_deg: float = 0.0

    def __repr__(self) -> str:
        rows, cols = self.shape
        known = self.elevation_m[np.isfinite(self.elevation_m)]
        heights = f"{known.min():.0f} to {known.max():.0f} m" if known.size else "no elevations"
        place = f"centre {self.longitude_deg:.5f}, {self.latitude_deg:.5f}"
        return f"<ArrayTerrain: {rows} x {cols} cells of {self.cell_m:g} m, {heights}, {place}>"

    @property
    def shape(self) -> tuple[int, int]:  # type: ignore[override]  # nobody sets a terrain's shape from outside
        """(rows, columns)."""
        rows, cols = self.elevation_m.shape
        return rows, cols

    def read(self, window: Window) -> np.ndarray:
        """See `Terrain.read`."""
        rows = slice(window.row, window.row + window.rows)
        return self.elevation_m[rows, window.col : window.col + window.cols].astype(np.float32)

    def frame(self, longitude_deg: float, latitude_deg: float, radius_m: float) -> LocalFrame:
        """See `Terrain.frame`.

        Parameters
        ----------
        longitude_deg, latitude_deg : float
            WGS 84 position [degrees].
        radius_m : float
            Distance to which the frame must reach [m].
        """
        col, row = self.pixel_of(longitude_deg, latitude_deg)
        return tabulate_frame(
            longitude_deg,
            latitude_deg,
            lambda east, north: (col + east / self.cell_m, row - north / self.cell_m),
            radius_m,
            size=3,
        )

    def local_of(
        self, observer: Observer, longitude_deg: FloatOrArray, latitude_deg: FloatOrArray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Give the true (east, north) of positions relative to an observer [m].

        Parameters
        ----------
        observer : Observer
            Origin of the local metres.
        longitude_deg, latitude_deg : float or array
            WGS 84 positions [degrees].
        """
        frame = self.frame(observer.longitude_deg, observer.latitude_deg, 1_000.0)
        return frame.to_local(*self.pixel_of(longitude_deg, latitude_deg))

    def pixel_of(self, longitude_deg: FloatOrArray, latitude_deg: FloatOrArray) -> tuple[FloatOrArray, FloatOrArray]:
        """Give the (col, row) of WGS 84 positions [pixels]."""
        rows, cols = self.shape
        per_degree = METRES_PER_DEGREE / self.cell_m
        col = (cols - 1) / 2 + (longitude_deg - self.longitude_deg) * per_degree * np.cos(np.radians(self.latitude_deg))
        return col, (rows - 1) / 2 - (latitude_deg - self.latitude_deg) * per_degree

    def position_of(self, col_px: FloatOrArray, row_px: FloatOrArray) -> tuple[FloatOrArray, FloatOrArray]:
        """Give the (longitude, latitude) of pixels [degrees]; the inverse of `pixel_of`."""
        rows, cols = self.shape
        per_degree = METRES_PER_DEGREE / self.cell_m
        longitude = self.longitude_deg + (col_px - (cols - 1) / 2) / per_degree / np.cos(np.radians(self.latitude_deg))
        return longitude, self.latitude_deg - (row_px - (rows - 1) / 2) / per_degree


def bilinear(elevation_m: np.ndarray, row_px: ArrayLike, col_px: ArrayLike) -> np.ndarray:
    """Interpolate an array bilinearly between its cell centres.

    This function handles voids and edges, and is used everywhere except in the following places. For speed,
    `base.frame`, `horizon.pieces`, `horizon.sky_view`, `mapping.march` and `mapping.drape` interpolate in their own
    loops; pictures are sampled by `base.imaging.sample_bilinear` and simulated scenes by `simulate.cast.sample_field`.
    Each of these gives its reason.

    Parameters
    ----------
    elevation_m : (R, C) array
        Values, such as elevations [m]; NaN where unknown.
    row_px, col_px : array
        Points [pixels, the centre of the first cell at 0].

    Returns
    -------
    array
        Values in the unit of the array; NaN outside the hull of the cell centres (half a cell of tolerance at the edge,
        where the nearest row or column is used) and where any cell with a non-zero weight is unknown.
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


def check_inside(terrain: Terrain, frame: LocalFrame) -> None:
    """Raise `ObserverOutsideDemError` if the frame's observer is not on the raster."""
    rows, cols = terrain.shape
    if not (-0.5 <= frame.row_px <= rows - 0.5 and -0.5 <= frame.col_px <= cols - 0.5):
        raise ObserverOutsideDemError(frame.longitude_deg, frame.latitude_deg)


def ground_elevation_m(terrain: Terrain, frame: LocalFrame) -> float:
    """Give the elevation of the terrain at the frame's observer [m].

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    check_inside(terrain, frame)
    position = frame.longitude_deg, frame.latitude_deg
    window = Window(int(np.floor(frame.row_px)), int(np.floor(frame.col_px)), 2, 2).clipped(terrain.shape)
    patch = terrain.read(window)
    elevation = float(bilinear(patch, frame.row_px - window.row, frame.col_px - window.col))
    if not np.isfinite(elevation):
        elevation = float(patch[np.isfinite(patch)].mean()) if np.isfinite(patch).any() else np.nan
    if not np.isfinite(elevation):
        raise NoElevationAtObserverError(*position)
    return elevation


def eye_elevation_m(terrain: Terrain, frame: LocalFrame, observer: Observer) -> float:
    """Give the absolute elevation of the observer's eye [m]: as given, else the surface plus the eye height.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
        Frame around the observer.
    observer : Observer

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    if observer.eye_elevation_m is not None:
        return float(observer.eye_elevation_m)
    return ground_elevation_m(terrain, frame) + observer.eye_height_m
