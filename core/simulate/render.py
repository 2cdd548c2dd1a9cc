"""Simulated photographs: the view of a camera over a terrain model, with the exact truth for every pixel.

They serve tests and benchmarks (known pose, known skyline, known ground), the demo, and users who want to know how a
photograph from a given place would look.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ..base.camera import Camera, Pose
from ..base.frame import LocalFrame
from ..base.posed import PosedPhoto
from ..base.progress import SILENT, Progress, checkpoint, subtask
from ..base.terrain import Observer, Terrain, eye_elevation_m, ground_elevation_m
from ..base.view import View
from .cast import Traced, cast_fan, row_blocks, skyline_row_px, trace, turns_deg
from .foreground import draw_foreground
from .patch import read_patch
from .scene import SceneOptions
from .sensor import develop
from .shading import Ground, Relief, shade_ground
from .sky import air_light, cloud_colour, clouds_before, clouds_behind, daylight, sky_radiance, transmission

LOWEST_EYE_M = 0.5
"""An eye below the terrain would see only the inside of a hill [m above the surface]."""


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
        Position of that terrain in the observer's local frame; NaN for sky [m].
    elevation_m : (H, W) float32 array
        Elevation of that terrain; NaN for sky [m].
    skyline_row_px : (W,) array
        Continuous row of the boundary between sky and terrain at the centre of each column, according to the terrain,
        whether or not something hides it; NaN where it leaves the frame. Rows from the next whole number on are
        terrain [pixels].
    skyline_visible : (W,) bool array
        Neither cloud nor foreground hides the boundary in this column.
    hidden : (H, W) bool array
        Pixels whose terrain or sky is hidden by cloud or foreground.
    frame : LocalFrame
        Frame of the observer, for conversion to the raster's pixels.
    eye_elevation_m : float
        [m].
    observer, camera, pose, scene
        The inputs of `render_view`.
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


def render_view(
    terrain: Terrain,
    observer: Observer,
    camera: Camera,
    pose: Pose,
    scene: SceneOptions | None = None,
    progress: Progress = SILENT,
) -> RenderedView:
    """Render a simulated photograph.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
        Position of the eye; an eye below the surface is raised to `LOWEST_EYE_M` above it.
    camera : Camera
        Size, focal length, principal point and radial distortion.
    pose : Pose
    scene : SceneOptions or None
        None means a clear day.

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError, Cancelled
    """
    scene = scene or SceneOptions()
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, scene.range_m * 1.01)
    ground_m = ground_elevation_m(terrain, frame)
    eye_m = max(eye_elevation_m(terrain, frame, observer), ground_m + LOWEST_EYE_M)
    turns = turns_deg(camera, pose)
    patch = read_patch(terrain, frame, turns, pose.heading_deg, scene.range_m)
    view = View(PosedPhoto(camera, pose, observer), frame, eye_m)
    fan = cast_fan(patch, view, turns, scene.range_m, subtask(progress, 0.0, 0.4))
    traced = trace(fan, camera, pose, eye_m, subtask(progress, 0.4, 0.5))
    skyline = skyline_row_px(fan, camera, pose)
    relief = Relief(patch, frame, scene)
    radiance = _light(traced, relief, view, scene, subtask(progress, 0.5, 0.8))
    radiance, cover = _obstruct(_soften(radiance, skyline), traced, fan, skyline, scene, pose)
    checkpoint(progress, 0.9)
    pixels = develop(radiance, camera, scene)
    checkpoint(progress, 1.0)
    return RenderedView(
        pixels,
        traced.distance_m,
        traced.east_m,
        traced.north_m,
        traced.elevation_m,
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


def _light(traced, relief, view, scene, progress):
    """Compute the light from sky, clouds behind the terrain and hazy ground, before anything in front of it."""
    camera, pose = view.camera, view.pose
    radiance = np.empty(traced.tangent.shape + (3,), np.float32)
    levels = _levels(scene, traced.elevation_m, traced.distance_m)
    for rows in row_blocks(camera):
        checkpoint(progress, rows.start / camera.height_px)
        part = Traced(*(getattr(traced, field.name)[rows.start : rows.stop] for field in fields(Traced)))
        light = sky_radiance(part.turn_deg, part.tangent, scene, pose.heading_deg)
        if scene.clouds in ("behind", "lid", "fog"):
            opacity, colour = clouds_behind(part.turn_deg, part.tangent, scene)
            light = light + opacity[..., None] * (colour - light)
        solid = np.isfinite(part.distance_m)
        if solid.any():
            light[solid] = _hazy_ground(part, solid, relief, view, scene, levels)
        radiance[rows.start : rows.stop] = light
    return radiance


def _hazy_ground(part, solid, relief, view, scene, levels):
    camera, pose = view.camera, view.pose
    turn, tangent, distance, east, north, elevation = (
        getattr(part, field.name)[solid].astype(float) for field in fields(Traced)
    )
    angle, slant = np.radians(pose.heading_deg + turn), np.sqrt(1 + tangent**2)
    sight = np.stack([-np.sin(angle), -np.cos(angle), -tangent], axis=-1) / slant[:, None]
    ground = Ground(east, north, elevation, distance, sight, distance * slant / camera.focal_px)
    own = shade_ground(ground, relief, scene, *daylight(scene), levels)
    through = transmission(distance * slant, view.eye_elevation_m, elevation, scene.visibility_m)
    return own * through + air_light(turn, scene, pose.heading_deg) * (1 - through)


def _soften(radiance, skyline):
    """Mix sky and ground in the pixels that contain both, in proportion to their shares of the column."""
    column = np.flatnonzero(np.isfinite(skyline))
    first = np.clip(np.ceil(skyline[column]), 1, radiance.shape[0] - 1).astype(np.intp)
    sky, ground = radiance[first - 1, column].copy(), radiance[first, column].copy()
    for row, colour_of_row in ((first - 1, sky), (first, ground)):
        share = np.clip(row + 0.5 - skyline[column], 0, 1)[:, None]
        radiance[row, column] = np.where((share > 0) & (share < 1), sky + share * (ground - sky), colour_of_row)
    return radiance


def _levels(scene, elevation, distance):
    """Tree line and snow line as given, or else at shares of the far terrain's relief [m]."""
    thin = max(1, int(np.sqrt(elevation.size / 200_000)))
    elevation, distance = elevation[::thin, ::thin], distance[::thin, ::thin]
    solid = np.isfinite(distance)
    if not solid.any():
        return 0.0, 0.0
    far = solid & (distance > min(2000.0, float(np.median(distance[solid]))))
    low, high = np.percentile(elevation[far if far.any() else solid].astype(float), [5, 97])
    tree = scene.tree_line_m if scene.tree_line_m is not None else low + scene.tree_share * (high - low)
    snow = scene.snow_line_m if scene.snow_line_m is not None else high - scene.snow_share * (high - low)
    return tree, snow


def _obstruct(radiance, traced, fan, skyline, scene, pose):
    """Put clouds and foreground in front of the view; return the light and the share of each pixel covered."""
    cover = np.zeros(traced.tangent.shape, np.float32)
    if scene.clouds in ("lid", "fog", "valley"):
        ridge = np.interp(traced.turn_deg, fan.azimuth_deg - pose.heading_deg, fan.highest[:, -1])
        cover, bright = clouds_before(
            traced.turn_deg, traced.tangent, ridge, traced.distance_m, traced.elevation_m, scene
        )
        lit, shaded = (colour.astype(np.float32) for colour in cloud_colour(scene))
        colour = shaded + (lit - shaded) * np.clip(bright, 0, 1).astype(np.float32)[..., None]
        radiance = radiance + cover[..., None] * (colour - radiance)
    if scene.foreground != "none":
        rows = np.where(np.isfinite(skyline), skyline, 0.4 * cover.shape[0])
        near, albedo = draw_foreground(cover.shape, rows, scene)
        sun, sky = daylight(scene)
        shade = albedo * (sky + 0.25 * sun).astype(np.float32)
        radiance = radiance + near[..., None] * (shade - radiance)
        cover = np.maximum(cover, near)
    return radiance, cover


def _visible(skyline, cover):
    """Columns in which nothing covers the pixels around the skyline."""
    known = np.isfinite(skyline)
    row = np.clip(np.rint(np.where(known, skyline, 0)), 1, cover.shape[0] - 2).astype(np.intp)
    column = np.arange(skyline.size)
    most = np.maximum(np.maximum(cover[row - 1, column], cover[row, column]), cover[row + 1, column])
    return known & (most < 0.5)
