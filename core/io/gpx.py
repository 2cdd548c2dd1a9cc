"""Track points read from GPX files."""

from __future__ import annotations

import os
from datetime import datetime, timedelta

from ..base.errors import SkylineViewshedError
from ..base.messages import Message
from .gdal_quiet import quiet_gdal


class UnreadableTrackError(SkylineViewshedError):
    """The file is missing, damaged, or has no track points."""


def read_track_points(path):
    """Read the points of all tracks of a GPX file.

    Parameters
    ----------
    path : str

    Returns
    -------
    time_s, longitude_deg, latitude_deg, elevation_m : lists of float
        Seconds since 1970, UTC; NaN where the file gives none.

    Raises
    ------
    UnreadableTrackError
    """
    from osgeo import gdal, ogr

    path = os.fspath(path)
    with quiet_gdal():
        try:
            source = gdal.OpenEx(path, gdal.OF_VECTOR, allowed_drivers=["GPX"])
            layer = None if source is None else source.GetLayerByName("track_points")
            rows = [] if layer is None else [_row(feature, ogr) for feature in layer]
        except RuntimeError:
            rows = []
    if not rows:
        raise UnreadableTrackError(
            Message("The track {path} has no points. Choose a GPX file with a recorded track.", path=path)
        )
    return tuple(list(column) for column in zip(*rows))


def _row(feature, ogr):
    nan = float("nan")
    geometry, time = feature.GetGeometryRef(), feature.GetFieldIndex("time")
    longitude, latitude = (nan, nan) if geometry is None else (geometry.GetX(), geometry.GetY())
    height = feature.GetFieldIndex("ele")
    elevation = feature.GetFieldAsDouble(height) if height >= 0 and feature.IsFieldSetAndNotNull(height) else nan
    seconds = nan
    if time >= 0 and feature.IsFieldSetAndNotNull(time):
        year, month, day, hour, minute, second, flag = feature.GetFieldAsDateTime(time)
        seconds = _seconds((year, month, day, hour, minute), second, flag)
    return seconds, longitude, latitude, elevation


def _seconds(to_minute, second, flag):
    """Seconds since 1970; OGR's flag counts quarters of an hour from 100, which is UTC."""
    moment = datetime(*to_minute) - datetime(1970, 1, 1)
    away = timedelta(minutes=15 * (flag - 100)) if flag > 1 else timedelta()
    return (moment - away).total_seconds() + float(second)
