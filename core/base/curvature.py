"""The only formula for Earth curvature and atmospheric refraction in this program."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .arrays import FloatOrArray

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

EARTH_RADIUS_M = 6_371_000.0
METRES_PER_DEGREE = EARTH_RADIUS_M * np.pi / 180
REFRACTION_COEFFICIENT = 0.13


def apparent_drop_m(
    distance_m: ArrayLike,
    refraction_coefficient: float = REFRACTION_COEFFICIENT,
    radius_m: float = EARTH_RADIUS_M,
) -> FloatOrArray:
    """Give the apparent drop of a point at `distance_m` below the observer's horizontal plane.

    Parameters
    ----------
    distance_m : float or array
        Ground distance [m].
    refraction_coefficient : float
        Ratio k of the Earth's radius to the ray's radius of curvature [1]; 0.13 after Gauss. GDAL's curvature
        coefficient is 1 - k.
    radius_m : float
        Mean radius of the Earth [m].

    Returns
    -------
    float or array
        (1 - k) d^2 / (2 R) [m].

    References
    ----------
    .. [1] Brunner, F. K. (ed.), Geodetic Refraction, Springer 1984, doi:10.1007/978-3-642-45583-4.
    """
    return (1.0 - refraction_coefficient) * np.square(distance_m) / (2.0 * radius_m)
