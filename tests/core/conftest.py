"""Scenes with exact truth for matching and for drawing: a random horizon, a camera, the evidence that it would see."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose, project
from skyline_viewshed.core.base.model import (
    Candidate,
    HorizonProfile,
    Orientation,
    OrientedPhoto,
    PhotoMetadata,
    Skyline,
    SkylineEvidence,
)
from skyline_viewshed.core.match.geometry import HorizonCurve
from skyline_viewshed.core.match.inputs import MatchInputs
from skyline_viewshed.core.match.likelihood import EvidenceStack
from skyline_viewshed.core.match.prior import CameraPrior
from skyline_viewshed.core.match.refine import Objective


@dataclass(frozen=True)
class MatchScene:
    """A photographed horizon: what the matcher gets, and what it should find."""

    horizon: HorizonProfile
    camera: Camera
    pose: Pose
    evidence: SkylineEvidence
    row_px: np.ndarray

    def inputs(self, **facts):
        """What a match takes of it."""
        return MatchInputs(self.evidence, CameraPrior(self.camera), self.horizon, **facts)

    @property
    def small_camera(self):
        """Of the reduced picture."""
        return self.inputs().reduced_prior.camera

    def objective(self, focal_sigma=0.025, **facts):
        """Score of trials against its evidence."""
        prior = CameraPrior(self.small_camera, focal_sigma)
        return Objective(EvidenceStack(self.evidence.probability), prior, HorizonCurve(self.horizon), **facts)


def random_horizon(seed, cell_m=30.0, step_deg=0.1):
    """A smooth random horizon from 2 to 14 degrees, at 5 to 25 km."""
    rng = np.random.default_rng(seed)
    azimuth = np.arange(0, 360, step_deg)
    elevation = np.full(azimuth.shape, 7.0)
    for waves in range(1, 60):
        elevation += rng.normal() * 3 / waves**0.9 * np.cos(np.radians(waves * azimuth) + rng.uniform(0, 6.3))
    distance = 15_000 + 10_000 * np.cos(np.radians(3 * azimuth))
    no = np.zeros(azimuth.shape, bool)
    return HorizonProfile(azimuth, elevation, distance, no, no, 1000.0, cell_m, np.full(azimuth.shape, 60_000.0))


def seen_rows(horizon, camera, pose):
    """Row of the horizon in each column, by dense projection and interpolation: independent of the matcher's."""
    azimuth = pose.heading_deg + np.arange(-80, 80, 0.01)
    elevation = np.interp(azimuth, horizon.azimuth_deg, horizon.elevation_deg, period=360)
    x, y = project(camera, pose, azimuth, elevation)
    seen = np.isfinite(x) & (np.abs(x - camera.width_px / 2) < 2 * camera.width_px)
    order = np.argsort(x[seen])
    return np.interp(np.arange(camera.width_px), x[seen][order], y[seen][order])


def evidence_of_rows(row_px, width_px, height_px, full_size, sigma_px=1.0, floor=1e-3):
    """A Gaussian per column around the first terrain row (half a pixel below the boundary), flat where outside."""
    row = np.arange(height_px)[:, None]
    probability = np.exp(-0.5 * ((row - row_px - 0.5) / sigma_px) ** 2) + floor
    inside = (row_px >= 0) & (row_px <= height_px - 1)
    probability = np.where(inside, probability, 1.0)
    probability /= probability.sum(axis=0)
    best = Skyline(row_px + 0.5, inside.astype(float), width_px, height_px)
    return SkylineEvidence(probability.astype(np.float32), best, *full_size)


def scene(seed=1, heading_deg=123.4, pitch_deg=3.0, roll_deg=1.5, hfov_deg=50.0, k1=0.0, focal_scale=1.0):
    """Photograph a random horizon."""
    horizon = random_horizon(seed)
    width, height = 256, 192
    focal = width / 2 / np.tan(np.radians(hfov_deg) / 2)
    pose = Pose(heading_deg, pitch_deg, roll_deg)
    rows = seen_rows(horizon, Camera(width, height, focal * focal_scale, k1=k1), pose)
    full = Camera(4 * width, 4 * height, 4 * focal)
    evidence = evidence_of_rows(rows, width, height, (full.width_px, full.height_px))
    return MatchScene(horizon, full, pose, evidence, rows)


@pytest.fixture(scope="session")
def match_scenes():
    """The makers of matching scenes: random_horizon, seen_rows, evidence_of_rows, scene."""
    return SimpleNamespace(
        random_horizon=random_horizon, seen_rows=seen_rows, evidence_of_rows=evidence_of_rows, scene=scene
    )


def painted_photo(status="accepted", path="/photos/IMG_0001.HEIC", heading_deg=123.4, hfov_deg=50.0, **changes):
    """An oriented photograph of a random horizon with everything that figures and reports may draw."""
    seen = scene(seed=5, heading_deg=heading_deg, hfov_deg=hfov_deg)
    width, height = 256, 192
    rows = np.arange(height)[:, None]
    sky, ground = np.array([150, 185, 225]), np.array([92, 84, 70])
    depth = np.clip((rows - seen.row_px) / height, 0, 1)[..., None]
    picture = np.where(
        (rows >= seen.row_px)[..., None], ground * (1 - 0.5 * depth), sky - 30 * rows[..., None] / height
    )
    curve = np.arange(0, 360, 0.5)
    away = np.abs((curve - heading_deg + 180) % 360 - 180)
    score = 4 * np.exp(-((away / 3) ** 2)) + 1 + 0.5 * np.sin(np.radians(5 * curve))
    poses = [seen.pose, Pose((heading_deg + 117) % 360, 2.0, 0.5), Pose((heading_deg + 200) % 360, 4.0, -1.0)]
    candidates = [Candidate(pose, seen.camera, 5.0 - rank, (0.97, 0.02, 0.01)[rank]) for rank, pose in enumerate(poses)]
    orientation = Orientation(
        status,
        "The horizon fits along the whole skyline.",
        tuple(candidates),
        (heading_deg - 0.4) % 360,
        (heading_deg + 0.4) % 360,
        0.97,
        curve,
        score,
        0.95,
        0.71,
        3.2,
        np.sin(np.arange(width) / 20) * 3,
        ("The eye lies 12 m above the DEM.",),
    )
    camera = seen.camera
    metadata = PhotoMetadata(
        path, camera.width_px, camera.height_px, 46.5, 8.0, altitude_m=2000.0, altitude_reference="sea level",
        focal_length_35mm=24.0, compass_heading_deg=121.0, compass_reference="T", position_error_m=5.0,
        taken_at=datetime(2024, 7, 1, 6, 30), camera="Maker Model",
    )  # fmt: skip
    photo = OrientedPhoto(
        path, orientation, metadata, picture.astype(np.uint8), camera, seen.evidence.best, seen.evidence, seen.horizon,
        8.0, 46.5, 2001.7, 2000.0, 0.7, 121.0,
    )  # fmt: skip
    return replace(photo, **changes)


@pytest.fixture(scope="session")
def painted():
    """The maker of oriented photographs with full contents; keywords replace fields of the `OrientedPhoto`."""
    return painted_photo


GOLDEN = Path(__file__).resolve().parent.parent / "golden"
BLOCK_PX = 4


def block_means(pixels):
    """Means of 4 x 4 blocks: type and smoothing may differ by a pixel from one Pillow to the next."""
    height, width = (side - side % BLOCK_PX for side in pixels.shape[:2])
    blocks = pixels[:height, :width].reshape(height // BLOCK_PX, BLOCK_PX, width // BLOCK_PX, BLOCK_PX, -1)
    return blocks.mean(axis=(1, 3), dtype=float)


@pytest.fixture(scope="session")
def golden_difference():
    """Give (mean, 99.5th percentile) difference of a picture from its golden file, in levels of 255.

    With SKYLINE_GOLDEN=write in the environment the files are written anew: look at each of them before committing.
    """
    image = pytest.importorskip("PIL.Image")

    def difference(name, pixels):
        path = GOLDEN / f"{name}.png"
        if os.environ.get("SKYLINE_GOLDEN") == "write":
            path.parent.mkdir(exist_ok=True)
            image.fromarray(pixels).save(path, optimize=True)
        stored = np.asarray(image.open(path).convert("RGB"))
        assert stored.shape == pixels.shape
        apart = np.abs(block_means(stored) - block_means(pixels))
        return float(apart.mean()), float(np.percentile(apart, 99.5))

    return difference
