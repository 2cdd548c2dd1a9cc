"""Draw the small pictures in the algorithms' help, icons/help/*.jpg, from the demo's sample; run after `make demo`."""

from __future__ import annotations

import csv
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "plugins"))
from skyline_viewshed.core.base.terrain import Observer, Window  # noqa: E402
from skyline_viewshed.core.batch import PhotoRequest, orient_request  # noqa: E402
from skyline_viewshed.core.figures.ground import (  # noqa: E402
    SeenGround,
    ground_map,
    three_panels,  # noqa: E402
)
from skyline_viewshed.core.figures.map import MapData, MapObserver, map_image  # noqa: E402
from skyline_viewshed.core.figures.overlay import overlay_image  # noqa: E402
from skyline_viewshed.core.figures.raster import draw_dot, draw_line, encode_jpeg, resized  # noqa: E402
from skyline_viewshed.core.io.raster import open_dem  # noqa: E402
from skyline_viewshed.core.viewshed.viewshed import PhotoFrame, ViewshedOptions, viewshed  # noqa: E402

SAMPLE = ROOT / "build" / "demo" / "sample"
OUT = ROOT / "icons" / "help"
WIDTH_PX = 420
PHOTO = "midday.jpg"
RED, BLUE, WHITE = (228, 87, 46), (40, 120, 200), (255, 255, 255)


def main():
    """Draw all pictures."""
    dem = open_dem(str(next((SAMPLE / "dem").glob("*.tif"))))
    photo = orient_request(PhotoRequest(str(SAMPLE / "photos" / PHOTO)), dem)
    OUT.mkdir(parents=True, exist_ok=True)
    save("extractskyline", overlay_image(replace(photo, orientation=empty(photo)), WIDTH_PX, legend=False))
    save("orientphotos", overlay_image(photo, WIDTH_PX, evidence=False, legend=False))
    save("simulatephotos", resized(photo.preview, WIDTH_PX, round(WIDTH_PX * 3 / 4)))
    save("measureoffsets", offsets(photo))
    save("horizonprofile", profile(photo))
    data = ground(photo, dem)
    save("directedviewshed", map_image(data, WIDTH_PX))
    save("photoviewshed", three_panels(overlay_image(photo, 500, legend=False), data, 220, captions=False))
    save("importphotos", stations(dem))


def save(name, pixels):
    """Write a picture no wider than `WIDTH_PX`."""
    height, width = pixels.shape[:2]
    if width > WIDTH_PX:
        pixels = resized(pixels, WIDTH_PX, round(height * WIDTH_PX / width))
    (OUT / f"{name}.jpg").write_bytes(encode_jpeg(pixels, 80))
    print(f"icons/help/{name}.jpg")


def empty(photo):
    """Return the photo's orientation without an answer."""
    return replace(photo.orientation, candidates=())


def offsets(photo):
    """Draw two skylines and the pairs between them."""
    pixels = resized(photo.preview, WIDTH_PX, round(WIDTH_PX * 3 / 4)).copy()
    scale = WIDTH_PX / len(photo.skyline.row_px)
    x, y = np.arange(len(photo.skyline.row_px)) * scale, np.asarray(photo.skyline.row_px) * scale
    moved = y - 9 + 5 * np.sin(x / 60)
    draw_line(pixels, x, y, BLUE, 2)
    draw_line(pixels, x + 5, moved, RED, 2)
    for at in (0.2, 0.5, 0.8):
        k = int(at * len(x))
        draw_line(pixels, np.array([x[k], x[k] + 5]), np.array([y[k], moved[k]]), WHITE, 2)
        draw_dot(pixels, x[k], y[k], 3.5, BLUE)
        draw_dot(pixels, x[k] + 5, moved[k], 3.5, RED)
    return pixels


def profile(photo):
    """Draw the elevation angle of the horizon over the full circle."""
    height = 170
    pixels = np.full((height, WIDTH_PX, 3), 246, np.uint8)
    horizon = photo.horizon
    low, high = np.nanmin(horizon.elevation_deg) - 2, np.nanmax(horizon.elevation_deg) + 2
    x = horizon.azimuth_deg / 360 * WIDTH_PX
    y = height - (horizon.elevation_deg - low) / (high - low) * height
    fill = np.arange(height)[:, None] > np.interp(np.arange(WIDTH_PX), x, y)[None, :]
    pixels[fill] = (196, 208, 214)
    level = height - (0 - low) / (high - low) * height
    draw_line(pixels, np.array([0, WIDTH_PX]), np.array([level, level]), (120, 130, 140), 1)
    draw_line(pixels, x, y, RED, 2)
    return pixels


def ground(photo, dem):
    """Draw a map cut to the ground in the photo."""
    observer = Observer(photo.longitude_deg, photo.latitude_deg, eye_elevation_m=photo.eye_elevation_m)
    pose = photo.orientation.best.pose
    found = viewshed(dem, observer, PhotoFrame(photo.camera, pose), ViewshedOptions(max_distance_m=14_000))
    eye = MapObserver(found.frame.col_px, found.frame.row_px, pose.heading_deg, photo.camera.hfov_deg)
    return ground_map(dem, found.frame, SeenGround(found.window, found.values), [eye])


def stations(dem):
    """Draw a map of the places where the photographs were taken."""
    with open(SAMPLE / "truth.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    eyes = []
    for row in rows:
        col_px, row_px = dem.pixel_of(float(row["longitude_deg"]), float(row["latitude_deg"]))
        eyes.append(MapObserver(float(col_px), float(row_px), label=Path(row["photo"]).stem))
    frame = dem.frame(*dem.position_of(dem.shape[1] / 2, dem.shape[0] / 2), 1000.0)
    data = MapData(dem.read(Window(0, 0, *dem.shape)), frame.cell_size_m, frame.convergence_deg, None, tuple(eyes))
    return map_image(data, 560)


if __name__ == "__main__":
    main()
