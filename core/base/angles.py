"""Arithmetic on compass angles.

All angles are in degrees, clockwise from north. *True* angles are measured from the meridian, *grid* angles from the
raster's columns. The two differ by the grid convergence.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .arrays import FloatOrArray

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def wrap_360(angle_deg: ArrayLike) -> FloatOrArray:
    """Wrap angles to [0, 360) [degrees]."""
    wrapped = np.mod(angle_deg, 360.0)
    # np.mod(-1e-20, 360) rounds to 360.0 itself.
    return np.where(wrapped >= 360.0, 0.0, wrapped)[()]


def wrap_180(angle_deg: ArrayLike) -> FloatOrArray:
    """Wrap angles to [-180, 180) [degrees]."""
    return wrap_360(np.add(angle_deg, 180.0)) - 180.0


def difference(angle_deg: ArrayLike, reference_deg: ArrayLike) -> FloatOrArray:
    """Give the signed turn from `reference_deg` to `angle_deg`, clockwise positive, in [-180, 180) [degrees]."""
    return wrap_180(np.subtract(angle_deg, reference_deg))


def in_wedge(azimuth_deg: ArrayLike, centre_deg: ArrayLike, width_deg: ArrayLike) -> FloatOrArray:
    """Tell which azimuths lie in a wedge, edges included; the wedge may span north.

    Parameters
    ----------
    azimuth_deg : float or array
        Azimuths to test, clockwise from north [degrees].
    centre_deg, width_deg : float or array
        Middle azimuth and full width of the wedge [degrees].

    Returns
    -------
    bool or bool array
    """
    return np.abs(difference(azimuth_deg, centre_deg)) <= np.divide(width_deg, 2.0)


def true_to_grid(azimuth_deg: ArrayLike, convergence_deg: ArrayLike) -> FloatOrArray:
    """Convert true azimuths to grid azimuths in [0, 360) [degrees].

    Parameters
    ----------
    azimuth_deg : float or array
        Clockwise from true north [degrees].
    convergence_deg : float
        Bearing of grid north seen from true north, clockwise positive [degrees] (Gauss-Bomford sense, as PROJ
        and Esri report it).

    Notes
    -----
    Equation 9 of the paper *adds* its gamma here, because that gamma is the grid bearing of true north, which is the
    negative of the standard convergence.
    """
    return wrap_360(np.subtract(azimuth_deg, convergence_deg))
