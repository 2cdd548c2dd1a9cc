"""Text in scripts that the usual font lacks."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.figures import fonts
from skyline_viewshed.core.figures.raster import TypeStyle, draw_words, words_width

USUAL, RARE = "Mönch Эльбрус 4110 m", "\U00012000"  # cuneiform, which no sans-serif has


@pytest.fixture
def only_usual(monkeypatch):
    monkeypatch.setattr(fonts, "_font_folders", lambda: [])
    cached = fonts.font_with, fonts._installed
    for found in cached:
        found.cache_clear()
    yield
    for found in cached:
        found.cache_clear()


def test_usual_text_is_one_run_of_the_usual_font(only_usual):
    assert [text for text, _ in fonts.runs_of(USUAL, 14)] == [USUAL]
    assert fonts.missing_characters(USUAL) == "" and fonts.runs_of("", 14)[0][0] == ""


def test_characters_that_no_font_has_are_named_once(only_usual):
    assert fonts.missing_characters(f"A {RARE}{RARE} 富士") == f"{RARE}富士"


@pytest.fixture
def with_another(only_usual, monkeypatch):
    """As if the usual font lacked 'ö' and another one had it."""
    path = fonts.usual_font(20).path
    monkeypatch.setattr(fonts, "_installed", lambda: ["missing.ttf", path])
    seen = []

    def has(font, character):
        seen.append(font)
        return character != "ö" or len(seen) > 1

    monkeypatch.setattr(fonts, "_has", has)
    return path


def test_a_missing_character_is_set_in_another_font_within_its_word(with_another):
    assert fonts.font_with("ö") == with_another
    runs = fonts.runs_of("Mönch", 14)
    assert [text for text, _ in runs] == ["M", "ö", "nch"]
    assert fonts.missing_characters("Mönch") == ""


@pytest.mark.parametrize("across", "lmr")
def test_runs_together_are_as_wide_as_the_text_and_keep_its_anchor(with_another, across):
    whole = sum(font.getlength(text) for text, font in [("Mönch", fonts.usual_font(20))])
    assert words_width("Mönch", 20) == pytest.approx(whole, abs=2)
    pixels = np.zeros((60, 300, 3), np.uint8)
    draw_words(pixels, 150, 40, "Mönch", (255, 255, 255), TypeStyle(20, across + "s", 0))
    ink = np.flatnonzero(pixels.any(axis=(0, 2)))
    start = 150 - {"l": 0, "m": 0.5, "r": 1}[across] * whole
    assert abs(ink[0] - start) < 4 and abs(ink[-1] - start - whole) < 4
