"""What a person says that a pixel shows: a map point, the sun or the moon."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import timedelta, timezone
from typing import Any

import numpy as np

from .curvature import apparent_drop_m
from .errors import PhotoError
from .messages import Message
from .model import PhotoMetadata
from .sun_moon import BODIES, direction_deg
from .terrain import Observer, eye_elevation_m, ground_elevation_m

LOWEST_BODY_DEG = -1.0
"""A body that stands lower than this is hidden by the earth, even from a summit and with refraction [degrees]."""


@dataclass(frozen=True)
class LandmarkHint:
    """A pixel of the full upright picture and what it shows: a map point, the sun or the moon.

    Attributes
    ----------
    x_px, y_px : float
        Position; the centre of the first pixel is at 0 [pixels].
    longitude_deg, latitude_deg : float or None
        WGS 84 [degrees].
    elevation_m : float or None
        Absolute elevation [m]; None means the elevation of the DEM.
    sigma_px : float
        Precision of the click [pixels].
    body : str or None
        'sun' or 'moon', whose direction follows from the time of the photograph; it needs no map point.
    """

    x_px: float
    y_px: float
    longitude_deg: float | None = None
    latitude_deg: float | None = None
    elevation_m: float | None = None
    sigma_px: float = 5.0
    body: str | None = None

    def __post_init__(self) -> None:
        if self.body not in (None, *BODIES):
            raise ValueError(f"body must be one of {BODIES}, not {self.body!r}")
        if self.body is None and None in (self.longitude_deg, self.latitude_deg):
            raise ValueError("a landmark needs longitude_deg and latitude_deg, or body='sun' or 'moon'")

    def direction_deg(self, dem: Any, observer: Observer, metadata: PhotoMetadata) -> tuple[float, float]:
        """Give the true azimuth and the elevation angle of what the pixel shows, seen from the eye.

        Parameters
        ----------
        dem : Terrain
        observer : Observer
        metadata : PhotoMetadata
            For the time, from which the place of the sun and the moon follows.

        Returns
        -------
        azimuth_deg, elevation_deg : float

        Raises
        ------
        PhotoError
            The time is unknown, or the body was below the horizon.
        ObserverOutsideDemError, NoElevationAtObserverError
            The map point has no elevation.
        """
        longitude, latitude = self.longitude_deg, self.latitude_deg
        if self.body is not None or longitude is None or latitude is None:
            return self._body_deg(self.body or "", observer, metadata)
        east, north = dem.local_of(observer, longitude, latitude)
        elevation = self.elevation_m
        if elevation is None:
            elevation = ground_elevation_m(dem, dem.frame(longitude, latitude, 1_000.0))
        frame = dem.frame(observer.longitude_deg, observer.latitude_deg, 1_000.0)
        distance = float(np.hypot(east, north))
        rise = elevation - apparent_drop_m(distance) - eye_elevation_m(dem, frame, observer)
        return float(np.degrees(np.arctan2(east, north)) % 360), float(np.degrees(np.arctan2(rise, distance)))

    def _body_deg(self, body: str, observer: Observer, metadata: PhotoMetadata) -> tuple[float, float]:
        if metadata.taken_at is None or metadata.utc_offset_s is None:
            raise PhotoError(
                Message(
                    "A landmark is the sun or the moon, but the photo does not record its time with a time zone. "
                    "Write the tags DateTimeOriginal and OffsetTimeOriginal, or leave this landmark out."
                )
            )
        when = metadata.taken_at.replace(tzinfo=timezone(timedelta(seconds=metadata.utc_offset_s)))
        azimuth, elevation = direction_deg(body, observer.longitude_deg, observer.latitude_deg, when)
        if elevation < LOWEST_BODY_DEG:
            raise PhotoError(
                Message(
                    "A landmark is the sun or the moon, which was below the horizon at {time}. Check the landmark and "
                    "the clock of the camera.",
                    time=f"{when:%Y-%m-%d %H:%M %z}",
                )
            )
        return azimuth, elevation
