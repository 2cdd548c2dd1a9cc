"""The panel as a person uses it: open, go, hover, switch overlays, review; and what must never end in a traceback."""

from __future__ import annotations

import shutil

import numpy as np
import pytest
from panel_hand import write_photos
from qgis.core import QgsCoordinateReferenceSystem, QgsField, QgsPointXY, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt, QVariant
from qgis.PyQt.QtTest import QTest
from skyline_viewshed.panel.model.overlays import KINDS
from skyline_viewshed.panel.view.actions import specs

TOOL_ROW = {spec.name for spec in specs()}


def test_the_panel_opens_with_picture_and_horizon(panel):
    session, canvas = panel.session, panel.view.dock.canvas
    assert session.item.name == "north.jpg" and session.picture is not None
    assert session.ground is not None and session.evidence is not None
    assert canvas.size_px == (800, 600)
    assert {"horizon", "skyline", "alternatives"} <= {line.kind for line in canvas.lines}
    assert "north.jpg, heading 25.0" in panel.view.dock.photo_label.text()
    assert panel.view.dock.strip.count() == 2
    assert not panel.view.dock.grab().toImage().isNull()


def test_keys_go_to_the_next_the_previous_and_the_next_doubtful(panel):
    hand, session = panel.hand, panel.session
    hand.key(Qt.Key.Key_PageDown)
    assert session.item.name == "west.jpg" and panel.layer.selectedFeatureIds() == [session.item.fid]
    hand.key(Qt.Key.Key_PageDown)
    assert session.item.name == "west.jpg" and "no further photograph" in hand.said
    hand.key(Qt.Key.Key_PageUp)
    assert session.item.name == "north.jpg"
    hand.key(Qt.Key.Key_PageDown, Qt.KeyboardModifier.ControlModifier)
    assert session.item.name == "north.jpg"  # the other one is accepted
    hand.settle()


def test_a_selection_on_the_map_shows_the_photograph(panel):
    other = next(f.id() for f in panel.layer.getFeatures() if f["filename"] == "west")
    panel.layer.selectByIds([other])
    panel.hand.settle()
    assert panel.session.item.name == "west.jpg"
    assert panel.view.dock.strip.currentItem().text() == "west.jpg"


def test_the_mouse_in_the_picture_shows_place_and_ellipse_on_the_map(panel):
    hand, view = panel.hand, panel.view
    hand.hover(400, 560)
    QTest.qWait(100)
    hand.settle()
    assert "m high" in view.dock.place_label.text() and "km away" in view.dock.place_label.text()
    assert view.marks._place.isVisible() and view.marks._ellipse.numberOfVertices() > 20
    hand.hover(400, 5)
    QTest.qWait(100)
    hand.settle()
    assert view.dock.place_label.text().startswith("Sky") and not view.marks._place.isVisible()


def spot_at(panel, longitude, latitude):
    view = panel.view
    point = view.marks._to_map([longitude], [latitude])[0]
    view.iface.mapCanvas().xyCoordinates.emit(point)
    QTest.qWait(100)
    panel.hand.settle()
    return view.dock.canvas.spot.spot


def test_the_mouse_on_the_map_shows_the_spot_in_the_picture(panel):
    from skyline_viewshed.panel.model.ground import place_of

    session = panel.session
    place = place_of(session.ground, session.posed, 420, 540)
    spot = spot_at(panel, place.longitude_deg, place.latitude_deg)
    assert spot.state == "visible"
    assert (spot.x_px, spot.y_px) == pytest.approx((420, 540), abs=3)
    eye = session.ground.observer
    behind = spot_at(panel, eye.longitude_deg, eye.latitude_deg - 0.02)
    assert behind.state == "outside" and abs(behind.turn_deg) > 90
    panel.view.dock.grab()


def test_a_hidden_place_names_the_terrain_that_hides_it(panel):
    from skyline_viewshed.panel.view.spots import spot_words

    session = panel.session
    horizon, frame = session.ground.horizon, session.ground.terrain.frame(*panel_eye(session), 20_000.0)
    k = int(np.abs(horizon.azimuth_deg - session.draft.pose.heading_deg).argmin())
    turn, far = np.radians(horizon.azimuth_deg[k]), horizon.distance_m[k] + 1_500.0
    position = session.ground.terrain.position_of(*frame.to_pixel(far * np.sin(turn), far * np.cos(turn)))
    spot = spot_at(panel, *map(float, position))
    assert spot.state == "hidden" and spot.hidden_at_m < spot.distance_m
    assert spot_words(spot) == f"Hidden by terrain at {spot.hidden_at_m / 1000:.1f} km."


def panel_eye(session):
    return session.ground.observer.longitude_deg, session.ground.observer.latitude_deg


def test_every_overlay_can_be_switched(panel):
    dock = panel.view.dock
    outline = QgsVectorLayer("LineString?crs=EPSG:4326&field=name:string", "trail", "memory")
    from qgis.core import QgsFeature, QgsGeometry

    eye, feature = panel_eye(panel.session), QgsFeature(outline.fields())
    points = [QgsPointXY(eye[0] + 0.01 * k, eye[1] + 0.02) for k in range(-3, 4)]
    feature.setGeometry(QgsGeometry.fromPolylineXY(points))
    outline.dataProvider().addFeatures([feature])
    panel.project.addMapLayer(outline)
    panel.view.iface.mapCanvas().setLayers([outline])
    for kind in KINDS:
        dock.switches[kind].setChecked(True)
        panel.hand.settle()
    kinds = {line.kind for line in dock.canvas.lines} | {label.kind for label in dock.canvas.labels}
    assert set(KINDS) - {"map"} <= kinds and kinds & {"map", "hidden"}
    dock.grab()
    for kind in KINDS:
        dock.switches[kind].setChecked(False)
    QTest.qWait(50)
    assert dock.canvas.lines == []


def test_map_layers_follow_the_pose(panel):
    from qgis.core import QgsFeature, QgsGeometry

    outline = QgsVectorLayer("LineString?crs=EPSG:4326", "trail", "memory")
    eye, feature = panel_eye(panel.session), QgsFeature(outline.fields())
    points = [QgsPointXY(eye[0] + 0.02, eye[1] + 0.001 * k) for k in range(-3, 4)]
    feature.setGeometry(QgsGeometry.fromPolylineXY(points))
    outline.dataProvider().addFeatures([feature])
    panel.project.addMapLayer(outline)
    panel.view.iface.mapCanvas().setLayers([outline])
    panel.view.dock.switches["map"].setChecked(True)
    panel.hand.settle()
    canvas = panel.view.dock.canvas
    assert not {"map", "hidden"} & {line.kind for line in canvas.lines}  # it lies east, the camera looks north
    panel.hand.press("face")
    panel.hand.click_map(eye[0] + 0.02, eye[1])
    panel.hand.settle()
    assert {"map", "hidden"} & {line.kind for line in canvas.lines}


@pytest.mark.parametrize("width", [260, 420, 900])
def test_every_button_is_in_sight_whatever_the_width(panel, width):
    from qgis.PyQt.QtWidgets import QToolButton

    panel.hand.press("review")
    inside = panel.view.dock.widget()
    inside.setParent(None)
    inside.resize(width, 800)
    inside.show()
    QTest.qWait(50)
    shown = {button.defaultAction(): button for button in inside.findChildren(QToolButton) if button.isVisible()}
    wanted = [action for name, action in panel.view.dock.actions.items() if name in TOOL_ROW]
    verdicts = [shown[action] for action in panel.view.dock.verdicts.values()]
    assert all(button.geometry().right() < inside.width() and button.height() > 10 for button in verdicts)
    assert inside.width() == width  # nothing makes it wider
    assert len(wanted) > 20 and set(wanted) <= set(shown)
    assert all(shown[a].x() >= 0 and shown[a].geometry().right() < inside.width() for a in wanted)
    corners = {(shown[a].x(), shown[a].y()) for a in wanted}
    assert len(corners) == len(wanted)
    panel.view.dock.setWidget(inside)


def test_a_long_message_leaves_the_picture_its_room(panel):
    message = "The heading is doubtful because " + 20 * "of this and that "
    panel.layer.startEditing()
    panel.layer.changeAttributeValue(panel.session.item.fid, panel.layer.fields().lookupField("message"), message)
    panel.session.show(panel.session.item.fid)
    panel.hand.settle()
    label = panel.view.dock.photo_label
    assert "The heading is doubtful" in label.text() and label.text().endswith("...") and len(label.text()) < 220
    assert label.toolTip() == message
    panel.layer.rollBack()


def test_zoom_and_pan_keep_the_pixel_under_the_mouse(panel):
    canvas, hand = panel.view.dock.canvas, panel.hand
    before = hand.at(600, 300)
    hand.wheel(1, 600, 300)
    assert (hand.at(600, 300) - before).manhattanLength() <= 2 and canvas.scale > 1
    hand.drag((600, 300), (560, 280))
    assert canvas.to_picture(before) == pytest.approx((640, 320), abs=3)
    canvas.fit()
    assert canvas.to_widget(-0.5, -0.5)[0] >= -0.5


def test_review_takes_one_key_per_verdict(panel):
    hand, dock = panel.hand, panel.view.dock
    hand.press("review")
    assert (dock.progress.value(), dock.progress.maximum()) == (0, 2)
    hand.key(Qt.Key.Key_A)
    hand.settle()
    assert panel.session.item.name == "west.jpg"
    hand.key(Qt.Key.Key_S)
    assert "No photograph without a verdict" in hand.said
    hand.key(Qt.Key.Key_D)
    assert dock.progress.value() == 2
    assert sorted(f["review"] for f in panel.layer.getFeatures()) == ["accepted", "doubtful"]
    hand.press("previous")
    hand.key(Qt.Key.Key_R)
    assert sorted(f["review"] for f in panel.layer.getFeatures()) == ["doubtful", "rejected"]
    panel.layer.undoStack().undo()
    panel.layer.undoStack().undo()
    hand.settle()
    assert len([1 for f in panel.layer.getFeatures() if f["review"]]) == 1 and dock.progress.value() == 1
    hand.press("review")
    hand.key(Qt.Key.Key_A)
    assert not dock.review_bar.isVisible()
    panel.layer.rollBack()


def test_two_layers_and_a_removed_one(panel, photos, tmp_path):
    copy = tmp_path / "second.gpkg"
    shutil.copy(photos, copy)
    second = QgsVectorLayer(str(copy), "second", "ogr")
    panel.project.addMapLayer(second)
    panel.view.dock.layer_box.setLayer(second)
    panel.hand.settle()
    assert panel.session.photos.layer is second and panel.session.item is not None
    panel.project.removeMapLayer(second.id())
    panel.hand.settle()
    assert panel.session.item is None or panel.session.photos.layer is panel.layer
    panel.project.removeMapLayer(panel.layer.id())
    panel.hand.settle()
    assert panel.session.item is None
    for name in ("next", "snap", "keep", "undo", "viewshed", "face", "second"):
        panel.hand.press(name)
    panel.hand.drag((10, 10), (50, 50))


def test_an_elevation_model_removed_while_open(panel):
    dem = next(layer for layer in panel.project.mapLayers().values() if isinstance(layer, QgsRasterLayer))
    panel.project.removeMapLayer(dem.id())
    panel.hand.settle()
    assert panel.session.ground is None and "Choose an elevation model" in panel.hand.said
    panel.hand.press("correct")
    panel.hand.drag((400, 300), (450, 300))
    panel.hand.press("snap")
    assert "Nothing to fit yet" in panel.hand.said


def test_a_missing_photograph_still_shows_its_horizon(make_view, scene, tmp_path):
    path = tmp_path / "photos.gpkg"
    write_photos(path, scene, folder=tmp_path / "gone")
    panel = make_view(path)
    assert panel.session.picture is None and panel.session.ground is not None
    assert "north.jpg" in panel.hand.said
    assert "horizon" in {line.kind for line in panel.view.dock.canvas.lines}
    panel.view.dock.grab()


def write_previews(path, names):
    """Fill the field `preview` of a layer's file."""
    layer = QgsVectorLayer(str(path), "photos", "ogr")
    layer.startEditing()
    assert layer.addAttribute(QgsField("preview", QVariant.String)) or layer.fields().lookupField("preview") >= 0
    for feature in list(layer.getFeatures()):
        index = layer.fields().lookupField("preview")
        assert layer.changeAttributeValue(feature.id(), index, names[feature["filename"]])
    assert layer.commitChanges()


def test_a_photograph_that_moved_is_found_by_its_preview(make_view, scene, tmp_path):
    path = tmp_path / "photos.gpkg"
    write_photos(path, scene, folder="elsewhere")
    write_previews(path, {name: str(scene.folder / f"{name}.jpg") for name in scene.truth})
    panel = make_view(path)
    assert panel.session.item.path == str(scene.folder / "north.jpg")
    assert panel.session.picture is not None and panel.session.evidence is not None


def test_a_smaller_copy_is_shown_for_a_photograph_that_is_missing(make_view, scene, tmp_path):
    from PIL import Image

    path, folder = tmp_path / "photos.gpkg", tmp_path / "photos_previews"
    folder.mkdir()
    for name in scene.truth:
        Image.open(scene.folder / f"{name}.jpg").resize((400, 300)).save(folder / f"{name}_small.jpg")
    write_photos(path, scene, folder="elsewhere")
    write_previews(path, {name: f"photos_previews/{name}_small.jpg" for name in scene.truth})
    panel = make_view(path)
    canvas = panel.view.dock.canvas
    assert panel.session.picture is None and "north.jpg" in panel.hand.said
    assert canvas.levels[0].width() == 400 and canvas.notice == ""
    assert canvas.size_px == (800, 600)  # pixels count in the photograph
    panel.hand.press("snap")
    assert "picture" in panel.hand.said and "missing" in panel.hand.said


def test_a_damaged_photograph_gets_a_sentence(make_view, scene, tmp_path):
    folder = tmp_path / "damaged"
    folder.mkdir()
    (folder / "north.jpg").write_bytes((scene.folder / "north.jpg").read_bytes()[:3000])
    write_photos(tmp_path / "photos.gpkg", scene, folder=folder)
    panel = make_view(tmp_path / "photos.gpkg")
    assert "damaged" in panel.hand.said


def test_other_coordinates_of_the_project_and_a_turned_map(panel):
    canvas = panel.view.iface.mapCanvas()
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:4326"))
    first = QgsPointXY(panel.view.marks._wedge.getPoint(0, 0))
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:3857"))
    moved = panel.view.marks._wedge.getPoint(0, 0)
    assert abs(moved.x() - first.x()) > 1_000
    canvas.setRotation(30)
    panel.hand.hover(400, 560)
    QTest.qWait(100)
    panel.hand.settle()
    assert panel.view.marks._place.isVisible()
    longitude, latitude = panel.view.marks.position_of(moved)
    assert (longitude, latitude) == pytest.approx(panel_eye(panel.session), abs=1e-6)
    canvas.setRotation(0)


def test_a_layer_without_photographs_gets_a_sentence(panel):
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=name:string", "plain", "memory")
    panel.project.addMapLayer(layer)
    panel.view.dock.layer_box.setLayer(layer)
    assert "no field with the photographs" in panel.hand.said and panel.session.item is None


def test_a_photograph_outside_the_elevation_model_gets_a_sentence(panel):
    fid = panel.session.item.fid
    from qgis.core import QgsGeometry

    panel.layer.startEditing()
    panel.layer.changeGeometry(fid, QgsGeometry.fromPointXY(QgsPointXY(20.0, 20.0)))
    panel.session.show(fid)
    panel.hand.settle()
    assert "outside" in panel.hand.said.lower() and panel.session.ground is None
    panel.layer.rollBack()


def test_the_plugin_opens_and_removes_the_panel(qgis_iface, make_view, photos):
    from skyline_viewshed.plugin import SkylineViewshedPlugin

    make_view(photos)
    plugin = SkylineViewshedPlugin(qgis_iface)
    plugin._add_photo_view()
    plugin.photo_view_action.trigger()
    assert plugin.photo_view.dock.windowTitle() == "Photo view"
    plugin.unload()
    assert plugin.photo_view is None
