"""Photographs that were oriented again -> the layer that they came from, updated in place."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingOutputVectorLayer,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterVectorLayer,
    QgsVectorDataProvider,
)

from ..core.base.status import known_status
from .base import SkylineAlgorithm
from .shared import parameters as shared
from .shared.fields import is_null
from .shared.i18n import tr
from .shared.oriented import oriented_specs

RANK = {"failed": 0, "rejected": 1, "ambiguous": 2, "accepted": 3, "confirmed": 4}
"""How much a status is worth; a layer without one is worth nothing."""


class MergeOriented(SkylineAlgorithm):
    """Take the answers of photographs that were oriented again into their layer."""

    ID = "mergeoriented"
    GROUP_ID = "photographs"

    def flags(self):
        """Run in the main thread, to which the layers of a project belong."""
        return super().flags() | QgsProcessingAlgorithm.Flag.FlagNoThreading

    def displayName(self):
        """Title in the toolbox."""
        return tr("Merge oriented photos")

    def tags(self):
        """Search words."""
        return tr("photo,heading,update,merge,rescue,again,ambiguous,rejected,join").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Updates a layer of oriented photos with photos that were oriented again")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "When a few photographs have been oriented again, with a hint or a landmark, this puts their answers "
                "into the layer that they came from. Photographs are recognised by their path; all others, all other "
                "fields and the points' positions stay as they are."
            ),
            tr(
                "The layer itself is changed. If it is being edited, the changes join your unsaved ones and can be "
                "undone. Run <i>Directed viewshed</i> on it afterwards to renew the ground in view, or use <i>Model: "
                "orient photos again</i>, which does all three steps."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        points = [QgsProcessing.SourceType.TypeVectorPoint]
        layer = QgsProcessingParameterVectorLayer("INPUT", tr("Layer to update"), points)
        self.addParameter(shared.explained(layer, tr("Oriented photos of an earlier run. This layer is changed.")))
        solved = QgsProcessingParameterFeatureSource("SOLVED", tr("Photos that were oriented again"), points)
        self.addParameter(shared.explained(solved, tr("The output of Orient photos for some photos of that layer.")))
        better = QgsProcessingParameterBoolean("ONLY_BETTER", tr("Keep a better status"), True, True)
        text = tr("A photo whose new status is worse than its present one keeps its present answer.")
        self.addParameter(shared.explained(better, text))
        self.addParameter(shared.advanced(shared.photo_field()))
        self.addOutput(QgsProcessingOutputVectorLayer("UPDATED", tr("Updated layer")))
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of updated photos")))
        self.addOutput(QgsProcessingOutputNumber("KEPT", tr("Number of photos that keep a better status")))
        self.addOutput(QgsProcessingOutputNumber("UNKNOWN", tr("Number of photos that the layer does not have")))

    def input_fault(self, parameters, context):
        """Check that both layers have photographs and that the first can be changed."""
        layer = self.parameterAsVectorLayer(parameters, "INPUT", context)
        solved = self.parameterAsSource(parameters, "SOLVED", context)
        if layer is None or solved is None:
            return None
        can = layer.dataProvider().capabilities()
        if not can & QgsVectorDataProvider.Capability.ChangeAttributeValues:
            return tr("{name} cannot be changed. Save it as a GeoPackage first.").format(name=layer.name())
        column = self._column(parameters, context)
        for fields, name in ((layer.fields(), layer.name()), (solved.fields(), solved.sourceName())):
            for needed in (column, "heading"):
                if fields.lookupField(needed) < 0:
                    return tr("{name} has no field {field}. Choose a layer of oriented photos.").format(
                        name=name, field=needed
                    )
        return None

    def _column(self, parameters, context):
        return self.parameterAsString(parameters, "PHOTO_FIELD", context) or "photo"

    def compute(self, parameters, context, feedback):
        """Match the photographs, then change all of them in one step."""
        layer = self.parameterAsVectorLayer(parameters, "INPUT", context)
        column = self._column(parameters, context)
        solved, unknown = self._solved(self.parameterAsSource(parameters, "SOLVED", context), column, feedback), 0
        places = _places(layer, column)
        only_better = self.parameterAsBoolean(parameters, "ONLY_BETTER", context)
        changes, kept = {}, 0
        for path, answer in solved.items():
            own = places.get(path, ())
            if not own:
                unknown += 1
                feedback.pushWarning(tr("{name}: the layer does not have this photo.").format(name=_short(path)))
            for feature in own:
                if only_better and _worth(answer) < _worth(feature):
                    kept += 1
                    text = tr("{name}: stays {before}; the new answer is {after}.")
                    words = {"before": _status(feature), "after": _status(answer) or tr("unknown")}
                    feedback.pushInfo(text.format(name=_short(path), **words))
                    continue
                changes[feature.id()] = _changes(feature, answer)
        self._change(layer, changes)
        feedback.pushInfo(tr("{count} photos updated.").format(count=len(changes)))
        known = context.project() is not None and context.project().mapLayer(layer.id()) is not None
        return {
            "UPDATED": layer.id() if known else layer.source(),
            "COUNT": len(changes),
            "KEPT": kept,
            "UNKNOWN": unknown,
        }

    def _solved(self, source, column, feedback):
        """New answers by photograph; of several for one photograph, the one of the best status."""
        found: dict = {}
        for feature in source.getFeatures():
            if is_null(feature[column]):
                continue
            key = _key(feature[column])
            if key in found:
                text = tr("{name} occurs more than once; its best status is used.")
                feedback.pushWarning(text.format(name=_short(key)))
            if key not in found or _worth(feature) > _worth(found[key]):
                found[key] = feature
        return found

    def _change(self, layer, changes):
        """Change all photographs or none."""
        editing = layer.isEditable()
        if not editing and not layer.startEditing():
            raise QgsProcessingException(tr("{name} cannot be changed now.").format(name=layer.name()))
        layer.beginEditCommand(self.displayName())
        done = all(layer.changeAttributeValues(feature, values) for feature, values in changes.items())
        if done:
            layer.endEditCommand()
            if editing or layer.commitChanges():
                layer.triggerRepaint()
                return
            reason = "; ".join(layer.commitErrors())
        else:
            layer.destroyEditCommand()
            reason = tr("a value does not fit its field")
        if not editing:
            layer.rollBack()
        raise QgsProcessingException(tr("{name} was not changed: {reason}").format(name=layer.name(), reason=reason))


def _key(path):
    return str(path).replace("\\", "/")


def _short(path):
    return Path(path).name


def _places(layer, column):
    """Features of the layer by photograph."""
    places: dict = {}
    for feature in layer.getFeatures():
        if not is_null(feature[column]):
            places.setdefault(_key(feature[column]), []).append(feature)
    return places


def _status(feature):
    """Return the status of a feature, or None if it has none of ours."""
    return None if feature.fields().lookupField("status") < 0 else known_status(feature["status"])


def _worth(feature):
    return RANK.get(_status(feature), -1)


def _changes(feature, answer):
    """New values by index of the field, for the fields of an answer that both layers have."""
    values = {}
    for spec in oriented_specs():
        own, new = feature.fields().lookupField(spec.name), answer.fields().lookupField(spec.name)
        if own >= 0 and new >= 0:
            values[own] = answer[new]
    return values
