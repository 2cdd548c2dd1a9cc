"""Fields and features of located photographs: the best place, the candidates and the region."""

from __future__ import annotations

from qgis.core import QgsGeometry, QgsPointXY

from .fields import FieldSpec
from .i18n import in_users_language, tr


def located_specs():
    """Fields of the best places and of the candidates; the names are a contract."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("rank", "whole", tr("Rank")),
        FieldSpec("heading", "real", tr("Heading (° from true north)")),
        FieldSpec("pitch", "real", tr("Pitch (°, + up)")),
        FieldSpec("roll", "real", tr("Roll (°, + right side down)")),
        FieldSpec("hfov", "real", tr("Horizontal field of view (°)")),
        FieldSpec("vfov", "real", tr("Vertical field of view (°)")),
        FieldSpec("eye_z", "real", tr("Elevation of the camera (m)")),
        FieldSpec("p_correct", "real", tr("Probability that place (500 m) and heading (3°) are right")),
        FieldSpec("score", "real", tr("Agreement of the skyline with the horizon")),
        FieldSpec("semi_maj", "real", tr("Error ellipse (90 %), longer half axis (m)")),
        FieldSpec("semi_min", "real", tr("Error ellipse (90 %), shorter half axis (m)")),
        FieldSpec("semi_az", "real", tr("Azimuth of the longer half axis (°)")),
        FieldSpec("hfov_corr", "real", tr("Correlation of place and focal length")),
        FieldSpec("moved_m", "real", tr("Distance from the recorded position (m)")),
        FieldSpec("status", "text", tr("Status")),
        FieldSpec("message", "text", tr("Message")),
    ]


def region_specs():
    """Fields of the regions."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("area_km2", "real", tr("Area (km²)")),
        FieldSpec("p_correct", "real", tr("Probability that place (500 m) and heading (3°) are right")),
        FieldSpec("status", "text", tr("Status")),
    ]


def best_row(path, located, recorded):
    """Geometry and values of the best place; a photograph without one keeps its row."""
    if not located.places:
        blank = [None] * len(located_specs())
        blank[0], blank[-2], blank[-1] = path, located.status, in_users_language(located.message)
        return None, blank
    return _place_row(path, located, 0, recorded)


def candidate_rows(path, located, recorded):
    """Rows of all places, best first."""
    return [_place_row(path, located, number, recorded) for number in range(len(located.places))]


def _place_row(path, located, number, recorded):
    place = located.places[number]
    seen, best = place.oriented, place.oriented.orientation.best
    axes = [None] * 4
    if place.ellipse is not None:
        around = place.ellipse
        axes = [around.major_m, around.minor_m, around.azimuth_deg, around.focal_correlation]
    values = [
        path,
        number + 1,
        seen.heading_deg,
        best.pose.pitch_deg,
        best.pose.roll_deg,
        best.camera.hfov_deg,
        best.camera.vfov_deg,
        seen.eye_elevation_m,
        place.probability,
        place.score,
        *axes,
        _moved_m(place, recorded),
        located.status,
        in_users_language(located.message),
    ]
    return QgsGeometry.fromPointXY(QgsPointXY(place.longitude_deg, place.latitude_deg)), values


def _moved_m(place, recorded):
    from math import cos, hypot, radians

    from ...core.base.curvature import METRES_PER_DEGREE

    if None in recorded:
        return None
    north = (place.latitude_deg - recorded[1]) * METRES_PER_DEGREE
    east = (place.longitude_deg - recorded[0]) * METRES_PER_DEGREE * cos(radians(place.latitude_deg))
    return hypot(east, north)


def region_row(path, located, index):
    """Polygon of the places that hold 90 % of the probability; None if there are none."""
    from math import cos, radians

    from ...core.base.curvature import METRES_PER_DEGREE

    if not len(located.region):
        return None
    north = 0.5 * index.spacing_m / METRES_PER_DEGREE * 1.02
    cells = []
    for longitude, latitude in zip(index.longitude_deg[located.region], index.latitude_deg[located.region]):
        east = north / cos(radians(latitude))
        corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ring = [QgsPointXY(longitude + x * east, latitude + y * north) for x, y in corners]
        cells.append(QgsGeometry.fromPolygonXY([ring]))
    outline = QgsGeometry.unaryUnion(cells)
    outline.convertToMultiType()
    km2 = len(located.region) * index.spacing_m**2 / 1e6
    return outline, [path, km2, located.p_correct, located.status]
