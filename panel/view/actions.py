"""The panel's actions: text, icon, key and tooltip of each, in the order of the toolbar."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ...algorithms.shared.i18n import tr

ICONS = Path(__file__).resolve().parents[2] / "icons"


@dataclass(frozen=True)
class Spec:
    """An action; without an `icon` of ours or of QGIS, its button shows its key.

    `key` is (key, Ctrl, Shift) or None, and `tool` makes it one of the exclusive tools.
    """

    name: str
    text: str
    icon: str
    key: tuple | None
    tip: str
    tool: bool = False
    breaks: bool = False


def specs():
    """All actions."""
    return (
        Spec("previous", tr("Previous"), "mActionArrowLeft", (Qt.Key.Key_PageUp, False, False),
             tr("Show the previous photograph.")),
        Spec("next", tr("Next"), "mActionArrowRight", (Qt.Key.Key_PageDown, False, False),
             tr("Show the next photograph.")),
        Spec("doubtful", tr("Next doubtful"), "mActionDoubleArrowRight", (Qt.Key.Key_PageDown, True, False),
             tr("Show the next photograph whose status is ambiguous, rejected or failed.")),
        Spec("look", tr("Look"), "mActionPan", (Qt.Key.Key_L, False, False),
             tr("Drag to pan, wheel to zoom, double click to see the whole picture."), True, True),
        Spec("correct", tr("Correct"), "mActionMoveFeature", (Qt.Key.Key_C, False, False),
             tr("Drag the horizon. The right button or Shift turns it, the wheel changes the field of view. Arrow "
                "keys, comma, full stop, plus and minus do the same."), True),
        Spec("landmark", tr("Landmark"), "mActionAddMarker", (Qt.Key.Key_M, False, False),
             tr("Click a point in the picture, then the same point on the map."), True),
        Spec("sun", tr("Sun"), "photo_view_sun", (Qt.Key.Key_U, False, False),
             tr("Click the sun in the picture. Its direction follows from the time and the place of the photograph."),
             True),
        Spec("moon", tr("Moon"), "photo_view_moon", (Qt.Key.Key_O, False, False),
             tr("Click the moon in the picture. Its direction follows from the time and the place of the photograph."),
             True),
        Spec("draw", tr("Draw skyline"), "mActionStreamingDigitize", (Qt.Key.Key_W, False, False),
             tr("Draw the whole skyline by hand; the extracted one is ignored."), True),
        Spec("repair", tr("Repair skyline"), "mActionReshape", (Qt.Key.Key_E, False, False),
             tr("Draw over a wrong stretch of the extracted skyline."), True),
        Spec("brush", tr("Mask"), "mIconSnappingArea", (Qt.Key.Key_B, False, False),
             tr("Brush over what hides the skyline: flags, clouds, people, trees."), True),
        Spec("distance", tr("Measure distance"), "mActionMeasure", None,
             tr("Click points in the picture: distance and height difference on the ground."), True, True),
        Spec("area", tr("Measure area"), "mActionMeasureArea", None,
             tr("Click the corners of an area in the picture."), True),
        Spec("point", tr("Draw point"), "mActionCapturePoint", None,
             tr("Click a point in the picture; it goes to the active layer if that is edited, else to a new one."),
             True),
        Spec("line", tr("Draw line"), "mActionCaptureLine", None,
             tr("Click a line in the picture. A double click, Enter or the right button ends it."), True),
        Spec("polygon", tr("Draw area"), "mActionCapturePolygon", None,
             tr("Click an area in the picture. A double click, Enter or the right button ends it."), True),
        Spec("face", tr("Face a place"), "mActionPanTo", (Qt.Key.Key_G, False, False),
             tr("Click a place on the map: the camera turns to it."), False, True),
        Spec("snap", tr("Snap"), "mIconSnapping", (Qt.Key.Key_F, False, False),
             tr("Fit the horizon to the picture from where it is.")),
        Spec("second", tr("Use alternative 2"), "", (Qt.Key.Key_2, False, False),
             tr("Take the second-best heading of the table, and fit from there.")),
        Spec("third", tr("Use alternative 3"), "", (Qt.Key.Key_3, False, False),
             tr("Take the third-best heading of the table, and fit from there.")),
        Spec("undo", tr("Undo"), "mActionUndo", (Qt.Key.Key_Z, True, False), tr("Take the last change back.")),
        Spec("redo", tr("Redo"), "mActionRedo", (Qt.Key.Key_Z, True, True), tr("Make the change again.")),
        Spec("keep", tr("Keep"), "mActionSaveEdits", (Qt.Key.Key_K, False, False),
             tr("Write the correction to the layer's edit buffer, with the status confirmed.")),
        Spec("viewshed", tr("Viewshed"), "heatmap", (Qt.Key.Key_V, False, False),
             tr("Compute the ground that this photograph shows, and add it as a layer."), False, True),
        Spec("review", tr("Review"), "mActionSelectedToTop", (Qt.Key.Key_R, True, False),
             tr("Judge one photograph after the other with single keys.")),
    )  # fmt: skip


def verdict_specs():
    """Actions of the review, which have their keys only while it is on."""
    return (
        Spec("accepted", tr("Accept"), "mIconSuccess", (Qt.Key.Key_A, False, False), tr("The answer is right.")),
        Spec("rejected", tr("Reject"), "mIconDelete", (Qt.Key.Key_R, False, False), tr("The answer is wrong.")),
        Spec("doubtful", tr("Doubtful"), "mIconWarning", (Qt.Key.Key_D, False, False), tr("It cannot be told.")),
        Spec("skip", tr("Skip"), "mActionArrowRight", (Qt.Key.Key_S, False, False), tr("Leave it for later.")),
    )


def overlay_texts():
    """Text of each overlay's switch, by kind."""
    return {
        "horizon": tr("Horizon of the elevation model"),
        "crests": tr("Crests below the horizon"),
        "skyline": tr("Skyline in the picture"),
        "alternatives": tr("Alternatives"),
        "summits": tr("Summits"),
        "graticule": tr("Azimuth and elevation angle"),
        "map": tr("Map layers"),
    }


def key_text(key):
    """Name of a key as in menus."""
    code, control, shift = key
    names = {Qt.Key.Key_PageUp: tr("Page up"), Qt.Key.Key_PageDown: tr("Page down")}
    name = names.get(code) or chr(int(code))
    return "+".join([*([tr("Ctrl")] if control else []), *([tr("Shift")] if shift else []), name])


def make_action(spec, parent):
    """Make the action; its key is in the tooltip, since `Keys` handles it."""
    action = QAction(spec.text, parent)
    if spec.icon:
        own = ICONS / f"{spec.icon}.svg"
        action.setIcon(QIcon(str(own)) if own.exists() else QgsApplication.getThemeIcon(f"/{spec.icon}.svg"))
    else:
        action.setIconText(key_text(spec.key))
    action.setCheckable(spec.tool)
    key = f" ({key_text(spec.key)})" if spec.key else ""
    action.setToolTip(f"<b>{spec.text}</b>{key}<br>{spec.tip}")
    action.setObjectName(f"photo_view_{spec.name}")
    return action


class Keys(QObject):
    """Triggers actions by keys while the picture or the strip has the focus, before QGIS's own shortcuts see them."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._actions = {}

    def bind(self, key, action):
        """Let a key (key, Ctrl, Shift) trigger an action as long as that is enabled and visible."""
        self._actions.setdefault(key, []).append(action)

    def eventFilter(self, watched, event):
        """Take a known key."""
        if event.type() not in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress):
            return False
        modifiers = event.modifiers()
        control = bool(modifiers & Qt.KeyboardModifier.ControlModifier)
        shift = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        actions = self._actions.get((event.key(), control, shift), ())
        action = next((action for action in actions if action.isEnabled() and action.isVisible()), None)
        if action is None:
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()
        else:
            action.trigger()
        return True
