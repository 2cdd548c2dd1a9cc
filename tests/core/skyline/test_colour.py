"""The picture's own colour model: clusters, densities, and what is sky."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.skyline.appearance import measure
from skyline_viewshed.core.skyline.colour import NOISE_FLOOR, k_means, learn_sky, sky_log_ratio


def test_well_separated_clusters_are_told_apart():
    """Four tight clouds of points get four labels, whatever their sizes."""
    rng = np.random.default_rng(2)
    truth = np.repeat(np.arange(4), (50, 400, 90, 200))
    centres = np.array([[0, 0], [30, 2], [60, -3], [95, 1]], float)
    label = k_means(centres[truth] + rng.normal(size=(len(truth), 2)), 4)
    pairs = set(zip(truth.tolist(), label.tolist()))
    assert len(pairs) == 4


@settings(max_examples=30, deadline=None)
@given(st.integers(1, 6), st.integers(1, 40), st.integers(1, 3))
def test_degenerate_colour_sets_are_clustered_without_a_fault(clusters, count, distinct):
    """Fewer distinct points than clusters, one point, one colour."""
    points = np.random.default_rng(0).normal(size=(distinct, 4))[np.arange(count) % distinct]
    label = k_means(points, clusters)
    assert label.shape == (count,)
    assert label.min() >= 0
    assert label.max() < clusters
    for group in np.unique(label):  # identical points never part
        same = np.unique(points[label == group], axis=0)
        for other in np.setdiff1d(np.unique(label), group):
            rest = np.unique(points[label == other], axis=0)
            assert not (same[:, None] == rest[None]).all(2).any()


def test_the_ratio_of_two_single_gaussian_clouds_is_that_of_their_densities():
    """A second writing of the density: one cluster a side, covariance plus noise floor, t-like tails."""
    rng = np.random.default_rng(3)
    pixels = rng.normal(size=(60, 50, 4)).astype(np.float32) * (5, 2, 2, 0.3)
    pixels[:30] += (20, 0, -5, -1)
    is_sky = np.zeros((60, 50), bool)
    is_sky[:30] = True
    found = sky_log_ratio(pixels.astype(np.float32), is_sky, ~is_sky, clusters=1)

    def log_density(sample, x):
        precision = np.linalg.inv(np.cov(sample.T) + np.diag(NOISE_FLOOR))
        offset = x - sample.mean(0)
        distance2 = np.einsum("...i,ij,...j->...", offset, precision, offset)
        return 0.5 * np.log(np.linalg.det(precision)) - 4 * np.log1p(distance2 / 6)

    sky, ground = pixels[:30].reshape(-1, 4), pixels[30:].reshape(-1, 4)
    expected = log_density(sky.astype(float), pixels) - log_density(ground.astype(float), pixels)
    np.testing.assert_allclose(found, expected, atol=2e-3)


def test_too_few_pixels_teach_nothing():
    """Fewer than 200 on one side."""
    pixels = np.zeros((30, 30, 4), np.float32)
    is_sky = np.zeros((30, 30), bool)
    is_sky[:5] = True
    assert sky_log_ratio(pixels, is_sky, ~is_sky) is None


@pytest.mark.parametrize("sky_rgb", [(120, 160, 220), (235, 235, 235), (60, 40, 60), (200, 180, 140)])
def test_sky_is_learned_whatever_its_colour(sky_rgb):
    """Blue, overcast, dusk, sepia over mottled ground: the sign tells sky from ground nearly everywhere."""
    rng = np.random.default_rng(4)
    height, width = 120, 160
    ridge = 50 + 12 * np.sin(np.arange(width) / 15)
    is_sky = np.arange(height)[:, None] < ridge
    ground = rng.normal(90, 30, (height, width, 1)) * (1, 0.95, 0.8)
    picture = np.where(is_sky[..., None], np.array(sky_rgb) + rng.normal(0, 1.5, (height, width, 3)), ground)
    ratio = learn_sky(measure(np.clip(picture, 0, 255).astype(np.float32)))
    assert np.mean((ratio > 0) == is_sky) > 0.95


def test_a_picture_of_one_colour_teaches_nothing_and_harms_nothing():
    """Finite, and without preference where sky and ground are the same."""
    ratio = learn_sky(measure(np.full((80, 90, 3), 127, np.float32)))
    assert np.isfinite(ratio).all()
    assert np.abs(ratio).max() < 1
