"""A layout that breaks its widgets into as many rows as the width needs."""

from __future__ import annotations

from qgis.PyQt.QtCore import QPoint, QRect, QSize, Qt
from qgis.PyQt.QtWidgets import QLayout


class Flow(QLayout):
    """Places widgets from left to right, and goes on in the next row where one does not fit any more."""

    def __init__(self, spacing_px=1):
        super().__init__()
        self._items = []
        self.setSpacing(spacing_px)
        self.setContentsMargins(0, 0, 0, 0)

    def addItem(self, item):
        """Take an item."""
        self._items.append(item)

    def count(self):
        """Return the number of items."""
        return len(self._items)

    def itemAt(self, index):
        """Return an item, or None."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index):
        """Give an item away, or None."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self):
        """Return that the layout takes no more room than it needs."""
        return Qt.Orientation(0)

    def hasHeightForWidth(self):
        """Return that the height follows from the width."""
        return True

    def heightForWidth(self, width):
        """Height of all rows [pixels]."""
        return self._place(width, None)

    def sizeHint(self):
        """Return the least size."""
        return self.minimumSize()

    def minimumSize(self):
        """Size of the largest widget."""
        size = QSize()
        for item in self._items:
            size = size.expandedTo(item.minimumSize())
        return size

    def setGeometry(self, rectangle):
        """Place the widgets."""
        super().setGeometry(rectangle)
        self._place(rectangle.width(), rectangle.topLeft())

    def _place(self, width, corner):
        """Go through the rows, and place the widgets if there is a corner to start from; the height of all rows."""
        left = top = tallest = 0
        for item in self._items:
            size = item.sizeHint()
            if left and left + size.width() > width:
                left, top, tallest = 0, top + tallest + self.spacing(), 0
            if corner is not None:
                item.setGeometry(QRect(corner + QPoint(left, top), size))
            left, tallest = left + size.width() + self.spacing(), max(tallest, size.height())
        return top + tallest
