import numpy as np
import pytest
from skyline_viewshed.core.thumbnail import THUMBNAIL_PX, thumbnail


@pytest.mark.parametrize("shape, expected", [((480, 640), (48, 64)), ((640, 480), (64, 48)), ((20, 30), (20, 30))])
def test_the_long_side_is_the_thumbnails(shape, expected):
    small = thumbnail(np.full((*shape, 3), 77, np.uint8))
    assert small.shape == (*expected, 3) and max(expected) <= THUMBNAIL_PX
    assert small == pytest.approx(77.0)


def test_borders_and_what_they_touch_are_unknown():
    small = thumbnail(np.full((480, 640, 3), 50, np.uint8), crop=(25, 10, 0, 40))
    unknown = np.isnan(small).any(axis=2)
    assert unknown[:3].all() and unknown[-1:].all() and unknown[:, -4:].all()
    assert not unknown[3:-1, :-4].any()
    assert small[5, 5] == pytest.approx(50.0)
