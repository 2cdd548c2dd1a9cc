"""Slabs: the lines of a quarter in the order in which the sweep meets them, read a few at a time."""

from __future__ import annotations

import numpy as np

from .terrain import Window, read_into
from .viewshed_blocks import BAND, LOW

SLAB = 256
"""Lines read at once; slabs start at its multiples, as the tiles of usual files do."""


class Slabs:
    """Reads a quarter's lines.

    Parameters
    ----------
    terrain : Terrain
    quarter : Quarter
    window : Window
        Of the raster; nothing outside is read.
    u : (R,) array
        Rays.
    open_rays : (R,) bool array
        Those in the sector.
    """

    def __init__(self, terrain, quarter, window, u, open_rays):
        self.terrain, self.quarter, self.window = terrain, quarter, window
        self._ends = u[np.flatnonzero(open_rays)[[0, -1]]]
        self._memory = np.empty(0, np.float32)

    def lines(self):
        """Lines of the quarter, outwards, in groups that start at multiples of `SLAB`."""
        first, count = self.extent(self.quarter.by_rows)
        sign, origin = self.quarter.sign, self.quarter.origin_line
        if sign > 0:
            start = max(int(np.floor(origin)) + 1, first)
            edges = [start, *range((start // SLAB + 1) * SLAB, first + count, SLAB), first + count]
            edges = [edge for edge in edges if edge <= first + count]
            pairs = zip(edges[:-1], edges[1:])
            return [np.arange(a, b) for a, b in pairs if b > a]
        start = min(int(np.ceil(origin)) - 1, first + count - 1)
        edges = [start + 1, *range((start // SLAB) * SLAB, first, -SLAB), first]
        return [np.arange(a - 1, b - 1, -1) for a, b in zip(edges[:-1], edges[1:]) if a > b]

    def extent(self, of_rows):
        """First index and number of the window's rows or columns."""
        window = self.window
        return (window.row, window.rows) if of_rows else (window.col, window.cols)

    def read(self, lines):
        """Cells of a slab as (lines outwards, along) and the first column, or None where no open ray passes.

        They hold until the next slab is read.
        """
        low, high = self._along_range(np.abs(lines[[0, -1]] - self.quarter.origin_line))
        first, count = self.extent(not self.quarter.by_rows)
        start = (max(low, first - 1) - 1) // BAND * BAND
        stop = -(-(min(high, first + count) + 2) // BAND) * BAND
        inner, end = max(start, first), min(stop, first + count)
        if inner >= end:
            return None
        top = int(min(lines[0], lines[-1]))
        by_rows = self.quarter.by_rows
        window = Window(top, inner, len(lines), end - inner) if by_rows else Window(inner, top, end - inner, len(lines))
        cells = self._blank(len(lines), stop - start)
        cells[:, : inner - start], cells[:, end - start :] = LOW, LOW
        place = cells[:: self.quarter.sign, inner - start : end - start]
        if by_rows:
            read_into(self.terrain, window, place)
        else:
            values = self.terrain.read(window)
            for row in range(0, len(values), 512):  # transposing piecewise keeps to the cache
                place[:, row : row + 512] = values[row : row + 512].T
        # The outer half cells belong to the raster, and a cell on its edge is judged by a ray beside the edge too.
        if inner > start:
            cells[:, max(inner - start - 2, 0) : inner - start] = cells[:, inner - start, None]
        if end < stop:
            cells[:, end - start : end - start + 2] = cells[:, end - start - 1, None]
        return cells, start

    def _blank(self, rows, cols):
        """Memory in use is taken again, as new memory costs more than the cells that come into it."""
        if len(self._memory) < rows * cols:
            self._memory = np.empty(rows * cols, np.float32)
        return self._memory[: rows * cols].reshape(rows, cols)

    def _along_range(self, k):
        """Columns (rows) between which the open rays cross the lines `k`: whole pixels (low, high)."""
        w = self._ends + np.zeros((len(k), 1))
        if not self.quarter.plane:
            w = w + self.quarter.ray_bend.at(k, self.quarter.ray_bend.place(self._ends))
        j = w * np.asarray(k)[:, None]
        return (
            int(np.floor(j.min() + self.quarter.origin_along)) - 2,
            int(np.ceil(j.max() + self.quarter.origin_along)) + 2,
        )

    def place(self, lines, start, width):
        """Window of the raster that a slab of `width` cells from `start` covers, and the slice of the slab in it."""
        first, count = self.extent(not self.quarter.by_rows)
        inner, end = max(start, first), min(start + width, first + count)
        top = int(min(lines[0], lines[-1]))
        by_rows = self.quarter.by_rows
        window = Window(top, inner, len(lines), end - inner) if by_rows else Window(inner, top, end - inner, len(lines))
        return window, slice(inner - start, end - start)
