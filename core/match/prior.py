"""Define the priors on the lens and the heading, including the prior from a recorded compass heading."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.camera import (
    DOUBTFUL_FOCAL_SIGMA,
    FOCAL_SIGMA,
    ULTRA_WIDE_MM,
    Camera,
    focal_from_35mm_px,
    focal_of_fov_px,
)
from ..base.errors import MissingMetadataError
from ..base.messages import Message

WIDE = 3.0
"""How many times as far the wide part of a heading prior's core spreads."""


EFFECTIVE_COLUMNS = 15.0
"""Number of independent groups of columns in a picture: what one unit of the mean score per column is worth in nats."""


@dataclass(frozen=True)
class RollPrior:
    """Prior on the roll: Gaussian for small rolls, exponential for large ones (pseudo-Huber).

    Most pictures are level to a few degrees, but a camera that is held freely may be off by 15.

    Attributes
    ----------
    sigma_deg : float
        Standard deviation of the Gaussian part [degrees].
    tail : float
        The exponential part begins at about this many standard deviations.
    """

    sigma_deg: float = 3.0
    tail: float = 1.5

    def cost(self, roll_deg):
        """Negative log of the density relative to a level picture [nats]."""
        return self.tail**2 * (self._stretch(roll_deg) - 1)

    def stiffness(self, roll_deg):
        """Slope of the cost over the roll: positive, and the curvature of the Gaussian at 0 [nats / degree^2]."""
        return 1 / (self.sigma_deg**2 * self._stretch(roll_deg))

    def _stretch(self, roll_deg):
        return np.sqrt(1 + np.square(np.asarray(roll_deg, float) / (self.sigma_deg * self.tail)))


@dataclass(frozen=True)
class CameraPrior:
    """Lens before the fit.

    Attributes
    ----------
    camera : Camera
        Camera of the full upright picture.
    focal_sigma : float
        Relative standard deviation of the focal length.
    """

    camera: Camera
    focal_sigma: float = FOCAL_SIGMA


def camera_prior(metadata, hfov_deg=None):
    """Camera and uncertainty of its focal length before the fit.

    Parameters
    ----------
    metadata : PhotoMetadata
    hfov_deg : float or None
        Horizontal field of view of the upright picture [degrees]. If None, the 35 mm equivalent is converted by the
        diagonal rule, with the spread given in the metadata, and a wider one for ultra-wide lenses.

    Raises
    ------
    MissingMetadataError
        The field of view is not given, and the photo records no focal length.
    """
    width, height = metadata.width_px, metadata.height_px
    if hfov_deg is not None:
        focal, sigma = focal_of_fov_px(width, hfov_deg), FOCAL_SIGMA
    elif metadata.focal_length_35mm is not None:
        focal, sigma = focal_from_35mm_px(width, height, metadata.focal_length_35mm), metadata.focal_sigma
        if metadata.focal_length_35mm < ULTRA_WIDE_MM:
            sigma = max(sigma, DOUBTFUL_FOCAL_SIGMA)
    else:
        raise MissingMetadataError(
            Message(
                "The photo has no focal length (35 mm equivalent). Give the horizontal field of view in HFOV_FIELD."
            )
        )
    return CameraPrior(Camera(width, height, focal), sigma)


@dataclass(frozen=True)
class HeadingPrior:
    """Soft prior on the heading, from a compass or a person.

    Attributes
    ----------
    heading_deg : float
        True heading [degrees].
    sigma_deg : float
        Spread of the core [degrees].
    outlier_share : float
        Probability that the given heading is worthless (uniform over the circle).
    faults : tuple of (float, float)
        Known errors: a turn [degrees] to add to `heading_deg`, and its probability.
    wide_share : float
        Share of the core that spreads `WIDE` times as far: readings beside iron or with a poor calibration.
    """

    heading_deg: float
    sigma_deg: float
    outlier_share: float = 0.1
    faults: tuple = ()
    wide_share: float = 0.0

    @property
    def spread_deg(self):
        """Standard deviation of the whole core [degrees]."""
        return self.sigma_deg * float(np.sqrt(1 - self.wide_share + self.wide_share * WIDE**2))

    @property
    def core_share(self):
        """Probability that the heading is right within its spread."""
        return 1 - self.outlier_share - sum(share for _, share in self.faults)


def log_ratio(prior, heading_deg):
    """Log of the prior's density over the uniform one, at headings [degrees].

    The density has a Gaussian core, copies of it at the prior's known faults (a phone held the other way turns its
    compass by 90 degrees), and a uniform share. The result is never below the log of that share, so that no prior can
    rule out an answer.
    """
    heading_deg = np.asarray(heading_deg, float)
    if prior is None:
        return np.zeros(heading_deg.shape)
    density = np.full(heading_deg.shape, float(prior.outlier_share))
    for turn, share in ((0.0, prior.core_share), *prior.faults):
        away = difference(heading_deg, prior.heading_deg + turn)
        for part, spread in ((1 - prior.wide_share, 1.0), (prior.wide_share, WIDE)):
            density = density + share * part * _gaussian_ratio(away, spread * prior.sigma_deg)
    return np.log(np.maximum(density, 1e-12))


def _gaussian_ratio(turn_deg, sigma_deg):
    return 360 / (np.sqrt(2 * np.pi) * sigma_deg) * np.exp(-0.5 * np.square(turn_deg / sigma_deg))


@dataclass(frozen=True)
class CompassOptions:
    """Error model of a recorded heading.

    Attributes
    ----------
    sigma_deg : float
        Spread of the core [degrees].
    wide_share : float
        Share of the core that spreads `WIDE` times as far. For the compasses of 47 photographs of known heading, and
        for those left without any one region, 4.5 degrees and shares of 0 to 0.3 are the likeliest; the defaults are
        a little more careful.
    outlier_share : float
        Share of the readings that carry no information.
    quarter_turn_share, half_turn_share : float
        Shares of the readings that are off by 90 degrees to either side (each), and by 180 degrees.
    """

    sigma_deg: float = 5.0
    wide_share: float = 0.3
    outlier_share: float = 0.1
    quarter_turn_share: float = 0.02
    half_turn_share: float = 0.01

    def __post_init__(self):
        if not self.sigma_deg >= 5:
            raise ValueError(f"no phone's compass is better than 5 degrees in the mountains, not {self.sigma_deg}")
        if not 0 < self.outlier_share + 2 * self.quarter_turn_share + self.half_turn_share < 1:
            raise ValueError("the shares of bad readings must add up to between 0 and 1")

    def with_outliers(self, share):
        """Return the options for another share of worthless readings; the shares of all others keep their ratios."""
        rest = (1 - share) / (1 - self.outlier_share)
        quarter, half = rest * self.quarter_turn_share, rest * self.half_turn_share
        return replace(self, outlier_share=share, quarter_turn_share=quarter, half_turn_share=half)


def true_heading_deg(metadata, declination_deg=None):
    """Recorded heading against true north [degrees], or None if there is none or it cannot be converted.

    Parameters
    ----------
    metadata : PhotoMetadata
        A reading without a reference is taken as true.
    declination_deg : float or None
        Bearing of magnetic north at the photo's place and time, east of true north positive [degrees].
    """
    if metadata.compass_heading_deg is None:
        return None
    if metadata.compass_reference != "M":
        return float(wrap_360(metadata.compass_heading_deg))
    return None if declination_deg is None else float(wrap_360(metadata.compass_heading_deg + declination_deg))


def compass_prior(heading_deg, options=CompassOptions()):
    """Turn a true compass heading [degrees] into a soft prior with quarter- and half-turn faults; None stays None."""
    if heading_deg is None:
        return None
    quarter, half = options.quarter_turn_share, options.half_turn_share
    faults = ((90.0, quarter), (-90.0, quarter), (180.0, half))
    return HeadingPrior(float(heading_deg), options.sigma_deg, options.outlier_share, faults, options.wide_share)
