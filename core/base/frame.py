"""The observer's local frame, which relates true east and north on the ground to the raster's columns and rows.

The frame is azimuthal equidistant: the direction of (east, north) is the true azimuth and its length the ground
distance on the ellipsoid. Scale distortion and meridian convergence of the raster's CRS are therefore accounted for
by construction. The exact transformation is expensive, so it is split into an affine part, exact at the observer, and
a smooth remainder that is tabulated on a coarse grid and interpolated. The table is filled from a polynomial through a
few hundred exact points if further exact points confirm the polynomial, otherwise point by point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

NEGLIGIBLE_PX = 0.02
"""A remainder below this is neglected instead of interpolated [cells]."""

DEGREE = 16
"""Degree, per axis, of the polynomial from which a table is filled."""

POLYNOMIAL_PX = 1e-3
"""Largest error of the polynomial at exact points [pixels]; above it, the table is computed node by node."""

Transform = Callable[[np.ndarray, np.ndarray], Sequence[np.ndarray]]
"""A function from (east_m, north_m) [m] to (col, row) of the whole raster [pixels]."""


@dataclass(frozen=True, eq=False)
class LocalFrame:
    """Conversion in both directions between local metres and raster pixels around one observer.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 position of the observer [degrees].
    col_px, row_px : float
        Position of the observer [pixels of the whole raster, the centre of the first cell at 0].
    jacobian_px_per_m : (2, 2) array
        [[d col/d east, d col/d north], [d row/d east, d row/d north]] at the observer [pixels per m].
    radius_m : float
        Distance from the observer to which the tables reach in each direction [m].
    remainder_px : (2, N, N) array or None
        Remainder of (col, row) on a regular grid over (north, east) in [-radius, radius] [pixels]; None if negligible.
    """

    longitude_deg: float
    latitude_deg: float
    col_px: float
    row_px: float
    jacobian_px_per_m: np.ndarray
    radius_m: float
    remainder_px: np.ndarray | None = None

    @property
    def convergence_deg(self) -> float:
        """Bearing of grid north (up the columns) from true north, clockwise [degrees]."""
        east, north = np.linalg.solve(self.jacobian_px_per_m, [0.0, -1.0 if self.row_goes_south else 1.0])
        return float(np.degrees(np.arctan2(east, north)))

    @property
    def row_goes_south(self) -> bool:
        """Whether the rows run from grid north to grid south, as in nearly all rasters."""
        (a, b), (c, d) = self.jacobian_px_per_m
        return a * d - b * c < 0

    @property
    def cell_size_m(self) -> tuple[float, float]:
        """Size on the ground of the observer's cell (along a row, along a column) [m]."""
        inverse = np.linalg.inv(self.jacobian_px_per_m)
        return float(np.hypot(*inverse[:, 0])), float(np.hypot(*inverse[:, 1]))

    @property
    def cell_m(self) -> float:
        """Size of the cell on the ground as one number, the geometric mean of its sides [m]."""
        return float(np.sqrt(np.prod(self.cell_size_m)))

    def to_pixel(self, east_m: ArrayLike, north_m: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Map local metres to (col, row) of the whole raster [pixels]; shapes broadcast together."""
        east_m, north_m = np.broadcast_arrays(np.asarray(east_m, float), np.asarray(north_m, float))
        (a, b), (c, d) = self.jacobian_px_per_m
        col = self.col_px + a * east_m + b * north_m
        row = self.row_px + c * east_m + d * north_m
        if self.remainder_px is not None:
            to_index = (self.remainder_px.shape[-1] - 1) / (2 * self.radius_m)
            index = (north_m + self.radius_m) * to_index, (east_m + self.radius_m) * to_index
            bent_col, bent_row = _interpolate(self.remainder_px, *index)
            col, row = col + bent_col, row + bent_row
        return col, row

    def to_local(
        self, col_px: ArrayLike, row_px: ArrayLike, iterations: int = 3, enough_m: float = 0.0
    ) -> tuple[np.ndarray, np.ndarray]:
        """Map (col, row) of the whole raster to local (east, north) [m]; the inverse of `to_pixel`.

        The remainder is small compared with the affine part, so a few fixed-point steps converge to well below a
        hundredth of a cell.

        Parameters
        ----------
        col_px, row_px : array
            Pixels of the whole raster; broadcast together.
        iterations : int
            Largest number of fixed-point steps.
        enough_m : float
            No further step is made after one that is nowhere longer than this along either axis [m].
        """
        inverse = np.linalg.inv(self.jacobian_px_per_m)
        col_px, row_px = np.broadcast_arrays(np.asarray(col_px, float), np.asarray(row_px, float))
        east, north = _apply(inverse, col_px - self.col_px, row_px - self.row_px)
        if self.remainder_px is None:
            return east, north
        for _ in range(iterations):
            col, row = self.to_pixel(east, north)
            step_east, step_north = _apply(inverse, col_px - col, row_px - row)
            east, north = east + step_east, north + step_north
            if enough_m and max(np.abs(step_east).max(), np.abs(step_north).max()) <= enough_m:
                break
        return east, north


def _apply(matrix: np.ndarray, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return matrix[0, 0] * x + matrix[0, 1] * y, matrix[1, 0] * x + matrix[1, 1] * y


def _interpolate(tables: np.ndarray, row: np.ndarray, col: np.ndarray) -> Iterator[np.ndarray]:
    """Interpolate square tables linearly; beyond the outer nodes the values at the edge hold.

    SciPy's own interpolation takes as long, and its import takes longer than all frames of a usual run.
    """
    size = tables.shape[-1]
    row, col = (np.fmin(np.fmax(place, 0.0), size - 1.0) for place in (row, col))  # NaN yields NaN below
    first_row, first_col = (np.minimum(place.astype(np.intp), size - 2) for place in (row, col))
    row, col = row - first_row, col - first_col
    corner = first_row * size + first_col
    for table in tables:
        flat = table.reshape(-1)
        upper, lower = flat.take(corner), flat.take(corner + size)
        upper = upper + (flat.take(corner + 1) - upper) * col
        lower = lower + (flat.take(corner + (size + 1)) - lower) * col
        yield upper + (lower - upper) * row


def tabulate_frame(
    longitude_deg: float, latitude_deg: float, transform: Transform, radius_m: float, size: int = 129
) -> LocalFrame:
    """Build a `LocalFrame` from an exact transformation.

    Parameters
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 position of the observer [degrees].
    transform : callable
        (east_m, north_m) arrays -> (col, row) arrays of the whole raster [pixels].
    radius_m : float
        Reach of the frame [m].
    size : int
        Nodes per side of the table, odd. With 129 nodes over 200 km, the error for a raster in longitude and
        latitude at 60 degrees north is about 0.1 m.
    """
    step = min(10.0, radius_m / 100)
    col, row = transform(np.array([0, step, -step, 0, 0]), np.array([0, 0, 0, step, -step]))
    jacobian = np.array([[col[1] - col[2], col[3] - col[4]], [row[1] - row[2], row[3] - row[4]]]) / (2 * step)
    frame = LocalFrame(longitude_deg, latitude_deg, float(col[0]), float(row[0]), jacobian, float(radius_m))

    def remainder_at(east_m: np.ndarray, north_m: np.ndarray) -> np.ndarray:
        return np.array(transform(east_m, north_m)) - np.array(frame.to_pixel(east_m, north_m))

    axis = np.linspace(-radius_m, radius_m, size)
    remainder = _polynomial_table(remainder_at, axis) if size > 2 * DEGREE else None
    if remainder is None:
        north, east = np.meshgrid(axis, axis, indexing="ij")
        remainder = remainder_at(east.ravel(), north.ravel()).reshape(2, size, size)
    if not np.isfinite(remainder).all():
        # Distant corners may lie outside the CRS's domain, where the raster has no cells either.
        remainder = np.nan_to_num(remainder, nan=0.0, posinf=0.0, neginf=0.0)
    if np.abs(remainder).max() < NEGLIGIBLE_PX:
        return frame
    return LocalFrame(longitude_deg, latitude_deg, frame.col_px, frame.row_px, jacobian, float(radius_m), remainder)


def _polynomial_table(
    remainder_at: Callable[[np.ndarray, np.ndarray], np.ndarray], axis: np.ndarray
) -> np.ndarray | None:
    """Fill a table over (north, east) from a Chebyshev interpolant; None if exact points contradict it."""
    count = DEGREE + 1
    radius = float(axis[-1])
    node = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    north, east = np.meshgrid(node * radius, node * radius, indexing="ij")
    values = remainder_at(east.ravel(), north.ravel()).reshape(2, count, count)
    if not np.isfinite(values).all():
        return None
    orthogonal = np.polynomial.chebyshev.chebvander(node, DEGREE) * (2.0 / count)
    orthogonal[:, 0] /= 2
    coefficients = orthogonal.T @ values @ orthogonal

    def at(places: np.ndarray) -> np.ndarray:
        return np.polynomial.chebyshev.chebvander(places / radius, DEGREE)

    probe = np.linspace(-radius, radius, 9)
    north, east = np.meshgrid(probe, probe, indexing="ij")
    exact = remainder_at(east.ravel(), north.ravel()).reshape(2, len(probe), len(probe))
    error = np.abs(at(probe) @ coefficients @ at(probe).T - exact)
    if not error.max() <= POLYNOMIAL_PX:  # NaN fails this test too
        return None
    return at(axis) @ coefficients @ at(axis).T
