"""The panel with real widgets, offscreen, on simulated photographs of known pose."""

from __future__ import annotations

import gc
from types import SimpleNamespace

import pytest
from panel_hand import Hand, write_photos
from qgis.core import QgsApplication, QgsProject, QgsRasterLayer, QgsRectangle, QgsSettings, QgsVectorLayer
from qgis.PyQt.QtTest import QTest


@pytest.fixture
def photos(scene, tmp_path):
    """The layer's file, in a folder of its own, where landmarks and masks go too."""
    path = tmp_path / "photos.gpkg"
    write_photos(path, scene)
    return path


@pytest.fixture
def make_panel(qgis_app, qgis_iface, qgis_new_project):
    """Open the panel on layers; an unforeseen error of the panel fails the test."""
    from skyline_viewshed.panel.controller import PhotoView

    QgsSettings().remove("skyline_viewshed")
    made, faults = [], []

    def note(text, tag, level):
        if "Traceback" in text:
            faults.append(text)

    QgsApplication.messageLog().messageReceived.connect(note)

    def make(layer, dem):
        project, layers = QgsProject.instance(), [layer, dem]
        assert layer.isValid() and dem.isValid()
        project.addMapLayers(layers)
        project.setCrs(layers[-1].crs())
        canvas = qgis_iface.mapCanvas()
        canvas.setDestinationCrs(layers[-1].crs())
        canvas.setExtent(QgsRectangle(layers[-1].extent()))
        view = PhotoView(qgis_iface)
        qgis_iface.mainWindow().show()
        view.dock.resize(900, 900)
        view.open()
        view.dock.show()
        made.append(view)
        hand = Hand(view)
        hand.settle()
        return SimpleNamespace(view=view, hand=hand, layer=layer, project=project, session=view.session, faults=faults)

    yield make
    for view in made:
        view.remove()
    QTest.qWait(20)
    qgis_new_project.clear()
    gc.collect()
    QgsApplication.messageLog().messageReceived.disconnect(note)
    assert not faults, faults[0]


@pytest.fixture
def make_view(make_panel, scene):
    """Open the panel on a file of photo points and the scene's elevation model."""
    return lambda path: make_panel(QgsVectorLayer(str(path), "photos", "ogr"), QgsRasterLayer(str(scene.dem), "dem"))


@pytest.fixture
def panel(make_view, photos):
    """The panel, open on the scene's photographs."""
    return make_view(photos)
