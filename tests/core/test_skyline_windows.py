"""Running sums against loops."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.skyline_windows import means_above_below, strongest_above, strongest_below, sum_above


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 12), st.integers(1, 15), st.integers(0, 99))
def test_window_means_repeat_the_end_rows(height, window_px, seed):
    """Row by row with clipped indices, windows longer than the picture included."""
    values = np.random.default_rng(seed).normal(size=(height, 3))
    above, below = means_above_below(values, window_px)
    for y in range(height):
        up = np.clip(np.arange(y - window_px, y), 0, height - 1)
        down = np.clip(np.arange(y, y + window_px), 0, height - 1)
        np.testing.assert_allclose(above[y], values[up].mean(0), atol=1e-5)
        np.testing.assert_allclose(below[y], values[down].mean(0), atol=1e-5)


def test_several_channels_are_averaged_at_once():
    """A stack gives what its channels give one by one."""
    values = np.random.default_rng(1).normal(size=(20, 7, 3))
    above, below = means_above_below(values, 4)
    for channel in range(3):
        one = means_above_below(values[..., channel], 4)
        np.testing.assert_allclose(above[..., channel], one[0])
        np.testing.assert_allclose(below[..., channel], one[1])


def test_sums_and_maxima_look_only_upwards():
    """A single bright pixel shows below itself, with the gap, and nowhere else."""
    values = np.zeros((10, 1))
    values[3] = 5
    assert sum_above(values)[:, 0].tolist() == [0] * 4 + [5] * 6
    assert strongest_above(values)[:, 0].tolist() == [0] * 7 + [5] * 3
    assert strongest_below(values, 2)[:, 0].tolist() == [5, 5] + [0] * 8


@pytest.mark.parametrize("height", [1, 3, 4])
def test_pictures_lower_than_the_gap_have_nothing_above(height):
    """No row lies far enough above any other."""
    assert not strongest_above(np.ones((height, 2))).any()
