"""Places on a track, their errors, and the reasons where there is none."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.messages import Message
from skyline_viewshed.core.track.track import TrackError, TrackOptions, local_m, place_at, speed_at, track_of

T0 = 1_700_000_000.0


def straight(step_s=60.0, count=11, speed=1.0):
    """Walk north at a speed [m/s]."""
    time = T0 + step_s * np.arange(count)
    north = np.degrees(speed * (time - T0) / 6_371_000.0)
    return track_of(time, np.full(count, 86.8), 27.9 + north, 4000 + 0.1 * (time - T0))


def test_between_points_the_place_is_linear_in_time():
    track = straight()
    place = place_at(track, T0 + 90.0)
    east, north = local_m(track, place.longitude_deg, place.latitude_deg)
    assert abs(north - 90.0) < 0.01 and abs(east) < 0.01 and place.elevation_m == pytest.approx(4009.0)
    assert place.gap_s == 60.0


def test_the_error_is_that_of_gps_at_a_point_and_grows_with_the_gap():
    fine, coarse = straight(10.0, 61), straight(600.0, 2)
    assert place_at(fine, T0 + 300.0).error_m == pytest.approx(5.0)
    errors = [place_at(coarse, T0 + s).error_m for s in (0.0, 60.0, 300.0, 540.0, 600.0)]
    assert errors[0] == errors[4] == pytest.approx(5.0) and errors[1] == pytest.approx(errors[3])
    assert errors[2] == pytest.approx(np.hypot(5.0, 1.2 * np.sqrt(150.0 * 20.0)))
    assert place_at(fine, T0 + 305.0).error_m < errors[1] < errors[2]


@pytest.mark.parametrize(
    "points, when, words",
    [
        ([0, 600, 4300], 2000.0, "gap of 62 min"),
        ([0, 600], -301.0, "5 min before the track begins"),
        ([0, 600], 600.0 + 7500.0, "2 h 5 min after the track ends"),
    ],
)
def test_where_the_track_has_nothing_the_reason_says_so(points, when, words):
    track = track_of([T0 + s for s in points], [86.8] * len(points), [27.9] * len(points))
    reason = place_at(track, T0 + when)
    assert isinstance(reason, Message) and words in reason


def test_just_beyond_an_end_the_last_place_holds_with_a_larger_error():
    place = place_at(straight(), T0 + 600.0 + 100.0)
    assert place.error_m == pytest.approx(np.hypot(5.0, 1.2 * np.sqrt(100.0 * 20.0))) and place.gap_s == 100.0


def test_points_in_any_order_twice_and_without_time():
    nan = float("nan")
    track = track_of([T0 + 60, T0, T0 + 60, nan, T0 + 90], [1.0, 0.0, 1.0, 5.0, nan], [46.0] * 5)
    assert track.time_s.tolist() == [T0, T0 + 60] and track.longitude_deg.tolist() == [0.0, 1.0]
    assert place_at(track, T0 + 30).elevation_m is None
    for times in ([], [T0], [nan, T0], [T0, T0]):
        with pytest.raises(TrackError, match="fewer than two"):
            track_of(times, [0.0] * len(times), [0.0] * len(times))


def test_a_track_across_180_degrees_takes_the_short_way():
    track = track_of([T0, T0 + 100], [179.999, -179.999], [0.0, 0.0])
    place = place_at(track, T0 + 50)
    assert abs(abs(place.longitude_deg) - 180) < 1e-9
    assert abs(float(local_m(track, place.longitude_deg, 0.0)[0]) - 111.2) < 1


def test_speed_and_bad_options():
    assert speed_at(straight(), T0 + 300) == pytest.approx(1.0, rel=1e-3)
    assert speed_at(straight(), T0 + 9e5) == 0.0
    with pytest.raises(ValueError, match="positive"):
        TrackOptions(max_gap_s=0)
