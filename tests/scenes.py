"""Small simulated scenes with exact truth, shared by tests of all stages: `from scenes import mountain_scene`."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
from skyline_viewshed.core.base.model import Photo, PhotoMetadata
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.simulate.render import RenderedView, render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.weather import hard_scene
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains
from skyline_viewshed.demo.viewpoint import ViewpointOptions, find_view

F35_MM = 35.0


@dataclass(frozen=True, eq=False)
class Scene:
    """A simulated photograph, its terrain and its truth."""

    terrain: ArrayTerrain
    observer: Observer
    camera: Camera
    pose: Pose
    view: RenderedView
    photo: Photo


@lru_cache(maxsize=4)
def small_mountains(seed=1, size=256, cell_m=90.0) -> ArrayTerrain:
    """A range of 23 km with 2.4 km of relief (about a second)."""
    return make_mountains(seed, MountainOptions(size=size, cell_m=cell_m))


@lru_cache(maxsize=8)
def mountain_scene(seed=1, hard=False, width_px=640, height_px=480, focal_length_35mm=F35_MM) -> Scene:
    """A photograph of `small_mountains` from a random place with a view (about a second).

    Use `scene.pose` (heading, pitch, roll), `scene.view.skyline_row_px` and `scene.view.east_m, ...` as truth.
    """
    terrain = small_mountains()
    generator = np.random.Generator(np.random.PCG64(1000 + seed))
    camera = Camera(width_px, height_px, focal_from_35mm_px(width_px, height_px, focal_length_35mm))
    options = ViewpointOptions(range_m=40_000.0, roll_sigma_deg=1.5, largest_roll_deg=4.0)
    observer, pose = find_view(terrain, camera, generator, terrain.position_of, options)
    return taken(terrain, observer, camera, pose, hard_scene(seed) if hard else SceneOptions(seed), focal_length_35mm)


def taken(terrain, observer, camera, pose, scene: SceneOptions, focal_length_35mm=None) -> Scene:
    """Render one scene and wrap it as a `Photo`."""
    view = render_view(terrain, observer, camera, pose, scene)
    metadata = PhotoMetadata(
        "simulated.jpg",
        camera.width_px,
        camera.height_px,
        latitude_deg=observer.latitude_deg,
        longitude_deg=observer.longitude_deg,
        altitude_m=view.eye_elevation_m,
        altitude_reference="sea level",
        focal_length_35mm=focal_length_35mm,
        compass_heading_deg=pose.heading_deg % 360,
        compass_reference="T",
        position_error_m=5.0,
    )
    return Scene(terrain, observer, camera, pose, view, Photo(metadata, view.pixels))
