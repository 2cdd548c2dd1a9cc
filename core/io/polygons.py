"""Visible ground as one valid, dissolved multipolygon per photograph, with its area on the ellipsoid."""

from __future__ import annotations

import secrets
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr, osr

from ..base.terrain import Window
from ..base.viewed import VISIBLE
from .crs import local_plane, spatial_reference
from .gdal_quiet import quiet_gdal, small_cache

STRIP_CELLS = 8_000_000

HELD_CELLS = 100_000_000
"""Masks of up to this many cells are kept uncompressed; compression reduces larger ones to a hundredth."""

SIMPLIFY_CELLS = 0.7
"""Tolerance of simplification at which steps of one cell vanish and no corner moves by a whole cell [cells]."""


@dataclass(frozen=True)
class GroundPolygon:
    """The ground that one photograph shows.

    Attributes
    ----------
    wkb : bytes or None
        Multipolygon in the DEM's CRS; None if nothing is seen.
    area_m2 : float
        Area of the cells on the ellipsoid, before simplification [m2].
    farthest_m : float or None
        Ground distance of the farthest cell seen [m].
    dropped_m2 : float
        Area of the parts omitted as too small, from the cell size at the observer [m2].
    """

    wkb: bytes | None
    area_m2: float
    farthest_m: float | None
    dropped_m2: float = 0.0


def viewshed_polygons(viewshed, dem, smallest_m2=0.0, simplify_cells=SIMPLIFY_CELLS):
    """Convert the visible cells of a viewshed to a multipolygon.

    Parameters
    ----------
    viewshed : Viewshed
        Or any object with `window`, `frame` and `values`, which need only support slicing.
    dem : Dem
        DEM on whose grid the viewshed was computed.
    smallest_m2 : float
        Parts smaller than this are dropped, and smaller holes are filled [m2].
    simplify_cells : float
        Tolerance of the simplification, at least 0 and below 1 [cells]; 0 keeps the outlines of the cells.

    Returns
    -------
    GroundPolygon
    """
    if not 0 <= simplify_cells < 1:
        raise ValueError(f"the simplification must stay below one cell, not {simplify_cells}")
    box = _extent(viewshed.values)
    if box is None:
        return GroundPolygon(None, 0.0, None)
    first_row, first_col = viewshed.window.row + box.row, viewshed.window.col + box.col
    cell_m2 = float(np.prod(viewshed.frame.cell_size_m))
    with _mask(viewshed.values, box) as raster:
        exact, dropped = _keep(_outlines(raster, first_row, first_col), smallest_m2 / cell_m2)
    farthest = _farthest_m(viewshed.values, box, viewshed.window, viewshed.frame)
    if not exact.GetGeometryCount():
        return GroundPolygon(None, 0.0, farthest, dropped * cell_m2)
    whole = _dissolved(_simplified(exact, simplify_cells)) if simplify_cells else exact.Clone()
    for geometry in (exact, whole):
        _to_crs(geometry, dem.geotransform)
    area = _area_m2(exact, dem.crs_wkt, viewshed.frame)
    return GroundPolygon(bytes(whole.ExportToWkb(ogr.wkbNDR)), area, farthest, dropped * cell_m2)


def _strips(box):
    """Divide a window into slices of rows of some millions of cells each."""
    rows = max(STRIP_CELLS // max(box.cols, 1), 1)
    return [slice(row, min(row + rows, box.row + box.rows)) for row in range(box.row, box.row + box.rows, rows)]


def _extent(values):
    """Find the smallest window, in rows and columns of `values`, that contains all visible cells; None without any."""
    rows, cols = [], np.zeros(values.shape[1], bool)
    for strip in _strips(Window(0, 0, *values.shape)):
        seen = values[strip, :] == VISIBLE
        found = np.flatnonzero(seen.any(axis=1))
        if len(found):
            rows += [strip.start + int(found[0]), strip.start + int(found[-1])]
            cols |= seen.any(axis=0)
    if not rows:
        return None
    col = np.flatnonzero(cols)
    return Window(rows[0], int(col[0]), rows[-1] - rows[0] + 1, int(col[-1] - col[0]) + 1)


@contextmanager
def _mask(values, box):
    """Yield the visible cells of a window as a raster, compressed if it has very many cells."""
    name, driver, options = "", "MEM", []
    if box.rows * box.cols > HELD_CELLS:
        name, driver = f"/vsimem/skyline-{secrets.token_hex(6)}.tif", "GTiff"
        options = ["COMPRESS=DEFLATE", "ZLEVEL=1", "BIGTIFF=IF_SAFER"]
    raster = gdal.GetDriverByName(driver).Create(name, box.cols, box.rows, 1, gdal.GDT_Byte, options)
    try:
        with small_cache():
            for strip in _strips(box):
                seen = values[strip, box.col : box.col + box.cols] == VISIBLE
                raster.GetRasterBand(1).WriteArray(seen.astype(np.uint8), 0, strip.start - box.row)
            yield raster
    finally:
        raster = None
        if name:
            gdal.Unlink(name)


def _outlines(raster, first_row, first_col):
    """Make polygons around the 4-connected parts of a mask, in pixels of the DEM (corners at integers + 0.5)."""
    raster.SetGeoTransform((first_col - 0.5, 1, 0, first_row - 0.5, 0, 1))
    band = raster.GetRasterBand(1)
    table = ogr.GetDriverByName("Memory").CreateDataSource("")
    layer = table.CreateLayer("seen", None, ogr.wkbPolygon)
    with quiet_gdal():
        gdal.Polygonize(band, band, layer, -1)
    return [feature.GetGeometryRef().Clone() for feature in layer]


def _keep(outlines, smallest_cells):
    """Drop small parts and fill small holes; returns the multipolygon and the dropped area [cells]."""
    parts, dropped = ogr.Geometry(ogr.wkbMultiPolygon), 0.0
    for outline in outlines:
        area = outline.GetArea()
        if area < smallest_cells:
            dropped += area
            continue
        filled = ogr.Geometry(ogr.wkbPolygon)
        filled.AddGeometry(outline.GetGeometryRef(0))
        for ring in range(1, outline.GetGeometryCount()):
            if outline.GetGeometryRef(ring).GetArea() >= smallest_cells:
                filled.AddGeometry(outline.GetGeometryRef(ring))
        parts.AddGeometry(filled)
    return parts, dropped


def _simplified(parts, tolerance_px):
    """Remove corners from each polygon; no polygon vanishes."""
    result = ogr.Geometry(ogr.wkbMultiPolygon)
    for polygon in _polygons_of(parts):
        simple = polygon.SimplifyPreserveTopology(tolerance_px)
        for piece in _polygons_of(polygon if simple is None or simple.IsEmpty() else simple):
            result.AddGeometry(piece)
    return result


def _dissolved(parts):
    """Unite polygons that may touch, or overlap a little after simplification, into one valid multipolygon."""
    with quiet_gdal():
        whole = parts.UnionCascaded()
        if whole is None or not whole.IsValid():
            whole = (parts if whole is None else whole).MakeValid()
    result = ogr.Geometry(ogr.wkbMultiPolygon)
    for polygon in _polygons_of(whole):
        result.AddGeometry(polygon)
    return result


def _polygons_of(geometry):
    """Yield the polygons within any geometry; lines and points that remain from repairs are skipped."""
    kind = ogr.GT_Flatten(geometry.GetGeometryType())
    if kind == ogr.wkbPolygon and geometry.GetArea() > 0:
        yield geometry
    elif kind in (ogr.wkbMultiPolygon, ogr.wkbGeometryCollection):
        for index in range(geometry.GetGeometryCount()):
            yield from _polygons_of(geometry.GetGeometryRef(index))


def _to_crs(geometry, geotransform):
    """Convert pixels (the first cell's centre at 0) to the raster's CRS, in place."""
    x0, dx, _, y0, _, dy = geotransform
    for index in range(geometry.GetGeometryCount()):
        polygon = geometry.GetGeometryRef(index)
        for ring in (polygon.GetGeometryRef(number) for number in range(polygon.GetGeometryCount())):
            for corner, (col, row, *_) in enumerate(ring.GetPoints()):
                ring.SetPoint_2D(corner, x0 + dx * (col + 0.5), y0 + dy * (row + 0.5))


def _farthest_m(values, box, window, frame):
    """Give the distance to the farthest visible cell's centre [m], which is always an outermost cell of its row."""
    farthest = 0.0
    for strip in _strips(box):
        seen = values[strip, box.col : box.col + box.cols] == VISIBLE
        row = np.flatnonzero(seen.any(axis=1))
        if not len(row):
            continue
        left, right = seen[row].argmax(axis=1), seen.shape[1] - 1 - seen[row][:, ::-1].argmax(axis=1)
        cols = np.concatenate([left, right]) + (window.col + box.col)
        east, north = frame.to_local(cols, np.tile(row, 2) + (window.row + strip.start))
        farthest = max(farthest, float(np.hypot(east, north).max()))
    return farthest


def _area_m2(geometry, crs_wkt, frame):
    """Compute the area on the ellipsoid by an equal-area projection around the observer [m2]."""
    plane = local_plane(float(frame.longitude_deg), float(frame.latitude_deg)).replace("+proj=aeqd", "+proj=laea")
    flat = geometry.Clone()
    with quiet_gdal():
        flat.Transform(osr.CoordinateTransformation(spatial_reference(crs_wkt), spatial_reference(plane)))
    return float(flat.GetArea())
