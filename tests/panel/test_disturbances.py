"""What happens to layers, project and plugin while the panel is open: no traceback, and a sentence where one helps.

The fixture `panel` fails a test after which a traceback is in the log.
"""

from __future__ import annotations

import shutil

import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest

ALL_STEPS = ("next", "previous", "doubtful", "snap", "second", "third", "undo", "redo", "keep", "viewshed", "face",
             "remove_landmarks", "forget_drawing", "fit", "review", "accepted", "skip", "review")  # fmt: skip


def use_everything(panel):
    """Press every button and use every tool."""
    hand = panel.hand
    for name in ALL_STEPS:
        hand.press(name)
    for name in (
        "look",
        "correct",
        "landmark",
        "draw",
        "repair",
        "brush",
        "distance",
        "area",
        "point",
        "line",
        "polygon",
    ):
        hand.press(name)
        hand.drag((300, 300), (350, 320), (400, 310))
        hand.key(Qt.Key.Key_Return)
        hand.wheel(1, 400, 300)
    hand.hover(400, 300)
    panel.view.iface.mapCanvas().xyCoordinates.emit(panel.view.iface.mapCanvas().extent().center())
    QTest.qWait(100)
    hand.settle()


def remove_layer(panel):
    panel.project.removeMapLayer(panel.layer.id())


def remove_dem(panel):
    dem = next(layer for layer in panel.project.mapLayers().values() if isinstance(layer, QgsRasterLayer))
    panel.project.removeMapLayer(dem.id())


def clear_project(panel):
    panel.project.clear()


def delete_feature(panel):
    panel.layer.startEditing()
    panel.layer.deleteFeature(panel.session.item.fid)


def delete_all_features(panel):
    panel.layer.startEditing()
    panel.layer.deleteFeatures(panel.session.photos.ids())


def delete_path_field(panel):
    panel.layer.startEditing()
    for name in ("photo", "filename"):
        panel.layer.deleteAttribute(panel.layer.fields().lookupField(name))


def filter_layer(panel):
    panel.layer.setSubsetString("filename = 'nobody'")


def other_crs(panel):
    canvas = panel.view.iface.mapCanvas()
    for name in ("EPSG:3857", "EPSG:3031", "EPSG:2056"):  # the second and third do not reach everywhere
        crs = QgsCoordinateReferenceSystem(name)
        panel.project.setCrs(crs)
        canvas.setDestinationCrs(crs)


def no_crs(panel):
    panel.project.setCrs(QgsCoordinateReferenceSystem())
    panel.view.iface.mapCanvas().setDestinationCrs(QgsCoordinateReferenceSystem())


def turned_map(panel):
    panel.view.iface.mapCanvas().setRotation(135.0)


def read_only(panel):
    panel.layer.setReadOnly(True)


def close_dock(panel):
    panel.view.dock.hide()


DISTURBANCES = [remove_layer, remove_dem, clear_project, delete_feature, delete_all_features, delete_path_field,
                filter_layer, other_crs, no_crs, turned_map, read_only, close_dock]  # fmt: skip


@pytest.mark.parametrize("disturb", DISTURBANCES)
def test_the_panel_goes_on_whatever_happens_to_the_project(panel, disturb):
    disturb(panel)
    panel.hand.settle()
    use_everything(panel)
    panel.view.iface.mapCanvas().setRotation(0.0)
    if disturb not in (remove_layer, clear_project):
        panel.layer.setReadOnly(False)
        panel.layer.rollBack()
    for layer in list(QgsProject.instance().mapLayers().values()):
        if isinstance(layer, QgsVectorLayer):
            layer.rollBack()


@pytest.mark.parametrize("disturb", [remove_layer, remove_dem, clear_project, delete_feature, delete_path_field])
def test_what_is_under_way_ends_quietly(panel, disturb):
    """Pictures, horizons, a fit, a hover, a drag and a click on the map that is waited for."""
    hand = panel.hand
    hand.press("landmark")
    hand.click(300, 300)
    hand.press("correct")
    hand.drag((400, 300), (430, 300))
    hand.press("snap")
    hand.hover(400, 560)
    left = Qt.MouseButton.LeftButton
    from qgis.PyQt.QtCore import QEvent

    hand.send(QEvent.Type.MouseButtonPress, hand.at(400, 300), left, left)
    disturb(panel)
    hand.send(QEvent.Type.MouseMove, hand.at(440, 310), Qt.MouseButton.NoButton, left)
    hand.send(QEvent.Type.MouseButtonRelease, hand.at(440, 310), left, Qt.MouseButton.NoButton)
    hand.settle()
    for layer in list(QgsProject.instance().mapLayers().values()):
        if isinstance(layer, QgsVectorLayer):
            layer.rollBack()


@pytest.mark.parametrize(
    "disturb, words",
    [
        (remove_layer, "Choose a layer"),
        (remove_dem, "Choose an elevation model"),
        (delete_feature, "no longer in the layer"),
        (delete_path_field, "no field with the photographs"),
        (filter_layer, "no longer in the layer"),
    ],
)
def test_a_sentence_says_what_happened(panel, disturb, words):
    disturb(panel)
    panel.hand.settle()
    assert words in panel.hand.said
    if disturb is not remove_layer:
        panel.layer.setSubsetString("") if disturb is filter_layer else panel.layer.rollBack()


def test_the_thumbnails_follow_the_layer(panel):
    strip, layer = panel.view.dock.strip, panel.layer
    panel.view.select(panel.session.photos.ids()[1])
    layer.startEditing()
    layer.deleteFeature(panel.session.photos.ids()[0])
    panel.hand.settle()
    assert strip.count() == 1 and strip.currentItem().text() == panel.session.item.name == "west.jpg"
    layer.undoStack().undo()
    panel.hand.settle()
    assert strip.count() == 2 and strip.currentItem().text() == "west.jpg"
    layer.rollBack()
    layer.setSubsetString("filename = 'north'")
    panel.hand.settle()
    assert strip.count() == 1 and strip.item(0).text() == "north.jpg"
    layer.setSubsetString("")
    panel.hand.settle()
    assert strip.count() == 2


def test_a_layer_that_gets_its_field_back_is_shown_again(panel):
    delete_path_field(panel)
    panel.hand.settle()
    assert panel.session.item is None and panel.view.dock.strip.count() == 0
    for _ in range(2):
        panel.layer.undoStack().undo()
    panel.hand.settle()
    assert panel.session.item is not None and panel.view.dock.strip.count() == 2
    panel.layer.rollBack()


def test_a_layer_that_is_removed_leaves_the_panel_to_another(panel, photos, tmp_path):
    copy = tmp_path / "second.gpkg"
    shutil.copy(photos, copy)
    second = QgsVectorLayer(str(copy), "second", "ogr")
    panel.project.addMapLayer(second)
    panel.view.dock.layer_box.setLayer(second)
    panel.hand.settle()
    panel.hand.press("correct")
    panel.hand.drag((400, 300), (450, 300))
    panel.view.dock.layer_box.setLayer(panel.layer)
    panel.hand.settle()
    assert panel.session.photos.layer is panel.layer and not panel.session.history.changed
    panel.project.removeMapLayer(second.id())
    panel.hand.settle()
    assert panel.session.photos.layer is panel.layer and panel.session.item is not None
    panel.hand.press("keep")
    assert panel.layer.getFeature(panel.session.item.fid)["status"] == "confirmed"
    panel.layer.rollBack()


def test_the_plugin_can_be_reloaded_while_work_is_under_way(qgis_iface, make_view, photos):
    from skyline_viewshed.plugin import SkylineViewshedPlugin

    first = make_view(photos)
    for _ in range(2):
        plugin = SkylineViewshedPlugin(qgis_iface)
        plugin._add_photo_view()
        plugin.photo_view_action.trigger()
        view = plugin.photo_view
        view.select(view.session.photos.ids()[-1])
        view.correction.snap()
        plugin.unload()
        QTest.qWait(100)
        first.layer.selectByIds([first.layer.selectedFeatureIds()[0]])
        first.layer.removeSelection()
        qgis_iface.mapCanvas().xyCoordinates.emit(qgis_iface.mapCanvas().extent().center())
        assert plugin.photo_view is None


def test_the_layer_can_be_saved_and_opened_again(panel, photos):
    hand = panel.hand
    hand.press("correct")
    hand.drag((400, 300), (450, 300))
    hand.press("keep")
    heading = hand.draft.pose.heading_deg
    assert panel.layer.commitChanges()
    hand.settle()
    assert hand.draft.pose.heading_deg == pytest.approx(heading) and panel.session.item.status == "confirmed"
    again = QgsVectorLayer(str(photos), "again", "ogr")
    row = next(f for f in again.getFeatures() if f["filename"] == "north")
    assert row["status"] == "confirmed" and row["heading"] == pytest.approx(heading % 360)
