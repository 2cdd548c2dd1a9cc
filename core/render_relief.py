"""Slopes, cast shadows and openness of the terrain in a simulated view, prepared once and looked up per pixel."""

from __future__ import annotations

import numpy as np
from scipy import ndimage

from .render_cast import VOID_M

LIGHT_GRID = 900
"""Shadow and openness are computed on at most this many cells per side."""


class Relief:
    """What light needs to know of the terrain.

    Parameters
    ----------
    patch : TerrainPatch
    frame : LocalFrame
    scene : SceneOptions
        For the sun.
    """

    def __init__(self, patch, frame, scene):
        self._patch, self._frame = patch, frame
        self._slopes = _slopes(patch, frame)
        self._thin = max(1, int(np.ceil(max(patch.elevation_m.shape) / LIGHT_GRID)))
        elevation = patch.elevation_m[:: self._thin, :: self._thin]
        known = elevation > VOID_M / 10
        if not known.all():
            elevation = np.where(known, elevation, elevation[known].min() if known.any() else np.float32(0.0))
        self._elevation = elevation
        cell_m = frame.cell_m * self._thin
        self._shadow, self._penumbra_m = _shadow(elevation, cell_m, frame.jacobian_px_per_m, self._thin, scene)
        around = ndimage.gaussian_filter(elevation, max(700.0 / cell_m, 0.8))
        self._openness = 0.85 - 0.5 * np.clip((around - elevation) / 700.0, -0.5, 0.8)

    def at(self, east_m, north_m):
        """Look up places.

        Parameters
        ----------
        east_m, north_m : (N,) arrays
            [m].

        Returns
        -------
        slope_east, slope_north : (N,) float32 arrays
            Interpolated, so that cells do not show as facets.
        sunlit : (N,) float32 array
            Share of the sun's disc that the terrain towards it leaves free.
        openness : (N,) float32 array
            How open the place is to the sky: valleys are darker than crests.
        """
        col, row = self._frame.to_pixel(east_m, north_m)
        fine = np.array([row - self._patch.window.row, col - self._patch.window.col])
        coarse = fine / self._thin
        slope_east, slope_north = (_look_up(slope, fine) for slope in self._slopes)
        free = _look_up(self._elevation, coarse) - _look_up(self._shadow, coarse)
        return slope_east, slope_north, np.clip(free / self._penumbra_m + 1, 0, 1), _look_up(self._openness, coarse)


def sun_vector(scene):
    """Unit vector to the sun: east, north, up."""
    azimuth, elevation = np.radians(scene.sun_azimuth_deg), np.radians(scene.sun_elevation_deg)
    return np.array([np.cos(elevation) * np.sin(azimuth), np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])


def cosine(slope_east, slope_north, direction):
    """Cosine between the surface normal of a slope and a direction ((3,) or (N, 3))."""
    direction = np.asarray(direction)
    along = direction[..., 2] - slope_east * direction[..., 0] - slope_north * direction[..., 1]
    return along / np.sqrt(1 + slope_east**2 + slope_north**2)


def _slopes(patch, frame):
    known = patch.elevation_m > VOID_M / 10
    down_rows, along_cols = np.gradient(np.where(known, patch.elevation_m, np.float32(np.nan)))
    (col_e, col_n), (row_e, row_n) = frame.jacobian_px_per_m.astype(np.float32)
    east, north = along_cols * col_e + down_rows * row_e, along_cols * col_n + down_rows * row_n
    return np.nan_to_num(east, nan=0.0), np.nan_to_num(north, nan=0.0)


def _shadow(elevation, cell_m, jacobian, thin, scene):
    """Height up to which each cell lies in shadow, and of the penumbra above it [m].

    The shadow's height is a running maximum towards the sun; doubling the stride reaches across the whole patch in
    a few shifts.
    """
    azimuth = np.radians(scene.sun_azimuth_deg)
    drop_m = cell_m * np.tan(np.radians(np.clip(scene.sun_elevation_deg, 1.0, 89.0)))
    step = jacobian @ np.array([np.sin(azimuth), np.cos(azimuth)]) * cell_m / thin
    span = float(elevation.max() - elevation.min())
    highest, reach = elevation, 1
    while reach <= max(elevation.shape) and reach * drop_m < 2 * span:
        highest = np.maximum(highest, _towards(highest, step * reach) - np.float32(reach * drop_m))
        reach *= 2
    # The nearest cells only tell that a slope turns away from the sun, which its normal says without blots.
    return _towards(highest, step * 2) - np.float32(2 * drop_m), drop_m + 15.0


def _towards(field, step):
    """Bring to every cell what lies (cols, rows) `step` away from it."""
    return ndimage.shift(field, (-step[1], -step[0]), order=1, mode="constant", cval=-1e5)


def _look_up(field, place):
    return ndimage.map_coordinates(field, place, order=1, mode="nearest", output=np.float32)
