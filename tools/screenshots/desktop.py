"""Run inside QGIS (`qgis --code`): do what a newcomer does with the demo, and take a picture at each step."""

import os
import traceback
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsBilinearRasterResampler,
    QgsCoordinateTransform,
    QgsHillshadeRenderer,
    QgsMapRendererSequentialJob,
    QgsMapSettings,
    QgsProject,
    QgsRasterLayer,
    QgsRasterPipe,
    QgsRectangle,
)
from qgis.PyQt.QtCore import QSize, Qt, QTimer
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QTreeView, QWidget
from qgis.utils import iface

SHOTS, SAMPLE = Path(os.environ["SHOTS"]), Path(os.environ["SAMPLE"])
DEM = str(SAMPLE / "dem" / "mountains.tif")

SECONDS_TO_WAIT = 90


def say(text):
    """Write to the log that run.sh shows; QGIS swallows the output of `--code`."""
    with open(SHOTS / "desktop.log", "a", encoding="utf-8") as log:
        print(text, file=log)


def shot(name, widget=None):
    """Save a picture of the screen, or of one widget."""
    target = str(SHOTS / "raw" / f"{name}.png")
    if widget is None:
        QApplication.primaryScreen().grabWindow(0).save(target)
    else:
        widget.grab().save(target)
    say(f"{name}.png")


def dock(name):
    """Dock of the main window by its object name."""
    return iface.mainWindow().findChild(QDockWidget, name)


def steps():
    """The session; each `yield` lets QGIS go on for so many milliseconds."""
    window = iface.mainWindow()
    window.showMaximized()
    for other in window.findChildren(QDockWidget):
        other.setUserVisible(False) if hasattr(other, "setUserVisible") else other.hide()
    for bar in window.findChildren(type(iface.pluginToolBar())):
        bar.setVisible(bar.objectName() in ("mFileToolBar", "mMapNavToolBar", "mAttributesToolBar"))
    project = QgsProject.instance()
    relief = shaded_relief()
    iface.mapCanvas().setCanvasColor(QColor("#e9ecef"))
    project.setCrs(relief.crs())
    project.addMapLayer(relief)
    yield 1500

    toolbox = dock("ProcessingToolbox")
    toolbox.setUserVisible(True)
    toolbox.setMinimumWidth(330)
    toolbox.raise_()
    toolbox.searchBox.setText("")
    yield 1500
    expand_ours(toolbox.findChild(QTreeView))
    yield 1000
    shot("toolbox", toolbox)

    dialog = open_dialog("orientphotos", {"DEM": relief}, QSize(960, 760))
    yield 1200
    for group in dialog.findChildren(QWidget):
        if "CollapsibleGroupBox" in group.metaObject().className():
            group.setProperty("collapsed", False)
    yield 800
    shot("dialog_orientphotos", dialog)
    dialog.close()

    report = SHOTS / "results" / "report.html"
    given = {"FOLDER": str(SAMPLE / "photos"), "DEM": relief, "REPORT": str(report)}
    dialog = open_dialog("photoviewshed", given, QSize(960, 700))
    yield 1200
    shot("dialog_photoviewshed", dialog)
    dialog.runButton().click()
    for _ in range(SECONDS_TO_WAIT):
        yield 1000
        if dialog.results():
            break
    say({name: value for name, value in dialog.results().items() if isinstance(value, int)})
    yield 1000
    shot("log", dialog)
    dialog.close()
    viewer = dock("ResultsViewer")
    say(f"results viewer: {viewer is not None}")
    arrange(project, relief)
    dock("Layers").setUserVisible(True)
    dock("Layers").setMinimumWidth(250)
    for layer in iface.layerTreeView().layerTreeModel().rootGroup().findLayers():
        layer.setExpanded(True)
    zoom_to(project)
    yield 4000
    shot("desktop")
    save_strip(project, relief)
    yield from look_at_one(project)


def look_at_one(project):
    """The form of one photo with its picture, and its map tip's surroundings."""
    photos = project.mapLayersByName("Oriented photos")[0]
    feature = next(f for f in photos.getFeatures() if f["filename"] == "midday")
    dialog = iface.getFeatureForm(photos, feature)
    dialog.resize(QSize(1000, 760))
    dialog.show()
    yield 2500
    shot("form", dialog)
    dialog.close()
    iface.showAttributeTable(photos)
    yield 2000
    for widget in QApplication.topLevelWidgets():
        if widget.isVisible() and "AttributeTable" in type(widget).__name__ + widget.objectName():
            widget.resize(QSize(1200, 260))
            yield 1000
            shot("table", widget)
            widget.close()
    yield 500


def shaded_relief():
    """Give the DEM as a pale hillshade."""
    relief = QgsRasterLayer(DEM, "Relief")
    hillshade = QgsHillshadeRenderer(relief.dataProvider(), 1, 315, 45)
    hillshade.setMultiDirectional(True)
    hillshade.setZFactor(1.0)
    relief.setRenderer(hillshade)
    relief.resampleFilter().setZoomedInResampler(QgsBilinearRasterResampler())
    relief.resampleFilter().setZoomedOutResampler(QgsBilinearRasterResampler())
    relief.setResamplingStage(QgsRasterPipe.ResamplingStage.Provider)
    relief.dataProvider().enableProviderResampling(True)
    relief.dataProvider().setZoomedInResamplingMethod(relief.dataProvider().ResamplingMethod.Cubic)
    relief.brightnessFilter().setBrightness(60)
    relief.brightnessFilter().setContrast(-35)
    return relief


def open_dialog(name, parameters, size):
    """Open the dialog of an algorithm of ours, beside the map."""
    import processing

    dialog = processing.createAlgorithmDialog(f"skylineviewshed:{name}", parameters)
    dialog.setModal(False)
    dialog.show()
    dialog.resize(size)
    dialog.move(120, 20)
    return dialog


def expand_ours(tree):
    """Open our provider and its groups in the toolbox, and nothing else."""
    model = tree.model()
    tree.collapseAll()
    for row in range(model.rowCount()):
        index = model.index(row, 0)
        if model.data(index, Qt.ItemDataRole.DisplayRole) == "Skyline Viewshed":
            tree.expandRecursively(index)
            tree.scrollTo(index, tree.ScrollHint.PositionAtTop)


def arrange(project, relief):
    """Put the relief below the results."""
    root = project.layerTreeRoot()
    node = root.findLayer(relief.id())
    copy = node.clone()
    root.addChildNode(copy)
    root.removeChildNode(node)


def save_strip(project, relief):
    """Draw what the photo `morning` shows as a wide map, for the overview."""
    ground = project.mapLayersByName("Ground in view")[0]
    seen = next(f for f in ground.getFeatures() if f["photo"].endswith(("morning.heic", "morning.jpg")))
    size, whole = QSize(1164, 436), relief.extent()
    height = whole.width() * size.height() / size.width()
    shown = seen.geometry().boundingBox()
    photos = project.mapLayersByName("Oriented photos")[0]
    camera = next(f for f in photos.getFeatures() if f["photo"] == seen["photo"]).geometry()
    camera.transform(QgsCoordinateTransform(photos.crs(), project.crs(), project))
    shown.combineExtentWith(camera.boundingBox())
    middle = shown.center().y()
    bottom = max(min(middle - height / 2, whole.yMaximum() - height), whole.yMinimum())
    settings = QgsMapSettings(iface.mapCanvas().mapSettings())
    settings.setOutputSize(size)
    settings.setExtent(QgsRectangle(whole.xMinimum(), bottom, whole.xMaximum(), bottom + height))
    job = QgsMapRendererSequentialJob(settings)
    job.start()
    job.waitForFinished()
    job.renderedImage().save(str(SHOTS / "strip.png"))


def zoom_to(project):
    """Show all ground in view and all cameras."""
    extent = QgsRectangle()
    for name in ("Ground in view", "Oriented photos"):
        for layer in project.mapLayersByName(name):
            extent.combineExtentWith(iface.mapCanvas().mapSettings().layerExtentToOutputExtent(layer, layer.extent()))
    extent.scale(1.06)
    iface.mapCanvas().setExtent(extent)
    iface.mapCanvas().refresh()


def advance(session):
    """Take the next step; whatever goes wrong is said, and QGIS ends."""
    try:
        wait = next(session)
    except StopIteration:
        finish()
    except Exception:
        say(traceback.format_exc())
        finish()
    else:
        QTimer.singleShot(wait, lambda: advance(session))


def finish():
    """Leave without questions."""
    QgsProject.instance().clear()
    QgsApplication.instance().processEvents()
    os._exit(0)


QgsApplication.messageLog().messageReceived.connect(lambda text, tag, level: tag == "Python Error" and say(text))
QTimer.singleShot(4000, lambda: advance(steps()))
