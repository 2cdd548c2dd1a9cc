"""The DEM's surface at scattered places: elevation and normal, read tile by tile so that memory stays bounded."""

from __future__ import annotations

import numpy as np

from .terrain import Window, bilinear

TILE_CELLS = 1024


def sample_pixels(terrain, col_px, row_px):
    """Elevation at pixels of the whole raster [m], bilinear; NaN outside and beside voids. Shapes broadcast."""
    col_px, row_px = np.broadcast_arrays(np.asarray(col_px, float), np.asarray(row_px, float))
    col, row = col_px.ravel(), row_px.ravel()
    elevation = np.full(col.shape, np.nan)
    rows, cols = terrain.shape
    inside = np.flatnonzero((col >= -0.5) & (row >= -0.5) & (col <= cols - 0.5) & (row <= rows - 0.5))
    tile = (row[inside] // TILE_CELLS).astype(np.int64) * (cols // TILE_CELLS + 3) + (col[inside] // TILE_CELLS).astype(
        np.int64
    )
    order = np.argsort(tile, kind="stable")
    for members in np.split(inside[order], np.flatnonzero(np.diff(tile[order])) + 1):
        if members.size:
            window = _around(row[members], col[members], terrain.shape)
            patch = terrain.read(window)
            elevation[members] = bilinear(patch, row[members] - window.row, col[members] - window.col)
    return elevation.reshape(col_px.shape)


def _around(row, col, shape):
    top, left = int(np.floor(row.min())), int(np.floor(col.min()))
    bottom, right = int(np.ceil(row.max())) + 1, int(np.ceil(col.max())) + 1
    return Window(top - 1, left - 1, bottom - top + 2, right - left + 2).clipped(shape)


def elevation_at(terrain, frame, east_m, north_m):
    """Elevation of the surface at local places [m]; NaN outside and beside voids."""
    return sample_pixels(terrain, *frame.to_pixel(east_m, north_m))


def normal_at(terrain, frame, east_m, north_m):
    """Unit normal of the surface at local places.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
    east_m, north_m : (N,) arrays
        [m].

    Returns
    -------
    (3, N) array
        East, north, up; from central differences over one cell, NaN where an elevation is unknown.
    """
    east_m, north_m = np.asarray(east_m, float), np.asarray(north_m, float)
    step = frame.cell_m
    east = east_m + step * np.array([0.5, -0.5, 0, 0]).reshape((4,) + (1,) * east_m.ndim)
    north = north_m + step * np.array([0, 0, 0.5, -0.5]).reshape((4,) + (1,) * east_m.ndim)
    right, left, above, below = elevation_at(terrain, frame, east, north)
    normal = np.stack([(left - right) / step, (below - above) / step, np.ones(east_m.shape)])
    return normal / np.linalg.norm(normal, axis=0)


def incidence_deg(normal, azimuth_deg, elevation_deg):
    """Angle between the surface's normal and the way back to the eye [degrees]: 0 head-on, 90 grazing.

    `azimuth_deg` and `elevation_deg` are the ray's, as the eye sends it.
    """
    azimuth, elevation = np.radians(azimuth_deg), np.radians(elevation_deg)
    back = -np.stack([np.cos(elevation) * np.sin(azimuth), np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])
    return np.degrees(np.arccos(np.clip((normal * back).sum(axis=0), -1.0, 1.0)))
