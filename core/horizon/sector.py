"""The horizon in a sector only, which takes less time than the whole circle, in the form of the whole circle."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np

from .horizon import HorizonOptions, horizon_profile


@dataclass(frozen=True)
class SectorOptions(HorizonOptions):
    """The directions of a sector only: `count` azimuths from number `first` of the circle on, clockwise."""

    first: int = 0
    count: int = 1

    @property
    def azimuth_deg(self):
        """(count,) azimuths of the sector [degrees]."""
        whole = super().azimuth_deg
        return whole[(self.first + np.arange(self.count)) % len(whole)]


def sector_profile(terrain, observer, options, middle_deg, width_deg):
    """Find the horizon in a sector.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : HorizonOptions
        Of the whole circle.
    middle_deg, width_deg : float
        Azimuth of the middle of the sector, and its width [degrees].

    Returns
    -------
    HorizonProfile
        At all azimuths of the circle; unknown outside the sector, and the same as that of the circle inside.

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    total = len(options.azimuth_deg)
    count = int(np.ceil(width_deg / 360 * total)) + 1
    if count >= total:
        return horizon_profile(terrain, observer, options)
    first = int(np.floor((middle_deg - width_deg / 2) / 360 * total))
    known = {item.name: getattr(options, item.name) for item in fields(HorizonOptions)}
    profile = horizon_profile(terrain, observer, SectorOptions(**known, first=first, count=count))
    at = (first + np.arange(count)) % total

    def spread(values, unknown):
        whole = np.full(total, unknown, dtype=values.dtype)
        whole[at] = values
        return whole

    return replace(
        profile,
        azimuth_deg=options.azimuth_deg,
        elevation_deg=spread(profile.elevation_deg, np.nan),
        distance_m=spread(profile.distance_m, np.nan),
        clipped=spread(profile.clipped, False),
        void=spread(profile.void, False),
        reach_m=spread(profile.reach_m, 0.0),
    )
