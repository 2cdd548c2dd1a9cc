"""The range of mountains for first steps."""

import numpy as np
import pytest
from skyline_viewshed.core.simulate.example import example_terrain


def test_the_example_range_is_reproducible():
    np.testing.assert_array_equal(example_terrain(3).elevation_m, example_terrain(3).elevation_m)
    assert np.ptp(example_terrain(3, relief_m=1000).elevation_m) == pytest.approx(1000, rel=1e-3)
