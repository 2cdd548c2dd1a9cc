from dataclasses import replace

import pytest
from skyline_viewshed.core.compass import CompassOptions, compass_prior, true_heading_deg
from skyline_viewshed.core.match_prior import log_ratio
from skyline_viewshed.core.model import PhotoMetadata

READING = PhotoMetadata("a.jpg", 400, 300, compass_heading_deg=355.0, compass_reference="M")


def test_a_magnetic_reading_is_turned_by_the_declination():
    assert true_heading_deg(READING, 15.0) == pytest.approx(10.0)


def test_a_magnetic_reading_without_declination_is_not_passed_off_as_true():
    assert true_heading_deg(READING) is None


@pytest.mark.parametrize("reference", ["T", None])
def test_other_readings_are_taken_as_they_are(reference):
    assert true_heading_deg(replace(READING, compass_reference=reference), 15.0) == 355.0


def test_no_reading_gives_no_prior():
    assert compass_prior(true_heading_deg(replace(READING, compass_heading_deg=None))) is None


def test_the_prior_prefers_the_reading_and_then_its_quarter_turns():
    prior = compass_prior(100.0)
    assert log_ratio(prior, 100.0) > log_ratio(prior, 190.0) > log_ratio(prior, 145.0)


def test_an_overconfident_compass_is_refused():
    with pytest.raises(ValueError, match="5 degrees"):
        CompassOptions(sigma_deg=2)
