"""Places of a layer: its points, or points at a regular distance along its lines."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsCsException, QgsProcessingException

from .i18n import tr
from .layers import label_of, position_of, wgs84_transform


def places_of(algorithm, parameters, context, name, step):
    """Names and positions (longitude, latitude) of a source's places [degrees]; (None, None) without a geometry.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`.
    name, step : str
        Names of the parameters of the source and of the distance along lines.
    """
    source = algorithm.parameterAsSource(parameters, name, context)
    if source is None:
        raise QgsProcessingException(algorithm.invalidSourceError(parameters, name))
    transform, step_m = wgs84_transform(source, context), algorithm.parameterAsDouble(parameters, step, context)
    places = []
    for feature in source.getFeatures():
        geometry, label = feature.geometry(), label_of(feature)
        if geometry.isNull() or geometry.isEmpty() or geometry.length() == 0:
            places.append((label, position_of(feature, transform)))
            continue
        for number, position in enumerate(_along(geometry, transform, context, step_m)):
            places.append((f"{label} {number + 1}", position))
    if not places:
        raise QgsProcessingException(tr("The layer of points has no feature. Choose another, or clear the selection."))
    return places


def _along(geometry, transform, context, step_m):
    """Positions along a line, at most `step_m` apart on the ground, with both ends."""
    from math import ceil

    from ...core.io.crs import local_plane

    try:
        geometry.transform(transform)
        middle = geometry.boundingBox().center()
        plane = QgsCoordinateReferenceSystem()
        plane.createFromUserInput(local_plane(middle.x(), middle.y()))
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        to_plane = QgsCoordinateTransform(wgs84, plane, context.transformContext())
        geometry.transform(to_plane)
        back = QgsCoordinateTransform(plane, wgs84, context.transformContext())
        count = max(ceil(geometry.length() / step_m), 1)
        for number in range(count + 1):
            point = back.transform(geometry.interpolate(geometry.length() * number / count).asPoint())
            yield point.x(), point.y()
    except QgsCsException:
        yield None, None
