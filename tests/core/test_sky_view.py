from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.sky_view import sky_view_factor


def factor(elevation_deg):
    return sky_view_factor(SimpleNamespace(elevation_deg=np.asarray(elevation_deg, float)))


def test_open_sky_is_one_and_ground_below_the_plane_does_not_matter():
    assert factor([0.0] * 8) == 1.0
    assert factor([-30.0, -1.0, 0.0]) == 1.0


@pytest.mark.parametrize("angle_deg", [10.0, 45.0, 80.0])
def test_a_pit_of_even_depth_has_the_closed_form(angle_deg):
    assert factor([angle_deg] * 360) == pytest.approx(np.cos(np.radians(angle_deg)) ** 2)


def test_it_equals_the_integral_over_the_hemisphere():
    azimuth = np.radians(np.arange(0, 360, 0.5))
    horizon = np.degrees(0.4 + 0.3 * np.sin(azimuth))
    zenith = np.radians(np.arange(0.05, 90, 0.1))
    open_sky = zenith[None, :] < np.radians(90 - horizon)[:, None]
    light = (open_sky * np.cos(zenith) * np.sin(zenith)).sum() * np.radians(0.1) * np.radians(0.5) / np.pi
    assert factor(horizon) == pytest.approx(light, abs=2e-3)


def test_unknown_directions_are_left_out():
    assert factor([60.0, np.nan]) == pytest.approx(0.25)
    assert np.isnan(factor([np.nan]))
