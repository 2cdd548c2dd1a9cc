"""The horizons of many places as one curve per trial, so that the fit of one place fits many places at once."""

from __future__ import annotations

import numpy as np

UNKNOWN_M = 100_000.0
"""Distance where the horizon is not known [m]."""


class CurveSet:
    """Horizons of K places; the k-th trial of a fit looks at the k-th of them.

    It has the interface of `core.match.geometry.HorizonCurve`, except that `nearest` gives indices into flat arrays
    and that it takes (K, C) azimuths only.

    Parameters
    ----------
    elevation_deg, distance_m : (K, A) arrays
        At regular azimuths from north; NaN where unknown.
    cell_m : float
        Size of the DEM's cells [m].
    clipped : (K, A) bool array or None
        The horizon is a lower bound there.

    Attributes
    ----------
    elevation_deg, distance_m, known, clipped : (K * A,) arrays
    """

    def __init__(self, elevation_deg, distance_m, cell_m, clipped=None):
        count, size = elevation_deg.shape
        known = np.isfinite(elevation_deg)
        elevation = np.where(known, elevation_deg, 0.0).astype(float)
        distance = np.where(known & np.isfinite(distance_m), distance_m, UNKNOWN_M)
        self.step_deg, self.cell_m, self._size = 360.0 / size, float(cell_m), size
        self.known, self.elevation_deg = known.ravel(), elevation.ravel()
        self.distance_m = np.maximum(distance, cell_m).astype(float).ravel()
        self.clipped = np.zeros(count * size, bool) if clipped is None else np.asarray(clipped, bool).ravel()
        tangent = np.tan(np.radians(np.clip(elevation, -89.0, 89.0)))
        self._tangent = tangent.ravel()
        self._slope = ((np.roll(tangent, -1, axis=1) - tangent) / np.radians(self.step_deg)).ravel()
        self._first = (np.arange(count) * size)[:, None]

    def tangent_at(self, azimuth_deg):
        """Interpolated tangent of the elevation angle, and its slope per radian of azimuth; (K, C) arrays."""
        position = np.mod(azimuth_deg, 360.0) / self.step_deg
        whole = np.floor(position)
        low = np.nan_to_num(whole).astype(np.intp) % self._size + self._first  # NaN stays NaN below
        slope = self._slope[low]
        return self._tangent[low] + slope * (np.radians(self.step_deg) * (position - whole)), slope

    def nearest(self, azimuth_deg):
        """Flat index of the nearest azimuth of each place's horizon, (K, C); any for NaN, whose row is NaN too."""
        position = np.nan_to_num(np.mod(azimuth_deg, 360.0)) / self.step_deg
        return np.rint(position).astype(np.intp) % self._size + self._first
