"""The offsets of a clock that have been tried, and what each photograph speaks for each of them."""

from __future__ import annotations

import numpy as np

from ..base.progress import checkpoint
from .track import Placed, local_m, place_at

COARSE, FINE = 0, 1
"""The two kinds of fit. Their values are not comparable with one another."""


class OffsetSearch:
    """Values of the photographs at the offsets tried so far, of both kinds of fit.

    Parameters
    ----------
    photos : sequence of (int, float)
        Number of each photograph, and its time by the camera's clock [s since 1970, UTC].
    track : Track
    fit : callable
        As for `core.track.clock.solve_clock`.
    options : (ClockOptions, TrackOptions)
    """

    def __init__(self, photos, track, fit, options):
        self.photos, self.track, self.fit = photos, track, fit
        self.options, self.track_options = options
        self._rows: tuple = ({}, {})
        self._known: dict = {}

    def look(self, offsets, kind, progress):
        """Evaluate offsets [s] by one kind of fit; none of them twice.

        Parameters
        ----------
        offsets : sequence of float
        kind : int
        progress : Progress
        """
        for row, offset in enumerate(offsets):
            checkpoint(progress, row / max(len(offsets), 1))
            if offset not in self._rows[kind]:
                places = [place_at(self.track, time_s - offset, self.track_options) for _, time_s in self.photos]
                self._rows[kind][offset] = [
                    self._at(number, place, kind) if isinstance(place, Placed) else np.nan
                    for (number, _), place in zip(self.photos, places)
                ]

    def _at(self, number, place, kind):
        cell_m = self.options.cells_m[kind]
        east, north = local_m(self.track, place.longitude_deg, place.latitude_deg)
        key = number, kind, round(east / cell_m), round(north / cell_m)
        if key not in self._known:
            found = self.fit(number, place, kind)
            self._known[key] = np.nan if found is None else float(found)
        return self._known[key]

    def offsets(self, kind):
        """The offsets that one kind of fit has evaluated, in order (N,) [s]."""
        return np.array(sorted(self._rows[kind]), float)

    def values(self, kind):
        """Values of one kind of fit, (offsets, photographs); -inf where there is no place or no horizon."""
        rows = [self._rows[kind][offset] for offset in self.offsets(kind)]
        values = np.array(rows, float).reshape(-1, len(self.photos))
        return np.where(np.isfinite(values), values, -np.inf)

    def shares(self, kind):
        """What each photograph speaks for each offset, (offsets, photographs): 0 at its best one, less elsewhere."""
        values, misled = self.values(kind), self.options.misled
        best = values.max(axis=0, initial=np.finfo(float).min)
        share = np.log(misled + (1 - misled) * np.exp(values - best))
        return np.where(np.isfinite(values), share, -self.options.unplaced)

    def total(self, kind):
        """Log-likelihood of each offset, with the prior (N,); -inf where too few photographs have a place."""
        total = self.options.tempering * self.shares(kind).sum(axis=1) + log_prior(self.offsets(kind), self.options)
        placed = np.isfinite(self.values(kind)).sum(axis=1)
        return np.where(placed >= self.options.least_photos, total, -np.inf)

    def closer(self, kind, kept, steps_s):
        """Offsets of the next, finer search, around the best distinct ones of a kind (N,) [s].

        Parameters
        ----------
        kind : int
        kept : int
            Number of the best ones.
        steps_s : (float, float)
            Step of the search so far, and of the next [s].
        """
        offsets, total = self.offsets(kind), self.total(kind)
        found: list = []
        for index in np.argsort(-total, kind="stable"):
            if len(found) == kept or not np.isfinite(total[index]):
                break
            if all(abs(offsets[index] - other) >= steps_s[0] * 1.5 for other in found):
                found.append(float(offsets[index]))
        reach = int(np.ceil(steps_s[0] / steps_s[1]))
        around = steps_s[1] * np.arange(-reach, reach + 1)
        return np.unique([offset + around for offset in found])


def log_prior(offsets, options):
    """Logarithm of the prior's density at offsets [s], relative to one that is even everywhere."""
    drift = (offsets + options.zone_s / 2) % options.zone_s - options.zone_s / 2
    density = np.exp(-0.5 * (drift / options.zone_sigma_s) ** 2) * options.zone_s / options.zone_sigma_s
    return np.log(options.zone_share * density / np.sqrt(2 * np.pi) + 1 - options.zone_share)
