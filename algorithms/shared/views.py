"""Oriented photo points as views on a DEM: the parameters, and the loop that opens one view after the other."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from qgis.core import QgsFeature

from ...core.base.camera import Camera, Pose, focal_of_fov_px
from ...core.base.errors import PhotoError
from ...core.base.messages import Message
from ...core.base.progress import checkpoint, subtask
from ...core.base.terrain import Observer
from ...core.base.uncertainty import PoseUncertainty
from ...core.base.view import open_view
from . import parameters as shared
from .feedback import FeedbackProgress, announce, warn
from .fields import number_or_none
from .i18n import tr
from .layers import PATH_FIELDS, read_points

NOMINAL_WIDTH_PX = 4000
"""Width of a picture of which only the fields of view are known."""

POSE_FIELDS = {
    "HEADING_FIELD": "heading",
    "PITCH_FIELD": "pitch",
    "ROLL_FIELD": "roll",
    "HFOV_FIELD": "hfov",
    "VFOV_FIELD": "vfov",
    "HEIGHT_FIELD": "eye_z",
}
"""Parameter and the field that `orientphotos` writes."""


@dataclass(frozen=True)
class PhotoView:
    """An oriented photograph that has been placed on the DEM.

    Attributes
    ----------
    feature : QgsFeature
        Its point.
    name : str
        For messages and file names.
    path : str or None
        Of the photograph.
    view : core.base.view.View
    observer : core.base.terrain.Observer
    terrain : core.base.terrain.Terrain
    sized : bool
        The picture's size is known, so that pixels mean something; else only its shape.
    progress : core.base.progress.Progress
        Share of the run that this photo has.
    """

    feature: QgsFeature
    name: str
    path: str | None
    view: Any
    observer: Any
    terrain: Any
    sized: bool
    progress: Any


def add_view_parameters(algorithm, max_distance_m=30_000.0, photo_needed=True):
    """Declare oriented points, DEM, range, and the pose's fields below 'Advanced'."""
    points = shared.photo_source()
    points.setDescription(tr("Oriented photo points"))
    points.setHelp(tr("From Orient photos, or any points with heading, pitch, roll and field of view."))
    algorithm.addParameter(points)
    field = shared.photo_field()
    algorithm.addParameter(field if photo_needed else shared.advanced(field))
    algorithm.addParameter(shared.dem())
    algorithm.addParameter(shared.band())
    algorithm.addParameter(shared.max_distance(max_distance_m))
    texts = {
        "HEADING_FIELD": (tr("Field with the heading (°)"), tr("True, clockwise from north.")),
        "PITCH_FIELD": (tr("Field with the pitch (°)"), tr("Up is positive. NULL: 0.")),
        "ROLL_FIELD": (tr("Field with the roll (°)"), tr("Right side down is positive. NULL: 0.")),
        "HFOV_FIELD": (tr("Field with the horizontal field of view (°)"), tr("Field of view of the upright picture.")),
        "VFOV_FIELD": (
            tr("Field with the vertical field of view (°)"),
            tr("Only used if the photograph itself is missing."),
        ),
        "HEIGHT_FIELD": (
            tr("Field with the camera's elevation (m)"),
            tr("Absolute, in the DEM's height system. NULL: DEM plus camera height."),
        ),
    }
    for name, default in POSE_FIELDS.items():
        algorithm.addParameter(shared.advanced(shared.number_field(name, *texts[name], default)))
    algorithm.addParameter(shared.advanced(shared.eye_height()))
    algorithm.addParameter(shared.advanced(shared.refraction(0.13)))


def add_uncertainty_parameters(algorithm):
    """Declare the standard deviations behind an error ellipse."""
    default = PoseUncertainty()
    percent = 100 * default.focal_relative
    for name, label, value, text in (
        ("HEADING_SIGMA", tr("Uncertainty of the heading (°)"), default.heading_deg,
         tr("Standard deviation, used if the points have no heading_lo and heading_hi.")),
        ("PITCH_SIGMA", tr("Uncertainty of the pitch (°)"), default.pitch_deg, tr("Standard deviation.")),
        ("ROLL_SIGMA", tr("Uncertainty of the roll (°)"), default.roll_deg, tr("Standard deviation.")),
        ("FOCAL_SIGMA", tr("Uncertainty of the focal length (%)"), percent, tr("Standard deviation.")),
        ("POSITION_SIGMA", tr("Uncertainty of the position (m)"), default.position_m,
         tr(
             "Standard deviation of the camera's position, in east and in north. A field h_acc takes precedence."
         )),
        ("EYE_SIGMA", tr("Uncertainty of the camera's elevation (m)"), default.eye_m, tr("Standard deviation.")),
        ("DEM_SIGMA", tr("Vertical error of the DEM (m)"), default.dem_m, tr("Standard deviation.")),
    ):  # fmt: skip
        algorithm.addParameter(shared.advanced(shared.number(name, label, value, text, 0.0)))


def uncertainty_of(algorithm, parameters, context, feature):
    """Uncertainty of one photograph: the parameters, bettered by what its point carries."""

    def number(name):
        return algorithm.parameterAsDouble(parameters, name, context)

    sigma = PoseUncertainty(
        number("HEADING_SIGMA"), number("PITCH_SIGMA"), number("ROLL_SIGMA"), number("FOCAL_SIGMA") / 100,
        number("POSITION_SIGMA"), number("EYE_SIGMA"), number("DEM_SIGMA"),
    )  # fmt: skip
    low, high, accuracy = (value_of(feature, name) for name in ("heading_lo", "heading_hi", "h_acc"))
    if low is not None and high is not None:
        sigma = sigma.with_heading_interval(low, high)
    if accuracy is not None and accuracy > 0:
        sigma = replace(sigma, position_m=accuracy / PER_AXIS)
    return sigma


PER_AXIS = 1.5096
"""A radius that holds 68 % of places is this many standard deviations of one coordinate (Rayleigh)."""


def value_of(feature, field):
    """Finite number of a feature's field, or None where the field is missing or NULL."""
    if not field or feature.fields().lookupField(field) < 0:
        return None
    return number_or_none(feature[field])


def open_views(algorithm, parameters, context, feedback, terrain, max_distance_m, share=(0.0, 1.0), pixels=True):
    """Yield a `PhotoView` for each oriented point; what lacks a heading or lies off the DEM is warned of.

    Parameters
    ----------
    terrain : core.io.raster.Dem
    max_distance_m : float
        Reach of the views [m].
    share : (float, float)
        Part of the progress bar.
    pixels : bool
        The run tells pixels, so that a picture of unknown size is worth a warning.
    """
    _, rows = read_points(algorithm, parameters, context, "INPUT", _path_field(algorithm, parameters, context))
    fields = {key: algorithm.parameterAsString(parameters, key, context) for key in POSE_FIELDS}
    eye_height_m = algorithm.parameterAsDouble(parameters, "EYE_HEIGHT", context)
    refraction = algorithm.parameterAsDouble(parameters, "REFRACTION", context)
    progress = subtask(FeedbackProgress(feedback), *share)
    for index, row in enumerate(rows):
        announce(feedback, row.name, index, len(rows))
        part = subtask(progress, index / len(rows), (index + 1) / len(rows))
        values = {key: value_of(row.feature, field) for key, field in fields.items()}
        try:
            camera, sized = _camera(row.path, row.feature, values)
            observer = _observer(row, values, eye_height_m)
            view = open_view(terrain, observer, camera, _pose(values), max_distance_m, refraction)
        except PhotoError as error:
            warn(feedback, row.name, error.message)
            continue
        checkpoint(part, 0.0)
        if pixels and not sized:
            text = Message("The picture's size is unknown, so a width of 4000 px is assumed.")
            warn(feedback, row.name, text)
        yield PhotoView(row.feature, row.name, row.path, view, observer, terrain, sized, part)
        checkpoint(part, 1.0)


def _path_field(algorithm, parameters, context):
    """PHOTO_FIELD, or None where the layer has no such field and the user has not asked for another."""
    source = algorithm.parameterAsSource(parameters, "INPUT", context)
    chosen = algorithm.parameterAsString(parameters, "PHOTO_FIELD", context)
    names = [] if source is None else [field.name().lower() for field in source.fields()]
    if chosen in ("", "photo") and not set(PATH_FIELDS) & set(names):
        return None
    return "PHOTO_FIELD"


def _observer(row, values, eye_height_m):
    if row.longitude_deg is None:
        raise PhotoError(Message("The point has no usable position."))
    return Observer(row.longitude_deg, row.latitude_deg, eye_height_m, values["HEIGHT_FIELD"])


def _pose(values):
    if values["HEADING_FIELD"] is None:
        raise PhotoError(Message("The photo has no heading; orient it first."))
    return Pose(values["HEADING_FIELD"], values["PITCH_FIELD"] or 0.0, values["ROLL_FIELD"] or 0.0)


def _camera(path, feature, values):
    """Camera of the full picture, and whether its size is known."""
    from ...core.io.photo import read_metadata

    hfov, vfov = values["HFOV_FIELD"], values["VFOV_FIELD"]
    if hfov is None or not 0 < hfov < 180:
        raise PhotoError(
            Message("The photo has no horizontal field of view between 0 and 180 degrees; orient it first.")
        )
    size = tuple(value_of(feature, field) for field in ("width", "height"))
    sized = None not in size
    if path and Path(path).exists():
        metadata = read_metadata(path)
        size, sized = (metadata.width_px, metadata.height_px), True
    elif not sized:
        height = 2 * focal_of_fov_px(NOMINAL_WIDTH_PX, hfov) / (2 * focal_of_fov_px(1.0, vfov)) if vfov else None
        size = NOMINAL_WIDTH_PX, height or 0.75 * NOMINAL_WIDTH_PX
    width, height = max(round(size[0]), 1), max(round(size[1]), 1)
    return Camera(width, height, focal_of_fov_px(width, hfov)), sized


def sight_options(algorithm, parameters, context):
    """`SightOptions` of the core from the parameters of `add_view_parameters`."""
    from ...core.mapping.sightline import SightOptions

    return SightOptions(
        max_distance_m=algorithm.parameterAsDouble(parameters, "MAX_DISTANCE", context),
        refraction_coefficient=algorithm.parameterAsDouble(parameters, "REFRACTION", context),
    )
