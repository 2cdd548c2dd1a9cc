"""The offset of a camera's clock, found from how well the photographs' skylines fit the horizons along a track.

For every offset each photograph has a place on the track, and at each place its skyline fits the horizon more or less.
A coarse fit of all offsets only chooses those that are looked at closely: far from its best place it is wrong by more
than the places of neighbouring offsets differ. The fine fit decides, and the answer is given only if photographs agree.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..base.messages import Message
from ..base.progress import SILENT, subtask
from ..base.uncertainty import Z_90
from .offsets import COARSE, FINE, OffsetSearch, log_prior
from .track import TrackOptions

LEAST_SHARE = 0.5
"""A photograph speaks for an offset if it fits there better by this than at the others [log-likelihood]."""

GRID_S = 5.0
"""Step at which the posterior of the offset is summed [s]."""


@dataclass(frozen=True)
class ClockOptions:
    """How the offset of a clock is searched and judged.

    Attributes
    ----------
    largest_s : float
        Largest offset to either side [s]: a wrong time zone makes up to 14 hours.
    steps_s : tuple of float
        Steps of the searches [s]: of the coarse one, then of the fine ones. The first must divide a quarter of an hour,
        by which time zones differ.
    cells_m : (float, float)
        Places closer than this share the value of a fit, coarse and fine [m].
    kept : tuple of int
        Number of the best offsets around which each fine search looks.
    photos : int
        Most photographs that are used, spread over the walk.
    apart_s : float
        Of photographs taken within this time only one is used: from one place they share the errors of the DEM [s].
    misled : float
        Probability that a photograph is of no use: a skyline that is a cloud, or a place off the track. It bounds what
        one photograph can speak against an offset.
    unplaced : float
        What a photograph without a place at an offset speaks against it [log-likelihood].
    tempering : float
        Weight of the sum. On draws from the photographs of khumbu-trek the best offset scatters as a weight of 1 says
        (docs/walks.md); the rest is left for errors of DEM and track that photographs share elsewhere.
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
    steps_s: tuple = (300.0, 100.0, 50.0)
    cells_m: tuple = (75.0, 20.0)
    kept: tuple = (5, 2)
    photos: int = 20
    apart_s: float = 60.0
    misled: float = 0.02
    unplaced: float = 2.0
    tempering: float = 0.85
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
        Offsets that were looked at closely, in order [s], and the log-likelihood of each, prior included.
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
        Log-likelihood of a photograph's skyline as a function of (number of the photograph, `Placed`, `COARSE` or
        `FINE`); None where it cannot be computed.
    options : ClockOptions
    track_options : TrackOptions
    progress : Progress

    Returns
    -------
    ClockAnswer
    """
    chosen = spread_over_walk(times_s, options)[: options.photos]
    if len(chosen) < options.least_photos:
        text = Message(
            "The clock cannot be determined: only {count} photos with a time, at least a minute apart, show a skyline, "
            "and {least} are needed. Give the clock's offset.",
            count=len(chosen),
            least=options.least_photos,
        )
        return ClockAnswer(None, None, text)
    search = OffsetSearch([(k, float(times_s[k])) for k in sorted(chosen)], track, fit, (options, track_options))
    count = int(options.largest_s // options.steps_s[0])
    search.look(options.steps_s[0] * np.arange(-count, count + 1), COARSE, subtask(progress, 0.0, 0.4))
    for number, kept in enumerate(options.kept):
        offsets = search.closer(min(number, FINE), kept, options.steps_s[number : number + 2])
        first, last = (0.4 + 0.6 * part / len(options.kept) for part in (number, number + 1))
        search.look(offsets, FINE, subtask(progress, first, last))
    return _judged(search, options)


def spread_over_walk(times_s, options=ClockOptions()):  # noqa: B008 - frozen
    """Numbers of the photographs in the order in which they help: spread over the walk, and apart in time.

    Parameters
    ----------
    times_s : sequence of float
    options : ClockOptions

    Returns
    -------
    list of int
    """
    apart: list = []
    for index in np.argsort(times_s, kind="stable"):
        if not apart or times_s[index] - times_s[apart[-1]] >= options.apart_s:
            apart.append(int(index))
    stride = max(-(-len(apart) // options.photos), 1)
    return [index for start in range(stride) for index in apart[start::stride]]


def _judged(search, options):
    refused = Message(
        "The clock cannot be determined from the skylines: other offsets fit as well. Give the clock's offset, or "
        "more photos with a clear skyline from different places."
    )
    offsets = search.offsets(FINE)
    if not len(offsets) or not np.isfinite(search.total(FINE)).any():
        return ClockAnswer(None, None, refused)
    total, shares = search.total(FINE), search.shares(FINE)
    best = int(total.argmax())
    near = np.abs(offsets - offsets[best]) <= options.same_s
    probability = _probability(search, offsets[best], options)
    mean, sigma = _moments(offsets[near], total[near], options)
    curve = {"probability": probability, "curve_s": offsets, "curve": total}
    usual = np.median(shares[~near] if (~near).any() else shares, axis=0)
    speaking = int((shares[best] > usual + LEAST_SHARE).sum())
    if probability < options.least_probability or speaking < options.least_photos or not _agreed(shares, near):
        return ClockAnswer(None, None, refused, **curve)
    text = Message(
        "The camera's clock is ahead by {offset} s (90 % interval: {lo} to {hi} s); {count} photos agree.",
        offset=f"{mean:.0f}",
        lo=f"{mean - Z_90 * sigma:.0f}",
        hi=f"{mean + Z_90 * sigma:.0f}",
        count=speaking,
    )
    return ClockAnswer(mean, sigma, text, **curve)


def _probability(search, best_s, options):
    """Probability of the best offset among the distinct ones.

    Each answer counts by its best offset, because those tried lie closer around some answers than around others. An
    answer that only the coarse fit has seen counts by that fit, against what it gives the best one.
    """
    coarse: dict = {}
    fine: dict = {}
    for kind, peaks in ((COARSE, coarse), (FINE, fine)):
        total = search.total(kind)
        for offset, value in zip(search.offsets(kind)[np.isfinite(total)], total[np.isfinite(total)]):
            answer = int(np.floor((offset - best_s) / (2 * options.same_s) + 0.5))
            peaks[answer] = max(peaks.get(answer, -np.inf), value)
    others = [value - fine[0] for answer, value in fine.items() if answer]
    others += [value - coarse.get(0, -np.inf) for answer, value in coarse.items() if answer not in fine]
    return float(1 / (1 + np.exp(np.array(others)).sum()))


def _moments(offsets, total, options):
    """Mean and standard deviation of the offset around the best one [s]."""
    offsets, total = offsets[np.isfinite(total)], total[np.isfinite(total)]
    likelihood = total - log_prior(offsets, options)
    grid = np.arange(offsets[0], offsets[-1] + GRID_S / 2, GRID_S)
    value = np.interp(grid, offsets, likelihood) + log_prior(grid, options)
    weight = np.exp(value - value.max())
    mean = float(np.average(grid, weights=weight))
    return mean, float(np.sqrt(np.average((grid - mean) ** 2, weights=weight) + options.least_sigma_s**2))


def _agreed(shares, near):
    """Tell whether the answer stays the best without any one photograph."""
    total = shares.sum(axis=1)
    return all(near[(total - shares[:, column]).argmax()] for column in range(shares.shape[1]))
