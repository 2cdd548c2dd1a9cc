"""Room for the picture: the panel's first width, and words that fit a narrow picture."""

from __future__ import annotations

from types import SimpleNamespace

from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QImage, QPainter
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QMainWindow
from skyline_viewshed.panel.controller import PhotoView
from skyline_viewshed.panel.model.ground import Spot
from skyline_viewshed.panel.view.spots import SpotMark


def test_the_panel_is_wide_when_it_is_first_opened(qgis_app, qgis_new_project):
    window = QMainWindow()
    canvas = QgsMapCanvas(window)
    window.setCentralWidget(canvas)
    window.resize(1500, 900)
    window.show()
    desk = SimpleNamespace(
        mainWindow=lambda: window,
        mapCanvas=lambda: canvas,
        activeLayer=lambda: None,
        addDockWidget=window.addDockWidget,
        removeDockWidget=window.removeDockWidget,
    )
    view = PhotoView(desk)
    view.open()
    QTest.qWait(200)
    assert 0.4 * window.width() < view.dock.width() < 0.5 * window.width()
    window.resizeDocks([view.dock], [400], Qt.Orientation.Horizontal)
    view.dock.hide()
    view.open()
    QTest.qWait(200)
    assert view.dock.width() == 400
    view.remove()
    window.close()


def test_a_long_sentence_about_a_place_stays_in_a_narrow_picture(panel):
    canvas = panel.view.dock.canvas
    boxes = []

    class Watched(QPainter):
        def drawText(self, box, *rest):
            boxes.append(box)
            super().drawText(box, *rest)

    spot = Spot("outside", float("nan"), float("nan"), 120.0, 5_000.0, float("nan"))
    for width in (250, 900):
        canvas.resize(width, 500)
        image = QImage(canvas.size(), QImage.Format.Format_RGB32)  # a painter does not keep it
        painter = Watched(image)
        SpotMark(spot, panel.hand.draft.camera).paint(canvas, painter)
        painter.end()
    assert all(box.left() >= 0 and box.right() <= width for box, width in zip(boxes, (250, 900)))
    assert boxes[0].height() > 1.5 * boxes[1].height()
