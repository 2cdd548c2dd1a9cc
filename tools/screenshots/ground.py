"""The look of the ground as second evidence: docs/images/ground.png.

A simulated photograph, and what the DEM's slopes, distance and height explain of it at the right heading and at a
wrong one, as `core/match/ground.py` weighs it.

Usage: ground.py SAMPLE TARGET
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import numpy as np
from PIL import Image
from publish import save_small
from skyline_viewshed.core.base.camera import Pose, unproject
from skyline_viewshed.core.base.imaging import thumbnail
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.figures.raster import TypeStyle, draw_words
from skyline_viewshed.core.horizon.inner import inner_terrain
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.match.ground import GroundEvidence
from skyline_viewshed.core.match.prior import camera_prior

SHOT = "morning"
"""Photograph of the sample that is shown."""
TURN_DEG = 30.0
"""How far the wrong heading is off."""
WIDTH, CAPTION = 480, 34


def main(sample, target):
    with open(sample / "truth.csv", newline="", encoding="utf-8") as file:
        truth = next(row for row in csv.DictReader(file) if row["photo"].startswith(SHOT))
    photo = read_photo(str(next((sample / "photos").glob(SHOT + "*"))), 1024)
    place = Observer(float(truth["longitude_deg"]), float(truth["latitude_deg"]), 1.7)
    ground = inner_terrain(open_dem(str(sample / "dem" / "mountains.tif")), place).ground
    picture = thumbnail(photo.pixels)
    camera = camera_prior(photo.metadata).camera.scaled(picture.shape[1], picture.shape[0])
    right = Pose(float(truth["heading_deg"]), float(truth["pitch_deg"]), float(truth["roll_deg"]))
    wrong = Pose(right.heading_deg + TURN_DEG, right.pitch_deg, right.roll_deg)
    panels = [panel(picture, f"Photograph, {picture.shape[1]} pixels wide")]
    for pose, name in ((right, "right heading"), (wrong, f"wrong one ({TURN_DEG:+.0f}°)")):
        trial = np.array([[pose.heading_deg, pose.pitch_deg, pose.roll_deg, 0.0, 0.0]])
        score = GroundEvidence(picture, ground).score(camera, trial)[0]
        panels.append(panel(explained(picture, ground, camera, pose), f"Explained at the {name}: score {score:.2f}"))
    save_small(Image.fromarray(np.concatenate(panels, axis=1)), target)


def explained(picture, ground, camera, pose):
    """The picture as a linear function of what the DEM shows at a pose; white where it shows nothing."""
    x, y = np.meshgrid(np.arange(camera.width_px, dtype=float), np.arange(camera.height_px, dtype=float))
    attributes = ground.at(*unproject(camera, pose, x, y))
    seen = np.isfinite(attributes).all(axis=0)
    known = np.concatenate([attributes[:, seen], [np.ones(seen.sum()), x[seen], y[seen]]]).T.astype(float)
    light = np.log1p(picture[seen].astype(float))
    out = np.full(picture.shape, 255.0)
    out[seen] = np.expm1(known @ np.linalg.lstsq(known, light, rcond=None)[0])
    return np.clip(out, 0, 255)


def panel(picture, words):
    """Enlarge a picture without smoothing it, with words below."""
    height = round(WIDTH * picture.shape[0] / picture.shape[1])
    large = Image.fromarray(np.rint(picture).astype(np.uint8)).resize((WIDTH - 8, height), Image.NEAREST)
    whole = np.full((height + CAPTION, WIDTH, 3), 255, np.uint8)
    whole[:height, : WIDTH - 8] = np.asarray(large)
    draw_words(whole, 4, height + 22, words, (20, 24, 32), TypeStyle(16, casing_px=0, bold=True))
    return whole


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
