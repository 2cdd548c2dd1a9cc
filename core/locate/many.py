"""Horizons of many places at once: all places of a regular grid of cells march along the same ray together.

The places lie on cell centres, a whole number of cells apart. The cells that they meet at one distance in one direction
are then one shifted copy of the grid of places, so that a step of all rays is a few operations on whole arrays, without
a look-up. The elevations are held once for each phase of the grid, so that these copies lie side by side in memory.

Near samples are bilinear. Farther samples take the nearest cell, and where a step of azimuth spans several cells, the
highest cell of a block of that width. `docs/locate.md` says how far the result agrees with `horizon.horizon_profile`,
the exact engine, which also reports where the DEM ends too early.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.progress import SILENT, checkpoint
from ..base.terrain import Window

BILINEAR_CELLS = 48
"""Samples nearer than this are bilinear, half a cell apart [cells]."""

BLOCKS = (1, 2, 4, 8)
"""Widths of the blocks whose highest cell is taken [cells]."""

STRIP_CELLS = 2_000_000
"""Cells that are read together."""


@dataclass(frozen=True)
class CellGrid:
    """Places on cell centres of a DEM.

    Attributes
    ----------
    row, col : int
        Cell of the first place.
    rows, cols : int
        Number of places in each direction.
    step_rows, step_cols : int
        Distance between neighbouring places [cells].
    """

    row: int
    col: int
    rows: int
    cols: int
    step_rows: int = 1
    step_cols: int = 1

    @property
    def middle_px(self):
        """(col, row) of the middle of the grid [pixels]."""
        return (
            self.col + 0.5 * (self.cols - 1) * self.step_cols,
            self.row + 0.5 * (self.rows - 1) * self.step_rows,
        )

    @property
    def places_px(self):
        """(col, row) of all places, (rows * cols,) arrays, row by row [pixels]."""
        row, col = np.mgrid[: self.rows, : self.cols]
        return self.col + col.ravel() * self.step_cols, self.row + row.ravel() * self.step_rows


@dataclass(frozen=True)
class ManyOptions:
    """How the horizons of many places are sampled.

    Attributes
    ----------
    azimuths : int
        Number of azimuths around the circle.
    max_distance_m : float
        Search range [m].
    refraction_coefficient : float
        k of `apparent_drop_m`.
    near_skip_cells : float
        The search starts this far from the eye [cells].
    """

    azimuths: int = 720
    max_distance_m: float = 60_000.0
    refraction_coefficient: float = REFRACTION_COEFFICIENT
    near_skip_cells: float = 1.5


@dataclass(frozen=True, eq=False)
class ManyHorizons:
    """Horizons of P places at A azimuths, clockwise from true north.

    Attributes
    ----------
    elevation_deg, distance_m : (P, A) float32 arrays
        NaN where nothing is known.
    ground_m : (P,) float32 array
        Elevation of the terrain at each place; NaN in voids [m].
    """

    elevation_deg: np.ndarray
    distance_m: np.ndarray
    ground_m: np.ndarray


def many_horizons(terrain, frame, grid, eye_height_m, options=ManyOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Compute the horizons of all places of a grid.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
        Around the middle of the grid. Directions and distances of all places are taken from it, so that a grid is best
        not wider than about 10 km: 5 km from its middle, true north differs by less than 0.1 degrees up to 65 degrees
        of latitude.
    grid : CellGrid
        Its places must lie inside the terrain.
    eye_height_m : float
        Height of the eye above the terrain [m].
    options : ManyOptions
    progress : Progress

    Returns
    -------
    ManyHorizons
    """
    distance_m, block = _distances(frame.cell_m, options)
    azimuth = np.radians(np.arange(options.azimuths) * (360.0 / options.azimuths))[:, None]
    col, row = frame.to_pixel(distance_m * np.sin(azimuth), distance_m * np.cos(azimuth))
    col, row = col - frame.col_px, row - frame.row_px
    near = int(np.searchsorted(distance_m, BILINEAR_CELLS * frame.cell_m))
    block[:near] = 1
    shift = np.ceil(np.maximum(np.abs(col), np.abs(row)).max(axis=0))
    reach = {1: 0, **{int(size): int(shift[block == size].max()) for size in np.unique(block)}}
    cells = _Phases(terrain, grid, reach)
    shape = (grid.rows, grid.cols)
    eye = cells.at(1, 0, 0) + np.float32(eye_height_m)
    elevation = np.empty((options.azimuths, *shape), np.float32)
    distance = np.empty_like(elevation)
    value, better = np.empty(shape, np.float32), np.empty(shape, bool)
    inverse = (1.0 / distance_m).astype(np.float32)
    fall = (apparent_drop_m(distance_m, options.refraction_coefficient) / distance_m).astype(np.float32)
    nearest_row, nearest_col = np.rint(row).astype(int), np.rint(col).astype(int)
    for index in range(options.azimuths):
        checkpoint(progress, index / options.azimuths)
        best, at = elevation[index], distance[index]
        best.fill(-np.inf)
        at.fill(np.nan)
        for step in range(len(distance_m)):
            if step < near:
                cells.between(row[index, step], col[index, step], value)
                np.subtract(value, eye, out=value)
            else:
                height = cells.at(block[step], nearest_row[index, step], nearest_col[index, step])
                np.subtract(height, eye, out=value)
            value *= inverse[step]
            value -= fall[step]
            np.greater(value, best, out=better)
            np.copyto(best, value, where=better)
            np.copyto(at, distance_m[step], where=better, casting="same_kind")
    places = grid.rows * grid.cols
    elevation[~np.isfinite(elevation)] = np.nan
    np.degrees(np.arctan(elevation, out=elevation), out=elevation)
    return ManyHorizons(
        np.ascontiguousarray(elevation.reshape(options.azimuths, places).T),
        np.ascontiguousarray(distance.reshape(options.azimuths, places).T),
        (eye - np.float32(eye_height_m)).ravel(),
    )


def _distances(cell_m, options):
    """Distances of the samples [m], and the width of the block that each of them stands for [cells]."""
    step_rad = 2 * np.pi / options.azimuths
    at, found, width = options.near_skip_cells * cell_m, [], []
    while at <= options.max_distance_m:
        block = max(size for size in BLOCKS if size == 1 or size * cell_m <= at * step_rad)
        found.append(at)
        width.append(block)
        at += cell_m * (0.5 if at < BILINEAR_CELLS * cell_m else block)
    return np.array(found or [options.near_skip_cells * cell_m]), np.array(width or [1])


class _Phases:
    """Elevations around a grid of places, one array for each phase of the grid and width of block.

    Each width reaches only as far as its samples: of a fine DEM, the widest block alone reaches the whole range.

    Parameters
    ----------
    terrain : Terrain
    grid : CellGrid
    reach : dict
        Width of block -> largest shift in rows or columns at which it is asked for [cells].
    """

    def __init__(self, terrain, grid, reach):
        self.grid = grid
        self._margin = {block: cells + block + 1 for block, cells in reach.items()}
        self._held = {block: self._phases(terrain, margin, block) for block, margin in self._margin.items()}
        self._other = np.empty((grid.rows, grid.cols), np.float32)

    def _phases(self, terrain, margin, block):
        """Highest cell of the block around each cell, (phases down, phases across, rows, cols); read in strips."""
        grid = self.grid
        down, across = grid.step_rows, grid.step_cols
        # The last phases are filled up, so that all of them have the same shape.
        rows = -(-((grid.rows - 1) * down + 1 + 2 * margin) // down)
        cols = -(-((grid.cols - 1) * across + 1 + 2 * margin) // across)
        held = np.empty((down, across, rows, cols), np.float32)
        strip = max(STRIP_CELLS // (cols * across * down), 1)
        for top in range(0, rows, strip):
            count = min(strip, rows - top)
            whole = Window(
                grid.row - margin + top * down - block,
                grid.col - margin - block,
                count * down + 2 * block,
                cols * across + 2 * block,
            )
            highest = _highest(_elevations(terrain, whole), block)[block:-block, block:-block]
            held[:, :, top : top + count] = highest.reshape(count, down, cols, across).transpose(1, 3, 0, 2)
        return held

    def at(self, block, row, col):
        """Elevations at a shift from every place, as a view (rows, cols).

        Parameters
        ----------
        block : int
            Width of the block whose highest cell is taken [cells].
        row, col : int
            Shift [cells].
        """
        row, down = divmod(row + self._margin[block], self.grid.step_rows)
        col, across = divmod(col + self._margin[block], self.grid.step_cols)
        return self._held[block][down, across, row : row + self.grid.rows, col : col + self.grid.cols]

    def between(self, row, col, out):
        """Write the bilinear elevations at a shift from every place.

        Parameters
        ----------
        row, col : float
            Shift [cells].
        out : (rows, cols) float32 array
        """
        first_row, first_col = int(np.floor(row)), int(np.floor(col))
        down, across = np.float32(row - first_row), np.float32(col - first_col)
        one = np.float32(1)
        weights = (
            ((0, 0), (one - down) * (one - across)),
            ((0, 1), (one - down) * across),
            ((1, 0), down * (one - across)),
            ((1, 1), down * across),
        )
        out.fill(0)
        for (below, right), weight in weights:
            if weight > 1e-4:
                np.multiply(self.at(1, first_row + below, first_col + right), weight, out=self._other)
                out += self._other


def _elevations(terrain, window):
    """Elevations of a window that may reach beyond the raster; NaN there."""
    elevation, inside = np.full((window.rows, window.cols), np.nan, np.float32), window.clipped(terrain.shape)
    if inside.rows and inside.cols:
        top, left = inside.row - window.row, inside.col - window.col
        elevation[top : top + inside.rows, left : left + inside.cols] = terrain.read(inside)
    return elevation


def _highest(elevation, block):
    """Highest of the block of cells around each cell; voids do not count."""
    if block == 1:
        return elevation
    filled = np.where(np.isnan(elevation), -np.inf, elevation)
    highest = ndimage.maximum_filter(filled, size=block, mode="nearest")
    highest[~np.isfinite(highest)] = np.nan
    return highest
