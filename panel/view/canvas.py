"""The picture with its overlays: zoom and pan as in the map canvas; a tool decides what the mouse does."""

from __future__ import annotations

from typing import Any

import numpy as np
from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QPointF, QRectF, QSizeF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QCursor, QPainter, QPixmap
from qgis.PyQt.QtWidgets import QWidget

from ...algorithms.shared.i18n import tr
from ..model.faults import guarded
from ..model.identity import same
from ..model.overlays import Drawing
from .painting import paint_brush, paint_label, paint_line, paint_notice

NOTCH = 120.0
"""Angle of one notch of a wheel, in Qt's eighths of a degree."""

ZOOM_PER_NOTCH, FINER = 2.0, 20.0
"""Factor of one notch and how much smaller its step is with Ctrl, as in QGIS, where the user may set the first."""

PAN_SHARE = 0.25
"""Share of the widget by which an arrow key moves the picture, as in the map canvas."""

ARROWS = {
    Qt.Key.Key_Left: (1, 0),
    Qt.Key.Key_Right: (-1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}
MOST_ZOOM = 16.0
"""Screen pixels per pixel of the picture."""


class PictureCanvas(QWidget):
    """Shows one picture.

    Attributes
    ----------
    tool : Tool
        Gets the mouse in pixels of the picture; the middle button and the wheel belong to the canvas unless the tool
        takes the wheel.
    """

    hovered = pyqtSignal(float, float)
    left = pyqtSignal()
    failed = pyqtSignal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(240, 160)
        self.setAccessibleName(tr("Photograph"))
        self.tool: Any = None
        self.levels: Any = ()
        self.size_px: Any = None
        self.drawing: Any = Drawing()
        self.brush: tuple[Any, ...] = ()
        self.sketch: list[Any] = []
        self.spot: Any = None
        self.notice = ""
        self.scale, self.origin = 1.0, QPointF(0.0, 0.0)
        self._fitted, self._background, self._grip = True, None, None
        self._still: Any = None
        self._still_of: tuple[Any, ...] = ()
        self.say = self.failed.emit

    def show_picture(self, levels, size_px):
        """Show a picture from its smaller copies, or an empty frame of a size without any."""
        changed = size_px != self.size_px
        self.levels, self.size_px, self._background = levels, size_px, None
        if changed or self._fitted:
            self.fit()
        self.update()

    def show_overlays(self, drawing, brush=()):
        """Replace the lines, labels and brushed parts.

        Parameters
        ----------
        drawing : Drawing
        brush : tuple of BrushStroke
        """
        self.drawing, self.brush = drawing, brush
        self.update()

    @property
    def lines(self):
        """All lines."""
        return [*self.drawing.still, *self.drawing.moving]

    @property
    def labels(self):
        """All labels."""
        return self.drawing.labels

    def fit(self):
        """Show the whole picture."""
        if self.size_px is None:
            return
        width, height = self.size_px
        self.scale = min(self.width() / width, self.height() / height)
        self.origin = QPointF((self.width() - width * self.scale) / 2, (self.height() - height * self.scale) / 2)
        self._fitted, self._background = True, None
        self.update()

    def zoom_by(self, factor, at=None):
        """Zoom about a place of the widget, by default its middle."""
        if self.size_px is None:
            return
        at = at or QPointF(self.width() / 2, self.height() / 2)
        least = 0.5 * min(self.width() / self.size_px[0], self.height() / self.size_px[1])
        scale = float(np.clip(self.scale * factor, least, MOST_ZOOM))
        self.origin = at - (at - self.origin) * (scale / self.scale)
        self.scale, self._fitted, self._background = scale, False, None
        self.update()

    def to_picture(self, position):
        """Pixel (x, y) of the picture at a place of the widget."""
        return (position.x() - self.origin.x()) / self.scale - 0.5, (position.y() - self.origin.y()) / self.scale - 0.5

    def to_widget(self, x_px, y_px):
        """Place of the widget at a pixel of the picture; arrays give arrays."""
        return (x_px + 0.5) * self.scale + self.origin.x(), (y_px + 0.5) * self.scale + self.origin.y()

    def holds(self, x_px, y_px):
        """Return whether a pixel lies on the picture."""
        if self.size_px is None:
            return False
        return -0.5 <= x_px <= self.size_px[0] - 0.5 and -0.5 <= y_px <= self.size_px[1] - 0.5

    @guarded
    def mousePressEvent(self, event):
        """Begin to pan, or pass the press to the tool."""
        self.setFocus()
        if event.button() == Qt.MouseButton.MiddleButton or self._pans(event):
            self._take_grip(event.pos())
        elif self.tool is not None and self.size_px is not None:
            self.tool.press(self.to_picture(event.pos()), event)

    def _take_grip(self, place):
        self._grip = place, QPointF(self.origin)
        self.setCursor(Qt.CursorShape.ClosedHandCursor)

    def _let_go(self):
        self._grip = None
        self.unsetCursor()

    def _pans(self, event):
        free = self.tool is None or self.tool.pans
        return free and event.button() == Qt.MouseButton.LeftButton

    @guarded
    def mouseMoveEvent(self, event):
        """Pan, or pass the move on and report the pixel under the mouse."""
        if self._grip is not None:
            start, origin = self._grip
            self._move_to(origin + QPointF(event.pos() - start))
            return
        place = self.to_picture(event.pos())
        if self.tool is not None and self.size_px is not None:
            self.tool.move(place, event)
        if self.holds(*place):
            self.hovered.emit(*place)
        else:
            self.left.emit()

    @guarded
    def mouseReleaseEvent(self, event):
        """End what the press began."""
        if self._grip is not None:
            self._let_go()
        elif self.tool is not None and self.size_px is not None:
            self.tool.release(self.to_picture(event.pos()), event)

    @guarded
    def mouseDoubleClickEvent(self, event):
        """Finish a drawing, or show the whole picture."""
        if self.tool is not None and not self.tool.pans:
            self.tool.finish()
        else:
            self.fit()

    def leaveEvent(self, event):
        """Report that the mouse has left the picture."""
        self.left.emit()

    @guarded
    def wheelEvent(self, event):
        """Zoom the picture as the map, unless the tool takes the wheel, which it does not with Ctrl."""
        notches = event.angleDelta().y() / NOTCH
        control = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        wheels = self.tool is not None and self.tool.wheels
        if wheels and not control:
            self.tool.wheel(notches, self.to_picture(event.position()))
            return
        settings = QgsSettings()
        if settings.value("qgis/reverse_wheel_zoom", False, type=bool):
            notches = -notches
        step = settings.value("qgis/zoom_factor", ZOOM_PER_NOTCH, type=float) - 1.0
        self.zoom_by((1.0 + step / (FINER if control and not wheels else 1.0)) ** notches, QPointF(event.position()))

    @guarded
    def keyPressEvent(self, event):
        """Give the keys to the tool first; then arrows and a held space bar pan, plus and minus zoom, as on the map."""
        key = event.key()
        if self.tool is not None and self.tool.key(event):
            return
        if key in ARROWS:
            right, down = ARROWS[key]
            self._move_to(self.origin + PAN_SHARE * QPointF(right * self.width(), down * self.height()))
        elif key in (Qt.Key.Key_Plus, Qt.Key.Key_Minus):
            self.zoom_by(ZOOM_PER_NOTCH if key == Qt.Key.Key_Plus else 1 / ZOOM_PER_NOTCH)
        elif key == Qt.Key.Key_Space:
            if not event.isAutoRepeat():
                self._take_grip(self.mapFromGlobal(QCursor.pos()))
        else:
            super().keyPressEvent(event)

    @guarded
    def keyReleaseEvent(self, event):
        """End panning with the space bar."""
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._let_go()
        else:
            super().keyReleaseEvent(event)

    def _move_to(self, origin):
        if self.size_px is not None:
            self.origin, self._fitted, self._background = origin, False, None
            self.update()

    def resizeEvent(self, event):
        """Keep the whole picture in view."""
        self._background = None
        if self._fitted:
            self.fit()

    @guarded
    def paintEvent(self, event):
        """Paint the picture with all that does not follow the pose, which is kept as a pixmap, and the rest over it."""
        painter = QPainter(self)
        if self._background is None or self._background.devicePixelRatioF() != self.devicePixelRatioF():
            self._background, self._still_of = self._scaled(), ()
        present = self.drawing.still, self.brush
        if not same(self._still_of, present):
            self._still, self._still_of = self._with_still(), present
        painter.drawPixmap(0, 0, self._still)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for line in (*self.drawing.moving, *self.sketch):
            paint_line(self, painter, line)
        taken: list[Any] = []
        for label in self.labels:
            paint_label(self, painter, label, taken)
        if self.spot is not None:
            self.spot.paint(self, painter)
        if self.notice:
            paint_notice(self, painter)

    def _with_still(self):
        """The background with what is brushed and with the lines that do not follow the pose."""
        pixmap = QPixmap(self._background)
        if self.size_px is None:
            return pixmap
        painter = QPainter(pixmap)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        paint_brush(self, painter)
        for line in self.drawing.still:
            paint_line(self, painter, line)
        painter.end()
        return pixmap

    def _scaled(self):
        """The part of the picture that is in view, as fine as the screen."""
        ratio = self.devicePixelRatioF()
        pixmap = QPixmap(self.size() * ratio)
        pixmap.setDevicePixelRatio(ratio)
        pixmap.fill(QColor(38, 40, 44))
        if self.size_px is None:
            return pixmap
        painter = QPainter(pixmap)
        whole = QRectF(self.origin, QSizeF(self.size_px[0] * self.scale, self.size_px[1] * self.scale))
        if not self.levels:
            painter.fillRect(whole, QColor(70, 74, 80))
            painter.end()
            return pixmap
        fine = [level for level in self.levels if level.width() >= whole.width() * ratio]
        level = fine[-1] if fine else self.levels[0]
        shown = whole.intersected(QRectF(self.rect()))
        factor = level.width() / max(whole.width(), 1e-9)
        source = QRectF((shown.topLeft() - whole.topLeft()) * factor, shown.size() * factor)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self.scale < 2)
        painter.drawImage(shown, level, source)
        painter.end()
        return pixmap
