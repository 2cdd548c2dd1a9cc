"""Terrain for tests of horizon and viewshed: seeded fractal mountains, and one mountain written in many CRSs."""

from __future__ import annotations

import numpy as np
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer


def fractal(size, seed, relief_m=900.0, exponent=4.0):
    """Seeded rough terrain (size, size) float32 [m]."""
    rng = np.random.default_rng(seed)
    frequency = np.fft.rfftfreq(size)[None, :] ** 2 + np.fft.fftfreq(size)[:, None] ** 2
    frequency[0, 0] = 1.0
    field = np.fft.irfft2(
        np.fft.rfft2(rng.standard_normal((size, size))) * frequency ** (-exponent / 4), s=(size, size)
    )
    return ((field - field.min()) / np.ptp(field) * relief_m).astype(np.float32)


def stand(elevation_m, cell_m, row, col, eye_height_m=1.7, eye_elevation_m=None):
    """(terrain, observer) for an array and the observer's pixel."""
    terrain = ArrayTerrain(np.asarray(elevation_m), float(cell_m))
    longitude, latitude = terrain.position_of(col, row)
    return terrain, Observer(longitude, latitude, eye_height_m, eye_elevation_m)


def summits(longitude_deg, latitude_deg, centre):
    """Elevation [m] of a smooth mountain group around a centre (longitude, latitude), at any positions."""
    east = (longitude_deg - centre[0]) * 111_320 * np.cos(np.radians(centre[1]))
    north = (latitude_deg - centre[1]) * 111_320
    elevation = 300 + 30 * np.sin(east / 900) * np.cos(north / 700)
    for x, y, height, width in (
        (0, 9000, 1800, 2500),
        (7000, 4000, 1100, 1200),
        (-6000, -5000, 1500, 2000),
        (4000, -8000, 900, 1500),
        (-9000, 3000, 1300, 1000),
        (1500, 3500, 420, 800),
    ):
        elevation = elevation + height * np.exp(-((east - x) ** 2 + (north - y) ** 2) / (2 * width**2))
    return elevation


def write_summits(path, crs, cell, centre, half_m=14_000.0, south_up=False):
    """Write the mountain group as a GeoTIFF in a CRS; `cell` (x, y) in the CRS's units. Gives the path."""
    from osgeo import gdal, osr
    from skyline_viewshed.core.io.crs import from_wgs84

    reference = osr.SpatialReference()
    reference.SetFromUserInput(crs)
    wkt = reference.ExportToWkt()
    angle = np.radians(np.arange(0, 360, 5))
    longitude = centre[0] + half_m * np.sin(angle) / 111_320 / np.cos(np.radians(centre[1]))
    x, y = from_wgs84(wkt, longitude, centre[1] + half_m * np.cos(angle) / 111_320)
    left, top = x.min(), y.max()
    cols, rows = int((x.max() - left) / cell[0]), int((top - y.min()) / cell[1])
    grid_x, grid_y = left + (np.arange(cols) + 0.5) * cell[0], top - (np.arange(rows) + 0.5) * cell[1]
    elevation = summits(*_positions(wkt, grid_x, grid_y), centre).astype(np.float32)
    transform = (left, cell[0], 0, top, 0, -cell[1])
    if south_up:
        elevation, transform = elevation[::-1], (left, cell[0], 0, top - rows * cell[1], 0, cell[1])
    raster = gdal.GetDriverByName("GTiff").Create(str(path), cols, rows, 1, gdal.GDT_Float32)
    raster.SetGeoTransform(transform)
    raster.SetProjection(wkt)
    raster.GetRasterBand(1).WriteArray(np.ascontiguousarray(elevation))
    return str(path)


def _positions(wkt, x, y, step=16):
    """Longitudes and latitudes of a grid: every 16th is transformed, a spline gives the rest to a micrometre."""
    from scipy.interpolate import RectBivariateSpline
    from skyline_viewshed.core.io.crs import to_wgs84

    knots_x, knots_y = (np.linspace(axis[0], axis[-1], len(axis) // step + 4) for axis in (x, y))
    known = to_wgs84(wkt, *np.meshgrid(knots_x, knots_y))
    row, col = (np.linspace(0, 1, len(axis)) for axis in (y, x))
    ends = np.linspace(0, 1, len(knots_y)), np.linspace(0, 1, len(knots_x))
    return tuple(RectBivariateSpline(*ends, values)(row, col) for values in known)
