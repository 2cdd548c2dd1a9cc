"""A track, and the place on it at a time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.curvature import METRES_PER_DEGREE
from ..base.errors import SkylineViewshedError
from ..base.messages import Message


class TrackError(SkylineViewshedError):
    """The track cannot be used."""


@dataclass(frozen=True)
class TrackOptions:
    """How places between and beyond the points of a track are determined.

    Attributes
    ----------
    max_gap_s : float
        Longest time between two points that is interpolated; beyond the track's ends, half of it [s].
    gps_error_m : float
        Standard deviation of a track point [m].
    wander_m_per_s, wander_s : float
        Speed at which the person may leave the straight line between two points [m/s], and the time for which a
        direction is kept [s]: the error between two points is that of a random walk tied at both.
    """

    max_gap_s: float = 600.0
    gps_error_m: float = 5.0
    wander_m_per_s: float = 1.2
    wander_s: float = 20.0

    def __post_init__(self):
        if not self.max_gap_s > 0 or not self.gps_error_m > 0:
            raise ValueError(f"the gap and the error must be positive: {self}")


@dataclass(frozen=True, eq=False)
class Track:
    """Points in the order of their times.

    Attributes
    ----------
    time_s : (N,) array
        Seconds since 1970, UTC.
    longitude_deg, latitude_deg : (N,) arrays
        WGS 84 [degrees].
    elevation_m : (N,) array
        NaN where unknown [m].
    """

    time_s: np.ndarray
    longitude_deg: np.ndarray
    latitude_deg: np.ndarray
    elevation_m: np.ndarray

    @property
    def span_s(self):
        """First and last time [s]."""
        return float(self.time_s[0]), float(self.time_s[-1])


@dataclass(frozen=True)
class Placed:
    """Where a photograph was taken.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 [degrees].
    elevation_m : float or None
        As the track has it [m].
    error_m : float
        Standard deviation along each axis [m].
    gap_s : float
        Time between the two track points around it, or to the nearest one beyond the ends [s].
    """

    longitude_deg: float
    latitude_deg: float
    elevation_m: float | None
    error_m: float
    gap_s: float


def track_of(time_s, longitude_deg, latitude_deg, elevation_m=None):
    """Make a `Track` of points in any order; points without a time or a position are left out.

    Parameters
    ----------
    time_s, longitude_deg, latitude_deg : sequences of float
        NaN where unknown.
    elevation_m : sequence of float or None

    Raises
    ------
    TrackError
        Fewer than two points have a time and a position.
    """
    columns = [np.asarray(column, float) for column in (time_s, longitude_deg, latitude_deg)]
    height = np.full(len(columns[0]), np.nan) if elevation_m is None else np.asarray(elevation_m, float)
    known = np.isfinite(columns).all(axis=0) if len(columns[0]) else np.zeros(0, bool)
    known &= np.abs(columns[2]) <= 90
    time, first = np.unique(columns[0][known], return_index=True)
    if len(time) < 2:
        raise TrackError(
            Message("The track has fewer than two points with a time. Choose a recorded track, not a planned route.")
        )
    return Track(time, *(column[known][first] for column in (*columns[1:], height)))


def place_at(track, time_s, options=TrackOptions()):  # noqa: B008 - frozen
    """Find the place on a track at a time.

    Parameters
    ----------
    track : Track
    time_s : float
        Seconds since 1970, UTC.
    options : TrackOptions

    Returns
    -------
    Placed or Message
        The reason, if the track has no place at that time.
    """
    times = track.time_s
    if not times[0] <= time_s <= times[-1]:
        index = 0 if time_s < times[0] else len(times) - 1
        beyond_s = float(abs(time_s - times[index]))
        if beyond_s <= options.max_gap_s / 2:
            return _placed(track, index, index, 0.0, _error_m(options, beyond_s), beyond_s)
        if index == 0:
            return Message("The photo was taken {time} before the track begins.", time=_in_words(beyond_s))
        return Message("The photo was taken {time} after the track ends.", time=_in_words(beyond_s))
    after = min(max(int(np.searchsorted(times, time_s)), 1), len(times) - 1)
    gap_s = float(times[after] - times[after - 1])
    before_s = float(time_s - times[after - 1])
    if gap_s > options.max_gap_s and min(before_s, gap_s - before_s) > 0:
        return Message("The track has a gap of {time} around the photo.", time=_in_words(gap_s))
    free_s = before_s * (gap_s - before_s) / gap_s
    return _placed(track, after - 1, after, before_s / gap_s, _error_m(options, free_s), gap_s)


def local_m(track, longitude_deg, latitude_deg):
    """Give metres (east, north) from the track's first point, good to a percent over the length of a walk.

    Parameters
    ----------
    track : Track
    longitude_deg, latitude_deg : float or array
    """
    east = (longitude_deg - track.longitude_deg[0] + 180) % 360 - 180
    north = latitude_deg - track.latitude_deg[0]
    return east * METRES_PER_DEGREE * np.cos(np.radians(track.latitude_deg[0])), north * METRES_PER_DEGREE


def _placed(track, first, second, share, error_m, gap_s):
    turn = (track.longitude_deg[second] - track.longitude_deg[first] + 180) % 360 - 180
    longitude = (track.longitude_deg[first] + share * turn + 180) % 360 - 180
    latitude, height = (
        (1 - share) * column[first] + share * column[second] for column in (track.latitude_deg, track.elevation_m)
    )
    height = float(height) if np.isfinite(height) else None
    return Placed(float(longitude), float(latitude), height, error_m, gap_s)


def _error_m(options, free_s):
    """Error after a time during which nothing held the person to the line [m]."""
    wandered_m = options.wander_m_per_s * np.sqrt(free_s * min(options.wander_s, free_s))
    return float(np.hypot(options.gps_error_m, wandered_m))


def _in_words(seconds):
    """Time as hours and minutes, or as seconds if it is short."""
    if seconds < 120:
        return f"{seconds:.0f} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 120 else f"{minutes // 60} h {minutes % 60} min"


def speed_at(track, time_s, around_s=60.0):
    """Speed along a track around a time [m/s], for the error that an error of the clock makes.

    Parameters
    ----------
    track : Track
    time_s : float
        Seconds since 1970, UTC.
    around_s : float
        Half the time over which it is taken [s].
    """
    times = np.clip([time_s - around_s, time_s + around_s], *track.span_s)
    east, north = local_m(track, track.longitude_deg, track.latitude_deg)
    moved = np.hypot(*(np.diff(np.interp(times, track.time_s, column))[0] for column in (east, north)))
    return float(moved / max(times[1] - times[0], 1.0))
