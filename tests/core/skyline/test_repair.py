"""A skyline changed by hand: brushed parts are left out, strokes replace, and a mask reads back as the same line."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.model import Skyline, SkylineEvidence
from skyline_viewshed.core.skyline.given import evidence_from_mask
from skyline_viewshed.core.skyline.repair import (
    BrushStroke,
    brushed,
    edited_rows,
    full_size_line,
    joined,
    line_without,
    sky_mask,
)


@pytest.fixture
def evidence():
    """Evidence 100 x 60 of a picture 400 x 240: a false line at row 20, the true one at row 40."""
    probability = np.full((60, 100), 0.001, np.float32)
    probability[20], probability[40] = 0.6, 0.3
    best = Skyline(np.full(100, 20.0), np.ones(100), 100, 60)
    return SkylineEvidence(probability, best, 400, 240)


def test_a_stroke_covers_what_lies_within_its_radius():
    covered = brushed([BrushStroke(((100.0, 100.0), (300.0, 100.0)), 20.0)], (400, 240), (240, 400))
    rows, columns = np.nonzero(covered)
    assert (rows.min(), rows.max()) == (80, 120) and (columns.min(), columns.max()) == (80, 320)
    assert covered.sum() == pytest.approx(200 * 40 + np.pi * 400, rel=0.03)
    dot = brushed([BrushStroke(((0.0, 0.0),), 8.0)], (400, 240), (60, 100))
    assert dot[0, 0] and not dot[10, 10]


def test_brushing_over_the_line_takes_the_next_likely_row(evidence):
    left_out = np.zeros((60, 100), bool)
    left_out[15:25, 30:60] = True
    row = line_without(evidence, left_out)
    assert set(row[30:60]) == {40.0} and set(row[:30]) == {20.0}
    left_out[35:45, 50:60] = True
    row = line_without(evidence, left_out)
    assert np.isnan(row[50:60]).all() and set(row[30:50]) == {40.0}


def test_strokes_replace_stretches_of_the_line(evidence):
    x, y = full_size_line(evidence, evidence.best.row_px)
    assert (x[0], y[0]) == pytest.approx((1.5, 79.5))
    row = edited_rows(evidence, [[(200.0, 160.0), (100.0, 160.0)]], ())
    x, y = full_size_line(evidence, row)
    inside = (x >= 100) & (x <= 200)
    assert y[inside] == pytest.approx(160.0) and y[~inside] == pytest.approx(79.5)
    brush = [BrushStroke(((0.0, 79.5), (90.0, 79.5)), 12.0)]
    x, y = full_size_line(evidence, edited_rows(evidence, [[(200.0, 160.0), (100.0, 160.0)]], brush))
    assert y[x < 90] == pytest.approx(159.5) and y[x > 210] == pytest.approx(79.5)


def test_joined_strokes_run_from_left_to_right():
    strokes = [[(10.0, 5.0), (30.0, 5.0), (50.0, 5.0)], [(40.0, 9.0), (20.0, 9.0)]]
    assert joined(strokes) == ((10.0, 5.0), (20.0, 9.0), (40.0, 9.0), (50.0, 5.0))


def test_a_mask_reads_back_as_its_line():
    row = np.where(np.arange(512) < 100, np.nan, 150.0 + np.arange(512) / 10)
    given = evidence_from_mask(sky_mask(row, 384), 4096, 3072)
    assert np.array_equal(given.best.valid, np.isfinite(row))
    assert np.nanmax(np.abs(given.best.row_px - row)[100:]) <= 0.5
