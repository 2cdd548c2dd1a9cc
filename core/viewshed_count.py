"""How many photographs see each cell, gathered photo by photo in tiles, so that only ground in view takes memory."""

from __future__ import annotations

import numpy as np

from .viewshed_sweep import UNKNOWN, VISIBLE

TILE = 256


class SeenCount:
    """Counts on a DEM's grid.

    Parameters
    ----------
    shape : (rows, columns)
        Of the DEM.
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
        """Counts and doubt of whole rows.

        Returns
        -------
        seen : uint16 (rows, columns) array
        unknown : bool (rows, columns) array
            Nobody sees the cell for sure, and for one photo at least it is not known.
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
