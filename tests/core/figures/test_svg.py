"""SVG pieces: scales, ticks, paths, and figures that a machine can read."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.figures.svg import (
    STYLE,
    Scale,
    area_path,
    figure,
    on_circle,
    polyline_path,
    round_below,
    sector_path,
    spans_360,
    standalone,
    text,
    ticks,
)


@given(st.floats(1e-6, 1e9))
def test_a_scale_bar_is_round_and_nearly_as_long_as_allowed(longest):
    length = round_below(longest)
    assert longest / 2.51 < length <= longest * 1.0001
    assert any(abs(length / 10.0**power / m - 1) < 1e-6 for m in (1, 2, 5) for power in range(-7, 10))


def points_of(path):
    """Absolute points of each stretch of a path of M and l commands."""
    stretches = []
    for start, steps in re.findall(r"M([-\d. ]+)(?:l([-\d. ]+))?", path):
        first = np.array(start.split(), float)
        deltas = np.array((steps or "").split(), float).reshape(-1, 2)
        stretches.append(first + np.vstack([[0, 0], np.cumsum(deltas, axis=0)]))
    return stretches


def test_scales_run_either_way():
    scale = Scale(0, 10, 100, 0)
    assert scale(2.5) == 75
    assert np.array_equal(scale([0, 10]), [100, 0])


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6), st.integers(2, 8))
def test_ticks_are_round_even_and_inside(low, span, count):
    values = ticks(low, low + span, count)
    assert 1 <= len(values) <= count + 1 or len(values) == 0
    if len(values) > 1:
        step = values[1] - values[0]
        assert np.allclose(np.diff(values), step)
        mantissa = step / 10 ** np.floor(np.log10(step) + 1e-9)
        assert min(abs(mantissa - round_one) for round_one in (1, 2, 5, 10)) < 1e-3
    assert np.all(values >= low - 1e-6 * span)
    assert np.all(values <= low + span * (1 + 1e-6))


@given(st.lists(st.tuples(st.floats(-2000, 2000), st.floats(-2000, 2000)), min_size=2, max_size=60))
def test_a_path_meets_its_points_to_a_twentieth_however_long_it_is(points):
    points = np.array(points)
    (drawn,) = points_of(polyline_path(*points.T))
    assert np.abs(drawn - points).max() <= 0.051


def test_unknown_points_break_lines_and_areas():
    y = np.array([1, 2, np.nan, 4, 5, 6.0])
    first, second = points_of(polyline_path(np.arange(6), y))
    assert first[:, 1].tolist() == [1, 2]
    assert second[:, 0].tolist() == [3, 4, 5]
    area = area_path(np.arange(6), y, 10)
    assert area.count("Z") == 2
    assert [stretch[0, 1] for stretch in points_of(area)] == [10, 10]
    assert polyline_path([np.nan], [1.0]) == ""


def test_sectors_begin_at_the_top_and_turn_clockwise():
    assert np.allclose(on_circle(50, 50, 10, 90), (60, 50))
    assert sector_path(50, 50, 0, 10, 0, 90) == "M50 40A10 10 0 0 1 60 50L50 50Z"
    assert " 0 1 1 " in sector_path(0, 0, 0, 10, 10, 200)


@pytest.mark.parametrize(
    ("first", "width", "spans"),
    [(10, 20, [(10, 30)]), (350, 20, [(350, 360), (0, 10)]), (-10, 20, [(350, 360), (0, 10)])],
)
def test_arcs_across_north_are_cut_in_two(first, width, spans):
    assert spans_360(first, width) == spans


def test_figures_name_and_describe_themselves_and_escape_words():
    drawing = figure(100, 50, "Score <b>", 'A "curve" & more', text(1, 2, "</svg><script>"))
    root = ElementTree.fromstring(drawing)
    assert root.get("role") == "img"
    assert root.get("aria-label") == "Score <b>"
    assert [child.tag for child in root] == ["title", "desc", "text"]
    assert root[1].text == 'A "curve" & more'
    assert "style=" not in drawing


def test_a_figure_of_its_own_carries_both_themes():
    drawing = standalone(figure(100, 50, "a", "b"))
    assert ElementTree.fromstring(drawing).tag == "{http://www.w3.org/2000/svg}svg"
    assert "prefers-color-scheme:dark" in drawing
    used = set(re.findall(r"var\((--\w+)\)", STYLE))
    set_light, set_dark = (set(re.findall(r"(--\w+):", part)) for part in STYLE.split("@media")[:2])
    assert used <= set_light
    assert used <= set_dark
