"""Measuring and digitising in the picture, and the viewshed of the photograph."""

from __future__ import annotations

import pytest
from qgis.core import QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from skyline_viewshed.panel.model.ground import place_of


def test_a_measured_line_gives_distance_and_height_difference(panel):
    hand, session = panel.hand, panel.session
    hand.press("distance")
    hand.click(350, 560)
    hand.click(450, 570)
    hand.settle()
    places = [place_of(session.ground, session.posed, *p) for p in ((350, 560), (450, 570))]
    rise = places[1].elevation_m - places[0].elevation_m
    said = float(hand.said.split("height difference ")[1].split(" m")[0].replace("\u2212", "-"))
    assert said == pytest.approx(rise, abs=1.0)  # rounded, and the pointer counts in whole pixels
    assert panel.view.marks._figure.numberOfVertices() == 2
    hand.click(450, 5)
    hand.settle()
    assert "cannot be measured" in hand.said
    hand.key(Qt.Key.Key_Escape)


def test_a_measured_area(panel):
    hand = panel.hand
    hand.press("area")
    for place in ((350, 560), (450, 560), (400, 580)):
        hand.click(*place)
    hand.settle()
    assert "Area on the map" in hand.said and ("m²" in hand.said or "km²" in hand.said)


@pytest.mark.parametrize("tool, clicks", [("point", 1), ("line", 2), ("polygon", 3)])
def test_what_is_drawn_becomes_a_feature_with_its_errors(panel, tool, clicks):
    hand = panel.hand
    hand.press(tool)
    for place in ((350, 560), (450, 565), (400, 580))[:clicks]:
        hand.click(*place)
    if tool != "point":
        hand.key(Qt.Key.Key_Return)
    hand.settle()
    layers = [layer for layer in panel.project.mapLayers().values() if "from photos" in layer.name()]
    assert len(layers) == 1 and "Drawn into the layer" in hand.said
    feature = next(layers[0].getFeatures())
    assert feature["photo"].endswith("north.jpg") and feature.geometry().get().is3D()
    assert feature["err_major" if tool == "point" else "err_med"] > 0
    layers[0].rollBack()


def test_drawing_goes_to_the_active_layer_if_that_is_edited(panel, qgis_iface):
    layer = QgsVectorLayer("Point?crs=EPSG:3857&field=dist_m:double&field=note:string", "mine", "memory")
    panel.project.addMapLayer(layer)
    layer.startEditing()
    qgis_iface.setActiveLayer(layer)
    panel.hand.press("point")
    panel.hand.click(400, 570)
    panel.hand.settle()
    feature = next(layer.getFeatures())
    assert feature["dist_m"] > 0 and abs(feature.geometry().asPoint().x()) > 100_000
    panel.hand.click(400, 3)
    panel.hand.settle()
    assert "shows no ground" in panel.hand.said and layer.featureCount() == 1
    layer.rollBack()


def test_the_viewshed_of_the_photograph_becomes_a_layer(panel, provider):
    panel.hand.press("viewshed")
    for _ in range(600):
        QTest.qWait(100)
        if "is in the project" in panel.hand.said or "could not" in panel.hand.said:
            break
    assert "is in the project" in panel.hand.said
    made = [layer for layer in panel.project.mapLayers().values() if layer.name().startswith("Viewshed of")]
    assert len(made) == 1 and isinstance(made[0], QgsRasterLayer) and made[0].isValid()
    panel.hand.press("next")
    panel.hand.settle()
    assert not panel.project.layerTreeRoot().findLayer(made[0].id()).itemVisibilityChecked()


def test_viewsheds_that_are_cancelled_end_without_a_layer(panel, provider):
    from skyline_viewshed.panel.model.viewsheds import _RUNNING, cancel_viewsheds

    panel.hand.press("viewshed")
    panel.hand.press("viewshed")
    assert len(_RUNNING) == 2  # the first one stays alive, since its task still uses it
    cancel_viewsheds()
    for _ in range(600):
        QTest.qWait(50)
        if not _RUNNING:
            break
    assert not _RUNNING and "Computing" in panel.hand.said
    assert not [layer for layer in panel.project.mapLayers().values() if layer.name().startswith("Viewshed of")]
