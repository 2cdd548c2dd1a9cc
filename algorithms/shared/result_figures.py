"""The figure of each result in three panels: for the report, and as PNG files if the user chooses a folder."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime

from qgis.PyQt.QtCore import QDateTime

from ...core.base.errors import MissingPackageError, OutputError, PhotoError
from . import parameters as shared
from .feedback import warn
from .fields import is_null, number_or_none
from .i18n import marked, tr
from .outputs import write_whole
from .picture_files import PictureFolder

HEIGHT_PX = 480
PREVIEW_PX = 1024
PAUSE_S = 12 * 3600
"""Photographs taken further apart in time than this belong to different routes [s]."""


def figures_out(name="FIGURES"):
    """Folder for the figures."""
    text = tr(
        "PNG files with three panels: the photograph, the heading and field of view on the DEM, and the viewshed "
        "with the camera and, if the points have a timestamp, the path between the cameras."
    )  # fmt: skip
    return shared.advanced(shared.folder_out(name, tr("Folder for one figure per photo"), text))


@dataclass(frozen=True)
class PhotoPlace:
    """The place and time of a photograph.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 [degrees].
    time_s : float or None
        Seconds since any epoch, by the camera's clock [s].
    """

    longitude_deg: float
    latitude_deg: float
    time_s: float | None = None


def stations_of(rows):
    """Stations of `PointRow`s; for rows without a usable geometry, the attributes longitude and latitude are used."""
    found = []
    for row in rows:
        place = row.longitude_deg, row.latitude_deg
        if None in place:
            place = tuple(number_or_none(_value(row.feature, name)) for name in ("longitude", "latitude"))
        if None not in place and place != (0, 0):
            found.append(PhotoPlace(*place, _seconds(_value(row.feature, "timestamp"))))
    return found


def _value(feature, name):
    index = feature.fields().lookupField(name)
    return None if index < 0 or is_null(feature[index]) else feature[index]


def _seconds(value):
    if isinstance(value, QDateTime):
        return value.toMSecsSinceEpoch() / 1000 if value.isValid() else None
    try:
        return datetime.fromisoformat(value).timestamp() if isinstance(value, str) else None
    except ValueError:
        return None


class ResultFigures:
    """Draws results; does nothing if neither report nor folder is requested.

    Parameters
    ----------
    dem : core.io.raster.Dem
    folder : str
        Folder for the PNG files; empty for none.
    stations : list of PhotoPlace
        Stations of all photographs, for the route between them.
    feedback : QgsProcessingFeedback
    for_report : bool
        The panels are needed even without a folder.
    """

    def __init__(self, dem, folder, stations, feedback, for_report=False):
        self.dem, self.feedback, self.stations = dem, feedback, stations
        self.files, self.wanted = PictureFolder(folder), bool(folder) or for_report
        self._made = None

    def draw(self, point, viewshed, pixels=None):
        """Return the panels as uint8 (h, w, 3) pixels, and write them to the folder; None if not requested.

        Parameters
        ----------
        point : PhotoPoint
        viewshed : core.base.viewed.Viewshed
        pixels : uint8 (h, w, 3) array or None
            The photograph; if None, a reduced copy is read.
        """
        if not self.wanted:
            return None
        from ...core.figures.ground import three_panels
        from ...core.figures.raster import encode_png

        try:
            photo = self._photo(point) if pixels is None else pixels
            panels = three_panels(photo, self._map(point, viewshed), HEIGHT_PX, say=marked)
            if self.files.folder is not None:
                self._write(point, encode_png(panels, quickly=True))
            return panels
        except MissingPackageError as error:
            warn(self.feedback, point.name, error.message)
            self.wanted = False
            return None

    def _write(self, point, content):
        path = self.files.folder / f"{self.files.stem(point.name)}.png"
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, content)
        except OSError as error:
            raise OutputError.of_file(path, error.strerror or str(error)) from None

    def _photo(self, point):
        from ...core.io.photo import read_photo

        if not point.path:
            return None
        try:
            return read_photo(point.path, PREVIEW_PX).pixels
        except PhotoError as error:
            warn(self.feedback, point.name, error.message)
            return None

    def _map(self, point, viewshed):
        from ...core.figures.ground import SeenGround, ground_map
        from ...core.figures.map import MapObserver

        frame = viewshed.frame
        eye = MapObserver(frame.col_px, frame.row_px, point.heading_deg, point.hfov_deg)
        others, track_px = self._surroundings()
        seen = SeenGround(viewshed.window, viewshed.values)
        return ground_map(self.dem, frame, seen, [eye, *others], track_px)

    def _surroundings(self):
        """The other stations as `MapObserver`s, and the route through them in pixels or None; computed once."""
        if self._made is None:
            self._made = self._place_stations()
        return self._made

    def _place_stations(self):
        import numpy as np

        from ...core.figures.map import MapObserver

        if not self.stations:
            return [], None
        longitude, latitude = np.array([(s.longitude_deg, s.latitude_deg) for s in self.stations]).T
        places = np.column_stack(self.dem.pixel_of(longitude, latitude))
        known = np.isfinite(places).all(axis=1)
        others = [MapObserver(col, row, beside=True) for col, row in places[known].tolist()]
        timed = [(s.time_s, place) for s, place in zip(self.stations, places.tolist()) if s.time_s is not None]
        return others, way(sorted(timed)) if len(timed) > 1 else None


def way(timed):
    """(N, 2) pixels of (time [s], (col, row)) in order of time, with a gap at each long pause."""
    import numpy as np

    points = []
    for index, (time_s, place) in enumerate(timed):
        if index and time_s - timed[index - 1][0] > PAUSE_S:
            points.append((np.nan, np.nan))
        points.append(place)
    return np.array(points, float)
