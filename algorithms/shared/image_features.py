"""Map features in the pixels of one photo after another."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from qgis.core import QgsGeometry, QgsPointXY, QgsProcessingException

from ...core.base.upright import stored_of_upright
from .fields import FieldSpec, is_null, metres_of
from .i18n import tr
from .map_places import kind_of, local_of_map, number, of_one_kind, places_of, transformed
from .pixel_input import orientation_of
from .summit_input import PublishedHeights

AREA_SAMPLE_PX = 6.0
"""Spacing of the grid on which an area's visible share is sampled, at its nearest point [pixels]."""


def _common_specs():
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("feature_id", "whole", tr("Map feature")),
        FieldSpec("name", "text", tr("Name")),
        FieldSpec("state", "text", tr("visible, hidden, outside the frame, unknown")),
    ]


def point_specs():
    """Fields of points in pictures."""
    return [
        *_common_specs(),
        FieldSpec("x_px", "real", tr("Column (px)")),
        FieldSpec("y_px", "real", tr("Row (px)")),
        FieldSpec("dist_m", "real", tr("Distance from the camera (m)")),
        FieldSpec("azimuth", "real", tr("Azimuth (° from true north)")),
        FieldSpec("elev_deg", "real", tr("Elevation angle (°)")),
        FieldSpec("z", "real", tr("Elevation (m)")),
    ]


def line_specs():
    """Fields of lines and outlines in pictures."""
    return [
        *_common_specs(),
        FieldSpec("part", "whole", tr("Line or ring of the feature")),
        FieldSpec("from_share", "real", tr("Begins at this share of its length")),
        FieldSpec("to_share", "real", tr("Ends at this share of its length")),
        FieldSpec("dist_min", "real", tr("Nearest distance (m)")),
        FieldSpec("dist_max", "real", tr("Farthest distance (m)")),
        FieldSpec("vis_share", "real", tr("Share of the whole feature that is visible")),
    ]


@dataclass(frozen=True)
class MapFeature:
    """A feature, or the part of a mixed collection that is of one kind.

    Attributes
    ----------
    id : int
    name : str
    geometry : QgsGeometry
        In the DEM's CRS.
    height_m : float or None
        Published height of a point [m].
    """

    id: int
    name: str
    geometry: Any
    height_m: float | None = None


@dataclass(frozen=True)
class Placement:
    """How features are set on the ground: height above it [m], step along lines [pixels], radius around summits [m]."""

    height_above_m: float = 0.0
    step_px: float = 2.0
    snap_m: float = 0.0


def read_map_features(source, transform, name_field, height_field):
    """Read features whose geometry can be transformed.

    Parameters
    ----------
    source : QgsProcessingFeatureSource
    transform : QgsCoordinateTransform
        From `map_places.to_dem_transform`.
    name_field, height_field : str
        Empty, or a field that does not exist: no names, no heights.

    Returns
    -------
    list of MapFeature
    """
    known, found = source.fields(), []
    for feature in source.getFeatures():
        geometry = transformed(feature.geometry(), transform)
        if geometry is None:
            continue
        called = feature[name_field] if name_field else None
        height_m = metres_of(feature[height_field]) if known.lookupField(height_field) >= 0 else None
        name = "" if is_null(called) else str(called)
        found += [MapFeature(feature.id(), name, shape, height_m) for shape in of_one_kind(geometry)]
    if not found:
        raise QgsProcessingException(
            tr("The map features are empty, or lie outside the region for which the DEM's CRS is valid.")
        )
    return found


class ImageFeatures:
    """Collects rows for the outputs.

    Parameters
    ----------
    terrain : core.io.raster.Dem
    features : list of MapFeature
    options : SightOptions
    placement : Placement
    feedback : QgsProcessingFeedback or None
        Gets the warnings; None keeps silent.
    """

    def __init__(self, terrain, features, options, placement, feedback):
        self.terrain, self.options, self.placement = terrain, options, placement
        self.points, self.lines, self.visible_count = [], [], 0
        self._features, self._heights = features, PublishedHeights(feedback)

    def add(self, photo):
        """Project all features into one photo and return named points and strokes for its picture."""
        named, strokes = [], []
        for feature in self._features:
            kind = kind_of(feature.geometry)
            if kind == "point":
                named += self._add_points(photo, feature)
            else:
                strokes += self._add_lines(photo, feature.id, feature.name, feature.geometry, kind)
        return named, strokes

    def _local(self, photo, x, y):
        return local_of_map(self.terrain, photo.view.frame, x, y)

    def _places(self, photo, feature):
        """Points of a feature: a summit on its top in the DEM, all others on the ground."""
        from ...core.mapping.projecting import Places
        from ...core.mapping.sightings import place_of_height

        x, y, _ = places_of(feature.geometry, "point")[0]
        east, north = self._local(photo, x, y)
        if feature.height_m is None or x.size > 1:
            return Places(east, north, height_above_m=self.placement.height_above_m)
        doubted = partial(self._heights.doubted, feature.name or str(feature.id))
        place, frame = (float(east[0]), float(north[0])), photo.view.frame
        found = place_of_height(self.terrain, frame, place, feature.height_m, self.placement.snap_m, doubted)
        return replace(found, height_above_m=self.placement.height_above_m)

    def _add_points(self, photo, feature):
        from ...core.figures.annotate import NamedPoint
        from ...core.mapping.projecting import STATE_NAMES, PlaceState, project_places

        shown = project_places(self.terrain, photo.view, self._places(photo, feature), self.options)
        identifier, name, marks = feature.id, feature.name, []
        for k in range(shown.state.size):
            at = number(shown.x_px[k]), number(shown.y_px[k])
            values = [photo.path or photo.name, identifier, name, STATE_NAMES[int(shown.state[k])], *at]
            values += [number(v[k]) for v in (shown.distance_m, shown.azimuth_deg, shown.elevation_deg)]
            values.append(number(shown.elevation_m[k]))
            geometry = None if None in at else QgsGeometry.fromPointXY(_on_picture(photo, [at])[0])
            self.points.append((geometry, values))
            if shown.state[k] == PlaceState.VISIBLE:
                self.visible_count += 1
                marks.append(NamedPoint(name or str(identifier), *at))
        return marks

    def _add_lines(self, photo, identifier, name, geometry, kind):
        from ...core.figures.annotate import Stroke
        from ...core.mapping.projecting import STATE_NAMES, Places, PlaceState, project_line

        parts = [self._local(photo, x, y) for x, y, _ in places_of(geometry, kind)]
        runs = [
            (part, run)
            for part, (east, north) in enumerate(parts)
            for run in project_line(self.terrain, photo.view, Places(east, north), self.placement.step_px, self.options)
        ]
        share = self._visible_area(photo, parts) if kind == "polygon" else _visible_length(parts, runs)
        strokes = []
        for part, run in runs:
            values = [photo.path or photo.name, identifier, name, STATE_NAMES[run.state], part, *run.share]
            values += [number(run.distance_m.min()), number(run.distance_m.max()), number(share)]
            self.lines.append((_line_geometry(photo, run), values))
            self.visible_count += run.state == PlaceState.VISIBLE
            if run.state in (PlaceState.VISIBLE, PlaceState.HIDDEN):
                strokes.append(Stroke(run.x_px, run.y_px, run.state == PlaceState.VISIBLE))
        return strokes

    def _visible_area(self, photo, rings):
        from ...core.mapping.projecting import Places, project_places, sample_area

        nearest = min(float(np.hypot(east, north).min()) for east, north in rings)
        spacing = max(AREA_SAMPLE_PX * nearest / photo.view.camera.focal_px, 0.5 * photo.view.frame.cell_m)
        east, north = sample_area(rings, spacing)
        if not east.size:
            return np.nan
        return project_places(self.terrain, photo.view, Places(east, north), self.options).visible.mean()


def _visible_length(parts, runs):
    from ...core.mapping.projecting import PlaceState

    lengths = [float(np.hypot(np.diff(east), np.diff(north)).sum()) for east, north in parts]
    total = sum(lengths)
    seen = sum((run.share[1] - run.share[0]) * lengths[part] for part, run in runs if run.state == PlaceState.VISIBLE)
    return seen / total if total else np.nan


def _on_picture(photo, xy_px):
    """Positions on the picture as QGIS shows it: not rotated, from the corner, with y negative downwards."""
    camera = photo.view.camera
    stored = stored_of_upright(xy_px, (camera.width_px, camera.height_px), orientation_of(photo.path))
    return [QgsPointXY(x + 0.5, -(y + 0.5)) for x, y in stored.tolist()]


def _line_geometry(photo, run):
    known = np.isfinite(run.x_px) & np.isfinite(run.y_px)
    if known.sum() < 2:
        return None
    return QgsGeometry.fromPolylineXY(_on_picture(photo, np.column_stack([run.x_px[known], run.y_px[known]])))
