"""Viewsheds of oriented photographs: their parameters, and the sector of each photo."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ...core.base.camera import Camera, Pose, focal_of_fov_px
from ...core.base.messages import Message
from . import parameters as shared
from .feedback import warn
from .i18n import tr

FRAME_WIDTH_PX = 4000
"""Width of the picture where only its fields of view are known; fine enough that its edges fall within a cell."""


@dataclass(frozen=True, eq=False)
class Sight:
    """One oriented photo as the viewshed needs it; None where unknown.

    Attributes
    ----------
    name : str
        For messages and file names.
    photo : str or None
        Path.
    source_id : int
        Of the feature.
    longitude_deg, latitude_deg : float or None
    eye_elevation_m : float or None
        Absolute [m]; None takes the DEM plus the eye height.
    heading_deg, pitch_deg, roll_deg, hfov_deg, vfov_deg : float or None
    heading_lo_deg, heading_hi_deg : float or None
        Ends of the heading's 90 % interval.
    width_px : int or None
        Of the upright picture; None takes `FRAME_WIDTH_PX`.
    skyline_row_px : (width_px,) array or None
        The photograph's own skyline, above which no ground is claimed; see `PhotoFrame`.
    skyline_tolerance_deg : float
    """

    name: str
    photo: str | None
    source_id: int
    longitude_deg: float | None
    latitude_deg: float | None
    eye_elevation_m: float | None = None
    heading_deg: float | None = None
    pitch_deg: float | None = None
    roll_deg: float | None = None
    hfov_deg: float | None = None
    vfov_deg: float | None = None
    heading_lo_deg: float | None = None
    heading_hi_deg: float | None = None
    width_px: int | None = None
    skyline_row_px: Any = None
    skyline_tolerance_deg: float = 0.0

    @property
    def key(self):
        """What tells it from all other sights of a run."""
        return self.source_id, self.photo


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


def sector_of(sight, kind, feedback):
    """Sector of the view, or None (with a warning) where too little is known.

    A photo frame needs pitch and vertical field of view; without them the heading wedge stands in, and a warning
    says so.
    """
    from ...core.viewshed.sector import FullCircle, PhotoFrame, Wedge

    if kind == "full circle":
        return FullCircle()
    if sight.heading_deg is None:
        warn(feedback, sight.name, Message("No viewshed: the heading is unknown."))
        return None
    if sight.hfov_deg is None:
        warn(feedback, sight.name, Message("No viewshed: the horizontal field of view is unknown."))
        return None
    if not 0 < sight.hfov_deg < 180 or (sight.vfov_deg is not None and not 0 < sight.vfov_deg < 180):
        warn(feedback, sight.name, Message("No viewshed: a field of view must lie between 0 and 180 degrees."))
        return None
    if kind == "heading wedge":
        return Wedge(sight.heading_deg, sight.hfov_deg)
    if sight.pitch_deg is None or sight.vfov_deg is None:
        text = Message("Pitch or vertical field of view is unknown: the heading wedge is shown, not the photo's frame.")
        warn(feedback, sight.name, text)
        return Wedge(sight.heading_deg, sight.hfov_deg)
    camera, pose = view_of(sight)
    if sight.skyline_row_px is None:
        return PhotoFrame(camera, pose)
    tolerance_px = camera.focal_px * math.tan(math.radians(sight.skyline_tolerance_deg))
    return PhotoFrame(camera, pose, sight.skyline_row_px, tolerance_px)


def view_of(sight):
    """Camera and pose of a sight, or (None, None) where something of them is unknown."""
    if None in (sight.heading_deg, sight.pitch_deg, sight.hfov_deg, sight.vfov_deg):
        return None, None
    return camera_of(sight), Pose(sight.heading_deg, sight.pitch_deg, sight.roll_deg or 0.0)


def camera_of(sight):
    """Pinhole camera with the fields of view of a sight."""
    width_px = sight.width_px or FRAME_WIDTH_PX
    focal_px = focal_of_fov_px(width_px, sight.hfov_deg)
    height_px = 2 * focal_px * _half_tangent(sight.vfov_deg)
    return Camera(width_px, max(round(height_px), 1), focal_px)


def _half_tangent(fov_deg):
    return 1 / (2 * focal_of_fov_px(1.0, fov_deg))
