"""What a phone's compass says, and how far it can be believed.

GPSImgDirection is the direction of the picture when taken, against true (T) or magnetic (M) north. Phones are off
by 5 to 10 degrees in the mountains as a rule and much more at times; a phone held the other way than its software
thinks turns the reading by a quarter or half circle.
"""

from __future__ import annotations

from dataclasses import dataclass

from .angles import wrap_360
from .prior import HeadingPrior


@dataclass(frozen=True)
class CompassOptions:
    """Belief in a recorded heading.

    Attributes
    ----------
    sigma_deg : float
        Spread of the core [degrees].
    outlier_share : float
        Readings that say nothing.
    quarter_turn_share, half_turn_share : float
        Readings that are off by 90 degrees to either side (each), and by 180 degrees.
    """

    sigma_deg: float = 10.0
    outlier_share: float = 0.1
    quarter_turn_share: float = 0.02
    half_turn_share: float = 0.01

    def __post_init__(self):
        if not self.sigma_deg >= 5:
            raise ValueError(f"no phone's compass is better than 5 degrees in the mountains, not {self.sigma_deg}")
        if not 0 < self.outlier_share + 2 * self.quarter_turn_share + self.half_turn_share < 1:
            raise ValueError("the shares of bad readings must add up to between 0 and 1")


def true_heading_deg(metadata, declination_deg=None):
    """Recorded heading against true north [degrees], or None where there is none or it cannot be turned to true.

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
    """Turn a true compass heading [degrees] into a soft prior with quarter-turn faults; None stays None."""
    if heading_deg is None:
        return None
    quarter, half = options.quarter_turn_share, options.half_turn_share
    faults = ((90.0, quarter), (-90.0, quarter), (180.0, half))
    return HeadingPrior(float(heading_deg), options.sigma_deg, options.outlier_share, faults)
