"""Where an elevation model lies on the Earth: what its header says, or an error in a sentence."""

from __future__ import annotations

import numpy as np

from ..base.errors import TerrainError, UnusableDemError
from ..base.messages import Message
from .crs import spatial_reference


def crs_of(path, dataset, crs=None):
    """WKT of the CRS of a DEM.

    Parameters
    ----------
    path : str
        File of the DEM, for the message.
    dataset : osgeo.gdal.Dataset
    crs : str or None
        CRS that replaces the dataset's own.

    Raises
    ------
    UnusableDemError
        If the CRS is missing or not one on the Earth.
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
    """GDAL geotransform of an upright dataset; refused where there is none or it is rotated."""
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
