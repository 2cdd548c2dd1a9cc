"""The verdict on a recorded position; the whole check of photographs: tests/algorithms/test_position_check.py."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from fitted_places import places
from skyline_viewshed.core.base.curvature import METRES_PER_DEGREE
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.checking import CheckOptions, _checked, _rings, check_position
from skyline_viewshed.core.io.raster import open_dem

ORIENTED = SimpleNamespace(longitude_deg=8.0, latitude_deg=60.0, horizon=SimpleNamespace(cell_m=90.0))


def verdict(east_m, north_m, gain, score=5.0, turn_deg=2.0):
    """Check of a position from which the better place lies a way off."""
    x = 8.0 + east_m / (METRES_PER_DEGREE * np.cos(np.radians(60.0)))
    best = places([x], [60.0 + north_m / METRES_PER_DEGREE], [score])
    best = replace(best, trial=np.array([[359.0, 0, 0, 0, 0.0]]))
    near = replace(places([8.0], [60.0], [score - gain]), trial=np.array([[359.0 + turn_deg - 360, 0, 0, 0, 0.0]]))
    return _checked("a.jpg", ORIENTED, (near, best, gain), 0.02, CheckOptions())


def test_a_clear_gain_far_off_is_doubtful_with_the_way_there():
    found = verdict(-300.0, 400.0, 0.6)
    assert found.verdict == "doubtful"
    assert (found.east_m, found.north_m) == pytest.approx((-300.0, 400.0), abs=0.1)
    assert found.message.facts == {"distance": "500", "azimuth": "323", "turn": "2.0"}


@pytest.mark.parametrize(
    ("east_m", "gain", "score", "expected"),
    [
        (300.0, 0.49, 5.0, "believable"),
        (300.0, 0.5, 5.0, "doubtful"),
        (29.0, 2.0, 5.0, "believable"),  # within the error of any recorded position
        (31.0, 2.0, 5.0, "doubtful"),
        (300.0, 2.0, 2.9, "undecided"),
    ],
)
def test_the_limits_of_the_verdict(east_m, gain, score, expected):
    assert verdict(east_m, 0.0, gain, score).verdict == expected


def test_the_rings_reach_the_radius_and_hold_the_place_itself():
    offset = _rings(CheckOptions(radius_m=800.0))
    radius = np.hypot(*offset.T)
    assert offset[0].tolist() == [0.0, 0.0] and radius.max() == pytest.approx(800.0)
    assert np.unique(radius.round()).tolist() == [0, 160, 320, 480, 640, 800]


def test_a_photograph_that_cannot_be_oriented_fails_with_the_reason(scene):
    request = PhotoRequest(str(scene.odd / "damaged.jpg"), *scene.positions["north"])
    found = check_position(request, open_dem(str(scene.dem)))
    assert found.verdict == "failed" and found.message == found.oriented.orientation.message
    assert found.gain is None and found.east_m is None
