"""Viewsheds of oriented photographs: their parameters, and the sector of each photo."""

from __future__ import annotations

import math

from ...core.base.messages import Message
from . import parameters as shared
from .feedback import warn
from .i18n import tr
from .photo_points import is_field_of_view


def add_range_parameters(algorithm, eye_height=True):
    """Declare heights, range and refraction of the viewshed."""
    from ...core.viewshed.viewshed import ViewshedOptions

    defaults = ViewshedOptions()
    parameters = [shared.eye_height()] if eye_height else []
    parameters += [
        shared.distance(
            "TARGET_HEIGHT",
            tr("Target height above ground (m)"),
            defaults.target_height_m,
            tr("Height of the target; 0 means the ground itself."),
        ),
        shared.distance(
            "MIN_DISTANCE",
            tr("Minimum distance (m)"),
            defaults.min_distance_m,
            tr("Ground nearer than this does not count as seen, but it still hides the terrain behind it."),
        ),
    ]
    for parameter in parameters:
        algorithm.addParameter(shared.advanced(parameter))


def viewshed_options(algorithm, parameters, context, max_distance="MAX_DISTANCE"):
    """Options of the core from the parameters."""
    from ...core.viewshed.viewshed import ViewshedOptions

    return ViewshedOptions(
        target_height_m=algorithm.parameterAsDouble(parameters, "TARGET_HEIGHT", context),
        min_distance_m=algorithm.parameterAsDouble(parameters, "MIN_DISTANCE", context),
        max_distance_m=algorithm.parameterAsDouble(parameters, max_distance, context),
        refraction_coefficient=algorithm.parameterAsDouble(parameters, "REFRACTION", context),
    )


def range_fault(algorithm, parameters, context, max_distance="MAX_DISTANCE"):
    """Sentence on distances that exclude all ground, or None."""
    nearest = algorithm.parameterAsDouble(parameters, "MIN_DISTANCE", context)
    if nearest >= algorithm.parameterAsDouble(parameters, max_distance, context):
        return tr("The minimum distance must be smaller than the maximum distance.")
    return None


def sector_of(point, kind, feedback):
    """Sector of the view of a `PhotoPoint`, or None (with a warning) if too little is known.

    A photo frame needs pitch and vertical field of view; without them the heading wedge is used, and a warning says so.

    Parameters
    ----------
    point : PhotoPoint
    kind : str
        One of `algorithms.shared.parameters.SECTORS`.
    feedback : QgsProcessingFeedback
    """
    from ...core.viewshed.sector import FullCircle, PhotoFrame, Wedge

    if kind == "full circle":
        return FullCircle()
    if point.heading_deg is None:
        warn(feedback, point.name, Message("No viewshed: the heading is unknown."))
        return None
    if point.hfov_deg is None:
        warn(feedback, point.name, Message("No viewshed: the horizontal field of view is unknown."))
        return None
    if not is_field_of_view(point.hfov_deg) or (point.vfov_deg is not None and not is_field_of_view(point.vfov_deg)):
        warn(feedback, point.name, Message("No viewshed: a field of view must lie between 0 and 180 degrees."))
        return None
    if kind == "heading wedge":
        return Wedge(point.heading_deg, point.hfov_deg)
    if point.posed is None:
        # Without a position, of which the caller warns, there is no viewshed of either kind.
        if point.observer is not None:
            fault = Message(
                "Pitch or vertical field of view is unknown: the heading wedge is shown, not the photo's frame."
            )
            warn(feedback, point.name, fault)
        return Wedge(point.heading_deg, point.hfov_deg)
    camera, pose = point.posed.camera, point.posed.pose
    if point.skyline_row_px is None:
        return PhotoFrame(camera, pose)
    tolerance_px = camera.focal_px * math.tan(math.radians(point.skyline_tolerance_deg))
    return PhotoFrame(camera, pose, point.skyline_row_px, tolerance_px)
