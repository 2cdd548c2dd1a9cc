"""Points of a layer as posed photographs."""

from __future__ import annotations

import numpy as np
import pytest
from qgis.core import QgsFeature, QgsFields
from skyline_viewshed.algorithms.shared.fields import FieldSpec, qgis_field
from skyline_viewshed.algorithms.shared.layers import PointRow
from skyline_viewshed.algorithms.shared.photo_points import (
    NOMINAL_WIDTH_PX,
    PoseReading,
    oriented_point,
    photo_point,
    pinhole,
    pose_values,
)
from skyline_viewshed.algorithms.shared.skyline_limits import with_line
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, fov_of_focal_deg
from skyline_viewshed.core.base.model import Candidate, Orientation, OrientedPhoto
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.base.uncertainty import Z_90, PoseUncertainty

WHOLE = {"heading": 30.0, "pitch": 2.0, "roll": -1.0, "hfov": 60.0, "vfov": 45.0, "eye_z": 1800.0}


def row_of(place=(8.0, 46.0), **values):
    fields = QgsFields()
    for name in values:
        fields.append(qgis_field(FieldSpec(name, "real", name)))
    feature = QgsFeature(fields, 7)
    feature.setAttributes(list(values.values()))
    return PointRow(feature, "a.jpg", *place)


def read(row, level=False, size_px=None):
    return photo_point(row, pose_values(row.feature), PoseReading(1.7, level=level), "a.jpg", size_px)


def test_a_whole_row_is_a_posed_photo():
    point = read(row_of(**WHOLE), size_px=(800, 600))
    assert point.posed.camera == Camera(800, 600, focal_of_fov_px(800, 60.0))
    assert point.posed.pose == Pose(30.0, 2.0, -1.0)
    assert point.posed.observer == point.observer == Observer(8.0, 46.0, 1.7, 1800.0)
    assert point.posed.uncertainty == PoseUncertainty()
    assert (point.key, point.heading_deg) == ((7, "a.jpg"), 30.0)


def test_what_a_row_says_of_its_errors_counts():
    posed = read(row_of(**WHOLE, heading_lo=29.0, heading_hi=31.0, h_acc=15.096)).posed
    assert posed.uncertainty.heading_deg == pytest.approx(2 / 3.29, rel=1e-3)
    assert posed.uncertainty.position_m == pytest.approx(10.0)


def test_the_intervals_of_the_orientation_count_and_half_an_interval_does_not():
    focal = [focal_of_fov_px(1.0, 60.0) * np.exp(sign * Z_90 * 0.02) for sign in (1, -1)]
    ends = dict(zip(("hfov_lo", "hfov_hi"), (fov_of_focal_deg(1.0, value) for value in focal)))
    row = row_of(**WHOLE, pitch_lo=-2.0, pitch_hi=-2.0 + 2 * Z_90 * 0.7, roll_lo=1.0, **ends)
    uncertainty = read(row).posed.uncertainty
    assert uncertainty.pitch_deg == pytest.approx(0.7) and uncertainty.focal_relative == pytest.approx(0.02)
    assert uncertainty.roll_deg == PoseUncertainty().roll_deg


@pytest.mark.parametrize("name", ["pitch", "vfov"])
def test_without_pitch_or_vertical_view_a_pose_is_taken_only_where_a_level_one_serves(name):
    row = row_of(**{**WHOLE, name: None})
    assert read(row).posed is None and read(row).observer is not None
    posed = read(row, level=True).posed
    assert posed.pose.pitch_deg == (0.0 if name == "pitch" else 2.0)
    if name == "vfov":
        assert (posed.camera.width_px, posed.camera.height_px) == (NOMINAL_WIDTH_PX, 3000)


@pytest.mark.parametrize("wrong", [{"heading": None}, {"hfov": None}, {"hfov": 190.0}])
def test_without_a_heading_or_a_lens_there_is_no_pose(wrong):
    assert read(row_of(**{**WHOLE, **wrong}), level=True).posed is None


def test_without_a_place_there_is_neither_observer_nor_pose():
    point = read(row_of((None, None), **WHOLE))
    assert point.observer is None and point.posed is None and point.heading_deg == 30.0


def test_a_pinhole_has_the_fields_of_view_that_are_asked_for():
    camera = pinhole(60.0, 45.0)
    assert camera.hfov_deg == pytest.approx(60.0) and camera.vfov_deg == pytest.approx(45.0, abs=0.02)


def test_the_fitted_camera_stays_whole_within_a_run():
    camera = Camera(800, 600, 700.0, offset_x_px=4.0, offset_y_px=-3.0, k1=-0.04, k2=0.01)
    answer = Orientation("accepted", "", (Candidate(Pose(370.0, 2.0, 1.0), camera, 1.0),), 9.0, 11.0)
    oriented = OrientedPhoto(
        "/photos/b.jpg", answer, camera=camera, longitude_deg=8.0, latitude_deg=46.0, eye_elevation_m=1800.0
    )
    point = oriented_point(row_of(), oriented, PoseUncertainty(pitch_deg=0.7))
    assert point.posed.camera == camera and point.heading_deg == 10.0 and point.name == "b.jpg"
    assert point.posed.uncertainty.pitch_deg == 0.7
    assert point.posed.uncertainty.heading_deg == pytest.approx(2 / 3.29, rel=1e-3)
    limited = with_line(point, range(800), [300.0] * 800, [1.0] * 800, 0.3)
    assert limited.posed.camera == camera and limited.skyline_row_px.shape == (800,)


def test_a_skyline_tells_the_width_of_a_picture_known_by_its_fields_of_view():
    point = with_line(read(row_of(**WHOLE)), range(640), [200.0] * 640, [1.0] * 640, 0.3)
    assert point.posed.camera.width_px == 640
    assert point.posed.camera.hfov_deg == pytest.approx(60.0)
