from __future__ import annotations

from datetime import datetime

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.base.landmark_hint import LandmarkHint
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.sun_moon import direction_deg
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer

OBSERVER = Observer(8.0, 46.5, 2.0)


def metadata(**more):
    return PhotoMetadata("", 800, 600, **more)


@pytest.mark.parametrize("wrong", [{}, {"body": "comet"}, {"longitude_deg": 8.0}])
def test_a_pixel_needs_a_map_point_or_a_body(wrong):
    with pytest.raises(ValueError, match="body"):
        LandmarkHint(1.0, 2.0, **wrong)


def test_a_map_point_to_the_east_at_the_height_of_the_eye_is_seen_level():
    plain = ArrayTerrain(np.full((60, 60), 500.0, np.float32), 100.0, 8.0, 46.5)
    azimuth, elevation = LandmarkHint(1.0, 2.0, 8.01, 46.5, 502.0).direction_deg(plain, OBSERVER, metadata())
    assert azimuth == pytest.approx(90.0, abs=0.01) and elevation == pytest.approx(0.0, abs=0.02)


def test_the_sun_is_seen_by_the_clock_in_its_zone_whatever_the_terrain():
    taken = metadata(taken_at=datetime(2024, 6, 20, 14, 0), utc_offset_s=7200.0)
    expected = direction_deg("sun", 8.0, 46.5, datetime(2024, 6, 20, 12, 0))
    assert LandmarkHint(1.0, 2.0, body="sun").direction_deg(None, OBSERVER, taken) == expected


@pytest.mark.parametrize(
    ("known", "reason"),
    [
        ({}, "does not record its time with a time zone"),
        ({"taken_at": datetime(2024, 6, 20, 14, 0)}, "does not record its time with a time zone"),
        ({"taken_at": datetime(2024, 6, 20, 0, 0), "utc_offset_s": 0.0}, r"below the horizon at 2024-06-20 00:00"),
    ],
)
def test_a_body_without_a_place_in_the_sky_is_told(known, reason):
    with pytest.raises(PhotoError, match=reason):
        LandmarkHint(1.0, 2.0, body="sun").direction_deg(None, OBSERVER, metadata(**known))
