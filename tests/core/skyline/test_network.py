"""The sky network in NumPy: PyTorch's answers, painted pictures, damaged files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from skyline_viewshed.core.base import imaging
from skyline_viewshed.core.skyline import network
from skyline_viewshed.core.skyline.network import (
    NETWORK_PATH,
    load_layers,
    network_input,
    resized,
    row_probability,
    sky_log_odds,
)

GOLDEN_PATH = Path(__file__).with_name("golden_sky.npz")
BLUE, ROCK = (90, 140, 210), (75, 65, 55)


def painted(height=240, width=320, sky=BLUE, rock=ROCK, seed=1):
    """A ridge of rough rock under a smooth sky; pixels and where they are sky."""
    generator = np.random.default_rng(seed)
    ridge = 0.45 * height + 0.12 * height * np.sin(np.arange(width) / width * 7)
    is_sky = np.arange(height)[:, None] < ridge
    texture = ndimage.gaussian_filter(generator.normal(size=(height, width)), 2)[..., None] * 60
    pixels = np.where(is_sky[..., None], np.array(sky, float), np.array(rock, float) + texture)
    return np.clip(pixels, 0, 255).astype(np.uint8), is_sky


def test_numpy_answers_as_pytorch_does():
    """`tools/sky/export.py --golden` kept PyTorch's log-odds of a painted picture."""
    with np.load(GOLDEN_PATH) as golden:
        found = network._run(network_input(golden["pixels"]), load_layers())
        assert np.ptp(golden["log_odds"]) > 6
        np.testing.assert_allclose(found, golden["log_odds"], atol=1e-2)


def test_convolution_against_scipy():
    generator = np.random.default_rng(2)
    values, kernel = generator.normal(size=(7, 10, 3)).astype(np.float32), generator.normal(size=(27, 5))
    bias = np.arange(5.0)
    for stride in (1, 2):
        found = network._convolved(values, kernel.astype(np.float32), bias.astype(np.float32), stride)
        for out in range(5):
            taps = kernel[:, out].reshape(3, 3, 3)
            planes = [ndimage.correlate(values[..., i], taps[..., i], mode="constant") for i in range(3)]
            np.testing.assert_allclose(found[..., out], (sum(planes) + bias[out])[::stride, ::stride], atol=1e-4)


@pytest.mark.parametrize(
    ("shape", "expected"),
    [((192, 256), (96, 128)), ((1000, 500), (128, 64)), ((24, 30), (96, 128)), ((40, 900), (16, 128))],
)
def test_the_answer_covers_the_picture_at_half_the_size_that_the_network_sees(shape, expected):
    odds = sky_log_odds(np.full((*shape, 3), 128, np.uint8))
    assert odds.shape == expected
    assert odds.dtype == np.float32
    assert np.isfinite(odds).all()


@pytest.mark.parametrize(
    ("sky", "rock"),
    [(BLUE, ROCK), ((225, 228, 230), ROCK), ((60, 100, 170), (150, 148, 150))],
    ids=["clear", "white", "pale"],
)
def test_sky_lies_above_rock(sky, rock):
    pixels, is_sky = painted(sky=sky, rock=rock)
    odds = resized(sky_log_odds(pixels), *is_sky.shape)
    assert odds.shape == is_sky.shape
    assert ((odds > 0) == is_sky).mean() > 0.95
    assert odds[:20].mean() > 2
    assert odds[-20:].mean() < -2


def test_a_higher_ridge_leaves_less_sky():
    """The same terrain set higher and higher."""
    pixels, _ = painted(480)
    shares = [(sky_log_odds(pixels[top : top + 240]) > 0).mean() for top in (0, 60, 120)]
    assert shares[0] > shares[1] > shares[2]


def test_the_same_picture_gets_the_same_answer():
    pixels, _ = painted()
    np.testing.assert_array_equal(sky_log_odds(pixels), sky_log_odds(pixels.copy()))


def test_the_answer_hardly_depends_on_opencv(monkeypatch):
    pixels, _ = painted(600, 800)
    with_opencv = sky_log_odds(pixels)
    monkeypatch.setattr(imaging, "_cv2", lambda: None)
    np.testing.assert_allclose(sky_log_odds(pixels), with_opencv, atol=1e-2)


def test_resizing_keeps_a_ramp():
    """Shrunk by areas and enlarged linearly, a ramp stays a ramp between the outer centres."""
    ramp = np.linspace(0, 1, 40, dtype=np.float32)[:, None] * np.ones((1, 30), np.float32)
    small = resized(ramp, 10, 90)
    assert small.shape == (10, 90)
    np.testing.assert_allclose(small[:, 0], ramp.reshape(10, 4, 30).mean((1, 2)), atol=1e-6)
    large = resized(small, 100, 90)
    np.testing.assert_allclose(np.diff(large[5:-5, 0]), small[1, 0] / 10 - small[0, 0] / 10, atol=1e-5)


def test_resizing_one_pixel_gives_a_flat_map():
    np.testing.assert_array_equal(resized(np.full((1, 1), 3, np.float32), 4, 5), np.full((4, 5), 3))


def test_rows_are_probabilities_around_the_edge_of_the_log_odds():
    """Sharp where the network is sure; where it says nothing every row is as likely."""
    odds = np.where(np.arange(50)[:, None] < 20, 9.0, -9.0) * np.ones((1, 3))
    odds[:, 2] = 0
    found = row_probability(odds)
    np.testing.assert_allclose(found.sum(0), 1, atol=1e-5)
    assert (found[:, :2].argmax(0) == 20).all()
    assert found.min() >= 0.05 / 50 - 1e-6
    np.testing.assert_allclose(found[:, 2], 1 / 50, atol=1e-6)


def test_the_file_is_small():
    assert NETWORK_PATH.stat().st_size < 1_000_000


@pytest.mark.parametrize("kind", ["missing", "empty", "text", "cut", "foreign", "not finite"])
def test_a_damaged_file_is_named(tmp_path, kind):
    path = tmp_path / "weights.npz"
    with np.load(NETWORK_PATH) as file:
        arrays = dict(file)
    if kind == "empty":
        path.write_bytes(b"")
    elif kind == "text":
        path.write_text("no numbers here")
    elif kind == "cut":
        path.write_bytes(NETWORK_PATH.read_bytes()[:1000])
    elif kind == "foreign":
        np.savez(path, other=np.zeros(3))
    elif kind == "not finite":
        np.savez(path, **{**arrays, "last.bias": np.array([np.nan])})
    with pytest.raises(ValueError, match=r"weights.*weights\.npz"):
        load_layers(path)
