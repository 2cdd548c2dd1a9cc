"""Scattered cells of a DEM as one view has them: place, surface, and how much ground a pixel shows there."""

from __future__ import annotations

import numpy as np

from .camera import to_camera_axes
from .terrain import Window, bilinear

NODE_CELLS = 16
"""Local places are exact at every so manyth DEM cell and interpolated between: frames bend over kilometres."""

GRAZING_COSINE = 0.02
"""Beyond 88.9 degrees of incidence the distance along the line of sight is not told apart from infinite."""


def local_places(frame, row, col):
    """Local places of scattered DEM pixels of one tile, exact on nodes and interpolated between them."""
    if frame.remainder_px is None:
        return frame.to_local(col, row)
    r0, c0 = row.min(), col.min()
    nodes_r = np.arange(r0, row.max() + NODE_CELLS + 1, NODE_CELLS)
    nodes_c = np.arange(c0, col.max() + NODE_CELLS + 1, NODE_CELLS)
    east, north = frame.to_local(nodes_c[None, :], nodes_r[:, None])
    place = (row - r0) / NODE_CELLS, (col - c0) / NODE_CELLS
    return bilinear(east, *place), bilinear(north, *place)


def patch_around(terrain, row, col):
    """Elevations around scattered DEM pixels of one tile, and where in it they lie."""
    top, left = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    window = Window(top, left, int(np.ceil(row.max())) + 2 - top, int(np.ceil(col.max())) + 2 - left)
    window = window.clipped(terrain.shape)
    return terrain.read(window), row - window.row, col - window.col


def normal_of(z, row, col, frame):
    """(east, north, up) of the surface's unit normal at the cells nearest to places of a patch."""
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


def sampling_distance_m(view, east, north, rise, normal):
    """Ground sampling distance: metres of ground per pixel, across and along the line of sight.

    Parameters
    ----------
    view : View
    east, north, rise : (N,) arrays
        Vectors from the eye [m]; `rise` is apparent (`View.rise_of`).
    normal : three (N,) arrays
        Of the surface there (east, north, up).
    """
    _, _, depth = to_camera_axes(view.pose, east, north, rise)
    slant = np.sqrt(east**2 + north**2 + rise**2)
    cosine = -(normal[0] * east + normal[1] * north + normal[2] * rise) / np.maximum(slant, 1e-6)
    across = np.maximum(depth, 1e-6) / view.camera.focal_px
    return across, across / np.maximum(cosine, GRAZING_COSINE)
