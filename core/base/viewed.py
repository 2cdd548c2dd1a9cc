"""The result of a viewshed, which engine, files, figures and shells exchange, and the sinks that collect it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .frame import LocalFrame
from .memory import zeros
from .terrain import Window

COUNTED_ROWS = 1024

VISIBLE, UNKNOWN = 1, 255
"""Values of a cell that is seen, and of a cell whose visibility is unknown; all other cells are 0."""


@dataclass(frozen=True, eq=False)
class Viewshed:
    """Visibility of the cells of a window.

    Attributes
    ----------
    window : Window
        Part of the raster that the values cover; no cell outside it is in the sector.
    values : (rows, cols) uint8 array, or an object that can be read like one
        1 seen; 0 not seen, or outside sector or range; 255 unknown (no data there, or between there and the eye).
        If the caller gave a sink, its values.
    frame : LocalFrame
        Frame that gives the true directions and distances of the cells.
    eye_elevation_m : float
        Absolute elevation of the eye [m].
    options : core.viewshed.viewshed.ViewshedOptions
    sector : core.viewshed.sector.Sector
    """

    window: Window
    values: Any
    frame: LocalFrame
    eye_elevation_m: float
    options: Any
    sector: Any

    @property
    def visible(self) -> np.ndarray:
        """Cells that are certainly seen, (rows, cols) bool."""
        return self.values == VISIBLE

    @property
    def seen_cells(self) -> int | None:
        """Number of cells that are certainly seen; None if a sink keeps the values elsewhere."""
        if self.values is None:
            return None
        strips = range(0, self.window.rows, COUNTED_ROWS)
        return sum(int(np.count_nonzero(self.values[row : row + COUNTED_ROWS, :] == VISIBLE)) for row in strips)

    def __repr__(self) -> str:
        seen, cells = self.seen_cells, f"{self.window.rows} x {self.window.cols} cells"
        area_km2 = None if seen is None else seen * self.frame.cell_m**2 / 1e6
        facts = "values held elsewhere" if seen is None else f"{seen} seen, about {area_km2:.3g} km²"
        reach = f"range {self.options.max_distance_m / 1000:g} km, eye at {self.eye_elevation_m:.0f} m"
        return f"<Viewshed: {cells}, {facts}, {reach}>"


class Sink:
    """Receiver of the results of a sweep; other kinds, such as a file, derive from this class.

    Every cell is given once, so that adding is the same as writing. Calls may come from several threads, but never two
    at a time.

    Attributes
    ----------
    dtype : numpy.dtype
        Type of the values: uint8 for `VISIBLE` and `UNKNOWN`, uint32 with the marks of several sectors, a float
        type for heights above the line of sight.
    wants_clearance : bool
        Whether the sink takes heights above the line of sight instead of seen or not seen.
    values : (rows, cols) array, or an object that can be read like one, or None
        The results, if they are in memory.
    """

    dtype = np.dtype(np.uint8)
    wants_clearance = False
    values: Any = None

    def add(self, window: Window, values: np.ndarray) -> None:
        """Add values of a window of the raster."""
        raise NotImplementedError

    def set(self, row: int, col: int, value: int) -> None:
        """Set one cell of the raster.

        Parameters
        ----------
        row, col : int
            Indices in the whole raster.
        value : int
            New value of the cell.
        """
        raise NotImplementedError


class ArraySink(Sink):
    """Sink that collects the results in memory.

    Parameters
    ----------
    window : Window
        Part of the raster to collect.
    dtype : numpy.dtype
        Type of the values; a float type collects heights above the line of sight.
    """

    def __init__(self, window: Window, dtype: Any = np.uint8) -> None:
        self.window, self.dtype = window, np.dtype(dtype)
        self.wants_clearance = self.dtype.kind == "f"
        self.values = zeros((window.rows, window.cols), self.dtype)

    def add(self, window: Window, values: np.ndarray) -> None:
        """See `Sink.add`."""
        row, col = window.row - self.window.row, window.col - self.window.col
        place = self.values[row : row + window.rows, col : col + window.cols]
        np.add(place, values, out=place)

    def set(self, row: int, col: int, value: int) -> None:
        """See `Sink.set`.

        Parameters
        ----------
        row, col : int
            Indices in the whole raster.
        value : int
            New value of the cell.
        """
        self.values[row - self.window.row, col - self.window.col] = value
