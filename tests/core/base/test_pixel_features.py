"""Features drawn on photographs: whose they are, and which way their rows count."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.pixel_features import PixelFeature, downward, ellipse, open_ring

SQUARE = np.array([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]])


def test_only_points_lines_and_polygons_can_be_drawn():
    with pytest.raises(ValueError, match="circle"):
        PixelFeature("a.jpg", "circle", (SQUARE,))


def test_rows_that_qgis_counts_upwards_are_turned_down():
    """QGIS has the upper left corner at (0, 0) and y negative inside; here the first pixel's centre is at (0, 0)."""
    drawn = SQUARE * [1, -1] + [0.5, -0.5]
    (turned,) = downward((drawn,))
    assert turned == pytest.approx(SQUARE)
    assert downward((SQUARE,))[0] is SQUARE
    assert downward(()) == ()


def test_a_hole_at_the_top_is_turned_with_its_polygon():
    outer, inner = SQUARE * [1, -10] - [0, 1], np.array([[1.0, -0.6], [2.0, -0.6], [2.0, -0.9]])
    turned = downward((outer, inner))
    assert turned[1][:, 1] == pytest.approx([0.1, 0.1, 0.4])


def test_a_closed_ring_is_opened_once():
    closed = np.vstack([SQUARE, SQUARE[:1]])
    assert np.array_equal(open_ring(closed), SQUARE)
    assert np.array_equal(open_ring(SQUARE), SQUARE)
    assert open_ring(SQUARE[:1]).shape == (1, 2) and open_ring([]).shape == (0, 2)


def test_a_turned_ellipse_has_its_long_axis_where_via_draws_it():
    """VIA turns the canvas, whose y points down, by theta: a long axis along x then points down to the right."""
    turned = ellipse((10.0, 20.0), 8.0, 2.0, np.pi / 6) - (10.0, 20.0)
    far = turned[np.argmax(turned[:, 0])]
    assert np.degrees(np.arctan2(far[1], far[0])) == pytest.approx(30, abs=3)
    assert np.hypot(*turned.T).max() == pytest.approx(8)
