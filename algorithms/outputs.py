"""Writing what a run has found: vector sinks, and the folders that outputs lie in."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsFeature,
    QgsFeatureSink,
    QgsField,
    QgsFields,
    QgsProcessingException,
    QgsProcessingOutputLayerDefinition,
)

from .i18n import tr


def write_features(algorithm, parameters, name, context, fields, geometry_type, crs, rows):
    """Create the sink `name` and fill it.

    The sink is made only now, when everything is known, so that a run that failed or was cancelled leaves none.

    Parameters
    ----------
    rows : list of (QgsGeometry or None, list)
        Geometry and attributes.

    Returns
    -------
    str or None
        Identifier of the layer; None where an optional output is not wanted.
    """
    make_folder_of(parameters.get(name))
    if _is_in_memory(parameters.get(name)):
        fields = _without_aliases(fields)
    sink, identifier = algorithm.parameterAsSink(parameters, name, context, fields, geometry_type, crs)
    if sink is None:
        if parameters.get(name) is None:
            return None
        raise QgsProcessingException(algorithm.invalidSinkError(parameters, name))
    for geometry, attributes in rows:
        feature = QgsFeature(fields)
        if geometry is not None:
            feature.setGeometry(geometry)
        feature.setAttributes(attributes)
        if not sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert):
            raise QgsProcessingException(tr("{name} could not be written.").format(name=name))
    return identifier


def _is_in_memory(value):
    """Whether a destination is a layer in memory; the dialog wraps it, scripts do not."""
    if isinstance(value, QgsProcessingOutputLayerDefinition):
        value = value.sink.staticValue()
    return isinstance(value, str) and value.startswith(("TEMPORARY_OUTPUT", "memory:"))


def _without_aliases(fields):
    """Copy of the fields; layers in memory hold no aliases, and QGIS 3.40 warns of each one that is lost."""
    plain = QgsFields()
    for field in fields:
        copy = QgsField(field)
        copy.setAlias("")
        copy.setComment("")
        plain.append(copy)
    return plain


def make_folder_of(value):
    """Make the folder that an output file will lie in; destinations that are no plain path are left alone."""
    if isinstance(value, str) and value and not value.startswith(("TEMPORARY_OUTPUT", "memory:", "ogr:", "postgres")):
        Path(value.split("|", 1)[0]).expanduser().absolute().parent.mkdir(parents=True, exist_ok=True)
