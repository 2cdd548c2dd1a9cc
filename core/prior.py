"""What is believed before the fit: about the lens, the heading, and single pixels of the picture."""

from __future__ import annotations

from dataclasses import dataclass

from .camera import FOCAL_SIGMA, Camera

TYPICAL_POSITION_ERROR_M = 8.0
"""Standard deviation of a phone's GPS under open sky."""


@dataclass(frozen=True)
class HeadingPrior:
    """A soft belief about the heading, from a compass or a person.

    Attributes
    ----------
    heading_deg : float
        True [degrees].
    sigma_deg : float
        Spread of the core [degrees].
    outlier_share : float
        Probability that it is worthless (uniform over the circle).
    faults : tuple of (float, float)
        Known ways to be wrong: a turn [degrees] to add to `heading_deg`, and its probability.
    """

    heading_deg: float
    sigma_deg: float
    outlier_share: float = 0.1
    faults: tuple = ()


@dataclass(frozen=True)
class Landmark:
    """A pixel of the full upright picture whose direction from the eye is known.

    Attributes
    ----------
    x_px, y_px : float
    azimuth_deg, elevation_deg : float
        True azimuth and elevation angle of the map point seen from the eye [degrees].
    sigma_px : float
        Precision of the click [pixels].
    """

    x_px: float
    y_px: float
    azimuth_deg: float
    elevation_deg: float
    sigma_px: float = 5.0


@dataclass(frozen=True)
class CameraPrior:
    """What is known of the lens before the fit.

    Attributes
    ----------
    camera : Camera
        Of the full upright picture.
    focal_sigma : float
        Relative standard deviation of the focal length.
    """

    camera: Camera
    focal_sigma: float = FOCAL_SIGMA
