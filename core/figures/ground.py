"""The part of a DEM on which a result is drawn: around camera and ground in view, reduced to a figure's size.

The DEM is read in strips, so that a window of a gigapixel raster costs no more memory than a small one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.terrain import Window
from ..base.viewed import UNKNOWN
from .map import MapData, map_image
from .raster import TypeStyle, draw_words, resized
from .text import azimuth

MOST_CELLS = 600
"""Cells along the longer side of a map; a panel has about as many pixels."""

MARGIN = 0.06
"""Margin around the content, as a share of the longer side."""

LONGEST = 1.5
"""Largest ratio of a map's sides: three panels must fit side by side."""

SMALLEST_M = 500.0
"""A map reaches at least this far in each direction, even if nothing is seen [m]."""

STRIP_CELLS = 4_000_000


@dataclass(frozen=True, eq=False)
class SeenGround:
    """The cells of a raster that are seen.

    Attributes
    ----------
    window : Window
        Part of the raster that the values cover.
    values : (rows, cols) array, or an object that returns one for two slices
        0 for not seen; otherwise seen, or the number of photographs that see the cell.
    unknown : int
        Value of unknown cells, which count as not seen.
    """

    window: Window
    values: np.ndarray
    unknown: int = UNKNOWN

    def part(self, window):
        """Values of a window of the raster, 0 outside the area covered here."""
        out = np.zeros((window.rows, window.cols), self.values.dtype)
        first_row, first_col = max(window.row, self.window.row), max(window.col, self.window.col)
        last_row = min(window.row + window.rows, self.window.row + self.window.rows)
        last_col = min(window.col + window.cols, self.window.col + self.window.cols)
        if first_row < last_row and first_col < last_col:
            rows = slice(first_row - self.window.row, last_row - self.window.row)
            part = self.values[rows, first_col - self.window.col : last_col - self.window.col]
            place = slice(first_row - window.row, last_row - window.row)
            out[place, first_col - window.col : last_col - window.col] = np.where(part == self.unknown, 0, part)
        return out

    def extent(self):
        """(first row, last row, first column, last column) of seen cells on the raster, or None."""
        rows, columns = [], np.zeros(self.window.cols, bool)
        for start, strip in _strips(self.window):
            seen = self.part(strip) > 0
            rows += list(start + np.flatnonzero(seen.any(axis=1)))
            columns |= seen.any(axis=0)
        if not rows:
            return None
        found = np.flatnonzero(columns) + self.window.col
        return int(rows[0]), int(rows[-1]), int(found[0]), int(found[-1])


@dataclass(frozen=True)
class GroundMapOptions:
    """What a map must show, and its resolution.

    Attributes
    ----------
    shown : int
        Number of observers, from the first on, that must lie on the map.
    most_cells : int
        Number of cells along the longer side of the result.
    """

    shown: int = 1
    most_cells: int = MOST_CELLS


def ground_map(terrain, frame, seen, observers=(), track_px=None, options=GroundMapOptions()):  # noqa: B008 - frozen
    """Cut out the map around the ground that is seen.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
        Gives the ground size of cells and the direction of grid north.
    seen : SeenGround
    observers : sequence of MapObserver
        Positions on the raster [pixels]; those outside the map are left out.
    track_px : (N, 2) array or None
        (column, row) of a route on the raster; NaN breaks it.
    options : GroundMapOptions

    Returns
    -------
    MapData
        Its sides differ by at most `LONGEST` if the raster is large enough; row 0 is at the top.
    """
    observers, shown = tuple(observers), options.shown
    window = _surroundings(seen.extent(), observers[:shown], frame, terrain.shape)
    step = max(1, -(-max(window.rows, window.cols) // options.most_cells))
    elevation, visible = _reduced(terrain, seen, window, step)
    kept, placed = set(), []
    for index, observer in enumerate(observers):
        col, row = (observer.col_px - window.col + 0.5) / step - 0.5, (observer.row_px - window.row + 0.5) / step - 0.5
        pixel = round(col), round(row)
        inside = 0 <= pixel[0] < elevation.shape[1] and 0 <= pixel[1] < elevation.shape[0]
        if index < shown or (inside and pixel not in kept):  # a thousand photos of one place are one dot
            placed.append(replace(observer, col_px=col, row_px=row))
            kept.add(pixel)
    track = None if track_px is None else _near_track(track_px, window, step)
    if not frame.row_goes_south:
        elevation, visible = elevation[::-1], visible[::-1]
        placed = [replace(observer, row_px=len(elevation) - 1 - observer.row_px) for observer in placed]
        track = None if track is None else np.column_stack([track[:, 0], len(elevation) - 1 - track[:, 1]])
    cell_m = tuple(side * step for side in frame.cell_size_m)
    return MapData(elevation, cell_m, frame.convergence_deg, visible, tuple(placed), track)


def _surroundings(extent, observers, frame, shape):
    """Window with a margin around seen cells and observers, with bounded proportions if the raster is large enough."""
    rows, cols = [observer.row_px for observer in observers], [observer.col_px for observer in observers]
    if extent is not None:
        rows, cols = [*rows, *extent[:2]], [*cols, *extent[2:]]
    if not rows:
        return Window(0, 0, *shape)
    cell_x_m, cell_y_m = frame.cell_size_m
    half_x_m = (max(cols) - min(cols)) * cell_x_m * (0.5 + MARGIN)
    half_y_m = (max(rows) - min(rows)) * cell_y_m * (0.5 + MARGIN)
    half_x_m, half_y_m = max(half_x_m, half_y_m / LONGEST, SMALLEST_M), max(half_y_m, half_x_m / LONGEST, SMALLEST_M)
    row, height = _span((max(rows) + min(rows)) / 2, half_y_m / cell_y_m, shape[0])
    col, width = _span((max(cols) + min(cols)) / 2, half_x_m / cell_x_m, shape[1])
    return Window(row, col, height, width)


def _span(middle, half, size):
    """First cell and count of a span around `middle`, moved rather than cut if it would leave the raster."""
    count = min(2 * int(np.ceil(half)) + 1, size)
    return int(np.clip(round(middle) - count // 2, 0, size - count)), count


def _reduced(terrain, seen, window, step):
    """Mean of the known elevations of blocks of cells, and their counts if at least half of the cells are seen."""
    elevations, counts = [], []
    for _, strip in _strips(window, step):
        heights, values = _blocks(terrain.read(strip), step, np.nan), _blocks(seen.part(strip), step, 0)
        known = np.isfinite(heights)
        total = np.where(known, heights, 0).sum(axis=(1, 3), dtype=np.float64)
        with np.errstate(invalid="ignore"):
            elevations.append((total / known.sum(axis=(1, 3))).astype(np.float32))
        mostly = (values > 0).mean(axis=(1, 3)) >= 0.5
        counts.append(np.where(mostly, values.max(axis=(1, 3)), 0))
    return np.vstack(elevations), np.vstack(counts)


def _strips(window, step=1):
    """Yield (first row, Window) of strips of whole blocks from top to bottom."""
    height = max(STRIP_CELLS // max(window.cols * step, 1), 1) * step
    for row in range(window.row, window.row + window.rows, height):
        yield row, Window(row, window.col, min(height, window.row + window.rows - row), window.cols)


def _blocks(values, step, fill):
    """(rows, step, cols, step) blocks, the last ones padded."""
    rows, cols = (-(-side // step) for side in values.shape)
    whole = np.full((rows * step, cols * step), fill, values.dtype)
    whole[: values.shape[0], : values.shape[1]] = values
    return whole.reshape(rows, step, cols, step)


def _near_track(track_px, window, step):
    """Convert the track to the map's pixels: stretches that come near the map, without coincident points."""
    points = (np.asarray(track_px, float) - [window.col, window.row] + 0.5) / step - 0.5
    size = np.array([window.cols, window.rows]) / step
    points[~np.all((points > -size) & (points < 2 * size), axis=1)] = np.nan
    if len(points) > 1:
        still = np.all(np.rint(points[1:]) == np.rint(points[:-1]), axis=1)
        gap = np.isnan(points[1:, 0]) & np.isnan(points[:-1, 0])
        points = points[np.r_[True, ~(still | gap)]]
    return points if np.isfinite(points).all(axis=1).sum() > 1 else None


GAP_PX = 10
PAPER = (255, 255, 255)


def three_panels(photo, data, height_px=560, captions=True, say=str):
    """Draw photograph, wedge on the grey elevation model, and viewshed on shaded relief side by side.

    Parameters
    ----------
    photo : uint8 (h, w, 3) array or None
        The upright picture, or its overlay; without it there are two panels.
    data : MapData
        Map with the observer first, its heading and field of view, the viewshed as `seen`, and the track if there is
        one.
    height_px : int
        Height of the figure [pixels].
    captions : bool
        Write a letter and a word into each panel.
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    uint8 (height_px, w, 3) array
    """
    east_m, south_m = data.size_m
    map_px = round(height_px * east_m / south_m)
    plain = replace(data, seen=None, track_px=None, observers=data.observers[:1])
    heading = data.observers[0].heading_deg if data.observers else None
    wedge_words = say("view") if heading is None else f"{say('heading')} {azimuth(heading)}"
    panels = [
        (map_image(plain, map_px, "grey", wedge_reach_m=2 * max(east_m, south_m)), wedge_words),
        (map_image(data, map_px, "hillshade", wedges=False), say("viewshed")),
    ]
    if photo is not None:
        photo = np.asarray(photo)[..., :3]
        width_px = round(height_px * photo.shape[1] / photo.shape[0])
        panels.insert(0, (resized(photo, width_px, height_px).copy(), say("photograph")))
    gap = np.full((height_px, GAP_PX, 3), PAPER, np.uint8)
    drawn = []
    for letter, (pixels, words) in zip("abc", panels):
        if captions:
            style = TypeStyle(height_px / 26, "la", bold=True)
            draw_words(pixels, 14, 12, f"{letter}  {words}", (255, 255, 255), style)
        drawn += [gap, resized(pixels, pixels.shape[1], height_px)]
    return np.hstack(drawn[1:])
