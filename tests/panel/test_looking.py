"""What the panel shows and how a person moves in it: keys, thumbnails, zoom, the background, bounded memory."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsSettings, QgsVectorLayer
from qgis.PyQt.QtCore import QEvent, Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QToolButton
from skyline_viewshed.panel.model import pictures
from skyline_viewshed.panel.model.overlays import KINDS
from skyline_viewshed.panel.view.actions import key_text, specs, verdict_specs
from skyline_viewshed.panel.view.painting import _runs

CTRL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


def test_a_click_on_a_thumbnail_shows_its_photograph(panel):
    strip = panel.view.dock.strip
    place = strip.visualItemRect(strip.item(1)).center()
    QTest.mouseClick(strip.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
    panel.hand.settle()
    assert panel.session.item.name == "west.jpg" and panel.layer.selectedFeatureIds() == [panel.session.item.fid]


def test_thumbnails_are_pictures(panel):
    strip = panel.view.dock.strip
    QTest.qWait(200)
    panel.hand.settle()
    image = strip.item(1).icon().pixmap(96, 72).toImage()
    assert len({image.pixel(x, y) for x in range(0, image.width(), 8) for y in range(0, image.height(), 8)}) > 10


@pytest.mark.parametrize("number, kind", list(enumerate(KINDS)))
def test_every_overlay_has_its_key(panel, number, kind):
    switch = panel.view.dock.switches[kind]
    before = switch.isChecked()
    panel.hand.key(Qt.Key.Key_F1 + number, SHIFT)
    assert switch.isChecked() is not before and f"F{number + 1}" in switch.toolTip()
    panel.hand.key(Qt.Key.Key_F1 + number, SHIFT)


def test_the_next_doubtful_photograph_is_the_next_one_with_such_a_status(panel):
    fids = panel.session.photos.ids()
    panel.layer.startEditing()
    for fid, status in zip(fids, ("accepted", "rejected")):
        panel.layer.changeAttributeValue(fid, panel.layer.fields().lookupField("status"), status)
    panel.view.select(fids[0])
    panel.hand.key(Qt.Key.Key_PageDown, CTRL)
    assert panel.session.item.fid == fids[1]
    panel.hand.settle()
    panel.layer.rollBack()


def test_the_wheel_zooms_as_on_the_map(panel):
    canvas, hand = panel.view.dock.canvas, panel.hand
    whole = canvas.scale
    hand.wheel(1, 400, 300)
    assert canvas.scale == pytest.approx(2 * whole)
    hand.wheel(1, 400, 300, CTRL)
    assert canvas.scale == pytest.approx(2 * 1.05 * whole)
    canvas.fit()
    QgsSettings().setValue("qgis/zoom_factor", 1.5)
    QgsSettings().setValue("qgis/reverse_wheel_zoom", True)
    hand.wheel(-1, 400, 300)
    QgsSettings().remove("qgis/zoom_factor")
    QgsSettings().remove("qgis/reverse_wheel_zoom")
    assert canvas.scale == pytest.approx(1.5 * whole)


def test_keys_the_middle_button_and_the_space_bar_pan_as_on_the_map(panel):
    canvas, hand = panel.view.dock.canvas, panel.hand
    hand.press("brush")  # no tool is in the way
    hand.wheel(1, 400, 300)
    start = canvas.to_picture(hand.at(400, 300))
    hand.drag((400, 300), (360, 300), button=Qt.MouseButton.MiddleButton)
    assert canvas.to_picture(canvas.rect().center())[0] > start[0] and not hand.draft.brush
    hand.press("look")
    before = canvas.origin
    hand.key(Qt.Key.Key_Right)
    hand.key(Qt.Key.Key_Down)
    moved = canvas.origin - before
    assert (moved.x(), moved.y()) == pytest.approx((-canvas.width() / 4, -canvas.height() / 4))
    scale = canvas.scale
    hand.key(Qt.Key.Key_Plus)
    hand.key(Qt.Key.Key_Minus)
    assert canvas.scale == pytest.approx(scale)
    QTest.keyPress(canvas, Qt.Key.Key_Space)
    before = canvas.origin
    none = Qt.MouseButton.NoButton
    hand.send(QEvent.Type.MouseMove, hand.at(500, 300), none, none)
    hand.send(QEvent.Type.MouseMove, hand.at(450, 300), none, none)
    QTest.keyRelease(canvas, Qt.Key.Key_Space)
    assert canvas.origin != before
    before = canvas.origin
    hand.hover(300, 300)
    assert canvas.origin == before


def test_a_double_click_shows_the_whole_picture(panel):
    canvas, hand = panel.view.dock.canvas, panel.hand
    whole = canvas.scale
    hand.wheel(2, 100, 100)
    QTest.mouseDClick(canvas, Qt.MouseButton.LeftButton)
    assert canvas.scale == pytest.approx(whole)


def test_pictures_and_the_terrain_are_read_in_the_background(panel, monkeypatch):
    threads, main, whole = [], threading.current_thread(), pictures.open_picture

    def noted(path):
        threads.append(threading.current_thread())
        return whole(path)

    monkeypatch.setattr(pictures, "open_picture", noted)
    panel.session.pictures.clear()
    panel.session.show(panel.session.item.fid)
    assert panel.session.picture is None and panel.session.ground is None
    assert "Opening" in panel.view.dock.canvas.notice
    panel.hand.settle()
    assert panel.session.picture is not None and panel.session.ground is not None
    assert threads and main not in threads


def test_pictures_take_no_more_memory_than_allowed(panel, monkeypatch):
    one = panel.session.picture.size
    monkeypatch.setattr(pictures, "MOST_BYTES", 1.5 * one)
    panel.session.pictures.clear()
    for _ in range(3):
        for fid in panel.session.photos.ids():
            panel.view.select(fid)
            panel.hand.settle()
            assert panel.session.pictures.size <= 1.5 * one


@pytest.mark.parametrize("alternatives", [True, False])
def test_the_horizon_follows_a_mouse_that_does_not_rest(panel, alternatives):
    hand, canvas = panel.hand, panel.view.dock.canvas
    hand.press("correct")
    if not alternatives:
        panel.view.dock.switches["alternatives"].setChecked(False)
        hand.settle()
    left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    still, seen = canvas.drawing.still, set()
    hand.send(QEvent.Type.MouseButtonPress, hand.at(400, 300), left, left)
    for step in range(120):
        hand.send(QEvent.Type.MouseMove, hand.at(400 + step, 300), none, left)
        QTest.qWait(1)
        seen.add(canvas.drawing)
    assert len(seen) > 5 and canvas.drawing.still is still  # what does not follow the pose is not drawn anew
    assert "25.0" not in panel.view.dock.photo_label.text()
    hand.send(QEvent.Type.MouseButtonRelease, hand.at(520, 300), left, none)


def test_lines_lose_only_vertices_in_the_same_pixel():
    x = np.array([0.1, 0.2, 0.9, 1.5, np.nan, 3.0, 3.1, 9.0])
    runs = _runs(x, np.zeros(8), np.isfinite(x))
    assert [run.tolist() for run in runs] == [[0, 3], [5, 7]]


def test_the_picture_is_as_sharp_as_the_screen(panel, monkeypatch):
    canvas = panel.view.dock.canvas
    monkeypatch.setattr(type(canvas), "devicePixelRatioF", lambda self: 2.0)
    pixmap = canvas._scaled()
    assert pixmap.width() == 2 * canvas.width() and pixmap.devicePixelRatio() == 2.0


def test_the_ground_in_view_of_the_selected_photograph_is_highlighted(panel):
    eye, path = panel.session.ground.observer, panel.session.item.path
    other = next(f["photo"] for f in panel.layer.getFeatures() if f["photo"] != path)
    seen = QgsVectorLayer("Polygon?crs=EPSG:4326&field=photo:string", "Ground in view", "memory")
    features = []
    for number, photo in enumerate((path, other)):
        feature = QgsFeature(seen.fields())
        feature["photo"] = photo
        middle = QgsGeometry.fromPointXY(QgsPointXY(eye.longitude_deg, eye.latitude_deg + 0.01 * number))
        feature.setGeometry(middle.buffer(0.002, 4))
        features.append(feature)
    seen.dataProvider().addFeatures(features)
    panel.project.addMapLayer(seen)
    band, shown = panel.view.marks._ground, []
    for _ in range(2):
        panel.hand.press("next" if shown else "previous")
        panel.view._show_marks()
        shown.append(band.asGeometry().boundingBox().center())
        panel.hand.settle()
    assert band.isVisible() and shown[0] != shown[1]


def test_a_place_outside_the_picture_gets_an_arrow(panel):
    canvas, eye = panel.view.dock.canvas, panel.session.ground.observer
    plain = canvas.grab().toImage()
    point = panel.view.marks._to_map([eye.longitude_deg + 0.05], [eye.latitude_deg - 0.02])[0]
    panel.view.iface.mapCanvas().xyCoordinates.emit(point)
    QTest.qWait(100)
    panel.hand.settle()
    assert "to the right of its middle" in panel.view.dock.place_label.text()
    marked = canvas.grab().toImage()
    x = marked.width() - 10
    assert any(marked.pixel(x, y) != plain.pixel(x, y) for y in range(marked.height()))


def focusable(panel):
    """Widgets of the dock in the order of the Tab key, from the first box on."""
    first = widget = panel.view.dock.layer_box
    found = []
    while True:
        if widget.focusPolicy() & Qt.FocusPolicy.TabFocus and panel.view.dock.isAncestorOf(widget):
            found.append(widget)
        widget = widget.nextInFocusChain()
        if widget is first:
            return found


def test_the_tab_key_reaches_everything_from_top_to_bottom(panel):
    dock = panel.view.dock
    order = focusable(panel)
    tools = {button.defaultAction(): button for button in dock.findChildren(QToolButton) if button.defaultAction()}
    wanted = [dock.layer_box, dock.dem_box]
    wanted += [tools[dock.actions[spec.name]] for spec in specs()]
    wanted += [dock.canvas, *(tools[action] for action in dock.verdicts.values()), dock.strip]
    places = [order.index(widget) for widget in wanted]
    assert places == sorted(places)


def test_keys_work_while_a_button_has_the_focus(panel):
    dock = panel.view.dock
    button = next(b for b in dock.findChildren(QToolButton) if b.defaultAction() is dock.actions["snap"])
    QTest.keyClick(button, Qt.Key.Key_PageDown)
    assert panel.session.item.name == "west.jpg"
    panel.hand.settle()


def test_tooltips_name_the_keys(panel):
    dock = panel.view.dock
    for known, actions in ((specs(), dock.actions), (verdict_specs(), dock.verdicts)):
        for spec in known:
            tip = actions[spec.name].toolTip()
            assert spec.tip in tip and (not spec.key or f"({key_text(spec.key)})" in tip), spec.name
    assert key_text((Qt.Key.Key_Z, True, True)) == "Ctrl+Shift+Z"


def test_map_layers_appear_where_map_to_pixels_puts_them(panel, provider, scene):
    import processing
    from skyline_viewshed.panel.model.ground import place_of

    session = panel.session
    huts = QgsVectorLayer("Point?crs=EPSG:4326&field=name:string", "huts", "memory")
    features = []
    for name, pixel in (("Hut", (250, 560)), ("Tarn", (520, 540))):
        place = place_of(session.ground, session.posed, *pixel)
        feature = QgsFeature(huts.fields())
        feature["name"] = name
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(place.longitude_deg, place.latitude_deg)))
        features.append(feature)
    huts.dataProvider().addFeatures(features)
    panel.project.addMapLayer(huts)
    panel.view.iface.mapCanvas().setLayers([huts])
    panel.view.dock.switches["map"].setChecked(True)
    panel.hand.settle()
    shown = {label.text: (label.x_px, label.y_px) for label in panel.view.dock.canvas.labels if label.kind == "map"}
    given = {"INPUT": panel.layer, "DEM": str(scene.dem), "FEATURES": huts, "NAME_FIELD": "name", "STATUSES": [0, 1, 2],
             "OUTPUT": "memory:"}  # fmt: skip
    rows = [row for row in processing.run("skylineviewshed:maptopixel", given)["OUTPUT"].getFeatures()
            if row["photo"].endswith("north.jpg")]  # fmt: skip
    assert {row["name"] for row in rows} == set(shown) == {"Hut", "Tarn"}
    for row in rows:
        assert (row["x_px"], row["y_px"]) == pytest.approx(shown[row["name"]], abs=0.6)
