"""Oriented photo points as views on a DEM: the parameters, and the loop that opens one view after another."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from qgis.core import QgsFeature

from ...core.base.errors import PhotoError
from ...core.base.messages import Message
from ...core.base.progress import checkpoint, subtask
from ...core.base.uncertainty import PoseUncertainty
from ...core.base.view import open_view
from . import parameters as shared
from .doubtful_places import warn_of_place
from .feedback import FeedbackProgress, announce, warn
from .i18n import tr
from .layers import PATH_FIELDS, read_points
from .photo_points import POSE_FIELDS, PoseReading, is_field_of_view, photo_point, pose_values, value_of
from .statuses import relied_on


@dataclass(frozen=True)
class Opening:
    """Settings for opening the views of a run.

    Attributes
    ----------
    max_distance_m : float
        Range of the views [m].
    share : (float, float)
        Part of the progress bar.
    pixels : bool
        The run outputs pixels, so that a picture of unknown size deserves a warning.
    uncertainty : PoseUncertainty
        Uncertainty of a photograph whose point does not state it.
    """

    max_distance_m: float
    share: tuple = (0.0, 1.0)
    pixels: bool = True
    uncertainty: PoseUncertainty = field(default_factory=PoseUncertainty)


@dataclass(frozen=True, eq=False)
class OpenedPhoto:
    """A posed photograph of a layer that has been opened on the DEM.

    Attributes
    ----------
    feature : QgsFeature
        Point of the photograph.
    name : str
        Name used in messages and file names.
    path : str or None
        Path of the photograph.
    view : core.base.view.View
    terrain : core.base.terrain.Terrain
    sized : bool
        The picture's size is known, so that pixels are meaningful; otherwise only its shape is known.
    progress : core.base.progress.Progress
        This photo's share of the run.
    """

    feature: QgsFeature
    name: str
    path: str | None
    view: Any
    terrain: Any
    sized: bool
    progress: Any


def add_view_parameters(algorithm, max_distance_m=30_000.0, photo_needed=True):
    """Declare oriented points, DEM, range, and the fields of the pose under 'Advanced'."""
    points = shared.photo_source()
    points.setDescription(tr("Oriented photo points"))
    points.setHelp(tr("From Orient photos, or any points with heading, pitch, roll and field of view."))
    algorithm.addParameter(points)
    photo = shared.photo_field()
    algorithm.addParameter(photo if photo_needed else shared.advanced(photo))
    algorithm.addParameter(shared.dem())
    algorithm.addParameter(shared.band())
    algorithm.addParameter(shared.dem_unit())
    algorithm.addParameter(shared.max_distance(max_distance_m))
    algorithm.addParameter(shared.statuses())
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
        ("PITCH_SIGMA", tr("Uncertainty of the pitch (°)"), default.pitch_deg,
         tr("Standard deviation, used if the points have no pitch_lo and pitch_hi.")),
        ("ROLL_SIGMA", tr("Uncertainty of the roll (°)"), default.roll_deg,
         tr("Standard deviation, used if the points have no roll_lo and roll_hi.")),
        ("FOCAL_SIGMA", tr("Uncertainty of the focal length (%)"), percent,
         tr("Standard deviation, used if the points have no hfov_lo and hfov_hi.")),
        ("POSITION_SIGMA", tr("Uncertainty of the position (m)"), default.position_m,
         tr(
             "Standard deviation of the camera's position, in east and in north. A field h_acc takes precedence."
         )),
        ("EYE_SIGMA", tr("Uncertainty of the camera's elevation (m)"), default.eye_m, tr("Standard deviation.")),
        ("DEM_SIGMA", tr("Vertical error of the DEM (m)"), default.dem_m, tr("Standard deviation.")),
    ):  # fmt: skip
        most = 30.0 if name == "FOCAL_SIGMA" else None
        algorithm.addParameter(shared.advanced(shared.number(name, label, value, text, 0.0, most)))


def uncertainty_of(algorithm, parameters, context):
    """Read the parameters of `add_uncertainty_parameters`; values of the points refine them."""

    def number(name):
        return algorithm.parameterAsDouble(parameters, name, context)

    return PoseUncertainty(
        number("HEADING_SIGMA"), number("PITCH_SIGMA"), number("ROLL_SIGMA"), number("FOCAL_SIGMA") / 100,
        number("POSITION_SIGMA"), number("EYE_SIGMA"), number("DEM_SIGMA"),
    )  # fmt: skip


def open_views(algorithm, parameters, context, feedback, terrain, opening):
    """Yield an `OpenedPhoto` for each point of a chosen status; those without a heading or off the DEM get a warning.

    Parameters
    ----------
    algorithm, parameters, context, feedback
        As in `processAlgorithm`.
    terrain : core.io.raster.Dem
    opening : Opening
    """
    _, rows = read_points(algorithm, parameters, context, "INPUT", _path_field(algorithm, parameters, context))
    rows = relied_on(algorithm, parameters, context, feedback, rows)
    fields = {key: algorithm.parameterAsString(parameters, key, context) for key in POSE_FIELDS}
    eye_height_m = algorithm.parameterAsDouble(parameters, "EYE_HEIGHT", context)
    reading = PoseReading(eye_height_m, opening.uncertainty, level=True)
    refraction = algorithm.parameterAsDouble(parameters, "REFRACTION", context)
    progress = subtask(FeedbackProgress(feedback), *opening.share)
    for index, row in enumerate(rows):
        announce(feedback, row.name, index, len(rows))
        part = subtask(progress, index / len(rows), (index + 1) / len(rows))
        try:
            size_px = _size_px(row)
            point = photo_point(row, pose_values(row.feature, fields), reading, row.path, size_px)
            if point.posed is None:
                raise PhotoError(_lack(point))
            warn_of_place(feedback, point, terrain, point.observer)
            view = open_view(terrain, point.posed, opening.max_distance_m, refraction)
        except PhotoError as error:
            warn(feedback, row.name, error.message)
            continue
        checkpoint(part, 0.0)
        if opening.pixels and size_px is None:
            text = Message("The picture's size is unknown, so a width of 4000 px is assumed.")
            warn(feedback, row.name, text)
        yield OpenedPhoto(row.feature, row.name, row.path, view, terrain, size_px is not None, part)
        checkpoint(part, 1.0)


def photo_names(algorithm, parameters, context):
    """Path, or else name, of every photo of the points, also of those that `open_views` leaves out."""
    _, rows = read_points(algorithm, parameters, context, "INPUT", _path_field(algorithm, parameters, context))
    return [row.path or row.name for row in rows]


def _path_field(algorithm, parameters, context):
    """PHOTO_FIELD, or None if the layer has no such field and the user has not asked for another."""
    source = algorithm.parameterAsSource(parameters, "INPUT", context)
    chosen = algorithm.parameterAsString(parameters, "PHOTO_FIELD", context)
    names = [] if source is None else [column.name().lower() for column in source.fields()]
    if chosen in ("", "photo") and not set(PATH_FIELDS) & set(names):
        return None
    return "PHOTO_FIELD"


def _lack(point):
    """Message on why a point has no pose."""
    if not is_field_of_view(point.hfov_deg):
        return Message("The photo has no horizontal field of view between 0 and 180 degrees; orient it first.")
    if point.observer is None:
        return Message("The point has no usable position.")
    return Message("The photo has no heading; orient it first.")


def _size_px(row):
    """Size of the upright picture according to its file or its point's fields, or None [pixels]."""
    from ...core.io.photo import read_metadata

    if row.path and Path(row.path).exists():
        metadata = read_metadata(row.path)
        return metadata.width_px, metadata.height_px
    size = tuple(value_of(row.feature, name) for name in ("width", "height"))
    return None if None in size else size


def sight_options(algorithm, parameters, context):
    """`SightOptions` of the core from the parameters of `add_view_parameters`."""
    from ...core.mapping.sightline import SightOptions

    return SightOptions(
        max_distance_m=algorithm.parameterAsDouble(parameters, "MAX_DISTANCE", context),
        refraction_coefficient=algorithm.parameterAsDouble(parameters, "REFRACTION", context),
    )
