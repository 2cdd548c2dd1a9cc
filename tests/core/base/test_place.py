"""Where a photograph was taken, and how certain that is."""

from types import SimpleNamespace

import pytest
from skyline_viewshed.core.base.errors import MissingMetadataError
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.place import position_error_of, position_of
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


@pytest.mark.parametrize("error_m", [65_000.0, 238_000.0, 1_001.0])
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
