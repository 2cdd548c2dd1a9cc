import numpy as np
import pytest
from skyline_viewshed.core.base.curves import correlation, curve_peaks, distinct_headings, sharpness


def test_sharpness_counts_standard_deviations_above_the_sidelobes():
    heading = np.arange(0.0, 360.0)
    curve = np.where(heading % 2 == 0, 0.1, -0.1)
    curve[100] = 1.0
    assert sharpness(heading, curve, 100.0) == pytest.approx(10.0, rel=0.01)


def test_correlation_of_short_or_straight_curves_is_unknown():
    assert correlation(np.ones(50), np.arange(50.0)) is None
    assert correlation(np.arange(5.0), np.arange(5.0)) is None
    assert correlation(np.arange(50.0), 3 - np.arange(50.0)) == pytest.approx(-1.0)


def test_distinct_headings_are_counted_across_north():
    assert distinct_headings(np.array([359.5, 0.4, 10.0]), np.array([1.0, 2.0, 0.5]), 1.5) == [1, 2]


def test_peaks_are_local_maxima_that_keep_their_distance():
    heading = np.arange(0.0, 360.0)
    curve = np.cos(np.radians(3 * heading)) + 0.1 * np.cos(np.radians(heading - 120))
    assert curve_peaks(heading, curve, 5.0) == [120, 1, 239]
    curve[[123, 60]] = 5.0, np.nan
    assert curve_peaks(heading, curve, 5.0) == [123, 1, 239]
    assert curve_peaks(heading, curve, 2.0) == [123, 120, 1, 239]
