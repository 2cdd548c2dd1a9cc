"""Summits from a layer or from the DEM, as they appear in one view."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
)

from . import parameters as shared
from .fields import is_null, number_or_none
from .i18n import tr
from .map_places import local_of_map, to_dem_transform, transformed

SNAP_M = 500.0


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
    text = tr("Points with names and heights. Empty: summits are found in the DEM by their prominence.")
    algorithm.addParameter(shared.explained(layer, text))
    name = QgsProcessingParameterField("NAME_FIELD", tr("Field with names"), "name", "PEAKS", optional=True)
    algorithm.addParameter(shared.explained(name, tr("Summits without a name are left out.")))
    height = shared.number_field(
        "ELEVATION_FIELD", tr("Field with heights (m)"), tr("Text such as 4478 is read too."), "ele", "PEAKS"
    )
    height.setDataType(height.DataType.Any)
    algorithm.addParameter(height)
    least = shared.distance(
        "MIN_PROMINENCE",
        tr("Minimum prominence (m)"),
        150.0,
        tr("Prominence of the summits that are found in the DEM."),
        1.0,
    )
    algorithm.addParameter(shared.advanced(least))
    algorithm.addParameter(shared.advanced(snap_distance()))


def snap_distance():
    """Search radius around a published summit."""
    return shared.distance(
        "SNAP", tr("Search radius around a published summit (m)"), SNAP_M, tr("0: use the published position.")
    )


class Summitry:
    """The summits of one run.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`.
    terrain : core.io.raster.Dem
    dem_crs : QgsCoordinateReferenceSystem
    """

    def __init__(self, algorithm, parameters, context, terrain, dem_crs):
        self.terrain = terrain
        self.snap_m = algorithm.parameterAsDouble(parameters, "SNAP", context)
        self.least_m = algorithm.parameterAsDouble(parameters, "MIN_PROMINENCE", context)
        self.given = None
        if not is_null(parameters.get("PEAKS")):
            source = algorithm.parameterAsSource(parameters, "PEAKS", context)
            if source is None:
                raise QgsProcessingException(algorithm.invalidSourceError(parameters, "PEAKS"))
            names = [algorithm.parameterAsString(parameters, key, context) for key in ("NAME_FIELD", "ELEVATION_FIELD")]
            self.given = _read(source, *names, to_dem_transform(source.sourceCrs(), dem_crs, context))

    def around(self, view, max_distance_m):
        """(name, east, north, height, dem height, moved, prominence) of the summits within reach of a view."""
        if self.given is None:
            return self._found(view, max_distance_m)
        summits = []
        for name, x, y, height in self.given:
            east, north = (float(v) for v in local_of_map(self.terrain, view.frame, x, y))
            if np.hypot(east, north) <= max_distance_m:
                summits.append((name, *self._set(view, east, north, height), np.nan))
        return summits

    def _set(self, view, east, north, height):
        from ...core.mapping.peaks import snap_to_summit

        if self.snap_m <= 0:
            return east, north, np.nan if height is None else height, np.nan, 0.0
        to_east, to_north, top = snap_to_summit(self.terrain, view.frame, east, north, height, self.snap_m)
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


def _read(source, name_field, height_field, transform):
    known = {field.name() for field in source.fields()}
    if name_field not in known:
        raise QgsProcessingException(
            tr("The layer of summits has no field {field}. Choose the field with the names.").format(field=name_field)
        )
    summits = []
    for feature in source.getFeatures():
        geometry = transformed(feature.geometry(), transform)
        name = feature[name_field]
        if geometry is None or is_null(name):
            continue
        point = geometry.centroid().asPoint()
        height = number_or_none(feature[height_field]) if height_field in known else None
        summits.append((str(name), point.x(), point.y(), height))
    return summits
