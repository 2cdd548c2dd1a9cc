"""Writing of a mosaic of draped photos: only the box that has colour, strip by strip."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from qgis.core import QgsProcessingException

from ...core.base.progress import checkpoint
from ...core.base.terrain import Window
from ...core.mapping.drape import TILE_CELLS
from .feedback import FeedbackProgress
from .i18n import tr
from .outputs import make_folder_of


@dataclass(frozen=True)
class FinerGrid:
    """The DEM's grid with each cell subdivided."""

    shape: tuple
    crs_wkt: str
    geotransform: tuple


def finer_grid(dem, refine):
    """Grid of `refine` x `refine` cells for each of the DEM's."""
    x0, dx, _, y0, _, dy = dem.geotransform
    shape = dem.shape[0] * refine, dem.shape[1] * refine
    return FinerGrid(shape, dem.crs_wkt, (x0, dx / refine, 0.0, y0, 0.0, dy / refine))


def write_draped(path, gsd_path, mosaic, dem, feedback):
    """Write colours and, if a path is given, sampling distances; return the number of cells with colour.

    Raises
    ------
    QgsProcessingException
        No photo shows any ground.
    """
    from contextlib import ExitStack

    from ...core.io.write_raster import RasterLayout, new_raster

    if not mosaic.tiles:
        raise QgsProcessingException(tr("No photo shows any ground of this DEM, so there is nothing to drape."))
    grid, window = finer_grid(dem, mosaic.refine), _box(mosaic)
    progress, cells = FeedbackProgress(feedback), 0
    with ExitStack() as stack:
        make_folder_of(path)
        names = [tr("red"), tr("green"), tr("blue"), tr("opacity")]
        layout = RasterLayout("uint8", bands=4, descriptions=names, alpha=True)
        colour = stack.enter_context(new_raster(path, grid, window, layout))
        distance = None
        if gsd_path:
            make_folder_of(gsd_path)
            names = [tr("metres per pixel across the view"), tr("metres per pixel along the view")]
            layout = RasterLayout(bands=2, nodata=float("nan"), descriptions=names)
            distance = stack.enter_context(new_raster(gsd_path, grid, window, layout))
        for top in range(0, window.rows, TILE_CELLS):
            checkpoint(progress, 0.85 + 0.15 * top / window.rows)
            rows = min(TILE_CELLS, window.rows - top)
            rgba, gsd = mosaic.read(window.row + top, rows)
            part = slice(window.col, window.col + window.cols)
            cells += int(np.count_nonzero(rgba[:, part, 3]))
            for band in range(4):
                colour.write(rgba[:, part, band], top, band=band + 1)
            for band in range(2) if distance else ():
                distance.write(gsd[band][:, part], top, band=band + 1)
    return cells


def _box(mosaic):
    """Window of the mosaic's own cells that holds all its tiles."""
    keys = np.array(list(mosaic.tiles)) * TILE_CELLS
    (top, left), (bottom, right) = keys.min(axis=0), keys.max(axis=0) + TILE_CELLS
    return Window(int(top), int(left), int(bottom - top), int(right - left)).clipped(mosaic.shape)
