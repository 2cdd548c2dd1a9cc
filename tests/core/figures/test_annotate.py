from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest
from skyline_viewshed.core.figures.annotate import NamedPoint, Stroke, annotate, annotation_pixels, annotation_svg

pytest.importorskip("PIL")


def sample():
    pixels = np.full((300, 400, 3), 90, np.uint8)
    points = [NamedPoint("Everest & <co> 8849 m", 800.0, 700.0), NamedPoint("Lhotse 8516 m", 900.0, 720.0)]
    strokes = [Stroke([100, 900], [1000, 1000]), Stroke([900, 1500], [1000, 900], visible=False)]
    return annotate(pixels, 1600, points, strokes, width_px=800)


def test_marks_are_scaled_from_the_full_picture_to_the_drawing():
    annotation = sample()
    assert annotation.pixels.shape == (600, 800, 3)
    assert annotation.points[0].x_px == pytest.approx((800.5) / 2 - 0.5)
    assert annotation.strokes[0].y_px == pytest.approx([499.75, 499.75])
    assert len(annotation.labels) == 2


def test_burning_in_changes_the_picture_at_the_marks_only():
    annotation = sample()
    burnt = annotation_pixels(annotation)
    changed = (burnt != annotation.pixels).any(axis=2)
    assert changed[500, 60:440].mean() > 0.95 and changed[350, 400]
    assert not changed[:100].any() and not changed[560:].any()
    assert (annotation.pixels == 90).all()


def test_the_svg_is_one_well_formed_file_with_picture_and_words():
    root = ET.fromstring(annotation_svg(sample()))
    tag = "{http://www.w3.org/2000/svg}"
    assert root.find(f"{tag}image").get("href").startswith("data:image/jpeg;base64,")
    assert [e.text for e in root.iter(f"{tag}text")] == ["Everest & <co> 8849 m", "Lhotse 8516 m"]
    assert len(list(root.iter(f"{tag}circle"))) == 2


def test_a_picture_without_marks_stays_as_it_is():
    annotation = annotate(np.full((30, 40, 3), 7, np.uint8), 40, width_px=40)
    assert (annotation_pixels(annotation) == 7).all()
