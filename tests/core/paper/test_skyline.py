"""The published extraction, step by step on drawn pictures, and to the letter against a second writing of it."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.paper.skyline import (
    PaperSkylineOptions,
    extract_skyline_paper,
    first_terrain_row,
    sky_mask,
    smooth_rows,
)


def scene(row_px, height=240, seed=0):
    """Smooth sky above `row_px`, coarse bright-and-dark rock below, uint8 RGB."""
    rng = np.random.default_rng(seed)
    width = len(row_px)
    blocks = rng.integers(0, 2, (height // 12 + 1, width // 12 + 1)) * 200 + 20
    rock = np.kron(blocks, np.ones((12, 12)))[:height, :width]
    y = np.arange(height)[:, None]
    grey = np.where(y < np.asarray(row_px), 190 + 0.1 * y, rock)
    return np.repeat(grey.astype(np.uint8)[..., None], 3, 2)


def test_a_drawn_ridge_is_found_within_the_filters_reach():
    """The 9 and 15 px filters and the erosion blur a ridge by less than their summed half widths."""
    x = np.arange(320)
    truth = 120 + 25 * np.sin(x / 50)
    found = extract_skyline_paper(scene(truth))
    assert found.row_px.shape == found.confidence.shape == (320,)
    assert np.median(np.abs(found.row_px - truth)) < 12
    assert (found.width_px, found.height_px) == (320, 240)


def test_the_mask_follows_the_published_operators():
    """A second, direct writing of grey, box, median, Laplacian, threshold and erosion on a small picture."""
    rng = np.random.default_rng(5)
    grey = np.clip(130 + np.cumsum(rng.normal(0, 12, (30, 40)), 1), 0, 255).astype(np.uint8)

    def windows(image, width, height, mode):
        padded = np.pad(image, ((height // 2,) * 2, (width // 2,) * 2), mode=mode)
        return np.lib.stride_tricks.sliding_window_view(padded, (height, width))

    box = np.rint(windows(grey.astype(float), 9, 9, "reflect").mean((2, 3))).astype(np.uint8)
    median = np.median(windows(box, 15, 15, "edge").reshape(30, 40, -1), 2)
    padded = np.pad(median, 1, mode="reflect")
    lap = padded[:-2, 1:-1] + padded[2:, 1:-1] + padded[1:-1, :-2] + padded[1:-1, 2:] - 4 * median
    smooth = np.abs(lap) < 2.0
    expected = windows(np.pad(smooth, ((1, 1), (4, 4)), constant_values=True), 9, 3, "constant")
    expected = expected[1:-1, 4:-4].all((2, 3))
    found = sky_mask(np.repeat(grey[..., None], 3, 2), PaperSkylineOptions(laplacian_threshold=2.0))
    assert 0 < expected.mean() < 1
    np.testing.assert_array_equal(found, expected)


def test_the_first_transition_counts_and_everything_below_it_is_terrain():
    """A tree top above the ridge wins; terrain at the very top of a column is no transition."""
    sky = np.array([[1, 0, 1, 0], [1, 1, 1, 0], [0, 1, 1, 0], [1, 0, 1, 0], [0, 0, 1, 0]], bool)
    np.testing.assert_array_equal(first_terrain_row(sky), [2, 3, np.nan, np.nan])


def test_a_spike_is_interpolated_and_a_small_step_stays():
    """Columns that differ by more than 20 px from their left neighbour are flagged, and only those."""
    row_px = np.full(60, 100.0)
    row_px[30] = 10
    row_px[45:] = 115
    smooth, kept = smooth_rows(row_px, PaperSkylineOptions(smoothing_px=1))
    np.testing.assert_array_equal(np.flatnonzero(~kept), [30, 31])
    np.testing.assert_allclose(smooth[:45], 100)
    np.testing.assert_allclose(smooth[45:], 115)


@pytest.mark.parametrize("grey", [0, 128, 255])
def test_a_picture_without_a_transition_is_refused(grey):
    """All smooth: nothing to find."""
    with pytest.raises(SkylineNotFoundError, match="smooth region"):
        extract_skyline_paper(np.full((60, 80, 3), grey, np.uint8))


@pytest.mark.parametrize("shape", [(1, 1, 3), (1, 50, 3), (50, 1, 3), (3, 3, 3)])
def test_tiny_pictures_are_refused_or_answered_without_a_crash(shape):
    """Noise of any size gives a skyline of that width or the plain error."""
    noise = np.random.default_rng(0).integers(0, 256, shape, dtype=np.uint8)
    try:
        assert extract_skyline_paper(noise).row_px.shape == (shape[1],)
    except SkylineNotFoundError:
        assert shape[0] < 16


@pytest.mark.parametrize("wrong", [{"box_px": 8}, {"laplacian_threshold": 0}, {"passes": -1}, {"median_px": -3}])
def test_options_out_of_range_are_refused(wrong):
    """Even windows and negative numbers are programming errors."""
    with pytest.raises(ValueError):
        PaperSkylineOptions(**wrong)
