import numpy as np
import pytest
from skyline_viewshed.core.skyline.border import find_crop


def landscape(height=200, width=300, seed=0):
    """An even sky over a rough ground, to be framed."""
    rng = np.random.default_rng(seed)
    picture = np.full((height, width, 3), (150.0, 175.0, 215.0))
    ridge = 80 + 20 * np.sin(np.arange(width) / 30)
    ground = np.arange(height)[:, None] > ridge
    picture[ground] = (90, 85, 60) + rng.normal(0, 20, (ground.sum(), 1))
    return np.clip(picture, 0, 255)


@pytest.mark.parametrize("level", [255, 240, 8])
@pytest.mark.parametrize("border", [(6, 9, 5, 7), (20, 40, 20, 20)])
def test_a_frame_is_measured_on_each_side(level, border):
    """White, off-white and black, uneven sides."""
    top, bottom, left, right = border
    picture = landscape()
    framed = np.pad(picture, ((top, bottom), (left, right), (0, 0)), constant_values=level)
    assert find_crop(framed) == border


def test_a_caption_below_belongs_to_the_frame():
    """Letters darken a part of the lower border's lines."""
    framed = np.pad(landscape(), ((10, 40), (10, 10), (0, 0)), constant_values=250)
    framed[225:233, 20:120:3] = 30
    assert find_crop(framed) == (10, 40, 10, 10)


def test_bars_above_and_below_are_a_frame():
    """Letterbox: no bars at the sides."""
    framed = np.pad(landscape(), ((25, 25), (0, 0), (0, 0)), constant_values=0)
    assert find_crop(framed) == (25, 25, 0, 0)


@pytest.mark.parametrize("sky", [255, 250, 5])
def test_an_overexposed_or_black_sky_is_no_frame(sky):
    """Uniform at the top, and down the sides only as far as the ridge."""
    picture = landscape()
    picture[np.abs(picture - (150, 175, 215)).max(2) < 1] = sky
    assert find_crop(picture) == (0, 0, 0, 0)


def test_a_vignette_is_no_frame():
    """Dark corners fade; a frame ends at once."""
    y, x = np.mgrid[-1:1:200j, -1:1:300j]
    gain = np.clip(1.6 - np.maximum(np.abs(x), np.abs(y)) * 1.7, 0, 1)[..., None]
    assert find_crop(landscape() * gain) == (0, 0, 0, 0)


@pytest.mark.parametrize("value", [0, 128, 255])
def test_a_picture_of_one_colour_has_no_frame(value):
    """Nothing would be left."""
    assert find_crop(np.full((100, 100, 3), value, np.uint8)) == (0, 0, 0, 0)


def test_tiny_pictures_are_left_alone():
    """Too small to tell."""
    assert find_crop(np.zeros((10, 400, 3), np.uint8)) == (0, 0, 0, 0)
