"""The horizons of all places of an area, as small numbers in arrays that may lie on disk."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

UNKNOWN = -32_768
PER_DEGREE = 100.0
"""Angles are whole hundredths of a degree: finer than the horizons of an index are exact."""

METRES = 10.0
"""Unit of the distances [m]."""

ARRAYS = ("longitude_deg", "latitude_deg", "ground_m", "elevation", "distance")


@dataclass(frozen=True, eq=False)
class HorizonIndex:
    """Horizons of P places at A azimuths, clockwise from true north.

    Attributes
    ----------
    longitude_deg, latitude_deg : (P,) arrays
        WGS 84 [degrees].
    ground_m : (P,) array
        Elevation of the terrain [m].
    elevation : (P, A) int16 array
        Elevation angle of the horizon in hundredths of a degree; `UNKNOWN` where it is not known.
    distance : (P, A) uint16 array
        Distance of the horizon in units of `METRES`.
    cell_m, spacing_m : float
        Size of the DEM's cells, and distance between neighbouring places [m].
    """

    longitude_deg: np.ndarray
    latitude_deg: np.ndarray
    ground_m: np.ndarray
    elevation: np.ndarray
    distance: np.ndarray
    cell_m: float
    spacing_m: float

    def __len__(self):
        return len(self.longitude_deg)

    @property
    def middle_deg(self):
        """Longitude and latitude of the middle of the places [degrees]."""
        return float(np.mean(self.longitude_deg)), float(np.mean(self.latitude_deg))

    def horizons(self, places):
        """Angles [degrees] (NaN where unknown) and distances [m] of some places, float32 (K, A) arrays."""
        stored = self.elevation[places]
        elevation = stored.astype(np.float32) / np.float32(PER_DEGREE)
        elevation[stored == UNKNOWN] = np.nan
        return elevation, self.distance[places].astype(np.float32) * np.float32(METRES)

    def take(self, places):
        """The index of some places only."""
        return replace(self, **{name: getattr(self, name)[places] for name in ARRAYS})


def stored_angles(elevation_deg):
    """Angles [degrees] as they are stored."""
    scaled = np.rint(np.nan_to_num(elevation_deg, nan=0.0) * PER_DEGREE).astype(np.int16)
    return np.where(np.isfinite(elevation_deg), scaled, np.int16(UNKNOWN))


def stored_distances(distance_m):
    """Distances [m] as they are stored."""
    return np.rint(np.clip(np.nan_to_num(distance_m, nan=0.0) / METRES, 0, 65_535)).astype(np.uint16)
