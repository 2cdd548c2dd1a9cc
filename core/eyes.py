"""What the DEM shows from the eyes at one place, computed once for all photographs from there."""

from __future__ import annotations

from collections import OrderedDict
from contextlib import contextmanager
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
    """Cache of the last horizons, and of the `InnerTerrain` below each, for photographs from one station.

    A cache is for one thread.

    Parameters
    ----------
    size : int
        Number of eyes kept; each takes about 4 MB. A station has up to five, at several elevations.
    """

    def __init__(self, size=16):
        self.size = size
        self._kept = OrderedDict()
        self._terrain = None

    @contextmanager
    def station(self):
        """Keep the terrain around one place within the block, so that it is read once for all eyes there.

        It takes up to 64 MB for cells, a sixth of a byte for each cell within range, and 20 MB for samples.
        """
        self._terrain = {}
        try:
            yield
        finally:
            self._terrain = None

    def profile(self, dem, observer, options, progress=SILENT):
        """Return the observer's `HorizonProfile`, computed only if it is not cached.

        Parameters
        ----------
        dem : core.io.raster.Dem
        observer : Observer
        options : HorizonOptions or PaperHorizonOptions
        progress : Progress
        """
        compute = cast_horizon if isinstance(options, PaperHorizonOptions) else self._horizon
        return self._look_up(compute, dem, observer, options, progress)

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
        around = self._at_station(Surroundings, dem, observer, options)
        return horizon_from(around, eye_elevation_m(dem, around.frame, observer), progress)

    def _inner(self, dem, observer, options, progress):
        samples = self._at_station(ground_samples, dem, observer, options.rays, progress)
        return inner_from(samples.seen_from(eye_elevation_m(dem, samples.frame, observer)), options)

    def _at_station(self, compute, dem, observer, options, *progress):
        """Return what `compute` gives for the observer's position, kept within a block of `station`."""
        position = observer.longitude_deg, observer.latitude_deg
        terrain = {} if self._terrain is None else self._terrain
        key = dem, position, options
        if key not in terrain:
            terrain[key] = compute(dem, *position, options, *progress)
        return terrain[key]


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
        Within a block of `station` that includes `horizon`, the terrain is read once.

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
