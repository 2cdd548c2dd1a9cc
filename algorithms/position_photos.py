"""Photographs without GPS and the track of the walk -> points at the places of their times."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPoint,
    QgsProcessing,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterEnum,
    QgsProcessingParameterString,
    QgsWkbTypes,
)

from ..core.base.errors import PhotoError
from ..core.base.messages import Message
from ..core.base.progress import checkpoint, subtask
from .base import SkylineAlgorithm
from .shared import fields
from .shared import parameters as shared
from .shared.elevation import dem_fault, dem_source
from .shared.feedback import FeedbackProgress, warn
from .shared.fields import FieldSpec, is_null
from .shared.i18n import in_users_language, tr
from .shared.layers import read_points
from .shared.outputs import write_features
from .shared.photo_attributes import attributes_of, photos_in
from .shared.styling import style_on_completion
from .shared.track_input import add_track_parameters, read_track, track_fault

CLOCKS = ("given", "solve")


class PositionPhotos(SkylineAlgorithm):
    """Place photographs on a track by their times."""

    ID = "positionphotos"
    GROUP_ID = "photographs"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Position photos from a track")

    def tags(self):
        """Search words."""
        return tr("photo,gps,gpx,track,time,clock,geotag,position,exif,time zone").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Points of photographs without GPS, from the times of a recorded track")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Makes one point per photograph at the place of the track at the photograph's time. "
                "The point's error (<b>pos_err</b>) grows with the gap between the track points "
                "around it; <i>Orient photos</i> takes it into account. If the track gives no "
                "position for that time, the point has no geometry and <b>pos_note</b> says why."
            ),
            tr(
                "Cameras record local time. The time zone is read from the file, or taken from the parameter. If the "
                "clock was wrong, give its offset, or have it found <i>from the skylines</i>: this needs an elevation "
                "model and at least three photographs with a clear skyline from different places, and takes a few "
                "minutes. If other offsets fit as well, no photograph is placed and a warning says so."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        text = tr("JPEG and HEIC files; a GPS position is not needed.")
        folder = shared.folder_in("FOLDER", tr("Folder of photographs"), text, optional=True)
        photos = shared.photo_source(optional=True)
        photos.setDataTypes([QgsProcessing.SourceType.TypeVector])
        photos.setHelp(tr("Layer or table with the paths of the photographs, in place of a folder."))
        self.addParameter(folder)
        self.addParameter(photos)
        self.addParameter(shared.advanced(shared.photo_field()))
        recursive = QgsProcessingParameterBoolean("RECURSIVE", tr("Include subfolders"), False, optional=True)
        self.addParameter(shared.advanced(shared.explained(recursive, tr("Also searches all subfolders."))))
        add_track_parameters(self)
        zone = QgsProcessingParameterString("TIME_ZONE", tr("Time zone of the camera's clock"), "", optional=True)
        text = tr("For example +05:45 or Asia/Kathmandu. Empty: as the photograph records it.")
        self.addParameter(shared.explained(zone, text))
        clock = QgsProcessingParameterEnum(
            "CLOCK", tr("Camera's clock"), [tr("as given"), tr("find its offset from the skylines")], defaultValue=0
        )
        text = tr(
            "The skylines show where the photographs were taken, and so how much the clock is ahead: up to 14 hours to "
            "either side. At most 20 photographs are used, spread over the walk and at least a minute apart."
        )
        self.addParameter(shared.explained(clock, text))
        text = tr("Seconds by which the camera's clock is ahead of the true time; negative if it is behind.")
        offset = shared.number("CLOCK_OFFSET", tr("Clock is ahead by (s)"), 0.0, text, optional=True)
        self.addParameter(shared.advanced(offset))
        dem = shared.dem()
        dem.setFlags(dem.flags() | dem.Flag.FlagOptional)
        dem.setHelp(tr("Needed only to find the clock's offset from the skylines."))
        self.addParameter(dem)
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        text = tr("Longest time between two track points that is interpolated; beyond the track's ends, half of it.")
        gap = shared.number("MAX_GAP", tr("Interpolation limit (s)"), 600.0, text, minimum=1.0, optional=True)
        text = tr("Standard deviation of the track's points.")
        error = shared.distance("TRACK_ERROR", tr("Error of the track (m)"), 5.0, text, minimum=0.1, optional=True)
        self.addParameter(shared.advanced(gap))
        self.addParameter(shared.advanced(error))
        text = tr(
            "One point per photograph, with the source of its position and its error; without geometry if "
            "there is no position."
        )
        self.addParameter(shared.points_out("OUTPUT", tr("Positioned photos"), text=text))
        for name, label in (
            ("COUNT", tr("Number of photos")),
            ("PLACED", tr("Number of photos with a position")),
            ("CLOCK_FOUND", tr("Offset of the clock that was used (s)")),
            ("CLOCK_SIGMA", tr("Standard deviation of the clock's offset (s)")),
        ):
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def input_fault(self, parameters, context):
        """Check the photographs, the track, the time zone and the DEM."""
        from ..core.track.track import TrackError
        from ..core.track.zone import zone_of

        folder = self.parameterAsString(parameters, "FOLDER", context)
        if bool(folder) == (not is_null(parameters.get("INPUT"))):
            return tr("Choose either a folder of photographs or a layer with their paths.")
        try:
            zone_of(self.parameterAsString(parameters, "TIME_ZONE", context))
        except TrackError as error:
            return error.message
        if self._solves(parameters, context):
            if is_null(parameters.get("DEM")):
                return tr("To find the clock's offset from the skylines, choose an elevation model.")
            fault = dem_fault(self, parameters, context)
            if fault:
                return fault
        return track_fault(self, parameters, context)

    def prepareAlgorithm(self, parameters, context, feedback):
        """Read from the layers what they provide in the main thread only."""
        self.dem = dem_source(self, parameters, context) if self._solves(parameters, context) else None
        return True

    def _solves(self, parameters, context):
        return CLOCKS[self.parameterAsEnum(parameters, "CLOCK", context)] == "solve"

    def compute(self, parameters, context, feedback):
        """Read the times, find the clock's offset if requested, then place and write."""
        from ..core.track.track import TrackOptions
        from ..core.track.zone import zone_of

        track = read_track(self, parameters, context)
        limits = TrackOptions(
            max_gap_s=self.parameterAsDouble(parameters, "MAX_GAP", context),
            gps_error_m=self.parameterAsDouble(parameters, "TRACK_ERROR", context),
        )
        zone = zone_of(self.parameterAsString(parameters, "TIME_ZONE", context))
        photos = read_times(self._paths(parameters, context, feedback), zone, self.dem is not None, feedback)
        offset_s, sigma_s, refusal = self.parameterAsDouble(parameters, "CLOCK_OFFSET", context), 0.0, None
        if self.dem is not None:
            answer = self._solved(photos, track, limits, offset_s, feedback)
            refusal = answer.message if answer.offset_s is None else None
            offset_s, sigma_s = offset_s + (answer.offset_s or 0.0), answer.sigma_s or 0.0
        rows, placed = [], 0
        for photo in photos:
            geometry, values = positioned(photo, track, limits, (offset_s, sigma_s), refusal)
            placed += geometry is not None
            if geometry is None:
                warn(feedback, photo.name, values[-1])
            rows.append((geometry, values))
        specs = fields.photo_specs() + position_specs()
        output = write_features(
            self, parameters, "OUTPUT", context, fields.qgis_fields(specs), QgsWkbTypes.Type.PointZ,
            QgsCoordinateReferenceSystem("EPSG:4326"), rows,
        )  # fmt: skip
        style_on_completion(context, output, "photos", tr("Positioned photos"), specs, self.displayName())
        feedback.pushInfo(tr("{placed} of {count} photos have a position.").format(placed=placed, count=len(rows)))
        found = {"CLOCK_FOUND": None if refusal else offset_s, "CLOCK_SIGMA": None if refusal else sigma_s}
        return {"OUTPUT": output, "COUNT": len(rows), "PLACED": placed, **found}

    def _paths(self, parameters, context, feedback):
        folder = self.parameterAsString(parameters, "FOLDER", context)
        if folder:
            return photos_in(folder, self.parameterAsBoolean(parameters, "RECURSIVE", context), feedback)
        _, rows = read_points(self, parameters, context, "INPUT", "PHOTO_FIELD", needs_position=False)
        return [row.path for row in rows if row.path]

    def _solved(self, photos, track, limits, offset_s, feedback):
        from ..core.walk import clock_from_skylines

        dem = self.dem.open()  # type: ignore[union-attr]
        timed = [photo for photo in photos if photo.time_s is not None]
        answer = clock_from_skylines(
            [photo.path for photo in timed], [photo.time_s - offset_s for photo in timed], track, dem,
            track_options=limits, progress=subtask(FeedbackProgress(feedback), 0.1, 0.95),
        )  # fmt: skip
        text = in_users_language(answer.message)
        feedback.pushWarning(text) if answer.offset_s is None else feedback.pushInfo(text)
        return answer


@dataclass(frozen=True)
class TimedPhoto:
    """A photograph's metadata and time (seconds since 1970, UTC), or the reason why it has none."""

    path: str
    metadata: Any
    time_s: float | None
    reason: str | None

    @property
    def name(self):
        """Name of the file."""
        return Path(self.path).name


def read_times(paths, zone, any_zone, feedback):
    """Read the metadata of all paths; `any_zone` takes UTC for photographs whose zone nobody knows."""
    from datetime import timedelta, timezone

    from ..core.io.photo import read_metadata
    from ..core.track.zone import seconds_utc

    photos, progress = [], subtask(FeedbackProgress(feedback), 0.0, 0.1)
    for index, path in enumerate(paths):
        checkpoint(progress, index / len(paths))
        metadata, time_s, reason = None, None, None
        try:
            metadata = read_metadata(path)
            own = None if metadata.utc_offset_s is None else timezone(timedelta(seconds=metadata.utc_offset_s))
            used = zone or own or (timezone.utc if any_zone else None)
            if metadata.taken_at is None:
                reason = Message("The photo records no time.")
            elif used is None:
                reason = Message("The photo records no time zone. Give the time zone of the camera's clock.")
            else:
                time_s = seconds_utc(metadata.taken_at, used)
        except PhotoError as error:
            reason = error.message
        photos.append(TimedPhoto(str(path), metadata, time_s, reason))
    return photos


def positioned(photo, track, limits, clock, refusal):
    """Geometry (None without a place) and attributes of a photograph; `clock` is its offset and standard deviation."""
    import numpy as np

    from ..core.track.track import Placed, place_at, speed_at

    place = photo.reason or refusal or place_at(track, photo.time_s - clock[0], limits)
    if photo.metadata is None:
        path = Path(photo.path)
        known = {"photo": photo.path, "filename": path.stem, "directory": str(path.parent)}
        values = [known.get(spec.name) for spec in fields.photo_specs()]
    else:
        values = attributes_of(photo.metadata)
    if not isinstance(place, Placed):
        return None, [*values, None, None, in_users_language(place)]
    names = [spec.name for spec in fields.photo_specs()]
    ours = {"longitude": repr(place.longitude_deg), "latitude": repr(place.latitude_deg), "altitude": place.elevation_m}
    values = [ours.get(name, value) for name, value in zip(names, values)]
    error_m = float(np.hypot(place.error_m, clock[1] * speed_at(track, photo.time_s - clock[0])))
    geometry = QgsGeometry(QgsPoint(place.longitude_deg, place.latitude_deg, place.elevation_m or 0.0))
    return geometry, [*values, error_m, place.gap_s, tr("from the track")]


def position_specs():
    """Fields that are added to those of a photograph."""
    return [
        FieldSpec("pos_err", "real", tr("Error of the position (m)")),
        FieldSpec("pos_gap", "real", tr("Time between the track points around the photo (s)")),
        FieldSpec("pos_note", "text", tr("Where the position comes from, or why there is none")),
    ]
