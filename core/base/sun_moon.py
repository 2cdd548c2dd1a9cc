"""Compute where the sun and the moon stand, seen from a place at a time."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from datetime import datetime, timezone

import numpy as np

BODIES = ("sun", "moon")
J2000 = datetime(2000, 1, 1, 12, tzinfo=timezone.utc)
EARTH_EQUATOR_KM = 6378.14
ECLIPTIC_DEG = 23.4393

# Periodic terms of the moon: multiples of the arguments D, M, M' and F, and the amplitude.
LONGITUDE_DEG = (
    (0, 0, 1, 0, 6.288774), (2, 0, -1, 0, 1.274027), (2, 0, 0, 0, 0.658314), (0, 0, 2, 0, 0.213618),
    (0, 1, 0, 0, -0.185116), (0, 0, 0, 2, -0.114332), (2, 0, -2, 0, 0.058793), (2, -1, -1, 0, 0.057066),
    (2, 0, 1, 0, 0.053322), (2, -1, 0, 0, 0.045758), (0, 1, -1, 0, -0.040923), (1, 0, 0, 0, -0.034720),
    (0, 1, 1, 0, -0.030383), (2, 0, 0, -2, 0.015327), (0, 0, 1, 2, -0.012528), (0, 0, 1, -2, 0.010980),
    (4, 0, -1, 0, 0.010675), (0, 0, 3, 0, 0.010034),
)  # fmt: skip
LATITUDE_DEG = (
    (0, 0, 0, 1, 5.128122), (0, 0, 1, 1, 0.280602), (0, 0, 1, -1, 0.277693), (2, 0, 0, -1, 0.173237),
    (2, 0, -1, 1, 0.055413), (2, 0, -1, -1, 0.046271), (2, 0, 0, 1, 0.032573), (0, 0, 2, 1, 0.017198),
)  # fmt: skip
DISTANCE_KM = (
    (0, 0, 1, 0, -20905.355), (2, 0, -1, 0, -3699.111), (2, 0, 0, 0, -2955.968), (0, 0, 2, 0, -569.925),
    (2, 0, -2, 0, 246.158), (2, -1, 0, 0, -204.586), (2, 0, 1, 0, -170.733), (2, -1, -1, 0, -152.138),
)  # fmt: skip
MEAN_DISTANCE_KM = 385000.56


def direction_deg(body: str, longitude_deg: float, latitude_deg: float, when: datetime) -> tuple[float, float]:
    """Give the direction in which the sun or the moon is seen, with refraction.

    Parameters
    ----------
    body : str
        'sun' or 'moon'.
    longitude_deg, latitude_deg : float
        WGS 84 [degrees].
    when : datetime
        With a time zone, or UTC.

    Returns
    -------
    azimuth_deg, elevation_deg : float
        Clockwise from true north; apparent elevation angle [degrees]. Good to 0.05 degrees for the sun's and the
        moon's centre if they stand higher than 2 degrees.
    """
    where = {"sun": sun_direction_deg, "moon": moon_direction_deg}[body]
    azimuth, elevation = where(longitude_deg, latitude_deg, when)
    return azimuth, elevation + refraction_deg(elevation)


def sun_direction_deg(longitude_deg: float, latitude_deg: float, when: datetime) -> tuple[float, float]:
    """Compute the position of the sun.

    Parameters
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 [degrees].
    when : datetime
        Time with a time zone; without one it is taken as UTC.

    Returns
    -------
    azimuth_deg, elevation_deg : float
        Clockwise from true north; above the horizon, without refraction [degrees]. Good to about 0.02 degrees.

    References
    ----------
    .. [1] The Astronomical Almanac, low precision formulas for the sun (section C); 1950 to 2050.
    """
    days = _days(when)
    anomaly = np.radians(357.528 + 0.9856003 * days)
    longitude = np.radians(280.460 + 0.9856474 * days + 1.915 * np.sin(anomaly) + 0.020 * np.sin(2 * anomaly))
    obliquity = np.radians(23.439 - 4e-7 * days)
    x, y = np.cos(longitude), np.sin(longitude)
    return _seen((x, np.cos(obliquity) * y, np.sin(obliquity) * y), longitude_deg, latitude_deg, days)


def moon_direction_deg(longitude_deg: float, latitude_deg: float, when: datetime) -> tuple[float, float]:
    """Compute the position of the moon, seen from the surface of the earth.

    Parameters
    ----------
    longitude_deg, latitude_deg, when
        As for `sun_direction_deg`.

    Returns
    -------
    azimuth_deg, elevation_deg : float
        Clockwise from true north; above the horizon, without refraction [degrees]. Good to about 0.03 degrees.

    References
    ----------
    .. [1] Meeus, Astronomical Algorithms, 2nd edition, chapter 47 (the larger terms).
    """
    days = _days(when)
    longitude, latitude, distance = moon_ecliptic(days)
    longitude, latitude, tilt = np.radians([longitude, latitude, ECLIPTIC_DEG])
    x, y, z = np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)
    centre = distance * np.array([x, np.cos(tilt) * y - np.sin(tilt) * z, np.sin(tilt) * y + np.cos(tilt) * z])
    sidereal, place = _sidereal(longitude_deg, days), np.radians(latitude_deg)
    eye = np.array([np.cos(place) * np.cos(sidereal), np.cos(place) * np.sin(sidereal), np.sin(place)])
    towards = centre - EARTH_EQUATOR_KM * eye
    return _seen(towards / np.linalg.norm(towards), longitude_deg, latitude_deg, days)


def moon_ecliptic(days: float) -> tuple[float, float, float]:
    """Give the moon's ecliptic longitude and latitude [degrees] and distance [km] from the earth's centre.

    Parameters
    ----------
    days : float
        Since 1 January 2000, 12:00.
    """
    centuries = days / 36525.0
    arguments = np.array(
        [
            297.8501921 + 445267.1114034 * centuries,
            357.5291092 + 35999.0502909 * centuries,
            134.9633964 + 477198.8675055 * centuries,
            93.2720950 + 483202.0175233 * centuries,
        ]
    )
    longitude = 218.3164477 + 481267.88123421 * centuries + _sum(np.sin, LONGITUDE_DEG, arguments)
    latitude = _sum(np.sin, LATITUDE_DEG, arguments)
    return longitude % 360, latitude, MEAN_DISTANCE_KM + _sum(np.cos, DISTANCE_KM, arguments)


def refraction_deg(elevation_deg: float) -> float:
    """Give how much the air at sea level lifts a body at a true elevation angle [degrees].

    References
    ----------
    .. [1] Saemundsson 1986, Sky and Telescope 72, 70.
    """
    above = np.maximum(elevation_deg, -1.0)
    return float(1.02 / 60 / np.tan(np.radians(above + 10.3 / (above + 5.11))))


def _sum(function: Callable, terms: tuple, arguments: np.ndarray) -> float:
    table = np.array(terms)
    return float(table[:, 4] @ function(np.radians(table[:, :4] @ arguments)))


def _days(when: datetime) -> float:
    when = when.replace(tzinfo=timezone.utc) if when.tzinfo is None else when.astimezone(timezone.utc)
    return (when - J2000).total_seconds() / 86400.0


def _sidereal(longitude_deg: float, days: float) -> float:
    return math.radians(280.46062 + 360.98564737 * days + longitude_deg)


def _seen(equator: Iterable[float], longitude_deg: float, latitude_deg: float, days: float) -> tuple[float, float]:
    """Azimuth and elevation angle of a unit vector towards (vernal equinox, 6 h of right ascension, north pole)."""
    x, y, z = equator
    sidereal, latitude = _sidereal(longitude_deg, days), np.radians(latitude_deg)
    outward = x * np.cos(sidereal) + y * np.sin(sidereal)
    east = y * np.cos(sidereal) - x * np.sin(sidereal)
    north = np.cos(latitude) * z - np.sin(latitude) * outward
    up = np.sin(latitude) * z + np.cos(latitude) * outward
    return float(np.degrees(np.arctan2(east, north)) % 360), float(np.degrees(np.arcsin(np.clip(up, -1, 1))))
