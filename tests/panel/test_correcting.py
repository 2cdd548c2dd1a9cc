"""Correcting with mouse and keys: drag, turn, zoom, snap, undo, landmarks, drawing, masks, and keeping all of it."""

from __future__ import annotations

import json

import numpy as np
import pytest
from qgis.core import QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import project, unproject
from skyline_viewshed.panel.model.aids import read_aids

SHIFT = Qt.KeyboardModifier.ShiftModifier


def error_deg(panel, scene):
    return abs(difference(panel.hand.draft.pose.heading_deg, scene.truth["north"].heading_deg))


def drag_right(panel, scene, miss_deg=0.6):
    """Drag the drawn horizon to where it belongs, as well as a hand can."""
    draft, truth = panel.hand.draft, scene.truth["north"]
    azimuth, elevation = unproject(draft.camera, draft.pose, 500.0, 250.0)
    x, y = project(draft.camera, truth, azimuth + miss_deg, elevation)
    panel.hand.drag((500.0, 250.0), (300.0, 250.0), (float(x), float(y)))


def test_a_drag_a_snap_and_keep_rescue_a_photograph_in_four_steps(panel, scene):
    hand, layer = panel.hand, panel.layer
    assert error_deg(panel, scene) == pytest.approx(5.0, abs=0.1)
    before = np.array(panel.view.dock.canvas.lines[-1].x_px)
    hand.steps = 0
    hand.press("correct")
    drag_right(panel, scene)
    assert 0.2 < error_deg(panel, scene) < 1.2
    hand.settle()
    assert not np.array_equal(before, panel.view.dock.canvas.lines[-1].x_px)
    assert panel.view.dock.strip.currentItem().text() == "• north.jpg"
    hand.key(Qt.Key.Key_F)
    hand.settle()
    assert error_deg(panel, scene) < 0.3 and "Fitted: heading" in hand.said
    hand.key(Qt.Key.Key_K)
    assert hand.steps <= 6
    row = layer.getFeature(panel.session.item.fid)
    assert row["status"] == "confirmed" and layer.isEditable()
    assert row["message"] == "corrected by hand: horizon moved, snapped to the skyline"
    assert abs(difference(row["heading"], 20.0)) < 0.3 and row["azim_1"] is not None
    assert difference(row["heading_lo"], row["heading"]) < 0 < difference(row["heading_hi"], row["heading"])
    assert not panel.session.history.changed and "edit buffer" in hand.said
    layer.undoStack().undo()
    hand.settle()
    assert layer.getFeature(panel.session.item.fid)["status"] == "ambiguous"
    assert error_deg(panel, scene) == pytest.approx(5.0, abs=0.1)
    assert "ambiguous" in panel.view.dock.photo_label.text()
    layer.undoStack().redo()
    hand.settle()
    assert error_deg(panel, scene) < 0.3 and "confirmed" in panel.view.dock.photo_label.text()
    layer.rollBack()
    hand.settle()
    assert error_deg(panel, scene) == pytest.approx(5.0, abs=0.1) and not panel.session.history.can_undo


def test_every_way_to_move_the_horizon_and_back(panel):
    hand = panel.hand
    hand.press("correct")
    start = hand.draft
    hand.drag((700, 300), (700, 200), button=Qt.MouseButton.RightButton)
    assert hand.draft.pose.roll_deg > start.pose.roll_deg + 5
    hand.drag((700, 200), (700, 300), modifiers=SHIFT)
    hand.wheel(3, 400, 300)
    assert hand.draft.camera.hfov_deg < start.camera.hfov_deg and hand.draft.lens_changed
    hand.key(Qt.Key.Key_Minus)
    hand.key(Qt.Key.Key_Left)
    hand.key(Qt.Key.Key_Up)
    hand.key(Qt.Key.Key_Comma)
    steps = 0
    while panel.session.history.can_undo:
        hand.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        steps += 1
    assert steps == 7 and hand.draft == start and not panel.view.dock.actions["undo"].isEnabled()
    hand.press("redo")
    assert hand.draft.pose.roll_deg > start.pose.roll_deg + 5
    hand.wheel(2, 400, 300, Qt.KeyboardModifier.ControlModifier)
    assert panel.view.dock.canvas.scale > 1.2


def test_another_answer_of_the_table(panel, scene):
    hand = panel.hand
    assert dict(panel.session.alternatives)[2].heading_deg == pytest.approx(20.7)
    hand.key(Qt.Key.Key_2)
    hand.settle()
    assert error_deg(panel, scene) < 0.3
    hand.press("keep")
    row = panel.layer.getFeature(panel.session.item.fid)
    assert row["heading_2"] == pytest.approx(25.0) and "another answer chosen" in row["message"]
    hand.press("third")
    assert "no answer 3" in hand.said
    panel.layer.rollBack()


def test_landmarks_place_the_camera_and_are_kept_for_later_runs(panel, scene, photos, provider):
    import processing
    from skyline_viewshed.panel.model.ground import place_of, posed_photo

    hand, session = panel.hand, panel.session
    truth = posed_photo(session.ground, session.draft.camera, scene.truth["north"])
    hand.press("landmark")
    for x, y in ((150.0, 520.0), (650.0, 500.0)):
        place = place_of(session.ground, truth, x, y)
        hand.click(x, y)
        assert "same point on the map" in hand.said
        hand.click_map(place.longitude_deg, place.latitude_deg)
    assert len(hand.draft.landmarks) == 2 and error_deg(panel, scene) < 0.5
    hand.press("keep")
    folder = photos.parent / "photo_view"
    table = QgsVectorLayer(str(folder / "landmarks.geojson"), "landmarks", "ogr")
    assert [f["photo"] for f in table.getFeatures()] == [f"{scene.folder.name}/north.jpg"] * 2
    assert {"photo", "x", "y", "elevation"} <= {field.name() for field in table.fields()}
    assert len(read_aids(folder, session.item.path)[0]) == 2
    given = {"INPUT": panel.layer, "DEM": str(scene.dem), "LANDMARKS": str(folder / "landmarks.geojson"),
             "OUTPUT": "TEMPORARY_OUTPUT"}  # fmt: skip
    found = {
        row["filename"]: row for row in processing.run("skylineviewshed:orientphotos", given)["OUTPUT"].getFeatures()
    }
    assert abs(difference(found["north"]["heading"], scene.truth["north"].heading_deg)) < 0.5
    session.show(session.item.fid)
    hand.settle()
    assert len(hand.draft.landmarks) == 2
    hand.press("remove_landmarks")
    hand.press("keep")
    assert json.loads((folder / "landmarks.geojson").read_text())["features"] == []
    panel.layer.rollBack()


def test_orientphotos_reads_what_the_panel_keeps(panel, photos, scene, provider):
    import processing

    hand, session = panel.hand, panel.session
    hand.press("draw")
    line = session.evidence.best
    columns = np.linspace(5, line.width_px - 5, 40).astype(int)
    factor = 800 / line.width_px
    hand.drag(*[(float(c * factor), float(line.row_px[c] * factor)) for c in columns])
    assert len(hand.draft.strokes) == 1 and hand.draft.anew
    hand.press("keep")
    folder = photos.parent / "photo_view"
    assert (folder / "skylines.csv").read_text().startswith(f"photo,column,row\n{scene.folder.name}/north.jpg,")
    hand.press("next")
    hand.settle()
    hand.press("brush")
    row = float(session.evidence.best.row_px[100]) * 800 / session.evidence.best.width_px
    hand.drag((100.0, row), (200.0, row))
    assert len(hand.draft.brush) == 1
    hand.press("keep")
    assert (folder / "sky_masks" / scene.folder.name / "west.png").exists()
    panel.layer.rollBack()
    parameters = {
        "INPUT": panel.layer, "DEM": str(scene.dem), "SKYLINES": str(folder / "skylines.csv"),
        "SKY_MASKS": str(folder / "sky_masks"), "OUTPUT": "TEMPORARY_OUTPUT",
    }  # fmt: skip
    found = processing.run("skylineviewshed:orientphotos", parameters)["OUTPUT"]
    for feature in found.getFeatures():
        assert abs(difference(feature["heading"], scene.truth[feature["filename"]].heading_deg)) < 1.0


def test_a_repaired_and_masked_skyline_is_what_snap_fits(panel, scene):
    hand, session = panel.hand, panel.session
    hand.press("repair")
    line = session.evidence.best
    factor = 800 / line.width_px
    hand.drag(*[(c * factor, float(line.row_px[c]) * factor) for c in range(100, 200, 10)])
    hand.press("brush")
    hand.click(700.0, float(line.row_px[int(700 / factor)]) * factor)
    assert (len(hand.draft.strokes), len(hand.draft.brush), hand.draft.anew) == (1, 1, False)
    assert "Masked" in hand.said
    panel.view.dock.grab()
    hand.press("correct")
    drag_right(panel, scene)
    hand.press("snap")
    hand.settle()
    assert error_deg(panel, scene) < 0.5
    hand.press("forget_drawing")
    assert hand.draft.strokes == hand.draft.brush == ()


def test_after_a_click_on_the_map_the_keys_go_to_the_picture_again(panel):
    hand, canvas = panel.hand, panel.view.dock.canvas
    hand.press("landmark")
    hand.click(400.0, 500.0)
    panel.view.dock.layer_box.setFocus()
    assert canvas.window().focusWidget() is not canvas
    hand.click_map(panel.session.ground.observer.longitude_deg + 0.02, panel.session.ground.observer.latitude_deg)
    assert canvas.window().focusWidget() is canvas and hand.said.startswith("One landmark.")


def test_facing_a_place_turns_the_camera(panel):
    hand, session = panel.hand, panel.session
    eye = session.ground.observer
    hand.press("face")
    hand.click_map(eye.longitude_deg + 0.05, eye.latitude_deg)
    assert hand.draft.pose.heading_deg == pytest.approx(90.0, abs=0.5) and hand.draft.pose.roll_deg == 0.0
    hand.press("undo")
    assert hand.draft.pose.heading_deg == pytest.approx(25.0)


def test_a_correction_waits_for_its_photograph(panel):
    hand, session = panel.hand, panel.session
    hand.press("correct")
    hand.drag((400, 300), (450, 300))
    changed = hand.draft
    hand.press("next")
    hand.settle()
    assert len(session.unkept()) == 1
    hand.press("previous")
    hand.settle()
    assert hand.draft == changed and "changed, not kept" in panel.view.dock.photo_label.text()


def test_a_layer_without_the_fields_gets_them(make_view, scene, tmp_path):
    from skyline_viewshed.core.base.attributes import photo_fields
    from skyline_viewshed.core.io.vector import PointRow, write_points

    path = tmp_path / "raw.gpkg"
    values = {"photo": str(scene.folder / "north.jpg"), "filename": "north"}
    specs = [spec for spec in photo_fields() if spec.name in ("photo", "filename")]
    write_points(path, specs, [PointRow((*scene.positions["north"], 0.0), values)])
    panel = make_view(path)
    assert panel.hand.draft.pose is None and "no heading yet" in panel.view.dock.photo_label.text()
    panel.hand.press("keep")
    assert "no heading" in panel.hand.said
    panel.hand.press("snap")
    panel.hand.settle()
    assert error_deg(panel, scene) < 0.5
    panel.hand.press("keep")
    row = panel.layer.getFeature(panel.session.item.fid)
    assert row["status"] == "confirmed" and row["hfov"] == pytest.approx(63.4, abs=1.0)
    panel.layer.rollBack()


def test_a_read_only_layer_gets_a_sentence(panel):
    panel.layer.setReadOnly(True)
    panel.hand.press("correct")
    panel.hand.drag((400, 300), (450, 300))
    panel.hand.press("keep")
    assert "read-only" in panel.hand.said and panel.session.history.changed
    panel.hand.press("review")
    panel.hand.key(Qt.Key.Key_A)
    assert "read-only" in panel.hand.said


def test_an_edit_elsewhere_leaves_an_unkept_correction(panel):
    hand, layer, fid = panel.hand, panel.layer, panel.session.item.fid
    hand.press("correct")
    hand.drag((400, 300), (450, 300))
    changed = hand.draft
    layer.startEditing()
    layer.beginEditCommand("elsewhere")
    layer.changeAttributeValue(fid, layer.fields().lookupField("status"), "rejected")
    layer.endEditCommand()
    hand.settle()
    assert hand.draft == changed and panel.session.item.status == "rejected"
    assert panel.view.dock.strip.currentItem().text() == "• north.jpg"
    layer.rollBack()


def test_a_folder_that_cannot_be_written_gets_a_sentence(panel, photos):
    (photos.parent / "photo_view").write_text("a file in the folder's place")
    panel.hand.press("brush")
    panel.hand.click(300, 200)
    panel.hand.press("keep")
    assert "cannot be written" in panel.hand.said and panel.session.history.changed
    panel.layer.rollBack()


def test_a_damaged_file_of_landmarks_is_not_written_over(panel, photos):
    folder = photos.parent / "photo_view"
    folder.mkdir()
    (folder / "landmarks.geojson").write_text("{")
    panel.session.show(panel.session.item.fid)
    panel.hand.settle()
    assert "not JSON" in panel.hand.said
    panel.hand.press("correct")
    panel.hand.drag((400, 300), (450, 300))
    panel.hand.press("brush")
    panel.hand.click(300, 200)
    panel.hand.press("keep")
    assert (folder / "landmarks.geojson").read_text() == "{" and "not JSON" in panel.hand.said
    panel.layer.rollBack()


def test_a_name_means_its_own_folder_only():
    from skyline_viewshed.panel.model.aids import means, name_of

    assert name_of("/a/day1/IMG_1.jpg") == "day1/IMG_1.jpg"
    assert means("day1/img_1.JPG", "/a/day1/IMG_1.jpg") and means("IMG_1.jpg", "/a/day1/IMG_1.jpg")
    assert not means("day2/IMG_1.jpg", "/a/day1/IMG_1.jpg") and not means("G_1.jpg", "/a/day1/IMG_1.jpg")
