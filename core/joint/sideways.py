"""What an error sideways, of the DEM or of the eye's position, does to the heading of one photograph.

The spread of a fit takes the columns of a skyline for independent. A ridge that stands half a cell beside its true
place turns all of its columns at once, by an angle that grows as the ridge comes nearer.
"""

from __future__ import annotations

import numpy as np

from ..base.angles import difference
from ..base.uncertainty import TYPICAL_POSITION_ERROR_M

DEM_ERROR_CELLS = 0.25
"""Standard deviation of a ridge's place sideways, as that of its height in `match.refine.RefineOptions` [cells]."""
SHARP_DEG = 0.1
"""Error of the skyline itself: nearer parts of it than this error shows have less weight in the heading [degrees]."""


def sideways_deg(photo):
    """Standard deviation of the heading by errors sideways; 0 without a horizon in the picture [degrees].

    Parameters
    ----------
    photo : OrientedPhoto
    """
    horizon, camera, heading_deg = photo.horizon, photo.camera, photo.heading_deg
    if horizon is None or camera is None or heading_deg is None:
        return 0.0
    turn_deg = np.abs(difference(np.asarray(horizon.azimuth_deg, float), heading_deg))
    distance_m = np.asarray(horizon.distance_m, float)[turn_deg <= camera.hfov_deg / 2]
    distance_m = distance_m[np.isfinite(distance_m)]
    if not len(distance_m):
        return 0.0
    position_m = getattr(photo.metadata, "position_error_m", None) or TYPICAL_POSITION_ERROR_M
    error_m = np.hypot(DEM_ERROR_CELLS * horizon.cell_m, position_m)
    angle_deg = np.degrees(np.arctan(error_m / np.maximum(distance_m, horizon.cell_m)))
    # Parts of the skyline count as they do in a fit that knows their errors.
    return float(np.average(angle_deg, weights=1 / (SHARP_DEG**2 + angle_deg**2)))
