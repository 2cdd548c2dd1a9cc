"""The track of a walk: a GPX file, a layer of points with times, or a line whose M values are times."""

from __future__ import annotations

import math
from datetime import datetime, timezone

from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QDate, QDateTime, Qt

from . import parameters as shared
from .fields import is_null, number_or_none
from .i18n import tr
from .layers import wgs84_transform

TIME_FIELDS = ("time", "timestamp", "datetime", "date_time", "zeit", "fecha", "heure")
"""Fields in which tracks store their times; if none is chosen, the first one that the layer has is used."""


def add_track_parameters(algorithm):
    """Declare the file or layer of the track, and the field of its times."""
    algorithm.addParameter(
        shared.explained(
            QgsProcessingParameterFile(
                "TRACK_FILE", tr("Track (GPX file)"), extension="gpx", optional=True,
            ),
            tr("A recorded track with times. Choose either a file or a layer."),
        )
    )  # fmt: skip
    kinds = [QgsProcessing.SourceType.TypeVectorPoint, QgsProcessing.SourceType.TypeVectorLine]
    algorithm.addParameter(
        shared.explained(
            QgsProcessingParameterFeatureSource("TRACK", tr("Track (layer)"), kinds, optional=True),
            tr("Points with a time, or lines whose M values are seconds since 1970 (UTC)."),
        )
    )
    field = QgsProcessingParameterField("TIME_FIELD", tr("Field with the time"), None, "TRACK", optional=True)
    text = tr("Date and time of each track point; without a time zone they count as UTC. Empty: a field named time.")
    algorithm.addParameter(shared.advanced(shared.explained(field, text)))


def track_fault(algorithm, parameters, context):
    """Sentence on a missing or duplicate choice of the track, or None."""
    file = algorithm.parameterAsString(parameters, "TRACK_FILE", context)
    layer = parameters.get("TRACK")
    if bool(file) == (not is_null(layer)):
        return tr("Choose the track: either a GPX file or a layer.")
    return None


def read_track(algorithm, parameters, context):
    """Read the `Track` that the user chose."""
    from ...core.io.gpx import read_track_points
    from ...core.track.track import track_of

    file = algorithm.parameterAsString(parameters, "TRACK_FILE", context)
    if file:
        return track_of(*read_track_points(file))
    source = algorithm.parameterAsSource(parameters, "TRACK", context)
    if source is None:
        raise QgsProcessingException(algorithm.invalidSourceError(parameters, "TRACK"))
    to_wgs84 = wgs84_transform(source, context)
    lines = QgsWkbTypes.geometryType(source.wkbType()) == QgsWkbTypes.GeometryType.LineGeometry
    if lines and not QgsWkbTypes.hasM(source.wkbType()):
        raise QgsProcessingException(
            tr("The lines of the track have no M values with times. Choose a layer of points, or a GPX file.")
        )
    column = None if lines else _time_column(algorithm, parameters, context, source)
    rows = [row for feature in source.getFeatures() for row in _rows(feature, column, to_wgs84)]
    return track_of(*([row[part] for row in rows] for part in range(4)))


def _time_column(algorithm, parameters, context, source):
    chosen = algorithm.parameterAsString(parameters, "TIME_FIELD", context)
    names = {field.name().lower(): field.name() for field in source.fields()}
    for name in [chosen.lower()] if chosen else TIME_FIELDS:
        if name in names:
            return names[name]
    raise QgsProcessingException(tr("The track has no field with times. Choose the field that holds them."))


def _rows(feature, column, to_wgs84):
    """(time, longitude, latitude, elevation) of the vertices of a feature; NaN where unknown."""
    if feature.geometry().isNull():
        return
    for vertex in feature.geometry().vertices():
        point = to_wgs84.transform(vertex.x(), vertex.y())
        time = vertex.m() if column is None else seconds_of(feature[column])
        yield time, point.x(), point.y(), vertex.z() if vertex.is3D() else math.nan


def seconds_of(value):
    """Seconds since 1970 (UTC) of an attribute: a date with time, a text in ISO form, or a number of seconds."""
    if is_null(value):
        return math.nan
    if isinstance(value, QDateTime):
        return _of_qt(value)
    if isinstance(value, QDate):
        return math.nan
    number = number_or_none(value)
    if number is not None:
        return number
    try:
        moment = datetime.fromisoformat(str(value).strip().replace("Z", "+00:00").replace("/", "-"))
    except ValueError:
        return math.nan
    return (moment if moment.tzinfo else moment.replace(tzinfo=timezone.utc)).timestamp()


def _of_qt(value):
    if value.timeSpec() == Qt.TimeSpec.LocalTime:  # what providers give for times without a zone
        value = QDateTime(value.date(), value.time(), Qt.TimeSpec.UTC)
    return value.toMSecsSinceEpoch() / 1000
