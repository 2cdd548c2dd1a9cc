"""Every picture operation agrees with its twin, and with closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base import imaging
from skyline_viewshed.core.base.imaging import THUMBNAIL_PX, thumbnail

pytest.importorskip("cv2")


@pytest.fixture
def without_cv2(monkeypatch):
    """A context in which OpenCV is not installed."""

    def call(function, *args):
        with monkeypatch.context() as patch:
            patch.setattr(imaging, "_cv2", lambda: None)
            return function(*args)

    return call


def picture(height=97, width=131, seed=0):
    """Blobs with a hard edge and grain: something of everything, uint8 RGB."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:height, :width]
    base = np.stack([120 + 60 * np.sin(x / 9), 90 + 0.8 * y, 60 + 1.2 * x], -1)
    base[height // 2 :, : width // 2] += 70
    return np.clip(base + rng.normal(0, 8, base.shape), 0, 255).astype(np.uint8)


TWINS = {
    "to_grey": (lambda p: imaging.to_grey(p), 0),
    "shrink by a whole factor": (lambda p: imaging.shrink(p, 65, 48), 2e-3),
    "shrink by an odd factor": (lambda p: imaging.shrink(p, 50, 37), 2e-3),
    "shrink one channel": (lambda p: imaging.shrink(p[..., 0], 40, 90), 2e-3),
    "gaussian_blur": (lambda p: imaging.gaussian_blur(p.astype(np.float32), 1.6), 2e-3),
    "gaussian_blur down only": (lambda p: imaging.gaussian_blur(p[..., 1].astype(np.float32), (2.3, 0)), 2e-3),
    "box_mean of bytes": (lambda p: imaging.box_mean(p[..., 0], 9, 5), 0),
    "box_mean of floats": (lambda p: imaging.box_mean(p[..., 0].astype(np.float32), 7, 7), 2e-3),
    "median": (lambda p: imaging.median(p[..., 2], 15), 0),
    "laplacian": (lambda p: imaging.laplacian(p[..., 1]), 0),
    "erode": (lambda p: imaging.erode(p[..., 0] > 90, 9, 3), 0),
    "maximum_down": (lambda p: imaging.maximum_down(p[..., 0].astype(np.float32), 7), 0),
}


@pytest.mark.parametrize("name", TWINS)
def test_the_scipy_twin_agrees_with_opencv(name, without_cv2):
    """Equal to rounding, the borders included."""
    operation, tolerance = TWINS[name]
    with_cv2, plain = operation(picture()), without_cv2(operation, picture())
    assert with_cv2.dtype == plain.dtype
    assert with_cv2.shape == plain.shape
    np.testing.assert_allclose(plain.astype(float), with_cv2.astype(float), atol=tolerance)


def test_bilinear_twins_agree_inside_outside_and_at_nan(without_cv2):
    """OpenCV's remap rounds positions to 1/32 pixel in older versions; the picture here is smooth enough for 1."""
    y, x = np.mgrid[:40, :60].astype(np.float32)
    image = 3 * x + 2 * y
    rng = np.random.default_rng(1)
    x_px, y_px = rng.uniform(-3, 63, (20, 30)), rng.uniform(-3, 43, (20, 30))
    x_px[0, 0] = np.nan
    fast = imaging.sample_bilinear(image, x_px, y_px, -5.0)
    plain = without_cv2(imaging.sample_bilinear, image, x_px, y_px, -5.0)
    far = (x_px < -1) | (x_px > 60) | (y_px < -1) | (y_px > 40)
    inside = (x_px >= 0) & (x_px <= 59) & (y_px >= 0) & (y_px <= 39)
    assert fast[0, 0] == plain[0, 0] == -5.0
    np.testing.assert_allclose(fast[far], -5.0)
    np.testing.assert_allclose(plain[far], -5.0)
    np.testing.assert_allclose(plain[inside], (3 * x_px + 2 * y_px)[inside], atol=1e-3)
    np.testing.assert_allclose(fast[inside], plain[inside], atol=0.1)


def test_the_median_of_a_tile_border_does_not_show(without_cv2):
    """A picture wider than one tile gives what NumPy's own median gives."""
    grey = picture(150, 150, seed=3)[..., 0]
    half = 2
    padded = np.pad(grey, half, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, (5, 5)).reshape(150, 150, 25)
    np.testing.assert_array_equal(without_cv2(imaging.median, grey, 5), np.median(windows, 2).astype(np.uint8))


@settings(max_examples=30, deadline=None)
@given(st.integers(1, 40), st.integers(1, 40), st.integers(0, 3))
def test_shrinking_keeps_the_mean(width_px, height_px, seed):
    """Area averaging preserves the picture's mean for every size."""
    image = np.random.default_rng(seed).uniform(0, 255, (40, 40)).astype(np.float32)
    assert imaging.shrink(image, width_px, height_px).mean() == pytest.approx(image.mean(), rel=1e-4)


def test_a_large_picture_is_shrunk_in_strips_to_the_same_result(monkeypatch):
    """Several strips, odd factors."""
    image = picture(701, 503)
    whole = imaging.shrink(image, 97, 131)
    monkeypatch.setattr(imaging, "LARGE", 1000)
    np.testing.assert_allclose(imaging.shrink(image, 97, 131), whole, atol=2e-3)


@pytest.mark.parametrize(
    "size, long_side_px, shrunk",
    [((30, 40), 20, (15, 20)), ((40, 30), 20, (20, 15)), ((3, 200), 20, (1, 20)), ((30, 40), 80, (30, 40))],
)
def test_shrinking_to_a_long_side_keeps_the_shape(size, long_side_px, shrunk):
    assert imaging.shrink_to(np.ones((*size, 3), np.uint8), long_side_px).shape == (*shrunk, 3)


def test_shrinking_refuses_to_enlarge():
    """Enlarging is no averaging."""
    with pytest.raises(ValueError, match="cannot shrink"):
        imaging.shrink(np.zeros((4, 4), np.uint8), 5, 4)


def test_lab_of_known_colours():
    """White, black, mid grey and the sRGB primaries (CIE 15, D65; Lindbloom's calculator)."""
    rgb = np.array([[255, 255, 255], [0, 0, 0], [119, 119, 119], [255, 0, 0], [0, 255, 0], [0, 0, 255]], np.uint8)
    lab = [
        [100, 0, 0],
        [0, 0, 0],
        [50.03, 0, 0],
        [53.24, 80.09, 67.20],
        [87.73, -86.18, 83.18],
        [32.30, 79.19, -107.86],
    ]
    np.testing.assert_allclose(imaging.rgb_to_lab(rgb), lab, atol=0.05)


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


@pytest.mark.parametrize("step", [np.add, np.maximum])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_accumulating_by_rows_gives_the_digits_of_numpy(step, dtype):
    values = np.random.default_rng(3).normal(size=(200, 7, 2)).astype(dtype)
    found, wanted = imaging.accumulate_down(step, values), step.accumulate(values, 0)
    assert found.dtype == wanted.dtype
    np.testing.assert_array_equal(found, wanted)
    assert imaging.accumulate_down(step, values[:0]).shape == (0, 7, 2)
