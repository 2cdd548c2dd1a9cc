"""How much of the sky a place sees."""

from __future__ import annotations

import numpy as np


def sky_view_factor(profile):
    """Sky view factor of a level surface under a horizon.

    Parameters
    ----------
    profile : HorizonProfile
        Regular in azimuth; directions without a known horizon are left out.

    Returns
    -------
    float
        Share of the radiation of an evenly bright sky that arrives, 0 to 1; NaN where no direction is known.

    Notes
    -----
    The mean of cos^2(h) over the azimuths, with h the elevation angle of the horizon, not below the level plane: what
    lies under the plane of the surface cannot light it.

    References
    ----------
    .. [1] Dozier, J., Frew, J., Rapid calculation of terrain parameters for radiation modeling from digital elevation
       data, IEEE Trans. Geosci. Remote Sens. 28(5), 1990, eq. 7b with zero slope, doi:10.1109/36.58986.
    """
    elevation_deg = np.asarray(profile.elevation_deg, float)
    elevation_deg = elevation_deg[np.isfinite(elevation_deg)]
    if elevation_deg.size == 0:
        return float("nan")
    return float(np.mean(np.cos(np.radians(np.maximum(elevation_deg, 0.0))) ** 2))
