"""Reading of photo points: position, path and numbers of each feature."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path, PureWindowsPath
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeature,
    QgsProcessingException,
    QgsProviderRegistry,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QUrl

from .fields import is_binary, is_null, number_or_none
from .i18n import tr
from .lost_crs import check_not_lost

PATH_FIELDS = (
    "photo", "path", "filepath", "file", "relpath", "image", "filename",
    "photo_path", "image_path", "file_path", "file_name", "picture",
)  # fmt: skip
"""Fields in which other importers store the path; if no field is chosen, the first one that the layer has is used."""

LONGEST_PATH, LONGEST_NAME = 4096, 255
"""Longer texts, and those that begin as in `EMBEDDED`, are no paths but the picture itself, as base64 or bytes."""
EMBEDDED = ("data:", "b'", "/9j/")
MOST_UP = 2
"""Folders above that of a layer or project in which a photo that moved is looked for."""


@dataclass(frozen=True)
class PointRow:
    """One feature of a point layer.

    Attributes
    ----------
    feature : QgsFeature
    name : str
        Name for messages: that of the photo, or the feature's number.
    longitude_deg, latitude_deg : float or None
        WGS 84 [degrees]; None without a usable geometry.
    path : str or None
        Path of the photograph.
    numbers : dict
        Value of each requested field; None if NULL.
    """

    feature: QgsFeature
    name: str
    longitude_deg: float | None
    latitude_deg: float | None
    path: str | None = None
    numbers: dict[str, Any] = field(default_factory=dict)


def read_points(algorithm, parameters, context, name="INPUT", path_field=None, number_fields=(), needs_position=True):
    """Read the features of a point parameter, only the selected ones if the user chose so.

    Parameters
    ----------
    path_field : str or None
        Name of the parameter that holds the path's field; None for layers without photographs.
    number_fields : sequence of str
        Names of field parameters; a NULL or an empty choice gives None.
    needs_position : bool
        False if the position does not matter, so that a table without geometry is accepted too.

    Returns
    -------
    source : QgsProcessingFeatureSource
    rows : list of PointRow
    """
    source = algorithm.parameterAsSource(parameters, name, context)
    if source is None:
        raise QgsProcessingException(algorithm.invalidSourceError(parameters, name))
    to_wgs84 = wgs84_transform(source, context) if needs_position else None
    column = None if path_field is None else path_column(algorithm, parameters, context, source, path_field)
    columns = {key: number_column(algorithm, parameters, context, source, key) for key in number_fields}
    folders = () if column is None else base_folders(algorithm, parameters, context, name)
    rows = []
    for feature in source.getFeatures():
        longitude, latitude = position_of(feature, to_wgs84) if needs_position else (None, None)
        path = None if column is None else absolute_path(feature[column], folders)
        label = name_of(path) if path else label_of(feature)
        values = {key: number_or_none(feature[field]) if field else None for key, field in columns.items()}
        rows.append(PointRow(feature, label, longitude, latitude, path, values))
    if not rows:
        raise QgsProcessingException(tr("The layer of points has no feature. Choose another, or clear the selection."))
    return source, rows


def points_fault(algorithm, parameters, context, name="INPUT", path_field=None, number_fields=()):
    """Sentence on why a point parameter is unusable (no CRS, no such field), or None."""
    source = algorithm.parameterAsSource(parameters, name, context)
    if source is None:
        return None
    try:
        wgs84_transform(source, context)
        if path_field is not None:
            path_column(algorithm, parameters, context, source, path_field)
        for field in number_fields:
            number_column(algorithm, parameters, context, source, field)
    except QgsProcessingException as error:
        return str(error)
    return None


def label_of(feature):
    """Name of a point for messages: that of its photo, if it has one, else its number."""
    for name in ("photo", "filename", "name"):
        index = feature.fields().lookupField(name)
        if index >= 0 and not is_null(feature[index]):
            return name_of(str(feature[index]))
    return tr("Point {id}").format(id=feature.id())


def name_of(path):
    """Name of a path for messages; a text that is no path is cut."""
    return Path(path).name[:LONGEST_NAME]


def number_column(algorithm, parameters, context, source, name):
    """Field of a parameter; None if none is chosen, or if it is a default that this layer does not have."""
    chosen = algorithm.parameterAsString(parameters, name, context)
    if not chosen or source.fields().lookupField(chosen) >= 0:
        return chosen or None
    if chosen == algorithm.parameterDefinition(name).defaultValue():
        return None
    raise QgsProcessingException(
        tr("The layer has no field {field} ({name}). Choose another.").format(field=chosen, name=name)
    )


def wgs84_transform(source, context):
    """Transformation of a source's coordinates to longitude and latitude."""
    if not source.sourceCrs().isValid():
        raise QgsProcessingException(
            tr("The point layer has no coordinate reference system. Assign the right one in the layer's properties.")
        )
    check_not_lost(source.sourceCrs())
    wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
    return QgsCoordinateTransform(source.sourceCrs(), wgs84, context.transformContext())


def position_of(feature, to_wgs84):
    """Longitude and latitude of a feature [degrees], or (None, None).

    A camera has one place: of a geometry with points that differ none is taken, since their middle is none of them.
    """
    geometry = feature.geometry()
    if geometry.isNull() or geometry.isEmpty():
        return None, None
    if geometry.type() == QgsWkbTypes.GeometryType.PointGeometry:
        places = {(vertex.x(), vertex.y()) for vertex in geometry.vertices()}
        if len(places) > 1:
            return None, None
    point = geometry.centroid().asPoint()
    try:
        point = to_wgs84.transform(point)
    except QgsCsException:
        return None, None
    # 0/0 is what cameras and importers write if they have no position.
    if point.isEmpty() or (point.x() == 0 and point.y() == 0) or abs(point.y()) > 90:
        return None, None
    return point.x(), point.y()


def path_column(algorithm, parameters, context, source, name):
    """Field with the photo's path: the chosen one, or the first of `PATH_FIELDS` that the layer has."""
    chosen = algorithm.parameterAsString(parameters, name, context)
    fields = {field.name().lower(): field for field in source.fields()}
    names = {name: field.name() for name, field in fields.items() if not is_binary(field)}
    if chosen and chosen.lower() in names:
        return names[chosen.lower()]
    for candidate in PATH_FIELDS:
        if candidate in names and (not chosen or chosen == "photo"):
            return names[candidate]
    if chosen.lower() in fields:
        raise QgsProcessingException(
            tr(
                "The field {field} holds pictures, not paths. Save the pictures as files and choose a field with their "
                "paths (PHOTO_FIELD)."
            ).format(field=chosen)
        )
    raise QgsProcessingException(
        tr("The layer has no field {field}. Choose the field that holds the photographs' paths.").format(field=chosen)
    )


def base_folders(algorithm, parameters, context, name):
    """Folders to which a path may be relative: the layer's, then the project's."""
    return folders_of(algorithm.parameterAsVectorLayer(parameters, name, context), context.project())


def folders_of(layer, project):
    """Folders to which a layer's paths may be relative: its own, then the project's; either may be None."""
    folders = []
    if layer is not None and layer.dataProvider() is not None:
        parts = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
        if parts.get("path"):
            folders.append(Path(parts["path"]).parent)
    if project is not None and project.homePath():
        folders.append(Path(project.homePath()))
    return tuple(folders)


def absolute_path(value, folders):
    """Full path of a photo, or None for NULL."""
    if is_null(value):
        return None
    text = str(value).strip()
    if len(text) > LONGEST_PATH or text.startswith(EMBEDDED):
        return f"{text[:30]}..."
    path = Path(QUrl(text).toLocalFile() if text.lower().startswith("file:") else text)
    if path.is_absolute() and _is_file(path):
        return str(path)
    if path.is_absolute() or PureWindowsPath(text).is_absolute():
        return moved_photo(path, folders)
    for folder in folders:
        if _is_file(folder / path):
            return str(folder / path)
    return str(path)


def _is_file(path):
    with suppress(OSError, ValueError):  # a text that no system takes for a path
        return path.is_file()
    return False


def moved_photo(path, folders):
    """Where a photo is that moved with its layer or project: as much of its path as fits below one of the folders.

    The folders above are searched too, since a layer often lies beside the folder of its photos, or in one of its own.
    """
    parts = [part for part in str(path).replace("\\", "/").split("/") if part]
    for folder in folders:
        for up, base in enumerate((folder, *list(folder.parents)[:MOST_UP])):
            # A name alone proves little: cameras number their files anew, so it counts only beside the layer.
            for start in range(1, len(parts) - (up > 0)):
                candidate = base.joinpath(*parts[start:])
                if _is_file(candidate):
                    return str(candidate)
    return str(path)
