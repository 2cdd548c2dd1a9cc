"""Uncertainty of a pose, and random draws from it.

Draws are antithetic and whitened: their mean is the pose itself and their covariance is exactly the given one. A few
dozen therefore give the moments of a linear map without sampling noise, and still respond to bends and edges of a
surface.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .angles import difference

Z_90 = 1.6448536269514722
"""A normal variable stays within this many standard deviations with probability 0.9."""

TYPICAL_POSITION_ERROR_M = 8.0
"""Standard deviation of a phone's GPS position under open sky, along each axis [m]."""

RADIUS_PER_AXIS = 1.5096
"""Radius that contains 68 % of the positions, in standard deviations of one coordinate (Rayleigh)."""

LARGEST = {"pitch_deg": 90.0, "roll_deg": 90.0, "focal_relative": 0.3}
"""Limits of the standard deviations that intervals give."""

PARAMETERS = ("heading_deg", "pitch_deg", "roll_deg", "log_focal", "east_m", "north_m", "height_m")


@dataclass(frozen=True)
class PoseUncertainty:
    """Standard deviations of all quantities that relate a pixel to its place on the map.

    Attributes
    ----------
    heading_deg, pitch_deg, roll_deg : float
        Standard deviations of heading, pitch and roll [degrees].
    focal_relative : float
        Standard deviation of the focal length, as a share of it, at most 0.3.
    position_m : float
        Standard deviation of the eye's position, along east and north each [m].
    eye_m : float
        Standard deviation of the eye's elevation [m].
    dem_m : float
        Standard deviation of the DEM's vertical error [m]: of a cell relative to the terrain that could hide it, taken
        as constant over the part of a ray near its end.
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
        """Standard deviations (7,) of `PARAMETERS`; the last is of the eye's height relative to the ray's end."""
        height = float(np.hypot(self.eye_m, self.dem_m))
        return np.array(
            [self.heading_deg, self.pitch_deg, self.roll_deg, self.focal_relative]
            + [self.position_m, self.position_m, height]
        )

    def with_pose_of(self, other: PoseUncertainty) -> PoseUncertainty:
        """Take over pitch, roll and focal length from another uncertainty."""
        return replace(self, pitch_deg=other.pitch_deg, roll_deg=other.roll_deg, focal_relative=other.focal_relative)

    def with_heading_interval(self, heading_lo_deg: float, heading_hi_deg: float) -> PoseUncertainty:
        """Derive the heading's standard deviation from its 90 % interval, clockwise from lo to hi [degrees]."""
        width = difference(heading_hi_deg, heading_lo_deg)
        width = width if width >= 0 else width + 360.0
        return replace(self, heading_deg=float(width / (2 * Z_90)))

    def with_interval(self, name: str, low: float, high: float) -> PoseUncertainty:
        """Derive one standard deviation from a 90 % interval.

        Parameters
        ----------
        name : str
            One of `LARGEST`.
        low, high : float
            Ends of the interval [degrees], or of the logarithm of the focal length.
        """
        return replace(self, **{name: min(max(high - low, 0.0) / (2 * Z_90), LARGEST[name])})

    def with_position_radius(self, radius_m: float) -> PoseUncertainty:
        """Derive the position's standard deviation from the radius [m] that holds 68 % of the positions."""
        return replace(self, position_m=radius_m / RADIUS_PER_AXIS)


def pose_draws(uncertainty: PoseUncertainty, pairs: int = 24, seed: int = 20) -> np.ndarray:
    """Draw deviations from a pose.

    Parameters
    ----------
    uncertainty : PoseUncertainty
    pairs : int
        Half the number of draws, at least 7.
    seed : int
        Seed of the random generator.

    Returns
    -------
    (2 * pairs, 7) array
        Deviations in the order and units of `PARAMETERS`, with mean 0 and covariance diag(sigmas^2) exactly.
    """
    if pairs < len(PARAMETERS):
        raise ValueError(f"at least {len(PARAMETERS)} pairs of draws are needed, not {pairs}")
    normal = np.random.default_rng(seed).standard_normal((pairs, len(PARAMETERS)))
    factor = np.linalg.cholesky(normal.T @ normal / pairs)
    white = np.linalg.solve(factor, normal.T).T
    return np.concatenate([white, -white]) * uncertainty.sigmas
