"""Photographs placed on tracks of all kinds, and the reasons where they cannot be."""

from __future__ import annotations

from datetime import datetime, timedelta, timezone

import numpy as np
import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsLineString, QgsPoint, QgsVectorLayer
from qgis.PyQt.QtCore import QDateTime
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.io.write_photo import write_photo
from whole_runs import rows_of

pytestmark = pytest.mark.qgis

START = datetime(2023, 10, 31, 3, 0, tzinfo=timezone.utc)
STEP_S = 60
LONGITUDE, LATITUDE = 86.8, 27.9


def longitude_at(seconds):
    return LONGITUDE + 0.0001 * seconds / STEP_S


@pytest.fixture(scope="module")
def photos(tmp_path_factory):
    """Photographs by local time in Nepal: with and without their zone, in the evening, and without a time."""
    folder = tmp_path_factory.mktemp("untagged")
    pixels = np.full((60, 80, 3), 128, np.uint8)
    for name, local, offset_s in (
        ("a_zone", datetime(2023, 10, 31, 8, 55, 30), 5.75 * 3600),
        ("b_bare", datetime(2023, 10, 31, 8, 55, 30), None),
        ("c_evening", datetime(2023, 10, 31, 20, 0), 5.75 * 3600),
        ("d_timeless", None, None),
    ):
        path = str(folder / f"{name}.jpg")
        write_photo(path, pixels, PhotoMetadata(path, 80, 60, taken_at=local, utc_offset_s=offset_s))
    return folder


@pytest.fixture(scope="module")
def gpx(tmp_path_factory):
    points = "".join(
        f'<trkpt lat="{LATITUDE}" lon="{longitude_at(s):.6f}"><ele>{4000 + s / 60}</ele>'
        f"<time>{(START + timedelta(seconds=s)).strftime('%Y-%m-%dT%H:%M:%SZ')}</time></trkpt>"
        for s in range(0, 3601, STEP_S)
    )
    path = tmp_path_factory.mktemp("track") / "walk.gpx"
    path.write_text(
        '<?xml version="1.0"?><gpx version="1.1" creator="test" xmlns="http://www.topografix.com/GPX/1/1">'
        f"<trk><trkseg>{points}</trkseg></trk></gpx>"
    )
    return path


@pytest.fixture
def placed(run, photos, tmp_path):
    def call(**given):
        output = tmp_path / "placed.gpkg"
        results, feedback = run("positionphotos", {"FOLDER": str(photos), "OUTPUT": str(output), **given})
        rows = {row["filename"]: row for row in rows_of(output)}
        points = {f["filename"]: f.geometry() for f in QgsVectorLayer(str(output)).getFeatures()}
        return results, feedback, rows, points

    return call


def test_a_gpx_file_places_by_the_recorded_zone_and_says_why_not(placed, gpx):
    results, feedback, rows, points = placed(TRACK_FILE=str(gpx))
    assert (results["COUNT"], results["PLACED"], results["CLOCK_FOUND"]) == (4, 1, 0.0)
    point = points["a_zone"].constGet()
    assert abs(point.x() - longitude_at(630)) < 1e-7 and abs(point.z() - 4010.5) < 0.01
    row = rows["a_zone"]
    assert float(row["longitude"]) == pytest.approx(point.x()) and row["pos_gap"] == 60.0
    assert 5 < row["pos_err"] < 40
    for name, words in (("b_bare", "no time zone"), ("c_evening", "after the track ends"), ("d_timeless", "no time.")):
        assert points[name].isEmpty() and words in rows[name]["pos_note"]
        assert any(name in text and words in text for text in feedback.warnings)


def test_the_zone_and_the_offset_can_be_given(placed, gpx):
    results, _, rows, points = placed(TRACK_FILE=str(gpx), TIME_ZONE="Asia/Kathmandu", CLOCK_OFFSET=300.0)
    assert results["PLACED"] == 2 and results["CLOCK_FOUND"] == 300.0
    for name in ("a_zone", "b_bare"):
        assert abs(points[name].constGet().x() - longitude_at(330)) < 1e-7


def layer_of_points(kind):
    layer = QgsVectorLayer(f"Point?crs=EPSG:4326&field=time:{kind}", "track", "memory")
    for s in range(0, 3601, STEP_S):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry(QgsPoint(longitude_at(s), LATITUDE)))
        text = (START + timedelta(seconds=s)).strftime("%Y-%m-%dT%H:%M:%S")
        moment = QDateTime.fromString(text, "yyyy-MM-ddTHH:mm:ss")
        feature.setAttributes([{"datetime": moment, "string": f"{text}Z", "double": START.timestamp() + s}[kind]])
        layer.dataProvider().addFeature(feature)
    return layer


@pytest.mark.parametrize("kind", ["datetime", "string", "double"])
def test_layers_of_points_with_times_of_any_kind(placed, kind):
    _, _, _, points = placed(TRACK=layer_of_points(kind))
    assert abs(points["a_zone"].constGet().x() - longitude_at(630)) < 1e-7


def test_a_line_with_m_values(placed, run, photos, tmp_path):
    layer = QgsVectorLayer("LineStringM?crs=EPSG:4326", "line", "memory")
    feature = QgsFeature()
    seconds = np.arange(0, 3601, STEP_S, dtype=float)
    vertices = [QgsPoint(longitude_at(s), LATITUDE, m=START.timestamp() + s) for s in seconds]
    feature.setGeometry(QgsGeometry(QgsLineString(vertices)))
    layer.dataProvider().addFeature(feature)
    _, _, _, points = placed(TRACK=layer)
    assert abs(points["a_zone"].constGet().x() - longitude_at(630)) < 1e-7


@pytest.mark.parametrize(
    "change, words",
    [
        ({"TRACK_FILE": ""}, "Choose the track"),
        ({"TIME_ZONE": "Nepal time"}, "time zone"),
        ({"CLOCK": 1}, "elevation model"),
        ({"FOLDER": ""}, "Choose either a folder"),
    ],
)
def test_what_is_missing_is_said_before_anything_starts(refusal, photos, gpx, tmp_path, change, words):
    given = {"FOLDER": str(photos), "TRACK_FILE": str(gpx), "OUTPUT": str(tmp_path / "o.gpkg")}
    assert words in refusal("positionphotos", {**given, **change})


def test_a_clock_that_the_skylines_cannot_tell_places_nothing(placed, gpx, scene):
    results, feedback, rows, points = placed(TRACK_FILE=str(gpx), CLOCK=1, DEM=str(scene.dem))
    assert results["PLACED"] == 0 and all(point.isEmpty() for point in points.values())
    assert any("cannot be determined" in text for text in feedback.warnings)
    assert "cannot be determined" in rows["a_zone"]["pos_note"]


def test_a_file_without_a_track_is_named(run, photos, tmp_path):
    from qgis.core import QgsProcessingException

    (tmp_path / "empty.gpx").write_text('<?xml version="1.0"?><gpx version="1.1" creator="t"></gpx>')
    with pytest.raises(QgsProcessingException, match="no points"):
        run("positionphotos", {"FOLDER": str(photos), "TRACK_FILE": str(tmp_path / "empty.gpx"), "OUTPUT": "memory:"})
