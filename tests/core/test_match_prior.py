import numpy as np
import pytest
from skyline_viewshed.core.match_prior import log_ratio
from skyline_viewshed.core.prior import HeadingPrior


def test_the_density_integrates_to_one_over_the_circle():
    prior = HeadingPrior(350.0, 12.0, 0.1, ((90.0, 0.03), (-90.0, 0.03), (180.0, 0.02)))
    heading = np.arange(0, 360, 0.1)
    assert np.exp(log_ratio(prior, heading)).mean() == pytest.approx(1.0, rel=1e-6)


def test_no_prior_is_worth_nothing():
    assert (log_ratio(None, np.arange(5)) == 0).all()


def test_nothing_is_forbidden_beyond_the_share_of_worthless_readings():
    prior = HeadingPrior(10.0, 10.0, 0.1)
    assert log_ratio(prior, 190.0) == pytest.approx(np.log(0.1), abs=1e-6)


def test_a_reading_turned_by_a_quarter_is_recognised():
    prior = HeadingPrior(10.0, 10.0, 0.1, ((90.0, 0.02), (-90.0, 0.02)))
    assert log_ratio(prior, 100.0) > log_ratio(prior, 60.0)
    assert log_ratio(prior, 280.0) == pytest.approx(log_ratio(prior, 100.0))
