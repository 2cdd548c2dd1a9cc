"""Values that cross stages: frozen, and empty where nothing is known."""

from __future__ import annotations

import dataclasses
import inspect

import numpy as np
import pytest
from skyline_viewshed.core.base import model
from skyline_viewshed.core.base.camera import Camera, Pose

CLASSES = [
    thing for _, thing in inspect.getmembers(model, dataclasses.is_dataclass) if thing.__module__ == model.__name__
]


def test_all_values_are_frozen():
    assert len(CLASSES) >= 8
    assert [c.__name__ for c in CLASSES if not c.__dataclass_params__.frozen] == []


def test_what_a_photo_does_not_say_is_none_and_not_zero():
    facts = dataclasses.asdict(model.PhotoMetadata("a.jpg", 400, 300))
    known = {name for name, value in facts.items() if value is not None}
    assert known == {"path", "width_px", "height_px", "focal_sigma", "orientation", "notes", "panorama"}
    photo = model.OrientedPhoto("a.jpg", model.Orientation("failed", "No position."))
    said = {field.name for field in dataclasses.fields(photo) if getattr(photo, field.name) is not None}
    assert said == {"path", "orientation"}


def test_the_best_answer_is_the_first_and_there_may_be_none():
    camera = Camera(400, 300, 350.0)
    first, second = (model.Candidate(Pose(heading), camera, score) for heading, score in ((10.0, 1.0), (20.0, 9.0)))
    assert model.Orientation("accepted", "", (first, second)).best is first
    assert model.Orientation("failed", "No skyline.").best is None


def test_columns_without_confidence_are_not_valid():
    skyline = model.Skyline(np.full(4, 7.0), np.array([0.0, 1e-6, 0.5, 1.0]), 4, 20)
    assert skyline.valid.tolist() == [False, True, True, True]


def test_two_orientations_do_not_share_their_curve():
    one, other = model.Orientation("failed", ""), model.Orientation("failed", "")
    assert one.curve_score is not other.curve_score and one.curve_score.size == 0
    with pytest.raises(dataclasses.FrozenInstanceError):
        one.status = "accepted"
