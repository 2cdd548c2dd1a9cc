"""Photographs from one place: the ground is swept once, and each photograph takes its part."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curvature import apparent_drop_m
from .progress import SILENT, checkpoint, subtask
from .terrain import Window
from .viewshed import Viewshed, ViewshedOptions, sector_window, viewshed

TILE_ROWS = 256


@dataclass(frozen=True, eq=False)
class AnyOf:
    """Everything that lies in at least one of several sectors."""

    sectors: tuple

    selective, azimuth_only = True, False

    @property
    def includes_observer(self):
        """Whether any of them counts the observer's own cell."""
        return any(sector.includes_observer for sector in self.sectors)

    @property
    def azimuth_range_deg(self):
        """First azimuth and width of a wedge that holds them all [degrees]; the circle where they lie apart."""
        ranges = [sector.azimuth_range_deg for sector in self.sectors]
        first = ranges[0][0]
        low = min((start - first + 180) % 360 - 180 for start, _ in ranges)
        high = max((start - first + 180) % 360 - 180 + width for start, width in ranges)
        return (first + low, high - low) if high - low < 360 else (0.0, 360.0)

    def touches(self, azimuth_deg, margin_deg):
        """See `FullCircle.touches`."""
        return np.logical_or.reduce([sector.touches(azimuth_deg, margin_deg) for sector in self.sectors])

    def accepts(self, azimuth_deg, elevation_deg, distance_m):
        """See `FullCircle.accepts`."""
        return np.logical_or.reduce([sector.accepts(azimuth_deg, elevation_deg, distance_m) for sector in self.sectors])


def station_viewsheds(terrain, observer, sectors, options=ViewshedOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Viewsheds of several photographs from one place, by one sweep.

    Parameters
    ----------
    terrain, observer, options, progress
        As for `viewshed`.
    sectors : sequence of FullCircle, Wedge or PhotoFrame

    Yields
    ------
    Viewshed
        One per sector, in order, each whole before the next; the same as `viewshed` gives for it alone, but for
        cells that lie on a sector's edge to the last digit.
    """
    together = viewshed(terrain, observer, AnyOf(tuple(sectors)), options, subtask(progress, 0.0, 0.7))
    for done, sector in enumerate(sectors):
        checkpoint(progress, 0.7 + 0.3 * done / len(sectors))
        window = sector_window(together.frame, terrain.shape, sector, options.max_distance_m)
        values = _cut(together, window)
        _select(terrain, together, window, values, sector)
        yield Viewshed(window, values, together.frame, together.eye_elevation_m, options, sector)


def _cut(whole, window):
    """Values of a part of a viewshed's window; what lies outside is 0."""
    values = np.zeros((window.rows, window.cols), np.uint8)
    top, left = max(window.row, whole.window.row), max(window.col, whole.window.col)
    bottom = min(window.row + window.rows, whole.window.row + whole.window.rows)
    right = min(window.col + window.cols, whole.window.col + whole.window.cols)
    if top < bottom and left < right:
        values[top - window.row : bottom - window.row, left - window.col : right - window.col] = whole.values[
            top - whole.window.row : bottom - whole.window.row, left - whole.window.col : right - whole.window.col
        ]
    return values


def _select(terrain, whole, window, values, sector):
    """Strike out, in place, the cells that a sector does not accept."""
    frame, options = whole.frame, whole.options
    own = round(frame.row_px) - window.row, round(frame.col_px) - window.col
    for first in range(0, window.rows, TILE_ROWS):
        strip = values[first : first + TILE_ROWS]
        row, col = np.nonzero(strip)
        if not len(row):
            continue
        piece = terrain.read(Window(window.row + first, window.col, len(strip), window.cols))[row, col]
        east, north = frame.to_local(col + window.col, row + window.row + first)
        distance = np.maximum(np.hypot(east, north), 1e-6)
        drop = apparent_drop_m(distance, options.refraction_coefficient) if options.curvature else 0.0
        rise = piece + options.target_height_m - whole.eye_elevation_m - drop
        accepted = sector.accepts(np.degrees(np.arctan2(east, north)), np.degrees(np.arctan(rise / distance)), distance)
        if sector.includes_observer:
            accepted |= (row + first == own[0]) & (col == own[1])
        strip[row[~accepted], col[~accepted]] = 0
