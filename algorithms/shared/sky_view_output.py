"""Raster of sky view factors over an area, beside the profiles of points."""

from __future__ import annotations

from qgis.core import QgsProcessingParameterExtent

from ...core.base.progress import checkpoint, subtask
from . import parameters as shared
from .feedback import FeedbackProgress
from .i18n import tr
from .outputs import make_folder_of
from .styling import style_on_completion

MARGIN_CELLS = 12_000
"""Most cells in the search range: 600 MB around each tile."""

NODATA = -9999.0


def add_sky_view_parameters(algorithm):
    """Declare the raster, its extent and the search range."""
    from ...core.horizon.sky_view import SkyViewOptions

    extent = QgsProcessingParameterExtent("SKY_VIEW_EXTENT", tr("Extent of the sky view raster"), optional=True)
    text = tr("Sky view factor of every cell of the DEM in the extent, its slope taken into account (1 = open sky).")
    for parameter in (
        shared.explained(extent, tr("Empty: the whole DEM. A million cells take some ten seconds.")),
        shared.distance(
            "SKY_VIEW_DISTANCE",
            tr("Search range of the sky view raster (m)"),
            SkyViewOptions().max_distance_m,
            tr("Terrain beyond is ignored; distant mountains cover little of the sky."),
            minimum=1.0,
        ),
        shared.raster_out("SKY_VIEW", tr("Sky view factor"), optional=True, create=False, text=text),
    ):
        algorithm.addParameter(shared.advanced(parameter))


def sky_view_fault(algorithm, parameters, context, source):
    """Sentence on an unusable extent or range, or None; `source` is a `DemSource`."""
    if parameters.get("SKY_VIEW") is None:
        return None
    dem = source.open()
    if window_of(algorithm, parameters, context, source, dem) is None:
        return tr("The extent of the sky view raster does not overlap the DEM. Choose another.")
    middle = dem.position_of(dem.shape[1] / 2, dem.shape[0] / 2)
    cell_m = dem.frame(*map(float, middle), 1000.0).cell_m
    most_m = MARGIN_CELLS * cell_m
    if algorithm.parameterAsDouble(parameters, "SKY_VIEW_DISTANCE", context) > most_m:
        return tr(
            "The search range of the sky view raster can be at most {most} m on a DEM with cells of {cell} m."
        ).format(most=f"{most_m:.0f}", cell=f"{cell_m:.2g}")
    return None


def window_of(algorithm, parameters, context, source, dem):
    """Cells of the DEM that the extent touches, or None."""
    from ...core.base.terrain import Window

    whole = Window(0, 0, *dem.shape)
    box = algorithm.parameterAsExtent(parameters, "SKY_VIEW_EXTENT", context, source.crs)
    if box.isNull():
        return whole
    x0, dx, _, y0, _, dy = dem.geotransform
    cols = sorted((x - x0) / dx for x in (box.xMinimum(), box.xMaximum()))
    rows = sorted((y - y0) / dy for y in (box.yMinimum(), box.yMaximum()))
    first_row, first_col = (int(side[0] // 1) for side in (rows, cols))
    last_row, last_col = (int(-(-side[1] // 1)) for side in (rows, cols))
    window = Window(first_row, first_col, last_row - first_row, last_col - first_col).clipped(dem.shape)
    return window if window.rows and window.cols else None


def write_sky_view(algorithm, parameters, context, source, feedback, share):
    """Write the raster tile by tile and return its path, or None if it is not requested."""
    import numpy as np

    from ...core.horizon.sky_view import SkyViewOptions, sky_view_raster
    from ...core.io.write_raster import RasterLayout, new_raster

    if parameters.get("SKY_VIEW") is None:
        return None
    path = algorithm.parameterAsOutputLayer(parameters, "SKY_VIEW", context)
    make_folder_of(path)
    dem = source.open()
    window = window_of(algorithm, parameters, context, source, dem)
    options = SkyViewOptions(
        max_distance_m=algorithm.parameterAsDouble(parameters, "SKY_VIEW_DISTANCE", context),
        refraction_coefficient=algorithm.parameterAsDouble(parameters, "REFRACTION", context),
    )
    progress = subtask(FeedbackProgress(feedback), *share)
    layout = RasterLayout(nodata=NODATA, descriptions=[tr("sky view factor")], units=["1"])
    with new_raster(path, dem, window, layout) as file:
        for tile, factor in sky_view_raster(dem, window, options, progress):
            file.write(
                np.where(np.isnan(factor), np.float32(NODATA), factor), tile.row - window.row, tile.col - window.col
            )
        checkpoint(progress, 1.0)
    style_on_completion(context, path, "sky_view", tr("Sky view factor"), (), algorithm.displayName())
    return path
