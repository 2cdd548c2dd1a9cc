"""Attribute table of a photograph's point: names, kinds and meanings of the fields, and their values.

QGIS layers and the files of the command line share these definitions. Names are a contract and have at most 10
characters.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Callable, Union

import numpy as np

from .angles import difference, true_to_grid, wrap_360
from .camera import Camera, focal_from_35mm_px, fov_of_focal_deg
from .model import HorizonProfile, OrientedPhoto, PhotoMetadata
from .uncertainty import Z_90

Value = Union[str, int, float, datetime, None]
ROTATION_OF_ORIENTATION = {1: 0, 2: 0, 3: 180, 4: 180, 5: 90, 6: 90, 7: 270, 8: 270}
"""Clockwise rotation that makes the stored picture upright, by EXIF Orientation [degrees]."""


@dataclass(frozen=True)
class FieldSpec:
    """Name, kind ('text', 'real', 'whole', 'yes', 'time') and alias of an attribute."""

    name: str
    kind: str
    alias: str


def photo_fields(say: Callable[[str], str] = str) -> list[FieldSpec]:
    """Fields of a photograph's own metadata: the nine of QGIS's Import geotagged photos, then those added here.

    `say` translates the aliases.
    """
    return [
        FieldSpec("photo", "text", say("Photo")),
        FieldSpec("filename", "text", say("Name")),
        FieldSpec("directory", "text", say("Folder")),
        FieldSpec("altitude", "real", say("GPS altitude (m)")),
        FieldSpec("direction", "real", say("Recorded heading (°)")),
        FieldSpec("rotation", "whole", say("Rotation by EXIF (°)")),
        FieldSpec("longitude", "text", say("Longitude (°)")),
        FieldSpec("latitude", "text", say("Latitude (°)")),
        FieldSpec("timestamp", "time", say("Taken at (camera's local time)")),
        FieldSpec("f35", "real", say("35 mm equivalent focal length (mm)")),
        FieldSpec("hfov", "real", say("Horizontal field of view (°)")),
        FieldSpec("vfov", "real", say("Vertical field of view (°)")),
        FieldSpec("width", "whole", say("Width of the upright picture (px)")),
        FieldSpec("height", "whole", say("Height of the upright picture (px)")),
        FieldSpec("dir_ref", "text", say("Recorded heading counts from (T true, M magnetic north)")),
        FieldSpec("h_acc", "real", say("GPS horizontal error (m)")),
        FieldSpec("camera", "text", say("Camera")),
    ]


def photo_values(metadata: PhotoMetadata) -> dict[str, Value]:
    """Give the values of `photo_fields` by name; None if unknown."""
    path = Path(metadata.path)
    camera = None
    if metadata.focal_length_35mm:
        size = metadata.width_px, metadata.height_px
        camera = Camera(*size, focal_from_35mm_px(*size, metadata.focal_length_35mm))
    return {
        "photo": str(path),
        "filename": path.stem,
        "directory": str(path.parent),
        "altitude": metadata.altitude_m,
        "direction": metadata.compass_heading_deg,
        "rotation": ROTATION_OF_ORIENTATION.get(metadata.orientation),
        "longitude": _text(metadata.longitude_deg),
        "latitude": _text(metadata.latitude_deg),
        "timestamp": metadata.taken_at,
        "f35": metadata.focal_length_35mm,
        "hfov": None if camera is None else camera.hfov_deg,
        "vfov": None if camera is None else camera.vfov_deg,
        "width": metadata.width_px,
        "height": metadata.height_px,
        "dir_ref": metadata.compass_reference,
        "h_acc": metadata.position_error_m,
        "camera": metadata.camera,
    }


def has_position(metadata: PhotoMetadata) -> bool:
    """Tell whether the file gives a position; cameras without one write 0/0."""
    if metadata.latitude_deg is None or metadata.longitude_deg is None:
        return False
    return not (metadata.latitude_deg == 0 and metadata.longitude_deg == 0)


def oriented_fields(say: Callable[[str], str] = str) -> list[FieldSpec]:
    """Fields that orientation adds, in their order; `say` translates the aliases."""
    return [
        FieldSpec("heading", "real", say("Heading (° from true north)")),
        FieldSpec("pitch", "real", say("Pitch (°, + up)")),
        FieldSpec("roll", "real", say("Roll (°, + right side down)")),
        FieldSpec("hfov", "real", say("Horizontal field of view (°)")),
        FieldSpec("vfov", "real", say("Vertical field of view (°)")),
        FieldSpec("ncc", "real", say("Correlation of skylines")),
        FieldSpec("ncc_2nd", "real", say("Correlation of the second-best heading")),
        FieldSpec("heading_2", "real", say("Second-best heading (°)")),
        FieldSpec("heading_3", "real", say("Third-best heading (°)")),
        FieldSpec("sharpness", "real", say("Sharpness of the correlation peak")),
        FieldSpec("heading_lo", "real", say("Heading, lower end of the 90 % interval (°)")),
        FieldSpec("heading_hi", "real", say("Heading, upper end of the 90 % interval (°)")),
        FieldSpec("pitch_lo", "real", say("Pitch, lower end of the 90 % interval (°)")),
        FieldSpec("pitch_hi", "real", say("Pitch, upper end of the 90 % interval (°)")),
        FieldSpec("roll_lo", "real", say("Roll, lower end of the 90 % interval (°)")),
        FieldSpec("roll_hi", "real", say("Roll, upper end of the 90 % interval (°)")),
        FieldSpec("hfov_lo", "real", say("Horizontal field of view, lower end of the 90 % interval (°)")),
        FieldSpec("hfov_hi", "real", say("Horizontal field of view, upper end of the 90 % interval (°)")),
        FieldSpec("p_correct", "real", say("Probability that the heading is right within 3°")),
        FieldSpec("status", "text", say("Status")),
        FieldSpec("message", "text", say("Message")),
        FieldSpec("compass", "real", say("Recorded heading (° from true north)")),
        FieldSpec("compass_df", "real", say("Recorded minus found heading (°)")),
        FieldSpec("grid_conv", "real", say("Grid convergence of the DEM (°)")),
        FieldSpec("horizon_m", "real", say("Distance of the horizon at the heading (m)")),
        FieldSpec("eye_z", "real", say("Elevation of the camera (m)")),
        FieldSpec("observ_hgt", "real", say("Camera above the DEM (m), for Visibility Analysis")),
        FieldSpec("radius", "real", say("Search range (m), for Visibility Analysis")),
        FieldSpec("azim_1", "real", say("Left edge of view (° from grid north), for Visibility Analysis")),
        FieldSpec("azim_2", "real", say("Right edge of view (° from grid north), for Visibility Analysis")),
    ]


def oriented_values(oriented: OrientedPhoto, max_distance_m: float) -> dict[str, Value]:
    """Give the values of `oriented_fields` by name; None if unknown.

    `max_distance_m` is the search range of the run [m].
    """
    answer, camera = oriented.orientation, oriented.camera
    pose = None if answer.best is None else answer.best.pose
    heading = None if pose is None else float(wrap_360(pose.heading_deg))
    others = [float(wrap_360(candidate.pose.heading_deg)) for candidate in answer.candidates[1:3]]
    left, right = _view_edges(heading, camera, oriented.convergence_deg)
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
        "message": " ".join([answer.message, *answer.notes]).strip(),
        "compass": oriented.compass_true_deg,
        "compass_df": _compass_difference(oriented.compass_true_deg, heading),
        "grid_conv": oriented.convergence_deg,
        "horizon_m": _horizon_distance_m(oriented.horizon, heading),
        "eye_z": oriented.eye_elevation_m,
        "observ_hgt": _above_ground_m(oriented),
        "radius": None if oriented.longitude_deg is None else max_distance_m,
        "azim_1": left,
        "azim_2": right,
    }
    values.update(_intervals(oriented))
    return {spec.name: _plain(values[spec.name]) for spec in oriented_fields()}


def _intervals(oriented: OrientedPhoto) -> dict[str, float | None]:
    """Give the ends of the 90 % intervals of pitch, roll and field of view [degrees]; None if unknown."""
    best, spread = oriented.orientation.best, oriented.orientation.uncertainty
    names = [f"{name}_{end}" for name in ("pitch", "roll", "hfov") for end in ("lo", "hi")]
    if best is None or spread is None:
        return dict.fromkeys(names)
    pitch, roll = Z_90 * spread.pitch_deg, Z_90 * spread.roll_deg
    wider = float(np.exp(Z_90 * spread.focal_relative))
    width, focal = best.camera.width_px, best.camera.focal_px
    ends = [best.pose.pitch_deg - pitch, best.pose.pitch_deg + pitch, best.pose.roll_deg - roll]
    ends += [best.pose.roll_deg + roll, fov_of_focal_deg(width, focal * wider), fov_of_focal_deg(width, focal / wider)]
    return dict(zip(names, ends))


def _text(angle_deg: float | None) -> str | None:
    """Give the shortest text that reads back as the same number."""
    return None if angle_deg is None else repr(float(angle_deg))


def _view_edges(
    heading_deg: float | None, camera: Camera | None, convergence_deg: float | None
) -> tuple[float | None, float | None]:
    """Give the grid azimuths of the view's left and right edge, as Visibility Analysis reads them [degrees]."""
    if heading_deg is None or camera is None or convergence_deg is None:
        return None, None
    left, right = true_to_grid(heading_deg + np.array([-0.5, 0.5]) * camera.hfov_deg, convergence_deg)
    return float(left), float(right)


def _compass_difference(compass_deg: float | None, heading_deg: float | None) -> float | None:
    """Give the recorded minus the found heading, in [-180, 180) [degrees]."""
    if compass_deg is None or heading_deg is None:
        return None
    return float(difference(compass_deg, heading_deg))


def _horizon_distance_m(horizon: HorizonProfile | None, heading_deg: float | None) -> float | None:
    """Give the distance of the horizon in the direction of the heading [m]."""
    if horizon is None or heading_deg is None:
        return None
    nearest = np.abs(difference(horizon.azimuth_deg, heading_deg)).argmin()
    return float(horizon.distance_m[nearest])


def _above_ground_m(oriented: OrientedPhoto) -> float | None:
    """Give the height of the eye above the DEM [m]."""
    if oriented.eye_elevation_m is None or oriented.ground_elevation_m is None:
        return None
    return oriented.eye_elevation_m - oriented.ground_elevation_m


def _plain(value: Value) -> Value:
    """Convert to a Python value that tables can store; NaN and infinity become None."""
    if value is None or isinstance(value, str):
        return value
    number = float(value)  # type: ignore[arg-type]
    return number if np.isfinite(number) else None
