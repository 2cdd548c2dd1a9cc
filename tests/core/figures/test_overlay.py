"""The overlay: right colours in the right places, as pixels and as layers."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from skyline_viewshed.core.base.model import SkylineEvidence
from skyline_viewshed.core.base.overlay_lines import photo_lines
from skyline_viewshed.core.figures.overlay import (
    BEST,
    EXTRACTED,
    evidence_rgba,
    focus_box,
    overlay_image,
    overlay_svg_lines,
)

pytest.importorskip("PIL")


def near(pixels, colour, tolerance=60):
    return (np.abs(pixels.astype(int) - colour).max(axis=2) < tolerance).nonzero()


def test_the_overlay_looks_as_it_did(painted, golden_difference):
    mean, worst = golden_difference("overlay", overlay_image(painted(), 320, legend=False))
    assert mean < 0.5
    assert worst < 15


def test_an_overlay_of_another_heading_does_not_look_like_it(painted, golden_difference):
    photo = painted()
    best = photo.orientation.candidates[0]
    moved = replace(best, pose=replace(best.pose, pitch_deg=best.pose.pitch_deg + 2))
    photo = replace(
        photo, orientation=replace(photo.orientation, candidates=(moved, *photo.orientation.candidates[1:]))
    )
    mean, worst = golden_difference("overlay", overlay_image(photo, 320, legend=False))
    assert mean > 0.5
    assert worst > 15


def test_the_answers_line_lies_on_the_projected_horizon(painted):
    pixels = overlay_image(painted(skyline=None, evidence=None), 1024, legend=False)
    line = photo_lines(painted())[1][0]
    known = np.isfinite(line.x_px)
    rows, columns = near(pixels, BEST, 30)
    assert len(np.unique(columns)) > 900
    expected = np.interp(columns, line.x_px[known], line.y_px[known])
    assert np.percentile(np.abs(rows - expected), 95) < 4


@pytest.mark.parametrize("ground", [0, 128, 255])
def test_lines_stand_out_on_any_ground(painted, ground):
    plain = painted(preview=np.full((192, 256, 3), ground, np.uint8), evidence=None)
    pixels = overlay_image(plain, 512, legend=False).astype(int)
    changed = np.abs(pixels - ground).max(axis=2)
    assert (changed > 90).any(axis=0).mean() > 0.98


def test_what_is_missing_is_left_out(painted):
    photo = painted()
    only_skyline = replace(photo, orientation=replace(photo.orientation, candidates=()), horizon=None)
    pixels = overlay_image(only_skyline, 256, evidence=False)
    assert len(near(pixels, EXTRACTED)[0]) > 100
    assert len(near(pixels, BEST)[0]) == 0
    with pytest.raises(ValueError, match="no preview"):
        overlay_image(replace(photo, preview=None))


def test_evidence_tints_rows_that_are_likely_and_leaves_columns_clear_that_know_nothing(painted):
    probability = np.full((100, 40), 1 / 100, np.float32)
    probability[:, 20:] = 0.0
    probability[30, 20:] = 1.0
    rgba = evidence_rgba(SkylineEvidence(probability, painted().skyline, 400, 1000))
    assert rgba.shape == (100, 40, 4)
    assert rgba[30, 20:, 3].min() > 100
    assert rgba[:, :20, 3].max() == 0
    assert rgba[:20, :, 3].max() == 0
    assert len(np.unique(rgba[..., 3])) <= 16


def test_layers_carry_classes_for_each_line_and_unique_names(painted):
    layers = overlay_svg_lines(painted(), "p7")
    root = ElementTree.fromstring(f'<svg xmlns:xlink="l">{layers}</svg>')
    classes = [group.get("class") for group in root]
    assert classes == ["line-alternative rank3", "line-alternative rank2", "line-extracted", "line-best"]
    names = [part.get("id") for part in root.iter() if part.get("id")]
    assert len(names) == len(set(names))
    used = [part.get("{l}href") for part in root.iter() if part.tag == "use"]
    assert {name[1:] for name in used} == set(names)
    assert all(name.startswith("p7-") for name in names)
    x = [float(value) for value in re.findall(r"M([-\d.]+) ", layers)]
    assert max(x) < 1300  # the picture is 1000 wide


def test_the_focus_keeps_the_skyline_in_sight(painted):
    photo = painted()
    x, top, width, height = focus_box(photo)
    rows = photo_lines(photo)[0].y_px
    assert (x, width) == (0, 1024)
    assert top <= np.percentile(rows, 2)
    assert np.percentile(rows, 98) <= top + height
    assert height < 768
    tall = focus_box(painted(skyline=None, orientation=replace(photo.orientation, candidates=())))
    assert tall == (0, 0, 1024, 768)
