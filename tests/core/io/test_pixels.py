"""Stored pixels: their size by the header, their colours by whichever decoder there is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import UnreadablePhotoError
from skyline_viewshed.core.base.optional import available
from skyline_viewshed.core.io.pixels import decode, stored_size

image = pytest.importorskip("PIL.Image")
PICTURE = np.random.default_rng(2).integers(0, 256, (24, 40, 3)).astype(np.uint8)


@pytest.fixture
def stored(tmp_path):
    """Write a picture as a kind of file; give its path."""

    def write(kind, pixels=PICTURE, **options):
        path = tmp_path / f"picture.{kind}"
        image.fromarray(pixels).save(path, format=kind.upper(), **options)
        return str(path)

    return write


@pytest.mark.parametrize(("kind", "options"), [("png", {}), ("tiff", {}), ("webp", {"lossless": True})])
def test_lossless_pictures_come_back_to_the_last_level(stored, kind, options):
    pixels, size = decode(stored(kind, **options), kind)
    assert np.array_equal(pixels, PICTURE) and size == (40, 24)


def test_a_jpeg_comes_back_nearly(stored):
    smooth = np.linspace(20, 230, 24 * 40 * 3).reshape(24, 40, 3).astype(np.uint8)
    pixels, size = decode(stored("jpeg", smooth, quality=95), "jpeg")
    assert size == (40, 24) and np.abs(pixels.astype(int) - smooth).mean() < 4


def test_without_pillow_gdal_gives_the_same(stored, monkeypatch):
    path = stored("png")
    expected = decode(path, "png")
    monkeypatch.setitem(__import__("sys").modules, "PIL.Image", None)
    monkeypatch.setitem(__import__("sys").modules, "PIL", None)
    assert available("PIL.Image") is None
    pixels, size = decode(path, "png")
    assert np.array_equal(pixels, expected[0]) and size == expected[1] == stored_size(path, "png")


def test_sixteen_bits_become_eight(tmp_path):
    deep = np.arange(24 * 40, dtype=np.uint16).reshape(24, 40) * 68
    path = tmp_path / "deep.png"
    image.fromarray(deep).save(path)
    pixels, _ = decode(str(path), "png")
    assert pixels.dtype == np.uint8
    assert np.array_equal(pixels, np.repeat((deep // 257)[..., None], 3, axis=2))


@pytest.mark.parametrize(("side", "shape"), [(None, (512, 768)), (384, (512, 768)), (192, (256, 384)), (40, (64, 96))])
def test_a_jpeg_may_come_averaged_but_never_below_twice_the_side_asked(stored, side, shape):
    path = stored("jpeg", np.zeros((512, 768, 3), np.uint8))
    pixels, size = decode(path, "jpeg", side)
    assert pixels.shape[:2] == shape and size == (768, 512)


def test_a_jpeg_whose_sides_do_not_divide_is_not_averaged(stored):
    pixels, _ = decode(stored("jpeg", np.zeros((511, 767, 3), np.uint8)), "jpeg", 40)
    assert pixels.shape[:2] == (511, 767)


@pytest.mark.parametrize("kind", ["png", "jpeg", "tiff", "webp"])
def test_half_a_picture_is_refused_with_the_reason(stored, kind, tmp_path):
    whole = Path(stored(kind)).read_bytes()
    path = tmp_path / f"half.{kind}"
    path.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(UnreadablePhotoError, match="damaged or incomplete"):
        decode(str(path), kind)
