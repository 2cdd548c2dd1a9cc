"""The strip of thumbnails: one for each photograph, decoded when it comes into view."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from qgis.PyQt.QtCore import QPoint, QSize, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QColor, QIcon, QPixmap
from qgis.PyQt.QtWidgets import QListView, QListWidget, QListWidgetItem

from ...algorithms.shared.i18n import tr
from ..model.pictures import THUMBNAIL_PX

COLOURS = {"accepted": "#2da44e", "confirmed": "#0a84ff", "ambiguous": "#d29922", "rejected": "#cf222e"}
FID = Qt.ItemDataRole.UserRole
PATH = Qt.ItemDataRole.UserRole + 1
SHOWN = Qt.ItemDataRole.UserRole + 2
PAUSE_MS = 120
WIDTH_PX = THUMBNAIL_PX + 16


class Strip(QListWidget):
    """Thumbnails in one row; a click shows the photograph.

    Parameters
    ----------
    pictures : PictureStore
    parent : QWidget or None
    """

    chosen = pyqtSignal(int)

    def __init__(self, pictures, parent=None):
        super().__init__(parent)
        self.pictures, self.files, self._rows, self._busy = pictures, {}, {}, False
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setFlow(QListView.Flow.LeftToRight)
        self.setWrapping(False)
        self.setUniformItemSizes(True)
        self.setMovement(QListView.Movement.Static)
        self.setIconSize(QSize(THUMBNAIL_PX, THUMBNAIL_PX * 3 // 4))
        self.setGridSize(QSize(WIDTH_PX, THUMBNAIL_PX * 3 // 4 + 26))
        self.setFixedHeight(THUMBNAIL_PX * 3 // 4 + 50)
        self.setAccessibleName(tr("Photographs of the layer"))
        self.setToolTip(tr("Click a photograph to show it."))
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(PAUSE_MS)
        self._timer.timeout.connect(self._load_visible)
        self.horizontalScrollBar().valueChanged.connect(lambda value: self._timer.start())
        self.currentItemChanged.connect(self._choose)

    def show_photos(self, files, statuses):
        """Show other photographs: (path, path of a picture that stands in for it) and status by identifier."""
        self._busy, self.files = True, dict(files)
        self.clear()
        self._rows = {}
        for row, (fid, (path, preview)) in enumerate(files.items()):
            item = QListWidgetItem(self._blank(statuses.get(fid, "")), Path(path).name if path else str(fid))
            item.setData(FID, fid)
            item.setData(PATH, path or "")
            item.setData(SHOWN, preview or path or "")
            item.setToolTip(f"{path or ''}\n{statuses.get(fid, '')}".strip())
            self.addItem(item)
            self._rows[fid] = row
        self._busy = False
        self._timer.start()

    def mark(self, fid, status, changed):
        """Show a photograph's status, and whether it has a correction that is not kept."""
        row = self._rows.get(fid)
        if row is None:
            return
        item = self.item(row)
        name = Path(item.data(PATH)).name or str(fid)
        item.setText(f"• {name}" if changed else name)
        item.setForeground(self._ink(status))
        item.setToolTip(f"{item.data(PATH)}\n{status}".strip())

    def _ink(self, status):
        """Colour of a name: that of the status, lighter on a dark ground."""
        if status not in COLOURS:
            return self.palette().text().color()
        dark = self.palette().base().color().lightness() < 128
        return QColor(COLOURS[status]).lighter(150 if dark else 100)

    def select(self, fid):
        """Make a photograph the current one without a signal."""
        row = self._rows.get(fid, -1)
        self._busy = True
        self.setCurrentRow(row)
        if row >= 0:
            self.scrollToItem(self.item(row))
        self._busy = False
        self._timer.start()

    def resizeEvent(self, event):
        """Load what has come into view."""
        super().resizeEvent(event)
        self._timer.start()

    def _choose(self, item, former):
        if item is not None and not self._busy:
            self.chosen.emit(item.data(FID))

    def _load_visible(self):
        first = self.indexAt(QPoint(WIDTH_PX // 2, self.viewport().height() // 3)).row()
        if first < 0:
            return
        self.pictures.cancel_thumbnails()
        for row in range(first, min(first + self.viewport().width() // WIDTH_PX + 2, self.count())):
            path, fid = self.item(row).data(SHOWN), self.item(row).data(FID)
            if path and Path(path).exists():
                self.pictures.thumbnail(path, partial(self._take, fid))

    def _take(self, fid, image):
        row = self._rows.get(fid)
        if row is not None:
            self.item(row).setIcon(_icon(QPixmap.fromImage(image)))

    def _blank(self, status):
        pixmap = QPixmap(THUMBNAIL_PX, THUMBNAIL_PX * 3 // 4)
        pixmap.fill(QColor(COLOURS.get(status, "#6e7781")))
        return _icon(pixmap)


def _icon(pixmap):
    """The same picture whether it is selected or not; Qt would tint it with the colour of the selection."""
    icon = QIcon(pixmap)
    icon.addPixmap(pixmap, QIcon.Mode.Selected)
    return icon
