"""The area in which photographs are searched: polygons, an extent, or a circle, and perhaps only along paths."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsPointXY,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)

from ...core.base.messages import Message
from . import parameters as shared
from .fields import is_null
from .i18n import tr
from .lost_crs import check_not_lost, raster_crs
from .raster_parameter import RasterParameter, no_statistics_file

WGS84 = "EPSG:4326"


def add_area_parameters(algorithm):
    """Declare area, extent, radius, paths and weights."""
    area = QgsProcessingParameterFeatureSource(
        "AREA", tr("Area"), [QgsProcessing.SourceType.TypeVectorPolygon], optional=True
    )
    algorithm.addParameter(shared.explained(area, tr("Polygons in which the photographs may have been taken.")))
    extent = QgsProcessingParameterExtent("EXTENT", tr("Extent"), optional=True)
    algorithm.addParameter(shared.explained(extent, tr("Rectangle to search, if no area is given.")))
    algorithm.addParameter(
        shared.distance(
            "RADIUS",
            tr("Radius around the recorded position (m)"),
            None,
            tr("Searches around the position of each photograph, if neither an area nor an extent is given."),
            minimum=1.0,
            optional=True,
        )
    )
    paths = QgsProcessingParameterFeatureSource(
        "PATHS", tr("Paths"), [QgsProcessing.SourceType.TypeVectorLine], optional=True
    )
    text = tr("Only places near these lines are searched, for example hiking trails and roads.")
    algorithm.addParameter(shared.explained(shared.advanced(paths), text))
    algorithm.addParameter(
        shared.advanced(
            shared.distance(
                "PATH_DISTANCE",
                tr("Distance from the paths (m)"),
                150.0,
                tr("Places farther from the paths are not searched. It should be at least half the spacing."),
                minimum=1.0,
            )
        )
    )
    weights = RasterParameter("WEIGHTS", tr("Weights of places"), optional=True)
    text = tr(
        "Raster with the relative probability that a photograph was taken at a place, for example from land cover or "
        "slope. Zero and nodata exclude a place."
    )
    algorithm.addParameter(shared.explained(shared.advanced(weights), text))


def area_fault(algorithm, parameters, context):
    """Sentence on a missing area, or None."""
    if any(not is_null(parameters.get(name)) for name in ("AREA", "EXTENT", "RADIUS")):
        return None
    return tr("Choose where to search: an area, an extent, or a radius around the recorded positions.")


def weights_source(algorithm, parameters, context):
    """Provider and CRS of the raster of weights, for another thread; None without one. Call it in the main thread."""
    with no_statistics_file(parameters.get("WEIGHTS")):
        layer = algorithm.parameterAsRasterLayer(parameters, "WEIGHTS", context)
    return None if layer is None else (layer.dataProvider().clone(), raster_crs(layer))


class SearchArea:
    """The area of one run.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`; the parameters of `add_area_parameters` are read, but for WEIGHTS, which
        `weights_source` has put into `algorithm.weights`.
    """

    def __init__(self, algorithm, parameters, context):
        self.context = context
        self.radius_m = None
        self._common = None
        self._paths = _lines(algorithm, parameters, context)
        self._path_m = algorithm.parameterAsDouble(parameters, "PATH_DISTANCE", context)
        self._weights = algorithm.weights
        if not is_null(parameters.get("AREA")):
            self._common = _united(algorithm, parameters, context, "AREA")
        elif not is_null(parameters.get("EXTENT")):
            crs = QgsCoordinateReferenceSystem(WGS84)
            self._common = algorithm.parameterAsExtentGeometry(parameters, "EXTENT", context, crs)
        else:
            self.radius_m = algorithm.parameterAsDouble(parameters, "RADIUS", context)

    @property
    def is_common(self):
        """Whether all photographs share the area, so that a fault in it concerns all of them."""
        return self._common is not None

    def around(self, longitude_deg, latitude_deg):
        """The core's `Area` for a photograph at a position; either may be None."""
        from ...core.locate.places import Area, AreaError

        if self._common is not None:
            return _area_of(self._on_paths(self._common))
        if longitude_deg is None or latitude_deg is None:
            raise AreaError(
                Message("The photo has no recorded position to search around. Choose an area or an extent.")
            )
        circle = Area.circle(longitude_deg, latitude_deg, self.radius_m)
        if self._paths is None:
            return circle
        ring = [QgsPointXY(*vertex) for vertex in circle.rings[0]]
        return _area_of(self._on_paths(QgsGeometry.fromPolygonXY([ring])))

    def _on_paths(self, geometry):
        if self._paths is None:
            return geometry
        crs, wgs84 = _plane_at(geometry), QgsCoordinateReferenceSystem(WGS84)
        project = self.context.transformContext()
        lines, inside = QgsGeometry(self._paths), QgsGeometry(geometry)
        lines = lines.intersection(QgsGeometry.fromRect(geometry.boundingBox().buffered(0.05)))
        lines.transform(QgsCoordinateTransform(wgs84, crs, project))
        inside.transform(QgsCoordinateTransform(wgs84, crs, project))
        near = inside.intersection(lines.buffer(self._path_m, 8))
        near.transform(QgsCoordinateTransform(crs, wgs84, project))
        return near

    def log_weight(self, index):
        """Logarithms of the weights of an index's places, (P,); None without a raster of weights."""
        import numpy as np

        if self._weights is None:
            return None
        provider, crs = self._weights
        wgs84, values = QgsCoordinateReferenceSystem(WGS84), np.zeros(len(index))
        to_raster = QgsCoordinateTransform(wgs84, crs, self.context.transformContext())
        for number, place in enumerate(zip(index.longitude_deg, index.latitude_deg)):
            try:
                value, known = provider.sample(to_raster.transform(QgsPointXY(*map(float, place))), 1)
            except QgsCsException:
                continue
            values[number] = value if known and value > 0 else 0.0
        if not (values > 0).any():
            raise QgsProcessingException(tr("The raster of weights excludes every place of the area. Choose another."))
        with np.errstate(divide="ignore"):
            return np.log(values / values.max())


def _lines(algorithm, parameters, context):
    return None if is_null(parameters.get("PATHS")) else _united(algorithm, parameters, context, "PATHS")


def _united(algorithm, parameters, context, name):
    """All features of a source as one geometry in WGS 84."""
    source = algorithm.parameterAsSource(parameters, name, context)
    if source is None:
        raise QgsProcessingException(algorithm.invalidSourceError(parameters, name))
    check_not_lost(source.sourceCrs())
    wgs84 = QgsCoordinateReferenceSystem(WGS84)
    transform = QgsCoordinateTransform(source.sourceCrs(), wgs84, context.transformContext())
    found = []
    for feature in source.getFeatures():
        geometry = feature.geometry()
        if geometry.isNull() or geometry.isEmpty():
            continue
        try:
            geometry.transform(transform)
        except QgsCsException:
            continue
        found.append(geometry)
    if not found:
        raise QgsProcessingException(tr("{name} has no usable feature. Choose another layer.").format(name=name))
    return QgsGeometry.unaryUnion(found)


def _area_of(geometry):
    from ...core.locate.places import Area

    polygons = [] if geometry.isNull() or geometry.isEmpty() else _polygons(geometry)
    rings = tuple(tuple((point.x(), point.y()) for point in ring[:-1]) for polygon in polygons for ring in polygon)
    if not rings:
        raise QgsProcessingException(tr("The area is empty. Choose a larger one, or a larger distance from the paths."))
    return Area(rings)


def _polygons(geometry):
    parts = geometry.asGeometryCollection() if geometry.isMultipart() else [geometry]
    return [part.asPolygon() for part in parts if part.type() == QgsWkbTypes.GeometryType.PolygonGeometry]


def _plane_at(geometry):
    """A CRS in metres around a geometry."""
    from ...core.io.crs import local_plane

    middle = geometry.boundingBox().center()
    crs = QgsCoordinateReferenceSystem()
    crs.createFromUserInput(local_plane(middle.x(), middle.y()))
    return crs
