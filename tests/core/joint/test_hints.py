"""What accepted photographs tell about others, and that nothing gets worse."""

from __future__ import annotations

from datetime import datetime, timedelta

import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.model import Candidate, Orientation, OrientedPhoto, PhotoMetadata
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.joint.hints import better, neighbour_hints

CAMERA = Camera(800, 600, 700.0)


def photo(name, status, heading, compass=None, minutes=0, camera="Phone"):
    metadata = PhotoMetadata(
        name, 800, 600, taken_at=datetime(2023, 10, 31, 9) + timedelta(minutes=minutes), camera=camera
    )
    candidates = () if heading is None else (Candidate(Pose(heading, 0.0, 0.0), CAMERA, 1.0),)
    answer = Orientation(status, "", candidates)
    return OrientedPhoto(name, answer, metadata, camera=CAMERA, compass_true_deg=compass)


def walk(*others):
    return [photo("a.jpg", "accepted", 358.0, 3.0), photo("b.jpg", "accepted", 100.0, 104.0, 10), *others]


def test_the_compass_is_corrected_by_its_error_at_accepted_photographs():
    hints = neighbour_hints(walk(photo("x.jpg", "ambiguous", 250.0, 2.0, 30)))
    assert list(hints) == [2] and hints[2].heading_deg == pytest.approx(357.5) and 4 < hints[2].sigma_deg < 6
    assert "a.jpg" in hints[2].note and "4.5°" in hints[2].note
    request = hints[2].applied(PhotoRequest("x.jpg"))
    assert request.heading_deg == hints[2].heading_deg and request.heading_tolerance_deg == 2 * hints[2].sigma_deg


@pytest.mark.parametrize(
    "photos",
    [
        walk(photo("x.jpg", "ambiguous", 250.0, 2.0, 90)),
        walk(photo("x.jpg", "ambiguous", 250.0, 2.0, 5, "Other phone")),
        walk(photo("x.jpg", "ambiguous", 250.0, None, 5)),
        walk(photo("x.jpg", "failed", None, 2.0, 5)),
        walk(photo("c.jpg", "accepted", 10.0, 100.0, 5), photo("x.jpg", "ambiguous", 250.0, 2.0, 6))[1:],
        walk(photo("x.jpg", "ambiguous", 250.0, 2.0, 5))[1:],
    ],
    ids=["an hour later", "another camera", "no compass", "failed", "the errors disagree", "one reading"],
)
def test_where_nothing_is_shared_there_is_no_hint(photos):
    assert neighbour_hints(photos) == {}


@pytest.mark.parametrize(
    "alone, again, taken",
    [
        (("ambiguous", 250.0), ("accepted", 357.0), True),
        (("ambiguous", 356.0), ("accepted", 357.0), True),
        (("ambiguous", 356.0), ("ambiguous", 357.5), False),
        (("ambiguous", 250.0), ("ambiguous", 357.5), True),
        (("ambiguous", 250.0), ("ambiguous", 90.0), False),
        (("rejected", None), ("ambiguous", 357.5), True),
        (("ambiguous", 250.0), ("rejected", None), False),
    ],
)
def test_no_answer_is_lost(alone, again, taken):
    hint = neighbour_hints(walk(photo("x.jpg", "ambiguous", 250.0, 2.0, 30)))[2]
    alone, again = (photo("x.jpg", *values, 2.0, 30) for values in (alone, again))
    chosen = better(alone, again, hint)
    assert (chosen is alone) != taken
    if taken:
        assert chosen.heading_deg == again.heading_deg and chosen.orientation.notes[-1] == hint.note
