"""Simulated scenes from easy to impossible, with what the program says to each: docs/images/failures.png.

Usage: failures.py SAMPLE TARGET
"""

from __future__ import annotations

import csv
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image
from publish import save_small
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.batch import PhotoRequest, orient_request
from skyline_viewshed.core.figures.overlay import overlay_image
from skyline_viewshed.core.figures.raster import TypeStyle, draw_words
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.simulate.detail import DetailedTerrain
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions

WIDTH, HEIGHT = 720, 480
CAPTION = 62
SEED = 11
SHOT = "morning"
"""Photograph of the sample from whose place, and in whose direction, all scenes are taken."""
SCENES = (
    # title, 35 mm equivalent, tilt against that photograph, weather
    ("clear, wide", 26, 0.0, {}),
    ("half of the ridge in cloud", 26, 0.0, {"clouds": "lid", "cloud_share": 0.5}),
    ("clear, long lens (120 mm)", 120, -5.5, {}),
    ("fog", 26, 0.0, {"clouds": "fog"}),
)


def main(sample, target):
    dem = open_dem(str(sample / "dem" / "mountains.tif"))
    with open(sample / "truth.csv", newline="", encoding="utf-8") as file:
        truth = next(row for row in csv.DictReader(file) if row["photo"].startswith(SHOT))
    with tempfile.TemporaryDirectory() as folder:
        panels = [panel(dem, truth, Path(folder) / f"{index}.jpg", *scene) for index, scene in enumerate(SCENES)]
    rows = [np.concatenate(panels[i : i + 2], axis=1) for i in (0, 2)]
    save_small(Image.fromarray(np.concatenate(rows)), target)


def panel(dem, truth, path, title, f35, tilt_deg, weather):
    """Take, orient and draw one scene."""
    camera = Camera(WIDTH, HEIGHT, focal_from_35mm_px(WIDTH, HEIGHT, f35))
    observer = Observer(float(truth["longitude_deg"]), float(truth["latitude_deg"]), 1.7)
    pose = Pose(float(truth["heading_deg"]), float(truth["pitch_deg"]) + tilt_deg, float(truth["roll_deg"]))
    scene = replace(SceneOptions(SEED, range_m=45_000.0), **weather)
    view = render_view(DetailedTerrain(dem, 3, SEED, strength=0.2), observer, camera, pose, scene)
    place = {"longitude_deg": observer.longitude_deg, "latitude_deg": observer.latitude_deg}
    write_photo(str(path), view.pixels, PhotoMetadata(str(path), WIDTH, HEIGHT, focal_length_35mm=float(f35), **place))
    oriented = orient_request(PhotoRequest(str(path)), dem)
    answer = oriented.orientation
    if oriented.preview is None:
        oriented = replace(oriented, preview=view.pixels)
    picture = overlay_image(oriented, WIDTH, legend=False)
    whole = np.full((HEIGHT + CAPTION, WIDTH, 3), 255, np.uint8)
    whole[:HEIGHT] = picture
    error = "no heading"
    if answer.best is not None:
        error = f"error {(answer.best.pose.heading_deg - pose.heading_deg + 180) % 360 - 180:+.1f}°"
    draw_words(
        whole, 8, HEIGHT + 24, f"{title}: {answer.status}, {error}", (20, 24, 32), TypeStyle(19, casing_px=0, bold=True)
    )
    draw_words(whole, 8, HEIGHT + 48, shortened(answer.message), (70, 76, 86), TypeStyle(14, casing_px=0))
    return whole


def shortened(message, longest=96):
    """First sentence of a message, or as much of it as fits."""
    first = message.split(". ")[0].rstrip(".") + "."
    return first if len(first) <= longest else first[:longest].rsplit(" ", 1)[0] + " ..."


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
