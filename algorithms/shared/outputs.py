"""Writing of a run's results: vector sinks, whole files, and the folders of the outputs."""

from __future__ import annotations

import os
import re
import secrets
import sqlite3
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from qgis.core import (
    QgsFeature,
    QgsFeatureSink,
    QgsField,
    QgsFields,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingOutputLayerDefinition,
    QgsProperty,
    QgsVectorLayer,
)

from ...core.base.errors import OutputError
from ...core.io.whole_file import staged
from .field_names import tell_changed, writable
from .i18n import in_users_language, tr
from .stored_style import store_style

IN_MEMORY = ("TEMPORARY_OUTPUT", "memory:")
SURE_FORMAT = ".gpkg"
"""Format that holds every field and geometry of ours."""

NO_FILE = re.compile(r"TEMPORARY_OUTPUT|/vsi|[A-Za-z]\w{2,}:")
"""Beginnings of destinations that are not plain paths, such as `memory:` or `postgis:`; a drive's name is one
letter."""


def write_features(algorithm, parameters, name, context, fields, geometry_type, crs, rows, style=""):
    """Create the sink `name` and fill it.

    The sink is created only now, when everything is known, so that a failed or cancelled run leaves none. A file gets
    its final name when it is complete; QGIS writes tables in databases and layers in memory.

    Parameters
    ----------
    rows : list of (QgsGeometry or None, list)
        Geometry and attributes.
    style : str
        Name in `styles/` of the style that a file carries; without one it carries the aliases.

    Returns
    -------
    str or None
        Identifier of the layer; None if an optional output is not requested.

    Raises
    ------
    QgsProcessingException
        Not all features could be written; a file that was begun has been removed.
    """
    given = destination(parameters.get(name), context)
    make_folder_of(given)
    if given and given.startswith(IN_MEMORY):
        fields = _without_aliases(fields)
    fields, changed = writable(fields, rows, given)
    tell_changed(context.feedback(), changed)
    kind = fields, geometry_type, crs
    if not is_plain_file(given):
        identifier = _written(algorithm, parameters, name, context, kind, rows)
        _dress(identifier or "", style, fields, name)
        return identifier
    path = Path(given).expanduser().absolute()
    with staged(path) as stage:
        elsewhere = {**parameters, name: _moved(parameters[name], str(stage / path.name))}
        identifier = _written(algorithm, elsewhere, name, context, kind, rows, path)
        if not path.with_suffix(".qml").exists():  # a style of the user's own beside a file stays
            _dress(identifier, style, fields, path)
    # QGIS may have added a suffix, or the name of a layer in the file.
    final = (str(path) if given.startswith("~") else given) + identifier[len(str(stage / path.name)) :]
    _load_instead(context, identifier, final)
    return final


def rehearse(algorithm, parameters, name, context, kind):
    """Write the output without features in a temporary folder, so that a long run does not end in a refusal.

    If a GeoPackage cannot be written there either, the temporary folder is at fault, and not the format.

    Parameters
    ----------
    kind : (QgsFields, QgsWkbTypes.Type, QgsCoordinateReferenceSystem)

    Raises
    ------
    QgsProcessingException
        The format cannot hold the fields or the geometry.
    """
    given = destination(parameters.get(name), context)
    if not is_plain_file(given) or given.lower().endswith(SURE_FORMAT):
        return
    with TemporaryDirectory(prefix="skyline-") as folder:
        trial = Path(folder)
        fault = _trial_fault(algorithm, parameters, name, context, kind, trial / Path(given).name)
        if fault and not _trial_fault(algorithm, parameters, name, context, kind, trial / f"control{SURE_FORMAT}"):
            raise QgsProcessingException(
                tr("{path} cannot hold the fields of the photo points: {reason} Write a GeoPackage (.gpkg).").format(
                    path=given, reason=in_users_language(fault)
                )
            )


def _trial_fault(algorithm, parameters, name, context, kind, target):
    """Write the output without features to `target` and return the message of the fault, or None."""
    fields, geometry_type, crs = kind
    # Without values, no field can number the features; which name that field gets does not matter here.
    fields, _ = writable(fields, [(None, [None] * len(fields))], str(target))
    alone = QgsProcessingContext()
    alone.setTransformContext(context.transformContext())
    given = Path(destination(parameters[name], context))
    try:
        empty = {name: _moved(parameters[name], str(target))}
        _written(algorithm, {**parameters, **empty}, name, alone, (fields, geometry_type, crs), [], given)
    except (OutputError, QgsProcessingException) as error:
        return getattr(error, "message", None) or str(error)
    return None


def _written(algorithm, parameters, name, context, kind, rows, path=None):
    """Create the sink and fill it; `path` is the user's name for a file that QGIS writes elsewhere."""
    fields, geometry_type, crs = kind
    try:
        sink, identifier = algorithm.parameterAsSink(parameters, name, context, fields, geometry_type, crs)
    except QgsProcessingException as error:
        if path is None:
            raise
        # "Could not create layer ...: Creation of data source failed (OGR error: ... failed: database or disk is full)"
        raise unwritable(path, str(error).rsplit(": ", 1)[-1].rstrip(").") or str(error)) from error
    if sink is None:
        if parameters.get(name) is None:
            return None
        named = parameters if path is None else {**parameters, name: str(path)}
        raise QgsProcessingException(algorithm.invalidSinkError(named, name))
    written = _fill(sink, fields, rows)
    del sink  # closes the file, which is complete only then
    if not written or (path is not None and not _holds(identifier, len(rows))):
        raise QgsProcessingException(tr("{name} could not be written.").format(name=path or name))
    return identifier


def _dress(identifier, style, fields, name):
    """Store the style with a layer in a file."""
    try:
        stored = store_style(identifier, style, fields)
    except (OSError, sqlite3.Error) as error:
        raise unwritable(name, error) from None
    if not stored:
        raise QgsProcessingException(tr("{name} could not be written.").format(name=name))


def _holds(identifier, count):
    """Return whether a file has all features, if QGIS can read its format again.

    A full disk shows only here.
    """
    layer = QgsVectorLayer(identifier, "written", "ogr")
    if not layer.isValid():
        return not identifier.lower().split("|")[0].endswith(".gpkg")
    return not 0 <= layer.featureCount() < count


def destination(value, context):
    """Text of a destination, which dialogs and models wrap; None if there is none."""
    if isinstance(value, QgsProcessingOutputLayerDefinition):
        value = value.sink
    if isinstance(value, QgsProperty):
        value, known = value.valueAsString(context.expressionContext())
        return value if known else None
    return value if isinstance(value, str) else None


def _moved(value, path):
    """Copy of a destination that points elsewhere and keeps its format, layer name and project."""
    if not isinstance(value, QgsProcessingOutputLayerDefinition):
        return path
    value = QgsProcessingOutputLayerDefinition(value)
    value.sink = QgsProperty.fromValue(path)
    return value


def _load_instead(context, old, new):
    """Make QGIS load a layer from the new location of its file."""
    layers = context.layersToLoadOnCompletion()
    if old in layers:
        layers[new] = layers.pop(old)
        context.setLayersToLoadOnCompletion(layers)


def _fill(sink, fields, rows):
    """Add all features; return False if one is refused."""
    for geometry, attributes in rows:
        feature = QgsFeature(fields)
        if geometry is not None:
            feature.setGeometry(geometry)
        feature.setAttributes(attributes)
        if not sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert):
            return False
    return True


def _without_aliases(fields):
    """Copy of the fields without aliases.

    Layers in memory hold no aliases, and QGIS 3.40 warns of each one that is lost.
    """
    plain = QgsFields()
    for field in fields:
        copy = QgsField(field)
        copy.setAlias("")
        copy.setComment("")
        plain.append(copy)
    return plain


def is_plain_file(value):
    """Return whether a destination is a file of its own; no database table, layer in memory or older .gdb folder."""
    return bool(value) and not NO_FILE.match(value) and "|" not in value and not Path(value).is_dir()


def make_folder_of(value):
    """Create the folder of an output file; destinations that are not plain paths are left alone.

    Raises
    ------
    OutputError
    """
    if not isinstance(value, str) or not value or NO_FILE.match(value):
        return
    path = Path(value.split("|", 1)[0]).expanduser().absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(path, error) from None


def write_whole(path, content):
    """Write bytes or text under a temporary name, then rename; creates the folder.

    Raises
    ------
    OutputError
    """
    write_together({path: content})


def write_together(contents):
    """Write several files, none of which appears before all of them are complete; creates their folders.

    Parameters
    ----------
    contents : dict
        Bytes or text by path.

    Raises
    ------
    OutputError
    """
    parts: dict = {}
    try:
        for path, content in contents.items():
            make_folder_of(str(path))
            parts[path] = Path(path).with_name(f".skyline-{secrets.token_hex(6)}.part")
            parts[path].write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
        for path, part in parts.items():
            os.replace(part, path)
    except OSError as error:
        raise unwritable(path, error) from None
    finally:
        for part in parts.values():
            with suppress(OSError):
                part.unlink()


def unwritable(path, error):
    """Make the `OutputError` for a file from the error of the system, or of QGIS."""
    reason = getattr(error, "strerror", None) or str(error)
    return OutputError.of_file(path, reason)
