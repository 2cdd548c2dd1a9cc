from __future__ import annotations

from dataclasses import replace

import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.model import Candidate, Orientation, OrientedPhoto
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.base.uncertainty import PoseUncertainty

CAMERA = Camera(400, 300, 350.0, offset_x_px=3.0, k1=-0.05)


def oriented(**changes):
    answer = Orientation(
        "accepted", "", (Candidate(Pose(-10.0, 2.0, 1.0), CAMERA, 5.0),), heading_lo_deg=349.0, heading_hi_deg=351.0
    )
    photo = OrientedPhoto("a.jpg", answer, longitude_deg=8.0, latitude_deg=46.0, eye_elevation_m=2000.0)
    return replace(photo, **changes)


def test_an_oriented_photo_gives_its_best_pose_with_the_whole_camera():
    view = oriented().view
    assert view.camera == CAMERA
    assert view.pose == Pose(350.0, 2.0, 1.0)
    assert view.observer == Observer(8.0, 46.0, eye_elevation_m=2000.0)
    assert view.path == "a.jpg"
    assert view.uncertainty == PoseUncertainty().with_heading_interval(349.0, 351.0)
    assert view.uncertainty.heading_deg == pytest.approx(2 / 3.29, rel=1e-3)


def test_without_an_answer_there_is_no_view():
    assert oriented(orientation=Orientation("rejected", "")).view is None


def test_without_an_interval_the_heading_has_the_usual_uncertainty():
    answer = replace(oriented().orientation, heading_lo_deg=None, heading_hi_deg=None)
    assert oriented(orientation=answer).view.uncertainty == PoseUncertainty()


def test_posed_photos_are_values():
    photo = PosedPhoto(CAMERA, Pose(1.0), Observer(8.0, 46.0))
    assert photo == PosedPhoto(CAMERA, Pose(1.0), Observer(8.0, 46.0)) and hash(photo) == hash(replace(photo))
    assert photo != replace(photo, uncertainty=PoseUncertainty(roll_deg=2.0))
