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
    QgsVectorLayer,
)

from ..core.errors import OutputError
from .i18n import tr

NO_FILE = ("TEMPORARY_OUTPUT", "memory:", "ogr:", "postgres")
"""How destinations begin that are no plain path."""


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

    Raises
    ------
    QgsProcessingException
        Not all could be written; a file that was begun is gone again.
    """
    make_folder_of(parameters.get(name))
    file = _plain_file(parameters.get(name))
    if _is_in_memory(parameters.get(name)):
        fields = _without_aliases(fields)
    sink, identifier = algorithm.parameterAsSink(parameters, name, context, fields, geometry_type, crs)
    if sink is None:
        if parameters.get(name) is None:
            return None
        raise QgsProcessingException(algorithm.invalidSinkError(parameters, name))
    written = _fill(sink, fields, rows)
    del sink  # closes the file, and only then is it whole
    if file is not None and not (written and _holds(identifier, file, len(rows))):
        for leftover in (file, *(file.with_name(file.name + end) for end in ("-journal", "-wal", "-shm"))):
            leftover.unlink(missing_ok=True)
        written = False
    if not written:
        raise QgsProcessingException(tr("{name} could not be written.").format(name=file or name))
    return identifier


def _holds(identifier, file, count):
    """Whether a file has all features, as far as QGIS can read its format again; a full disk shows only here."""
    layer = QgsVectorLayer(identifier, file.stem, "ogr")
    if not layer.isValid():
        return file.suffix.lower() != ".gpkg"
    return not 0 <= layer.featureCount() < count


def _fill(sink, fields, rows):
    """Add all features; False where one is refused."""
    for geometry, attributes in rows:
        feature = QgsFeature(fields)
        if geometry is not None:
            feature.setGeometry(geometry)
        feature.setAttributes(attributes)
        if not sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert):
            return False
    return True


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


def _plain_file(value):
    """Path of a destination that is a file of its own; None for tables in databases and layers in memory."""
    if isinstance(value, QgsProcessingOutputLayerDefinition):
        value = value.sink.staticValue()
    if not isinstance(value, str) or not value or value.startswith(NO_FILE) or "|" in value:
        return None
    return Path(value).expanduser().absolute()


def make_folder_of(value):
    """Make the folder that an output file will lie in; destinations that are no plain path are left alone.

    Raises
    ------
    OutputError
    """
    if not isinstance(value, str) or not value or value.startswith(NO_FILE):
        return
    path = Path(value.split("|", 1)[0]).expanduser().absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            f"The file {path} cannot be written: {reason}. Choose another folder or free some space."
        ) from None
