"""Edges, long edges and texture of drawn pictures."""

from __future__ import annotations

import numpy as np
from skyline_viewshed.core.skyline.appearance import EDGE_SIGMAS_PX, measure


def step_picture(contrast, noise, seed=0, height=100, width=140, row=40):
    rng = np.random.default_rng(seed)
    picture = np.full((height, width, 3), 150.0)
    picture[row:] -= contrast
    return (picture + rng.normal(0, noise, picture.shape)).astype(np.float32)


def test_a_step_shows_at_its_row_at_every_scale():
    """Row y is the first of the lower side."""
    seen = measure(step_picture(60, 1))
    for sigma in EDGE_SIGMAS_PX:
        assert np.median(seen.edges[sigma].argmax(0)) == 40
    for half in seen.long_edges:
        assert np.median(seen.long_edges[half].argmax(0)) == 40


def test_edges_count_in_units_of_the_pictures_own_noise():
    """The same step is worth less in a noisy picture."""
    quiet, noisy = measure(step_picture(40, 1)), measure(step_picture(40, 12))
    assert quiet.edges[1.6][40].mean() > noisy.edges[1.6][40].mean()


def test_a_faint_long_edge_stands_out_where_a_small_window_sees_noise():
    """A step of half the noise's size: the line finds its row more often than the point does."""
    seen = measure(step_picture(5, 6))
    by_line = np.abs(seen.long_edges[12].argmax(0) - 40) <= 2
    by_point = np.abs(seen.edges[0.8].argmax(0) - 40) <= 2
    assert by_line.mean() > by_point.mean() + 0.3


def test_texture_grows_with_contrast():
    """Flat, fine noise, coarse noise."""
    levels = [measure(step_picture(0, noise)).texture.mean() for noise in (0, 3, 12)]
    assert levels[0] < levels[1] < levels[2]
