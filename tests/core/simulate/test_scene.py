from __future__ import annotations

from datetime import datetime, timedelta, timezone

import pytest
from skyline_viewshed.core.simulate.scene import SceneOptions, sun_direction_deg


@pytest.mark.parametrize(
    "when, longitude, latitude, azimuth, elevation",
    [
        # Noon at Greenwich on the solstices: 90 - 51.48 +- 23.44; the equation of time is -1.8 and +1.8 minutes.
        (datetime(2024, 6, 20, 12, 1, 48), 0.0, 51.48, 180.0, 61.96),
        (datetime(2024, 12, 21, 11, 58, 10), 0.0, 51.48, 180.0, 15.08),
        # Worked example of Meeus, Astronomical Algorithms (1992 October 13.0): ra 198.38083, dec -7.78507 degrees.
        (datetime(1992, 10, 13, 0, 0), 177.13, -7.785, None, 90.0),
    ],
)
def test_the_sun_stands_where_the_almanac_puts_it(when, longitude, latitude, azimuth, elevation):
    found_azimuth, found_elevation = sun_direction_deg(longitude, latitude, when)
    if azimuth is None:
        # Sidereal time at Greenwich then is 21.88 degrees, so the sun is overhead at 198.38 - 21.88 = 176.50 east.
        _, at_zenith = sun_direction_deg(176.50, latitude, when)
        assert at_zenith == pytest.approx(90.0, abs=0.15)
        return
    assert found_azimuth == pytest.approx(azimuth, abs=0.4)
    assert found_elevation == pytest.approx(elevation, abs=0.03)


def test_time_zones_are_obeyed():
    utc = datetime(2024, 3, 1, 9, 0, tzinfo=timezone.utc)
    nepal = utc.astimezone(timezone(timedelta(hours=5, minutes=45)))
    assert sun_direction_deg(86.8, 27.9, utc) == sun_direction_deg(86.8, 27.9, nepal)


@pytest.mark.parametrize(
    "wrong", [{"clouds": "rain"}, {"foreground": "cows"}, {"range_m": 0}, {"noise": -1}, {"cloud_share": 2}]
)
def test_senseless_options_are_refused(wrong):
    with pytest.raises(ValueError, match="must"):
        SceneOptions(**wrong)
