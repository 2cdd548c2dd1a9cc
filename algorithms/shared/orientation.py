"""Orientation of the photographs of a layer: parameters, requests, and the loop, shared by two algorithms."""

from __future__ import annotations

import traceback
from functools import partial
from pathlib import Path

from qgis.core import QgsProcessingParameterBoolean, QgsProcessingParameterNumber

from ...core.base.errors import Cancelled, OutputError, TerrainError
from ...core.base.messages import Message
from ...core.base.progress import checkpoint, subtask
from ...core.horizon.horizon import HorizonOptions
from . import parameters as shared
from .compass_sample import compass_tested
from .feedback import FeedbackProgress
from .fields import is_null, joined_fields, number_or_none
from .i18n import in_users_language, marked, tr
from .kept_orientations import KeptOrientations
from .oriented import oriented_specs, oriented_values
from .photo_points import lens_of
from .rescue import Rescue
from .run_log import RunLog
from .together import are_together, oriented_together
from .workers import team_for

NUMBER_FIELDS = ("HFOV_FIELD", "HEIGHT_FIELD", "HEADING_HINT_FIELD", "TOLERANCE_FIELD", "POSITION_ERROR_FIELD")
LENS_FIELDS = ("hfov", "vfov")
DEFAULT_TOLERANCE_DEG = 20.0


def add_field_parameters(algorithm):
    """Declare the fields that may replace values of the file or the DEM."""
    algorithm.addParameter(
        shared.advanced(
            shared.number_field(
                "HFOV_FIELD",
                tr("Field with the horizontal field of view (°)"),
                tr(
                    "Field of view of the upright picture, across its middle. NULL: computed from the focal "
                    "length in the file. Fields named k1 and k2 give the distortion of the lens (Brown, as in OpenCV)."
                ),
            )
        )
    )
    algorithm.addParameter(
        shared.advanced(
            shared.number_field(
                "HEIGHT_FIELD",
                tr("Field with the camera's elevation (m)"),
                tr("Absolute elevation of the camera in the DEM's height system. NULL: DEM plus camera height."),
            )
        )
    )
    algorithm.addParameter(
        shared.advanced(
            shared.number_field(
                "POSITION_ERROR_FIELD",
                tr("Field with the error of the position (m)"),
                tr(
                    "Standard deviation, as Position photos from a track writes it. NULL: a few metres, as GPS has "
                    "in the open."
                ),
                "pos_err",
            )
        )
    )


def add_terrain_parameters(algorithm):
    """Declare camera height, range and refraction."""
    defaults = HorizonOptions()
    for parameter in (
        shared.eye_height(),
        shared.max_distance(defaults.max_distance_m, shared.horizon_distance_text()),
        shared.refraction(defaults.refraction_coefficient),
    ):
        algorithm.addParameter(shared.advanced(parameter))


def add_lens_parameter(algorithm):
    """Declare one field of view for all photographs."""
    parameter = QgsProcessingParameterNumber(
        "HFOV", tr("Horizontal field of view of all photos (°)"), QgsProcessingParameterNumber.Type.Double, None, True,
        0.1, 179.0,
    )  # fmt: skip
    text = tr(
        "For photographs of one lens without a focal length in their files, across the middle of the upright picture. "
        "A value in the field takes precedence."
    )
    algorithm.addParameter(shared.advanced(shared.explained(parameter, text)))


def add_altitude_parameter(algorithm):
    """Declare whether the recorded altitude is used."""
    parameter = QgsProcessingParameterBoolean("USE_ALTITUDE", tr("Camera at the recorded altitude"), False)
    text = tr(
        "For towers, cable cars and drones: uses the altitude in the file, if it counts from sea level, "
        "instead of the DEM plus camera height. A phone's altitude is often wrong by 10 to 50 m. The "
        "elevation in the field with the camera's elevation takes precedence."
    )
    algorithm.addParameter(shared.advanced(shared.explained(parameter, text)))


def oriented_out(name="OUTPUT"):
    """Layer of oriented photographs."""
    return shared.points_out(
        name,
        tr("Oriented photos"),
        text=tr(
            "One point per photograph with all fields of the source, then heading, pitch, roll, field of "
            "view, their uncertainty, status and message."
        ),
    )


def options_of(algorithm, parameters, context, horizon_distance="MAX_DISTANCE"):
    """Options of the core from the parameters; `horizon_distance` names the parameter with the search range."""
    from ...core.pipeline import OrientOptions

    horizon = HorizonOptions(
        max_distance_m=algorithm.parameterAsDouble(parameters, horizon_distance, context),
        refraction_coefficient=algorithm.parameterAsDouble(parameters, "REFRACTION", context),
    )
    return OrientOptions(
        method=shared.METHODS[algorithm.parameterAsEnum(parameters, "METHOD", context)],
        compass=shared.COMPASS_USES[algorithm.parameterAsEnum(parameters, "COMPASS", context)],
        horizon=horizon,
    )


def requests_of(algorithm, parameters, context, rows):
    """One `PhotoRequest` per row; None if the row names no photo."""
    rescue = Rescue(algorithm, parameters, context, [row.path for row in rows if row.path])
    eye_height_m = algorithm.parameterAsDouble(parameters, "EYE_HEIGHT", context)
    use_altitude = algorithm.parameterAsBoolean(parameters, "USE_ALTITUDE", context)
    hfov_deg = None
    if not is_null(parameters.get("HFOV")):
        hfov_deg = algorithm.parameterAsDouble(parameters, "HFOV", context)
    usual = {"eye_height_m": eye_height_m, "use_altitude": use_altitude, "hfov_deg": hfov_deg}
    return [None if row.path is None else request_of(row, rescue, usual) for row in rows]


def request_of(row, rescue, usual):
    """Collect the known data of one photo; `usual` holds what is the same for all, unless a field has a value."""
    from ...core.batch import PhotoRequest

    tolerance, hfov_deg = row.numbers.get("TOLERANCE_FIELD"), row.numbers.get("HFOV_FIELD")
    return PhotoRequest(
        row.path,
        longitude_deg=row.longitude_deg,
        latitude_deg=row.latitude_deg,
        eye_elevation_m=row.numbers.get("HEIGHT_FIELD"),
        **{**usual, **({} if hfov_deg is None else {"hfov_deg": hfov_deg})},
        **lens_of(row.feature),
        position_error_m=row.numbers.get("POSITION_ERROR_FIELD"),
        heading_deg=row.numbers.get("HEADING_HINT_FIELD"),
        heading_tolerance_deg=DEFAULT_TOLERANCE_DEG if tolerance is None else tolerance,
        **rescue.of(row.path),
    )


# parameters: the loop of two algorithms, which differ in all of them
def orient_each(
    requests, dem, options, feedback, folder="", share=(0.0, 1.0), part_of_photo=1.0, workers=1, joint=False
):
    """Orient one request after another, here or in worker processes, and yield each `OrientedPhoto` in order.

    `folder` is that of `KeptOrientations`, `share` is the loop's share of the progress bar, and `part_of_photo` is the
    orientation's part of each photo's share.

    A photo's fault becomes a status and a warning; cancelling reports how far the run came and raises `Cancelled`.
    """
    from ...core.batch import doubt_of_heights
    from ...core.many import OrientJob

    doubt = doubt_of_heights([request for request in requests if request is not None], dem)
    if doubt is not None:
        feedback.pushWarning(in_users_language(doubt))
    job, told = OrientJob(dem, options), RunLog(feedback, len(requests))
    job, known = compass_tested(requests, job, folder, feedback, workers)
    alone = partial(_oriented_alone, requests, job, KeptOrientations(folder, feedback, known), told)
    if are_together(joint, len(requests), options.method):
        orienting = share[0], share[0] + part_of_photo * (share[1] - share[0])
        yield from oriented_together(requests, job, alone, told, orienting, workers)
    else:
        yield from alone((*share, part_of_photo), workers)
    told.end()
    checkpoint(FeedbackProgress(feedback), share[1])


def _oriented_alone(requests, job, kept, told, share, workers):
    """Orient the photographs one by one; `share` ends with the orientation's part of each photo's share."""
    from ...core.many import station_of

    feedback, count, part_of_photo = told.feedback, len(requests), share[2]
    progress = subtask(FeedbackProgress(feedback), *share[:2])
    missing = [r for number, r in enumerate(requests) if r is not None and kept.is_missing(number, r, job)]
    with team_for(job, workers, len(missing), feedback) as team:
        team.begin([(request, None) for request in missing], progress, [station_of(request) for request in missing])
        for index, request in enumerate(requests):
            name = tr("A point without a photo") if request is None else Path(request.path).name
            told.start(name)
            part = subtask(progress, index / count, (index + part_of_photo) / count)
            try:
                oriented = without_photo() if request is None else kept.orient(index, request, team, part)
            except (TerrainError, OutputError):
                raise
            except Exception as error:  # a fault of ours, but no reason to lose the other photographs
                oriented = unforeseen(request, error, feedback)
            except Cancelled:
                feedback.pushWarning(tr("Cancelled after {done} of {count} photos.").format(done=index, count=count))
                raise
            told.answer(name, oriented.orientation)
            yield oriented


def unforeseen(request, error, feedback):
    """Make the result for a photo on which the program itself failed; the log gets the details."""
    from ...core.many import fallen

    feedback.pushDebugInfo(getattr(error, "details", "") or traceback.format_exc())
    return fallen(request.path, error)


def without_photo():
    """Make the result for a point whose path is NULL."""
    from ...core.base.model import Orientation, OrientedPhoto

    return OrientedPhoto("", Orientation("failed", Message("The point names no photo. Fill its path field.")))


def oriented_row(row, kept, oriented, max_distance_m, place=None):
    """Geometry and attributes of an output feature: those of the source, then ours.

    Parameters
    ----------
    row : PointRow
    kept : list of int
        See `oriented_fields`.
    oriented : OrientedPhoto
    max_distance_m : float
        Range that the run used [m].
    place : QgsGeometry or None
        As `Placing` gives it.
    """
    attributes = row.feature.attributes()
    ours = oriented_values(oriented, max_distance_m)
    for index, spec in enumerate(oriented_specs()):
        before = row.feature.fields().lookupField(spec.name)
        if spec.name in LENS_FIELDS and ours[index] is None and before >= 0:
            ours[index] = number_or_none(attributes[before])  # a photo that failed keeps the known data of its lens
    return place, [attributes[index] for index in kept] + ours


def oriented_fields(fields):
    """Fields of the output and the indices of the source's fields that are kept."""
    return joined_fields(fields, oriented_specs())


def summary(statuses):
    """Summarise the counts by status in a sentence."""
    from ...core.base.status import STATUSES
    from ...core.report.facts import status_word

    given = [status for status in STATUSES if status != "confirmed" or status in statuses]
    parts = [f"{statuses.count(status)} {status_word(status, marked)}" for status in given]
    return tr("{count} photos: {parts}.").format(count=len(statuses), parts=", ".join(parts))
