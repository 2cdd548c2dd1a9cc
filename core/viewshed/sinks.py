"""Viewsheds of hundreds of millions of cells in memory, at two bits per cell, and counts over many viewsheds."""

from __future__ import annotations

import numpy as np

from ..base.viewed import UNKNOWN, VISIBLE, Sink


class PackedSink(Sink):
    """Collects the sweep's results in two bits per cell, and returns them piece by piece.

    It replaces the array of values if that array is only ever cut into pieces: ``values[rows, cols]`` with two slices
    is a uint8 array as in `Viewshed.values`.
    """

    CODES = np.array([0, VISIBLE, UNKNOWN, UNKNOWN], np.uint8)

    def __init__(self, window):
        self.window, self.shape = window, (window.rows, window.cols)
        self._first = window.col // 4 * 4
        self._cells = np.zeros((window.rows, -(-(window.col + window.cols - self._first) // 4)), np.uint8)

    @property
    def values(self):
        """The sink itself, which can be indexed like an array."""
        return self

    def add(self, window, values):
        """See `Sink.add`."""
        left = window.col // 4 * 4
        padded = np.zeros((window.rows, -(-(window.col + window.cols - left) // 4) * 4), np.uint8)
        padded[:, window.col - left : window.col - left + window.cols] = np.minimum(values, 2)
        codes = padded.reshape(window.rows, -1, 4)
        packed = codes[..., 0] | codes[..., 1] << 2 | codes[..., 2] << 4 | codes[..., 3] << 6
        row, col = window.row - self.window.row, (left - self._first) // 4
        self._cells[row : row + window.rows, col : col + packed.shape[1]] |= packed

    def set(self, row, col, value):
        """See `Sink.set`."""
        place = row - self.window.row, (col - self._first) // 4
        shift = 2 * ((col - self._first) % 4)
        self._cells[place] = (int(self._cells[place]) & ~(3 << shift)) | min(value, 2) << shift

    def __getitem__(self, place):
        """Values of (rows, columns), two slices without steps, counted from the window's first cell."""
        rows, cols = place if isinstance(place, tuple) else (place, slice(None))
        row, last_row, _ = rows.indices(self.shape[0])
        col, last_col, _ = cols.indices(self.shape[1])
        start = self.window.col - self._first + col
        end = start + max(last_col - col, 0)
        packed = self._cells[row : max(last_row, row), start // 4 : -(-end // 4)]
        codes = np.stack([packed >> shift & 3 for shift in (0, 2, 4, 6)], axis=-1)
        codes = codes.reshape(len(packed), 4 * packed.shape[1])
        return self.CODES[codes[:, start % 4 : start % 4 + end - start]]

    def read(self, window):
        """Values of a window of the raster that lies within the sink's window."""
        row, col = window.row - self.window.row, window.col - self.window.col
        return self[row : row + window.rows, col : col + window.cols]


TILE = 256


class SeenCount:
    """Counts, on a DEM's grid, of the photographs that see each cell.

    Parameters
    ----------
    shape : (rows, columns)
        Shape of the DEM.
    """

    def __init__(self, shape):
        self.shape, self.photos = tuple(shape), 0
        self._tiles = {}

    def add(self, window, values):
        """Add one photo's viewshed: uint8 values of a window, 1 seen, 0 not, 255 unknown."""
        self.photos += 1
        for top in range(window.row // TILE * TILE, window.row + window.rows, TILE):
            for left in range(window.col // TILE * TILE, window.col + window.cols, TILE):
                self._add_tile(top, left, window, values)

    def _add_tile(self, top, left, window, values):
        first_row, first_col = max(top, window.row), max(left, window.col)
        last_row = min(top + TILE, window.row + window.rows)
        last_col = min(left + TILE, window.col + window.cols)
        part = values[first_row - window.row : last_row - window.row, first_col - window.col : last_col - window.col]
        if not part.any():
            return
        if (top, left) not in self._tiles:
            self._tiles[top, left] = np.zeros((TILE, TILE), np.uint16), np.zeros((TILE, TILE), bool)
        seen, unknown = self._tiles[top, left]
        place = slice(first_row - top, last_row - top), slice(first_col - left, last_col - left)
        seen[place] += part == VISIBLE
        unknown[place] |= part == UNKNOWN

    def strip(self, row, rows):
        """Return the counts of whole rows, and which cells are in doubt.

        Returns
        -------
        seen : uint16 (rows, columns) array
        unknown : bool (rows, columns) array
            No photo certainly sees the cell, and for at least one photo it is not known.
        """
        cols = self.shape[1]
        seen, unknown = np.zeros((rows, cols), np.uint16), np.zeros((rows, cols), bool)
        for (top, left), (tile_seen, tile_unknown) in self._tiles.items():
            first, last = max(top, row), min(top + TILE, row + rows)
            if first >= last:
                continue
            width = min(TILE, cols - left)
            place = slice(first - row, last - row), slice(left, left + width)
            seen[place] = tile_seen[first - top : last - top, :width]
            unknown[place] = tile_unknown[first - top : last - top, :width]
        return seen, unknown & (seen == 0)
