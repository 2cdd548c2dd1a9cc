"""Invented terrain written as a file that GDAL and QGIS place on the Earth."""

from __future__ import annotations

import numpy as np

from ..core.io.crs import local_plane, spatial_reference
from ..core.io.write_raster import RasterLayout, write_raster

DEM_NODATA = -9999.0


def write_dem(path, elevation_m, cell_m, longitude_deg=0.0, latitude_deg=0.0):
    """Write synthetic terrain (`core.base.terrain.ArrayTerrain`) as a GeoTIFF that GDAL and QGIS place on the Earth.

    Parameters
    ----------
    path : str
    elevation_m : (R, C) array
        Row 0 is the northernmost; NaN is written as -9999 [m].
    cell_m : float
        Side of a cell [m].
    longitude_deg, latitude_deg : float
        WGS 84 position of the array's centre [degrees].

    Notes
    -----
    The CRS is azimuthal equidistant around the centre, so distances and azimuths from the centre are those of the
    array. Seen from an observer d off the centre, scale changes by less than (d / R)^2 / 2, and the columns turn from
    true north by (d_east / R) tan(latitude), as meridians do: 0.05 degrees at 5 km and 46 degrees, nothing on the
    equator. `ArrayTerrain.pixel_of`, a plate carree on a sphere, agrees at the centre and departs by up to 0.7 % of the
    distance from it, so photographs should take their positions from `Dem.position_of`.
    """
    elevation_m = np.asarray(elevation_m, np.float32)
    grid = _CentredGrid(elevation_m.shape, cell_m, longitude_deg, latitude_deg)
    values = np.where(np.isfinite(elevation_m), elevation_m, np.float32(DEM_NODATA))
    write_raster(path, values, grid, layout=RasterLayout(nodata=DEM_NODATA, descriptions=["elevation [m]"]))


class _CentredGrid:
    def __init__(self, shape, cell_m, longitude_deg, latitude_deg):
        rows, cols = self.shape = shape
        self.crs_wkt = spatial_reference(local_plane(float(longitude_deg), float(latitude_deg))).ExportToWkt()
        self.geotransform = (-cols / 2 * cell_m, cell_m, 0.0, rows / 2 * cell_m, 0.0, -cell_m)
