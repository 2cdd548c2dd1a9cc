"""Features drawn on a stored or a reduced copy, in pixels of the full upright picture."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.base.pixel_features import PixelFeature
from skyline_viewshed.core.base.upright import on_upright, stored_of_upright, upright_of_stored
from skyline_viewshed.core.io.photo import _upright


def drawn(xy, **more):
    return PixelFeature("a.jpg", "line", (np.asarray(xy, float),), **more)


@pytest.mark.parametrize("orientation", range(1, 9))
def test_pixels_go_where_the_reader_puts_them(orientation):
    stored = np.arange(12).reshape(3, 4)  # each pixel's value tells which one it is
    upright = _upright(stored, orientation)
    xy = np.array([[x, y] for y in range(3) for x in range(4)], float)
    moved = upright_of_stored(xy, (4, 3), orientation)
    assert [upright[int(y), int(x)] for x, y in moved] == list(range(12))
    assert np.array_equal(stored_of_upright(moved, upright.shape[::-1], orientation), xy)


@pytest.mark.parametrize("orientation", range(2, 9))
def test_what_was_drawn_on_the_stored_picture_is_rotated_with_it(orientation):
    upright_px = (300, 400) if orientation >= 5 else (400, 300)
    found, note = on_upright(drawn([[10, 20], [390, 290]], as_stored=True), *upright_px, orientation)
    expected = upright_of_stored([[10, 20], [390, 290]], (400, 300), orientation)
    assert np.array_equal(found.parts[0], expected) and "rotated" in str(note)


def test_what_cannot_have_been_drawn_on_the_stored_picture_stays():
    feature = drawn([[10, 20], [290, 390]], as_stored=True)  # y beyond the 300 rows that are stored
    assert on_upright(feature, 300, 400, 6) == (feature, None)
    feature = drawn([[10, 20], [30, 40]], as_stored=True)
    assert on_upright(feature, 400, 300, 1) == (feature, None)
    feature = drawn([[10, 20], [30, 40]])
    assert on_upright(feature, 300, 400, 6) == (feature, None)


@pytest.mark.parametrize("size", [(1008, 756), (1007, 756), (640, 480), (8064, 6048)])
def test_labels_of_a_reduced_copy_are_scaled_by_its_corners(size):
    corners = [[-0.5, -0.5], [size[0] - 0.5, size[1] - 0.5]]
    found, note = on_upright(drawn(corners, size_px=size), 4032, 3024)
    assert found.parts[0] == pytest.approx(np.array([[-0.5, -0.5], [4031.5, 3023.5]])) and "scaled" in str(note)


def test_labels_of_the_photo_itself_stay():
    feature = drawn([[1, 2], [3, 4]], size_px=(4032.0, 3024.0))
    assert on_upright(feature, 4032, 3024, 6) == (feature, None)


def test_labels_of_a_reduced_copy_that_was_not_rotated_are_scaled_and_rotated():
    found, _ = on_upright(drawn([[-0.5, -0.5], [399.5, -0.5]], size_px=(400, 300)), 3000, 4000, 6)
    assert found.parts[0] == pytest.approx(np.array([[2999.5, -0.5], [2999.5, 3999.5]]))


@pytest.mark.parametrize("size", [(4032, 2268), (1000, 1000), (300, 400)])
def test_labels_of_another_shape_are_refused_with_both_sizes(size):
    with pytest.raises(PhotoError, match=f"{size[0]} x {size[1]} pixels.*4032 x 3024"):
        on_upright(drawn([[1, 2], [3, 4]], size_px=size), 4032, 3024, 1)
