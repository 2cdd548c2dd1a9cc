"""Highest elevation of each small block of cells, which lets the horizon search skip nearly all of the terrain.

The raster is read once, in strips, and only one number per `block` x `block` cells is kept, so that memory does not
depend on the size of the file.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.progress import SILENT, checkpoint
from ..base.terrain import Terrain, Window

STRIP_ROWS = 256
"""Strips start at multiples of this many rows, so that no tile of a usual file is decoded twice."""


@dataclass(frozen=True, eq=False)
class BlockMaxima:
    """Upper bounds of a window of the terrain.

    Attributes
    ----------
    window : Window
        Cells that were read; the first row and column are multiples of `block`.
    block : int
        Side of a block [cells].
    highest_m : (R, C) float32 array
        Highest known elevation of the block **and its eight neighbours** [m]; -inf where nothing is known. It
        bounds every interpolated sample within `block` cells of any point in the block.
    own_m : (R, C) float32 array
        Highest known elevation of the block alone [m]; -inf where nothing is known.
    has_void, all_void : (R, C) bool arrays
        Whether some cell of the block or its neighbours, or every cell of the block itself, is without data.
    summit_m : float
        Highest known elevation of the window [m]; -inf where nothing is known.
    """

    window: Window
    block: int
    highest_m: np.ndarray
    own_m: np.ndarray
    has_void: np.ndarray
    all_void: np.ndarray
    summit_m: float

    def index(self, col_px, row_px):
        """Block (row, column) of pixels of the whole raster, clamped to the window."""
        return tuple(self._held(self.scaled(place, axis), axis) for axis, place in enumerate((row_px, col_px)))

    def scaled(self, place_px, axis):
        """Rows (`axis` 0) or columns (1) of the whole raster, counted in blocks of the window."""
        start = self.window.col if axis else self.window.row
        return (np.asarray(place_px) + (0.5 - start)) * (1.0 / self.block)  # a power of two: exact

    def flat_index_in_place(self, block_row, block_col):
        """Positions in the flattened tables of rows and columns counted in blocks; overwrites both arrays."""
        row, col = (self._held(place, axis, place) for axis, place in enumerate((block_row, block_col)))
        row *= self.highest_m.shape[1]
        row += col
        return row

    def _held(self, place, axis, out=None):
        place = np.minimum(place, self.highest_m.shape[axis] - 1, out=out)
        return np.maximum(place, 0.0, out=out).astype(np.intp)

    def highest_around(self, col_px, row_px, half_px):
        """Bound the known elevations around positions [m].

        Parameters
        ----------
        col_px, row_px : array
            Positions in the whole raster [pixels].
        half_px : float
            Radius around each position, at most half a block [cells].
        """
        (top, left), (bottom, right) = (self.index(col_px + way, row_px + way) for way in (-half_px, half_px))
        cols, flat = self.own_m.shape[1], self.own_m.reshape(-1)
        corners = (flat.take(row * cols + col) for row in (top, bottom) for col in (left, right))
        return np.maximum.reduce(list(corners))


def aligned(window, block, shape):
    """Grow a window so that it starts at whole blocks.

    Parameters
    ----------
    window : Window
    block : int
        Side of a block [cells].
    shape : (rows, columns)
        Shape of the raster, to which the window is cut.
    """
    row, col = max(window.row, 0) // block * block, max(window.col, 0) // block * block
    return Window(row, col, window.row + window.rows - row, window.col + window.cols - col).clipped(shape)


def block_maxima(terrain, window, block, progress=SILENT, columns=None):
    """Read a window in strips and keep the maximum of every block.

    Parameters
    ----------
    terrain : Terrain
    window : Window
        Starts at whole blocks (see `aligned`) and lies inside the raster.
    block : int
        Side of a block, a power of two that divides `STRIP_ROWS` [cells].
    progress : Progress
    columns : callable or None
        (first row, last row) -> first and last column that matter there, or None for all columns. Blocks that lie
        wholly outside these columns are not read and count as unknown.

    Returns
    -------
    BlockMaxima
    """
    count = (-(-window.rows // block), -(-window.cols // block))
    highest = np.full(count, -np.inf, np.float32)
    has_void, all_void = np.zeros(count, bool), np.zeros(count, bool)
    row, stop = window.row, window.row + window.rows
    while row < stop:
        checkpoint(progress, (row - window.row) / window.rows)
        end = min(stop, (row // STRIP_ROWS + 1) * STRIP_ROWS)
        left, right = _block_columns(None if columns is None else columns(row, end - 1), window, block)
        if left < right:
            cols = min(right * block, window.cols) - left * block
            strip = terrain.read_transient(Window(row, window.col + left * block, end - row, cols))
            place = slice((row - window.row) // block, -(-(end - window.row) // block)), slice(left, right)
            maxima = _maxima_of(strip, block)
            unknown = np.isnan(maxima)
            if unknown.any():
                maxima = _maxima_of(np.where(np.isnan(strip), np.float32(-np.inf), strip), block)
                has_void[place], all_void[place] = unknown, np.isneginf(maxima)
            highest[place] = maxima
        row = end
    summit = float(highest.max()) if highest.size else -np.inf
    if has_void.any():
        has_void = _with_neighbours(has_void)
    return BlockMaxima(window, block, _with_neighbours(highest), highest, has_void, all_void, summit)


def _block_columns(columns, window, block):
    """First column of blocks that holds the given columns of cells, and the one after the last."""
    count = -(-window.cols // block)
    if columns is None:
        return 0, count
    first, last = ((column - window.col) // block for column in columns)
    return min(max(first, 0), count), min(max(last + 1, 0), count)


def _maxima_of(strip, block):
    """Maximum of each block of a strip; NaN if a block holds one."""
    rows, cols = strip.shape
    lines = np.empty((-(-rows // block), -(-cols // block) * block), np.float32)
    lines[:, cols:] = -np.inf
    for line, row in enumerate(range(0, rows, block)):
        np.max(strip[row : row + block], axis=0, out=lines[line, :cols])
    while block > 1:  # halving is several times faster than a reduction over a short axis
        lines = np.maximum(lines[:, ::2], lines[:, 1::2])
        block //= 2
    return lines


def _with_neighbours(values, radius=1):
    """Maximum of each element and its neighbours. (SciPy's filter is no faster, and importing it takes time.)"""
    for _ in range(2):
        highest = values.copy()
        for step in range(1, radius + 1):
            np.maximum(highest[step:], values[:-step], out=highest[step:])
            np.maximum(highest[:-step], values[step:], out=highest[:-step])
        values = highest.T
    return np.ascontiguousarray(values)


def highest_close_by(terrain, window, half_px):
    """Prepare the bound of `BlockMaxima.highest_around` to the nearest cell, in a window of few cells.

    Parameters
    ----------
    terrain : Terrain
    window : Window
        Window inside the raster.
    half_px : float
        Radius around each position [cells].

    Returns
    -------
    callable
        (column, row) of the whole raster [pixels] -> highest known elevation [m], -inf where nothing is known.
    """
    cells = terrain.read_transient(window)
    highest = _with_neighbours(np.where(np.isnan(cells), np.float32(-np.inf), cells), int(half_px + 0.5))

    def at(col_px, row_px):
        row = np.clip(np.rint(row_px).astype(np.intp) - window.row, 0, window.rows - 1)
        return highest[row, np.clip(np.rint(col_px).astype(np.intp) - window.col, 0, window.cols - 1)]

    return at


class HeldTerrain(Terrain):
    """A terrain that keeps the rows nearest one position in memory once they have been read.

    Parameters
    ----------
    terrain : Terrain
    window : Window
        All cells that will be read.
    middle_row : float
        Row around which rows are kept.
    memory_mb : float
        Most memory for the rows that are kept [MB].
    """

    def __init__(self, terrain, window, middle_row, memory_mb):
        self.shape, self._terrain = terrain.shape, terrain
        end = window.row + window.rows
        count = int(memory_mb * 1e6 / (4 * max(window.cols, 1)))
        self.whole = count >= window.rows
        first = window.row
        if not self.whole:  # whole strips, so that each strip is read from one place
            count = count // STRIP_ROWS * STRIP_ROWS
            first = max(int(middle_row - count / 2) // STRIP_ROWS * STRIP_ROWS, first)
            first = max(min(first, -(-end // STRIP_ROWS) * STRIP_ROWS - count), window.row)
        self._kept = Window(first, window.col, min(count, end - first), window.cols)
        self._cells = np.empty((self._kept.rows, self._kept.cols), np.float32)
        self._scratch = np.empty(0 if self.whole else STRIP_ROWS * window.cols, np.float32)
        # First known column of each row and the one after the last; none yet.
        self._first, self._last = np.full(self._kept.rows, self._kept.cols), np.zeros(self._kept.rows, int)

    def read(self, window):
        """See `Terrain.read`."""
        return self.read_transient(window).copy()

    def frame(self, longitude_deg, latitude_deg, radius_m):
        """See `Terrain.frame`."""
        return self._terrain.frame(longitude_deg, latitude_deg, radius_m)

    def read_transient(self, window):
        """See `Terrain.read_transient`: rows that are not kept go into memory that the next reading overwrites."""
        cells = self._kept_cells(window)
        if cells is None:
            size = window.rows * window.cols
            cells = np.empty(size, np.float32) if size > len(self._scratch) else self._scratch[:size]
            cells = cells.reshape(window.rows, window.cols)
            self._terrain.read_into(window, cells)
        return cells

    def read_into(self, window, out):
        """See `Terrain.read_into`."""
        cells = self._kept_cells(window)
        if cells is None:
            self._terrain.read_into(window, out)
        else:
            out[...] = cells

    def _kept_cells(self, window):
        """Cells of the window, read now if they are to be kept; None if they are not."""
        kept = self._kept
        row, col = window.row - kept.row, window.col - kept.col
        rows, cols = slice(row, row + window.rows), slice(col, col + window.cols)
        if row < 0 or col < 0 or rows.stop > kept.rows or cols.stop > kept.cols:
            return None
        if self._first[rows].max(initial=0) > cols.start or self._last[rows].min(initial=kept.cols) < cols.stop:
            if self._last[rows].any():  # so that known columns are not forgotten
                return None
            self._terrain.read_into(window, self._cells[rows, cols])
            self._first[rows], self._last[rows] = cols.start, cols.stop
        return self._cells[rows, cols]

    def held(self, row_px, col_px, margin_px):
        """Return the pixels around which all cells are in memory.

        Parameters
        ----------
        row_px, col_px : (N,) arrays
            Pixels of the whole raster.
        margin_px : int
            Radius, to which the interpolation's stencil is added [cells].
        """
        kept = self._kept
        if kept.rows == 0:
            return np.zeros(len(row_px), bool)
        (top, bottom), (left, right) = (
            (np.maximum(np.floor(place - margin_px) - 1, 0) - start, np.minimum(place + margin_px + 2, end - 1) - start)
            for place, start, end in ((row_px, kept.row, self.shape[0]), (col_px, kept.col, self.shape[1]))
        )
        known = (top >= 0) & (bottom < kept.rows)
        for step in range(0, 2 * margin_px + 5 + STRIP_ROWS, STRIP_ROWS):  # all rows of a strip have the same columns
            row = np.clip(np.minimum(top + step, bottom), 0, kept.rows - 1).astype(np.intp)
            known &= (self._first[row] <= left) & (self._last[row] > right)
        return known

    def kept(self):
        """The window that is kept, and its cells."""
        return self._kept, self._cells
