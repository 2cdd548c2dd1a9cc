import numpy as np
import pytest
from skyline_viewshed.core.base.curves import correlation, sharpness


def test_sharpness_counts_standard_deviations_above_the_sidelobes():
    heading = np.arange(0.0, 360.0)
    curve = np.where(heading % 2 == 0, 0.1, -0.1)
    curve[100] = 1.0
    assert sharpness(heading, curve, 100.0) == pytest.approx(10.0, rel=0.01)


def test_correlation_of_short_or_straight_curves_is_unknown():
    assert correlation(np.ones(50), np.arange(50.0)) is None
    assert correlation(np.arange(5.0), np.arange(5.0)) is None
    assert correlation(np.arange(50.0), 3 - np.arange(50.0)) == pytest.approx(-1.0)
