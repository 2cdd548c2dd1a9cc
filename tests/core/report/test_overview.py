"""The table of all photographs and the switches above it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from skyline_viewshed.core.report import overview
from skyline_viewshed.core.report.facts import STATUSES, Summary
from skyline_viewshed.core.report.overview import badge, bar, columns, number_cell, overview_table, switches


def summary(status="accepted", **values):
    return Summary("a.jpg", status, "Why.", **values)


def cells_of(table):
    return re.findall(r'<td[^>]*data-sort="([^"]*)"[^>]*>(.*?)</td>', table)


def test_unknown_numbers_are_dashes_that_sort_last():
    cells = cells_of(overview_table([summary(heading_deg=12.0)]))
    assert len(cells) == len(columns(str)) == 11
    assert cells[2] == ("12", "12.0° NNE")
    assert {sort for sort, _ in cells[3:]} == {""}
    assert {words for _, words in cells[3:]} == {"–"}


def test_shares_near_certainty_are_escaped():
    cells = cells_of(overview_table([summary(heading_deg=1.0, p_correct=0.9997), summary(p_correct=0.0002)]))
    assert cells[4] == ("0.9997", "&gt;99.9 %") and cells[15] == ("0.0002", "&lt;0.1 %")


def test_a_photo_without_an_answer_says_why_beside_its_name():
    first, second = re.findall(r"<tr class.*?</tr>", overview_table([summary("failed"), summary(heading_deg=1.0)]))
    assert "Why." in first and "Why." not in second
    assert 'href="#photo-1"' in first and 'href="#photo-2"' in second


@pytest.mark.parametrize("value", [None, np.nan, np.inf])
def test_a_number_that_is_none_has_nothing_to_sort_by(value):
    assert 'data-sort=""' in number_cell(value, "–")


def test_the_bar_counts_each_status_that_there_is():
    shown = bar([summary(), summary(), summary("rejected")])
    assert "✓ accepted 2" in shown and "✕ rejected 1" in shown and "all 3" in shown
    assert "ambiguous" not in shown and "failed" not in shown


def test_every_status_has_a_switch_a_sign_and_a_word():
    inputs = re.findall(r'id="([^"]+)"', switches())
    assert len(inputs) == len(set(inputs)) and {f"show-{status}" for status in STATUSES} < set(inputs)
    assert switches().count(" checked") == 1 + 4
    assert len({badge(status) for status in STATUSES}) == len(STATUSES)


def test_every_status_has_its_own_colours_in_the_style_sheet():
    sheet = (Path(overview.__file__).parent / "report.css").read_text(encoding="utf-8")
    for status in STATUSES:
        assert f".is-{status} .badge{{background:var(--{status})}}" in sheet
        assert f"#show-{status}:checked~.page .item:not(.is-{status})" in sheet
        assert f"#show-{status}:checked~.bar [for=show-{status}]" in sheet
        assert len(set(re.findall(rf"--{status}:(#\w+)", sheet))) == 2, "one for light pages and one for dark ones"
    assert len({re.search(rf"--{status}:(#\w+)", sheet).group(1) for status in STATUSES}) == len(STATUSES)
