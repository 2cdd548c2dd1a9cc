"""Run inside QGIS (`qgis --code`): open the Photo view on oriented points, and take a picture of each of its states.

The environment names the points (PANEL_POINTS), the elevation model (PANEL_DEM) and the folder of the pictures (SHOTS).
"""

import os
import sys
import traceback
from pathlib import Path

from qgis.core import QgsApplication, QgsProject, QgsRasterLayer, QgsSettings, QgsVectorLayer
from qgis.PyQt.QtCore import QEvent, Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QDockWidget
from qgis.utils import iface, plugins

SHOTS = Path(os.environ["SHOTS"])
ROOT = Path(os.environ["PANEL_ROOT"])
sys.path.insert(0, str(ROOT / "tests"))


def say(text):
    """Write to the log; QGIS swallows the output of `--code`."""
    with open(SHOTS / "panel.log", "a", encoding="utf-8") as log:
        print(text, file=log)


def shot(name):
    """Save a picture of the main window, once the map is drawn."""
    QTest.qWait(400)
    while iface.mapCanvas().isDrawing():
        QTest.qWait(100)
    target = SHOTS / "raw" / f"panel-{name}.png"
    target.parent.mkdir(exist_ok=True)
    iface.mainWindow().grab().save(str(target))
    say(target.name)


def frame(view, number):
    """Save a picture of the panel's picture alone: a frame of the sequence of a rescue."""
    QTest.qWait(100)
    target = SHOTS / "frames" / f"{number}.png"
    target.parent.mkdir(exist_ok=True)
    view.dock.canvas.grab().save(str(target))


def prepare():
    """Show the layers, and no dock but ours."""
    window = iface.mainWindow()
    window.showMaximized()
    for other in window.findChildren(QDockWidget):
        other.setUserVisible(False) if hasattr(other, "setUserVisible") else other.hide()
    for bar in window.findChildren(type(iface.pluginToolBar())):
        if bar.window() is window and bar.parent() is window:
            bar.setVisible(bar.objectName() in ("mFileToolBar", "mMapNavToolBar", "mPluginToolBar"))
    project = QgsProject.instance()
    points = QgsVectorLayer(os.environ["PANEL_POINTS"], "Oriented photos", "ogr")
    relief = QgsRasterLayer(os.environ["PANEL_DEM"], "Elevation model")
    project.addMapLayers([points, relief])
    project.setCrs(relief.crs())
    points.loadNamedStyle(str(ROOT / "styles" / "oriented.qml"))
    iface.setActiveLayer(points)
    iface.mapCanvas().setExtent(relief.extent())
    return points


def steps(points):
    """Yield after each state that QGIS should paint before the next."""
    from panel_hand import Hand

    QgsSettings().remove("skyline_viewshed")
    plugins["skyline_viewshed"].open_photo_view()
    view = plugins["skyline_viewshed"].photo_view
    view.dock.setMinimumWidth(int(os.environ.get("PANEL_WIDTH", "700")))
    hand = Hand(view)
    yield
    hand.settle()
    wanted = os.environ.get("PANEL_FIRST", "")
    while (view.session.posed is None or wanted not in view.session.item.name) and view.go(1):
        hand.settle()
    width, height = hand.canvas.size_px
    shot("open")
    for kind in ("crests", "summits", "graticule"):
        view.dock.switches[kind].setChecked(True)
    hand.settle()
    hand.hover(0.5 * width, 0.75 * height)
    yield
    hand.settle()
    shot("overlays")
    for kind in ("crests", "summits", "graticule"):
        view.dock.switches[kind].setChecked(False)
    yield from correct(view, hand, width, height)
    yield from draw(view, hand, width, height)
    hand.press("viewshed")
    for _ in range(300):
        QTest.qWait(200)
        if "Computing" not in hand.said:
            break
    say(hand.said)
    QTest.qWait(1500)
    shot("viewshed")
    hand.press("review")
    hand.key(Qt.Key.Key_A)
    yield
    hand.settle()
    shot("review")
    points.rollBack()


def correct(view, hand, width, height):
    """Drag, snap, and point at the map."""
    truth = hand.draft.pose
    hand.press("correct")
    hand.drag((0.5 * width, 0.4 * height), (0.53 * width, 0.45 * height), (0.56 * width, 0.47 * height))
    yield
    shot("dragged")
    hand.drag((0.5 * width, 0.4 * height), (0.45 * width, 0.44 * height), (0.34 * width, 0.48 * height))
    yield
    frame(view, 0)
    left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    grip, goal = hand.hold(truth)
    hand.send(QEvent.Type.MouseButtonPress, hand.at(*grip), left, left)
    for number, share in enumerate((0.75, 1.0), 1):
        place = [a + share * (b - a) for a, b in zip(grip, goal)]
        hand.send(QEvent.Type.MouseMove, hand.at(*place), none, left)
        yield
        frame(view, number)
    hand.send(QEvent.Type.MouseButtonRelease, hand.at(*goal), left, none)
    hand.press("snap")
    hand.settle()
    frame(view, 3)
    shot("snapped")
    hand.press("look")
    ground = view.session.ground
    extent = iface.mapCanvas().extent()
    iface.mapCanvas().xyCoordinates.emit(extent.center())
    QTest.qWait(200)
    hand.settle()
    say(f"eye {ground.observer.longitude_deg:.4f} {ground.observer.latitude_deg:.4f}; spot {view.dock.canvas.spot}")
    shot("spot")
    view.dock.canvas.spot = None


def draw(view, hand, width, height):
    """Repair, mask, set a landmark, measure."""
    session = view.session
    line = session.evidence.best
    factor = width / line.width_px
    hand.press("repair")
    columns = range(int(0.15 * line.width_px), int(0.3 * line.width_px), 4)
    hand.drag(*[(c * factor, float(line.row_px[c]) * factor - 0.01 * height) for c in columns])
    hand.press("brush")
    middle = int(0.7 * line.width_px)
    hand.drag(*[(c * factor, float(line.row_px[c]) * factor) for c in range(middle - 25, middle + 25, 5)])
    yield
    hand.settle()
    shot("drawn")
    hand.press("forget_drawing")
    hand.press("distance")
    hand.click(0.4 * width, 0.7 * height)
    hand.click(0.6 * width, 0.7 * height)
    hand.settle()
    shot("measured")
    hand.key(Qt.Key.Key_Escape)
    hand.press("look")


def advance(session):
    """Take the next step; whatever goes wrong is said, and QGIS ends."""
    try:
        next(session)
    except StopIteration:
        finish()
    except Exception:
        say(traceback.format_exc())
        finish()
    else:
        QTimer.singleShot(800, lambda: advance(session))


def finish():
    """Leave without questions."""
    QgsProject.instance().clear()
    QgsApplication.instance().processEvents()
    os._exit(0)


def start():
    """Begin once QGIS is up."""
    try:
        session = steps(prepare())
    except Exception:
        say(traceback.format_exc())
        finish()
    QTimer.singleShot(1500, lambda: advance(session))


QgsApplication.messageLog().messageReceived.connect(lambda text, tag, level: tag == "Python Error" and say(text))
QTimer.singleShot(4000, start)
