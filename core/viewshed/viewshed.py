"""The ground that an observer, or a photograph, sees: every cell of the DEM in range is judged once.

The result lies on the DEM's own grid. Distances and directions are true ones on the ellipsoid, whatever the CRS.
See `core.viewshed.sweep` for the method and `docs/performance.md` for the alternatives that were tried.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from threading import Lock

import numpy as np

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.progress import SILENT
from ..base.terrain import Window, check_inside, eye_elevation_m
from ..base.threads import side_by_side
from ..base.viewed import VISIBLE, ArraySink, Viewshed
from .geometry import quarters, tabulated
from .sector import FullCircle, PhotoFrame, Wedge
from .sinks import PackedSink
from .slabs import OneAtATime, SweptGround
from .sweep import QuarterSweep, SweepOptions

__all__ = [
    "FullCircle",
    "PackedSink",
    "PhotoFrame",
    "Viewshed",
    "ViewshedOptions",
    "Wedge",
    "photo_viewshed",
    "viewshed",
]

KEPT_BYTES = 30 * 2**20
"""Memory of arrays up to this size is reused. Linux's allocator returns the memory of large arrays to the system until
an even larger one has been freed, and fetching it again, page by page, takes as long as a tenth of a sweep."""

LEAST_CELLS = 100_000_000
"""Windows of fewer cells are swept in one thread: threads would cost more than they save."""

FRAME_MARGIN = 1.6
"""The frame reaches this many times farther than the range, as the quarters' corners do."""


@dataclass(frozen=True)
class ViewshedOptions:
    """How to compute a viewshed.

    Attributes
    ----------
    target_height_m : float
        Height of the target above ground [m]; 0 means the ground itself.
    min_distance_m, max_distance_m : float
        Range of distances that count [m]. Ground nearer than the minimum still obstructs.
    refraction_coefficient : float
        k of `apparent_drop_m`.
    curvature : bool
        Account for the earth's curvature and refraction.
    near_skip_cells : float
        Ground nearer than this does not obstruct [cells]: the DEM does not describe it well enough.
    rays_per_cell : float
        Rays per cell at the far end; 2 is slower and slightly more exact.
    voids_block : bool
        True: cells in view but behind cells without data are unknown (255). False: voids count as open air.
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


def viewshed(terrain, observer, sector=FullCircle(), options=ViewshedOptions(), progress=SILENT, sink=ArraySink):  # noqa: B008 - frozen values
    """Find the ground that is seen from one place.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    sector : Sector
        `FullCircle`, `Wedge` or `PhotoFrame`.
    options : ViewshedOptions
    progress : Progress
    sink : callable
        Called with the window; returns the `Sink` that takes the results, in memory or elsewhere.

    Returns
    -------
    Viewshed

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError, UnusableDemError
    """
    np.empty(KEPT_BYTES, np.uint8)  # freed at once
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, FRAME_MARGIN * options.max_distance_m)
    check_inside(terrain, frame)
    eye_m = eye_elevation_m(terrain, frame, observer)
    window = sector_window(frame, terrain.shape, sector, options.max_distance_m)
    taken = sink(window)
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
    # Set up for the full circle whatever the sector, so that the rays, and with them the results, are the same in all
    # sectors.
    k_max = _farthest_lines(frame, sector_window(frame, terrain.shape, FullCircle(), options.max_distance_m))
    views = quarters(frame, k_max, sector.touches)
    views.sort(key=lambda quarter: -k_max[quarter.by_rows, quarter.sign])  # so that the largest does not come last
    shared, lock = OneAtATime(terrain), Lock()

    def sweep(quarter, progress):
        farthest = k_max[quarter.by_rows, quarter.sign]
        ground = SweptGround(shared, tabulated(frame, quarter, farthest), window, farthest)
        QuarterSweep(ground, sector, sweep_options, taken, lock).run(progress)

    threads = 1 if window.rows * window.cols < LEAST_CELLS else 0
    side_by_side([partial(sweep, quarter) for quarter in views], progress, threads)
    mark_observer(taken, frame, terrain.shape, sector, options)
    return Viewshed(window, taken.values, frame, eye_m, options, sector)


def photo_viewshed(terrain, photo, options=ViewshedOptions(), progress=SILENT):  # noqa: B008 - frozen values
    """Find the ground that a photograph shows: the ground in view from its eye that lies within its frame.

    Parameters
    ----------
    terrain : Terrain
    photo : PosedPhoto
    options : ViewshedOptions
    progress : Progress

    Returns
    -------
    Viewshed

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError, UnusableDemError
    """
    return viewshed(terrain, photo.observer, PhotoFrame(photo.camera, photo.pose), options, progress)


def sector_window(frame, shape, sector, max_distance_m):
    """Find the rectangle of the raster that holds a sector out to a distance.

    Parameters
    ----------
    frame : LocalFrame
    shape : (rows, columns)
        Shape of the raster, to which the rectangle is cut.
    sector : Sector
    max_distance_m : float
        Range of the sector [m].

    Returns
    -------
    Window
    """
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
    """Mark the observer's own cell as seen: it belongs to no quarter if the observer stands on its centre.

    Parameters
    ----------
    sink : Sink
    frame : LocalFrame
    shape : (rows, columns)
        Shape of the raster.
    sector : Sector
    options : ViewshedOptions
    """
    if sink.wants_clearance or not sector.includes_observer or options.min_distance_m > 0:
        return
    rows, cols = shape
    row = min(max(int(np.floor(frame.row_px + 0.5)), 0), rows - 1)
    col = min(max(int(np.floor(frame.col_px + 0.5)), 0), cols - 1)
    sink.set(row, col, VISIBLE)
