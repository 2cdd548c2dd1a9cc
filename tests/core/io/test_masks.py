"""Masks as outlines."""

from __future__ import annotations

import base64
import io

import numpy as np
import pytest
from skyline_viewshed.core.io.masks import mask_of_picture, mask_of_runs, outlines


def area(ring):
    x, y = ring.T
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def filled(rings, shape):
    """Pixels whose centre lies inside, by the even-odd rule."""
    y, x = np.mgrid[: shape[0], : shape[1]] + 0.5
    inside = np.zeros(shape, bool)
    for ring in rings:
        for (x1, y1), (x2, y2) in zip(ring, np.roll(ring, -1, axis=0)):
            if y1 != y2:
                inside ^= ((y1 > y) != (y2 > y)) & (x < x1 + (y - y1) / (y2 - y1) * (x2 - x1))
    return inside


def test_outlines_enclose_exactly_the_mask_with_holes_of_their_own():
    rng = np.random.default_rng(3)
    for _ in range(100):
        mask = rng.random(rng.integers(1, 12, 2)) < rng.random()
        seen = np.zeros(mask.shape, int)
        for rings in outlines(mask):
            assert area(rings[0]) > 0 and all(area(hole) < 0 for hole in rings[1:])
            seen += filled(rings, mask.shape)
        assert np.array_equal(seen, mask.astype(int))


def test_an_outline_has_only_the_corners():
    mask = np.zeros((9, 9), bool)
    mask[2:6, 3:8] = True
    ((ring,),) = outlines(mask)
    assert sorted(map(tuple, ring)) == [(3, 2), (3, 6), (8, 2), (8, 6)]


def compressed(counts):
    """Write COCO's text as its rleToString does."""
    text = ""
    for k, value in enumerate(counts):
        value -= counts[k - 2] if k > 2 else 0
        more = True
        while more:
            bits = value & 0x1F
            value >>= 5
            more = value != -1 if bits & 0x10 else value != 0
            text += chr((bits | (0x20 if more else 0)) + 48)
    return text


@pytest.mark.parametrize("packed", [list, compressed])
def test_run_lengths_go_down_the_columns_from_a_run_of_zeros(packed):
    mask = np.random.default_rng(1).random((40, 70)) < 0.5
    mask[:, 20:50] = False
    mask[0, 0] = True  # the first run is empty
    flat = np.concatenate([[False], mask.T.ravel(), [not mask[-1, -1]]])
    counts = np.diff(np.concatenate([[0], np.flatnonzero(np.diff(flat.astype(int)))])).tolist()
    assert counts[0] == 0 and sum(counts) == mask.size
    assert np.array_equal(mask_of_runs({"size": [40, 70], "counts": packed(counts)}), mask)


@pytest.mark.parametrize("runs", [
    {"size": [2, 2], "counts": [1, 2]}, {"size": [2, 2], "counts": [5, -1]}, {"size": [0, 2], "counts": []},
    {"size": [10**6, 10**6], "counts": [10**12]},
])  # fmt: skip
def test_runs_that_do_not_fill_the_picture_are_refused(runs):
    with pytest.raises(ValueError, match="run lengths"):
        mask_of_runs(runs)


def test_labelmes_bitmaps():
    image = pytest.importorskip("PIL.Image")
    mask = np.array([[0, 1, 1], [1, 0, 1]], np.uint8)
    stream = io.BytesIO()
    image.fromarray(mask * 255).save(stream, "PNG")
    assert np.array_equal(mask_of_picture(base64.b64encode(stream.getvalue()).decode()), mask > 0)
