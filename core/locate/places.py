"""Places of an area at which a photograph may have been taken: a regular grid on the cells of a DEM, in tiles."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..base.curvature import METRES_PER_DEGREE
from ..base.errors import SkylineViewshedError
from ..base.messages import Message

TILE = 40
"""Largest number of places along one side of a tile."""

BYTES_PER_AZIMUTH = 4
"""Size of the angle and the distance of the horizon in an index, per azimuth [bytes]."""

RING_VERTICES = 90


class AreaError(SkylineViewshedError):
    """The area cannot be searched: outside the DEM, empty, or too large for the memory."""


@dataclass(frozen=True)
class Area:
    """Polygons in WGS 84, with holes: a place is inside if a ray from it crosses the rings an odd number of times.

    Attributes
    ----------
    rings : tuple of tuples of (longitude_deg, latitude_deg)
    """

    rings: tuple

    @classmethod
    def box(cls, west_deg, south_deg, east_deg, north_deg):
        """Make an area from its bounds.

        Parameters
        ----------
        west_deg, south_deg, east_deg, north_deg : float
            WGS 84 [degrees].
        """
        corners = (west_deg, south_deg), (east_deg, south_deg), (east_deg, north_deg), (west_deg, north_deg)
        return cls((corners,))

    @classmethod
    def circle(cls, longitude_deg, latitude_deg, radius_m):
        """Make the area within a distance of a position.

        Parameters
        ----------
        longitude_deg, latitude_deg : float
            WGS 84 [degrees].
        radius_m : float
        """
        turn = np.linspace(0, 2 * np.pi, RING_VERTICES, endpoint=False)
        north = radius_m / METRES_PER_DEGREE
        east = north / max(np.cos(np.radians(latitude_deg)), 1e-6)
        ring = zip(longitude_deg + east * np.cos(turn), latitude_deg + north * np.sin(turn))
        return cls((tuple((float(x), float(y)) for x, y in ring),))

    def holds(self, longitude_deg, latitude_deg):
        """Tell which positions (N,) [degrees] lie inside."""
        x, y = np.asarray(longitude_deg, float), np.asarray(latitude_deg, float)
        inside = np.zeros(x.shape, bool)
        for ring in self.rings:
            points = np.asarray(ring, float)
            for (x0, y0), (x1, y1) in zip(points, np.roll(points, -1, axis=0)):
                if y0 == y1:
                    continue
                crosses = (y0 > y) != (y1 > y)
                inside ^= crosses & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
        return inside


@dataclass(frozen=True)
class IndexOptions:
    """Grid of places and the sampling of their horizons.

    Attributes
    ----------
    spacing_m : float
        Distance between neighbouring places, rounded to whole cells of the DEM [m].
    eye_height_m : float
        Height of the eye above the DEM [m].
    azimuths : int
        Number of azimuths of a horizon.
    max_distance_m : float
        Search range of the horizons [m].
    refraction_coefficient : float
    memory_mb : float
        Largest index that is held in memory [MB].
    """

    spacing_m: float = 250.0
    eye_height_m: float = 1.7
    azimuths: int = 720
    max_distance_m: float = 60_000.0
    refraction_coefficient: float = 0.13
    memory_mb: float = 1000.0

    def __post_init__(self):
        if not (self.spacing_m > 0 and self.max_distance_m > 0 and self.azimuths >= 36):
            raise ValueError(f"spacing and range must be positive, with at least 36 azimuths, not {self}")


@dataclass(frozen=True, eq=False)
class Tile:
    """Places that are sampled together.

    Attributes
    ----------
    row, col, rows, cols : int
        Cell of the first place, and the number of places in each direction.
    inside : (rows * cols,) bool array
        Which of them lie in the area, row by row.
    """

    row: int
    col: int
    rows: int
    cols: int
    inside: np.ndarray


@dataclass(frozen=True, eq=False)
class PlaceGrid:
    """All places of an area.

    Attributes
    ----------
    tiles : tuple of Tile
    step_rows, step_cols : int
        Distance between neighbouring places [cells].
    spacing_m : float
        The same on the ground, as the geometric mean [m].
    count : int
    """

    tiles: tuple = field(default_factory=tuple)
    step_rows: int = 1
    step_cols: int = 1
    spacing_m: float = 250.0
    count: int = 0


def lay_places(dem, area, options=IndexOptions()):  # noqa: B008 - frozen
    """Lay the grid of places over an area.

    Parameters
    ----------
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
        A terrain with `pixel_of` and `position_of`.
    area : Area
    options : IndexOptions

    Returns
    -------
    PlaceGrid

    Raises
    ------
    AreaError
        No place of the area lies inside the DEM.
    """
    outline = np.concatenate([_densified(ring) for ring in area.rings])
    col, row = (np.asarray(values, float) for values in dem.pixel_of(*outline.T))
    known = np.isfinite(col) & np.isfinite(row)
    rows, cols = dem.shape
    first_row, last_row = _range(row[known], rows)
    first_col, last_col = _range(col[known], cols)
    if first_row >= last_row or first_col >= last_col:
        raise AreaError(_outside())
    middle = dem.position_of((first_col + last_col) / 2, (first_row + last_row) / 2)
    frame = dem.frame(float(middle[0]), float(middle[1]), 1_000.0)
    width_m, height_m = frame.cell_size_m
    step_cols, step_rows = (max(int(round(options.spacing_m / size)), 1) for size in (width_m, height_m))
    tiles, count = [], 0
    for top in range(first_row, last_row + 1, TILE * step_rows):
        for left in range(first_col, last_col + 1, TILE * step_cols):
            down = min(TILE, (last_row - top) // step_rows + 1)
            across = min(TILE, (last_col - left) // step_cols + 1)
            place = np.mgrid[:down, :across].reshape(2, -1)
            inside = area.holds(*dem.position_of(left + place[1] * step_cols, top + place[0] * step_rows))
            if inside.any():
                tiles.append(Tile(top, left, down, across, inside))
                count += int(inside.sum())
    if not count:
        raise AreaError(_outside())
    spacing_m = float(np.sqrt(step_cols * width_m * step_rows * height_m))
    return PlaceGrid(tuple(tiles), step_rows, step_cols, spacing_m, count)


def check_memory(grid, options):
    """Refuse an index that does not fit into the memory.

    Raises
    ------
    AreaError
        It names the largest area that fits at this spacing.
    """
    needed_mb = grid.count * options.azimuths * BYTES_PER_AZIMUTH / 1e6
    if needed_mb > options.memory_mb:
        fits_km2 = grid.spacing_m**2 / 1e6 * options.memory_mb / needed_mb * grid.count
        raise AreaError(
            Message(
                "The area needs an index of {needed} MB, and {limit} MB are allowed. Choose an area of at most {km2} "
                "km2, a wider spacing of the places, or a folder for the index, which then stays on disk.",
                needed=f"{needed_mb:.0f}",
                limit=f"{options.memory_mb:.0f}",
                km2=f"{fits_km2:.0f}",
            )
        )


def _outside():
    return Message("No part of the area lies inside the DEM. Choose an area that the DEM covers, or another DEM.")


def _range(pixel, size):
    """First and last whole cell between the extremes that lie inside the raster."""
    if not len(pixel):
        return 0, 0
    return int(max(np.ceil(pixel.min()), 0)), int(min(np.floor(pixel.max()), size - 1))


def _densified(ring, parts=8):
    """Vertices of a ring with further ones on its edges, since straight edges are curves in another CRS."""
    points = np.asarray(ring, float)
    share = np.arange(parts)[:, None, None] / parts
    return (points + share * (np.roll(points, -1, axis=0) - points)).reshape(-1, 2)
