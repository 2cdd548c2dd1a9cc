"""Viewsheds of photographs from one place: the ground is swept once, and each photograph takes its part."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.progress import SILENT, checkpoint, subtask
from ..base.viewed import ArraySink, Viewshed
from .sector import Sector
from .sinks import PackedSink
from .viewshed import FRAME_MARGIN, ViewshedOptions, mark_observer, sector_window, viewshed

PACKED_CELLS = 500_000_000
"""Viewsheds of more cells than this are held at two bits per cell."""

SHARED_CELLS = 100_000_000
"""Photos from one place are swept together in windows of up to this many cells, each of which then takes four bytes."""

CODE_BITS = 8
"""Bits of a cell's own value, 0, 1 or 255; the bits above it record the sectors in which the cell lies."""

MOST_SECTORS = 32 - CODE_BITS
"""Most sectors that are swept together; more sectors are divided among several sweeps."""


@dataclass(frozen=True, eq=False)
class AnyOf(Sector):
    """Everything that lies in at least one of several sectors."""

    sectors: tuple

    gives_marks = True
    includes_observer = False  # each sector decides this for itself

    @property
    def azimuth_range_deg(self):
        """First azimuth and width of a wedge that contains them all [degrees]; the full circle if they lie apart."""
        ranges = [sector.azimuth_range_deg for sector in self.sectors]
        first = ranges[0][0]
        low = min((start - first + 180) % 360 - 180 for start, _ in ranges)
        high = max((start - first + 180) % 360 - 180 + width for start, width in ranges)
        return (first + low, high - low) if high - low < 360 else (0.0, 360.0)

    def touches(self, azimuth_deg, margin_deg):
        """See `Sector.touches`."""
        return np.logical_or.reduce([sector.touches(azimuth_deg, margin_deg) for sector in self.sectors])

    def marks(self, azimuth_deg, elevation_deg, distance_m):
        """See `Sector.marks`; one bit per sector, above a cell's own value."""
        marks = np.zeros(np.shape(azimuth_deg), np.uint32)
        for number, sector in enumerate(self.sectors):
            inside = sector.accepts(azimuth_deg, elevation_deg, distance_m)
            marks |= inside.astype(np.uint32) << np.uint32(CODE_BITS + number)
        return marks


class _MarkedSink(ArraySink):
    """Values of the cells with the sectors' marks."""

    def __init__(self, window):
        super().__init__(window, np.uint32)


def station_viewsheds(terrain, observer, sectors, options=ViewshedOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Compute the viewsheds of several photographs from one place in one sweep.

    Parameters
    ----------
    terrain, observer, options, progress
        As for `viewshed`.
    sectors : sequence of Sector

    Yields
    ------
    Viewshed
        One per sector, in order, each complete before the next and identical to the result of `viewshed` for it alone.
    """
    sectors = tuple(sectors)
    for first in range(0, len(sectors), MOST_SECTORS):
        some = sectors[first : first + MOST_SECTORS]
        share = first / len(sectors), (first + len(some)) / len(sectors)
        yield from _together(terrain, observer, some, options, subtask(progress, *share))


def viewsheds_at(terrain, observer, sectors, options=ViewshedOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Compute the viewsheds of photographs from one place, from one sweep if its window is not too large.

    Parameters
    ----------
    terrain, observer, sectors, options, progress
        As for `station_viewsheds`.

    Yields
    ------
    Viewshed
        One per sector, in order, each complete before the next.
    """
    sectors = tuple(sectors)
    if len(sectors) > 1 and cells_at(terrain, observer, sectors, options) <= SHARED_CELLS:
        yield from station_viewsheds(terrain, observer, sectors, options, progress)
        return
    for index, sector in enumerate(sectors):
        part = subtask(progress, index / len(sectors), (index + 1) / len(sectors))
        yield viewshed(terrain, observer, sector, options, part, sink_for)


def cells_at(terrain, observer, sectors, options):
    """Number of cells of the window in which the sectors of a place lie.

    Parameters
    ----------
    terrain, observer, sectors, options
        As for `station_viewsheds`.
    """
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, FRAME_MARGIN * options.max_distance_m)
    window = sector_window(frame, terrain.shape, AnyOf(tuple(sectors)), options.max_distance_m)
    return window.rows * window.cols


def sink_for(window):
    """Return the object that holds the cells of a window: one byte each, or two bits if there are very many."""
    return (PackedSink if window.rows * window.cols > PACKED_CELLS else ArraySink)(window)


def _together(terrain, observer, sectors, options, progress):
    if len(sectors) == 1:
        yield viewshed(terrain, observer, sectors[0], options, progress)
        return
    whole = viewshed(terrain, observer, AnyOf(sectors), options, subtask(progress, 0.0, 0.9), _MarkedSink)
    for number, sector in enumerate(sectors):
        checkpoint(progress, 0.9 + 0.1 * number / len(sectors))
        window = sector_window(whole.frame, terrain.shape, sector, options.max_distance_m)
        sink = ArraySink(window)
        _take(whole, number, window, sink.values)
        mark_observer(sink, whole.frame, terrain.shape, sector, options)
        yield Viewshed(window, sink.values, whole.frame, whole.eye_elevation_m, options, sector)


def _take(whole, number, window, values):
    """Write the cells with one sector's mark into the values of its own window."""
    top, left = max(window.row, whole.window.row), max(window.col, whole.window.col)
    bottom = min(window.row + window.rows, whole.window.row + whole.window.rows)
    right = min(window.col + window.cols, whole.window.col + whole.window.cols)
    if top >= bottom or left >= right:
        return
    cells = whole.values[
        top - whole.window.row : bottom - whole.window.row, left - whole.window.col : right - whole.window.col
    ]
    mine = cells >> np.uint32(CODE_BITS + number) & np.uint32(1)
    values[top - window.row : bottom - window.row, left - window.col : right - window.col] = cells.astype(
        np.uint8
    ) * mine.astype(np.uint8)
