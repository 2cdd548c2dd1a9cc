"""Measuring and digitising in the picture: figures of pixels become distances, and features of a map layer."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsDistanceArea,
    QgsFeature,
    QgsPointXY,
    QgsProcessingFeedback,
    QgsProject,
    QgsVectorLayer,
    QgsVectorLayerUtils,
    QgsWkbTypes,
)

from ...algorithms.shared.fields import qgis_fields
from ...algorithms.shared.i18n import tr
from ...algorithms.shared.lost_crs import loss
from ...algorithms.shared.map_places import transformed
from ...algorithms.shared.monoplotting import MapFeatures, drawn_specs, point_specs
from ...algorithms.shared.pixel_input import FeaturesByPhoto
from ...algorithms.shared.views import OpenedPhoto
from .edits import NotEditableError
from .ground import REACH_M, view_of

COVERAGE, STEP_PX = 0.9, 3.0
GEOMETRIES = {
    "point": (QgsWkbTypes.GeometryType.PointGeometry, "PointZ"),
    "line": (QgsWkbTypes.GeometryType.LineGeometry, "MultiLineStringZ"),
    "polygon": (QgsWkbTypes.GeometryType.PolygonGeometry, "MultiPolygonZ"),
}
LAYER_PROPERTY = "skyline_viewshed/drawn_in_photos"


def measured(kind, places, project):
    """Sentence on a measured line or area.

    Parameters
    ----------
    kind : str
        'line' or 'polygon'.
    places : list of Place
    project : QgsProject
    """
    if not all(place.on_ground for place in places):
        return tr("Part of the figure shows the sky or lies beyond the elevation model, so it cannot be measured.")
    area = QgsDistanceArea()
    area.setSourceCrs(QgsCoordinateReferenceSystem("EPSG:4326"), project.transformContext())
    area.setEllipsoid("EPSG:7030")
    points = [QgsPointXY(place.longitude_deg, place.latitude_deg) for place in places]
    if kind == "polygon":
        square_m = area.measurePolygon(points) if len(points) > 2 else 0.0
        around = area.measureLine([*points, points[0]])
        return tr("Area on the map {area}, outline {length}.").format(area=_area(square_m), length=_length(around))
    length = area.measureLine(points) if len(points) > 1 else 0.0
    rise = places[-1].elevation_m - places[0].elevation_m
    return tr("Distance on the map {length}, height difference {rise} m.").format(
        length=_length(length), rise=f"{rise:+.0f}"
    )


def _length(metres):
    return f"{metres:.0f} m" if metres < 10_000 else f"{metres / 1000:.2f} km"


def _area(square_m):
    return f"{square_m:.0f} m²" if square_m < 1e6 else f"{square_m / 1e6:.2f} km²"


def placed(item, ground, posed, kind, points, progress):
    """Place a drawn figure on the map: (geometry in the DEM's CRS or None, attributes).

    Parameters
    ----------
    item : PhotoItem
    ground : Ground
    posed : PosedPhoto
    kind : str
        'point', 'line' or 'polygon'.
    points : sequence of (x_px, y_px)
    progress : Progress
    """
    import numpy as np

    from ...core.base.pixel_features import PixelFeature
    from ...core.mapping.sightline import SightOptions

    drawn = FeaturesByPhoto([PixelFeature("", kind, (np.asarray(points, float).reshape(-1, 2),))], [])
    rows = MapFeatures(ground.terrain, drawn, SightOptions(max_distance_m=REACH_M), COVERAGE, STEP_PX)
    view, name = view_of(ground, posed), item.path or item.name
    photo = OpenedPhoto(item.point.feature, item.name, name, view, ground.terrain, True, progress)
    rows.add(photo, QgsProcessingFeedback(False))
    return {"point": rows.points, "line": rows.lines, "polygon": rows.polygons}[kind][0]


def target_layer(kind, active, project, crs):
    """Layer that takes a figure: the active one if it is being edited and fits, else one of our own.

    Parameters
    ----------
    kind : str
    active : QgsMapLayer or None
    project : QgsProject
    crs : QgsCoordinateReferenceSystem
        Of a new layer.
    """
    geometry, type_name = GEOMETRIES[kind]
    if isinstance(active, QgsVectorLayer) and active.isEditable() and active.geometryType() == geometry:
        return active
    for layer in project.mapLayers().values():
        if layer.customProperty(LAYER_PROPERTY) == kind and layer.isValid():
            return layer
    titles = {
        "point": tr("Points from photos"),
        "line": tr("Lines from photos"),
        "polygon": tr("Areas from photos"),
    }
    layer = QgsVectorLayer(type_name, titles[kind], "memory")
    layer.setCrs(crs)
    specs = point_specs() if kind == "point" else drawn_specs()
    layer.dataProvider().addAttributes(list(qgis_fields(specs)))
    layer.updateFields()
    layer.setCustomProperty(LAYER_PROPERTY, kind)
    project.addMapLayer(layer)
    return layer


def add_figure(layer, kind, geometry, values, crs):
    """Add a placed figure to a layer's edit buffer.

    Parameters
    ----------
    layer : QgsVectorLayer
    kind : str
    geometry : QgsGeometry or None
        In `crs`.
    values : list
        As of `point_specs` or `drawn_specs`; those whose field the layer has are kept.
    crs : QgsCoordinateReferenceSystem

    Raises
    ------
    NotEditableError
    """
    fault = loss(layer.crs())
    if fault:
        raise NotEditableError(fault)
    moved = None if geometry is None else _fitting(geometry, layer, crs)
    if moved is None:
        raise NotEditableError(tr("This shows no ground that the elevation model knows, so nothing was drawn."))
    if layer.readOnly() or not (layer.isEditable() or layer.startEditing()):
        raise NotEditableError(tr("The layer {layer} cannot be edited.").format(layer=layer.name()))
    specs = point_specs() if kind == "point" else drawn_specs()
    given = {spec.name: value for spec, value in zip(specs, values)}
    indexes = {layer.fields().lookupField(name): value for name, value in given.items()}
    attributes = {index: value for index, value in indexes.items() if index >= 0 and value is not None}
    feature = QgsVectorLayerUtils.createFeature(layer, moved, attributes)
    layer.beginEditCommand(tr("Draw in a photo"))
    if not layer.addFeature(QgsFeature(feature)):
        layer.destroyEditCommand()
        raise NotEditableError(tr("The layer {layer} cannot be edited.").format(layer=layer.name()))
    layer.endEditCommand()
    layer.triggerRepaint()


def _fitting(geometry, layer, crs):
    """The geometry in the layer's CRS, with or without Z, single or multi as the layer wants it."""
    try:
        moved = transformed(geometry, QgsCoordinateTransform(crs, layer.crs(), QgsProject.instance()))
    except QgsCsException:
        return None
    if moved is None:
        return None
    pieces = moved.coerceToType(layer.wkbType())
    return pieces[0] if pieces else None
