"""The sun and the moon as landmarks: one click in the picture, and the time of the photograph does the rest."""

from __future__ import annotations

import json
import shutil
from types import SimpleNamespace

import pytest
from moonlit import moonlit_photo
from panel_hand import write_photos
from qgis.core import QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.landmark_hint import LandmarkHint
from skyline_viewshed.panel.model.aids import _write_landmarks, read_aids


@pytest.fixture
def night(make_view, scene, tmp_path):
    """The panel on the photograph with the moon; the other photograph of the layer has no time."""
    folder = tmp_path / "night"
    folder.mkdir()
    shutil.copy(scene.folder / "north.jpg", folder)
    path, x, y = moonlit_photo(scene, folder)
    write_photos(tmp_path / "photos.gpkg", scene, folder=folder)
    panel = make_view(tmp_path / "photos.gpkg")
    panel.fids = {panel.session.photos.item(fid).name: fid for fid in panel.session.photos.ids()}
    panel.show = lambda name: (panel.view.select(panel.fids[name]), panel.hand.settle())
    panel.show("west.jpg")
    panel.path, panel.moon, panel.table = path, (x, y), tmp_path / "photo_view" / "landmarks.geojson"
    return panel


def off_deg(panel, heading_deg, scene):
    return abs(difference(heading_deg, scene.truth["west"].heading_deg))


def test_one_click_on_the_moon_places_the_camera_and_is_kept_for_later_runs(night, scene, provider):
    import processing

    hand, start = night.hand, night.hand.draft
    assert off_deg(night, start.pose.heading_deg, scene) == pytest.approx(5.0, abs=0.1)
    hand.key(Qt.Key.Key_O)
    assert night.view.dock.actions["moon"].isChecked()
    hand.click(*night.moon)
    assert "The moon stood at azimuth" in hand.said and off_deg(night, hand.draft.pose.heading_deg, scene) < 0.6
    hand.settle()
    assert "landmark" in [line.kind for line in night.view.dock.canvas.lines]
    hand.press("undo")
    assert hand.draft == start
    hand.press("redo")
    hand.click(*night.moon)
    assert [mark.body for mark in hand.draft.landmarks] == ["moon"]
    hand.press("snap")
    hand.settle()
    assert off_deg(night, hand.draft.pose.heading_deg, scene) < 0.3
    hand.press("keep")
    assert off_deg(night, night.layer.getFeature(night.session.item.fid)["heading"], scene) < 0.3
    (feature,) = json.loads(night.table.read_text())["features"]
    assert feature["properties"]["body"] == "moon"
    longitude, latitude = feature["geometry"]["coordinates"]
    assert (longitude, latitude) == pytest.approx(scene.positions["west"])
    layer = QgsVectorLayer(str(night.table), "landmarks", "ogr")
    given = {"INPUT": night.layer, "DEM": str(scene.dem), "LANDMARKS": layer, "OUTPUT": "TEMPORARY_OUTPUT"}
    report = night.table.with_name("report.html")
    rows = processing.run("skylineviewshed:orientphotos", {**given, "REPORT": str(report)})["OUTPUT"].getFeatures()
    assert off_deg(night, {row["filename"]: row for row in rows}["west"]["heading"], scene) < 0.5
    assert "Landmark 1 lies" in report.read_text(encoding="utf-8")
    night.session.show(night.session.item.fid)
    hand.settle()
    assert [mark.body for mark in hand.draft.landmarks] == ["moon"]
    hand.press("remove_landmarks")
    hand.press("keep")
    assert json.loads(night.table.read_text())["features"] == []
    night.layer.rollBack()


@pytest.mark.parametrize(
    "name, key, sentence",
    [
        ("west.jpg", Qt.Key.Key_U, "below the horizon at 2024-"),
        ("north.jpg", Qt.Key.Key_O, "does not record its time with a time zone"),
    ],
)
def test_a_body_that_cannot_be_there_gets_a_sentence_and_changes_nothing(night, name, key, sentence):
    night.show(name)
    start = night.hand.draft
    night.hand.key(key)
    night.hand.click(*night.moon)
    assert sentence in night.hand.said
    assert night.hand.draft == start and not night.session.history.can_undo


def test_landmarks_that_contradict_one_another_are_said_and_can_be_undone(night):
    hand, eye = night.hand, night.session.ground.observer
    hand.press("moon")
    hand.click(*night.moon)
    right = hand.draft
    hand.press("landmark")
    hand.click(400.0, 300.0)
    hand.click_map(eye.longitude_deg + 0.05, eye.latitude_deg)
    assert "contradict one another" in hand.said
    hand.press("undo")
    assert hand.draft == right and hand.said == ""


def test_without_an_elevation_model_a_click_on_the_sun_gets_a_sentence(night):
    night.view.dock.dem_box.setLayer(None)
    night.hand.press("sun")
    night.hand.click(*night.moon)
    assert "elevation model is missing" in night.hand.said and night.hand.draft.landmarks == ()


def test_a_table_of_landmarks_keeps_the_rows_that_are_not_of_this_photograph(tmp_path):
    """The panel rewrites the file: rows of others, and those that it cannot show, stay as they were."""

    def feature(place, **values):
        geometry = place and {"type": "Point", "coordinates": place}
        return {"type": "Feature", "properties": {"photo": "a.jpg", "x": 4, "y": 5, **values}, "geometry": geometry}

    mine = [feature(None, body="Sun"), feature([8.0, 46.5], body="moon"), feature([8.1, 46.6])]
    others = [feature([8.0, 46.5], body="moon", photo="b.jpg"), feature(None), feature([8.2, 46.6], x=None),
              feature([8.2, 46.6], body="mars"), {"type": "Feature", "properties": None, "geometry": None}]  # fmt: skip
    table = tmp_path / "landmarks.geojson"
    table.write_text(json.dumps({"type": "FeatureCollection", "features": [*mine, *others]}))
    marks = read_aids(tmp_path, "/d/a.jpg")[0]
    assert [(mark.body, mark.longitude_deg) for mark in marks] == [("sun", None), ("moon", 8.0), (None, 8.1)]
    assert read_aids(tmp_path, "/d/b.jpg")[0] == (LandmarkHint(4, 5, 8.0, 46.5, body="moon"),)
    _write_landmarks(tmp_path, "/d/a.jpg", SimpleNamespace(landmarks=marks))
    assert read_aids(tmp_path, "/d/a.jpg")[0] == marks
    _write_landmarks(tmp_path, "/d/a.jpg", SimpleNamespace(landmarks=()))
    assert json.loads(table.read_text())["features"] == others
