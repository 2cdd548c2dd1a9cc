"""Recorded altitudes against the DEM: wrong units, datums and places."""

from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.base.heights import altitude_limit_m, contradiction, doubt_of_run
from skyline_viewshed.core.base.model import PhotoMetadata

TRUE_M = np.array([2200.0, 2450.0, 3100.0, 2800.0, 3550.0])
ERROR_M = np.array([12.0, -25.0, 31.0, -8.0, 4.0])


@pytest.mark.parametrize(
    "factor, unit",
    [
        (1 / 0.3048, "feet"),
        (3937 / 1200, "feet"),
        (10, "decimetres"),
        (100, "centimetres"),
        (1e3, "millimetres"),
        (1e-3, "kilometres"),
    ],
)
def test_the_unit_of_the_dem_is_named(factor, unit):
    text = doubt_of_run(TRUE_M + ERROR_M, TRUE_M * factor)
    assert f"as if its heights were in {unit}" in text
    assert "median of 5 photos" in text
    assert "DEM_UNIT" in text


def test_one_photo_suffices_for_a_unit():
    assert "in feet" in doubt_of_run([4477.0], [14755.0])


def test_altitudes_in_feet_are_told_apart_from_a_dem_in_feet():
    assert "as if these were in feet" in doubt_of_run((TRUE_M + ERROR_M) / 0.3048, TRUE_M)


@pytest.mark.parametrize("shift", [105.0, -120.0])
def test_one_and_the_same_shift_names_the_datum(shift):
    assert "ellipsoid" in doubt_of_run(TRUE_M + ERROR_M + shift, TRUE_M)


@pytest.mark.parametrize("ground", [[45.0, 31.0, 60.0, 12.0, 44.0], [900.0, 3900.0, 1200.0, 4700.0, 1000.0]])
def test_anything_else_is_said_without_a_guess(ground):
    text = doubt_of_run(TRUE_M, ground)
    assert "Check that the DEM holds heights" in text
    assert "as if" not in text


@pytest.mark.parametrize("altitudes", [TRUE_M + ERROR_M, TRUE_M - 90, np.zeros(5), []])
def test_usual_errors_unknown_altitudes_and_empty_runs_are_no_doubt(altitudes):
    assert doubt_of_run(altitudes, TRUE_M[: len(altitudes)]) is None


def test_one_bad_altitude_among_many_is_no_doubt():
    assert doubt_of_run(TRUE_M + [900, 0, 0, 0, 0], TRUE_M) is None


def metadata(altitude_m, reference="sea level"):
    return PhotoMetadata("a.jpg", 4000, 3000, altitude_m=altitude_m, altitude_reference=reference)


def told(altitude_m, ground_m=2000.0, eye_m=None, use_altitude=False, reference="sea level"):
    request = SimpleNamespace(eye_elevation_m=eye_m, use_altitude=use_altitude)
    photo = metadata(altitude_m, reference)
    limit_m = altitude_limit_m(photo, cell_m=90.0, gps_limit_m=150.0, position_error_m=8.0)
    return contradiction(request, photo, SimpleNamespace(ground_elevation_m=ground_m), limit_m)


def test_an_altitude_beyond_what_gps_and_dem_allow_contradicts():
    assert "326 m below the DEM's surface" in told(2000.0 - 326)
    assert "1000 m above the DEM's surface" in told(3000.0)
    for altitude_m in (2000.0 - 200, 2000.0 + 200, None, 0.0):
        assert told(altitude_m) is None
    assert told(1000.0, ground_m=None) is None


def test_ellipsoidal_altitudes_may_be_off_by_the_geoid():
    assert told(2000.0 + 300, reference="ellipsoid") is None
    assert told(2000.0 + 300) is not None


def test_a_drone_may_be_high_but_not_below_the_ground():
    assert told(3000.0, use_altitude=True) is None
    assert "below" in told(1000.0, use_altitude=True)


def test_a_given_elevation_replaces_the_recorded_one():
    assert told(500.0, eye_m=2500.0) is None
    assert "given elevation of the camera lies 700 m below" in told(2000.0, eye_m=1300.0)
