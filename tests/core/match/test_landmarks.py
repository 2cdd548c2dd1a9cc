import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, project, unproject
from skyline_viewshed.core.match.landmarks import Landmark, landmark_notes, scale_landmarks, starting_pose

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
