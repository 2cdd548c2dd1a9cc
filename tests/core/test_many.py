"""Photographs of a walk that are oriented again with hints from their neighbours."""

from __future__ import annotations

import pytest
from skyline_viewshed.core import api, many
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.joint.pairs import Tie
from skyline_viewshed.core.joint.ties import axes_of
from skyline_viewshed.core.pipeline import OrientOptions
from skyline_viewshed.core.workers.pool import Outcome
from worker_jobs import Hinted

GIVEN_DEG = 250.0


def tie(one, other, turn_deg):
    return Tie(one, other, axes_of(Pose(turn_deg)) @ axes_of(Pose(0.0)).T, 0.4)


@pytest.fixture
def ties(monkeypatch):
    """Features tie the first photograph, whose heading is given, to the two after it."""
    monkeypatch.setattr(many, "ties_between", lambda photos, progress: [tie(0, 1, 140.0), tie(0, 2, 60.0)])


def asked(*given):
    given = (GIVEN_DEG, *given, *[None] * (2 - len(given)))
    requests = [PhotoRequest(f"{k}.jpg", heading_deg=heading) for k, heading in enumerate(given)]
    return [*[(request, None) for request in requests], (None, None)]


def orient_all(tasks, progress):
    work = Hinted(None, None)()
    return [Outcome(work(task, progress)) for task in tasks]


def alone(tasks):
    return [Hinted.answer(request.path if request else "", request and request.heading_deg) for request, _ in tasks]


def headings(photos):
    return [round(photo.heading_deg) for photo in photos]


def test_those_of_which_others_predict_another_heading_are_oriented_again(ties):
    tasks, looked = asked(), []

    def noted(tasks, progress):
        looked.extend(request for request, _ in tasks)
        return orient_all(tasks, progress)

    photos = alone(tasks)
    found = many.look_again(tasks, photos, noted, SILENT)
    assert headings(found) == [250, 30, 310, 200]
    assert [photo.status for photo in found] == ["accepted"] * 3 + ["ambiguous"]
    assert found[0] is photos[0] and found[3] is photos[3]
    assert [request.path for request in looked] == ["1.jpg", "2.jpg"]
    assert [abs(difference(request.heading_deg, at)) < 0.5 for request, at in zip(looked, (30, 310))] == [True, True]
    assert all("shares" in photo.orientation.notes[-1] for photo in found[1:3])


def test_a_heading_that_the_user_has_given_is_not_replaced(ties):
    tasks = asked(100.0)
    photos = alone(tasks)
    found = many.look_again(tasks, photos, orient_all, SILENT)
    assert found[0] is photos[0] and found[1] is photos[1] and headings(found)[1] == 100


def test_an_error_of_the_second_look_leaves_the_pose_of_the_tie(ties):
    tasks = asked()
    found = many.look_again(tasks, alone(tasks), lambda tasks, part: [Outcome(error=PhotoError("gone"))] * 2, SILENT)
    assert headings(found) == [250, 30, 310, 200]


def test_a_compass_that_each_has_used_already_is_not_used_again(ties, monkeypatch):
    used = []

    def solved(photos, alones, ties, with_compass):
        used.append(with_compass)
        return [None] * len(photos)

    monkeypatch.setattr(many, "beliefs", solved)
    tasks = asked()
    for compass in ("ignore", "prior"):
        many.look_again(tasks, alone(tasks), orient_all, SILENT, OrientOptions(compass=compass))
    assert used == [True, False]


def test_a_fault_of_ours_leaves_each_photograph_its_own_answer_in_python_too(monkeypatch, caplog):
    def broken(*_):
        raise RuntimeError("a matrix is singular")

    monkeypatch.setattr(api, "OrientJob", Hinted)
    monkeypatch.setattr(many, "look_again", broken)
    found = list(api.orient_many(["0.jpg", "1.jpg"], None, joint=True))
    assert headings(found) == headings(api.orient_many(["0.jpg", "1.jpg"], None))
    assert "a matrix is singular" in caplog.text


def test_in_python_the_progress_of_both_attempts_never_goes_back(monkeypatch):
    # The second and the third of three photographs are tied; which of them is right stays open.
    monkeypatch.setattr(api, "OrientJob", Hinted)
    monkeypatch.setattr(many, "ties_between", lambda photos, progress: [tie(1, 2, 60.0)])
    monkeypatch.setattr("skyline_viewshed.core.joint.hints.LEAST_PROBABILITY", 0.05)
    told = []
    found = list(api.orient_many(["0.jpg", "1.jpg", "2.jpg"], None, joint=True, progress=told.append))
    assert [photo.status for photo in found] == ["ambiguous"] * 3
    assert told == sorted(told) and told[-1] == 1.0 and any(0 < fraction < many.JOINT_PART for fraction in told)
