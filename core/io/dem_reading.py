"""Choices of the user on how the values of a DEM are read, beside those in its file."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class DemReading:
    """How the values of a DEM are read; the defaults follow the file.

    Attributes
    ----------
    unit : str, float or None
        Unit of the heights: a name, or metres per unit. None means that of the file.
    nodata_ranges : tuple of (float, float)
        Further values without data, limits included [values of the band, after its own scale].
    own_nodata : bool
        Whether the file's nodata value counts.
    """

    unit: str | float | None = None
    nodata_ranges: tuple[tuple[float, float], ...] = ()
    own_nodata: bool = True


def in_ranges(values_m, ranges, metres_per_unit):
    """Tell which values lie in ranges of nodata.

    Parameters
    ----------
    values_m : float32 array
        Heights [m].
    ranges : tuple of (float, float)
        See `DemReading`.
    metres_per_unit : float
    """
    inside = np.zeros(values_m.shape, bool)
    with np.errstate(invalid="ignore", over="ignore"):
        for low, high in ranges:
            # A bit wider than given, because the conversion to metres rounds.
            low_m, high_m = (np.float32(limit * metres_per_unit) for limit in (low, high))
            inside |= (values_m >= np.nextafter(low_m, -np.inf)) & (values_m <= np.nextafter(high_m, np.inf))
    return inside
