"""The score as curve and rose."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from skyline_viewshed.core.base.model import Orientation
from skyline_viewshed.core.figures.score import probability_rose_svg, score_curve_svg, score_rose_svg


def parts(drawing, class_):
    root = ElementTree.fromstring(drawing)
    return [part for part in root.iter() if class_ in (part.get("class") or "").split()]


def words(drawing):
    return [part.text for part in ElementTree.fromstring(drawing).iter() if part.tag.endswith("text")]


def x_of(heading, width=620):
    return 44 + heading / 360 * (width - 16 - 44)


def test_the_answer_stands_at_its_heading_and_on_its_score(painted):
    drawing = score_curve_svg(painted().orientation)
    (mark,) = parts(drawing, "mark-best")
    assert float(mark.get("cx")) == pytest.approx(x_of(123.4), abs=0.1)
    path = parts(drawing, "curve")[0].get("d")
    start, steps = re.match(r"M([^l]*)l([^Z]*)Z", path).groups()
    points = np.array(start.split(), float) + np.cumsum(np.array(steps.split(), float).reshape(-1, 2), axis=0)
    assert float(mark.get("cy")) == pytest.approx(points[:, 1].min(), abs=0.2)
    assert "123.4° ESE" in words(drawing)


def test_alternatives_compass_and_interval_are_marked(painted):
    drawing = score_curve_svg(painted().orientation, compass_true_deg=121.0, score_name="NCC")
    assert [text for text in words(drawing) if text.startswith(("2:", "3:"))] == ["3: 323.4°", "2: 240.4°"]
    assert len(parts(drawing, "mark-alternative")) == 2
    (compass,) = [part for part in parts(drawing, "compass") if part.tag.endswith("line")]
    assert float(compass.get("x1")) == pytest.approx(x_of(121.0), abs=0.1)
    (interval,) = parts(drawing, "interval")
    assert float(interval.get("width")) == pytest.approx(x_of(0.8) - x_of(0) + 1, abs=0.1)
    assert "NCC" in words(drawing)


def test_an_interval_across_north_is_drawn_at_both_ends(painted):
    orientation = replace(painted().orientation, heading_lo_deg=355.0, heading_hi_deg=5.0)
    spans = parts(score_curve_svg(orientation), "interval")
    assert len(spans) == 2
    assert sum(float(span.get("width")) for span in spans) == pytest.approx(x_of(10) - x_of(0) + 2, abs=0.1)


def test_a_fine_curve_is_thinned_but_keeps_its_narrow_peak(painted):
    heading = np.arange(0, 360, 0.01)
    score = np.where(np.abs(heading - 77.77) < 0.006, 9.0, 1.0)
    orientation = replace(painted().orientation, curve_heading_deg=heading, curve_score=score, candidates=())
    drawing = score_curve_svg(orientation)
    assert len(drawing) < 12_000
    ys = np.cumsum([float(step) for step in re.search(r"l([-\d. ]+)Z", drawing).group(1).split()[1::2]])
    assert ys.min() < -100


def test_without_a_curve_or_an_answer_the_figures_say_so():
    nothing = Orientation("rejected", "no")
    assert "No heading was scored." in words(score_curve_svg(nothing))
    ElementTree.fromstring(score_rose_svg(nothing))
    flat = Orientation("rejected", "no", (), None, None, None, np.arange(0.0, 360), np.full(360, 2.0))
    ElementTree.fromstring(score_curve_svg(flat))
    unknown = Orientation("rejected", "no", (), None, None, None, np.arange(0.0, 360), np.full(360, np.nan))
    assert "No heading was scored." in words(score_curve_svg(unknown))


def test_the_rose_points_where_the_answer_looks(painted):
    drawing = score_rose_svg(painted().orientation, 121.0, 50.0, size=220)
    (mark,) = parts(drawing, "mark-best")
    angle = np.degrees(np.arctan2(float(mark.get("cx")) - 110, 110 - float(mark.get("cy"))))
    assert angle == pytest.approx(123.4, abs=0.1)
    assert len(parts(drawing, "view")) == 1
    assert [text for text in words(drawing) if text in "NESW"] == ["N", "E", "S", "W"]


@pytest.mark.parametrize("draw", [score_curve_svg, score_rose_svg])
def test_figures_say_in_words_what_they_show(painted, draw):
    said = ElementTree.fromstring(draw(painted().orientation, compass_true_deg=121.0))[1].text
    for expected in ("123.4°", "240.4°", "323.4°", "121.0°"):
        assert expected in said


def test_a_rose_of_probabilities_has_one_scale_for_all_places():
    heading = np.arange(0.0, 360.0)
    half, full = (probability_rose_svg(heading, np.full(360, value), size=234) for value in (0.5, 1.0))
    # The centre is at 117 and the rim 100 from it: to the north, a half ends at 67 and certainty at 17.
    assert "M117,67" in half.replace(".0", "").replace(" ", ",") and "M117,17" in full.replace(".0", "").replace(
        " ", ","
    )
    some = np.where(heading == 90, 0.8, np.where(heading < 180, 0.1, np.nan))
    drawing = probability_rose_svg(heading, some)
    assert "highest at azimuth 90" in drawing and "80 %" in drawing and "nan" not in drawing
    assert "no horizon here" in probability_rose_svg(heading, np.full(360, np.nan))
