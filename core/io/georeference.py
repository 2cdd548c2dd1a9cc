"""Band, CRS and geotransform of an elevation model, read from its header and checked."""

from __future__ import annotations

import numpy as np
from osgeo import gdal

from ..base.errors import TerrainError, UnusableDemError
from ..base.messages import Message
from .crs import spatial_reference


def check_band(path, dataset, band):
    """Raise `UnusableDemError` if a DEM has no band of this number, or if the band is of complex numbers.

    Parameters
    ----------
    path : str
        Path of the DEM, for the error message.
    dataset : osgeo.gdal.Dataset
    band : int
        Number of the band, from 1.
    """
    if not 1 <= band <= dataset.RasterCount:
        count = dataset.RasterCount
        reason = Message(
            "The DEM {path} has {count} band(s), but no band {band}. Choose another.", path=path, count=count, band=band
        )
        raise UnusableDemError(reason)
    if gdal.DataTypeIsComplex(dataset.GetRasterBand(band).DataType):
        raise UnusableDemError(
            Message("Band {band} of {path} contains complex numbers. Choose an elevation raster.", band=band, path=path)
        )


def crs_of(path, dataset, crs=None):
    """Give the WKT of the CRS of a DEM.

    Parameters
    ----------
    path : str
        Path of the DEM, for the error message.
    dataset : osgeo.gdal.Dataset
    crs : str or None
        Replaces the dataset's own CRS.

    Raises
    ------
    UnusableDemError
        If the CRS is missing, is neither geographic nor projected, or cannot be used.
    """
    reference = dataset.GetSpatialRef() if crs is None else spatial_reference(crs)
    if reference is None or not (reference.IsGeographic() or reference.IsProjected()):
        raise UnusableDemError(
            Message(
                "The DEM {path} has no geographic or projected coordinate reference system. Assign the right one "
                "(gdal_edit -a_srs).",
                path=path,
            )
        )
    wkt = reference.ExportToWkt()
    try:
        spatial_reference(wkt)
    except TerrainError as error:
        raise UnusableDemError(
            Message(
                "The coordinate reference system of the DEM {path} cannot be used. {reason}",
                path=path,
                reason=error.message,
            )
        ) from None
    return wkt


def geotransform_of(path, dataset):
    """Give the GDAL geotransform of a dataset; raise `UnusableDemError` if it is missing or rotated."""
    transform = dataset.GetGeoTransform(can_return_null=True)
    if transform is None or not np.isfinite(transform).all() or transform[1] == 0 or transform[5] == 0:
        raise UnusableDemError(
            Message("The DEM {path} is not georeferenced. Warp it to a CRS first (gdalwarp).", path=path)
        )
    shear = abs(transform[2]) * dataset.RasterYSize, abs(transform[4]) * dataset.RasterXSize
    if shear[0] > 0.01 * abs(transform[1]) or shear[1] > 0.01 * abs(transform[5]):
        raise UnusableDemError(
            Message(
                "The DEM {path} is rotated relative to its CRS. Warp it to a north-up grid first (gdalwarp).", path=path
            )
        )
    return (transform[0], transform[1], 0.0, transform[3], 0.0, transform[5])
