"""Texts of unknown origin come out harmless and legible."""

from __future__ import annotations

from html.parser import HTMLParser
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.figures.text import (
    LONGEST_TEXT,
    azimuth,
    compass_point,
    degrees,
    escape,
    plain,
    plus_minus,
    with_unit,
)

ANY_TEXT = st.text(st.characters(codec=None, categories=None), max_size=600)


def test_a_mark_that_turns_the_writing_direction_becomes_visible():
    assert plain("holiday\u202egpj.exe") == "holiday⟨U+202E⟩gpj.exe"


def test_control_characters_become_visible_and_line_breaks_become_spaces():
    assert plain("a\x00b\x1b[31m\r\nc\td\x85") == "a⟨U+0000⟩b⟨U+001B⟩[31m  c d⟨U+0085⟩"


def test_bytes_of_a_file_name_that_are_not_utf8_become_visible():
    name = b"IMG_\xff.JPG".decode("utf-8", "surrogateescape")
    assert plain(name) == "IMG_⟨U+DCFF⟩.JPG"


def test_ordinary_names_of_any_language_stay_as_they_are():
    for name in ("Mönch & Jungfrau", "कञ्चनजङ्घा.jpg", "جبل.jpg", "👩‍👩‍👧.heic", "山と雪"):
        assert plain(name) == name


def test_piled_up_marks_and_endless_texts_are_cut():
    assert len(plain("a" + "\u0301" * 50)) == 5
    assert plain("x" * 1000) == "x" * LONGEST_TEXT + "…"


def test_markup_is_escaped_for_content_and_for_both_quotes():
    assert escape("</script>\"'<&") == "&lt;/script&gt;&quot;&#x27;&lt;&amp;"


@given(ANY_TEXT)
def test_any_text_can_be_written_parsed_and_stays_text(text):
    written = f'<p title="{escape(text)}">{escape(text)}</p>'
    written.encode("utf-8")
    element = ElementTree.fromstring(written)
    assert len(element) == 0
    assert element.text or not plain(text)
    assert (element.text or "") == plain(text)
    tags = []
    parser = HTMLParser()
    parser.handle_starttag = lambda tag, attributes: tags.append(tag)
    parser.feed(written)
    assert tags == ["p"]


@pytest.mark.parametrize(
    ("angle", "words"), [(359.97, "0.0°"), (-0.01, "0.0°"), (45.25, "45.2°"), (None, "–"), (float("nan"), "–")]
)
def test_azimuths_are_written_below_360(angle, words):
    assert azimuth(angle) == words


@pytest.mark.parametrize(("angle", "name"), [(0, "N"), (11.2, "N"), (11.3, "NNE"), (225, "SW"), (355, "N")])
def test_compass_points_are_the_nearest_of_sixteen(angle, name):
    assert compass_point(angle) == name


def test_numbers_have_true_minus_signs_thin_thousands_and_units():
    assert with_unit(-12345.6, "m", 1) == "−12\u202f345.6\u00a0m"
    assert with_unit(-0.01, "m", 1) == "0.0\u00a0m"
    assert degrees(2.04, 1, signed=True) == "+2.0°"
    assert with_unit(None, "m") == with_unit(float("inf"), "m") == "–"


@pytest.mark.parametrize(("half", "words"), [(0.247, "±0.25°"), (1.04, "±1.0°"), (12.3, "±12°"), (100.28, "±100°")])
def test_intervals_have_as_many_decimals_as_they_deserve(half, words):
    assert plus_minus(half) == words
