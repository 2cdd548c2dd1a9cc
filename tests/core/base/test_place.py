"""Where a photograph was taken, and how certain that is."""

from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import MissingMetadataError
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.place import doubts_of_place, position_error_of, position_of
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.uncertainty import TYPICAL_POSITION_ERROR_M

RECORDED = (7.9, 46.5)


def request(position=(None, None), prefer=False, error=None):
    longitude, latitude = position
    return SimpleNamespace(
        longitude_deg=longitude, latitude_deg=latitude, prefer_photo_position=prefer, position_error_m=error
    )


def photo(position=RECORDED, error=None):
    return PhotoMetadata("a.jpg", 4, 3, longitude_deg=position[0], latitude_deg=position[1], position_error_m=error)


def test_given_comes_before_recorded_unless_that_is_preferred():
    assert position_of(request((8.0, 46.0)), photo()) == (8.0, 46.0)
    assert position_of(request((8.0, 46.0), prefer=True), photo()) == RECORDED
    assert position_of(request(), photo()) == RECORDED


@pytest.mark.parametrize("none", [(None, None), (0, 0), (float("nan"), 46.0), (8.0, 91.0)])
def test_what_is_no_position_does_not_count(none):
    assert position_of(request(none), photo()) == RECORDED
    with pytest.raises(MissingMetadataError, match="no GPS position"):
        position_of(request(none), photo((None, None)))


@pytest.mark.parametrize("error_m", [65_000.0, 238_000.0, 1_000.0])
def test_a_position_that_decides_nothing_is_refused_also_as_a_point_of_a_layer(error_m):
    for given in ((None, None), RECORDED, (RECORDED[0] + 1e-6, RECORDED[1])):
        with pytest.raises(MissingMetadataError, match="uncertain by .* km"):
            position_error_of(request(given), photo(error=error_m))


def test_a_point_that_was_moved_has_lost_the_error_of_the_file():
    assert position_error_of(request((7.95, 46.5)), photo(error=65_000.0)) == TYPICAL_POSITION_ERROR_M


def test_the_given_error_comes_first_then_the_recorded_one():
    assert position_error_of(request(error=30.0), photo(error=65_000.0)) == 30.0
    assert position_error_of(request(RECORDED), photo(error=12.0)) == 12.0
    assert position_error_of(request(), photo()) == TYPICAL_POSITION_ERROR_M


@pytest.mark.parametrize(
    "observer, error_m, words",
    [
        (Observer(0.0, 0.0), None, []),
        (Observer(0.0, 0.0, 120.0), 999.0, []),
        (Observer(0.0, 0.0, 1.7, 1910.0), None, []),
        (Observer(0.0, 0.0, 1.7, 1890.0), None, ["110 m below"]),
        (Observer(0.0, 0.0, 1.7, 6562.0), 1_000.0, ["uncertain by 1.0 km", "4562 m above"]),
        (Observer(0.0, 0.0, 2000.0), None, ["2000 m above"]),
    ],
)
def test_an_eye_in_an_unlikely_place_is_said(observer, error_m, words):
    terrain = ArrayTerrain(np.full((9, 9), 2000.0, np.float32), 30.0)
    doubts = doubts_of_place(terrain, observer, error_m)
    assert len(doubts) == len(words) and all(part in str(doubt) for part, doubt in zip(words, doubts))
