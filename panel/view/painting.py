"""Paints lines, brushed parts and labels over the picture."""

from __future__ import annotations

import numpy as np
from qgis.PyQt.QtCore import QLineF, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPen, QPolygonF, QTextOption

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

CASING = QColor(16, 21, 28, 110)
LABEL_GROUND = QColor(16, 21, 28, 215)
BRUSH = QColor(255, 60, 60, 110)
SMALL_PX = 4.0


def paint_line(canvas, painter, line):
    """Paint a line, or dots.

    Parameters
    ----------
    canvas : PictureCanvas
    painter : QPainter
    line : Line
    """
    colour, width, dashed = PENS[line.kind]
    x, y = canvas.to_widget(np.asarray(line.x_px, float), np.asarray(line.y_px, float))
    near = (np.abs(x - canvas.width() / 2) < canvas.width()) & (np.abs(y - canvas.height() / 2) < canvas.height())
    if line.dots:
        _paint_dots(painter, np.rint(np.stack([x[near], y[near]])), colour, width)
        return
    runs = _runs(x, y, near)
    ends = [np.stack([x[run[:-1]], y[run[:-1]], x[run[1:]], y[run[1:]]]).tolist() for run in runs]
    segments = [segment for columns in ends for segment in map(QLineF, *columns)]
    for shade, extra in ((CASING, 1.6), (QColor(colour), 0.0)):
        if dashed and not extra:  # dashes go on from segment to segment
            painter.setPen(QPen(shade, width, Qt.PenStyle.DashLine))
            for run in runs:
                painter.drawPolyline(QPolygonF(list(map(QPointF, x[run].tolist(), y[run].tolist()))))
        else:  # Qt paints single segments in a fifth of the time of a polyline
            painter.setPen(QPen(shade, width + extra))
            painter.drawLines(segments)


def _paint_dots(painter, places, colour, width):
    """Paint large dots round, and small ones, of which there are many, as squares, which takes a third of the time."""
    cap = Qt.PenCapStyle.SquareCap if width < SMALL_PX else Qt.PenCapStyle.RoundCap
    points = QPolygonF(list(map(QPointF, *np.unique(places, axis=1).tolist())))
    for shade, extra in ((CASING, 1.5), (QColor(colour), 0.0)):
        painter.setPen(QPen(shade, width + extra, Qt.PenStyle.SolidLine, cap))
        painter.drawPoints(points)


def paint_brush(canvas, painter):
    """Paint the brushed parts."""
    for stroke in canvas.brush:
        pen = QPen(BRUSH, 2 * stroke.radius_px * canvas.scale, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        points = [QPointF(*canvas.to_widget(*point)) for point in stroke.points]
        painter.drawPolyline(QPolygonF(points if len(points) > 1 else points * 2))


def paint_label(canvas, painter, label, taken):
    """Paint a label unless a more important one has its place.

    Parameters
    ----------
    canvas : PictureCanvas
    painter : QPainter
    label : Label
    taken : list of QRectF
        Places of other labels; that of this one is added.
    """
    x, y = canvas.to_widget(label.x_px, label.y_px)
    metrics = QFontMetricsF(painter.font())
    width, height = metrics.horizontalAdvance(label.text), metrics.height()
    box = QRectF(min(x + 4, canvas.width() - width - 2), min(max(y - height - 3, 1), canvas.height() - height), width,
                 height)  # fmt: skip
    if not QRectF(canvas.rect()).contains(QPointF(x, y)) or any(box.intersects(other) for other in taken):
        return
    taken.append(box)
    if label.kind in ("summits", "map"):
        painter.setPen(QPen(QColor("#ffffff"), 4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        painter.drawPoint(QPointF(x, y))
    painter.fillRect(box.adjusted(-2, 0, 2, 0), LABEL_GROUND)
    painter.setPen(QColor(PENS[label.kind][0]))
    painter.drawText(box, label.text, QTextOption(Qt.AlignmentFlag.AlignCenter))


def paint_notice(canvas, painter):
    """Write a sentence in the middle."""
    layout = QTextOption(Qt.AlignmentFlag.AlignCenter)
    layout.setWrapMode(QTextOption.WrapMode.WordWrap)
    painter.setPen(QColor("#ffffff"))
    painter.drawText(QRectF(canvas.rect()).adjusted(20, 20, -20, -20), canvas.notice, layout)


def _runs(x, y, near):
    """Split a line where it is not near, and leave out vertices in the same pixel of the screen as the one before.

    Parameters
    ----------
    x, y : (N,) arrays
        Vertices [pixels of the screen].
    near : (N,) bool array

    Returns
    -------
    list of int arrays
        Indices of the vertices of each run, two or more.
    """
    index = np.flatnonzero(near)
    if index.size < 2:
        return []
    begins = np.r_[True, np.diff(index) > 1]
    moved = np.r_[True, (np.diff(np.floor(x[index])) != 0) | (np.diff(np.floor(y[index])) != 0)]
    kept = np.flatnonzero(begins | moved | np.r_[begins[1:], True])
    return [run for run in np.split(index[kept], np.flatnonzero(begins[kept])[1:]) if run.size > 1]
