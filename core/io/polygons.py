"""Ground in view as one valid, dissolved multipolygon per photograph, with its area on the ellipsoid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr, osr

from .crs import local_plane, spatial_reference
from .gdal_quiet import quiet_gdal

VISIBLE = 1

SIMPLIFY_CELLS = 0.7
"""Stair-steps of one cell vanish at this tolerance; no corner moves by a whole cell."""


@dataclass(frozen=True)
class GroundPolygon:
    """Ground that one photograph shows.

    Attributes
    ----------
    wkb : bytes or None
        Multipolygon in the DEM's CRS; None where nothing is seen.
    area_m2 : float
        Of its cells before simplification, on the ellipsoid [m2].
    farthest_m : float or None
        Ground distance of the farthest cell seen [m].
    dropped_m2 : float
        Area of the parts left out as too small, by the cell size at the observer [m2].
    """

    wkb: bytes | None
    area_m2: float
    farthest_m: float | None
    dropped_m2: float = 0.0


def viewshed_polygons(viewshed, dem, smallest_m2=0.0, simplify_cells=SIMPLIFY_CELLS):
    """Turn a viewshed's visible cells into a multipolygon.

    Parameters
    ----------
    viewshed : core.viewshed.Viewshed
        Or anything with `window`, `values` and `frame`.
    dem : Dem
        On whose grid it was computed.
    smallest_m2 : float
        Parts below this are dropped, and holes below it filled [m2].
    simplify_cells : float
        Tolerance of the simplification, below 1 [cells]; 0 keeps the cells' outlines.

    Returns
    -------
    GroundPolygon
    """
    if not 0 <= simplify_cells < 1:
        raise ValueError(f"the simplification must stay below one cell, not {simplify_cells}")
    visible = viewshed.values == VISIBLE
    rows, cols = np.flatnonzero(visible.any(axis=1)), np.flatnonzero(visible.any(axis=0))
    if len(rows) == 0:
        return GroundPolygon(None, 0.0, None)
    mask = visible[rows[0] : rows[-1] + 1, cols[0] : cols[-1] + 1]
    first_row, first_col = viewshed.window.row + int(rows[0]), viewshed.window.col + int(cols[0])
    cell_m2 = float(np.prod(viewshed.frame.cell_size_m))
    exact, dropped = _keep(_outlines(mask, first_row, first_col), smallest_m2 / cell_m2)
    farthest = _farthest_m(mask, first_row, first_col, viewshed.frame)
    if not exact.GetGeometryCount():
        return GroundPolygon(None, 0.0, farthest, dropped * cell_m2)
    whole = _dissolved(_simplified(exact, simplify_cells)) if simplify_cells else exact.Clone()
    for geometry in (exact, whole):
        _to_crs(geometry, dem.geotransform)
    area = _area_m2(exact, dem.crs_wkt, viewshed.frame)
    return GroundPolygon(bytes(whole.ExportToWkb(ogr.wkbNDR)), area, farthest, dropped * cell_m2)


def _outlines(mask, first_row, first_col):
    """Polygons around the mask's 4-connected parts, in pixels of the raster (corners at whole numbers + 0.5)."""
    rows, cols = mask.shape
    raster = gdal.GetDriverByName("MEM").Create("", cols, rows, 1, gdal.GDT_Byte)
    raster.SetGeoTransform((first_col - 0.5, 1, 0, first_row - 0.5, 0, 1))
    band = raster.GetRasterBand(1)
    band.WriteArray(mask.astype(np.uint8))
    table = ogr.GetDriverByName("Memory").CreateDataSource("")
    layer = table.CreateLayer("seen", None, ogr.wkbPolygon)
    with quiet_gdal():
        gdal.Polygonize(band, band, layer, -1)
    return [feature.GetGeometryRef().Clone() for feature in layer]


def _keep(outlines, smallest_cells):
    """Drop small parts and fill small holes: (multipolygon, dropped area [cells])."""
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
    """Each polygon with fewer corners; none vanishes."""
    result = ogr.Geometry(ogr.wkbMultiPolygon)
    for polygon in _polygons_of(parts):
        simple = polygon.SimplifyPreserveTopology(tolerance_px)
        for piece in _polygons_of(polygon if simple is None or simple.IsEmpty() else simple):
            result.AddGeometry(piece)
    return result


def _dissolved(parts):
    """Union of polygons that may touch, or overlap a little after simplification, as one valid multipolygon."""
    with quiet_gdal():
        whole = parts.UnionCascaded()
        if whole is None or not whole.IsValid():
            whole = (parts if whole is None else whole).MakeValid()
    result = ogr.Geometry(ogr.wkbMultiPolygon)
    for polygon in _polygons_of(whole):
        result.AddGeometry(polygon)
    return result


def _polygons_of(geometry):
    """Yield the polygons within any geometry; lines and points that repairs leave behind are no ground."""
    kind = ogr.GT_Flatten(geometry.GetGeometryType())
    if kind == ogr.wkbPolygon and geometry.GetArea() > 0:
        yield geometry
    elif kind in (ogr.wkbMultiPolygon, ogr.wkbGeometryCollection):
        for index in range(geometry.GetGeometryCount()):
            yield from _polygons_of(geometry.GetGeometryRef(index))


def _to_crs(geometry, geotransform):
    """Map pixels (first cell's centre at 0) to the raster's CRS, in place."""
    x0, dx, _, y0, _, dy = geotransform
    for index in range(geometry.GetGeometryCount()):
        polygon = geometry.GetGeometryRef(index)
        for ring in (polygon.GetGeometryRef(number) for number in range(polygon.GetGeometryCount())):
            for corner, (col, row, *_) in enumerate(ring.GetPoints()):
                ring.SetPoint_2D(corner, x0 + dx * (col + 0.5), y0 + dy * (row + 0.5))


def _farthest_m(mask, first_row, first_col, frame):
    """Distance of the farthest visible cell's centre [m]; only the outermost cells of rows can be it."""
    row = np.flatnonzero(mask.any(axis=1))
    left, right = mask[row].argmax(axis=1), mask.shape[1] - 1 - mask[row][:, ::-1].argmax(axis=1)
    east, north = frame.to_local(np.concatenate([left, right]) + first_col, np.tile(row, 2) + first_row)
    return float(np.hypot(east, north).max())


def _area_m2(geometry, crs_wkt, frame):
    """Area on the ellipsoid, by an equal-area projection around the observer [m2]."""
    plane = local_plane(float(frame.longitude_deg), float(frame.latitude_deg)).replace("+proj=aeqd", "+proj=laea")
    flat = geometry.Clone()
    with quiet_gdal():
        flat.Transform(osr.CoordinateTransformation(spatial_reference(crs_wkt), spatial_reference(plane)))
    return float(flat.GetArea())
