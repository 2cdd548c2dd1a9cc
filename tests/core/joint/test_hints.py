"""Where a photograph is looked at again."""

from __future__ import annotations

import pytest
from joint_walks import photo
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.joint.circle import mixture
from skyline_viewshed.core.joint.hints import NeighbourHint, predictions
from skyline_viewshed.core.joint.together import Belief


def belief(heading, probability, sigma=2.0, **helpers):
    density = mixture([heading], [sigma], [probability])
    return Belief(density, heading, probability, pose=Pose(heading), **(helpers or {"tied": (0,)}))


def test_a_predicted_heading_becomes_a_hint_with_its_spread():
    hints = predictions([photo("a.jpg", "ambiguous", [(250.0, 0.3)])], [belief(60.0, 0.9)])
    assert list(hints) == [0] and hints[0].heading_deg == 60.0 and hints[0].sigma_deg == pytest.approx(2.0, rel=0.2)
    request = hints[0].applied(PhotoRequest("a.jpg"))
    assert request.heading_deg == 60.0 and request.heading_tolerance_deg == 2 * hints[0].sigma_deg


@pytest.mark.parametrize(
    "own, known",
    [
        ([(61.0, 0.3)], belief(60.0, 0.9)),
        ([(250.0, 0.3)], belief(60.0, 0.2)),
        ([(250.0, 0.3)], belief(60.0, 0.9, tied=())),
        ([(250.0, 0.3)], None),
    ],
    ids=["its own answer", "too unlikely", "nobody helped", "takes no part"],
)
def test_no_second_look_is_needed(own, known):
    assert predictions([photo("a.jpg", "ambiguous", own)], [known]) == {}


def test_the_hint_itself_is_no_answer_of_the_picture():
    hint = NeighbourHint(60.0, 1.0)
    assert hint.found_in(photo("a.jpg", "ambiguous", [(60.0, 0.6), (250.0, 0.2)])) is None
    assert hint.found_in(photo("a.jpg", "ambiguous", [(60.0, 0.6), (61.0, 0.2)])).pose.heading_deg == 61.0
