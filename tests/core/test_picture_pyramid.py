from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.picture_pyramid import build_picture_pyramid


def ramp(height=64, width=96):
    y, x = np.mgrid[:height, :width]
    return np.stack([x * 2, y * 3, np.full(x.shape, 50)], -1).astype(np.uint8)


def test_levels_halve_and_keep_the_mean():
    picture = np.random.default_rng(0).integers(0, 256, (130, 201, 3)).astype(np.uint8)
    pyramid = build_picture_pyramid(picture)
    assert [level.shape[:2] for level in pyramid.levels] == [(130, 201), (65, 100), (32, 50), (16, 25)]
    assert pyramid.size_px == (201, 130)
    for level in pyramid.levels:
        assert level.mean() == pytest.approx(picture.mean(), abs=1.0)


def test_between_pixels_a_ramp_is_a_ramp_on_every_level():
    pyramid = build_picture_pyramid(ramp())
    x, y = np.array([20.25, 40.0, 61.5]), np.array([30.75, 10.0, 22.5])
    for footprint in (0.3, 1.0, 2.0, 4.0):
        colour = pyramid.sample(x, y, np.full(3, footprint))
        assert colour[:, 0] == pytest.approx(2 * x, abs=1.1) and colour[:, 1] == pytest.approx(3 * y, abs=1.6)
        assert colour[:, 2] == pytest.approx(50)


def test_edges_hold_their_colour_and_opacity_is_dropped():
    rgba = np.dstack([ramp(), np.full((64, 96), 9, np.uint8)])
    pyramid = build_picture_pyramid(rgba)
    colour = pyramid.sample(np.array([-5.0, 200.0]), np.array([-5.0, 200.0]), np.ones(2))
    assert colour.tolist() == [[0, 0, 50], [190, 189, 50]]


def test_a_tiny_picture_has_one_level():
    assert len(build_picture_pyramid(ramp(20, 20)).levels) == 1
