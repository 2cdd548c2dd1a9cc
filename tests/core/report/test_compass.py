"""The compass audit in the report."""

from __future__ import annotations

from datetime import datetime

import numpy as np
from documents import report_html
from skyline_viewshed.core.report.audit import Reading
from skyline_viewshed.core.report.compass import compass_panel


def readings(device, error):
    return [Reading(device, datetime(2024, 7, 1, 6 + k % 12), float(value)) for k, value in enumerate(error)]


def test_each_device_has_a_row_with_its_numbers():
    error = np.r_[np.linspace(1, 9, 30), np.full(5, 95.0)]
    panel = compass_panel(readings("Maker <b> 1", error) + readings("", [1.0, 2.0, 3.0]))
    assert panel.count("<tr>") == 3
    assert "Maker &lt;b&gt; 1" in panel and "unknown" in panel
    assert "+5.0° (" in panel and "5 (14 %)" in panel and "5, 0, 0 (turned)" in panel
    assert "<svg" in panel


def test_hardly_any_readings_are_no_audit():
    assert compass_panel(readings("A", [1.0, 2.0])) == ""


def test_the_report_audits_reliable_photographs(painted):
    def said(status):
        return report_html([painted(status) for _ in range(3)], "t")

    assert "<summary>Compasses</summary>" in said("accepted") and "−2.4°" in said("accepted")
    assert "Compasses" not in said("rejected")
