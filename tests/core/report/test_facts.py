"""Numbers of the report."""

from __future__ import annotations

from dataclasses import replace

import pytest
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto
from skyline_viewshed.core.report.facts import fact_groups, file_name, interval_words, percent, summarise


@pytest.mark.parametrize(
    ("path", "name"),
    [("/a/b c.jpg", "b c.jpg"), ("C:\\a\\b.jpg", "b.jpg"), ("b.jpg", "b.jpg"), ("/a/b/", "b"), ("", ""), ("/", "/")],
)
def test_names_come_without_folders_of_any_system(path, name):
    assert file_name(path) == name


@pytest.mark.parametrize(
    ("share", "words"),
    [(0.5, "50 %"), (0.97, "97.0 %"), (0.9996, ">99.9 %"), (1, "100 %"), (0.0002, "<0.1 %"), (0, "0 %"), (None, "–")],
)
def test_what_is_not_certain_is_never_called_100_per_cent(share, words):
    assert percent(share) == words


def test_the_summary_holds_what_the_overview_sorts_by(painted):
    summary = summarise(painted())
    assert summary.heading_deg == pytest.approx(123.4)
    assert summary.half_interval_deg == pytest.approx(0.4)
    assert summary.second_deg == pytest.approx(240.4)
    assert summary.compass_difference_deg == pytest.approx(-2.4)
    assert summary.hfov_deg == pytest.approx(50, abs=0.1)
    assert summary.residual_deg == pytest.approx(summary.residual_px / (1024 / 2 / 0.4663) * 57.3, rel=0.01)


def test_intervals_and_differences_go_across_north(painted):
    photo = painted(heading_deg=359.9, compass_true_deg=2.0)
    assert interval_words(photo.orientation) == "359.50° to 0.30° (±0.40°)"
    assert summarise(photo).compass_difference_deg == pytest.approx(2.1)


def test_every_number_has_a_unit(painted):
    groups = dict(fact_groups(painted(), {"Feature id": 7}))
    assert groups["Other values"] == [("Feature id", "7")]
    assert ("Eye above the DEM", "+1.7\u00a0m") in groups["Position and elevation"]
    assert ("Altitude, EXIF", "2\u202f000.0\u00a0m (sea level)") in groups["Position and elevation"]
    assert ("Recorded", "121.0° (from true north)") in groups["Compass"]
    assert ("Grid north from true north", "+0.70°") in groups["DEM horizon"]
    assert ("35 mm equivalent, EXIF", "24.0\u00a0mm") in groups["Lens"]
    assert ("Taken, camera's time", "2024-07-01 06:30:00") in groups["File"]


def test_magnetic_and_unknown_references_are_said(painted):
    photo = painted()
    for code, words in (("M", "from magnetic north"), (None, "reference unknown"), ("X", "reference unknown")):
        metadata = replace(photo.metadata, compass_reference=code)
        assert ("Recorded", f"121.0° ({words})") in dict(fact_groups(replace(photo, metadata=metadata)))["Compass"]


def test_the_angles_of_a_drone_s_gimbal_are_shown_if_there_are_any(painted):
    photo = painted()
    assert not [label for label, _ in dict(fact_groups(photo))["Compass"] if "gimbal" in label]
    metadata = replace(photo.metadata, gimbal_pitch_deg=-4.5)
    rows = dict(fact_groups(replace(photo, metadata=metadata)))["Compass"]
    assert ("Pitch of the gimbal, + up", "−4.5°") in rows
    assert ("Roll of the gimbal, + right side down", "–") in rows


def test_a_photo_of_which_nothing_is_known_has_its_path_only():
    photo = OrientedPhoto("/x/y.jpg", Orientation("failed", "no"))
    assert fact_groups(photo) == [("File", [("Path", "/x/y.jpg")])]
    assert summarise(photo).heading_deg is None
