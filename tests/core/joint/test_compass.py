"""The compass of one device within an hour."""

from __future__ import annotations

import pytest
from joint_walks import photo
from skyline_viewshed.core.joint.circle import probability_near
from skyline_viewshed.core.joint.compass import WORTHLESS_SHARE, device_hours, reading_error, reading_of_tree


def test_the_error_has_a_core_faults_and_a_worthless_share():
    error = reading_error()
    assert error.mean() == pytest.approx(1.0)
    assert error.min() == pytest.approx(WORTHLESS_SHARE, rel=0.05)
    core, quarter, half = probability_near(error, [0.0, 90.0, 180.0], 30.0)
    assert core > 0.8 and quarter == pytest.approx(0.02 + WORTHLESS_SHARE / 6, abs=5e-3) and half < quarter


def test_groups_are_those_of_one_device_within_an_hour():
    photos = [
        photo("a.jpg", "accepted", compass=10.0, minutes=0),
        photo("b.jpg", "accepted", compass=10.0, minutes=59),
        photo("c.jpg", "accepted", compass=10.0, minutes=61),
        photo("d.jpg", "accepted", compass=10.0, minutes=5, device="Other phone"),
        photo("e.jpg", "accepted", minutes=6),
    ]
    groups = device_hours(photos)
    assert groups[0] == groups[1] and len({groups[0], groups[2], groups[3]}) == 3 and 4 not in groups


def test_tied_photographs_have_one_reading():
    photos = [photo(f"{k}.jpg", "accepted", compass=reading) for k, reading in enumerate((5.0, 27.0, 300.0, None))]
    headings = {0: 358.0, 1: 20.0, 2: 40.0, 3: 0.0}
    group, reading, told = reading_of_tree(photos, [0, 1, 2, 3], headings, device_hours(photos))
    assert reading == pytest.approx(5.0) and told == [0, 1, 2]
    assert reading_of_tree(photos, [3], headings, device_hours(photos)) is None
