"""Elevation and normal of the DEM's surface at scattered places, read tile by tile so that memory stays bounded."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .camera import to_camera_axes
from .frame import LocalFrame
from .terrain import Terrain, Window, bilinear
from .view import View

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

TILE_CELLS = 1024


def sample_pixels(terrain: Terrain, col_px: ArrayLike, row_px: ArrayLike) -> np.ndarray:
    """Interpolate the elevation at pixels of the whole raster bilinearly.

    Parameters
    ----------
    terrain : Terrain
    col_px, row_px : array
        Pixels of the whole raster; broadcast together.

    Returns
    -------
    array
        Elevation [m]; NaN outside the raster and beside voids.
    """
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


def _around(row: np.ndarray, col: np.ndarray, shape: tuple[int, int]) -> Window:
    top, left = int(np.floor(row.min())), int(np.floor(col.min()))
    bottom, right = int(np.ceil(row.max())) + 1, int(np.ceil(col.max())) + 1
    return Window(top - 1, left - 1, bottom - top + 2, right - left + 2).clipped(shape)


def elevation_at(terrain: Terrain, frame: LocalFrame, east_m: ArrayLike, north_m: ArrayLike) -> np.ndarray:
    """Interpolate the elevation of the surface at local places.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
    east_m, north_m : array
        Local coordinates [m]; broadcast together.

    Returns
    -------
    array
        Elevation [m]; NaN outside the raster and beside voids.
    """
    return sample_pixels(terrain, *frame.to_pixel(east_m, north_m))


def normal_at(terrain: Terrain, frame: LocalFrame, east_m: ArrayLike, north_m: ArrayLike) -> np.ndarray:
    """Give the unit normal of the surface at local places.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
    east_m, north_m : (N,) arrays
        Local coordinates [m].

    Returns
    -------
    (3, N) array
        Normal (east, north, up) from central differences over one cell; NaN where an elevation is unknown.
    """
    east_m, north_m = np.asarray(east_m, float), np.asarray(north_m, float)
    step = frame.cell_m
    east = east_m + step * np.array([0.5, -0.5, 0, 0]).reshape((4,) + (1,) * east_m.ndim)
    north = north_m + step * np.array([0, 0, 0.5, -0.5]).reshape((4,) + (1,) * east_m.ndim)
    right, left, above, below = elevation_at(terrain, frame, east, north)
    normal = np.stack([(left - right) / step, (below - above) / step, np.ones(east_m.shape)])
    return normal / np.linalg.norm(normal, axis=0)


def incidence_deg(normal: np.ndarray, azimuth_deg: ArrayLike, elevation_deg: ArrayLike) -> np.ndarray:
    """Give the angle between the surface's normal and the direction to the eye [degrees]: 0 head-on, 90 grazing.

    Parameters
    ----------
    normal : (3, N) array
        Unit normal (east, north, up).
    azimuth_deg, elevation_deg : (N,) arrays
        Azimuth, clockwise from north, and elevation angle, up positive, of the ray from the eye to the surface
        [degrees].
    """
    azimuth, elevation = np.radians(azimuth_deg), np.radians(elevation_deg)
    back = -np.stack([np.cos(elevation) * np.sin(azimuth), np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])
    return np.degrees(np.arccos(np.clip((normal * back).sum(axis=0), -1.0, 1.0)))


NODE_CELLS = 16
"""Spacing of the nodes at which local places are exact [cells]; between them interpolation is enough, because frames
bend over kilometres."""

GRAZING_COSINE = 0.02
"""Smallest cosine used: above 88.9 degrees of incidence, the sampling distance along the line of sight is capped."""


def local_places(frame: LocalFrame, row: np.ndarray, col: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Give the local places of scattered DEM pixels of one tile, exact on nodes and interpolated between them.

    Parameters
    ----------
    frame : LocalFrame
    row, col : (N,) arrays
        Pixels of the whole raster, close enough together for a table over them.

    Returns
    -------
    east_m, north_m : (N,) arrays
        Local coordinates [m].
    """
    if frame.remainder_px is None:
        return frame.to_local(col, row)
    r0, c0 = row.min(), col.min()
    nodes_r = np.arange(r0, row.max() + NODE_CELLS + 1, NODE_CELLS)
    nodes_c = np.arange(c0, col.max() + NODE_CELLS + 1, NODE_CELLS)
    east, north = frame.to_local(nodes_c[None, :], nodes_r[:, None])
    place = (row - r0) / NODE_CELLS, (col - c0) / NODE_CELLS
    return bilinear(east, *place), bilinear(north, *place)


def patch_around(terrain: Terrain, row: np.ndarray, col: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Read the elevations around scattered DEM pixels of one tile.

    Parameters
    ----------
    terrain : Terrain
    row, col : (N,) arrays
        Pixels of the whole raster.

    Returns
    -------
    patch : (R, C) float32 array
        Elevations [m].
    row, col : (N,) arrays
        The same places in pixels of the patch.
    """
    top, left = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    window = Window(top, left, int(np.ceil(row.max())) + 2 - top, int(np.ceil(col.max())) + 2 - left)
    window = window.clipped(terrain.shape)
    return terrain.read(window), row - window.row, col - window.col


def normal_of(
    z: np.ndarray, row: np.ndarray, col: np.ndarray, frame: LocalFrame
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Give the unit normal of the surface at the cells nearest to places of a patch.

    Parameters
    ----------
    z : (R, C) array
        Elevations [m].
    row, col : (N,) arrays
        Places in pixels of `z`.
    frame : LocalFrame
        Frame that gives the size and direction of the cells on the ground.

    Returns
    -------
    east, north, up : (N,) arrays
        Components of the normals.
    """
    rows, cols = z.shape
    r = np.clip(np.rint(row).astype(np.intp), 0, rows - 1)
    c = np.clip(np.rint(col).astype(np.intp), 0, cols - 1)
    flat, at = z.reshape(-1), r * cols + c
    up, down = np.where(r > 0, cols, 0), np.where(r < rows - 1, cols, 0)
    left, right = np.where(c > 0, 1, 0), np.where(c < cols - 1, 1, 0)
    slope_row = (flat[at + down] - flat[at - up]) / np.maximum((up + down) // cols, 1)
    slope_col = (flat[at + right] - flat[at - left]) / np.maximum(left + right, 1)
    (a, b), (e, f) = frame.jacobian_px_per_m  # gradient in metres by the chain rule
    dz_east = np.nan_to_num(slope_col * a + slope_row * e)
    dz_north = np.nan_to_num(slope_col * b + slope_row * f)
    length = np.sqrt(1 + dz_east**2 + dz_north**2)
    return -dz_east / length, -dz_north / length, 1 / length


def sampling_distance_m(
    view: View, east: np.ndarray, north: np.ndarray, rise: np.ndarray, normal: Sequence[np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """Give the ground sampling distance [m per pixel] across and along the line of sight.

    Parameters
    ----------
    view : View
    east, north, rise : (N,) arrays
        Vectors from the eye [m]; `rise` includes curvature and refraction (`View.rise_of`).
    normal : three (N,) arrays
        Unit normal of the surface there (east, north, up).
    """
    _, _, depth = to_camera_axes(view.pose, east, north, rise)
    slant = np.sqrt(east**2 + north**2 + rise**2)
    cosine = -(normal[0] * east + normal[1] * north + normal[2] * rise) / np.maximum(slant, 1e-6)
    across = np.maximum(depth, 1e-6) / view.camera.focal_px
    return across, across / np.maximum(cosine, GRAZING_COSINE)
