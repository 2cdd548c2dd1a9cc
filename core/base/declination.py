"""Magnetic declination, which converts a compass heading to a true heading.

The field is the negative gradient of a potential expanded in Schmidt semi-normalised spherical harmonics to degree
13. The model covers the field of the Earth's core only: local rock and a phone's own magnets can deflect a compass
much further.

References
----------
.. [1] IAGA Division V Working Group V-MOD, IGRF-14, 2024, doi:10.5281/zenodo.14012302.
.. [2] Alken, P. et al., International Geomagnetic Reference Field: the thirteenth generation, Earth Planets Space 73,
   49 (2021), doi:10.1186/s40623-020-01288-x, equations 1 to 3.
"""

from __future__ import annotations

import os
from datetime import datetime
from functools import lru_cache

import numpy as np

COEFFICIENTS_FILE = os.path.join(os.path.dirname(__file__), "igrf14.txt")
REFERENCE_RADIUS_M = 6_371_200.0
WGS84_SEMI_MAJOR_M = 6_378_137.0
WGS84_E2 = 6.694379990141e-3


def declination_deg(latitude_deg: float, longitude_deg: float, altitude_m: float, when: datetime) -> float | None:
    """Give the declination of the Earth's main field.

    Parameters
    ----------
    latitude_deg, longitude_deg : float
        WGS 84 position [degrees].
    altitude_m : float
        Height above the ellipsoid or above the sea [m]; the difference does not matter here.
    when : datetime
        Time of the photograph; local time is accurate enough.

    Returns
    -------
    float or None
        Bearing of magnetic north seen from true north, clockwise (east) positive, in [-180, 180] [degrees]:
        true heading = magnetic heading + declination. None for a time outside the model's years, 1900 to 2030.
    """
    years, _ = _table()
    year = _decimal_year(when)
    if not years[0] <= year <= years[-1]:
        return None
    north_nt, east_nt, _ = field_nt(latitude_deg, longitude_deg, altitude_m, year)
    return float(np.degrees(np.arctan2(east_nt, north_nt)))


def field_nt(latitude_deg: float, longitude_deg: float, altitude_m: float, year: float) -> tuple[float, float, float]:
    """Give the main field relative to the vertical of the ellipsoid.

    Parameters
    ----------
    latitude_deg, longitude_deg : float
        WGS 84 position [degrees].
    altitude_m : float
        Height above the ellipsoid [m].
    year : float
        Decimal year, 1900 to 2030.

    Returns
    -------
    north, east, down : float
        Components of the field [nT].
    """
    colatitude, radius_m, tilt = _geocentric(np.radians(latitude_deg), altitude_m)
    cosine, sine = _coefficients(year)
    degree_max = cosine.shape[0] - 1
    p, dp = schmidt_functions(colatitude, degree_max)
    degree = np.arange(degree_max + 1)
    # Exactly at the pole the east component is 0/0; a colatitude of 1e-9 gives its limit.
    longitude = np.radians(longitude_deg) * degree
    cos_m, sin_m = np.cos(longitude), np.sin(longitude)
    decay = (REFERENCE_RADIUS_M / radius_m) ** (degree + 2)
    radial = np.sum((degree + 1) * decay * np.sum((cosine * cos_m + sine * sin_m) * p, axis=1))
    south = -np.sum(decay * np.sum((cosine * cos_m + sine * sin_m) * dp, axis=1))
    east = np.sum(decay * np.sum(degree * (cosine * sin_m - sine * cos_m) * p, axis=1)) / np.sin(colatitude)
    north, down = -south, -radial
    return north * np.cos(tilt) + down * np.sin(tilt), east, down * np.cos(tilt) - north * np.sin(tilt)


def schmidt_functions(colatitude: float, degree_max: int) -> tuple[np.ndarray, np.ndarray]:
    """Give Schmidt semi-normalised Legendre functions P and dP/d(colatitude), each (degree_max + 1, degree_max + 1).

    The row is the degree n and the column the order m. The colatitude is in radians.
    """
    p = np.zeros((degree_max + 1, degree_max + 1))
    dp = np.zeros_like(p)
    p[0, 0] = 1.0
    cos_t, sin_t = np.cos(colatitude), np.sin(colatitude)
    for n in range(1, degree_max + 1):
        ratio = np.sqrt((2 * n - 1) / (2 * n)) if n > 1 else 1.0
        p[n, n] = ratio * sin_t * p[n - 1, n - 1]
        dp[n, n] = ratio * (sin_t * dp[n - 1, n - 1] + cos_t * p[n - 1, n - 1])
        for m in range(n):
            scale, before = np.sqrt(n * n - m * m), np.sqrt((n - 1) ** 2 - m * m) if m < n - 1 else 0.0
            p_before, dp_before = (p[n - 2, m], dp[n - 2, m]) if n > 1 else (0.0, 0.0)
            p[n, m] = ((2 * n - 1) * cos_t * p[n - 1, m] - before * p_before) / scale
            dp[n, m] = ((2 * n - 1) * (cos_t * dp[n - 1, m] - sin_t * p[n - 1, m]) - before * dp_before) / scale
    return p, dp


def _geocentric(latitude: float, altitude_m: float) -> tuple[float, float, float]:
    """Give the geocentric colatitude [rad], the radius [m], and the geodetic minus the geocentric latitude [rad]."""
    curvature_m = WGS84_SEMI_MAJOR_M / np.sqrt(1 - WGS84_E2 * np.sin(latitude) ** 2)
    axis_m = (curvature_m + altitude_m) * np.cos(latitude)
    up_m = (curvature_m * (1 - WGS84_E2) + altitude_m) * np.sin(latitude)
    colatitude = np.clip(np.arctan2(axis_m, up_m), 1e-9, np.pi - 1e-9)
    return colatitude, np.hypot(axis_m, up_m), latitude - (np.pi / 2 - colatitude)


def _decimal_year(when: datetime) -> float:
    when = when.replace(tzinfo=None)
    start, end = datetime(when.year, 1, 1), datetime(min(when.year + 1, datetime.max.year), 1, 1)
    return when.year + (when - start) / (end - start) if end > start else float(when.year)


def _coefficients(year: float) -> np.ndarray:
    """Give the Gauss coefficients g and h [nT] of a year, each (n, m), linearly interpolated between the epochs."""
    years, table = _table()
    after = int(np.clip(np.searchsorted(years, year, side="right"), 1, len(years) - 1))
    share = (year - years[after - 1]) / (years[after] - years[after - 1])
    return (1 - share) * table[:, after - 1] + share * table[:, after]


@lru_cache(maxsize=1)
def _table() -> tuple[np.ndarray, np.ndarray]:
    """Read the epochs (E,) and the coefficients g and h [nT] (2, E, n, m)."""
    with open(COEFFICIENTS_FILE, encoding="ascii") as file:
        lines = [line.split() for line in file if not line.startswith("#")]
    years = np.array(lines[0], float)
    degree_max = int(lines[-1][0])
    table = np.zeros((2, len(years), degree_max + 1, degree_max + 1))
    for n, m, *values in lines[1:]:
        table[int(int(m) < 0), :, int(n), abs(int(m))] = np.array(values, float)
    return years, table
