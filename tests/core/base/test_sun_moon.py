from __future__ import annotations

from datetime import datetime, timedelta, timezone

import numpy as np
import pytest
from skyline_viewshed.core.base.sun_moon import (
    direction_deg,
    moon_direction_deg,
    moon_ecliptic,
    refraction_deg,
    sun_direction_deg,
)


@pytest.mark.parametrize(
    "when, longitude, latitude, azimuth, elevation",
    [
        # Noon at Greenwich on the solstices: 90 - 51.48 +- 23.44; the equation of time is -1.8 and +1.8 minutes.
        (datetime(2024, 6, 20, 12, 1, 48), 0.0, 51.48, 180.0, 61.96),
        (datetime(2024, 12, 21, 11, 58, 10), 0.0, 51.48, 180.0, 15.08),
    ],
)
def test_the_sun_stands_where_the_almanac_puts_it(when, longitude, latitude, azimuth, elevation):
    found_azimuth, found_elevation = sun_direction_deg(longitude, latitude, when)
    assert found_azimuth == pytest.approx(azimuth, abs=0.4)
    assert found_elevation == pytest.approx(elevation, abs=0.03)


def test_the_sun_is_overhead_where_the_almanac_puts_it():
    """Meeus, example 25.a (1992 October 13.0): ra 198.38083, dec -7.78507 degrees; sidereal time at Greenwich 21.88."""
    _, at_zenith = sun_direction_deg(176.50, -7.785, datetime(1992, 10, 13))
    assert at_zenith == pytest.approx(90.0, abs=0.15)


def test_time_zones_are_obeyed():
    utc = datetime(2024, 3, 1, 9, 0, tzinfo=timezone.utc)
    nepal = utc.astimezone(timezone(timedelta(hours=5, minutes=45)))
    assert sun_direction_deg(86.8, 27.9, utc) == sun_direction_deg(86.8, 27.9, nepal)
    assert moon_direction_deg(86.8, 27.9, utc) == moon_direction_deg(86.8, 27.9, nepal)


def test_the_moon_of_a_worked_example():
    """Meeus, example 47.a (1992 April 12.0): longitude 133.162655, latitude -3.229126 degrees, 368 409.7 km."""
    longitude, latitude, distance = moon_ecliptic(2448724.5 - 2451545.0)
    assert longitude == pytest.approx(133.1627, abs=0.03) and latitude == pytest.approx(-3.2291, abs=0.01)
    assert distance == pytest.approx(368_409.7, rel=5e-4)


@pytest.mark.parametrize(
    "when, longitude, latitude",
    [  # greatest eclipse, from NASA's catalogue of solar eclipses
        (datetime(2009, 7, 22, 2, 35, 19), 144.1, 24.2),
        (datetime(2017, 8, 21, 18, 25, 32), -87.7, 37.0),
        (datetime(2024, 4, 8, 18, 17, 16), -104.1, 25.3),
    ],
)
def test_the_moon_covers_the_sun_during_a_total_eclipse(when, longitude, latitude):
    """Independent of every formula here: both are in the same direction, as seen from the surface."""
    sun, moon = (np.radians(body(longitude, latitude, when)) for body in (sun_direction_deg, moon_direction_deg))
    apart = np.hypot((sun[0] - moon[0]) * np.cos(sun[1]), sun[1] - moon[1])
    assert np.degrees(apart) < 0.06


def test_refraction_lifts_a_body_at_the_horizon_by_its_diameter_and_none_overhead():
    assert refraction_deg(0.0) == pytest.approx(0.48, abs=0.02)
    assert refraction_deg(45.0) == pytest.approx(1 / 60, abs=0.001)
    assert abs(refraction_deg(90.0)) < 1e-3


def test_the_apparent_direction_is_the_true_one_with_refraction():
    when = datetime(2024, 6, 20, 5, 0)
    azimuth, elevation = sun_direction_deg(7.0, 45.8, when)
    assert direction_deg("sun", 7.0, 45.8, when) == (azimuth, elevation + refraction_deg(elevation))
    assert direction_deg("moon", 7.0, 45.8, when)[0] == moon_direction_deg(7.0, 45.8, when)[0]
