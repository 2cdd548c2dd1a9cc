"""Places of oriented photographs whose points have none of their own."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsPoint,
    QgsWkbTypes,
)


class Placing:
    """Gives each output point the place from which its photo was oriented.

    Parameters
    ----------
    wkb_type : QgsWkbTypes.Type
        Of the output layer.
    crs : QgsCoordinateReferenceSystem
        Of the output layer.
    context : QgsProcessingContext
    """

    def __init__(self, wkb_type, crs, context):
        self._wkb_type = wkb_type
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        self._from_wgs84 = QgsCoordinateTransform(wgs84, crs, context.transformContext())

    def of(self, row, oriented):
        """Geometry of a row: that of its feature, or, if that gives no position, the place that the photo records."""
        own = row.feature.geometry() if row.feature.hasGeometry() else None
        longitude, latitude = oriented.longitude_deg, oriented.latitude_deg
        if row.longitude_deg is not None or longitude is None:
            return own
        altitude_m = None if oriented.metadata is None else oriented.metadata.altitude_m
        # As in an import, Z is 0 where the altitude is unknown.
        place = QgsGeometry(QgsPoint(longitude, latitude, altitude_m or 0.0))
        if not QgsWkbTypes.hasZ(self._wkb_type):
            place.get().dropZValue()
        try:
            place.transform(self._from_wgs84)
        except QgsCsException:
            return own
        if QgsWkbTypes.isMultiType(self._wkb_type):
            place.convertToMultiType()
        return place
