"""What a horizon is: by itself, as who wants horizons only need not load all that the photographs' results are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class HorizonProfile:
    """The sky-terrain boundary as the DEM has it, around one observer.

    Attributes
    ----------
    azimuth_deg : (A,) array
        Regular, from 0, clockwise from true north [degrees].
    elevation_deg : (A,) array
        Elevation angle of the horizon [degrees]; NaN where nothing is known in that direction.
    distance_m : (A,) array
        Ground distance of the horizon point [m]; NaN where unknown.
    clipped : (A,) bool array
        The DEM ends in this direction before `max_distance_m` and terrain beyond its edge could be higher, so that
        the horizon is a lower bound.
    void : (A,) bool array
        Cells without data lie along the ray and might hide a higher horizon.
    eye_elevation_m : float
        Of the observer's eye [m].
    cell_m : float
        Ground size of the DEM's cells [m].
    reach_m : (A,) array
        How far the DEM was searched in each direction [m].
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    clipped: np.ndarray
    void: np.ndarray
    eye_elevation_m: float
    cell_m: float
    reach_m: np.ndarray
