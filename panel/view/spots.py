"""Where a place of the map appears in the picture: a ring, or an arrow at its edge, with a word."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPen, QPolygonF, QTextOption

from ...algorithms.shared.i18n import tr
from ...core.base.camera import Camera

COLOUR = "#4cff88"
ARROW_PX, MARGIN_PX = 16.0, 24.0


def spot_words(spot):
    """Sentence on a spot of the map.

    Parameters
    ----------
    spot : Spot
    """
    far = f"{spot.distance_m / 1000:.1f} km"
    if spot.state == "visible":
        return tr("In the picture, {distance} away.").format(distance=far)
    if spot.state == "hidden":
        return tr("Hidden by terrain at {distance}.").format(distance=f"{spot.hidden_at_m / 1000:.1f} km")
    if spot.state == "unknown":
        return tr("The elevation model does not know this place.")
    if abs(spot.turn_deg) < 1.0:
        return tr("Outside the picture, straight ahead.")
    if spot.turn_deg > 0:
        return tr("Outside the picture, {angle}° to the right of its middle.").format(angle=f"{spot.turn_deg:.0f}")
    return tr("Outside the picture, {angle}° to the left of its middle.").format(angle=f"{-spot.turn_deg:.0f}")


@dataclass(frozen=True)
class SpotMark:
    """Paints a spot over a canvas.

    Parameters
    ----------
    spot : Spot
    camera : Camera
    """

    spot: Any
    camera: Camera

    def paint(self, canvas, painter):
        """Paint a ring if the place is in the frame, else an arrow towards it."""
        spot = self.spot
        dim = spot.state != "visible"
        painter.setPen(QPen(QColor("#ffffff" if dim else COLOUR), 2.5))
        painter.setBrush(QColor(0, 0, 0, 0))
        if spot.state in ("visible", "hidden"):
            x, y = canvas.to_widget(spot.x_px, spot.y_px)
            painter.drawEllipse(QPointF(x, y), 8.0, 8.0)
            self._words(canvas, painter, x, y)
        elif spot.state == "outside":
            right = spot.turn_deg > 0
            height = canvas.to_widget(0, spot.y_px)[1] if spot.y_px == spot.y_px else canvas.height() / 2
            y = min(max(height, 20.0), canvas.height() - 20.0)
            x = canvas.width() - 6.0 if right else 6.0
            back = -ARROW_PX if right else ARROW_PX
            painter.setBrush(QColor(COLOUR))
            painter.drawPolygon(QPolygonF([QPointF(x, y), QPointF(x + back, y - 9), QPointF(x + back, y + 9)]))
            self._words(canvas, painter, x, y)

    def _words(self, canvas, painter, x, y):
        text = spot_words(self.spot)
        room = QRectF(0.0, 0.0, canvas.width() - 2 * MARGIN_PX, canvas.height())
        box = QFontMetricsF(painter.font()).boundingRect(room, int(Qt.TextFlag.TextWordWrap), text)
        box.adjust(0.0, 0.0, 8.0, 0.0)
        box.moveLeft(max(min(x + 12, canvas.width() - box.width() - MARGIN_PX), 4.0))
        box.moveTop(min(max(y + 10, 0.0), canvas.height() - box.height()))
        painter.fillRect(box, QColor(16, 21, 28, 170))
        painter.setPen(QColor("#ffffff"))
        painter.drawText(box, text, QTextOption())
