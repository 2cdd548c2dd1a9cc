"""The features' names, shapes and senses."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.skyline_appearance import measure
from skyline_viewshed.core.skyline_colour import learn_sky
from skyline_viewshed.core.skyline_evidence import shipped_weights
from skyline_viewshed.core.skyline_features import boundary_features


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
