"""The viewshed of the photograph that is shown, by the algorithm Directed viewshed, as layers of the project."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsApplication,
    QgsFeatureRequest,
    QgsProcessingAlgRunnerTask,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsRasterLayer,
)

from ...algorithms.shared.i18n import tr
from ...algorithms.shared.lost_crs import is_lost
from ...algorithms.shared.styling import STYLES
from .faults import guarded

ALGORITHM = "skylineviewshed:directedviewshed"
PHOTO_PROPERTY = "skyline_viewshed/viewshed_of"

_RUNNING: set[Any] = set()
"""Runs that have not ended: their tasks use context and feedback to the end, also after the panel is gone."""


class ViewshedRun:
    """One run in the background; it stays alive until its task has ended, since that uses its context.

    Parameters
    ----------
    layer : QgsVectorLayer
        Of the photographs.
    item : PhotoItem
    values : dict
        Pose that counts, by field.
    dem_layer : QgsRasterLayer
    project : QgsProject
    """

    def __init__(self, layer, item, values, dem_layer, project):
        self.item, self.project = item, project
        self.points = layer.materialize(QgsFeatureRequest(item.fid))
        self._correct(values)
        self.context, self.feedback = QgsProcessingContext(), QgsProcessingFeedback()
        self.context.setProject(project)
        self.say: Any = None
        self.task: Any = None
        self.cancelled = False
        self.parameters = {
            "INPUT": self.points,
            "DEM": dem_layer,
            "OUTPUT": "TEMPORARY_OUTPUT",
        }

    def _correct(self, values):
        changes = {self.points.fields().lookupField(name): value for name, value in values.items()}
        changes = {index: value for index, value in changes.items() if index >= 0}
        provider = self.points.dataProvider()
        for feature in self.points.getFeatures():
            provider.changeAttributeValues({feature.id(): changes})

    def start(self, told):
        """Begin; `told` gets a sentence at the end."""
        algorithm = QgsApplication.processingRegistry().algorithmById(ALGORITHM)
        if algorithm is None:
            told(tr("The algorithm Directed viewshed is not there. Switch Processing on in the plugin manager."))
            return
        self.say = told
        self.algorithm = algorithm.create()
        passed, message = self.algorithm.checkParameterValues(self.parameters, self.context)
        if not passed:
            told(message)
            return
        self.task = QgsProcessingAlgRunnerTask(self.algorithm, self.parameters, self.context, self.feedback)
        self.task.executed.connect(self._finish)
        _RUNNING.add(self)
        QgsApplication.taskManager().addTask(self.task)

    def cancel(self):
        """Stop the run; its result is not wanted any more."""
        self.cancelled = True
        self.feedback.cancel()

    @guarded
    def _finish(self, successful, results):
        _RUNNING.discard(self)
        if self.cancelled:
            return
        path = results.get("OUTPUT") if successful else None
        if not path:
            self.say(tr("The viewshed could not be computed. The log of Processing says why."))
            return
        layer = QgsRasterLayer(str(path), tr("Viewshed of {photo}").format(photo=self.item.name))
        layer.loadNamedStyle(str(STYLES / "viewshed.qml"))
        layer.setCustomProperty(PHOTO_PROPERTY, self.item.path or self.item.name)
        self.project.addMapLayer(layer)
        self.say(tr("The viewshed of {photo} is in the project.").format(photo=self.item.name))


def cancel_viewsheds():
    """Stop all runs."""
    for run in _RUNNING:
        run.cancel()


def highlight_viewsheds(project, root, item):
    """Show the viewshed layers of one photograph and hide those of the others, as far as the panel made them.

    Parameters
    ----------
    project : QgsProject
    root : QgsLayerTree
    item : PhotoItem
    """
    for layer in project.mapLayers().values():
        made_for = layer.customProperty(PHOTO_PROPERTY)
        node = root.findLayer(layer.id()) if made_for else None
        if node is not None:
            node.setItemVisibilityChecked(made_for == (item.path or item.name))


def ground_in_view(project, item):
    """Polygon of the ground in view of a photograph and its CRS, from any polygon layer with its path, or (None, None).

    Parameters
    ----------
    project : QgsProject
    item : PhotoItem
    """
    from qgis.core import QgsExpression, QgsVectorLayer, QgsWkbTypes

    for layer in project.mapLayers().values():
        if not isinstance(layer, QgsVectorLayer) or layer.fields().lookupField("photo") < 0 or not item.path:
            continue
        if layer.geometryType() != QgsWkbTypes.GeometryType.PolygonGeometry or is_lost(layer.crs()):
            continue
        expression = QgsExpression.createFieldEqualityExpression("photo", item.path)
        feature = next(layer.getFeatures(QgsFeatureRequest().setFilterExpression(expression)), None)
        if feature is not None and feature.hasGeometry():
            return feature.geometry(), layer.crs()
    return None, None
