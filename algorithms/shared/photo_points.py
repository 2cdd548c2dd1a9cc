"""Conversion of a layer's points to posed photographs, by field values; this is the only place that does so."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import log
from pathlib import Path
from typing import Any

from qgis.core import QgsFeature

from ...core.base.camera import Camera, Pose, focal_of_fov_px, folds
from ...core.base.posed import PosedPhoto
from ...core.base.terrain import Observer
from ...core.base.uncertainty import PoseUncertainty
from .fields import number_or_none

NOMINAL_WIDTH_PX = 4000
"""Width assumed for a picture of which only the fields of view are known; fine enough to place edges within a cell."""

POSE_FIELDS = {
    "HEADING_FIELD": "heading",
    "PITCH_FIELD": "pitch",
    "ROLL_FIELD": "roll",
    "HFOV_FIELD": "hfov",
    "VFOV_FIELD": "vfov",
    "HEIGHT_FIELD": "eye_z",
}
"""Parameters, and the field that `orientphotos` writes for each."""

INTERVAL_FIELDS = {"HEADING_LO_FIELD": "heading_lo", "HEADING_HI_FIELD": "heading_hi"}
"""The same for the ends of the heading's 90 % interval."""

ACCURACY_FIELD = "h_acc"
"""Radius that contains the true position with probability 0.68, as importers write it [m]."""


DISTORTION_FIELDS = ("k1", "k2")
"""Fields of the lens's distortion, if the layer has them: no importer writes them, but people add them."""


@dataclass(frozen=True, eq=False)
class PhotoPoint:
    """A point of a layer and the photograph that it represents, as far as the point describes it.

    Attributes
    ----------
    feature : QgsFeature
    name : str
        Name used in messages and file names.
    path : str or None
        Path of the photograph.
    observer : Observer or None
        None without a usable position.
    heading_deg, hfov_deg, vfov_deg : float or None
        Values of the point; a heading wedge needs no more [degrees].
    posed : PosedPhoto or None
        None if position, pose or lens is not known.
    skyline_row_px : (width_px,) array or None
        The photograph's own skyline, above which no ground is claimed; see `PhotoFrame`.
    skyline_tolerance_deg : float
    """

    feature: QgsFeature
    name: str
    path: str | None
    observer: Observer | None
    heading_deg: float | None = None
    hfov_deg: float | None = None
    vfov_deg: float | None = None
    posed: PosedPhoto | None = None
    skyline_row_px: Any = None
    skyline_tolerance_deg: float = 0.0

    @property
    def source_id(self):
        """Identifier of the feature."""
        return self.feature.id()

    @property
    def key(self):
        """Key that distinguishes this point from all others of a run."""
        return self.source_id, self.path


@dataclass(frozen=True)
class PoseReading:
    """Substitutes for values that a point does not have.

    Attributes
    ----------
    eye_height_m : float
        Height above the DEM, for points without an elevation of the eye [m].
    uncertainty : PoseUncertainty
        Default uncertainty; a point's heading interval and position accuracy refine it.
    level : bool
        An unknown pitch is taken as 0, and an unknown vertical field of view as that of a 4 by 3 picture. Otherwise a
        point without them has no pose.
    """

    eye_height_m: float = 1.7
    uncertainty: PoseUncertainty = field(default_factory=PoseUncertainty)
    level: bool = False


def value_of(feature, name):
    """Finite number of a feature's field, or None if the field is missing or NULL."""
    if not name or feature.fields().lookupField(name) < 0:
        return None
    return number_or_none(feature[name])


def pose_values(feature, fields=POSE_FIELDS):
    """Numbers of a point, keyed by parameter, from the fields that the parameters name; see `photo_point`."""
    names = {**INTERVAL_FIELDS, **fields, ACCURACY_FIELD: ACCURACY_FIELD}
    return {key: value_of(feature, name) for key, name in names.items()}


def lens_of(feature):
    """Distortion of a point's lens from its fields k1 and k2; 0 where they are missing or NULL."""
    return {name: value_of(feature, name) or 0.0 for name in DISTORTION_FIELDS}


def photo_point(row, values, reading, path=None, size_px=None):
    """Read one point.

    Parameters
    ----------
    row : PointRow
    values : dict
        Number or None for each of `POSE_FIELDS`, and for those of `INTERVAL_FIELDS` and `ACCURACY_FIELD` that apply.
    reading : PoseReading
    path : str or None
        Path of the photograph.
    size_px : (width, height) or None
        Size of the upright picture, if known [pixels].

    Returns
    -------
    PhotoPoint
    """
    observer = None
    if row.longitude_deg is not None:
        observer = Observer(row.longitude_deg, row.latitude_deg, reading.eye_height_m, values["HEIGHT_FIELD"])
    heading, hfov, vfov = (values[key] for key in ("HEADING_FIELD", "HFOV_FIELD", "VFOV_FIELD"))
    pose, camera = _pose(values, reading), pinhole(hfov, vfov, size_px)
    if vfov is None and not reading.level:
        camera = None
    if camera is not None:
        camera = replace(camera, **lens_of(row.feature))
        camera = replace(camera, k1=0.0, k2=0.0) if folds(camera) else camera
    posed = None
    if observer is not None and pose is not None and camera is not None:
        usual = _of_intervals(row.feature, reading.uncertainty)
        posed = PosedPhoto(camera, pose, observer, _uncertainty(values, usual), path)
    return PhotoPoint(row.feature, row.name, path, observer, heading, hfov, vfov, posed)


def _pose(values, reading):
    heading, pitch = values["HEADING_FIELD"], values["PITCH_FIELD"]
    if heading is None or (pitch is None and not reading.level):
        return None
    return Pose(heading, pitch or 0.0, values["ROLL_FIELD"] or 0.0)


def _uncertainty(values, usual):
    low, high = (values.get(key) for key in INTERVAL_FIELDS)
    radius_m = values.get(ACCURACY_FIELD)
    if low is not None and high is not None:
        usual = usual.with_heading_interval(low, high)
    return usual.with_position_radius(radius_m) if radius_m is not None and radius_m > 0 else usual


def _of_intervals(feature, usual):
    """Uncertainty of pitch, roll and focal length from the intervals that `orientphotos` writes."""
    ends = {
        name: (value_of(feature, f"{name}_lo"), value_of(feature, f"{name}_hi")) for name in ("pitch", "roll", "hfov")
    }
    for name in ("pitch", "roll"):
        if None not in ends[name]:
            usual = usual.with_interval(f"{name}_deg", *ends[name])
    if all(map(is_field_of_view, ends["hfov"])):
        focal = [log(focal_of_fov_px(1.0, angle)) for angle in ends["hfov"]]
        usual = usual.with_interval("focal_relative", min(focal), max(focal))
    return usual


def pinhole(hfov_deg, vfov_deg=None, size_px=None):
    """Camera with these fields of view, or None if the horizontal one is unknown or impossible.

    Parameters
    ----------
    hfov_deg, vfov_deg : float or None
        [degrees].
    size_px : (width, height) or None
        Size of the picture; a height of None, or no size at all, follows from the vertical field of view [pixels].
    """
    if not is_field_of_view(hfov_deg):
        return None
    width, height = size_px or (NOMINAL_WIDTH_PX, None)
    width = max(round(width), 1)
    if height is None:
        known = is_field_of_view(vfov_deg)
        height = focal_of_fov_px(width, hfov_deg) / focal_of_fov_px(1.0, vfov_deg) if known else 0.75 * width
    return Camera(width, max(round(height), 1), focal_of_fov_px(width, hfov_deg))


def is_field_of_view(angle_deg):
    """Return whether an angle is known and possible for a picture."""
    return angle_deg is not None and 0 < angle_deg < 180


def oriented_point(row, oriented, usual):
    """Return the point of a photo that has just been oriented, with its whole camera.

    Parameters
    ----------
    row : PointRow
    oriented : OrientedPhoto
    usual : PoseUncertainty
        Uncertainty of what the orientation does not determine.
    """
    posed, camera = oriented.view, oriented.camera
    if posed is not None:
        uncertainty = replace(usual, heading_deg=posed.uncertainty.heading_deg)
        if oriented.orientation.uncertainty is not None:
            uncertainty = uncertainty.with_pose_of(oriented.orientation.uncertainty)
        posed = replace(posed, uncertainty=uncertainty)
    return PhotoPoint(
        row.feature,
        Path(oriented.path).name if oriented.path else row.name,
        oriented.path or None,
        None if posed is None else posed.observer,
        None if posed is None else posed.pose.heading_deg,
        None if camera is None else camera.hfov_deg,
        None if camera is None else camera.vfov_deg,
        posed,
    )
