"""The picture that is draped: its levels, and what of it shows sky."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.model import Skyline, SkylineEvidence
from skyline_viewshed.core.mapping.picture import build_picture_pyramid, sky_of

HEIGHT, WIDTH = 40, 30


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


def evidence(row, sky_score=None, **more):
    """Evidence that is sure of one row in every column; None makes a column flat."""
    probability = np.zeros((HEIGHT, WIDTH), np.float32)
    for column, first in enumerate(np.broadcast_to(row, WIDTH)):
        probability[:, column] = 1 / HEIGHT if first is None else np.arange(HEIGHT) == first
    best = Skyline(np.zeros(WIDTH), np.ones(WIDTH), WIDTH, HEIGHT)
    return SkylineEvidence(probability, best, WIDTH, HEIGHT, sky_score=sky_score, **more)


def test_sky_lies_above_the_skyline_and_looks_like_sky():
    score = np.ones((HEIGHT, WIDTH), np.float32)
    score[:, :10] = -1  # a cloud, or a pale range
    sky = sky_of(evidence(25, score))
    assert not sky[:, :10].any() and sky[:25, 10:].all() and not sky[25:].any()


def test_a_column_that_leaves_the_frame_has_no_sky():
    found = evidence(25)
    gone = replace(found, probability=found.probability * 0.2, leaves_frame=np.full(WIDTH, 0.8, np.float32))
    assert sky_of(found).any() and not sky_of(gone).any()


def test_ground_between_two_lines_is_no_sky():
    near_crest, range_behind = evidence(30), evidence(12)
    sky = sky_of(replace(near_crest, rival=range_behind))
    assert sky[:12].all() and not sky[12:].any()


def test_without_a_skyline_nothing_is_sky():
    assert not build_picture_pyramid(ramp()).is_sky(np.array([0.0, 0.5]), np.array([0.0, 0.1])).any()


def test_positions_are_shares_of_a_mask_of_any_size():
    sky = np.zeros((4, 8), bool)
    sky[0, :4] = True
    picture = build_picture_pyramid(ramp(), sky=sky)
    assert picture.is_sky(np.array([0.0, 0.49, 0.51, 1.0]), np.array([0.1, 0.24, 0.1, 1.0])).tolist() == [
        True, True, False, False,
    ]  # fmt: skip
