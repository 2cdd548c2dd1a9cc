"""The ground that an observer, or a photograph, sees: every cell of the DEM in range, judged once.

The answer lies on the DEM's own grid. Distances and directions are true ones on the ellipsoid whatever the CRS.
See `viewshed_sweep` for the method and `docs/performance.md` for what else was tried.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.errors import ObserverOutsideDemError
from ..base.progress import SILENT, subtask
from ..base.terrain import Window, eye_elevation_m
from .geometry import quarters
from .sector import FullCircle, PhotoFrame, Wedge
from .sinks import PackedSink
from .sweep import UNKNOWN, VISIBLE, QuarterSweep, SweepOptions

__all__ = [
    "UNKNOWN",
    "VISIBLE",
    "FullCircle",
    "PackedSink",
    "PhotoFrame",
    "Viewshed",
    "ViewshedOptions",
    "Wedge",
    "viewshed",
]

KEPT_BYTES = 30 * 2**20
"""Memory of arrays up to this size is used again. Linux's allocator gives that of large arrays back to the system until
it has seen an even larger one freed, and fetching it anew, page by page, takes as long as a tenth of a sweep."""

FRAME_MARGIN = 1.6
"""The frame reaches this much farther than the range, as the quarters' corners do."""


@dataclass(frozen=True)
class ViewshedOptions:
    """How to compute a viewshed.

    Attributes
    ----------
    target_height_m : float
        Height above ground of what is looked at [m]; 0 asks for the ground itself.
    min_distance_m, max_distance_m : float
        Range of distances that count [m]. Ground nearer than the minimum still obstructs.
    refraction_coefficient : float
        k of `apparent_drop_m`.
    curvature : bool
        Account for the earth's curvature and refraction.
    near_skip_cells : float
        Ground nearer than this does not obstruct [cells]: the DEM does not know it well enough.
    rays_per_cell : float
        Rays per cell at the far end; 2 is slower and a little more exact.
    voids_block : bool
        True: cells in view but behind cells without data are unknown (255). False: voids are taken for open air.
    """

    target_height_m: float = 0.0
    min_distance_m: float = 0.0
    max_distance_m: float = 30_000.0
    refraction_coefficient: float = REFRACTION_COEFFICIENT
    curvature: bool = True
    near_skip_cells: float = 1.0
    rays_per_cell: float = 1.0
    voids_block: bool = True

    def __post_init__(self):
        if not 0 <= self.min_distance_m < self.max_distance_m:
            raise ValueError("distances need 0 <= min_distance_m < max_distance_m")
        if not self.target_height_m >= 0:
            raise ValueError(f"the target height must not be negative, is {self.target_height_m}")
        if not 0 <= self.refraction_coefficient < 1:
            raise ValueError(f"the refraction coefficient must lie in [0, 1), not {self.refraction_coefficient}")
        if not 0.25 <= self.rays_per_cell <= 8:
            raise ValueError(f"rays_per_cell must lie in 0.25 to 8, not {self.rays_per_cell}")


@dataclass(frozen=True, eq=False)
class Viewshed:
    """Which cells are seen.

    Attributes
    ----------
    window : Window
        Part of the raster that the values cover; outside it nothing is in the sector.
    values : (rows, cols) uint8 array, PackedSink or None
        1 seen; 0 not seen or outside sector and range; 255 unknown (no data there, or between there and the eye).
        What the caller's sink holds, where there is one.
    frame : LocalFrame
        True directions and distances of the cells.
    eye_elevation_m : float
    options : ViewshedOptions
    sector : FullCircle, Wedge or PhotoFrame
    """

    window: Window
    values: np.ndarray | None
    frame: object
    eye_elevation_m: float
    options: ViewshedOptions
    sector: object

    @property
    def visible(self):
        """(rows, cols) bool: cells that are certainly seen."""
        return self.values == VISIBLE


class ArraySink:
    """Collects the sweep's results in memory.

    Every cell is given once, so that adding is writing; a sink of one's own (a file) needs these members.
    """

    def __init__(self, window, dtype=np.uint8):
        self.window, self.dtype = window, np.dtype(dtype)
        self.wants_clearance = self.dtype.kind == "f"
        self.values = np.zeros((window.rows, window.cols), self.dtype)

    def add(self, window, values):
        """Add values of a window of the raster."""
        row, col = window.row - self.window.row, window.col - self.window.col
        place = self.values[row : row + window.rows, col : col + window.cols]
        np.add(place, values, out=place)

    def set(self, row, col, value):
        """Set one cell of the raster."""
        self.values[row - self.window.row, col - self.window.col] = value


def viewshed(terrain, observer, sector=FullCircle(), options=ViewshedOptions(), progress=SILENT, sink=None):  # noqa: B008 - frozen values
    """Find the ground that is seen from one place.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    sector : FullCircle, Wedge or PhotoFrame
    options : ViewshedOptions
    progress : Progress
    sink : object or callable or None
        Takes the results instead of memory (see `ArraySink`); a callable is called with the window to make one.

    Returns
    -------
    Viewshed

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError, UnusableDemError
    """
    np.empty(KEPT_BYTES, np.uint8)  # freed at once
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, FRAME_MARGIN * options.max_distance_m)
    rows, cols = terrain.shape
    if not (-0.5 <= frame.row_px <= rows - 0.5 and -0.5 <= frame.col_px <= cols - 0.5):
        raise ObserverOutsideDemError(observer.longitude_deg, observer.latitude_deg)
    eye_m = eye_elevation_m(terrain, frame, observer)
    window = sector_window(frame, terrain.shape, sector, options.max_distance_m)
    sink = ArraySink(window) if sink is None else sink(window) if callable(sink) else sink
    drop = float(apparent_drop_m(1.0, options.refraction_coefficient)) if options.curvature else 0.0
    sweep_options = SweepOptions(
        eye_m,
        drop,
        options.target_height_m,
        options.min_distance_m,
        options.max_distance_m,
        options.near_skip_cells,
        options.rays_per_cell,
        options.voids_block,
    )
    # Laid out for the whole circle whatever the sector: rays, and so results, are then the same in all of them.
    k_max = _farthest_lines(frame, sector_window(frame, terrain.shape, FullCircle(), options.max_distance_m))
    views = quarters(frame, k_max, sector.touches)
    for done, quarter in enumerate(views):
        sweep = QuarterSweep(
            terrain, quarter, window, k_max[quarter.by_rows, quarter.sign], sector, sweep_options, sink
        )
        sweep.run(subtask(progress, done / len(views), (done + 1) / len(views)))
    mark_observer(sink, frame, terrain.shape, sector, options)
    return Viewshed(window, getattr(sink, "values", None), frame, eye_m, options, sector)


def sector_window(frame, shape, sector, max_distance_m):
    """Rectangle of the raster that holds the sector out to a distance, cut to `shape` (rows, cols)."""
    start, width = sector.azimuth_range_deg
    azimuth = np.radians(start + np.linspace(0.0, width, 721))
    col, row = frame.to_pixel(max_distance_m * np.sin(azimuth), max_distance_m * np.cos(azimuth))
    col, row = np.append(col, frame.col_px), np.append(row, frame.row_px)
    top, left = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    bottom, right = int(np.ceil(row.max())) + 2, int(np.ceil(col.max())) + 2
    return Window(top, left, bottom - top, right - left).clipped(shape)


def _farthest_lines(frame, window):
    """Distance from the observer to the window's outer lines, per quarter [lines]."""
    return {
        (True, -1): frame.row_px - window.row,
        (True, 1): window.row + window.rows - 1 - frame.row_px,
        (False, -1): frame.col_px - window.col,
        (False, 1): window.col + window.cols - 1 - frame.col_px,
    }


def mark_observer(sink, frame, shape, sector, options):
    """The observer's own point belongs to no quarter where it lies on a cell's centre; one sees one's own cell."""
    if sink.wants_clearance or not sector.includes_observer or options.min_distance_m > 0:
        return
    rows, cols = shape
    row = min(max(int(np.floor(frame.row_px + 0.5)), 0), rows - 1)
    col = min(max(int(np.floor(frame.col_px + 0.5)), 0), cols - 1)
    sink.set(row, col, VISIBLE)
