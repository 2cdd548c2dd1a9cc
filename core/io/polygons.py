"""Viewsheds as polygons: traced along the cells, dissolved per photograph, measured on the ellipsoid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr, osr

from .crs import spatial_reference
from .gdal_quiet import quiet_gdal

VISIBLE = 1


@dataclass(frozen=True)
class GroundPolygon:
    """Ground that one photograph shows.

    Attributes
    ----------
    wkb : bytes or None
        Multipolygon in the DEM's CRS; None where nothing is seen.
    area_m2 : float
        On the ellipsoid [m2].
    farthest_m : float or None
        Ground distance of the farthest cell seen [m].
    """

    wkb: bytes | None
    area_m2: float
    farthest_m: float | None


def viewshed_polygons(viewshed, dem, smallest_m2=0.0):
    """Trace a viewshed's visible cells.

    Parameters
    ----------
    viewshed : core.viewshed.Viewshed
    dem : Dem
        On whose grid it was computed.
    smallest_m2 : float
        Parts below this are dropped [m2].

    Returns
    -------
    GroundPolygon
    """
    seen = viewshed.values == VISIBLE
    if not seen.any():
        return GroundPolygon(None, 0.0, None)
    to_equal_area = _equal_area(dem.crs_wkt, viewshed.frame)
    whole, area_m2 = ogr.Geometry(ogr.wkbMultiPolygon), 0.0
    for part in _parts(seen, viewshed.window, dem):
        flat = part.Clone()
        flat.Transform(to_equal_area)
        part_m2 = abs(flat.GetArea())
        if part_m2 >= smallest_m2:
            whole.AddGeometry(part)
            area_m2 += part_m2
    wkb = None if whole.IsEmpty() else bytes(whole.ExportToWkb(ogr.wkbNDR))
    return GroundPolygon(wkb, area_m2, _farthest_m(seen, viewshed))


def _parts(seen, window, dem):
    """Polygons along the cells' edges; cells that touch at a corner only belong to different parts, which is valid."""
    rows, cols = seen.shape
    x0, dx, _, y0, _, dy = dem.geotransform
    raster = gdal.GetDriverByName("MEM").Create("", cols, rows, 1, gdal.GDT_Byte)
    raster.SetGeoTransform((x0 + window.col * dx, dx, 0.0, y0 + window.row * dy, 0.0, dy))
    band = raster.GetRasterBand(1)
    band.WriteArray(seen.astype(np.uint8))
    table = ogr.GetDriverByName("Memory").CreateDataSource("")
    layer = table.CreateLayer("seen", None, ogr.wkbPolygon)
    with quiet_gdal():
        gdal.Polygonize(band, band, layer, -1)
    return [feature.GetGeometryRef().Clone() for feature in layer]


def _equal_area(crs_wkt, frame):
    """Transformation into an equal-area plane around the observer."""
    plane = (
        f"+proj=laea +lat_0={float(frame.latitude_deg)!r} +lon_0={float(frame.longitude_deg)!r} +datum=WGS84 +units=m"
    )
    return osr.CoordinateTransformation(spatial_reference(crs_wkt), spatial_reference(plane))


def _farthest_m(seen, viewshed):
    """Distance of the farthest visible cell's centre [m]; only the outermost cells of rows can be it."""
    rows = np.flatnonzero(seen.any(axis=1))
    first = seen[rows].argmax(axis=1)
    last = seen.shape[1] - 1 - seen[rows][:, ::-1].argmax(axis=1)
    row = np.concatenate([rows, rows]) + viewshed.window.row
    col = np.concatenate([first, last]) + viewshed.window.col
    return float(np.hypot(*viewshed.frame.to_local(col, row)).max())
