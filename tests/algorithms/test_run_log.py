"""The log of a run: each photo with verdict and heading, the time left, and the doubtful ones by name."""

from __future__ import annotations

import pytest
from skyline_viewshed.algorithms.shared.run_log import RunLog, time_left
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.model import Candidate, Orientation

pytestmark = pytest.mark.qgis


def answer(status, heading=None):
    candidates = () if heading is None else (Candidate(Pose(heading, 1.0, 0.0), Camera(800, 600, 700.0), 1.0, 0.9),)
    return Orientation(status, "reason", candidates)


def test_each_photo_has_verdict_heading_and_time_left_and_the_doubtful_are_named_at_the_end(listener):
    feedback, now = listener(), [0.0]
    log = RunLog(feedback, 4, lambda: now[0])
    given = {"a.jpg": answer("accepted", 359.96), "b.jpg": answer("ambiguous", 12.0), "c.jpg": answer("failed")}
    for name, orientation in {**given, "d.jpg": answer("ambiguous", 200.0)}.items():
        log.start(name)
        now[0] += 60
        log.answer(name, orientation)
    log.end()
    assert feedback.texts == [
        "a.jpg (1/4)",
        "b.jpg (2/4), about 3 min left",
        "c.jpg (3/4), about 2 min left",
        "d.jpg (4/4), about 60 s left",
    ]
    assert feedback.infos[:3] == [
        "a.jpg: accepted, heading 0.0°",
        "b.jpg: ambiguous, heading 12.0°",
        "d.jpg: ambiguous, heading 200.0°",
    ]
    assert feedback.warnings == ["c.jpg: reason"]
    assert feedback.infos[3:] == ["Check these photos (ambiguous): b.jpg, d.jpg", "Check these photos (failed): c.jpg"]


def test_a_better_answer_takes_the_place_of_the_first(listener):
    feedback = listener()
    log = RunLog(feedback, 3)
    first = {"a.jpg": answer("accepted", 5.0), "b.jpg": answer("ambiguous", 12.0), "c.jpg": answer("rejected", 9.0)}
    for name, orientation in first.items():
        log.answer(name, orientation)
    log.revise("b.jpg", first["b.jpg"], answer("accepted", 77.0))
    log.revise("c.jpg", first["c.jpg"], answer("ambiguous", 78.0))
    log.end()
    assert feedback.infos[3:] == [
        "b.jpg: accepted, heading 77.0°",
        "c.jpg: ambiguous, heading 78.0°",
        "Check these photos (ambiguous): c.jpg",
    ]


def test_a_long_list_is_cut_and_counted(listener):
    feedback = listener()
    log = RunLog(feedback, 60)
    for number in range(60):
        log.answer(f"{number}.jpg", answer("ambiguous", 1.0))
    log.end()
    assert feedback.infos[-1].endswith("49.jpg and 10 more")


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(1, "about 5 s left"), (83, "about 85 s left"), (100, "about 2 min left"), (7200, "about 2.0 h left")],
)
def test_the_time_left_is_as_coarse_as_it_is_known(seconds, words):
    assert time_left(seconds) == words
