"""Photographs of invented walks, without pictures: what is known of them after each has been oriented alone."""

from __future__ import annotations

from datetime import datetime, timedelta

import numpy as np
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.model import Candidate, HorizonProfile, Orientation, OrientedPhoto, PhotoMetadata
from skyline_viewshed.core.base.uncertainty import PoseUncertainty

CAMERA = Camera(800, 600, 700.0)


def photo(name, status, answers=(), compass=None, minutes=0.0, **facts):
    """Give a photograph; `answers` are (heading, probability), best first, and each has a spread of half a degree."""
    camera = facts.pop("camera", CAMERA)
    metadata = PhotoMetadata(
        name, camera.width_px, camera.height_px, taken_at=datetime(2023, 10, 31, 9) + timedelta(minutes=minutes),
        camera=facts.pop("device", "Phone"), focal_length_35mm=facts.pop("focal_length_35mm", None),
    )  # fmt: skip
    candidates = tuple(
        Candidate(Pose(heading, 2.0, 0.0), camera, 1.0 - 0.1 * rank, share, 0.5)
        for rank, (heading, share) in enumerate(answers)
    )
    answer = Orientation(
        status, "", candidates, p_correct=answers[0][1] if answers else None, uncertainty=PoseUncertainty()
    )
    return OrientedPhoto(name, answer, metadata, camera=camera, compass_true_deg=compass, **facts)


def horizon_at(distance_m, cell_m=90.0):
    """Give a horizon at a distance: a number, or one for each degree of azimuth [m]."""
    none = np.zeros(360, bool)
    distance = np.array(np.broadcast_to(np.asarray(distance_m, float), 360))
    return HorizonProfile(
        np.arange(360.0), np.full(360, 5.0), distance, none, none, 4000.0, cell_m, np.full(360, 1e5)
    )  # fmt: skip
