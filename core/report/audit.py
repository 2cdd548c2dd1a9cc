"""What a collection says about the compasses of its cameras: bias, spread, worthless readings, turned ones, drift.

A reading is the recorded heading minus the one found. Up to half of the readings may be worthless without harm, so
medians are used throughout, and intervals come from the order of the readings, whatever their distribution.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime

import numpy as np

from ..base.angles import wrap_180
from ..base.status import RELIABLE
from .facts import compass_difference_deg, status_of

WORTHLESS_DEG = 30.0
"""A reading farther than this from the heading found is worthless: most lenses see less to each side."""

TURNS_DEG = (90.0, -90.0, 180.0)
"""Differences that a compass shows if the phone takes portrait for landscape, or the reverse."""

LEAST_TURNED, LEAST_FOR_SPREAD, LEAST_FOR_DRIFT = 3, 3, 8
"""Fewest readings for a fault of 90 or 180 degrees, for a bias and a spread, and for a drift."""

SIGNIFICANT = 0.01
"""Chance below which so many worthless readings near one turn are no accident."""

LEVEL = 0.9
"""Confidence of all intervals."""

TRUSTED_HOURS = 0.1
"""Readings less far apart say nothing about a drift; a pair of them would give an arbitrary slope [h]."""

MOST_OF_A_DAY = 400
"""Readings of one day from which slopes are taken; more are thinned evenly, as their number grows with the square."""


@dataclass(frozen=True)
class Reading:
    """A compass reading of one photograph: device, time or None, and recorded minus found heading [degrees]."""

    device: str
    taken_at: datetime | None
    difference_deg: float


@dataclass(frozen=True)
class DeviceAudit:
    """What the readings of one device show; None if there are too few readings, or they agree on no direction.

    Attributes
    ----------
    device : str
        Maker and model, and the software where the file names it; '' if unknown.
    count : int
        Number of readings.
    bias_deg, bias_lo_deg, bias_hi_deg : float or None
        Median of the readings that are not worthless, recorded minus found, and its 90 % interval [degrees].
    spread_deg : float or None
        Standard deviation of a normal distribution with their median absolute deviation [degrees].
    worthless : int
        Readings more than `WORTHLESS_DEG` from the heading found.
    turned : (int, int, int)
        Readings near +90, -90 and 180 degrees from the bias.
    turned_fault : bool
        Whether there are too many near one of them for chance.
    drift_deg_per_h, drift_lo_deg_per_h, drift_hi_deg_per_h : float or None
        Change of the bias during a day, and its 90 % interval [degrees per hour].
    """

    device: str
    count: int
    bias_deg: float | None = None
    bias_lo_deg: float | None = None
    bias_hi_deg: float | None = None
    spread_deg: float | None = None
    worthless: int = 0
    turned: tuple[int, int, int] = (0, 0, 0)
    turned_fault: bool = False
    drift_deg_per_h: float | None = None
    drift_lo_deg_per_h: float | None = None
    drift_hi_deg_per_h: float | None = None


def reading_of(photo):
    """Reading of an `OrientedPhoto`, or None if its heading is not reliable or it has no compass."""
    difference_deg = compass_difference_deg(photo)
    if difference_deg is None or status_of(photo) not in RELIABLE:
        return None
    metadata = photo.metadata
    device = "" if metadata is None else " · ".join(filter(None, (metadata.camera, metadata.software)))
    return Reading(device, None if metadata is None else metadata.taken_at, difference_deg)


def audit(readings):
    """Judge the compasses.

    Parameters
    ----------
    readings : iterable of Reading

    Returns
    -------
    list of DeviceAudit
        One per device, the one with most readings first.
    """
    groups: dict = {}
    for reading in readings:
        groups.setdefault(reading.device, []).append(reading)
    ordered = sorted(groups.items(), key=lambda item: (-len(item[1]), item[0]))
    return [_of_device(device, group) for device, group in ordered]


def _of_device(device, readings):
    difference = wrap_180(np.array([reading.difference_deg for reading in readings]))
    worthless = int((np.abs(difference) > WORTHLESS_DEG).sum())
    middle = circular_median(difference)
    away = wrap_180(difference - middle)
    core = np.abs(away) <= WORTHLESS_DEG
    if core.sum() < LEAST_FOR_SPREAD or 2 * core.sum() < len(difference):
        return DeviceAudit(device, len(readings), worthless=worthless)
    # Worthless readings to one side would shift the median, so the bias is that of the readings around it.
    bias = middle + float(np.median(away[core]))
    rest = np.sort(wrap_180(difference - bias)[core])
    low, high = median_interval(rest)
    spread = 1.4826 * float(np.median(np.abs(rest)))
    turned, fault = _turned(wrap_180(difference - bias), spread)
    slope, slope_lo, slope_hi = drift([readings[k].taken_at for k in np.flatnonzero(core)], away[core])
    return DeviceAudit(
        device,
        len(readings),
        bias_deg=float(wrap_180(bias)),
        bias_lo_deg=None if low is None else float(wrap_180(bias + low)),
        bias_hi_deg=None if high is None else float(wrap_180(bias + high)),
        spread_deg=spread,
        worthless=worthless,
        turned=turned,
        turned_fault=fault,
        drift_deg_per_h=slope,
        drift_lo_deg_per_h=slope_lo,
        drift_hi_deg_per_h=slope_hi,
    )


def circular_median(difference_deg):
    """The reading from which all others are least far away in sum [degrees]; the first of several.

    Parameters
    ----------
    difference_deg : (N,) array
    """
    values = np.sort(difference_deg)
    some = values[np.linspace(0, len(values) - 1, min(len(values), 721)).round().astype(int)]
    return float(some[np.argmin([np.abs(wrap_180(values - one)).sum() for one in some])])


def median_interval(ordered):
    """Interval of the median from the order of the values, whatever their distribution; (None, None) below five.

    The median lies between the k-th smallest and the k-th largest value, unless fewer than k values fall on one side
    of it, as of a coin that is tossed N times.

    Parameters
    ----------
    ordered : (N,) array
        Ascending.
    """
    from scipy.stats import binom

    rank = int(binom.ppf((1 - LEVEL) / 2, len(ordered), 0.5))  # P(fewer than `rank` on one side) <= 5 %
    return (float(ordered[rank - 1]), float(ordered[-rank])) if rank >= 1 else (None, None)


def _turned(away, spread):
    """Count readings near +90, -90 and 180 degrees from the bias, and say whether chance explains the most frequent."""
    from scipy.stats import binom

    width = min(max(10.0, 3 * spread), 25.0)
    counts = tuple(int((np.abs(wrap_180(away - turn)) <= width).sum()) for turn in TURNS_DEG)
    outside = int((np.abs(away) > WORTHLESS_DEG).sum())
    share = 2 * width / (360 - 2 * WORTHLESS_DEG)  # of readings that point anywhere
    chance = len(TURNS_DEG) * float(binom.sf(max(counts) - 1, outside, share))
    return counts, max(counts) >= LEAST_TURNED and chance < SIGNIFICANT


def drift(times, difference_deg):
    """Median slope between readings of the same day, and its interval from Kendall's statistic (Sen's method).

    Parameters
    ----------
    times : list of datetime or None
    difference_deg : (N,) array
        Without jumps at 180 [degrees].

    Returns
    -------
    slope, low, high : float or None
        [degrees per hour]
    """
    days: dict = {}
    for time, value in zip(times, difference_deg):
        if time is not None:
            hour = time.hour + time.minute / 60 + time.second / 3600
            days.setdefault(time.date(), []).append((hour, value))
    parts, variance, count = [], 0.0, 0
    for day in days.values():
        hour, value = np.array(sorted(day)[:: -(-len(day) // MOST_OF_A_DAY)]).T
        first, second = np.triu_indices(len(hour), 1)
        gap = hour[second] - hour[first]
        apart = gap > TRUSTED_HOURS
        parts.append((value[second] - value[first])[apart] / gap[apart])
        if apart.any():
            count += len(hour)
            variance += len(hour) * (len(hour) - 1) * (2 * len(hour) + 5) / 18
    slopes = np.sort(np.concatenate(parts)) if parts else np.zeros(0)
    if count < LEAST_FOR_DRIFT or len(slopes) < LEAST_FOR_DRIFT:
        return None, None, None
    reach = 1.6449 * np.sqrt(variance)
    low = int(np.clip(np.floor((len(slopes) - reach) / 2), 0, len(slopes) - 1))
    high = int(np.clip(np.ceil((len(slopes) + reach) / 2), 0, len(slopes) - 1))
    return float(np.median(slopes)), float(slopes[low]), float(slopes[high])
