"""Lines and words in arrays."""

from __future__ import annotations

import io
import sys

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import MissingPackageError
from skyline_viewshed.core.figures import raster as draw

RED = (255, 0, 0)


def blank(height=60, width=80):
    return np.full((height, width, 3), 200, np.uint8)


def test_pictures_survive_png_exactly_and_jpeg_nearly():
    image = pytest.importorskip("PIL.Image")
    ramp = np.broadcast_to(np.arange(80, dtype=np.uint8)[None, :, None] * 3, (60, 80, 3))
    for encode, tolerance in ((draw.encode_png, 0), (draw.encode_jpeg, 6)):
        back = np.asarray(image.open(io.BytesIO(encode(ramp)))).astype(int)
        assert np.abs(back - ramp).max() <= tolerance
    alpha = np.dstack([ramp, ramp[..., 0]])
    assert np.array_equal(np.asarray(image.open(io.BytesIO(draw.encode_png(alpha)))), alpha)


def test_a_line_lies_on_its_pixels_and_nowhere_else():
    pixels = blank()
    draw.draw_line(pixels, [10, 70], [30, 30], RED, width_px=3)
    assert np.array_equal(pixels[30, 40], RED)
    assert np.all(pixels[[27, 33]] == 200)
    assert np.all(pixels[:, :7] == 200)


def test_a_slanted_line_is_smooth():
    pixels = blank()
    draw.draw_line(pixels, [5, 75], [10, 22], RED, width_px=2)
    between = (pixels[..., 1] > 10) & (pixels[..., 1] < 190)
    assert between.sum() > 60


def test_a_line_keeps_its_weight_whatever_its_direction():
    def ink(x, y):
        pixels = blank(100, 100)
        draw.draw_line(pixels, x, y, (0, 0, 0), width_px=4)
        return (200 - pixels[..., 0].astype(float)).sum() / np.hypot(x[1] - x[0], y[1] - y[0])

    assert ink([20, 80], [50, 50]) == pytest.approx(ink([20, 80], [20, 80]), rel=0.15)


def test_unknown_points_break_a_line():
    pixels = blank()
    draw.draw_line(pixels, [5, 30, np.nan, 50, 75], [30] * 5, RED)
    assert np.all(pixels[30, 36:45] == 200)
    assert pixels[30, 60, 1] < 60


def test_dashes_leave_gaps_of_their_length():
    pixels = blank()
    draw.draw_line(pixels, [0, 79], [30, 30], RED, width_px=2, style=draw.LineStyle((10, 10)))
    drawn = pixels[30, :, 1] < 100
    assert 0.35 < drawn.mean() < 0.7
    assert np.abs(np.diff(drawn.astype(int))).sum() >= 6


def test_a_casing_darkens_both_sides():
    pixels = blank()
    draw.draw_line(pixels, [5, 75], [30, 30], RED, width_px=3, style=draw.LineStyle(casing_px=2))
    assert pixels[27, 40].max() < 120
    assert pixels[33, 40].max() < 120
    assert np.array_equal(pixels[30, 40], RED)


def test_what_lies_outside_is_cut_without_complaint():
    pixels = blank()
    draw.draw_line(pixels, [-500, 500], [-400, 400], RED)
    draw.draw_line(pixels, [500, 600], [500, 600], RED)
    draw.draw_dot(pixels, -100, -100, 5, RED)
    draw.draw_area(pixels, [200, 220, 210], [0, 0, 30], RED)
    draw.draw_words(pixels, 70, 59, "beyond the edge", RED)
    assert np.array_equal(pixels[0, 0], blank()[0, 0]) or pixels[0, 0, 1] < 200


def test_words_take_the_width_they_say():
    pixels = blank(40, 300)
    draw.draw_words(pixels, 10, 30, "Jungfrau 4158", (0, 0, 0), draw.TypeStyle(18, casing_px=0))
    columns = np.flatnonzero((pixels != 200).any(axis=(0, 2)))
    assert columns.max() - columns.min() == pytest.approx(draw.words_width("Jungfrau 4158", 18), abs=5)


def test_without_pillow_the_message_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "PIL", None)
    with pytest.raises(MissingPackageError, match="Pillow"):
        draw.encode_png(blank())


def test_an_old_pillow_without_the_usual_fonts_says_what_to_install(monkeypatch):
    fonts = pytest.importorskip("PIL.ImageFont")

    def missing(*_):
        raise OSError("no such font")

    monkeypatch.setattr(fonts, "truetype", missing)
    with pytest.raises(MissingPackageError, match="font"):
        monkeypatch.setattr(fonts, "load_default", lambda: None)  # as before Pillow 10.1
        draw.words_width("Eiger")
