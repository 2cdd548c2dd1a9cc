"""Shaded relief."""

from __future__ import annotations

import numpy as np


def hillshade(elevation_m, cell_size_m, azimuth_deg=315.0, altitude_deg=45.0, exaggeration=1.0):
    """Compute the brightness of a matt surface lit from one direction.

    Parameters
    ----------
    elevation_m : (R, C) array
        Row 0 is the northernmost [m]; NaN where unknown.
    cell_size_m : float or (float, float)
        Ground size of a cell along a row and along a column [m].
    azimuth_deg : float
        Direction of the light, clockwise from grid north [degrees]; maps are customarily lit from the north-west.
    altitude_deg : float
        Elevation of the light above the horizon [degrees].
    exaggeration : float
        Factor by which elevations are multiplied.

    Returns
    -------
    (R, C) float32 array
        Cosine of the angle between surface and light, 0 to 1; NaN exactly where the elevation is.

    Notes
    -----
    Beside unknown cells and at the edge the differences are one-sided or use fewer rows; an isolated cell is flat.

    References
    ----------
    .. [1] Horn, B. K. P., Hill shading and the reflectance map, Proc. IEEE 69(1), 1981,
       doi:10.1109/PROC.1981.11918.
    """
    elevation = np.asarray(elevation_m, np.float32)
    cell_x, cell_y = np.broadcast_to(np.asarray(cell_size_m, float), 2)
    if not (cell_x > 0 and cell_y > 0):
        raise ValueError(f"cell sizes must be positive, not {cell_size_m}")
    if elevation.size == 0:
        return elevation.copy()
    east, south = _horn_gradient(elevation)
    east, south = east * (exaggeration / cell_x), south * (exaggeration / cell_y)
    light, height = np.radians(azimuth_deg), np.radians(altitude_deg)
    # The surface's upward normal is (-dz/dx, -dz/dy, 1); y points north, rows run south.
    facing = -east * np.sin(light) + south * np.cos(light)
    shade = (np.sin(height) + np.cos(height) * facing) / np.sqrt(1 + east**2 + south**2)
    return np.where(np.isfinite(elevation), np.clip(shade, 0, 1), np.nan).astype(np.float32)


def _horn_gradient(elevation):
    """Rise per cell to the east and to the south: differences of three rows (columns), weighted 1-2-1."""
    padded = np.pad(elevation, 1, constant_values=np.nan)
    rows, cols = elevation.shape

    def at(down, right):
        return padded[1 + down : 1 + down + rows, 1 + right : 1 + right + cols]

    east = _weighted([_rise(at(side, -1), at(side, 0), at(side, 1)) for side in (-1, 0, 1)])
    south = _weighted([_rise(at(-1, side), at(0, side), at(1, side)) for side in (-1, 0, 1)])
    return east, south


def _rise(before, here, after):
    """Central difference, or the one-sided one if a side is unknown; NaN if there is nothing to compare."""
    central = (after - before) / 2
    one_sided = np.where(np.isfinite(after - here), after - here, here - before)
    return np.where(np.isfinite(central), central, one_sided)


def _weighted(rises):
    total, weights = np.zeros_like(rises[0]), np.zeros_like(rises[0])
    for weight, rise in zip((1, 2, 1), rises):
        known = np.isfinite(rise)
        total += weight * np.where(known, rise, 0)
        weights += weight * known
    return total / np.maximum(weights, 1)
