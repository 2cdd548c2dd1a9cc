"""Make simulated photographs with exact truth from a seed, for `bench_simulated.py` and for the calibration.

A case depends on (seed, index, level) alone and is always the same. The camera sees a finer mountain than the matcher's
DEM contains, stands a little off its recorded position, and its EXIF focal length is slightly wrong.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from datetime import datetime
from functools import lru_cache
from pathlib import Path

import numpy as np
from skyline_viewshed.core.base.camera import DIAGONAL_35MM, Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.simulate.detail import DetailedTerrain
from skyline_viewshed.core.simulate.render import RenderedView, render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.weather import hard_scene
from skyline_viewshed.demo.dem_file import write_dem
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains
from skyline_viewshed.demo.viewpoint import ViewpointOptions, find_view

ROOT = Path(__file__).resolve().parent.parent
SEEDS = {"perfect": 0, "exact": 1, "clean": 1, "full": 2, "adverse": 3, "anywhere": 4}
LEVELS = tuple(SEEDS)
"""perfect: the true skyline, drawn from the matcher's own DEM at the true position; exact: clear weather, ordinary
lenses, 3 m GPS, on the matcher's own DEM; clean: the same scenes on mountains finer than the DEM; full: all of it;
adverse: what went wrong on real photographs, in each picture: clouds above and before the ridge, a foreground, rolls to
15 degrees, ultra-wide lenses, near terrain and an eye whose ground the DEM smooths; anywhere: the weather and lenses of
`full` at any place and in any direction with a horizon, also over flat ground and before near slopes."""
ORDINARY = LEVELS[:4]
"""The levels that are measured unless others are asked for."""
HARD = ("full", "adverse", "anywhere")

REAL_DEMS = (
    "khumbu/dem/khumbu.tif",
    "columbia/dem/columbia.tif",
    "aletsch/dem",
    "dem/AST_L1A_00303182012144228_Z.tif",
    "dem/S33W071.tif",
    "dem/N43E007.hgt",
    "dem/dem_SouthGlacier.tif",
)
PROCEDURAL = (
    MountainOptions(size=700, cell_m=90.0, relief_m=2800.0, latitude_deg=46.5, longitude_deg=8.0),
    MountainOptions(size=900, cell_m=30.0, relief_m=1900.0, latitude_deg=61.0, longitude_deg=9.0),
    MountainOptions(size=600, cell_m=60.0, relief_m=2400.0, base_m=2200.0, latitude_deg=-33.0, longitude_deg=-70.0),
)


@dataclass(frozen=True)
class Case:
    """One photograph to be rendered, and the metadata of its file."""

    name: str
    level: str
    dem_path: str
    factor: int
    roughness: float
    observer: Observer
    camera: Camera
    pose: Pose
    scene: SceneOptions
    metadata: PhotoMetadata
    gps_error_m: float
    detail_seed: int

    @property
    def hfov_deg(self):
        """True horizontal field of view [degrees]."""
        return self.camera.hfov_deg


def data_folder():
    """Folder of the shared real data, or None if there is none."""
    for folder in (os.environ.get("SKYLINE_DATA"), ROOT.parent / "shared" / "data"):
        if folder and Path(folder).is_dir():
            return Path(folder)
    return None


def dem_paths(work):
    """Paths of the real DEMs that are available, and of procedural ones, made once in `work`."""
    paths = []
    for index, options in enumerate(PROCEDURAL):
        path = Path(work) / f"mountains_{index}.tif"
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            terrain = make_mountains(4000 + index, options)
            write_dem(str(path), terrain.elevation_m, options.cell_m, options.longitude_deg, options.latitude_deg)
        paths.append(str(path))
    data = data_folder()
    for name in REAL_DEMS if data else ():
        path = data / name
        if path.is_dir():
            path = next(p for p in sorted(path.iterdir()) if p.suffix.lower() in (".tif", ".tiff"))
        paths.append(str(path))
    return paths


@lru_cache(maxsize=16)
def dem_of(path):
    return open_dem(path)


def draw_case(seed, index, level, paths, long_side_px=1024):
    """Draw one case; deterministic in all arguments."""
    generator = np.random.Generator(np.random.PCG64([seed, index, SEEDS[level]]))
    clear, own_dem = level in ("exact", "clean"), level in ("perfect", "exact")
    # Procedural and real mountains alternate, whichever are available.
    path = paths[int(generator.random() * len(paths))]
    dem = dem_of(path)
    cell_m = dem.frame(*map(float, dem.position_of(dem.shape[1] / 2, dem.shape[0] / 2)), 2_000.0).cell_m
    strength = 0.0 if level == "perfect" else float(np.exp(np.log(0.8) + np.log(3.0) * generator.random()))
    factor = 1 if own_dem else (4 if cell_m > 50 else 2)
    detail_seed = int(generator.integers(2**31))
    terrain = terrain_of(path, factor, detail_seed, strength)
    camera, f35 = _draw_camera(generator, level, long_side_px)
    options = ViewpointOptions(roll_sigma_deg=1.2 if clear else 2.8, largest_roll_deg=3.0 if clear else 8.0)
    if level == "adverse":
        options = ViewpointOptions(roll_sigma_deg=7.0, largest_roll_deg=15.0, near_m=10 * cell_m)
    if level == "anywhere":
        options = ViewpointOptions(near_m=2 * cell_m, least_relief_deg=0.0)
    observer, pose = find_view(dem, camera, generator, dem.position_of, options, terrain)
    scene_seed = int(generator.integers(2**31))
    scene = SceneOptions(scene_seed) if level not in HARD else hard_scene(scene_seed)
    if level == "adverse":
        scene = replace(
            scene,
            clouds=("behind", "lid")[int(generator.random() < 0.3)],
            cloud_share=0.4 + 0.5 * generator.random(),
            foreground=("trees", "people")[int(generator.random() < 0.3)],
        )
    if clear:
        scene = SceneOptions(
            scene_seed,
            sun_azimuth_deg=360 * generator.random(),
            sun_elevation_deg=15 + 45 * generator.random(),
            visibility_m=80_000 + 120_000 * generator.random(),
        )
    long_tail = min(3.0 - 7.0 * np.log(1 - generator.random()), 20.0)
    sigma = {"perfect": 0.0, "exact": 3.0, "clean": 3.0}.get(level, long_tail)
    east, north = sigma * np.sqrt(-np.log(1 - generator.random(2)))
    east, north = (np.array([east, north]) * np.sign(generator.random(2) - 0.5)).tolist()
    metadata = _metadata(generator, observer, camera, pose, f35, east, north, sigma)
    error_m = float(np.hypot(east, north))
    name = f"{level}_{seed}_{index:04d}"
    if own_dem:
        strength = 0.0
    return Case(name, level, path, factor, strength, observer, camera, pose, scene, metadata, error_m, detail_seed)


def terrain_of(path, factor, seed, strength):
    """Make the mountain that the camera sees."""
    dem = dem_of(path)
    return dem if factor == 1 else DetailedTerrain(dem, factor, seed, strength, sharpening=0.5)


def _draw_camera(generator, level, long_side):
    portrait = generator.random() < 0.35
    aspect = (4 / 3, 3 / 2, 16 / 9)[int(np.searchsorted([0.6, 0.85], generator.random()))]
    width, height = (long_side, int(round(long_side / aspect)))
    if portrait:
        width, height = height, width
    if generator.random() < 0.7:
        lenses = (24, 26, 28, 35, 47, 50, 52, 71, 77, 120)
        f35 = (lenses if level != "adverse" else (13, 14, *lenses[:-2]))[int(10 * generator.random())]
    else:
        hfov = np.exp(np.log(4.0) + np.log(75 / 4.0) * generator.random())
        f35 = focal_of_fov_px(width, hfov) * DIAGONAL_35MM / np.hypot(width, height)
    if level in ("exact", "clean"):
        f35 = float(np.clip(f35, 24, 85))
    f35 = max(int(round(f35)), 13)
    wrong = 0.0 if level == "perfect" else 0.012
    focal = np.hypot(width, height) * f35 / DIAGONAL_35MM * (1 + wrong * (2 * generator.random() - 1) * 1.7)
    k1 = 0.0
    if level in HARD and f35 < 40 and generator.random() < 0.3:
        k1 = -0.10 * generator.random()
    return Camera(width, height, float(focal), k1=float(k1)), f35


def _metadata(generator, observer, camera, pose, f35, east, north, sigma):
    metres = 111_195.0
    latitude = observer.latitude_deg + north / metres
    longitude = observer.longitude_deg + east / (metres * np.cos(np.radians(latitude)))
    compass = (
        pose.heading_deg + (20 * generator.random() - 10) + (60 * generator.random() - 30) * (generator.random() < 0.1)
    )
    return PhotoMetadata(
        "",
        camera.width_px,
        camera.height_px,
        latitude_deg=float(latitude),
        longitude_deg=float(longitude),
        focal_length_35mm=float(f35),
        compass_heading_deg=float(compass % 360),
        compass_reference="T",
        position_error_m=float(max(sigma, 2.0)),
        taken_at=datetime(2024, 7, 14, 9, 30),
        camera="Skyline Simulated",
    )


def take(case, folder, quality=88) -> tuple[str, RenderedView]:
    """Render a case and write its JPEG into `folder`."""
    terrain = terrain_of(case.dem_path, case.factor, case.detail_seed, case.roughness)
    view = render_view(terrain, case.observer, case.camera, case.pose, case.scene)
    path = os.path.join(folder, case.name + ".jpg")
    write_photo(path, view.pixels, case.metadata, quality)
    return path, view


def truth_row(case, view):
    """Return the truth and conditions of a case as plain values."""
    row = view.skyline_row_px
    known = np.isfinite(row)
    hidden = known & ~view.skyline_visible
    return {
        "photo": case.name + ".jpg",
        "group": case.level,
        "dem": case.dem_path,
        "latitude_deg": case.metadata.latitude_deg,
        "longitude_deg": case.metadata.longitude_deg,
        "true_latitude_deg": case.observer.latitude_deg,
        "true_longitude_deg": case.observer.longitude_deg,
        "eye_elevation_m": view.eye_elevation_m,
        "heading_deg": case.pose.heading_deg,
        "pitch_deg": case.pose.pitch_deg,
        "roll_deg": case.pose.roll_deg,
        "hfov_deg": case.hfov_deg,
        "focal_px": case.camera.focal_px,
        "k1": case.camera.k1,
        "width_px": case.camera.width_px,
        "height_px": case.camera.height_px,
        "focal_length_35mm": case.metadata.focal_length_35mm,
        "compass_heading_deg": case.metadata.compass_heading_deg,
        "gps_error_m": case.gps_error_m,
        "position_error_m": case.metadata.position_error_m,
        "dem_roughness": case.roughness,
        "clouds": case.scene.clouds,
        "foreground": case.scene.foreground,
        "visibility_m": case.scene.visibility_m,
        "sun_elevation_deg": case.scene.sun_elevation_deg,
        "noise": case.scene.noise,
        "skyline_share": float(known.mean()),
        "hidden_share": float(hidden.sum() / max(known.sum(), 1)),
        "scene_seed": case.scene.seed,
    }
