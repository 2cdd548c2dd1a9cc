"""Simulated photographs: what a camera at a place would see of a terrain model, with exact truth for every pixel.

Serves tests and benchmarks (known pose, known skyline, known ground), the demo, and users who ask what a photograph
from somewhere would look like.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .camera import Camera, Pose
from .curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from .frame import LocalFrame
from .progress import SILENT, Progress, checkpoint, subtask
from .render_cast import cast_fan, first_hits_m, pixel_directions, read_patch, skyline_row_px
from .render_foreground import draw_foreground
from .render_scene import SceneOptions
from .render_sensor import develop
from .render_shading import Ground, shade_ground
from .render_sky import (
    air_light,
    cloud_colour,
    clouds_before,
    clouds_behind,
    daylight,
    sky_radiance,
    transmission,
)
from .terrain import Observer, Terrain, eye_elevation_m, ground_elevation_m

LOWEST_EYE_M = 0.5
"""An eye below the terrain would see nothing but the inside of a hill [m above the surface]."""


@dataclass(frozen=True, eq=False)
class RenderedView:
    """A simulated photograph and the truth about it.

    Attributes
    ----------
    pixels : (H, W, 3) uint8 array
        RGB, upright.
    distance_m : (H, W) float32 array
        Ground distance of the terrain behind each pixel, whether or not cloud or trees hide it; inf for sky [m].
    east_m, north_m : (H, W) float32 arrays
        Its place in the observer's local frame; NaN for sky [m].
    elevation_m : (H, W) float32 array
        Its elevation; NaN for sky [m].
    skyline_row_px : (W,) array
        Continuous row of the boundary between sky and terrain at the centre of each column, as the terrain has it,
        whether or not something hides it; NaN where it leaves the frame. Rows from the next whole one on are
        terrain [pixels].
    skyline_visible : (W,) bool array
        Neither cloud nor foreground hides the boundary in this column.
    hidden : (H, W) bool array
        Pixels whose terrain or sky is hidden by cloud or foreground.
    frame : LocalFrame
        Of the observer, for the way to the raster's pixels.
    eye_elevation_m : float
        [m].
    observer, camera, pose, scene
        What was asked for.
    """

    pixels: np.ndarray
    distance_m: np.ndarray
    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray
    skyline_row_px: np.ndarray
    skyline_visible: np.ndarray
    hidden: np.ndarray
    frame: LocalFrame
    eye_elevation_m: float
    observer: Observer
    camera: Camera
    pose: Pose
    scene: SceneOptions

    def raster_pixels(self):
        """(col, row) of every pixel's ground in the terrain's raster, two (H, W) arrays; NaN for sky [pixels]."""
        return self.frame.to_pixel(self.east_m.astype(float), self.north_m.astype(float))


def render_view(
    terrain: Terrain,
    observer: Observer,
    camera: Camera,
    pose: Pose,
    scene: SceneOptions | None = None,
    progress: Progress = SILENT,
) -> RenderedView:
    """Take a simulated photograph.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
        An eye below the surface is lifted to `LOWEST_EYE_M` above it.
    camera : Camera
        Size, focal length, principal point and radial distortion.
    pose : Pose
    scene : SceneOptions or None
        None gives a clear day.

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError, Cancelled
    """
    scene = scene or SceneOptions()
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, scene.range_m * 1.01)
    ground_m = ground_elevation_m(terrain, frame)
    eye_m = max(eye_elevation_m(terrain, frame, observer), ground_m + LOWEST_EYE_M)
    turn, tangent = pixel_directions(camera, pose)
    turns = float(turn.min()), float(turn.max())
    patch = read_patch(terrain, frame, turns, pose.heading_deg, scene.range_m)
    fan = cast_fan(patch, frame, camera, pose, turns, eye_m, scene.range_m, subtask(progress, 0.0, 0.5))
    azimuth = pose.heading_deg + turn
    distance = first_hits_m(fan, azimuth.ravel(), tangent.ravel()).reshape(tangent.shape)
    checkpoint(progress, 0.6)
    solid = np.isfinite(distance)
    angle = np.radians(azimuth)
    reach = np.where(solid, distance, np.nan)
    east, north = reach * np.sin(angle), reach * np.cos(angle)
    elevation = eye_m + reach * tangent + apparent_drop_m(reach, REFRACTION_COEFFICIENT)
    skyline = skyline_row_px(fan, camera, pose)
    ridge = np.interp(turn.ravel(), fan.azimuth_deg - pose.heading_deg, fan.highest[:, -1]).reshape(turn.shape)
    truth = _Seen(turn, tangent, ridge, distance, east, north, elevation, solid)
    radiance = _soften(_light(truth, patch, frame, camera, pose, scene, eye_m), skyline)
    checkpoint(progress, 0.8)
    radiance, cover = _obstruct(radiance, truth, skyline, scene, pose)
    pixels = develop(radiance, camera, scene)
    checkpoint(progress, 1.0)
    return RenderedView(
        pixels,
        distance.astype(np.float32),
        east.astype(np.float32),
        north.astype(np.float32),
        elevation.astype(np.float32),
        skyline,
        _visible(skyline, cover),
        cover > 0.5,
        frame,
        eye_m,
        observer,
        camera,
        pose,
        scene,
    )


@dataclass(frozen=True, eq=False)
class _Seen:
    turn_deg: np.ndarray
    tangent: np.ndarray
    ridge_tangent: np.ndarray
    distance_m: np.ndarray
    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray
    solid: np.ndarray


def _light(seen, patch, frame, camera, pose, scene, eye_m):
    """Light from sky, clouds behind and hazy ground, before anything in front of it."""
    radiance = sky_radiance(seen.turn_deg, seen.tangent, scene, pose.heading_deg)
    if scene.clouds in ("behind", "lid", "fog"):
        opacity, colour = clouds_behind(seen.turn_deg, seen.tangent, scene)
        radiance = radiance + opacity[..., None] * (colour - radiance)
    solid = seen.solid
    if not solid.any():
        return radiance
    distance, tangent = seen.distance_m[solid], seen.tangent[solid]
    angle = np.radians(pose.heading_deg + seen.turn_deg[solid])
    slant = np.sqrt(1 + tangent**2)
    sight = np.stack([-np.sin(angle), -np.cos(angle), -tangent], axis=-1) / slant[:, None]
    elevation = seen.elevation_m[solid]
    ground = Ground(
        seen.east_m[solid], seen.north_m[solid], elevation, distance, sight, distance * slant / camera.focal_px
    )
    levels = _levels(scene, elevation, distance)
    sun, sky = daylight(scene)
    own = shade_ground(ground, patch, frame, scene, sun, sky, levels)
    through = transmission(distance * slant, eye_m, elevation, scene.visibility_m)
    air = air_light(seen.turn_deg[solid], scene, pose.heading_deg)
    radiance[solid] = own * through + air * (1 - through)
    return radiance


def _soften(radiance, skyline):
    """Mix sky and ground in the pixels that hold both, in proportion to their shares of the column."""
    column = np.flatnonzero(np.isfinite(skyline))
    first = np.clip(np.ceil(skyline[column]), 1, radiance.shape[0] - 1).astype(np.intp)
    sky, ground = radiance[first - 1, column].copy(), radiance[first, column].copy()
    for row, colour_of_row in ((first - 1, sky), (first, ground)):
        share = np.clip(row + 0.5 - skyline[column], 0, 1)[:, None]
        radiance[row, column] = np.where((share > 0) & (share < 1), sky + share * (ground - sky), colour_of_row)
    return radiance


def _levels(scene, elevation, distance):
    """Tree and snow line as given, else at shares of the far terrain's relief."""
    far = elevation[distance > min(2000.0, float(np.median(distance)))]
    low, high = np.percentile(far if far.size else elevation, [5, 97])
    tree = scene.tree_line_m if scene.tree_line_m is not None else low + scene.tree_share * (high - low)
    snow = scene.snow_line_m if scene.snow_line_m is not None else high - scene.snow_share * (high - low)
    return tree, snow


def _obstruct(radiance, seen, skyline, scene, pose):
    """Put clouds and foreground before the view; give the light and the share of each pixel that is covered."""
    opacity, bright = clouds_before(
        seen.turn_deg, seen.tangent, seen.ridge_tangent, seen.distance_m, seen.elevation_m, scene
    )
    lit, shaded = cloud_colour(scene)
    colour = shaded + (lit - shaded) * np.clip(bright, 0, 1)[..., None]
    radiance = radiance + opacity[..., None] * (colour.astype(np.float32) - radiance)
    rows = np.where(np.isfinite(skyline), skyline, 0.4 * seen.tangent.shape[0])
    near, albedo = draw_foreground(seen.tangent.shape, rows, scene)
    sun, sky = daylight(scene)
    shade = albedo * (sky + 0.25 * sun)
    radiance = radiance + near[..., None] * (shade.astype(np.float32) - radiance)
    return radiance, np.maximum(opacity, near)


def _visible(skyline, cover):
    """Columns in which nothing covers the pixels around the skyline."""
    known = np.isfinite(skyline)
    row = np.clip(np.rint(np.where(known, skyline, 0)), 1, cover.shape[0] - 2).astype(np.intp)
    column = np.arange(skyline.size)
    most = np.maximum(np.maximum(cover[row - 1, column], cover[row, column]), cover[row + 1, column])
    return known & (most < 0.5)
