"""Placing of drawn features on the map, one photo after another, with their errors as plain numbers."""

from __future__ import annotations

import numpy as np
from qgis.core import QgsGeometry, QgsLineString, QgsMultiLineString, QgsMultiPolygon, QgsPoint, QgsPointXY, QgsPolygon

from ...core.base.progress import subtask
from .feedback import warn
from .fields import FieldSpec
from .i18n import tr
from .map_places import kind_of, map_of_local, number, simple_parts
from .pixel_input import upright_features

ELLIPSE_CORNERS = 48
OUTSIDE = "outside"
"""Status of a feature that lies outside the picture."""

JUMP_RATIO = 1.35
"""Neighbouring places along a drawn line lie on two surfaces if their distances differ by more than this factor."""


def point_specs():
    """Fields of placed points."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("label", "text", tr("Label")),
        FieldSpec("status", "text", tr("What the pixel shows: ground, sky, void, beyond the DEM, outside the frame")),
        FieldSpec("x_px", "real", tr("Column (px)")),
        FieldSpec("y_px", "real", tr("Row (px)")),
        FieldSpec("z", "real", tr("Elevation (m)")),
        FieldSpec("dist_m", "real", tr("Distance from the camera (m)")),
        FieldSpec("azimuth", "real", tr("Azimuth (° from true north)")),
        FieldSpec("elev_deg", "real", tr("Elevation angle (°)")),
        FieldSpec("incidence", "real", tr("Angle of incidence (°, 0 head-on)")),
        FieldSpec("m_per_px", "real", tr("Ground per pixel across the view (m)")),
        *error_specs(),
    ]


def error_specs():
    """Fields of the error ellipse."""
    return [
        FieldSpec("err_major", "real", tr("Error ellipse, major half axis (m)")),
        FieldSpec("err_minor", "real", tr("Error ellipse, minor half axis (m)")),
        FieldSpec("err_azim", "real", tr("Direction of the major axis (° from true north)")),
        FieldSpec("err_z", "real", tr("Standard deviation of the elevation (m)")),
        FieldSpec("p_other", "real", tr("Probability that the pixel shows other ground, beyond an edge")),
        FieldSpec("near_m", "real", tr("Distance, 5 % quantile (m)")),
        FieldSpec("far_m", "real", tr("Distance, 95 % quantile (m)")),
    ]


def drawn_specs():
    """Fields of placed lines and areas."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("label", "text", tr("Label")),
        FieldSpec(
            "status", "text", tr("What it shows: ground, partly ground, sky, void, beyond the DEM, outside the frame")
        ),
        FieldSpec("ground", "real", tr("Share of its outline that lies on known ground")),
        FieldSpec("parts", "whole", tr("Pieces, cut where the ground behind jumps")),
        FieldSpec("dist_min", "real", tr("Nearest distance (m)")),
        FieldSpec("dist_max", "real", tr("Farthest distance (m)")),
        FieldSpec("err_med", "real", tr("Median of the error ellipses' major half axis (m)")),
        FieldSpec("err_max", "real", tr("Largest of the error ellipses' major half axis (m)")),
        FieldSpec("p_other", "real", tr("Mean probability that it shows other ground, beyond an edge")),
    ]


def ellipse_specs():
    """Fields of error ellipses as polygons."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("label", "text", tr("Label")),
        FieldSpec("coverage", "real", tr("Probability that the ellipse contains the true position")),
        *error_specs(),
    ]


class MapFeatures:
    """Collects rows for the output layers, photo by photo.

    Parameters
    ----------
    terrain : core.io.raster.Dem
    drawn : FeaturesByPhoto
    options : SightOptions
    coverage : float
        Probability that an ellipse contains the true place.
    step_px : float
        Step along lines and outlines [pixels].
    """

    def __init__(self, terrain, drawn, options, coverage, step_px):
        self.terrain, self.drawn, self.options = terrain, drawn, options
        self.coverage, self.step_px = coverage, step_px
        self.points, self.lines, self.polygons, self.ellipses = [], [], [], []
        self.sky_count = 0

    @property
    def count(self):
        """Number of features written."""
        return len(self.points) + len(self.lines) + len(self.polygons)

    def add(self, photo, feedback):
        """Place the features drawn on one photo."""
        mine = self.drawn.of(photo.path or photo.name)
        if mine and not photo.sized:
            warn(feedback, photo.name, tr("The picture's size is unknown, so its pixels cannot be placed."))
            return
        mine = upright_features(photo, mine, feedback)
        _tell_outside(photo, mine, feedback)
        for index, feature in enumerate(mine):
            part = subtask(photo.progress, index / len(mine), (index + 1) / len(mine))
            if feature.kind == "point":
                self._add_points(photo, feature, part)
            else:
                self._add_drawn(photo, feature, part)

    def _place(self, photo, xy, progress):
        from ...core.mapping.monoplot import EllipseOptions, ground_ellipses, place_pixels

        placed = place_pixels(self.terrain, photo.view, xy[:, 0], xy[:, 1], self.options, subtask(progress, 0, 0.2))
        ellipse = ground_ellipses(
            self.terrain, photo.view, placed, EllipseOptions(self.coverage), self.options, subtask(progress, 0.2, 1.0)
        )
        x, y = map_of_local(self.terrain, photo.view.frame, placed.hits.east_m, placed.hits.north_m)
        return placed, ellipse, x, y

    def _add_points(self, photo, feature, progress):
        from ...core.mapping.sightline import STATE_NAMES

        xy = np.vstack(feature.parts)
        placed, ellipse, x, y = self._place(photo, xy, progress)
        hits, inside = placed.hits, photo.view.frames(xy[:, 0], xy[:, 1])
        for k in range(len(xy)):
            if not inside[k]:
                unknown = [None] * (len(point_specs()) - 5)
                known = [photo.path or photo.name, feature.label, OUTSIDE, *xy[k].tolist()]
                self.points.append((None, known + unknown))
                self.sky_count += 1
                continue
            ground = bool(hits.on_ground[k])
            errors = _errors(ellipse, k)
            values = [photo.path or photo.name, feature.label, STATE_NAMES[int(hits.state[k])], *xy[k].tolist()]
            values += [number(hits.elevation_m[k]), number(hits.distance_m[k]), number(placed.azimuth_deg[k])]
            values += [number(placed.elevation_deg[k]), number(placed.incidence_deg[k])]
            values += [number(placed.metres_per_pixel[k]), *errors]
            geometry = QgsGeometry(QgsPoint(x[k], y[k], hits.elevation_m[k])) if ground else None
            self.points.append((geometry, values))
            self.sky_count += not ground
            if ground and errors[0] is not None:
                outline = self._ellipse(photo, hits.east_m[k], hits.north_m[k], *errors[:3])
                self.ellipses.append((outline, [values[0], feature.label, self.coverage, *errors]))

    def _ellipse(self, photo, east, north, major, minor, azimuth_deg):
        turn, angle = 2 * np.pi * np.arange(ELLIPSE_CORNERS) / ELLIPSE_CORNERS, np.radians(azimuth_deg)
        along, across = major * np.cos(turn), minor * np.sin(turn)
        places = (
            east + along * np.sin(angle) + across * np.cos(angle),
            north + along * np.cos(angle) - across * np.sin(angle),
        )
        x, y = map_of_local(self.terrain, photo.view.frame, *places)
        return QgsGeometry.fromPolygonXY([[QgsPointXY(a, b) for a, b in zip(x, y)]])

    def _add_drawn(self, photo, feature, progress):
        from ...core.mapping.sightline import STATE_NAMES

        closed = feature.kind == "polygon"
        chains = [_followed(part, self.step_px, closed) for part in feature.parts]
        placed, ellipse, x, y = self._place(photo, np.vstack(chains), progress)
        hits = placed.hits
        inside = photo.view.frames(placed.x_px, placed.y_px)
        ground = hits.on_ground & inside
        edges = np.cumsum([0] + [len(chain) for chain in chains])
        pieces = []
        for start, stop in zip(edges[:-1], edges[1:]):
            part = slice(start, stop)
            places = np.column_stack([x[part], y[part], hits.elevation_m[part]])
            pieces.append(_ring(places, ground[part]) if closed else _runs(places, ground[part], hits.distance_m[part]))
        geometry, count = _polygon(pieces) if closed else _lines(pieces)
        if ground.all():
            status = "ground"
        elif ground.any():
            status = "partly ground"
        elif not inside.any():
            status = OUTSIDE
        else:
            status = STATE_NAMES[int(np.bincount(hits.state).argmax())]
        self.sky_count += geometry is None
        known = np.isfinite(ellipse.semi_major_m) & inside
        errors = ellipse.semi_major_m[known]
        values = [photo.path or photo.name, feature.label, status, float(ground.mean()), count]
        values += [number(hits.distance_m[ground].min()), number(hits.distance_m[ground].max())] if ground.any() else [
            None, None]  # fmt: skip
        values += [number(np.median(errors)), number(errors.max())] if errors.size else [None, None]
        values.append(number(np.nanmean(ellipse.p_other[ground])) if ground.any() else None)
        (self.polygons if closed else self.lines).append((geometry, values))


def _tell_outside(photo, features, feedback):
    """Warn of features that reach beyond the picture, which most often were drawn on another version of it."""
    outside = [f for f in features if not all(photo.view.frames(part[:, 0], part[:, 1]).all() for part in f.parts)]
    if outside:
        camera = photo.view.camera
        text = tr(
            "{count} of {total} image features reach beyond the picture of {width} x {height} pixels; nothing outside "
            "it is placed. Check that they were drawn on this picture, and not on a reduced, cropped or turned copy."
        )
        numbers = {"count": len(outside), "total": len(features)}
        warn(feedback, photo.name, text.format(width=camera.width_px, height=camera.height_px, **numbers))


def _errors(ellipse, k):
    columns = (
        ellipse.semi_major_m, ellipse.semi_minor_m, ellipse.azimuth_deg, ellipse.sigma_z_m, ellipse.p_other,
        ellipse.near_m, ellipse.far_m,
    )  # fmt: skip
    return [number(column[k]) for column in columns]


def _followed(points, step_px, closed):
    """Positions along a chain of pixels, one step apart; a ring returns to its first."""
    points = np.vstack([points, points[:1]]) if closed else np.asarray(points, float)
    length = np.hypot(*np.diff(points, axis=0).T)
    pieces = np.maximum(np.ceil(length / step_px), 1).astype(int)
    t = np.concatenate([k + np.arange(n) / n for k, n in enumerate(pieces)] + [[float(len(pieces))]])
    return np.column_stack([np.interp(t, np.arange(len(points)), points[:, axis]) for axis in (0, 1)])


def _ring(places, ground):
    places = places[ground]
    if len(places) < 3:
        return []
    return [places if np.array_equal(places[0], places[-1]) else np.vstack([places, places[:1]])]


def _runs(places, ground, distance_m):
    """Pieces of a line on the ground, cut where the distance jumps."""
    with np.errstate(invalid="ignore"):
        ratio = distance_m[1:] / distance_m[:-1]
        whole = ground[1:] & ground[:-1] & (ratio < JUMP_RATIO) & (ratio > 1 / JUMP_RATIO)
    cuts = np.flatnonzero(~whole) + 1
    pieces = [piece for piece in np.split(np.arange(len(places)), cuts) if len(piece) > 1]
    return [places[piece] for piece in pieces if ground[piece].all()]


def _lines(pieces):
    lines = QgsMultiLineString()
    for run in (run for part in pieces for run in part):
        lines.addGeometry(_line(run))
    count = lines.numGeometries()
    return (QgsGeometry(lines) if count else None), count


def _polygon(pieces):
    """Make one multipolygon of the outer ring and the holes; the first piece is the outer one.

    Holes remain none if their outer ring lies in the sky. Where the ground jumps, a ring may cross itself on the map.
    """
    if not pieces[0]:
        return None, 0
    polygon = QgsPolygon()
    polygon.setExteriorRing(_line(pieces[0][0]))
    for ring in (ring for part in pieces[1:] for ring in part):
        polygon.addInteriorRing(_line(ring))
    whole = QgsMultiPolygon()
    whole.addGeometry(polygon)
    area = QgsGeometry(whole)
    return (area if area.isGeosValid() else _valid(area)), 1


def _valid(area):
    """Multipolygon of the parts of an area whose rings cross."""
    whole = QgsMultiPolygon()
    for part in simple_parts(area.makeValid()):
        if kind_of(part) == "polygon":
            whole.addGeometry(part.constGet().clone())
    return QgsGeometry(whole) if whole.numGeometries() else None


def _line(places):
    return QgsLineString([QgsPoint(*place) for place in places.tolist()])
