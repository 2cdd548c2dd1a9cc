"""Summits from a layer or from the DEM, as they appear in one view."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
)

from ...core.base.summit_heights import contradicts, fits_in_feet
from . import parameters as shared
from .feedback import warn
from .fields import is_null, metres_of
from .i18n import tr
from .map_places import local_of_map, simple_parts, to_dem_transform, transformed

SNAP_M, LEAST_M = 500.0, 150.0


@dataclass(frozen=True)
class ShownSummit:
    """A summit in a view; numbers are NaN where unknown."""

    name: str
    height_m: float
    dem_m: float
    moved_m: float
    prominence_m: float
    east_m: float
    north_m: float
    state: str
    x_px: float
    y_px: float
    distance_m: float
    azimuth_deg: float
    elevation_deg: float
    mark: Any

    @property
    def visible(self):
        """Return whether the summit is visible from the eye."""
        return self.state == "visible"


def add_summit_parameters(algorithm):
    """Declare the layer of summits, its fields, and the search in the DEM."""
    layer = QgsProcessingParameterFeatureSource(
        "PEAKS", tr("Summits"), [QgsProcessing.SourceType.TypeVectorPoint], optional=True
    )
    text = tr(
        "Points with names and heights, or an OpenStreetMap extract on your disk (.osm, .osm.pbf), of which the "
        "summits are read. Empty: summits are found in the DEM by their prominence."
    )
    algorithm.addParameter(shared.explained(layer, text))
    name = QgsProcessingParameterField("NAME_FIELD", tr("Field with names"), "name", "PEAKS", optional=True)
    algorithm.addParameter(shared.explained(name, tr("Summits without a name are left out.")))
    text = tr("Text such as 4478, 4478 m or 14692 ft is read too. Heights that the DEM contradicts are not used.")
    algorithm.addParameter(point_heights("PEAKS", text))
    least = shared.distance(
        "MIN_PROMINENCE",
        tr("Minimum prominence (m)"),
        LEAST_M,
        tr("Prominence of the summits that are found in the DEM."),
        1.0,
    )
    algorithm.addParameter(shared.advanced(least))
    algorithm.addParameter(shared.advanced(snap_distance()))


def point_heights(features, text):
    """Field with the heights of points, as numbers or as text with a unit.

    Parameters
    ----------
    features : str
        Name of the parameter with the layer.
    text : str
        Help.
    """
    height = shared.number_field("ELEVATION_FIELD", tr("Field with heights (m)"), text, "ele", features)
    height.setDataType(height.DataType.Any)
    return height


def snap_distance():
    """Search radius around a published summit."""
    return shared.distance(
        "SNAP", tr("Search radius around a published summit (m)"), SNAP_M, tr("0: use the published position.")
    )


class PublishedHeights:
    """Tells whether the DEM contradicts published heights, and warns of each summit once."""

    def __init__(self, feedback):
        self._feedback, self._told = feedback, set()

    def doubted(self, name, height, top):
        """Return whether the DEM contradicts a height, given that of the top there [m]."""
        if not contradicts(height, top):
            return False
        if self._feedback is not None and (name, height) not in self._told:
            self._told.add((name, height))
            text = tr(
                "The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is "
                "used. The point may lie beside its summit: move it, or enlarge SNAP."
            )
            if fits_in_feet(height, top):
                text = tr(
                    "The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM "
                    "is used. If it is in feet, write 'ft' after it."
                )
            warn(self._feedback, name, text.format(height=f"{height:.0f}", top=f"{top:.0f}"))
        return True


def summits_of(algorithm, parameters, context, terrain, dem_crs):
    """The summits that the parameters of `add_summit_parameters` name.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`.
    terrain : core.io.raster.Dem
    dem_crs : QgsCoordinateReferenceSystem
    """
    given = None
    if not is_null(parameters.get("PEAKS")):
        source = algorithm.parameterAsSource(parameters, "PEAKS", context)
        if source is None:
            raise QgsProcessingException(algorithm.invalidSourceError(parameters, "PEAKS"))
        given = _given(algorithm, parameters, context, source, dem_crs)
    snap_m, least_m = (algorithm.parameterAsDouble(parameters, key, context) for key in ("SNAP", "MIN_PROMINENCE"))
    return Summitry(terrain, given, snap_m, least_m, context.feedback())


def _given(algorithm, parameters, context, source, dem_crs):
    """Summits of a layer, or of the OpenStreetMap extract to which it belongs."""
    from ...core.io.osm_summits import is_extract

    layer = algorithm.parameterAsVectorLayer(parameters, "PEAKS", context)
    path = "" if layer is None else layer.source().split("|")[0]
    if is_extract(path):
        return _of_extract(path, dem_crs, context)
    name, height = (algorithm.parameterAsString(parameters, key, context) for key in ("NAME_FIELD", "ELEVATION_FIELD"))
    return read_summits(source, name, height, to_dem_transform(source.sourceCrs(), dem_crs, context))


class Summitry:
    """The summits of one run.

    Parameters
    ----------
    terrain : core.io.raster.Dem
    given : list or None
        From `read_summits`; None searches the DEM.
    snap_m : float
        Search radius around a published summit [m].
    least_m : float
        Prominence of the summits that are found in the DEM [m].
    feedback : QgsProcessingFeedback or None
        Gets the warnings; None keeps silent.
    """

    def __init__(self, terrain, given=None, snap_m=SNAP_M, least_m=LEAST_M, feedback=None):
        self.terrain, self.given, self.snap_m, self.least_m = terrain, given, snap_m, least_m
        self._heights = PublishedHeights(feedback)

    def around(self, view, max_distance_m):
        """(name, east, north, height, dem height, moved, prominence) of the summits within reach of a view."""
        if self.given is None:
            return self._found(view, max_distance_m)
        summits = []
        for name, x, y, height in self.given:
            east, north = (float(v) for v in local_of_map(self.terrain, view.frame, x, y))
            if np.hypot(east, north) <= max_distance_m:
                summits.append((name, *self._set(view, name, (east, north), height), np.nan))
        return summits

    def _set(self, view, name, place, height):
        """East, north, height, height in the DEM and distance moved of a published summit."""
        from ...core.mapping.peaks import snap_to_summit

        east, north = place
        radius_m = max(self.snap_m, 0.0)
        to_east, to_north, top = snap_to_summit(self.terrain, view.frame, east, north, height, radius_m)
        if height is not None and self._heights.doubted(name, height, top):
            height = None
            to_east, to_north, top = snap_to_summit(self.terrain, view.frame, east, north, None, radius_m)
        if self.snap_m <= 0:
            return east, north, top if height is None else height, np.nan, 0.0
        moved = float(np.hypot(to_east - east, to_north - north))
        return to_east, to_north, top if height is None else height, top, moved

    def _found(self, view, max_distance_m):
        from ...core.mapping.peaks import summits_around

        places = summits_around(self.terrain, view.frame, max_distance_m, self.least_m)
        return [(f"{z:.0f} m", east, north, z, z, 0.0, p) for east, north, z, p in places]

    def shown(self, view, options, all_round=False):
        """Summits in the frame of a view, most important first."""
        from ...core.figures.annotate import NamedPoint
        from ...core.mapping.peaks import own_ground_m
        from ...core.mapping.projecting import STATE_NAMES, Places, PlaceState, project_places

        summits = self.around(view, options.max_distance_m)
        if not summits:
            return []
        east, north, height = (np.array([summit[k] for summit in summits], float) for k in (1, 2, 3))
        places = Places(east, north, height, own_ground_m=own_ground_m(view.frame))
        seen = project_places(self.terrain, view, places, options, all_round)
        found = []
        for k, (name, _, _, tall, top, moved, prominence) in enumerate(summits):
            if seen.state[k] == PlaceState.OUTSIDE:
                continue
            words = name if self.given is None or not np.isfinite(tall) else f"{name} {tall:.0f} m"
            place, state = (float(seen.x_px[k]), float(seen.y_px[k])), STATE_NAMES[int(seen.state[k])]
            found.append(
                ShownSummit(
                    name, tall, top, moved, prominence, float(east[k]), float(north[k]), state,
                    *place, float(seen.distance_m[k]), float(seen.azimuth_deg[k]), float(seen.elevation_deg[k]),
                    NamedPoint(words, *place),
                )
            )  # fmt: skip
        return sorted(found, key=_importance)


def _importance(summit):
    """Rank prominent summits first, else those that are highest in the picture or above sea level."""
    if np.isfinite(summit.prominence_m):
        return (-summit.prominence_m, summit.name)
    return (-summit.elevation_deg - summit.height_m / 2000.0, summit.name)


def read_summits(source, name_field, height_field, transform):
    """Read (name, x, y, height or None) of the summits of a layer, in the transform's target.

    Parameters
    ----------
    source : QgsFeatureSource
    name_field, height_field : str
        The latter may be missing.
    transform : QgsCoordinateTransform
    """
    known = {field.name() for field in source.fields()}
    if name_field not in known:
        raise QgsProcessingException(
            tr("The layer of summits has no field {field}. Choose the field with the names.").format(field=name_field)
        )
    summits = []
    for feature in source.getFeatures():
        name = feature[name_field]
        geometry = transformed(feature.geometry(), transform)
        if geometry is None or is_null(name):
            continue
        height = metres_of(feature[height_field]) if height_field in known else None
        for part in simple_parts(geometry):
            point = part.centroid().asPoint()
            summits.append((str(name), point.x(), point.y(), height))
    return summits


def _of_extract(path, dem_crs, context):
    """Summits of an OpenStreetMap extract, whose layer as QGIS opens it lacks the heights."""
    from ...core.io.osm_summits import read_summits

    wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
    transform, summits = to_dem_transform(wgs84, dem_crs, context), []
    for name, longitude, latitude, height in read_summits(path):
        place = transformed(QgsGeometry.fromPointXY(QgsPointXY(longitude, latitude)), transform)
        if place is not None:
            summits.append((name, place.asPoint().x(), place.asPoint().y(), metres_of(height)))
    return summits
