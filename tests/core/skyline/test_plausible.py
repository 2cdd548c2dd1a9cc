"""Pictures without a mountain skyline are refused with that reason."""

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.base.model import Skyline, SkylineEvidence
from skyline_viewshed.core.skyline.evidence import skyline_evidence
from skyline_viewshed.core.skyline.plausible import check_skyline


def evidence(row_px, confidence=0.9):
    row_px = np.asarray(row_px, float)
    line = Skyline(row_px, np.full(len(row_px), confidence), len(row_px), 384)
    return SkylineEvidence(np.zeros((384, len(row_px)), np.float32), line, len(row_px), 384)


STEPS = np.repeat([256.0, 144.0, 256.0, 192.0, 256.0], [60, 140, 80, 140, 92])
RIDGE = 150 + 40 * np.sin(np.arange(512) / 40) + 10 * np.sin(np.arange(512) / 7)


def test_steps_are_no_mountains_even_with_slanted_joints():
    slanted = STEPS.copy()
    for start in (60, 200, 280, 420):
        slanted[start - 4 : start + 4] = np.linspace(slanted[start - 5], slanted[start + 5], 8)
    for line in (STEPS, slanted):
        with pytest.raises(SkylineNotFoundError, match="shows no mountain skyline.*supply a sky mask"):
            check_skyline(evidence(line))


@pytest.mark.parametrize(
    "line",
    [
        RIDGE,
        np.full(512, 200.0),
        np.where(np.arange(512) < 300, 200.0, RIDGE),
        np.round(RIDGE),
        STEPS + np.arange(512) / 20,
    ],
)
def test_ridges_seas_and_tilted_lines_pass(line):
    check_skyline(evidence(line))


@pytest.mark.parametrize("confidence", [0.03, 0.28, np.where(np.arange(512) < 50, 0.9, 0.1)])
def test_a_line_that_is_likely_in_few_columns_is_none_unless_landmarks_decide(confidence):
    with pytest.raises(SkylineNotFoundError, match="no line separates sky from terrain"):
        check_skyline(evidence(RIDGE, confidence))
    check_skyline(evidence(RIDGE, confidence), needed=False)


def test_a_skyline_that_clouds_hide_for_the_most_part_passes():
    check_skyline(evidence(RIDGE, np.where(np.arange(512) < 100, 0.9, 0.0)))


def test_the_night_is_refused():
    dark = np.random.default_rng(3).normal(12, 6, (600, 800, 3))
    with pytest.raises(SkylineNotFoundError, match="no line separates sky from terrain"):
        check_skyline(skyline_evidence(np.clip(dark, 0, 255).astype(np.uint8)))


def room(height=600, width=800):
    """A wall with a cupboard and a window above a floor."""
    pixels = np.full((height, width, 3), (190, 180, 165), np.uint8)
    pixels[400:] = (110, 80, 60)
    pixels[225:400, 100:300] = (90, 60, 50)
    pixels[300:, 450:650] = (60, 60, 65)
    return np.clip(pixels + np.random.default_rng(2).normal(0, 2, pixels.shape), 0, 255).astype(np.uint8)


def test_a_made_up_room_is_refused():
    with pytest.raises(SkylineNotFoundError, match="as in a room or on a page"):
        check_skyline(skyline_evidence(room()))
