"""Evidence supplied by a mask or a drawn line."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.skyline.given import evidence_from_line, evidence_from_mask


def test_a_masks_edge_is_the_likeliest_row_at_any_resolution():
    """A mask a quarter of the photo's size and one of full size give the same rows of the reduced picture."""
    x = (np.arange(2048) + 0.5) / 2048
    edge = 0.4 + 0.1 * np.sin(8 * x)
    full = ((np.arange(1536)[:, None] + 0.5) / 1536 < edge).astype(np.uint8) * 255
    large = evidence_from_mask(full)
    small = evidence_from_mask(full[::4, ::4], 2048, 1536)
    assert large.probability.shape == small.probability.shape == (384, 512)
    assert (large.width_px, large.height_px) == (small.width_px, small.height_px) == (2048, 1536)
    truth = (0.4 + 0.1 * np.sin(8 * (np.arange(512) + 0.5) / 512)) * 384
    assert np.abs(large.best.row_px - truth).max() < 0.75
    assert np.abs(small.best.row_px - truth).max() < 1.5
    np.testing.assert_allclose(large.probability.sum(0), 1, atol=1e-4)
    assert np.abs(large.probability.argmax(0) - truth).max() < 1.5


@pytest.mark.parametrize("kind", [bool, np.uint8, np.uint16, float])
def test_masks_of_every_number_type_mean_the_same(kind):
    """True, 255, 65535 and 1.0 are sky; a colour mask too."""
    sky = np.zeros((60, 80), bool)
    sky[:20] = True
    top = 1 if kind in (bool, float) else np.iinfo(kind).max
    mask = (sky * top).astype(kind)
    assert (evidence_from_mask(mask).best.row_px == 20).all()
    assert (evidence_from_mask(np.repeat(mask[..., None], 3, 2)).best.row_px == 20).all()


def test_columns_without_an_edge_are_flat_and_masked():
    """All sky or all ground says nothing about a row."""
    sky = np.zeros((60, 80), bool)
    sky[:20, 10:70] = True
    sky[:, 50:60] = True
    evidence = evidence_from_mask(sky)
    silent = np.r_[0:10, 50:60, 70:80]
    assert (evidence.best.confidence[silent] == 0).all()
    np.testing.assert_allclose(evidence.probability[:, silent], 1 / 60, rtol=1e-5)
    assert evidence.best.valid.sum() == 50


def test_a_drawn_line_covers_its_own_columns_only():
    """Straight between vertices in any order; flat beyond the ends; broader where drawn carelessly."""
    sharp = evidence_from_line([900, 100, 500], [600, 300, 200], 1024, 768, sigma_px=2)
    broad = evidence_from_line([100, 500, 900], [300, 200, 600], 1024, 768, sigma_px=20)
    columns = np.arange(60, 440)
    truth = np.interp(columns * 2 + 0.5, [100, 500, 900], [300, 200, 600]) / 2
    assert np.abs(sharp.best.row_px[columns] - truth).max() < 0.6
    assert (sharp.best.confidence[:45] == 0).all()
    assert (sharp.best.confidence[455:] == 0).all()
    assert broad.probability.max() < sharp.probability.max() / 3


def test_a_line_with_a_vertex_in_every_column_is_taken_at_its_word():
    """A hand draws to a 300th of the long side; a program that traced every column means it to the pixel."""
    columns = np.arange(0, 3000)
    row = 900 + 200 * np.sin(columns / 300)
    traced = evidence_from_line(columns, row, 3000, 2000)
    drawn = evidence_from_line(columns[::100], row[::100], 3000, 2000)
    said = evidence_from_line(columns[::100], row[::100], 3000, 2000, sigma_px=10.0)
    assert traced.probability.max() > 2 * drawn.probability.max()
    np.testing.assert_allclose(drawn.probability, said.probability)


@pytest.mark.parametrize(
    "mask", [np.zeros((40, 40), np.uint8), np.full((40, 40), 255, np.uint8), np.zeros((1, 9), bool)]
)
def test_a_mask_without_an_edge_is_refused(mask):
    """Nothing to match."""
    with pytest.raises(SkylineNotFoundError, match="sky mask"):
        evidence_from_mask(mask)


@pytest.mark.parametrize("line", [([5], [9]), ([5, np.nan], [9, 9]), ([0, 50], [-90, -80])])
def test_a_line_of_less_than_two_points_or_off_the_picture_is_refused(line):
    """Nothing to match."""
    with pytest.raises(SkylineNotFoundError):
        evidence_from_line(*line, 100, 80)
