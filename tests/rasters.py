"""Small rasters written by GDAL alone, shared by tests of reading: `from rasters import make_tif`."""

from __future__ import annotations

import numpy as np
from osgeo import gdal, osr
from skyline_viewshed.core.base.terrain import Window


def make_tif(path, values, geotransform=(600_000, 30, 0, 5_100_000, 0, -30), crs="EPSG:32632", nodata=None, **extra):
    """Write a raster with GDAL alone, so that the tests do not depend on our own writer."""
    values = np.asarray(values)
    code = {"int16": gdal.GDT_Int16, "float32": gdal.GDT_Float32, "float64": gdal.GDT_Float64, "uint8": gdal.GDT_Byte,
            "int32": gdal.GDT_Int32}[values.dtype.name]  # fmt: skip
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), values.shape[1], values.shape[0], 1, code)
    if geotransform is not None:
        dataset.SetGeoTransform(geotransform)
    if crs is not None:
        reference = osr.SpatialReference()
        reference.SetFromUserInput(crs)
        dataset.SetProjection(reference.ExportToWkt())
    band = dataset.GetRasterBand(1)
    if nodata is not None:
        band.SetNoDataValue(nodata)
    if "unit" in extra:
        band.SetUnitType(extra["unit"])
    if "scale" in extra:
        band.SetScale(extra["scale"])
        band.SetOffset(extra["offset"])
    band.WriteArray(values)
    dataset.FlushCache()
    return str(path)


def whole(dem):
    return dem.read(Window(0, 0, *dem.shape))
