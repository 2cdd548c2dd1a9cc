from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, project, unproject
from skyline_viewshed.core.base.model import Candidate, Orientation
from skyline_viewshed.core.match.landmarks import (
    Landmark,
    contradicting,
    landmark_notes,
    match_with_landmarks,
    scale_landmarks,
    starting_pose,
)
from skyline_viewshed.core.match.robust import RobustOptions, match_robust

FULL = Camera(4000, 3000, 3500.0)


@settings(max_examples=40, deadline=None)
@given(st.floats(0, 359), st.floats(-30, 30), st.floats(100, 3900), st.floats(100, 2900))
def test_one_landmark_gives_heading_and_pitch_of_a_level_camera(heading, pitch, x, y):
    azimuth, elevation = unproject(FULL, Pose(heading, pitch), x, y)
    start = starting_pose(FULL, Landmark(x, y, float(azimuth), float(elevation)))
    assert abs((start.heading_deg - heading + 180) % 360 - 180) < 0.2
    assert abs(start.pitch_deg - pitch) < 0.2


def test_landmarks_keep_their_place_on_the_reduced_picture():
    (mark,) = scale_landmarks([Landmark(-0.5, 2999.5, 10.0, 2.0, 8.0)], FULL, FULL.scaled(500, 375))
    assert (mark.x_px, mark.y_px) == (-0.5, 374.5)  # the picture's corner stays its corner
    assert mark.sigma_px == pytest.approx(np.hypot(1.0, 0.5))


def test_notes_say_by_how_much_each_landmark_is_missed():
    pose = Pose(20.0, 5.0)
    x, y = project(FULL, pose, 25.0, 7.0)
    marks = [Landmark(float(x) + 30, float(y) + 40, 25.0, 7.0), Landmark(10.0, 10.0, 200.0, 0.0)]
    near, behind = landmark_notes(marks, FULL, pose)
    assert "50 pixels" in near
    assert "180 degrees" in behind


def test_a_landmark_that_contradicts_a_clear_skyline_is_reported_and_not_believed(match_scenes):
    """A pixel 18 degrees from where the map point is seen would turn the heading by as much, and be accepted."""
    scene = match_scenes.scene(9, 222.0, 4.0, 2.0)
    right, wrong = seen_at(scene, 236.0, 8.0), replace(seen_at(scene, 210.0, 5.0), azimuth_deg=228.0)
    for marks, number, used in (((wrong,), 1, ()), ((right, wrong), 2, ("Landmark 1 lies",))):
        found = match_with_landmarks(match_robust, scene.inputs(landmarks=marks), RobustOptions())
        assert found.status == "accepted"
        assert abs((found.best.pose.heading_deg - 222.0 + 180) % 360 - 180) < 0.5
        told = [note for note in found.notes if "contradicts" in note]
        assert len(told) == 1 and f"Landmark {number} " in told[0] and "18 degrees" in told[0]
        assert tuple(note[:15] for note in found.notes if "pixels from" in note) == used


def test_landmarks_that_agree_are_used(match_scenes):
    scene = match_scenes.scene(9, 222.0, 4.0, 2.0)
    found = match_with_landmarks(match_robust, scene.inputs(landmarks=(seen_at(scene, 236.0, 8.0),)), RobustOptions())
    assert found.status == "accepted" and len(found.notes) == 1 and "Landmark 1 lies" in found.notes[0]


def test_a_landmark_outside_the_picture_is_refused(match_scenes):
    scene = match_scenes.scene(9, 222.0, 4.0, 2.0)
    beyond = replace(seen_at(scene, 236.0, 8.0), x_px=2.5 * scene.camera.width_px)
    with_it = match_with_landmarks(match_robust, scene.inputs(landmarks=(beyond,)), RobustOptions())
    without = match_robust(scene.inputs())
    assert with_it.best.pose == without.best.pose and with_it.p_correct == without.p_correct
    assert "Landmark 1 lies outside the picture of 1024 x 768" in with_it.notes[0]


def answer(status, ncc, pose):
    return Orientation(status, "", (Candidate(pose, FULL, 1.0),), ncc=ncc)


@pytest.mark.parametrize(
    "alone, found_ncc, contradicted",
    [
        (("accepted", 0.9), 0.4, True),
        (("accepted", 0.9), 0.95, False),  # the landmark has found what the search had missed
        (("ambiguous", 0.9), 0.4, False),  # what landmarks are for
    ],
)
def test_only_a_clear_answer_can_contradict_a_landmark(alone, found_ncc, contradicted):
    mark = Landmark(2000.0, 1500.0, 60.0, 5.0)
    wrong = contradicting((mark,), answer(*alone, Pose(20.0, 5.0)), answer("accepted", found_ncc, Pose(60.0, 5.0)))
    assert wrong == ((mark,) if contradicted else ())


@pytest.mark.parametrize("count", [1, 2])
def test_one_landmark_against_the_skyline_is_no_acceptance_and_two_that_agree_are(match_scenes, count):
    """The rows are noise, so that landmarks alone give the heading; the line that was found is the true skyline."""
    scene = match_scenes.scene(9, 222.0, 4.0, 2.0)
    noise = np.random.default_rng(1).dirichlet(np.full(192, 0.05), size=256).T.astype(np.float32)
    scene = replace(scene, evidence=replace(scene.evidence, probability=noise))
    places = ((210.0, 5.0), (236.0, 8.0))[:count]
    wrong = tuple(replace(seen_at(scene, *place), azimuth_deg=place[0] + 90.0) for place in places)
    found = match_with_landmarks(match_robust, scene.inputs(landmarks=wrong), RobustOptions())
    assert found.ncc < 0.4 and abs(found.best.pose.heading_deg - 312.0) < 3
    if count == 1:
        assert found.status == "ambiguous" and "does not follow the skyline" in found.message
        assert (found.p_correct, found.heading_lo_deg, found.heading_hi_deg) == (None, None, None)
    else:
        assert found.status == "accepted"


def seen_at(scene, azimuth_deg, elevation_deg):
    """Landmark where the scene's camera sees a direction."""
    x, y = project(scene.camera, scene.pose, azimuth_deg, elevation_deg)
    return Landmark(float(x), float(y), azimuth_deg, elevation_deg)
