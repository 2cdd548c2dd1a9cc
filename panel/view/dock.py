"""The dock: layers above, tools, the picture, what is under the mouse, and the strip of thumbnails."""

from __future__ import annotations

from textwrap import shorten

from qgis.core import QgsMapLayerProxyModel, QgsSettings
from qgis.gui import QgsDockWidget, QgsMapLayerComboBox
from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QAction,
    QActionGroup,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenu,
    QProgressBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...algorithms.shared.i18n import tr
from ..model.overlays import KINDS, SHOWN_AT_FIRST
from .actions import Keys, key_text, make_action, overlay_texts, specs, verdict_specs
from .canvas import PictureCanvas
from .flow import Flow
from .strip import Strip

SHOWN_SETTING = "skyline_viewshed/photo_view/shown"
ICON_PX = 18
LONGEST_MESSAGE = 90
"""Characters of a message above the picture, so that it leaves the picture its room."""


class PhotoViewDock(QgsDockWidget):
    """All widgets of the panel; the controller connects them.

    Parameters
    ----------
    pictures : PictureStore
    parent : QWidget or None
    """

    shown_changed = pyqtSignal()

    def __init__(self, pictures, parent=None):
        super().__init__(tr("Photo view"), parent)
        self.setObjectName("SkylineViewshedPhotoView")
        self.actions, self.verdicts, self.switches = {}, {}, {}
        self.keys = Keys(self)
        self.canvas = PictureCanvas()
        self.strip = Strip(pictures)
        self.layer_box = self._layer_box(QgsMapLayerProxyModel.Filter.PointLayer, tr("Layer of oriented photo points."))
        self.dem_box = self._layer_box(QgsMapLayerProxyModel.Filter.RasterLayer, tr("Elevation model (DEM)"))
        self.place_label, self.photo_label, self.told_label = QLabel(), QLabel(), QLabel()
        for label in (self.place_label, self.photo_label, self.told_label):
            label.setWordWrap(True)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._lay_out()
        self._order_focus()

    def _order_focus(self):
        """Let the Tab key go from top to bottom, and the keys work everywhere but in the boxes, which take letters."""
        buttons = self.widget().findChildren(QToolButton)
        bar = [button for button in buttons if self.review_bar.isAncestorOf(button)]
        tools = [button for button in buttons if button not in bar]
        for watched in (*buttons, self.canvas, self.strip):
            watched.installEventFilter(self.keys)
        order = [self.layer_box, self.dem_box, *tools, self.canvas, *bar, self.strip]
        for one, other in zip(order, order[1:]):
            self.setTabOrder(one, other)

    def _layer_box(self, kinds, tip):
        box = QgsMapLayerComboBox()
        box.setFilters(kinds)
        box.setAllowEmptyLayer(True)
        box.setToolTip(tip)
        box.setAccessibleName(tip)
        box.setMinimumContentsLength(12)
        return box

    def _lay_out(self):
        form = QFormLayout()
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        form.addRow(tr("Photos"), self.layer_box)
        form.addRow(tr("Elevation model"), self.dem_box)
        self.review_bar = self._review_bar()
        whole = QVBoxLayout()
        whole.setContentsMargins(4, 4, 4, 4)
        whole.setSpacing(3)
        whole.addLayout(form)
        whole.addLayout(self._tool_rows())
        whole.addWidget(self.photo_label)
        whole.addWidget(self.canvas, 1)
        whole.addWidget(self.place_label)
        whole.addWidget(self.told_label)
        whole.addWidget(self.review_bar)
        whole.addWidget(self.strip)
        inside = QWidget()
        inside.setLayout(whole)
        self.setWidget(inside)

    def _tool_rows(self):
        """Going, tools and drawing, and what acts on the photograph, in as many rows as the width needs."""
        rows = Flow()
        self.tools = QActionGroup(self)
        for spec in specs():
            if spec.breaks:
                rows.addWidget(self._separator())
            action = make_action(spec, self)
            if spec.tool:
                self.tools.addAction(action)
            if spec.key:
                self.keys.bind(spec.key, action)
            self.actions[spec.name] = action
            button = QToolButton()
            button.setDefaultAction(action)
            button.setAutoRaise(True)
            button.setIconSize(QSize(ICON_PX, ICON_PX))
            rows.addWidget(button)
        self.actions["look"].setChecked(True)
        self.actions["review"].setCheckable(True)
        rows.addWidget(self._overlay_button())
        rows.addWidget(self._more_button())
        return rows

    def _separator(self):
        line = QFrame()
        line.setFrameShape(QFrame.Shape.VLine)
        line.setFrameShadow(QFrame.Shadow.Sunken)
        line.setMinimumSize(6, ICON_PX + 4)
        return line

    def _overlay_button(self):
        shown = QgsSettings().value(SHOWN_SETTING, ",".join(SHOWN_AT_FIRST)).split(",")
        menu = QMenu(self)
        texts = overlay_texts()
        for number, kind in enumerate(KINDS):
            switch = QAction(texts[kind], self)
            switch.setCheckable(True)
            switch.setChecked(kind in shown)
            switch.toggled.connect(self._remember_shown)
            key = (Qt.Key.Key_F1 + number, False, True)
            self.keys.bind(key, switch)
            switch.setToolTip(f"{texts[kind]} ({tr('Shift')}+F{number + 1})")
            self.switches[kind] = switch
            menu.addAction(switch)
        menu.setToolTipsVisible(True)
        return self._button(tr("Show"), tr("Choose what is drawn over the picture."), menu)

    def _more_button(self):
        menu = QMenu(self)
        for name, text in (
            ("remove_landmarks", tr("Remove the landmarks")),
            ("forget_drawing", tr("Remove what was drawn and masked")),
            ("folder", tr("Folder of landmarks, skylines and masks ...")),
            ("fit", tr("Show the whole picture")),
        ):
            self.actions[name] = QAction(text, self)
            menu.addAction(self.actions[name])
        return self._button(tr("More"), tr("Further commands for this photograph."), menu)

    def _button(self, text, tip, menu):
        button = QToolButton()
        button.setText(text)
        button.setToolTip(tip)
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        return button

    def _review_bar(self):
        bar, whole, buttons, row = QWidget(), QVBoxLayout(), Flow(), QHBoxLayout()
        whole.setContentsMargins(0, 0, 0, 0)
        for spec in verdict_specs():
            action = make_action(spec, self)
            action.setText(f"{spec.text} ({key_text(spec.key)})")
            action.setEnabled(False)
            self.keys.bind(spec.key, action)
            self.verdicts[spec.name] = action
            button = QToolButton()
            button.setDefaultAction(action)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            buttons.addWidget(button)
        self.progress, self.count_label = QProgressBar(), QLabel()
        self.progress.setTextVisible(False)  # some themes write it in the colour of the bar
        self.progress.setAccessibleName(tr("Reviewed photographs"))
        row.addWidget(self.progress, 1)
        row.addWidget(self.count_label)
        whole.addLayout(buttons)
        whole.addLayout(row)
        bar.setLayout(whole)
        bar.hide()
        return bar

    def _remember_shown(self, checked):
        QgsSettings().setValue(SHOWN_SETTING, ",".join(sorted(self.shown)))
        self.shown_changed.emit()

    @property
    def shown(self):
        """Kinds of overlays that are switched on."""
        return {kind for kind, switch in self.switches.items() if switch.isChecked()}

    def show_photo_words(self, text, message):
        """Show what is known of the photograph, with a long message cut; the tooltip has all of it."""
        self.photo_label.setText(f"{text} {shorten(message, LONGEST_MESSAGE, placeholder=' ...')}".strip())
        self.photo_label.setToolTip(message)

    def say(self, text):
        """Show a sentence below the picture."""
        self.told_label.setText(text)

    def show_review(self, on, done=0, count=0):
        """Show or hide the review's buttons and progress."""
        self.review_bar.setVisible(on)
        for action in self.verdicts.values():
            action.setEnabled(on)
        self.progress.setMaximum(max(count, 1))
        self.progress.setValue(done)
        self.count_label.setText(f"{done} / {count}")
