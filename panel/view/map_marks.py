"""What the panel shows on the map: the camera's wedge, the place under the mouse with its error ellipse, a drawing."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsWkbTypes,
)
from qgis.gui import QgsMapToolEmitPoint, QgsRubberBand, QgsVertexMarker
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QColor

LINE, POLYGON = QgsWkbTypes.GeometryType.LineGeometry, QgsWkbTypes.GeometryType.PolygonGeometry


class MapMarks:
    """Marks over the map canvas, in longitude and latitude, so that they follow the project's CRS.

    Parameters
    ----------
    canvas : QgsMapCanvas
    """

    def __init__(self, canvas):
        self.canvas = canvas
        self._wanted: dict[str, Any] = {}
        self._wedge = self._band(POLYGON, "#ff3b30", 2, 30)
        self._ellipse = self._band(POLYGON, "#34c3ff", 2, 60)
        self._figure = self._band(LINE, "#4cff88", 2, 40)
        self._ground = self._band(POLYGON, "#ffb340", 2, 50)
        self._place = QgsVertexMarker(canvas)
        self._place.setIconType(QgsVertexMarker.IconType.ICON_CROSS)
        self._place.setColor(QColor("#34c3ff"))
        self._place.setPenWidth(3)
        self._place.setIconSize(14)
        self._place.hide()
        canvas.destinationCrsChanged.connect(self.refresh)

    def _band(self, kind, colour, width, opacity):
        band = QgsRubberBand(self.canvas, kind)
        band.setStrokeColor(QColor(colour))
        fill = QColor(colour)
        fill.setAlpha(opacity)
        band.setFillColor(fill)
        band.setWidth(width)
        return band

    def show_wedge(self, ring):
        """Show the camera's wedge, (lon, lat) arrays, or nothing."""
        self._put("wedge", ring, self._wedge, POLYGON)

    def show_place(self, longitude_deg, latitude_deg, ellipse=None):
        """Show the place under the mouse."""
        self._wanted["place"] = (longitude_deg, latitude_deg)
        self._put("ellipse", ellipse, self._ellipse, POLYGON)
        point = self._to_map([longitude_deg], [latitude_deg])
        self._place.setVisible(bool(point))
        if point:
            self._place.setCenter(point[0])

    def hide_place(self):
        """Show no place."""
        self._wanted.pop("place", None)
        self._place.hide()
        self._put("ellipse", None, self._ellipse, POLYGON)

    def show_figure(self, ring):
        """Show what is being measured, (lon, lat) sequences, or nothing."""
        self._put("figure", ring, self._figure, LINE)

    def show_ground(self, geometry, crs):
        """Highlight the ground in view, a geometry in a CRS, or nothing."""
        self._ground.reset(POLYGON)
        self._wanted["ground"] = (geometry, crs)
        if geometry is None:
            return
        copy = QgsGeometry(geometry)
        try:
            copy.transform(QgsCoordinateTransform(crs, self._crs(), QgsProject.instance()))
        except QgsCsException:
            return
        self._ground.setToGeometry(copy, None)

    def _put(self, name, ring, band, kind):
        self._wanted[name] = ring
        band.reset(kind)
        for point in self._to_map(*ring) if ring is not None else []:
            band.addPoint(point)

    def _crs(self):
        return self.canvas.mapSettings().destinationCrs()

    def _to_map(self, longitudes, latitudes):
        """Points in the map's CRS; none if it does not reach there."""
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        transform = QgsCoordinateTransform(wgs84, self._crs(), QgsProject.instance())
        try:
            return [
                transform.transform(QgsPointXY(x, y)) for x, y in zip(map(float, longitudes), map(float, latitudes))
            ]
        except QgsCsException:
            return []

    def position_of(self, point):
        """Longitude and latitude of a point of the map, or None."""
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        try:
            place = QgsCoordinateTransform(self._crs(), wgs84, QgsProject.instance()).transform(point)
        except QgsCsException:
            return None
        return (place.x(), place.y()) if abs(place.y()) <= 90 else None

    def refresh(self):
        """Put everything where it belongs after a change of the map's CRS."""
        self.show_wedge(self._wanted.get("wedge"))
        self.show_figure(self._wanted.get("figure"))
        self.show_ground(*self._wanted.get("ground", (None, None)))
        if "place" in self._wanted:
            longitude, latitude = self._wanted["place"]
            self.show_place(longitude, latitude, self._wanted.get("ellipse"))

    def clear(self):
        """Show nothing."""
        self.show_wedge(None)
        self.show_figure(None)
        self.show_ground(None, None)
        self.hide_place()

    def remove(self):
        """Take everything off the canvas."""
        self.canvas.destinationCrsChanged.disconnect(self.refresh)
        for item in (self._wedge, self._ellipse, self._figure, self._ground, self._place):
            self.canvas.scene().removeItem(item)


class PlaceTool(QgsMapToolEmitPoint):
    """Takes one click on the map, then gives the former tool back.

    Parameters
    ----------
    canvas : QgsMapCanvas
    clicked : callable
        Gets the point in the map's CRS.
    """

    def __init__(self, canvas, clicked):
        super().__init__(canvas)
        self.clicked, self._former = clicked, canvas.mapTool()
        self.setCursor(Qt.CursorShape.CrossCursor)

    def canvasReleaseEvent(self, event):
        """Hand the click over."""
        point = self.toMapCoordinates(event.pos())
        self.give_back()
        self.clicked(point)

    def give_back(self):
        """Put the former tool back, if this one is still in use."""
        if self.canvas().mapTool() is self:
            self.canvas().unsetMapTool(self)
            if self._former is not None:
                self.canvas().setMapTool(self._former)
