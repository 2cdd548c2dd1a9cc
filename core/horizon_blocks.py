"""Highest elevation of each small block of cells: what lets the horizon search skip nearly all of the terrain.

The raster is read once, in strips, and only one number in `block` x `block` cells is kept, so that memory does not
depend on the size of the file.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .progress import SILENT, checkpoint
from .terrain import Window

STRIP_ROWS = 256
"""Strips start at multiples of this many rows, so that no tile of a usual file is decoded twice."""


@dataclass(frozen=True, eq=False)
class BlockMaxima:
    """Upper bounds of a window of the terrain.

    Attributes
    ----------
    window : Window
        What was read; its first row and column are multiples of `block`.
    block : int
        Side of a block [cells].
    highest_m : (R, C) float32 array
        Highest known elevation of the block **and its eight neighbours** [m]; -inf where nothing is known. It
        bounds every interpolated sample within `block` cells of any point in the block.
    own_m : (R, C) float32 array
        The same of the block alone.
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
        """Block (row, column) under pixels of the whole raster, held inside the window."""
        places = []
        for place, start, count in zip((row_px, col_px), (self.window.row, self.window.col), self.highest_m.shape):
            index = (np.asarray(place) + (0.5 - start)) * (1.0 / self.block)  # a power of two: exact
            places.append(np.minimum(np.maximum(index, 0.0), count - 1).astype(np.intp))
        return tuple(places)

    def highest_around(self, col_px, row_px, half_px):
        """Highest known elevation within so many cells, at most half a block, of pixels of the whole raster [m]."""
        (top, left), (bottom, right) = (self.index(col_px + way, row_px + way) for way in (-half_px, half_px))
        cols, flat = self.own_m.shape[1], self.own_m.reshape(-1)
        corners = (flat.take(row * cols + col) for row in (top, bottom) for col in (left, right))
        return np.maximum.reduce(list(corners))


def aligned(window, block, shape):
    """Grow a window so that it starts at whole blocks; cut to a raster of `shape`."""
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
        (first row, last row) -> first and last column that matter there, or None for all. Blocks that lie wholly
        beside them are not read: nothing is known of them.

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
            strip = terrain.read(Window(row, window.col + left * block, end - row, cols))
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
    """First and last but one column of blocks that hold the given columns of cells."""
    count = -(-window.cols // block)
    if columns is None:
        return 0, count
    first, last = ((column - window.col) // block for column in columns)
    return min(max(first, 0), count), min(max(last + 1, 0), count)


def _maxima_of(strip, block):
    """Maximum of each block of a strip; NaN wherever a block holds one."""
    rows, cols = strip.shape
    lines = np.empty((-(-rows // block), -(-cols // block) * block), np.float32)
    lines[:, cols:] = -np.inf
    for line, row in enumerate(range(0, rows, block)):
        np.max(strip[row : row + block], axis=0, out=lines[line, :cols])
    while block > 1:  # halving is several times faster than a reduction over a short axis
        lines = np.maximum(lines[:, ::2], lines[:, 1::2])
        block //= 2
    return lines


def _with_neighbours(values):
    """Maximum of each element and its eight neighbours. (SciPy's filter is no faster, and costs its import.)"""
    for _ in range(2):
        highest = values.copy()
        np.maximum(highest[1:], values[:-1], out=highest[1:])
        np.maximum(highest[:-1], values[1:], out=highest[:-1])
        values = highest.T
    return np.ascontiguousarray(values)


class HeldTerrain:
    """A terrain of which the rows nearest one place stay in memory once they are read.

    Parameters
    ----------
    terrain : Terrain
    window : Window
        All that will be read.
    middle_row : float
        The rows around it are kept.
    memory_mb : float
        So much may be kept [MB].
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
        # Columns known of each row, from the first up to the last but one; none yet.
        self._first, self._last = np.full(self._kept.rows, self._kept.cols), np.zeros(self._kept.rows, int)

    def read(self, window):
        """See `Terrain.read`; holds until the next reading, and is not to be written to."""
        kept = self._kept
        row, col = window.row - kept.row, window.col - kept.col
        rows, cols = slice(row, row + window.rows), slice(col, col + window.cols)
        if row < 0 or col < 0 or rows.stop > kept.rows or cols.stop > kept.cols:
            return self._read_once(window)
        if self._first[rows].max(initial=0) > cols.start or self._last[rows].min(initial=kept.cols) < cols.stop:
            self._read_into(window, self._cells[rows, cols])
            self._first[rows], self._last[rows] = cols.start, cols.stop
        return self._cells[rows, cols]

    def _read_once(self, window):
        size = window.rows * window.cols
        if size > len(self._scratch):
            return self._terrain.read(window)
        cells = self._scratch[:size].reshape(window.rows, window.cols)
        self._read_into(window, cells)
        return cells

    def _read_into(self, window, out):
        """New memory costs more than the cells that come into it, so it is used again where the terrain lets us."""
        if hasattr(self._terrain, "read_into"):
            self._terrain.read_into(window, out)
        else:
            out[...] = self._terrain.read(window)
