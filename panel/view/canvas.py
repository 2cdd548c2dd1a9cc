"""The picture with its overlays: zoom and pan as in the map canvas; a tool decides what the mouse does."""

from __future__ import annotations

from typing import Any

import numpy as np
from qgis.PyQt.QtCore import QPointF, QRectF, QSizeF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPixmap, QPolygonF, QTextOption
from qgis.PyQt.QtWidgets import QWidget

from ...algorithms.shared.i18n import tr
from ..model.faults import guarded

PENS = {
    "horizon": ("#ff3b30", 2.0, False),
    "doubtful": ("#ff3b30", 2.0, True),
    "crests": ("#ffb340", 2.5, False),
    "skyline": ("#34c3ff", 1.6, False),
    "alternatives": ("#c77dff", 1.6, True),
    "graticule": ("#ffffff", 0.8, True),
    "map": ("#ffe94d", 1.8, False),
    "hidden": ("#ffffff", 1.2, True),
    "summits": ("#ffffff", 1.4, False),
    "drawn": ("#4cff88", 2.4, False),
    "landmark": ("#ff5bd1", 9.0, False),
    "sketch": ("#4cff88", 2.0, False),
    "spot": ("#4cff88", 12.0, False),
}
"""Colour, width [pixels of the screen] and whether dashed, by kind of line."""

CASING = QColor(16, 21, 28, 150)
BRUSH = QColor(255, 60, 60, 110)
NOTCH = 120.0
"""Angle of one notch of a wheel, in Qt's eighths of a degree."""

ZOOM_PER_NOTCH = 1.25
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
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(240, 160)
        self.setAccessibleName(tr("Photograph"))
        self.tool: Any = None
        self.levels: Any = ()
        self.size_px: Any = None
        self.lines: list[Any] = []
        self.labels: list[Any] = []
        self.brush: tuple[Any, ...] = ()
        self.sketch: list[Any] = []
        self.spot: Any = None
        self.notice = ""
        self.scale, self.origin = 1.0, QPointF(0.0, 0.0)
        self._fitted, self._background, self._grip = True, None, None
        self.say = self.failed.emit

    def show_picture(self, levels, size_px):
        """Show a picture from its smaller copies, or an empty frame of a size without any."""
        changed = size_px != self.size_px
        self.levels, self.size_px, self._background = levels, size_px, None
        if changed or self._fitted:
            self.fit()
        self.update()

    def show_overlays(self, lines, labels, brush=()):
        """Replace the lines, labels and brushed parts."""
        self.lines, self.labels, self.brush = lines, labels, brush
        self.update()

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
            self._grip = event.pos(), QPointF(self.origin)
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif self.tool is not None and self.size_px is not None:
            self.tool.press(self.to_picture(event.pos()), event)

    def _pans(self, event):
        free = self.tool is None or self.tool.pans
        return free and event.button() == Qt.MouseButton.LeftButton

    @guarded
    def mouseMoveEvent(self, event):
        """Pan, or pass the move on and report the pixel under the mouse."""
        if self._grip is not None:
            start, origin = self._grip
            self.origin, self._fitted, self._background = origin + QPointF(event.pos() - start), False, None
            self.update()
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
            self._grip = None
            self.unsetCursor()
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
        """Zoom the picture, unless the tool takes the wheel; with Ctrl it never does."""
        notches = event.angleDelta().y() / NOTCH
        control = event.modifiers() & Qt.KeyboardModifier.ControlModifier
        if self.tool is not None and not control and self.tool.wheel(notches, self.to_picture(event.position())):
            return
        self.zoom_by(ZOOM_PER_NOTCH**notches, QPointF(event.position()))

    @guarded
    def keyPressEvent(self, event):
        """Give the keys to the tool first."""
        if self.tool is None or not self.tool.key(event):
            super().keyPressEvent(event)

    def resizeEvent(self, event):
        """Keep the whole picture in view."""
        self._background = None
        if self._fitted:
            self.fit()

    @guarded
    def paintEvent(self, event):
        """Paint the picture, which is kept as it was last scaled, and the overlays over it."""
        painter = QPainter(self)
        if self._background is None or self._background.size() != self.size():
            self._background = self._scaled()
        painter.drawPixmap(0, 0, self._background)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self.brush and self.size_px is not None:
            self._paint_brush(painter)
        for line in (*self.lines, *self.sketch):
            self._paint_line(painter, line)
        taken: list[Any] = []
        for label in self.labels:
            self._paint_label(painter, label, taken)
        if self.spot is not None:
            self.spot.paint(self, painter)
        if self.notice:
            self._paint_notice(painter)

    def _scaled(self):
        pixmap = QPixmap(self.size())
        pixmap.fill(QColor(38, 40, 44))
        if self.size_px is None:
            return pixmap
        painter = QPainter(pixmap)
        whole = QRectF(self.origin, QSizeF(self.size_px[0] * self.scale, self.size_px[1] * self.scale))
        if not self.levels:
            painter.fillRect(whole, QColor(70, 74, 80))
            painter.end()
            return pixmap
        fine = [level for level in self.levels if level.width() >= whole.width()]
        level = fine[-1] if fine else self.levels[0]
        shown = whole.intersected(QRectF(self.rect()))
        factor = level.width() / max(whole.width(), 1e-9)
        source = QRectF((shown.topLeft() - whole.topLeft()) * factor, shown.size() * factor)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self.scale < 2)
        painter.drawImage(shown, level, source)
        painter.end()
        return pixmap

    def _paint_line(self, painter, line):
        colour, width, dashed = PENS[line.kind]
        x, y = self.to_widget(np.asarray(line.x_px, float), np.asarray(line.y_px, float))
        near = (np.abs(x - self.width() / 2) < self.width()) & (np.abs(y - self.height() / 2) < self.height())
        if line.dots:
            points = QPolygonF([QPointF(a, b) for a, b in zip(x[near].tolist(), y[near].tolist())])
            for shade, extra in ((CASING, 1.5), (QColor(colour), 0.0)):
                painter.setPen(QPen(shade, width + extra, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
                painter.drawPoints(points)
            return
        style = Qt.PenStyle.DashLine if dashed else Qt.PenStyle.SolidLine
        cuts = np.flatnonzero(~near)
        runs = [run for run in np.split(np.arange(near.size), cuts) if run.size]
        runs = [run if near[run[0]] else run[1:] for run in runs]
        polygons = [QPolygonF([QPointF(x[k], y[k]) for k in run.tolist()]) for run in runs if run.size > 1]
        for shade, extra in ((CASING, 1.6), (QColor(colour), 0.0)):
            painter.setPen(QPen(shade, width + extra, style if extra == 0 else Qt.PenStyle.SolidLine))
            for polygon in polygons:
                painter.drawPolyline(polygon)

    def _paint_brush(self, painter):
        for stroke in self.brush:
            pen = QPen(BRUSH, 2 * stroke.radius_px * self.scale, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap)
            pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
            painter.setPen(pen)
            points = [QPointF(*self.to_widget(*point)) for point in stroke.points]
            painter.drawPolyline(QPolygonF(points if len(points) > 1 else points * 2))

    def _paint_label(self, painter, label, taken):
        """Paint a label unless a more important one has its place."""
        x, y = self.to_widget(label.x_px, label.y_px)
        metrics = QFontMetricsF(painter.font())
        width, height = metrics.horizontalAdvance(label.text), metrics.height()
        box = QRectF(min(x + 4, self.width() - width - 2), min(max(y - height - 3, 1), self.height() - height), width,
                     height)  # fmt: skip
        if not QRectF(self.rect()).contains(QPointF(x, y)) or any(box.intersects(other) for other in taken):
            return
        taken.append(box)
        if label.kind in ("summits", "map"):
            painter.setPen(QPen(QColor("#ffffff"), 4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawPoint(QPointF(x, y))
        painter.fillRect(box.adjusted(-2, 0, 2, 0), CASING)
        painter.setPen(QColor(PENS[label.kind][0]))
        painter.drawText(box, label.text, QTextOption(Qt.AlignmentFlag.AlignCenter))

    def _paint_notice(self, painter):
        layout = QTextOption(Qt.AlignmentFlag.AlignCenter)
        layout.setWrapMode(QTextOption.WrapMode.WordWrap)
        painter.setPen(QColor("#ffffff"))
        painter.drawText(QRectF(self.rect()).adjusted(20, 20, -20, -20), self.notice, layout)
