"""Conversion of places between three systems: a layer's coordinates, the DEM's, and the local metres around an eye."""

from __future__ import annotations

import numpy as np
from qgis.core import (
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsGeometryCollection,
    QgsProcessingException,
    QgsWkbTypes,
)

from .i18n import tr
from .lost_crs import check_not_lost


def to_dem_transform(crs, dem_crs, context):
    """Return the transformation from a layer's CRS to the DEM's, or raise a clear error."""
    if not crs.isValid():
        raise QgsProcessingException(
            tr("A layer has no coordinate reference system. Assign the right one in the layer's properties.")
        )
    check_not_lost(crs)
    return QgsCoordinateTransform(crs, dem_crs, context.transformContext())


def crs_of(algorithm, parameters, name, context):
    """CRS of a layer with any geometry.

    QGIS takes layers of geometry collections for tables and hides their CRS, which their provider still has.
    """
    crs = algorithm.parameterAsSource(parameters, name, context).sourceCrs()
    layer = None if crs.isValid() else algorithm.parameterAsVectorLayer(parameters, name, context)
    return crs if layer is None else layer.dataProvider().crs()


def local_of_map(dem, frame, x, y):
    """Local (east, north) [m] of places in the DEM's CRS."""
    x0, dx, _, y0, _, dy = dem.geotransform
    return frame.to_local((np.asarray(x, float) - x0) / dx - 0.5, (np.asarray(y, float) - y0) / dy - 0.5)


def map_of_local(dem, frame, east_m, north_m):
    """(x, y) in the DEM's CRS of local places."""
    x0, dx, _, y0, _, dy = dem.geotransform
    col, row = frame.to_pixel(east_m, north_m)
    return x0 + dx * (col + 0.5), y0 + dy * (row + 0.5)


def transformed(geometry, transform):
    """Copy of a geometry in the transform's target, or None if it cannot be transformed."""
    copy = QgsGeometry(geometry)
    try:
        copy.transform(transform)
    except QgsCsException:
        return None
    return None if copy.isNull() or copy.isEmpty() else copy


def places_of(geometry, kind):
    """Vertices of a geometry by parts: [(x, y, z), ...] arrays; z is NaN where the geometry has none.

    `kind` is 'point' (all places in one part), 'line' (a part per line) or 'polygon' (a part per ring). Arcs become
    chains of short lines.
    """
    geometry = straight(geometry)
    with_z = geometry.constGet().is3D()
    if kind == "point":
        return [_xyz(list(geometry.vertices()), with_z)]
    parts = []
    for part in geometry.constParts():
        if kind == "line":
            parts.append(_xyz(list(part.vertices()), with_z))
        else:
            rings = [part.exteriorRing(), *(part.interiorRing(k) for k in range(part.numInteriorRings()))]
            parts += [_xyz(list(ring.vertices()), with_z) for ring in rings]
    return parts


def _xyz(vertices, with_z):
    return (
        np.array([v.x() for v in vertices]),
        np.array([v.y() for v in vertices]),
        np.array([v.z() if with_z else np.nan for v in vertices]),
    )


def straight(geometry):
    """Geometry without arcs, whose vertices alone would cut them short."""
    shape = geometry.constGet()
    return QgsGeometry(shape.segmentize()) if shape.hasCurvedSegments() else geometry


def simple_parts(geometry):
    """Yield the points, lines and polygons (with their holes) of any geometry, also of a mixed collection."""
    shape = geometry.constGet()
    if isinstance(shape, QgsGeometryCollection):
        for k in range(shape.numGeometries()):
            yield from simple_parts(QgsGeometry(shape.geometryN(k).clone()))
    elif not shape.isEmpty():
        yield geometry


def of_one_kind(geometry):
    """Split a collection of several kinds into one geometry for each kind; others stay whole."""
    if geometry.type() != QgsWkbTypes.GeometryType.UnknownGeometry:
        return [geometry]
    kinds: dict = {}
    for part in simple_parts(geometry):
        kinds.setdefault(kind_of(part), []).append(part)
    return [QgsGeometry.collectGeometry(parts) for parts in kinds.values()]


def kind_of(geometry):
    """Return 'point', 'line' or 'polygon' for a geometry."""
    return ("point", "line", "polygon")[int(geometry.type())]


def number(value):
    """Return a float that QGIS stores; None for NaN and infinity."""
    value = float(value)
    return value if np.isfinite(value) else None
