"""The numbers that the report gives for a photograph: with units, unknown values as dashes, nothing invented."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from ..base.angles import difference, in_wedge, wrap_360
from ..base.overlay_lines import skyline_residuals_px
from ..base.status import STATUSES
from ..base.uncertainty import Z_90
from ..figures.text import azimuth, compass_point, decimals_of, degrees, is_known, plus_minus, with_unit


@dataclass(frozen=True)
class Summary:
    """One photograph's line in the overview; None if unknown.

    Attributes
    ----------
    name : str
        File name without its folder.
    status : str
    heading_deg, half_interval_deg, second_deg, compass_difference_deg, pitch_deg, roll_deg, hfov_deg : float or None
        Compass difference is recorded minus found, in [-180, 180) [degrees].
    p_correct : float or None
    residual_px, residual_deg : float or None
        Median of the absolute residuals.
    message : str
    """

    name: str
    status: str
    message: str
    heading_deg: float | None = None
    half_interval_deg: float | None = None
    p_correct: float | None = None
    second_deg: float | None = None
    compass_difference_deg: float | None = None
    pitch_deg: float | None = None
    roll_deg: float | None = None
    hfov_deg: float | None = None
    residual_px: float | None = None
    residual_deg: float | None = None


def file_name(path):
    """Name of a file without its folder, whichever operating system wrote the path."""
    return re.split(r"[\\/]", str(path).rstrip("\\/"))[-1] or str(path)


def status_of(photo):
    """Return the photo's status; an unknown one counts as failed, because it becomes a class name of the page."""
    status = photo.orientation.status
    return status if status in STATUSES else "failed"


def status_word(status, say=str):
    """Return the status in the reader's language; in attributes it stays English."""
    return {
        "accepted": say("accepted"),
        "confirmed": say("confirmed"),
        "ambiguous": say("ambiguous"),
        "rejected": say("rejected"),
        "failed": say("failed"),
    }[status]


def pixels_per_degree(photo):
    """Pixels of the full picture per degree in its middle, or None."""
    return None if photo.camera is None else photo.camera.focal_px * np.pi / 180


def summarise(photo):
    """Compute the overview's line of an `OrientedPhoto`."""
    orientation, best = photo.orientation, photo.orientation.best
    name, status = file_name(photo.path), status_of(photo)
    if best is None:
        return Summary(name, status, orientation.message)
    residual_px = _median_abs(skyline_residuals_px(photo))
    return Summary(
        name,
        status,
        orientation.message,
        heading_deg=float(wrap_360(best.pose.heading_deg)),
        half_interval_deg=half_interval_deg(orientation),
        p_correct=orientation.p_correct,
        second_deg=float(wrap_360(orientation.candidates[1].pose.heading_deg)) if orientation.candidates[1:] else None,
        compass_difference_deg=compass_difference_deg(photo),
        pitch_deg=best.pose.pitch_deg,
        roll_deg=best.pose.roll_deg,
        hfov_deg=best.camera.hfov_deg,
        residual_px=residual_px,
        residual_deg=None if residual_px is None else float(np.degrees(np.arctan(residual_px / best.camera.focal_px))),
    )


def half_interval_deg(orientation):
    """Half the width of the 90 % interval, or None [degrees]."""
    low, high = orientation.heading_lo_deg, orientation.heading_hi_deg
    return float(wrap_360(high - low)) / 2 if is_known(low) and is_known(high) else None


def compass_difference_deg(photo):
    """Recorded minus found heading, in [-180, 180), or None [degrees]."""
    best = photo.orientation.best
    if best is None or not is_known(photo.compass_true_deg):
        return None
    return float(difference(photo.compass_true_deg, best.pose.heading_deg))


def fact_groups(photo, extras=None, say=str):
    """Collect all numbers of a photograph.

    Parameters
    ----------
    photo : OrientedPhoto
    extras : mapping or None
        Further labels and values from the caller, shown first.
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    list of (title, list of (label, words))
        Plain text, not escaped; groups without any known value are left out.
    """
    groups = [
        (say("Other values"), [(str(label), str(value)) for label, value in (extras or {}).items()]),
        (say("Pose"), _pose(photo, say)),
        (say("Match"), _match(photo, say)),
        (say("Lens"), _lens(photo, say)),
        (say("Compass"), _compass(photo, say)),
        (say("Position and elevation"), _place(photo, say)),
        (say("DEM horizon"), _horizon(photo, say)),
        (say("File"), _file(photo, say)),
    ]
    return [(title, rows) for title, rows in groups if any(words != "–" for _, words in rows)]


def interval_words(orientation, say=str):
    """Write the 90 % interval of the heading, or ''."""
    half = half_interval_deg(orientation)
    if half is None:
        return ""
    ends = (orientation.heading_lo_deg, orientation.heading_hi_deg)
    low, high = (azimuth(at, decimals_of(half)) for at in ends)
    return say("{low} to {high}").format(low=low, high=high) + f" ({plus_minus(half)})"


def percent(share):
    """Write a probability or share as a percentage; never 100 for a value that is not certain."""
    if not is_known(share):
        return "–"
    if 0.999 < share < 1:
        return ">99.9 %"
    if 0 < share < 0.001:
        return "<0.1 %"
    return f"{100 * share:.{0 if 0.1 <= share <= 0.9 or share in (0, 1) else 1}f} %"


def _pose(photo, say):
    orientation, best = photo.orientation, photo.orientation.best
    if best is None:
        return []
    heading = best.pose.heading_deg
    rows = [
        (say("Heading, true"), f"{azimuth(heading, 2)} {compass_point(wrap_360(heading), say)}"),
        (say("90 % interval"), interval_words(orientation, say) or "–"),
    ]
    for name, label in (("pitch_deg", say("Pitch, + up")), ("roll_deg", say("Roll, + right side down"))):
        rows.append((label, degrees(getattr(best.pose, name), 2, signed=True) + _margin(orientation, name)))
    for rank, other in enumerate(orientation.candidates[1:3], 2):
        chance = f" ({percent(other.probability)})" if other.probability is not None else ""
        rows.append((say("Alternative {rank}").format(rank=rank), f"{azimuth(other.pose.heading_deg, 2)}{chance}"))
    return rows


def _margin(orientation, name):
    """Write half the 90 % interval of an angle, or ''."""
    spread = orientation.uncertainty
    return "" if spread is None else f" (±{Z_90 * getattr(spread, name):.1f}°)"


def _match(photo, say):
    orientation = photo.orientation
    rows = [
        (say("Within 3° of the truth"), percent(orientation.p_correct)),
        (say("Score"), "–" if orientation.best is None else f"{orientation.best.score:.3f}"),
        (say("Score of alternative 2"), next((f"{one.score:.3f}" for one in orientation.candidates[1:2]), "–")),
        (say("NCC"), with_unit(orientation.ncc, "", 3)),
        (say("NCC of the second peak"), with_unit(orientation.ncc_second, "", 3)),
        (say("Sharpness of the peak"), with_unit(orientation.sharpness, "", 2)),
    ]
    residual, scale = skyline_residuals_px(photo), pixels_per_degree(photo)
    median = _median_abs(residual)
    if median is not None:
        angle = degrees(median / scale, 2) if scale else "–"
        rows.append((say("Residual, median"), f"{with_unit(median, 'px', 1)}, {angle}"))
        rows.append((say("Columns compared"), percent(float(np.isfinite(np.asarray(residual, float)).mean()))))
    return rows


def _lens(photo, say):
    if photo.camera is None:
        return []
    camera, recorded = photo.camera, photo.metadata.focal_length_35mm if photo.metadata else None
    diagonal = np.hypot(camera.width_px, camera.height_px)
    rows = [
        (say("Horizontal field of view"), degrees(camera.hfov_deg, 2)),
        (say("Vertical field of view"), degrees(camera.vfov_deg, 2)),
        (say("Focal length"), with_unit(camera.focal_px, "px", 0)),
        (say("35 mm equivalent, used"), with_unit(camera.focal_px / diagonal * np.hypot(36, 24), "mm", 1)),
        (say("35 mm equivalent, EXIF"), with_unit(recorded, "mm", 1)),
    ]
    if camera.k1 or camera.k2:
        rows.append((say("Distortion k1, k2"), f"{camera.k1:.4f}, {camera.k2:.4f}"))
    return rows


def _compass(photo, say):
    metadata = photo.metadata
    recorded, code = (metadata.compass_heading_deg, metadata.compass_reference) if metadata else (None, None)
    reference = {"T": say("from true north"), "M": say("from magnetic north")}.get(code, say("reference unknown"))
    rows = [
        (say("Recorded"), f"{azimuth(recorded)} ({reference})" if is_known(recorded) else "–"),
        (say("Converted to true north"), azimuth(photo.compass_true_deg)),
        (say("Recorded minus found"), degrees(compass_difference_deg(photo), 1, signed=True)),
    ]
    gimbal = (metadata.gimbal_pitch_deg, metadata.gimbal_roll_deg) if metadata else (None, None)
    labels = say("Pitch of the gimbal, + up"), say("Roll of the gimbal, + right side down")
    drone = gimbal != (None, None)  # others have no such rows
    return rows + [(label, degrees(angle, 1, signed=True)) for label, angle in zip(labels, gimbal) if drone]


def _place(photo, say):
    metadata = photo.metadata
    eye, ground = photo.eye_elevation_m, photo.ground_elevation_m
    known = is_known(eye) and is_known(ground)
    altitude = metadata.altitude_m if metadata else None
    reference = metadata.altitude_reference if metadata else None
    reference = f" ({_height_reference(reference, say)})" if reference else ""
    return [
        (say("Latitude"), degrees(photo.latitude_deg, 6)),
        (say("Longitude"), degrees(photo.longitude_deg, 6)),
        (say("Position error, EXIF"), with_unit(metadata.position_error_m if metadata else None, "m", 1)),
        (say("Eye elevation, used"), with_unit(eye, "m", 1)),
        (say("DEM under the eye"), with_unit(ground, "m", 1)),
        (say("Eye above the DEM"), with_unit(eye - ground if known else None, "m", 1, signed=True)),
        (say("Altitude, EXIF"), with_unit(altitude, "m", 1) + (reference if is_known(altitude) else "")),
    ]


def _height_reference(reference, say):
    known = {"sea level": say("sea level"), "below sea level": say("below sea level"), "ellipsoid": say("ellipsoid")}
    return known.get(reference, reference)


def _horizon(photo, say):
    horizon, best = photo.horizon, photo.orientation.best
    if horizon is None:
        return []
    rows = []
    if best is not None:
        inside = in_wedge(horizon.azimuth_deg, best.pose.heading_deg, best.camera.hfov_deg)
        distances = np.asarray(horizon.distance_m, float)[inside]
        distances = distances[np.isfinite(distances)] / 1000
        rows = [
            (say("Distance in view, median"), with_unit(np.median(distances) if len(distances) else None, "km", 1)),
            (say("Distance in view, farthest"), with_unit(distances.max() if len(distances) else None, "km", 1)),
            (say("Cut by the DEM's edge in view"), percent(float(np.mean(np.asarray(horizon.clipped)[inside])))),
        ]
    return [
        *rows,
        (say("Cell size"), with_unit(horizon.cell_m, "m", 1)),
        (say("Grid north from true north"), degrees(photo.convergence_deg, 2, signed=True)),
    ]


def _file(photo, say):
    metadata = photo.metadata
    rows = [(say("Path"), str(photo.path))]
    if metadata is None:
        return rows
    taken = metadata.taken_at.strftime("%Y-%m-%d %H:%M:%S") if metadata.taken_at else "–"
    size = f"{metadata.width_px} × {metadata.height_px} px"
    return [
        *rows,
        (say("Size, upright"), size),
        (say("Camera"), metadata.camera or "–"),
        (say("Taken, camera's time"), taken),
    ]


def _median_abs(residual_px):
    residual = np.zeros(0) if residual_px is None else np.asarray(residual_px, float).ravel()
    residual = residual[np.isfinite(residual)]
    return float(np.median(np.abs(residual))) if len(residual) else None
