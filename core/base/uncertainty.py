"""How unsure a pose is, and draws from that doubt.

Draws are antithetic and whitened: their mean is the pose itself and their covariance exactly the given one, so that
a few dozen give the moments of a linear map without sampling noise, and still feel a surface's bends and edges.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .angles import difference

Z_90 = 1.6448536269514722
"""A normal variable stays within this many standard deviations with probability 0.9."""

TYPICAL_POSITION_ERROR_M = 8.0
"""Standard deviation of a phone's GPS under open sky, along each axis [m]."""

RADIUS_PER_AXIS = 1.5096
"""A radius that holds 68 % of places is this many standard deviations of one coordinate (Rayleigh)."""

PARAMETERS = ("heading_deg", "pitch_deg", "roll_deg", "log_focal", "east_m", "north_m", "height_m")


@dataclass(frozen=True)
class PoseUncertainty:
    """Standard deviations of everything between a pixel and its place on the map.

    Attributes
    ----------
    heading_deg, pitch_deg, roll_deg : float
        Of the pose [degrees].
    focal_relative : float
        Of the focal length, as a share of it, at most 0.3.
    position_m : float
        Of the eye's place, east and north each [m].
    eye_m : float
        Of the eye's elevation [m].
    dem_m : float
        Vertical error of the DEM [m]: of a cell against the terrain that could hide it, taken as constant over the
        part of a ray near its end.
    """

    heading_deg: float = 0.5
    pitch_deg: float = 0.3
    roll_deg: float = 0.5
    focal_relative: float = 0.01
    position_m: float = TYPICAL_POSITION_ERROR_M
    eye_m: float = 2.0
    dem_m: float = 3.0

    def __post_init__(self) -> None:
        if min(self.sigmas) < 0 or min(self.eye_m, self.dem_m) < 0:
            raise ValueError(f"standard deviations must not be negative: {self}")
        if self.focal_relative > 0.3:
            raise ValueError(f"the focal length's deviation is a share of it, at most 0.3: {self}")

    @property
    def sigmas(self) -> np.ndarray:
        """(7,) in the order of `PARAMETERS`; the last is the eye's height against the terrain at the ray's end."""
        height = float(np.hypot(self.eye_m, self.dem_m))
        return np.array(
            [self.heading_deg, self.pitch_deg, self.roll_deg, self.focal_relative]
            + [self.position_m, self.position_m, height]
        )

    def with_heading_interval(self, heading_lo_deg: float, heading_hi_deg: float) -> PoseUncertainty:
        """Take the heading's spread from its 90 % interval, clockwise from lo to hi [degrees]."""
        width = difference(heading_hi_deg, heading_lo_deg)
        width = width if width >= 0 else width + 360.0
        return replace(self, heading_deg=float(width / (2 * Z_90)))

    def with_position_radius(self, radius_m: float) -> PoseUncertainty:
        """Take the position's spread from the radius that holds the true place with probability 0.68 [m]."""
        return replace(self, position_m=radius_m / RADIUS_PER_AXIS)


def pose_draws(uncertainty: PoseUncertainty, pairs: int = 24, seed: int = 20) -> np.ndarray:
    """Draw deviations from a pose.

    Parameters
    ----------
    uncertainty : PoseUncertainty
    pairs : int
        Half the number of draws, at least 7.
    seed : int

    Returns
    -------
    (2 * pairs, 7) array
        In the order and units of `PARAMETERS`; mean 0 and covariance diag(sigmas^2) exactly.
    """
    if pairs < len(PARAMETERS):
        raise ValueError(f"at least {len(PARAMETERS)} pairs of draws are needed, not {pairs}")
    normal = np.random.default_rng(seed).standard_normal((pairs, len(PARAMETERS)))
    factor = np.linalg.cholesky(normal.T @ normal / pairs)
    white = np.linalg.solve(factor, normal.T).T
    return np.concatenate([white, -white]) * uncertainty.sigmas
