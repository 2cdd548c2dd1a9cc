"""Slabs: the lines of a quarter in the order in which the sweep processes them, read a few at a time."""

from __future__ import annotations

from dataclasses import dataclass
from threading import Lock

import numpy as np

from ..base.terrain import Terrain, Window
from .blocks import BAND, LOW

SLAB = 256
"""Number of lines read at once; slabs start at its multiples, as the tiles of usual files do."""

PIECE, GAP = 256, 16
"""Cells along the lines that are transposed together so that they stay in the processor's cache, and cells between the
rows of what is transposed."""


@dataclass(frozen=True, eq=False)
class SweptGround:
    """The ground that one sweep covers.

    Attributes
    ----------
    terrain : Terrain
    quarter : Quarter
    window : Window
        Part of the raster; nothing outside is read.
    k_max : float
        Distance of the quarter's last line [lines].
    """

    terrain: object
    quarter: object
    window: object
    k_max: float


class OneAtATime(Terrain):
    """A terrain that several threads read, one at a time."""

    def __init__(self, terrain):
        self.shape, self._terrain, self._lock = terrain.shape, terrain, Lock()

    def read(self, window):
        """See `Terrain.read`."""
        with self._lock:
            return self._terrain.read(window)

    def read_into(self, window, out):
        """See `Terrain.read_into`."""
        with self._lock:
            self._terrain.read_into(window, out)

    def frame(self, longitude_deg, latitude_deg, radius_m):
        """See `Terrain.frame`."""
        return self._terrain.frame(longitude_deg, latitude_deg, radius_m)


class Slabs:
    """Reads a quarter's lines.

    Parameters
    ----------
    ground : SweptGround
    u : (R,) array
        Rays, by their coordinate u.
    open_rays : (R,) bool array
        Rays that lie in the sector.
    """

    def __init__(self, ground, u, open_rays):
        self.terrain, self.quarter, self.window = ground.terrain, ground.quarter, ground.window
        self._ends = u[np.flatnonzero(open_rays)[[0, -1]]]
        self._memory, self._columns = np.empty(0, np.float32), np.empty(0, np.float32)

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

    def read_transient(self, lines):
        """Cells of a slab as (lines outwards, along) and the first column, or None if no open ray passes.

        Reading the next slab overwrites them.
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
            self.terrain.read_into(window, place)
        else:
            values = self._read_columns(window)
            for row in range(0, len(values), PIECE):
                place[:, row : row + PIECE] = values[row : row + PIECE].T
        # The outer half cells belong to the raster, and a cell on its edge is judged by a ray outside the edge too.
        if inner > start:
            cells[:, max(inner - start - 2, 0) : inner - start] = cells[:, inner - start, None]
        if end < stop:
            cells[:, end - start : end - start + 2] = cells[:, end - start - 1, None]
        return cells, start

    def _blank(self, rows, cols):
        """Reuse memory, as new memory costs more than the cells that are read into it."""
        if len(self._memory) < rows * cols:
            self._memory = np.empty(rows * cols, np.float32)
        return self._memory[: rows * cols].reshape(rows, cols)

    def _read_columns(self, window):
        """Read a window whose columns are the lines, with gaps between its rows.

        Rows that are a power of two apart compete for the same places of the processor's cache: without the gaps the
        transposition takes twice as long.
        """
        stride = window.cols + GAP
        if len(self._columns) < window.rows * stride:
            self._columns = np.empty(window.rows * stride, np.float32)
        values = self._columns[: window.rows * stride].reshape(window.rows, stride)[:, : window.cols]
        self.terrain.read_into(window, values)
        return values

    def _along_range(self, k):
        """Columns (rows) between which the open rays cross the lines `k`: whole pixels (low, high)."""
        w = self._ends + np.zeros((len(k), 1))
        if not self.quarter.plane:
            w = w + self.quarter.ray_bend.each(k[:, None], w)
        j = w * np.asarray(k)[:, None]
        return (
            int(np.floor(j.min() + self.quarter.origin_along)) - 2,
            int(np.ceil(j.max() + self.quarter.origin_along)) + 2,
        )

    def place(self, lines, start, width):
        """Find the position of a part of a slab on the raster.

        Parameters
        ----------
        lines : int array
            Lines of the slab.
        start, width : int
            First cell along the lines, and number of cells.

        Returns
        -------
        window : Window
            Part of the raster.
        inner : slice
            Part of the slab that lies inside the raster's window.
        """
        first, count = self.extent(not self.quarter.by_rows)
        inner, end = max(start, first), min(start + width, first + count)
        top = int(min(lines[0], lines[-1]))
        by_rows = self.quarter.by_rows
        window = Window(top, inner, len(lines), end - inner) if by_rows else Window(inner, top, end - inner, len(lines))
        return window, slice(inner - start, end - start)


def transposed(values):
    """Transpose lines into columns, in pieces that stay in the processor's cache."""
    turned = np.empty(values.shape[::-1], values.dtype)
    for first in range(0, len(turned), PIECE):
        turned[first : first + PIECE] = values[:, first : first + PIECE].T
    return turned
