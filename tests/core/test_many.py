"""Photographs of a walk that are oriented again with hints from their neighbours."""

from __future__ import annotations

import pytest
from skyline_viewshed.core import api, many
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.base.messages import Message
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.joint.hints import NeighbourHint
from skyline_viewshed.core.workers.pool import Outcome
from worker_jobs import Hinted

HINT = NeighbourHint(30.0, 5.0, Message("A neighbour helped."))


@pytest.fixture
def hints(monkeypatch):
    """Hints for the second and the third photograph."""
    monkeypatch.setattr(many, "neighbour_hints", lambda photos: {1: HINT, 2: HINT})


def asked(given=None):
    return [(None, None), (PhotoRequest("1.jpg"), None), (PhotoRequest("2.jpg", heading_deg=given), None)]


def orient_all(tasks, progress):
    work = Hinted(None, None)()
    return [Outcome(work(task, progress)) for task in tasks]


def alone(tasks):
    return [Hinted.answer("", None), *(Hinted.answer(request.path, None) for request, _ in tasks[1:])]


def test_those_with_a_hint_are_oriented_again(hints):
    tasks = asked()
    photos = alone(tasks)
    found = many.look_again(tasks, photos, orient_all, SILENT)
    assert found[0] is photos[0] and [photo.status for photo in found[1:]] == ["accepted"] * 2
    assert [photo.heading_deg for photo in found[1:]] == [30.0, 30.0]
    assert found[1].orientation.notes == (HINT.note,)


def test_a_heading_that_the_user_has_given_is_not_replaced(hints):
    tasks = asked(given=250.0)
    photos = alone(tasks)
    found = many.look_again(tasks, photos, orient_all, SILENT)
    assert found[1].status == "accepted" and found[2] is photos[2]


def test_an_error_of_the_second_attempt_keeps_the_first_answer(hints):
    tasks = asked()
    photos = alone(tasks)
    found = many.look_again(tasks, photos, lambda tasks, part: [Outcome(error=PhotoError("gone"))] * 2, SILENT)
    assert all(after is before for before, after in zip(photos, found))


def test_in_python_the_progress_of_both_attempts_never_goes_back(hints, monkeypatch):
    monkeypatch.setattr(api, "OrientJob", Hinted)
    told = []
    found = list(api.orient_many(["0.jpg", "1.jpg", "2.jpg"], None, joint=True, progress=told.append))
    assert [photo.status for photo in found] == ["ambiguous", "accepted", "accepted"]
    assert told == sorted(told) and told[-1] == 1.0 and any(0 < fraction < many.JOINT_PART for fraction in told)
