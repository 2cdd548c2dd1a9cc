"""Light and colour of the ground in a simulated photograph: relief, shadow, snow, rock, scree, grass and forest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from .noise import noise_tile, smoothstep
from .patch import VOID_M, sample_field

ROCK = np.array([0.185, 0.170, 0.155], np.float32)
WARM_ROCK = np.array([0.225, 0.190, 0.155], np.float32)
SCREE = np.array([0.285, 0.270, 0.250], np.float32)
GRASS = np.array([0.130, 0.118, 0.066], np.float32)
FOREST = np.array([0.034, 0.042, 0.028], np.float32)
SNOW = np.array([0.86, 0.88, 0.91], np.float32)
WATER = np.array([0.02, 0.04, 0.05], np.float32)
"""Albedos in linear red, green, blue."""

TEXTURE_PERIODS_M = (9000.0, 700.0, 45.0, 3.0)
"""Periods of the four texture tiles; each holds details down to 1/256 of its period."""


@dataclass(frozen=True, eq=False)
class Ground:
    """Terrain pixels of a view, as flat arrays.

    Attributes
    ----------
    east_m, north_m, elevation_m, distance_m : (N,) arrays
        Position and distance of each pixel's ground [m].
    sight : (N, 3) array
        Unit vector from the ground to the eye: east, north, up.
    pixel_m : (N,) array
        Size of the pixel's footprint across the line of sight [m].
    """

    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray
    distance_m: np.ndarray
    sight: np.ndarray
    pixel_m: np.ndarray


def shade_ground(ground, relief, scene, sun_light, sky_light, levels):
    """Compute the radiance of the ground, without the air in between.

    Parameters
    ----------
    ground : Ground
    relief : Relief
    scene : SceneOptions
    sun_light, sky_light : (3,) arrays
        Irradiance of the sun perpendicular to its rays, and of the open sky.
    levels : (tree_line_m, snow_line_m)
        Elevations of both lines [m].

    Returns
    -------
    (N, 3) float32 array
        Linear red, green, blue.
    """
    slope_east, slope_north, sunlit, openness = relief.at(ground.east_m, ground.north_m)
    steep = np.hypot(slope_east, slope_north)
    facing = np.abs(cosine(slope_east, slope_north, ground.sight))
    footprint = ground.pixel_m / np.sqrt(np.maximum(facing, 0.06))
    value, bump_east, bump_north = _texture(ground, footprint, scene)
    albedo, rough, water = _cover(ground, steep, slope_north, value, scene, levels)
    slope_east = slope_east + rough * bump_east
    slope_north = slope_north + rough * bump_north
    lit = np.maximum(cosine(slope_east, slope_north, sun_vector(scene)), 0.0) * sunlit
    open_sky = (0.5 + 0.5 / np.sqrt(1 + slope_east**2 + slope_north**2)) * openness
    light = lit[:, None] * sun_light + open_sky[:, None] * sky_light
    # Sunlit slopes light their neighbours, so shadows on snow are never black.
    light = light + 0.10 * sun_light * 0.65 * (1 - open_sky[:, None])
    colour = albedo * light / np.pi * 2.2
    return np.where(water[:, None], _mirror(ground, value, sky_light), colour).astype(np.float32)


def _texture(ground, footprint_m, scene):
    """Compute the fractal texture of the ground and the slope that it adds, over four scales.

    On steep walls the plane position hardly changes from pixel to pixel, so height shears the lookup.
    """
    x = ground.east_m + 0.8 * ground.elevation_m
    y = ground.north_m - 0.5 * ground.elevation_m
    value = np.zeros((ground.east_m.size, len(TEXTURE_PERIODS_M)), np.float32)
    bump = np.zeros((ground.east_m.size, 2), np.float32)
    for index, period in enumerate(TEXTURE_PERIODS_M):
        cell = period / 256
        tile = noise_tile(9100 + 13 * scene.seed + index, 1.25, np.inf if index == 0 else 40.0)
        found = tile.sample(x / cell, y / cell, footprint_m / cell)
        value[:, index] = found[:, 0]
        # A slope per metre: relief of this scale has a height of about 0.4 % of the period.
        bump += found[:, 1:] * np.float32(period * 0.004 / cell)
    return value * scene.texture, bump[:, 0] * scene.texture, bump[:, 1] * scene.texture


def _cover(ground, steep, slope_north, value, scene, levels):
    """Albedo, roughness of the relief, and the water mask."""
    tree_line, snow_line = levels
    wide, middle, fine, near = value.T
    height = ground.elevation_m
    angle = np.degrees(np.arctan(steep)) + 4 * middle + 2.5 * fine
    patchy = 120 * wide + 70 * middle + 30 * fine
    # On sunny slopes trees and bare ground reach higher; shady slopes keep their snow.
    sunny = np.clip(slope_north / np.sqrt(1 + steep**2), -1, 1) * 150
    strata = np.sin((height + 40 * middle + 300 * wide) / 23.0) * 0.12
    rock = _mix(ROCK, WARM_ROCK, smoothstep(-1.2, 1.2, wide + 0.5 * middle))
    rock = rock * (1 + 0.28 * middle + 0.22 * fine + 0.15 * near + strata)[:, None]
    scree = SCREE * (1 + 0.12 * middle + 0.14 * fine + 0.16 * near)[:, None]
    grass = GRASS * (1 + 0.18 * wide + 0.15 * middle + 0.2 * fine + 0.25 * near)[:, None]
    forest = FOREST * (1 + 0.2 * middle + 0.45 * fine + 0.45 * near)[:, None]
    colour = _mix(rock, scree, smoothstep(40, 33, angle))
    grassy = smoothstep(tree_line + 520, tree_line + 80, height + patchy - sunny) * smoothstep(41, 31, angle)
    colour = _mix(colour, grass, grassy)
    wooded = smoothstep(tree_line + 60, tree_line - 90, height + patchy - sunny)
    wooded = wooded * smoothstep(44, 36, angle) * smoothstep(-1.6, -0.6, middle + 0.6 * fine)
    colour = _mix(colour, forest, wooded)
    snowy = smoothstep(-90, 110, height - snow_line + 1.3 * patchy - sunny)
    held = smoothstep(68, 52, angle + 6 * fine + 3 * near - 9 * smoothstep(0, 1500, height - snow_line))
    snowy = snowy * held
    colour = _mix(colour, SNOW * (1 + 0.03 * middle + 0.03 * fine)[:, None], snowy)
    rough = 1.0 + 0.5 * wooded - 0.55 * snowy - 0.4 * grassy
    water = np.zeros(height.shape, bool)
    if scene.lake_elevation_m is not None:
        water = height <= scene.lake_elevation_m + 0.5
    return np.maximum(colour, 0.004), rough, water


def _mirror(ground, value, sky_light):
    """Water surface: darker the steeper the view down, with ripples (Schlick's approximation)."""
    reflect = 0.02 + 0.98 * (1 - np.clip(ground.sight[:, 2], 0, 1)) ** 5
    ripple = 1 + 0.08 * value[:, 2] + 0.08 * value[:, 3]
    return WATER * 0.5 + (reflect * ripple)[:, None] * sky_light * 0.6


def _mix(low, high, share):
    return low + (high - low) * share[:, None]


LIGHT_GRID = 900
"""Shadow and openness are computed on at most this many cells per side."""


class Relief:
    """The properties of the terrain that determine its lighting.

    Parameters
    ----------
    patch : TerrainPatch
    frame : LocalFrame
    scene : SceneOptions
        Scene, which gives the sun's direction.
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
            Positions [m].

        Returns
        -------
        slope_east, slope_north : (N,) float32 arrays
            Interpolated, so that cells do not show as facets.
        sunlit : (N,) float32 array
            Share of the sun's disc that terrain does not cover.
        openness : (N,) float32 array
            How open the place is to the sky: valleys are darker than crests.
        """
        col, row = self._frame.to_pixel(east_m, north_m)
        fine = np.array([row - self._patch.window.row, col - self._patch.window.col])
        coarse = fine / self._thin
        slope_east, slope_north = (sample_field(slope, *fine) for slope in self._slopes)
        free = sample_field(self._elevation, *coarse) - sample_field(self._shadow, *coarse)
        openness = sample_field(self._openness, *coarse)
        return slope_east, slope_north, np.clip(free / self._penumbra_m + 1, 0, 1), openness


def sun_vector(scene):
    """Unit vector to the sun: east, north, up."""
    azimuth, elevation = np.radians(scene.sun_azimuth_deg), np.radians(scene.sun_elevation_deg)
    return np.array([np.cos(elevation) * np.sin(azimuth), np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])


def cosine(slope_east, slope_north, direction):
    """Cosine of the angle between the normal of a slope and a direction.

    Parameters
    ----------
    slope_east, slope_north : array
        Rise per metre towards east and north.
    direction : (3,) or (N, 3) array
        Unit vectors (east, north, up).
    """
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
    """Compute the height up to which each cell lies in shadow, and that of the penumbra above it [m].

    The shadow's height is a running maximum towards the sun; doubling the stride reaches across the whole patch in a
    few shifts.
    """
    azimuth = np.radians(scene.sun_azimuth_deg)
    drop_m = cell_m * np.tan(np.radians(np.clip(scene.sun_elevation_deg, 1.0, 89.0)))
    step = jacobian @ np.array([np.sin(azimuth), np.cos(azimuth)]) * cell_m / thin
    span = float(elevation.max() - elevation.min())
    highest, reach = elevation, 1
    while reach <= max(elevation.shape) and reach * drop_m < 2 * span:
        highest = np.maximum(highest, _towards(highest, step * reach) - np.float32(reach * drop_m))
        reach *= 2
    # The nearest cells only show that a slope faces away from the sun, which its normal shows without blotches.
    return _towards(highest, step * 2) - np.float32(2 * drop_m), drop_m + 15.0


def _towards(field, step):
    """Return, for every cell, the value that lies (cols, rows) `step` away from it."""
    return ndimage.shift(field, (-step[1], -step[0]), order=1, mode="constant", cval=-1e5)
