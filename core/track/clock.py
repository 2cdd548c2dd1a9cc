"""The offset of a camera's clock, found from how well the photographs' skylines fit the horizons along a track.

For every offset each photograph has a place on the track, and at each place its skyline fits the horizon more or less.
The offsets are searched from coarse to fine; the answer is given only where photographs agree.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..base.messages import Message
from ..base.progress import SILENT, checkpoint, subtask
from .track import Placed, TrackOptions, local_m, place_at


@dataclass(frozen=True)
class ClockOptions:
    """How the offset of a clock is searched and judged.

    Attributes
    ----------
    largest_s : float
        Largest offset to either side [s]: a wrong time zone makes up to 14 hours.
    steps_s : tuple of float
        Steps of the searches, from coarse to fine [s]. The first must divide a quarter of an hour, by which time zones
        differ.
    cells_m : tuple of float
        Places closer than this share a horizon, for each search [m].
    kept : int
        Offsets from which a finer search goes on.
    photos : int
        Most photographs that are used, spread over the walk.
    support, against : float
        Most that one photograph can speak for or against an offset [log-likelihood]: a skyline that is wrong, or a
        place off the track, must not decide alone.
    unplaced : float
        What a photograph without a place at an offset speaks against it.
    tempering : float
        Weight of the sum: the photographs share the errors of DEM and track, and are not independent. On the 27
        photographs of khumbu-trek, whose track was made from their positions, the sum prefers an offset three minutes
        off by 6 units; with this weight the truth lies within 2.5 standard deviations.
    least_sigma_s : float
        Standard deviation that the errors of DEM and track, which the photographs share, always leave [s].
    zone_s, zone_sigma_s, zone_share : float
        Prior: with this share the clock is wrong by a multiple of `zone_s` (a time zone, or none) and some drift of
        this spread [s]; otherwise by any time.
    least_photos : int
        Photographs that must speak for the answer.
    least_probability : float
        Probability that the best offset must have.
    same_s : float
        Offsets closer than this count as one answer [s].
    """

    largest_s: float = 14 * 3600.0
    steps_s: tuple = (300.0, 60.0, 20.0)
    cells_m: tuple = (75.0, 40.0, 15.0)
    kept: int = 5
    photos: int = 16
    support: float = 6.0
    against: float = 4.0
    unplaced: float = 2.0
    tempering: float = 0.5
    least_sigma_s: float = 30.0
    zone_s: float = 900.0
    zone_sigma_s: float = 90.0
    zone_share: float = 0.7
    least_photos: int = 3
    least_probability: float = 0.95
    same_s: float = 450.0


@dataclass(frozen=True, eq=False)
class ClockAnswer:
    """The offset of a clock, or why there is none.

    Attributes
    ----------
    offset_s : float or None
        How much the camera's clock is ahead [s].
    sigma_s : float or None
        Standard deviation [s].
    message : Message
        The result in a sentence.
    probability : float
        Probability of the best offset among the distinct ones.
    curve_s, curve : (N,) arrays
        Offsets that were tried, in order [s], and the log-likelihood of each.
    """

    offset_s: float | None
    sigma_s: float | None
    message: Message
    probability: float = 0.0
    curve_s: np.ndarray = field(default_factory=lambda: np.zeros(0))
    curve: np.ndarray = field(default_factory=lambda: np.zeros(0))


def solve_clock(times_s, track, fit, options=ClockOptions(), track_options=TrackOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Find how much a camera's clock is ahead.

    Parameters
    ----------
    times_s : sequence of float
        Times of the photographs that have a skyline, by the camera's clock as if it were right [s since 1970, UTC].
    track : Track
    fit : callable
        Log-likelihood of a photograph's skyline, summed over the headings, as a function of (number of the photograph,
        `Placed`, number of the search from 0); None where it cannot be computed.
    options : ClockOptions
    track_options : TrackOptions
    progress : Progress

    Returns
    -------
    ClockAnswer
    """
    if len(times_s) < options.least_photos:
        return ClockAnswer(
            None,
            None,
            Message(
                "The clock cannot be determined: only {count} photos with a time show a skyline, and {least} are "
                "needed. Give the clock's offset.",
                count=len(times_s),
                least=options.least_photos,
            ),
        )
    chosen = np.unique(np.linspace(0, len(times_s) - 1, min(options.photos, len(times_s))).round().astype(int))
    order = np.argsort(times_s, kind="stable")[chosen]
    search = _Search([(int(k), float(times_s[k])) for k in order], track, fit, (options, track_options))
    levels = len(options.steps_s)
    count = int(options.largest_s // options.steps_s[0])
    offsets = options.steps_s[0] * np.arange(-count, count + 1)
    for level in range(levels):
        search.look(offsets, level, subtask(progress, level / levels, (level + 1) / levels))
        if level + 1 < levels:
            offsets = _closer(search.offsets, search.total(), options, level)
    return _judged(search, options)


class _Search:
    """Contributions of the photographs at the offsets tried so far."""

    def __init__(self, photos, track, fit, options):
        self.photos, self.track, self.fit = photos, track, fit
        self.options, self.track_options = options
        self.offsets, self.values = np.zeros(0), np.zeros((0, len(photos)))
        self._known: dict[Any, float] = {}

    def look(self, offsets, level, progress):
        """Evaluate offsets; one that was tried before is tried anew at the finer cells of this level.

        Parameters
        ----------
        offsets : (N,) array
            [s].
        level : int
        progress : Progress
        """
        values = np.full((len(offsets), len(self.photos)), np.nan)
        for row, offset in enumerate(offsets):
            checkpoint(progress, row / max(len(offsets), 1))
            for column, (number, time_s) in enumerate(self.photos):
                place = place_at(self.track, time_s - offset, self.track_options)
                if isinstance(place, Placed):
                    values[row, column] = self._at(number, place, level)
        old = ~np.isin(self.offsets, offsets)
        self.offsets = np.concatenate([self.offsets[old], offsets])
        self.values = np.concatenate([self.values[old], values])

    def _at(self, number, place, level):
        cell_m = self.options.cells_m[level]
        east, north = local_m(self.track, place.longitude_deg, place.latitude_deg)
        key = number, level, round(east / cell_m), round(north / cell_m)
        if key not in self._known:
            found = self.fit(number, place, level)
            self._known[key] = np.nan if found is None else float(found)
        return self._known[key]

    def shares(self):
        """What each photograph speaks for each offset, (offsets, photographs): 0 where it fits as at most places."""
        options = self.options
        shares = np.full(self.values.shape, -options.unplaced)
        for column in range(len(self.photos)):
            known = [value for (number, *_), value in self._known.items() if number == self.photos[column][0]]
            known = np.array(known)[np.isfinite(known)]
            if len(known):
                usual = np.percentile(known, 75)
                found = np.clip(self.values[:, column] - usual, -options.against, options.support)
                shares[:, column] = np.where(np.isfinite(found), found, -options.unplaced)
        return shares

    def total(self):
        """Log-likelihood of each offset, with the prior."""
        options = self.options
        drift = (self.offsets + options.zone_s / 2) % options.zone_s - options.zone_s / 2
        density = np.exp(-0.5 * (drift / options.zone_sigma_s) ** 2) * options.zone_s / options.zone_sigma_s
        prior = np.log(options.zone_share * density / np.sqrt(2 * np.pi) + 1 - options.zone_share)
        return options.tempering * self.shares().sum(axis=1) + prior


def _closer(offsets, total, options, level):
    """Offsets of the next, finer search: around the best distinct ones."""
    found: list = []
    for index in np.argsort(-total, kind="stable"):
        if all(abs(offsets[index] - other) >= options.steps_s[level] * 1.5 for other in found):
            found.append(float(offsets[index]))
        if len(found) == options.kept:
            break
    step = options.steps_s[level + 1]
    reach = int(np.ceil(options.steps_s[level] / step))
    around = step * np.arange(-reach, reach + 1)
    return np.unique(np.concatenate([offset + around for offset in found]))


def _judged(search, options):
    order = np.argsort(search.offsets)
    offsets, total, shares = search.offsets[order], search.total()[order], search.shares()[order]
    best = int(total.argmax())
    near = np.abs(offsets - offsets[best]) <= options.same_s
    # Each answer counts by its best offset, because those tried lie closer around some answers than around others.
    answer = np.floor((offsets - offsets[best]) / (2 * options.same_s) + 0.5).astype(int)
    peaks = np.full(np.ptp(answer) + 1, -np.inf)
    np.maximum.at(peaks, answer - answer.min(), total)
    probability = float(1 / np.exp(peaks - total.max()).sum())
    width = np.gradient(offsets)
    weight = np.where(near, np.exp(total - total.max()) * width, 0.0)
    weight /= weight.sum()
    mean = float((offsets * weight).sum())
    spread = (((offsets - mean) ** 2 + width**2 / 12) * weight).sum()
    sigma = float(np.hypot(np.sqrt(spread), options.least_sigma_s))
    curve = {"probability": probability, "curve_s": offsets, "curve": total}
    if probability < options.least_probability or not _agreed(shares, near, best, options):
        text = Message(
            "The clock cannot be determined from the skylines: other offsets fit as well. Give the clock's offset, or "
            "more photos with a clear skyline from different places."
        )
        return ClockAnswer(None, None, text, **curve)
    text = Message(
        "The camera's clock is ahead by {offset} s, with a standard deviation of {sigma} s; {count} photos agree.",
        offset=f"{mean:.0f}",
        sigma=f"{sigma:.0f}",
        count=int((shares[best] > 0.5).sum()),
    )
    return ClockAnswer(mean, sigma, text, **curve)


def _agreed(shares, near, best, options):
    """Tell whether enough photographs speak for the answer, and whether it stays the best without any one of them."""
    if (shares[best] > 0.5).sum() < options.least_photos:
        return False
    total = shares.sum(axis=1)
    return all(near[(total - shares[:, column]).argmax()] for column in range(shares.shape[1]))
