"""Time zones as users write them."""

from __future__ import annotations

from datetime import datetime

import pytest
from skyline_viewshed.core.track.track import TrackError
from skyline_viewshed.core.track.zone import seconds_utc, zone_of

NOON = datetime(2023, 10, 31, 12)


@pytest.mark.parametrize(
    "text, hours",
    [("+05:45", 5.75), ("-3", -3), ("UTC+1", 1), ("+0545", 5.75), ("Z", 0), (" utc ", 0), ("14", 14),
     ("Asia/Kathmandu", 5.75)],
)  # fmt: skip
def test_zones(text, hours):
    assert (
        seconds_utc(NOON, zone_of(text))
        == datetime(2023, 10, 31, 12).timestamp() - datetime(1970, 1, 1).timestamp() - 3600 * hours
    )


def test_none_and_nonsense():
    assert zone_of("") is None and zone_of(None) is None
    for text in ("Nepal time", "+25", "+05:99", "../../etc/passwd"):
        with pytest.raises(TrackError, match="time zone"):
            zone_of(text)
