"""The turn between two photographs from one place: exact axes, simulated photographs, and pictures without a tie."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from scenes import small_mountains
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px, project
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.joint.ties import axes_of, features, pose_of, turn_between, turned
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions

CAMERA = Camera(800, 600, focal_from_35mm_px(800, 600, 28.0))


@pytest.mark.parametrize("pose", [Pose(0, 0, 0), Pose(123.0, 12.0, -7.0), Pose(359.0, -30.0, 15.0)])
def test_axes_agree_with_the_camera_and_can_be_inverted(pose):
    back = pose_of(axes_of(pose))
    assert difference(back.heading_deg, pose.heading_deg) == pytest.approx(0, abs=1e-9)
    assert (back.pitch_deg, back.roll_deg) == pytest.approx((pose.pitch_deg, pose.roll_deg))
    azimuth, elevation = pose.heading_deg + 9.0, pose.pitch_deg + 4.0
    a, e = np.radians([azimuth, elevation])
    x, y, z = axes_of(pose) @ [np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), np.sin(e)]
    centre = (CAMERA.width_px - 1) / 2, (CAMERA.height_px - 1) / 2
    found = centre[0] + CAMERA.focal_px * x / z, centre[1] + CAMERA.focal_px * y / z
    assert np.ravel(project(CAMERA, pose, azimuth, elevation)) == pytest.approx(found)


@pytest.fixture(scope="module")
def views():
    pytest.importorskip("cv2")
    terrain = small_mountains()
    rows, cols = terrain.shape
    place = Observer(*terrain.position_of(cols / 2, rows / 2), eye_height_m=30.0)
    poses = Pose(40.0, 2.0, 1.0), Pose(55.0, 5.0, -3.0), Pose(220.0, 2.0, 0.0)
    return poses, [render_view(terrain, place, CAMERA, pose, SceneOptions(3)).pixels for pose in poses]


def test_a_turn_is_found_to_a_quarter_of_a_degree(views):
    poses, pictures = views
    known = [(picture.shape, features(picture)) for picture in pictures[:2]]
    rotation, _ = turn_between(*known, CAMERA.focal_px, CAMERA.focal_px)
    found = turned(poses[0], rotation)
    assert abs(difference(found.heading_deg, poses[1].heading_deg)) < 0.25
    assert (found.pitch_deg, found.roll_deg) == pytest.approx((5.0, -3.0), abs=0.3)


def test_pictures_without_anything_in_common_are_not_tied(views):
    _, pictures = views
    known = [(picture.shape, features(picture)) for picture in (pictures[0], pictures[2])]
    assert turn_between(*known, CAMERA.focal_px, CAMERA.focal_px) is None


def test_a_wrong_focal_length_is_no_turn(views):
    _, pictures = views
    known = [(picture.shape, features(picture)) for picture in pictures[:2]]
    assert turn_between(*known, CAMERA.focal_px, 1.5 * CAMERA.focal_px) is None


def test_without_opencv_or_features_there_are_none(monkeypatch):
    from skyline_viewshed.core.joint import ties

    assert features(np.zeros((60, 80, 3), np.uint8)) is None and features(None) is None
    noise = np.random.default_rng(0).integers(0, 255, (200, 300, 3)).astype(np.uint8)
    for found in (None, SimpleNamespace(__version__="4.2.0")):
        monkeypatch.setattr(ties, "available", lambda name, found=found: found)
        assert features(noise) is None
