"""One photo's result as attributes: the fields that orientation adds, and what each means."""

from __future__ import annotations

import numpy as np

from ...core.base.angles import difference, true_to_grid, wrap_360
from .fields import FieldSpec
from .i18n import in_users_language, tr


def oriented_specs():
    """Fields in their order; the names are a contract."""
    return [
        FieldSpec("heading", "real", tr("Heading (° from true north)")),
        FieldSpec("pitch", "real", tr("Pitch (°, + up)")),
        FieldSpec("roll", "real", tr("Roll (°, + right side down)")),
        FieldSpec("hfov", "real", tr("Horizontal field of view (°)")),
        FieldSpec("vfov", "real", tr("Vertical field of view (°)")),
        FieldSpec("ncc", "real", tr("Correlation of skylines")),
        FieldSpec("ncc_2nd", "real", tr("Correlation of the second-best heading")),
        FieldSpec("heading_2", "real", tr("Second-best heading (°)")),
        FieldSpec("heading_3", "real", tr("Third-best heading (°)")),
        FieldSpec("sharpness", "real", tr("Sharpness of the correlation peak")),
        FieldSpec("heading_lo", "real", tr("Heading, lower end of the 90 % interval (°)")),
        FieldSpec("heading_hi", "real", tr("Heading, upper end of the 90 % interval (°)")),
        FieldSpec("p_correct", "real", tr("Probability that the heading is right within 3°")),
        FieldSpec("status", "text", tr("Status")),
        FieldSpec("message", "text", tr("Message")),
        FieldSpec("compass", "real", tr("Recorded heading (° from true north)")),
        FieldSpec("compass_df", "real", tr("Recorded minus found heading (°)")),
        FieldSpec("grid_conv", "real", tr("Grid convergence of the DEM (°)")),
        FieldSpec("horizon_m", "real", tr("Distance of the horizon at the heading (m)")),
        FieldSpec("eye_z", "real", tr("Elevation of the camera (m)")),
        FieldSpec("observ_hgt", "real", tr("Camera above the DEM (m), for Visibility Analysis")),
        FieldSpec("radius", "real", tr("Search range (m), for Visibility Analysis")),
        FieldSpec("azim_1", "real", tr("Left edge of view (° from grid north), for Visibility Analysis")),
        FieldSpec("azim_2", "real", tr("Right edge of view (° from grid north), for Visibility Analysis")),
    ]


def oriented_values(oriented, max_distance_m):
    """Attributes of a result in the order of `oriented_specs`; None where unknown.

    Parameters
    ----------
    oriented : OrientedPhoto
    max_distance_m : float
        Range that the run used [m].
    """
    answer, camera = oriented.orientation, oriented.camera
    pose = None if oriented.view is None else oriented.view.pose
    heading = None if pose is None else pose.heading_deg
    others = [float(wrap_360(candidate.pose.heading_deg)) for candidate in answer.candidates[1:3]]
    left, right = view_edges(heading, camera, oriented.convergence_deg)
    values = {
        "heading": heading,
        "pitch": None if pose is None else pose.pitch_deg,
        "roll": None if pose is None else pose.roll_deg,
        "hfov": None if camera is None else camera.hfov_deg,
        "vfov": None if camera is None else camera.vfov_deg,
        "ncc": answer.ncc,
        "ncc_2nd": answer.ncc_second,
        "heading_2": others[0] if others else None,
        "heading_3": others[1] if len(others) > 1 else None,
        "sharpness": answer.sharpness,
        "heading_lo": answer.heading_lo_deg,
        "heading_hi": answer.heading_hi_deg,
        "p_correct": answer.p_correct,
        "status": answer.status,
        "message": " ".join(map(in_users_language, [answer.message, *answer.notes])).strip(),
        "compass": oriented.compass_true_deg,
        "compass_df": compass_difference(oriented.compass_true_deg, heading),
        "grid_conv": oriented.convergence_deg,
        "horizon_m": horizon_distance_m(oriented.horizon, heading),
        "eye_z": oriented.eye_elevation_m,
        "observ_hgt": above_ground_m(oriented),
        "radius": None if oriented.longitude_deg is None else max_distance_m,
        "azim_1": left,
        "azim_2": right,
    }
    return [plain(values[spec.name]) for spec in oriented_specs()]


def view_edges(heading_deg, camera, convergence_deg):
    """Grid azimuths of the view's left and right edge, as Visibility Analysis reads them [degrees]."""
    if heading_deg is None or camera is None or convergence_deg is None:
        return None, None
    edges = heading_deg + np.array([-0.5, 0.5]) * camera.hfov_deg
    return tuple(float(edge) for edge in true_to_grid(edges, convergence_deg))


def compass_difference(compass_deg, heading_deg):
    """Recorded minus found heading, in [-180, 180) [degrees]."""
    if compass_deg is None or heading_deg is None:
        return None
    return float(difference(compass_deg, heading_deg))


def horizon_distance_m(horizon, heading_deg):
    """Distance of the horizon in the direction of the heading [m]."""
    if horizon is None or heading_deg is None:
        return None
    nearest = np.abs(difference(horizon.azimuth_deg, heading_deg)).argmin()
    return float(horizon.distance_m[nearest])


def above_ground_m(oriented):
    """Height of the eye above the DEM [m]."""
    if oriented.eye_elevation_m is None or oriented.ground_elevation_m is None:
        return None
    return oriented.eye_elevation_m - oriented.ground_elevation_m


def plain(value):
    """Give a Python value that QGIS stores; NaN and infinity become NULL."""
    if value is None or isinstance(value, str):
        return value
    value = float(value)
    return value if np.isfinite(value) else None
