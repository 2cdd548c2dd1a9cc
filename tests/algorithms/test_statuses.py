"""Later steps keep the doubt: which photographs each of them uses by their status, and what it says of the others."""

from __future__ import annotations

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import NULL, QgsFeature, QgsGeometry, QgsProcessingException, QgsVectorLayer
from skyline_viewshed.core.base.status import RELIABLE
from skyline_viewshed.core.report.facts import STATUSES

REACH_M = 5_000.0
ALL = [0, 1, 2, 3]
FIELDS = "field=photo:string&field=heading:double&field=pitch:double&field=roll:double&field=hfov:double"


@pytest.fixture
def photos(scene):
    """Make a layer of the photo `north`, one point for each status; None leaves the field `status` away."""

    def make(statuses):
        status = "" if statuses is None else "&field=status:string"
        layer = QgsVectorLayer(f"Point?crs=EPSG:4326&{FIELDS}&field=vfov:double{status}", "oriented", "memory")
        pose, (lon, lat) = scene.truth["north"], scene.positions["north"]
        values = [
            str(scene.folder / "north.jpg"),
            pose.heading_deg,
            pose.pitch_deg,
            pose.roll_deg,
            scene.hfov_deg,
            45.0,
        ]
        for word in [()] * 3 if statuses is None else [(status,) for status in statuses]:
            feature = QgsFeature(layer.fields())
            feature.setGeometry(QgsGeometry.fromWkt(f"Point({lon!r} {lat!r})"))
            feature.setAttributes([*values, *word])
            layer.dataProvider().addFeature(feature)
        return layer

    return make


def place(scene, distance_deg=0.01):
    """A point and an area in front of the camera of `north`."""
    lon, lat = scene.positions["north"]
    point = QgsVectorLayer("Point?crs=EPSG:4326&field=name:string", "places", "memory")
    feature = QgsFeature(point.fields())
    feature.setGeometry(QgsGeometry.fromWkt(f"Point({lon!r} {lat + distance_deg!r})"))
    feature.setAttributes(["there"])
    point.dataProvider().addFeature(feature)
    return point


def pixels():
    table = QgsVectorLayer("NoGeometry?field=x:double&field=y:double", "pixels", "memory")
    feature = QgsFeature(table.fields())
    feature.setAttributes([400.0, 500.0])
    table.dataProvider().addFeature(feature)
    return table


def rows(output, context_result=None):
    return [feature.attributes() for feature in output.getFeatures()]


def count_directed(run, given, tmp_path):
    results, feedback = run("directedviewshed", {**given, "OUTPUT": str(tmp_path / "seen.tif"), "POLYGONS": "memory:"})
    assert int(gdal.Open(results["OUTPUT"]).ReadAsArray().max()) in (results["COUNT"], 0)
    return results["COUNT"], feedback


def count_labels(run, given, tmp_path):
    results, feedback = run("labelpeaks", {**given, "OUTPUT": "memory:"})
    names = [(row[1], row[4]) for row in rows(results["OUTPUT"])]
    return max((names.count(name) for name in names), default=0), feedback


def count_draped(run, given, tmp_path):
    results, feedback = run("drapephoto", {**given, "OUTPUT": str(tmp_path / "draped.tif")})
    return results["COUNT"], feedback


def count_covered(run, given, tmp_path):
    results, feedback = run("photocoverage", {**given, "OUTPUT": str(tmp_path / "covered.tif")})
    return results["COUNT"], feedback


def count_placed(run, given, tmp_path):
    results, feedback = run("pixeltomap", {**given, "PIXELS": pixels(), "OUTPUT": "memory:"})
    return results["COUNT"], feedback


def count_in_pictures(run, given, tmp_path):
    results, feedback = run("maptopixel", {**given, "FEATURES": given.pop("PLACES"), "OUTPUT": "memory:"})
    return results["OUTPUT"].featureCount(), feedback


def count_sightings(run, given, tmp_path):
    area = given["PLACES"].getFeature(1).geometry().buffer(0.004, 8)
    places = QgsVectorLayer("Polygon?crs=EPSG:4326", "area", "memory")
    feature = QgsFeature()
    feature.setGeometry(area)
    places.dataProvider().addFeature(feature)
    results, feedback = run("whichphotos", {**given, "PLACES": places, "OUTPUT": "memory:"})
    return results["OUTPUT"].featureCount(), feedback


def count_frames(run, given, tmp_path):
    observer = QgsVectorLayer("Point?crs=EPSG:4326", "observer", "memory")
    observer.dataProvider().addFeatures([next(given["INPUT"].getFeatures())])
    given = {**given, "PHOTOS": given["INPUT"], "INPUT": observer, "AZIMUTH_STEP": 1.0, "FOLDER": str(tmp_path / "p")}
    results, feedback = run("panorama", given)
    (drawing,) = (tmp_path / "p").glob("*.svg")
    return drawing.read_text(encoding="utf-8").count(">north<"), feedback


STEPS = {
    "directedviewshed": count_directed,
    "labelpeaks": count_labels,
    "drapephoto": count_draped,
    "photocoverage": count_covered,
    "pixeltomap": count_placed,
    "maptopixel": count_in_pictures,
    "whichphotos": count_sightings,
    "panorama": count_frames,
}
STOPS = ("drapephoto", "photocoverage")
"""Steps whose raster cannot be made without a photo: they stop with a sentence instead of writing an empty one."""


def used(step, run, scene, layer, tmp_path, **more):
    given = {"INPUT": layer, "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, **more}
    if step in ("maptopixel", "whichphotos"):
        given["PLACES"] = place(scene)
    return STEPS[step](run, given, tmp_path)


@pytest.mark.parametrize("step", STEPS)
def test_a_step_uses_reliable_photos_and_says_how_many_it_leaves_out_and_why(step, run, scene, photos, tmp_path):
    count, feedback = used(step, run, scene, photos(STATUSES), tmp_path)
    assert count == len(RELIABLE) == 2
    (told,) = (warning for warning in feedback.warnings if "left out" in warning)
    assert "3 of 5 photos" in told and "1 ambiguous, 1 rejected, 1 failed" in told and "STATUSES" in told


@pytest.mark.parametrize("step", STEPS)
def test_the_doubtful_ones_are_used_when_they_are_asked_for(step, run, scene, photos, tmp_path):
    count, feedback = used(step, run, scene, photos(STATUSES[:4]), tmp_path, STATUSES=ALL)
    assert count == 4 and not [warning for warning in feedback.warnings if "left out" in warning]


@pytest.mark.parametrize("step", STEPS)
def test_layers_without_a_status_of_ours_are_used_whole(step, run, scene, photos, tmp_path):
    for number, statuses in enumerate((None, ["done", "", NULL])):
        count, feedback = used(step, run, scene, photos(statuses), tmp_path / str(number))
        assert count == 3 and not feedback.errors
        assert not [warning for warning in feedback.warnings if "left out" in warning]


@pytest.mark.parametrize("step", STEPS)
def test_nothing_is_left_never_without_a_sentence(step, run, scene, photos, tmp_path):
    from skyline_viewshed.tests.algorithms.conftest import Listener

    feedback, layer = Listener(), photos(["ambiguous", "rejected"])

    def run_told(name, parameters):
        return run(name, parameters, feedback)

    if step in STOPS:
        with pytest.raises(QgsProcessingException):
            used(step, run_told, scene, layer, tmp_path)
    else:
        assert used(step, run_told, scene, layer, tmp_path)[0] == 0
    (told,) = (error for error in feedback.errors if "No photo is used" in error)
    assert "2 of 2 photos" in told and "1 ambiguous, 1 rejected" in told


def test_a_full_circle_does_not_depend_on_the_heading(run, scene, photos, tmp_path):
    count, feedback = used("directedviewshed", run, scene, photos(STATUSES), tmp_path, SECTOR=2)
    assert count == 5 and not feedback.warnings


def test_the_run_that_solves_and_sees_in_one_says_which_photos_get_no_viewshed(run, scene, tmp_path):
    from PIL import Image

    folder = tmp_path / "photos"
    folder.mkdir()
    with Image.open(scene.folder / "north.jpg") as picture:
        exif = picture.info["exif"]
    noise = np.random.default_rng(1).integers(0, 255, (600, 800, 3), np.uint8)
    Image.fromarray(noise).save(folder / "noise.jpg", exif=exif)
    given = {"FOLDER": str(folder), "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, "OUTPUT": "memory:",
             "POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "seen.tif")}  # fmt: skip
    results, feedback = run("photoviewshed", given)
    assert results["VIEWSHEDS"] == 0
    (told,) = feedback.errors
    assert "1 of 1 photos get no viewshed" in told
