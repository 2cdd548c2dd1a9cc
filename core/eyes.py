"""What the DEM shows from the eyes at one place, computed once for all photographs from there."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace

from .base.progress import SILENT
from .base.terrain import eye_elevation_m
from .horizon.ground_rays import ground_samples
from .horizon.horizon import horizon_from, horizon_profile
from .horizon.inner import inner_from
from .horizon.surroundings import Surroundings
from .match.inputs import Eye, differs, eye_offsets_m
from .paper.horizon import PaperHorizonOptions, paper_horizon


def cast_horizon(terrain, observer, options, progress=SILENT):
    """Compute the horizon by either method.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : HorizonOptions or PaperHorizonOptions
        Their type selects the method.
    progress : Progress

    Returns
    -------
    HorizonProfile
    """
    if isinstance(options, PaperHorizonOptions):
        return paper_horizon(terrain, observer, replace(options, eye_height_m=observer.eye_height_m), progress)
    return horizon_profile(terrain, observer, options, progress)


class HorizonCache:
    """Cache of the last horizons and the terrain below them, for photographs taken from one station.

    The terrain around the last station is cached too, because reading it takes most of the time with fine DEMs.

    Parameters
    ----------
    size : int
        Number of eyes kept; each takes about 4 MB. A station has up to five, at several elevations. The terrain
        around a station takes up to 100 MB.
    """

    def __init__(self, size=16):
        self.size = size
        self._kept = OrderedDict()
        self._place, self._around = None, {}

    def profile(self, dem, observer, options, progress=SILENT):
        """Return the observer's `HorizonProfile`, computed only if it is not cached.

        Parameters
        ----------
        dem : core.io.raster.Dem
        observer : Observer
        options : HorizonOptions or PaperHorizonOptions
        progress : Progress
        """
        return self._look_up(self._horizon, dem, observer, options, progress)

    def inner(self, dem, observer, options, progress=SILENT):
        """Return the `InnerTerrain` below the observer's horizon in the same way.

        Parameters
        ----------
        dem, observer, progress
            As for `profile`.
        options : InnerOptions
        """
        return self._look_up(self._inner, dem, observer, options, progress)

    def _look_up(self, compute, dem, observer, options, progress):
        # A DEM is equal only to itself; as part of the key it stays alive as long as its results do.
        key = (compute.__name__, dem, observer, options)
        if key not in self._kept:
            self._kept[key] = compute(dem, observer, options, progress)
            while len(self._kept) > 2 * self.size:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]

    def _horizon(self, dem, observer, options, progress):
        if isinstance(options, PaperHorizonOptions):
            return cast_horizon(dem, observer, options, progress)
        position = observer.longitude_deg, observer.latitude_deg
        around = self._at_station(dem, position, options, lambda: Surroundings(dem, position[0], position[1], options))
        return horizon_from(around, observer, options, progress)

    def _inner(self, dem, observer, options, progress):
        rays = options.rays
        position = observer.longitude_deg, observer.latitude_deg
        frame = dem.frame(position[0], position[1], rays.max_distance_m)
        eye_m = eye_elevation_m(dem, frame, observer)
        samples = self._at_station(dem, position, rays, lambda: ground_samples(dem, frame, rays, progress))
        return inner_from(samples.seen_from(eye_m), options)

    def _at_station(self, dem, position, options, compute):
        """Return what `compute` gives for a position, from the cache if it is the last station's."""
        if self._place != (dem, position):
            self._place, self._around = (dem, position), {}
        if options not in self._around:
            self._around[options] = compute()
        return self._around[options]


def other_eyes(terrain, observer, horizon, altitude_m, options, cache):
    """Compute what the DEM shows from further elevations of the eye; none if the eye's elevation is given.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    horizon : HorizonProfile
        From the assumed eye.
    altitude_m : float or None
        As the photograph records it [m].
    options : OrientOptions
    cache : HorizonCache

    Returns
    -------
    tuple of Eye
    """
    if observer.eye_elevation_m is not None:
        return ()
    assumed_m, error = horizon.eye_elevation_m, options.robust.refine.terrain_error_cells
    recorded = None if altitude_m is None else altitude_m - assumed_m
    found, shown = [], [horizon]
    for offset_m, log_prior in eye_offsets_m(horizon.cell_m, recorded, options.eyes):
        place = replace(observer, eye_elevation_m=assumed_m + offset_m)
        other = cache.profile(terrain, place, options.horizon)
        if all(differs(earlier, other, error, options.eyes) for earlier in shown):
            found.append(Eye(other, cache.inner(terrain, place, options.inner), log_prior))
            shown.append(other)
    return tuple(found)
