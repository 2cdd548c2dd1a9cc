"""Lenses that the user describes, from the parameter or the field to the answer: field of view and distortion."""

from dataclasses import replace

import pytest
from qgis.core import NULL, QgsFeature, QgsGeometry, QgsPointXY, QgsVectorLayer
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions

K1 = -0.12
"""A barrel distortion as of a wide action camera: it moves the picture's corner by a tenth of its distance."""


def points_of(path, place, *rows, fields=()):
    """Layer of one photograph, one point for each tuple of values."""
    columns = "".join(f"&field={name}:double" for name in fields)
    layer = QgsVectorLayer(f"Point?crs=EPSG:4326&field=photo:string{columns}", "points", "memory")
    for values in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*place)))
        feature.setAttributes([path, *values])
        layer.dataProvider().addFeature(feature)
    return layer


@pytest.fixture(scope="module")
def distorted(scene, tmp_path_factory):
    """The scene's north view through a lens of strong distortion: path and true pose."""
    dem, place, pose = open_dem(str(scene.dem)), scene.positions["north"], Pose(20.0, 2.0, 0.5)
    camera = Camera(800, 600, focal_of_fov_px(800, 75.0))
    view = render_view(dem, Observer(*place, 2.0), replace(camera, k1=K1), pose, SceneOptions(0))
    path = str(tmp_path_factory.mktemp("lens") / "barrel.jpg")
    write_photo(path, view.pixels, PhotoMetadata(path, 800, 600))
    return path, pose


def test_fields_of_the_distortion_reach_the_answer(run, scene, distorted):
    path, pose = distorted
    layer = points_of(path, scene.positions["north"], (75.0, K1, 0.0), (75.0, NULL, NULL), fields=("hfov", "k1", "k2"))
    given = {"INPUT": layer, "DEM": str(scene.dem), "HFOV_FIELD": "hfov", "OUTPUT": "memory:"}
    results, _ = run("orientphotos", given)
    right, pinhole = results["OUTPUT"].getFeatures()
    assert right["status"] == "accepted" and (right["k1"], right["k2"]) == (K1, 0.0)
    assert abs(difference(right["heading"], pose.heading_deg)) < 0.3 and abs(right["pitch"] - pose.pitch_deg) < 0.3
    assert right["ncc"] > pinhole["ncc"]
    given = {"INPUT": results["OUTPUT"], "DEM": str(scene.dem), "MAX_DISTANCE": 2_000.0, "STATUSES": []}
    seen, _ = run("directedviewshed", {**given, "OUTPUT": "TEMPORARY_OUTPUT", "POLYGONS": "memory:"})
    assert seen["COUNT"] >= 1


def test_one_field_of_view_for_all_photos_and_a_field_for_some(run, scene, tmp_path):
    path = str(scene.odd / "no_focal.jpg")
    layer = points_of(path, scene.positions["west"], (NULL,), (20.0,), fields=("hfov",))
    given = {"INPUT": layer, "DEM": str(scene.dem), "HFOV_FIELD": "hfov", "OUTPUT": "memory:"}
    results, _ = run("orientphotos", {**given, "HFOV": scene.hfov_deg})
    all_of_them, own = results["OUTPUT"].getFeatures()
    assert all_of_them["status"] == "accepted"
    assert abs(difference(all_of_them["heading"], scene.truth["west"].heading_deg)) < 0.5
    assert all_of_them["hfov"] == pytest.approx(scene.hfov_deg, rel=0.05)
    assert own["status"] != "accepted" and own["hfov"] == pytest.approx(20.0, rel=0.15)
    without, _ = run("orientphotos", given)
    failed = next(without["OUTPUT"].getFeatures())
    assert failed["status"] == "failed" and "no focal length" in failed["message"]
