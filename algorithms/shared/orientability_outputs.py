"""Raster and report of orientability."""

from __future__ import annotations

from ...core.base.progress import checkpoint, subtask
from .feedback import FeedbackProgress
from .fields import is_null
from .horizon_report import HorizonReport
from .i18n import tr
from .outputs import make_folder_of
from .styling import style_on_completion

NODATA = -9999.0

SECTORS = 8

RASTER_STEP_DEG = 2.0
"""Step of the directions for a raster, coarser than for single places, since it has many."""


class OrientabilityReport(HorizonReport):
    """Report of places; see `HorizonReport`."""

    WRITER = "orientability"

    def add_place(self, name, position, horizon, predictions):
        """Append one place.

        Parameters
        ----------
        name : str
        position : (longitude_deg, latitude_deg)
        horizon : HorizonProfile
        predictions : list of (hfov_deg, Orientability)
        """
        if self._writer is not None:
            self._writer.add_place(name, position, horizon, predictions)


# parameters: what a run shares, and the raster's own
def write_orientability(algorithm, parameters, context, feedback, hfov_deg, options, share):
    """Write the raster and return its path, or None if it is not requested."""
    from dataclasses import replace

    import numpy as np
    from qgis.core import QgsCoordinateReferenceSystem

    from ...core.io.write_raster import RasterLayout, write_raster
    from ...core.locate.build import build_index
    from ...core.locate.places import Area, IndexOptions, lay_places
    from ...core.locate.unique import orientability

    if is_null(parameters.get("RASTER")):
        return None
    path = algorithm.parameterAsOutputLayer(parameters, "RASTER", context)
    make_folder_of(path)
    box = algorithm.parameterAsExtent(parameters, "EXTENT", context, QgsCoordinateReferenceSystem("EPSG:4326"))
    area = Area.box(box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum())
    dem, progress = algorithm.dem.open(), subtask(FeedbackProgress(feedback), *share)
    places = IndexOptions(
        spacing_m=algorithm.parameterAsDouble(parameters, "CELL", context),
        eye_height_m=algorithm.parameterAsDouble(parameters, "EYE_HEIGHT", context),
        max_distance_m=options.horizon.max_distance_m,
    )
    grid = lay_places(dem, area, places)
    index = build_index(dem, area, places, progress=subtask(progress, 0.0, 0.4))
    coarse = replace(options.unique, step_deg=RASTER_STEP_DEG)
    col, row = (np.asarray(values) for values in dem.pixel_of(index.longitude_deg, index.latitude_deg))
    first_row, first_col = min(tile.row for tile in grid.tiles), min(tile.col for tile in grid.tiles)
    row = np.rint((row - first_row) / grid.step_rows).astype(int)
    col = np.rint((col - first_col) / grid.step_cols).astype(int)
    bands = np.full((SECTORS + 2, row.max() + 1, col.max() + 1), NODATA, np.float32)
    for number in range(len(index)):
        checkpoint(progress, 0.4 + 0.6 * number / len(index))
        elevation, distance = index.horizons(slice(number, number + 1))
        found = orientability(elevation[0], distance[0], hfov_deg, index.cell_m, coarse)
        values = [found.mean, *(found.towards(45.0 * at) for at in range(SECTORS)), found.typical_error_deg]
        bands[:, row[number], col[number]] = np.nan_to_num(np.array(values, np.float32), nan=NODATA)
    names = ("N", "NE", "E", "SE", "S", "SW", "W", "NW")
    layout = RasterLayout(
        nodata=NODATA,
        descriptions=[tr("mean probability"), *names, tr("expected error (°)")],
        units=["1"] * (SECTORS + 1) + ["degree"],
    )
    write_raster(path, bands, CoarseGrid(dem, grid, (first_row, first_col), bands.shape[1:]), None, layout)
    style_on_completion(context, path, "orientability", tr("Orientability"), (), algorithm.displayName())
    return path


class CoarseGrid:
    """Grid of whole cells of a DEM around the places of an index; see `new_raster`."""

    def __init__(self, dem, grid, first, shape):
        x0, dx, _, y0, _, dy = dem.geotransform
        self.shape, self.crs_wkt = shape, dem.crs_wkt
        row, col = first
        left, top = col + 0.5 - 0.5 * grid.step_cols, row + 0.5 - 0.5 * grid.step_rows
        self.geotransform = (x0 + left * dx, dx * grid.step_cols, 0.0, y0 + top * dy, 0.0, dy * grid.step_rows)
