"""What the mouse does in the picture: look, correct, set a landmark, draw, brush."""

from __future__ import annotations

import numpy as np
from qgis.PyQt.QtCore import Qt

from ...core.skyline.repair import BrushStroke
from ..model.overlays import Line

BRUSH_SHARE = 40.0
"""The picture's long side divided by this is the brush's radius [pixels]."""

NUDGES = {
    Qt.Key.Key_Left: (-1, 0, 0.0),
    Qt.Key.Key_Right: (1, 0, 0.0),
    Qt.Key.Key_Up: (0, 1, 0.0),
    Qt.Key.Key_Down: (0, -1, 0.0),
    Qt.Key.Key_Comma: (0, 0, 0.1),
    Qt.Key.Key_Period: (0, 0, -0.1),
}
"""Steps to the right and up, and the turn [degrees], by key."""


class Tool:
    """Changes nothing: the left button pans, the wheel zooms.

    Parameters
    ----------
    canvas : PictureCanvas
    """

    pans = True
    wheels = False
    """Whether the tool takes the wheel, with which the picture is zoomed otherwise."""

    def __init__(self, canvas):
        self.canvas = canvas

    def press(self, place, event):
        """A button goes down at a pixel."""

    def move(self, place, event):
        """The mouse moves."""

    def release(self, place, event):
        """A button comes up."""

    def wheel(self, notches, place):
        """The wheel turns, if the tool takes it."""

    def key(self, event):
        """A key goes down; True if the tool takes it."""
        return False

    def finish(self):
        """End what is being drawn."""

    def stop(self):
        """Another tool follows."""
        self.canvas.sketch = []
        self.canvas.update()


class CorrectTool(Tool):
    """Drags the horizon; the right button, or Shift, turns it; the wheel changes the focal length.

    Parameters
    ----------
    canvas : PictureCanvas
    correction : Correction
    """

    pans, wheels = False, True

    def __init__(self, canvas, correction):
        super().__init__(canvas)
        self.correction, self._from, self._turns = correction, None, False

    def press(self, place, event):
        """Take hold of the horizon."""
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        self._from, self._turns = place, shift or event.button() == Qt.MouseButton.RightButton
        self.correction.begin()

    def move(self, place, event):
        """Let the horizon follow."""
        if self._from is None:
            return
        if self._turns:
            width, height = self.canvas.size_px
            self.correction.turn((width / 2, height / 2), self._from, place)
        else:
            self.correction.drag(self._from, place)

    def release(self, place, event):
        """Let go."""
        if self._from is not None:
            self._from = None
            self.correction.end()

    def wheel(self, notches, place):
        """Change the focal length."""
        self.correction.zoom(notches, place)

    def key(self, event):
        """Move by arrow keys, turn by comma and full stop, zoom by plus and minus."""
        if event.key() in NUDGES:
            self.correction.nudge(*NUDGES[event.key()])
        elif event.key() in (Qt.Key.Key_Plus, Qt.Key.Key_Minus):
            width, height = self.canvas.size_px or (1, 1)
            self.correction.zoom(1 if event.key() == Qt.Key.Key_Plus else -1, (width / 2, height / 2))
        else:
            return False
        return True


class ClickTool(Tool):
    """Takes single clicks.

    Parameters
    ----------
    canvas : PictureCanvas
    clicked : callable
        Gets the pixel (x, y).
    """

    pans = False

    def __init__(self, canvas, clicked):
        super().__init__(canvas)
        self.clicked = clicked

    def press(self, place, event):
        """Pass a click on the picture on."""
        if event.button() == Qt.MouseButton.LeftButton and self.canvas.holds(*place):
            self.clicked(place)


class StrokeTool(Tool):
    """Draws free lines with the button held down.

    Parameters
    ----------
    canvas : PictureCanvas
    drawn : callable
        Gets the vertices [pixels].
    """

    pans = False

    def __init__(self, canvas, drawn):
        super().__init__(canvas)
        self.drawn, self._points = drawn, []

    def press(self, place, event):
        """Begin a stroke."""
        self._points = [place] if event.button() == Qt.MouseButton.LeftButton else []

    def move(self, place, event):
        """Add a vertex."""
        if self._points:
            self._points.append(place)
            self.show_sketch()

    def show_sketch(self):
        """Show the stroke so far."""
        self.canvas.sketch = [Line("sketch", *np.asarray(self._points, float).T)]
        self.canvas.update()

    def release(self, place, event):
        """Hand the stroke over."""
        points, self._points = self._points, []
        self.stop()
        if len(points) > 1 or (points and self.dots):
            self.drawn(tuple(points))

    dots = False
    """Whether a click without a move is a stroke."""


class BrushTool(StrokeTool):
    """Brushes over parts of the picture; see `StrokeTool`."""

    dots = True

    def __init__(self, canvas, brushed):
        super().__init__(canvas, self._strokes)
        self.brushed = brushed

    @property
    def radius_px(self):
        """Radius of the brush: larger the more of the picture is in view [pixels of the picture]."""
        seen = min(self.canvas.width() / self.canvas.scale, max(self.canvas.size_px))
        return seen / BRUSH_SHARE

    def _strokes(self, points):
        self.brushed(BrushStroke(points, self.radius_px))

    def show_sketch(self):
        """Show the stroke so far as it will be."""
        self.canvas.brush = (*self.canvas.brush[: self._before], BrushStroke(tuple(self._points), self.radius_px))
        self.canvas.update()

    def press(self, place, event):
        """Begin a stroke after those that are there."""
        super().press(place, event)
        self._before = len(self.canvas.brush)


class ChainTool(Tool):
    """Collects clicks to a point, a line or an area; a double click, Enter or the right button ends it.

    Parameters
    ----------
    canvas : PictureCanvas
    kind : str
        'point', 'line' or 'polygon'.
    changed, finished : callable
        Get the kind and the vertices [pixels].
    """

    pans = False
    LEAST = {"point": 1, "line": 2, "polygon": 3}

    def __init__(self, canvas, kind, changed, finished):
        super().__init__(canvas)
        self.kind, self.changed, self.finished, self._points = kind, changed, finished, []

    def press(self, place, event):
        """Add a vertex, or end."""
        if event.button() == Qt.MouseButton.RightButton:
            self.finish()
        elif self.canvas.holds(*place):
            self._points.append(place)
            if self.kind == "point":
                self.finish()
            else:
                self.changed(self.kind, tuple(self._points))
                self._show(place)

    def move(self, place, event):
        """Show where the next vertex would be."""
        if self._points:
            self._show(place)

    def _show(self, place):
        points = [*self._points, place, *(self._points[:1] if self.kind == "polygon" else [])]
        self.canvas.sketch = [Line("sketch", *np.asarray(points, float).T)]
        self.canvas.update()

    def key(self, event):
        """Enter ends, Escape forgets, Backspace takes the last vertex back."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.finish()
        elif event.key() == Qt.Key.Key_Escape:
            self._points = []
            self.stop()
        elif event.key() == Qt.Key.Key_Backspace and self._points:
            self._points.pop()
            self.stop()
        else:
            return False
        return True

    def finish(self):
        """Hand the figure over; a double click has set its last vertex twice."""
        points = tuple(p for k, p in enumerate(self._points) if k == 0 or p != self._points[k - 1])
        self._points = []
        super().stop()
        if len(points) >= self.LEAST[self.kind]:
            self.finished(self.kind, points)

    def stop(self):
        """Forget the sketch."""
        self._points = []
        super().stop()
