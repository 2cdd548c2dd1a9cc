"""Make the small sample that `make demo` runs on: a procedural DEM and photographs of it with known truth.

    python tools/make_sample.py build/demo/sample [--seed 7] [--zip build/skyline_viewshed_sample.zip]

This writes `dem/mountains.tif`, `photos/*.heic|jpg` and `truth.csv` (with the columns of the accuracy benchmark), and
with --zip packs them for download. The camera sees a rougher mountain than the DEM contains, as in nature.
"""

from __future__ import annotations

import argparse
import csv
import sys
import zipfile
from datetime import datetime, timedelta
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "plugins"))
from skyline_viewshed.core.base.camera import Camera, focal_from_35mm_px  # noqa: E402
from skyline_viewshed.core.base.errors import MissingPackageError  # noqa: E402
from skyline_viewshed.core.base.model import PhotoMetadata  # noqa: E402
from skyline_viewshed.core.base.sun_moon import sun_direction_deg  # noqa: E402
from skyline_viewshed.core.io.raster import open_dem  # noqa: E402
from skyline_viewshed.core.io.write_photo import write_photo  # noqa: E402
from skyline_viewshed.core.simulate.detail import DetailedTerrain  # noqa: E402
from skyline_viewshed.core.simulate.render import render_view  # noqa: E402
from skyline_viewshed.core.simulate.scene import SceneOptions  # noqa: E402
from skyline_viewshed.demo.dem_file import write_dem  # noqa: E402
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains  # noqa: E402
from skyline_viewshed.demo.viewpoint import ViewpointOptions, find_view  # noqa: E402

MOUNTAINS = MountainOptions(size=480, cell_m=60.0, relief_m=2500.0, base_m=700.0, longitude_deg=8.0, latitude_deg=46.5)
NOON_UTC = datetime(2024, 7, 14, 11, 30)
SHOTS = (
    # name, width, height, 35 mm equivalent, hours from noon, weather
    ("morning.heic", 1280, 960, 26, -4.0, {"clouds": "behind", "cloud_share": 0.25}),
    ("midday.jpg", 1280, 960, 35, 0.0, {}),
    ("portrait.heic", 960, 1280, 28, 2.0, {"foreground": "trees", "foreground_share": 0.25}),
    ("evening.jpg", 1280, 853, 50, 6.0, {"visibility_m": 70_000.0}),
)
MOST_BYTES = 5_000_000
EXPLANATION = """Sample for the QGIS plugin Skyline Viewshed: an invented mountain range, simulated.

photos/             four photos with GPS position; two are HEIC files as iPhones write them
dem/mountains.tif   the elevation model
truth.csv           the true heading of each photo, to compare with

In QGIS: click the plugin's button, choose the folder photos and the DEM mountains.tif, and press Run.
"""
COLUMNS = ("photo", "group", "latitude_deg", "longitude_deg", "gps_altitude_m", "focal_length_35mm")
COLUMNS += ("compass_heading_deg", "heading_deg", "pitch_deg", "roll_deg")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--zip", type=Path)
    given = parser.parse_args(arguments)
    rows = make_sample(given.folder, given.seed)
    print(f"{len(rows)} photographs, truth.csv and dem/mountains.tif in {given.folder}")
    if given.zip:
        size = pack_sample(given.folder, given.zip)
        print(f"{given.zip}: {size / 1e6:.1f} MB")


def make_sample(folder, seed=7):
    """Write DEM, photographs and truth; return the rows of truth."""
    folder = Path(folder)
    for name in ("dem", "photos"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    dem_path = str(folder / "dem" / "mountains.tif")
    terrain = make_mountains(seed, MOUNTAINS)
    write_dem(dem_path, terrain.elevation_m, MOUNTAINS.cell_m, MOUNTAINS.longitude_deg, MOUNTAINS.latitude_deg)
    dem = open_dem(dem_path)
    generator = np.random.Generator(np.random.PCG64(seed))
    rows = [take(folder, dem, generator, shot, seed) for shot in SHOTS]
    with open(folder / "truth.csv", "w", newline="", encoding="utf-8") as table:
        writer = csv.DictWriter(table, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    return rows


def pack_sample(folder, target):
    """Pack a sample into one zip with a short explanation; return its size [bytes].

    Raises
    ------
    SystemExit
        If the zip is too large to download at leisure.
    """
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        archive.writestr("skyline_sample/README.txt", EXPLANATION)
        for path in sorted(file for file in Path(folder).rglob("*") if file.is_file()):
            archive.write(path, Path("skyline_sample") / path.relative_to(folder))
    size = target.stat().st_size
    if size >= MOST_BYTES:
        target.unlink()
        raise SystemExit(f"The sample has {size / 1e6:.1f} MB; it must stay below {MOST_BYTES / 1e6:.0f} MB.")
    return size


def take(folder, dem, generator, shot, seed):
    """Take one photograph from a random place with a view; return its row of truth."""
    name, width, height, f35, hours, weather = shot
    camera = Camera(width, height, focal_from_35mm_px(width, height, f35))
    mountain = DetailedTerrain(dem, 3, seed, strength=0.6)
    options = ViewpointOptions(range_m=40_000.0, least_relief_deg=1.2, roll_sigma_deg=1.5, largest_roll_deg=3.0)
    observer, pose = find_view(dem, camera, generator, dem.position_of, options, mountain)
    when = NOON_UTC + timedelta(hours=hours)
    azimuth, elevation = sun_direction_deg(observer.longitude_deg, observer.latitude_deg, when)
    scene = SceneOptions(
        seed + len(name), sun_azimuth_deg=azimuth, sun_elevation_deg=elevation, range_m=45_000.0, **weather
    )
    view = render_view(mountain, observer, camera, pose, scene)
    compass = (pose.heading_deg + 12 * generator.random() - 6) % 360
    metadata = PhotoMetadata(
        "",
        width,
        height,
        latitude_deg=observer.latitude_deg,
        longitude_deg=observer.longitude_deg,
        altitude_m=round(view.eye_elevation_m, 1),
        altitude_reference="sea level",
        focal_length_35mm=float(f35),
        focal_length_mm=round(f35 * 0.22, 2),
        compass_heading_deg=compass,
        compass_reference="T",
        position_error_m=4.7,
        taken_at=when + timedelta(hours=2),
        camera="Skyline Simulated",
    )
    name = _write(folder / "photos", name, view.pixels, metadata)
    known = (observer.latitude_deg, observer.longitude_deg, view.eye_elevation_m, f35, compass)
    pose_deg = (pose.heading_deg, pose.pitch_deg, pose.roll_deg)
    return dict(zip(COLUMNS, (name, "good", *(round(value, 6) for value in known + pose_deg))))


def _write(folder, name, pixels, metadata):
    """Write a photograph, as JPEG if HEIC cannot be written here."""
    try:
        write_photo(str(folder / name), pixels, metadata, quality=90)
    except MissingPackageError:
        name = Path(name).with_suffix(".jpg").name
        write_photo(str(folder / name), pixels, metadata, quality=90)
    return name


if __name__ == "__main__":
    main()
