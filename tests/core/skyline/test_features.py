"""The features' names, shapes and senses."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.skyline.appearance import measure
from skyline_viewshed.core.skyline.colour import learn_sky
from skyline_viewshed.core.skyline.evidence import shipped_weights
from skyline_viewshed.core.skyline.features import (
    boundary_features,
    means_above_below,
    strongest_above,
    strongest_below,
    sum_above,
)


@pytest.fixture(scope="module")
def features():
    """Of a bright smooth sky over a dark rough ground, boundary at row 45."""
    rng = np.random.default_rng(0)
    picture = np.full((110, 90, 3), (140.0, 170.0, 220.0)) + rng.normal(0, 1, (110, 90, 3))
    picture[45:] = (70, 75, 50) + rng.normal(0, 25, (65, 90, 1))
    appearance = measure(np.clip(picture, 0, 255).astype(np.float32))
    return boundary_features(appearance, learn_sky(appearance))


def test_the_shipped_table_and_the_features_have_the_same_names(features):
    """No weight without a feature, no feature without a weight."""
    assert set(shipped_weights()) == set(features)


def test_every_feature_is_a_finite_map_of_the_pictures_size(features):
    """NaN in one would poison every row."""
    for name, values in features.items():
        assert values.shape == (110, 90), name
        assert np.isfinite(values).all(), name


@pytest.mark.parametrize("name", ["edge_0.8", "line_6", "sky_over_ground_9", "sky_over_ground_81"])
def test_the_boundary_is_the_maximum_of_what_speaks_for_it(features, name):
    """Sky above, ground below, an edge between."""
    assert abs(np.median(features[name].argmax(0)) - 45) <= 1


def test_only_row_zero_can_leave_the_frame(features):
    """These three speak for no other row."""
    for name in ("leaves_frame", "leaves_frame_ground", "leaves_frame_rough"):
        assert not features[name][1:].any()
    assert (features["leaves_frame"][0] == 1).all()


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
