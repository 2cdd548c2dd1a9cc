"""Features drawn on photographs: whose they are, and which way their rows count."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.pixel_features import PixelFeature, downward, for_photo, open_ring, photo_key

SQUARE = np.array([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]])


def feature(photo):
    return PixelFeature(photo, "line", (SQUARE,))


@pytest.mark.parametrize("path", ["/a/b/IMG_1.JPG", "C:\\photos\\IMG_1.jpg", "img_1.jpg", "b/Img_1.Jpg"])
def test_photos_are_known_by_their_file_name_alone(path):
    assert photo_key(path) == "img_1.jpg"


def test_a_feature_belongs_to_its_photo_with_any_extension_and_to_all_without_a_name():
    features = [feature(name) for name in ("IMG_1.jpg", "/x/img_1.HEIC", "img_1", "", "IMG_10.jpg", "1.jpg")]
    assert for_photo(features, "/photos/IMG_1.JPG") == features[:4]
    assert for_photo(features, "IMG_10.tif") == [features[3], features[4]]


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
