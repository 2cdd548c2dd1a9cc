"""What a terrain shows, on its own grid, and how far two views agree."""

import numpy as np
from reference.landscapes import stand
from skyline_viewshed.core.viewshed.viewshed import FullCircle, ViewshedOptions, viewshed

UNKNOWN = 255


def look(elevation, cell_m, row, col, eye_height_m=1.7, eye_elevation_m=None, sector=None, **options):
    """Values on the whole array's grid."""
    terrain, observer = stand(elevation, cell_m, row, col, eye_height_m, eye_elevation_m)
    result = viewshed(terrain, observer, sector or FullCircle(), ViewshedOptions(**options))
    return spread(result, terrain.shape)


def spread(result, shape):
    values, window = np.zeros(shape, np.uint8), result.window
    values[window.row : window.row + window.rows, window.col : window.col + window.cols] = result.values
    return values


def overlap(a, b):
    return (a & b).sum() / max((a | b).sum(), 1)


def directions(shape, cell_m, row, col):
    """(azimuth [degrees], distance [m]) of every cell of a plane grid."""
    down, right = np.mgrid[: shape[0], : shape[1]]
    azimuth = np.degrees(np.arctan2(right - col, row - down)) % 360
    return azimuth, np.hypot(down - row, right - col) * cell_m
