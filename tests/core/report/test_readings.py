"""The drawing of compass readings."""

from __future__ import annotations

import re

import numpy as np
from skyline_viewshed.core.report.readings import compass_svg


def test_every_reading_with_a_time_is_a_dot_and_far_ones_lie_at_the_edge():
    hours, error = np.array([6.0, 8.0, np.nan, 10.0]), np.array([0.0, 170.0, 5.0, -5.0])
    drawing = compass_svg([(hours, error, 1.0), (np.array([7.5]), np.array([3.0]), None)])
    first, second = re.findall(r'<path d="([^"]*)" class="dots device(?:\d)"', drawing)
    assert first.count("h0") == 3 and second.count("h0") == 1
    rows = [float(row) for row in re.findall(r"M[\d.]+ ([\d.]+)h0", first)]
    assert rows[1] == min(rows) == 14.0 and rows[0] == (14 + 266) / 2
    assert drawing.count('class="bias') == 1
    assert "5 readings" in drawing


def test_without_times_the_circle_is_still_drawn():
    drawing = compass_svg([(np.full(3, np.nan), np.array([1.0, 2.0, 91.0]), 1.5)])
    assert "dots" not in drawing and drawing.count('class="bars"') == 2
    assert "nan" not in drawing


def test_more_devices_than_colours_share_the_last():
    drawing = compass_svg([(np.array([6.0]), np.array([1.0]), None)] * 6)
    assert [drawing.count(f"dots device{k}") for k in range(5)] == [1, 1, 1, 3, 0]
