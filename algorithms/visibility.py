"""Viewsheds of oriented photographs: the parameters, the sector of each photo, the loop, the outputs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..core.camera import Camera, Pose, focal_of_fov_px
from ..core.errors import Cancelled, PhotoError
from ..core.progress import checkpoint, subtask
from . import parameters as shared
from .feedback import FeedbackProgress, announce, warn
from .i18n import tr
from .outputs import make_folder_of

FRAME_WIDTH_PX = 4000
"""Width of the picture where only its fields of view are known; fine enough that its edges fall within a cell."""


@dataclass(frozen=True)
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


def add_range_parameters(algorithm, eye_height=True):
    """Declare heights, range and refraction of the viewshed."""
    from ..core.viewshed import ViewshedOptions

    defaults = ViewshedOptions()
    parameters = [shared.eye_height()] if eye_height else []
    parameters += [
        shared.distance(
            "TARGET_HEIGHT",
            tr("Target height above ground (m)"),
            defaults.target_height_m,
            tr("Height of what is looked at; 0 asks for the ground itself."),
        ),
        shared.distance(
            "MIN_DISTANCE",
            tr("Minimum distance (m)"),
            defaults.min_distance_m,
            tr("Ground nearer than this is not claimed as seen, but hides what lies behind it."),
        ),
    ]
    for parameter in parameters:
        algorithm.addParameter(shared.advanced(parameter))


def viewshed_options(algorithm, parameters, context, max_distance="MAX_DISTANCE"):
    """Options of the core from the parameters."""
    from ..core.viewshed import ViewshedOptions

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
    from ..core.viewshed_sector import FullCircle, PhotoFrame, Wedge

    if kind == "full circle":
        return FullCircle()
    missing = tr("heading") if sight.heading_deg is None else tr("horizontal field of view")
    if sight.heading_deg is None or sight.hfov_deg is None:
        warn(feedback, sight.name, tr("No viewshed: the {value} is unknown.").format(value=missing))
        return None
    if not 0 < sight.hfov_deg < 180 or (sight.vfov_deg is not None and not 0 < sight.vfov_deg < 180):
        warn(feedback, sight.name, tr("No viewshed: a field of view must lie between 0 and 180 degrees."))
        return None
    if kind == "heading wedge":
        return Wedge(sight.heading_deg, sight.hfov_deg)
    if sight.pitch_deg is None or sight.vfov_deg is None:
        text = tr("Pitch or vertical field of view is unknown: the heading wedge is shown, not the photo's frame.")
        warn(feedback, sight.name, text)
        return Wedge(sight.heading_deg, sight.hfov_deg)
    return PhotoFrame(camera_of(sight), Pose(sight.heading_deg, sight.pitch_deg, sight.roll_deg or 0.0))


def camera_of(sight):
    """Pinhole camera with the fields of view of a sight."""
    focal_px = focal_of_fov_px(FRAME_WIDTH_PX, sight.hfov_deg)
    height_px = 2 * focal_px * _half_tangent(sight.vfov_deg)
    return Camera(FRAME_WIDTH_PX, max(round(height_px), 1), focal_px)


def _half_tangent(fov_deg):
    return 1 / (2 * focal_of_fov_px(1.0, fov_deg))


class Viewer:
    """Computes viewsheds, and keeps each in a file of its own where a folder is given.

    A repeated run takes what an earlier one, perhaps killed, has finished there; a file of other settings or another
    DEM is computed anew.

    Parameters
    ----------
    dem : core.io.raster.Dem
    kind : str
        Of `parameters.SECTORS`.
    eye_height_m : float
        Above the DEM, for sights without an elevation of their own [m].
    options : ViewshedOptions
    feedback : QgsProcessingFeedback
    folder : str
        For one GeoTIFF per photo; empty where not wanted.
    """

    def __init__(self, dem, kind, eye_height_m, options, feedback, folder=""):
        self.dem, self.kind, self.eye_height_m, self.options = dem, kind, eye_height_m, options
        self.feedback, self.folder, self._names = feedback, folder, set()

    def each(self, sights, share=(0.0, 1.0)):
        """Yield (sight, viewshed) photo by photo; those without one are warned of."""
        progress = subtask(FeedbackProgress(self.feedback), *share)
        for index, sight in enumerate(sights):
            announce(self.feedback, sight.name, index, len(sights))
            part = subtask(progress, index / len(sights), (index + 1) / len(sights))
            try:
                found = self.view(sight, part)
            except Cancelled:
                text = tr("Cancelled after {done} of {count} viewsheds.")
                self.feedback.pushWarning(text.format(done=index, count=len(sights)))
                raise
            if found is not None:
                yield sight, found
        checkpoint(progress, 1.0)

    def view(self, sight, progress):
        """Give one viewshed, or warn and give None."""
        from ..core.terrain import Observer

        sector = sector_of(sight, self.kind, self.feedback)
        if sector is None:
            return None
        if sight.longitude_deg is None:
            warn(self.feedback, sight.name, tr("The point has no usable position."))
            return None
        observer = Observer(sight.longitude_deg, sight.latitude_deg, self.eye_height_m, sight.eye_elevation_m)
        try:
            return self._compute_or_take(sight, observer, sector, progress)
        except PhotoError as error:
            warn(self.feedback, sight.name, str(error))
            return None

    def _compute_or_take(self, sight, observer, sector, progress):
        from ..core.io.viewshed_raster import fingerprint, viewshed_once
        from ..core.viewshed import FRAME_MARGIN, viewshed

        def compute():
            return viewshed(self.dem, observer, sector, self.options, progress)

        if not self.folder:
            return compute()
        path = Path(self.folder) / f"{file_stem(sight, self._names)}.tif"
        make_folder_of(str(path))
        mark = fingerprint(self.dem, observer, sector, self.options)
        facts = {"PHOTO": sight.photo or "", "HEADING": sight.heading_deg, "SOFTWARE": "Skyline Viewshed"}
        found, computed = viewshed_once(str(path), self.dem, mark, compute, facts)
        if computed:
            return found
        self.feedback.pushInfo(tr("{name}: taken from {path}").format(name=sight.name, path=path))
        radius_m = FRAME_MARGIN * self.options.max_distance_m
        frame = self.dem.frame(sight.longitude_deg, sight.latitude_deg, radius_m)
        return KeptViewshed(found.window, found.values, frame)


@dataclass(frozen=True, eq=False)
class KeptViewshed:
    """An earlier run's viewshed: window and values as in `core.viewshed.Viewshed`, and the observer's frame."""

    window: Any
    values: Any
    frame: Any


def file_stem(sight, taken):
    """Unique name for a photo's own raster; `taken` remembers the names in use."""
    stem = Path(sight.photo).stem if sight.photo else f"point_{sight.source_id}"
    unique, number = stem, 1
    while unique.lower() in taken:
        number += 1
        unique = f"{stem}_{number}"
    taken.add(unique.lower())
    return unique
