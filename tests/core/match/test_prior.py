from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import FOCAL_SIGMA
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.match.prior import (
    CompassOptions,
    HeadingPrior,
    RollPrior,
    camera_prior,
    compass_prior,
    log_ratio,
    true_heading_deg,
)


def test_the_density_integrates_to_one_over_the_circle():
    prior = HeadingPrior(350.0, 12.0, 0.1, ((90.0, 0.03), (-90.0, 0.03), (180.0, 0.02)), wide_share=0.2)
    heading = np.arange(0, 360, 0.1)
    assert np.exp(log_ratio(prior, heading)).mean() == pytest.approx(1.0, rel=1e-6)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_the_share_of_worthless_readings_leaves_the_ratios_of_all_others(share):
    usual, options = CompassOptions(), CompassOptions().with_outliers(share)
    heading = np.arange(0, 360, 0.1)
    density, before = (np.exp(log_ratio(compass_prior(40.0, one), heading)) for one in (options, usual))
    assert density.mean() == pytest.approx(1.0, rel=1e-6)
    right = (before - usual.outlier_share) / (1 - usual.outlier_share)
    np.testing.assert_allclose(density, share + (1 - share) * right, rtol=1e-6)
    assert (options == usual) == (share == usual.outlier_share)


def test_no_prior_is_worth_nothing():
    assert (log_ratio(None, np.arange(5)) == 0).all()


def test_nothing_is_forbidden_beyond_the_share_of_worthless_readings():
    prior = HeadingPrior(10.0, 10.0, 0.1)
    assert log_ratio(prior, 190.0) == pytest.approx(np.log(0.1), abs=1e-6)


def test_a_reading_turned_by_a_quarter_is_recognised():
    prior = HeadingPrior(10.0, 10.0, 0.1, ((90.0, 0.02), (-90.0, 0.02)))
    assert log_ratio(prior, 100.0) > log_ratio(prior, 60.0)
    assert log_ratio(prior, 280.0) == pytest.approx(log_ratio(prior, 100.0))


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


def test_the_wide_part_of_the_core_counts_in_its_spread():
    assert HeadingPrior(10.0, 5.0).spread_deg == 5.0
    assert HeadingPrior(10.0, 5.0, wide_share=0.3).spread_deg == pytest.approx(5 * np.sqrt(0.7 + 0.3 * 9))
    near, wide = (log_ratio(HeadingPrior(10.0, 5.0, wide_share=share), 35.0) for share in (0.0, 0.3))
    assert wide > near


def test_a_small_roll_costs_as_much_as_a_gaussian_and_a_large_one_less():
    prior = RollPrior()
    rolls_deg = np.array([0.0, 1.0, -1.0, 15.0])
    cost, gaussian = prior.cost(rolls_deg), 0.5 * np.square(rolls_deg / prior.sigma_deg)
    assert cost[0] == 0 and cost[1] == cost[2] == pytest.approx(gaussian[1], rel=0.05)
    assert 0.3 * gaussian[3] < cost[3] < 0.6 * gaussian[3]


def test_only_ultra_wide_lenses_have_a_wider_spread_of_the_focal_length():
    spread = {
        mm: camera_prior(PhotoMetadata("a.jpg", 4000, 3000, focal_length_35mm=mm)).focal_sigma for mm in (13, 18, 26)
    }
    assert spread[13] > spread[18] == spread[26] == FOCAL_SIGMA
