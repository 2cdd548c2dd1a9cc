"""Area, rasters and table of a coverage run."""

from __future__ import annotations

import numpy as np

from ...core.base.terrain import Window
from .fields import FieldSpec
from .i18n import tr
from .map_places import number, places_of
from .outputs import make_folder_of
from .styling import style_on_completion

COUNT_NODATA = 65535


def coverage_specs():
    """Fields of the table."""
    return [
        FieldSpec("photo_id", "whole", tr("Photo point")),
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("cells", "whole", tr("Cells of the area that it sees")),
        FieldSpec("share", "real", tr("Share of the area that it sees")),
        FieldSpec("pick", "whole", tr("Place among the fewest photos needed; NULL: not needed")),
        FieldSpec("adds", "whole", tr("Cells that it adds to those picked before")),
        FieldSpec("so_far", "real", tr("Share of the area seen by the picks up to here")),
    ]


def coverage_window(dem, photos, reach_m, geometries):
    """Part of the DEM that can matter: the area's bounding box, or else that of everything within reach of a photo."""
    if geometries is not None:
        x0, dx, _, y0, _, dy = dem.geotransform
        boxes = [geometry.boundingBox() for geometry in geometries]
        col = [(edge - x0) / dx for box in boxes for edge in (box.xMinimum(), box.xMaximum())]
        row = [(edge - y0) / dy for box in boxes for edge in (box.yMinimum(), box.yMaximum())]
    else:
        from ...core.viewshed.viewshed import PhotoFrame, sector_window

        sectors = [PhotoFrame(photo.view.camera, photo.view.pose) for photo in photos]
        windows = [sector_window(p.view.frame, dem.shape, s, reach_m) for p, s in zip(photos, sectors)]
        col = [edge for w in windows for edge in (w.col, w.col + w.cols)]
        row = [edge for w in windows for edge in (w.row, w.row + w.rows)]
    top, left = int(np.floor(min(row))), int(np.floor(min(col)))
    return Window(top, left, int(np.ceil(max(row))) - top, int(np.ceil(max(col))) - left).clipped(dem.shape)


def area_mask(dem, window, geometries):
    """Cells of the window whose centre lies in one of the polygons; None for all.

    Even-odd rule by scan lines: each ring's edges flip the cells to the right of where they cross a row of centres.
    """
    if geometries is None:
        return None
    mask = np.zeros((window.rows, window.cols), bool)
    x0, dx, _, y0, _, dy = dem.geotransform
    for geometry in geometries:
        flips = np.zeros((window.rows, window.cols + 1), np.int32)
        for x, y, _ in places_of(geometry, "polygon"):
            col, row = (x - x0) / dx - 0.5 - window.col, (y - y0) / dy - 0.5 - window.row
            _flip(flips, col, row)
        mask |= (np.cumsum(flips[:, :-1], axis=1) % 2).astype(bool)
    return mask


def _flip(flips, col, row):
    rows, cols = flips.shape[0], flips.shape[1] - 1
    for c1, r1, c2, r2 in zip(col, row, np.roll(col, -1), np.roll(row, -1)):
        if r1 == r2:
            continue
        low, high = min(r1, r2), max(r1, r2)
        line = np.arange(max(int(np.ceil(low)), 0), min(int(np.ceil(high)), rows))
        cross = c1 + (line - r1) / (r2 - r1) * (c2 - c1)
        np.add.at(flips, (line, np.clip(np.ceil(cross), 0, cols).astype(int)), 1)


def write_coverage(algorithm, parameters, context, coverage, dem, feedback):
    """Write the raster of counts and, if requested, that of sampling distances; return both paths."""
    from ...core.io.write_raster import RasterLayout, write_raster

    path = algorithm.parameterAsOutputLayer(parameters, "OUTPUT", context)
    make_folder_of(path)
    count = np.where(coverage.area, coverage.count, COUNT_NODATA).astype(np.uint16)
    count[np.isnan(dem.read(coverage.window)) & (coverage.count == 0)] = COUNT_NODATA
    facts = {"CONTENT": "number of photographs that see the cell", "PHOTOS": len(coverage.names)}
    names = [tr("photographs that see the cell")]
    layout = RasterLayout(nodata=COUNT_NODATA, descriptions=names, metadata=facts)
    write_raster(path, count, dem, coverage.window, layout)
    style_on_completion(context, path, "viewshed", tr("Number of photos"), (), algorithm.displayName())
    if parameters.get("GSD") is None:
        return path, None
    gsd = algorithm.parameterAsOutputLayer(parameters, "GSD", context)
    make_folder_of(gsd)
    names = [tr("metres per pixel across the view, best photo")]
    layout = RasterLayout(nodata=float("nan"), descriptions=names)
    write_raster(gsd, coverage.best_gsd_m, dem, coverage.window, layout)
    style_on_completion(context, gsd, "gsd", tr("Best ground sampling distance"), (), algorithm.displayName())
    return path, gsd


def table_rows(photos, cells, coverage, chosen, gains, dem):
    """Rows of the table: needed photos first, in the order of what they add."""
    area = max(int(coverage.area.sum()), 1)
    rank = {index: k for k, index in enumerate(chosen)}
    so_far = np.cumsum(gains) / area if gains else []
    order = sorted(range(len(photos)), key=lambda k: (rank.get(k, len(photos)), -cells[k]))
    rows = []
    for index in order:
        photo, k = photos[index], rank.get(index)
        values = [photo.feature.id(), photo.path or photo.name, cells[index], number(cells[index] / area)]
        values += [None, None, None] if k is None else [k + 1, gains[k], number(so_far[k])]
        rows.append((None, values))
    return rows
