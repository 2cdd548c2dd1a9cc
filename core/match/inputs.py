"""Define the inputs of a match: everything known about one photograph before the search for its heading.

The elevation of the eye is one of the unknowns. Near terrain rises or sinks in the picture when the eye moves; far
terrain does not. The position on the map is known to a few metres, but the ground there is not: a DEM smooths the
floor of a valley upwards and a ridge downwards by a share of its cell, and a recorded altitude has errors of its own.
So the horizon is computed from several elevations, and the match takes the one that fits the skyline best.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.model import HorizonProfile, SkylineEvidence
from ..base.uncertainty import TYPICAL_POSITION_ERROR_M
from .prior import CameraPrior, HeadingPrior


@dataclass(frozen=True, eq=False)
class Eye:
    """Hypothesis of the eye's elevation, with what the DEM shows from there.

    Attributes
    ----------
    horizon : HorizonProfile
    inner : InnerTerrain or None
        Crests and ground below the horizon, for second evidence.
    log_prior : float
        Natural logarithm of its prior probability relative to the first hypothesis.
    """

    horizon: HorizonProfile
    inner: object | None = None
    log_prior: float = 0.0


@dataclass(frozen=True, eq=False)
class MatchInputs:
    """Everything known about one photograph before the match.

    Attributes
    ----------
    evidence : SkylineEvidence
        Where the skyline may lie in the picture.
    camera_prior : CameraPrior
        Lens of the full upright picture.
    horizon : HorizonProfile
        The DEM's horizon at the observer.
    heading_prior : HeadingPrior or None
        From a compass or a person.
    landmarks : tuple of Landmark
        In pixels of the full upright picture.
    position_error_m : float
        Standard deviation of the observer's position [m].
    inner : InnerTerrain or None
        Crests and ground below the horizon, for second evidence.
    other_eyes : tuple of Eye
        Further hypotheses of the eye's elevation; see `eye_offsets_m`.
    recorded_heading_deg : float or None
        True compass heading that takes no part in the match, but may cast doubt on its result [degrees].
    """

    evidence: SkylineEvidence
    camera_prior: CameraPrior
    horizon: HorizonProfile
    heading_prior: HeadingPrior | None = None
    landmarks: tuple = ()
    position_error_m: float = TYPICAL_POSITION_ERROR_M
    inner: object | None = None
    other_eyes: tuple = ()
    recorded_heading_deg: float | None = None

    @property
    def eyes(self):
        """All hypotheses of the eye's elevation, the assumed one first."""
        return (Eye(self.horizon, self.inner), *self.other_eyes)

    @property
    def reduced_prior(self):
        """Camera prior at the size of the evidence; the spread of the focal length is relative and does not change."""
        height, width = self.evidence.probability.shape
        return replace(self.camera_prior, camera=self.camera_prior.camera.scaled(width, height))

    @property
    def behind(self):
        """Inputs with the evidence's rival, the fainter line behind the most prominent one, as their evidence."""
        return replace(self, evidence=self.evidence.rival)

    def mirrored(self, eye):
        """Return the inputs of the picture's mirror image, seen by one of the eyes and without any hint of a heading.

        Parameters
        ----------
        eye : Eye
        """
        known = {"horizon": eye.horizon, "inner": eye.inner, "other_eyes": ()}
        return replace(self, evidence=_mirrored(self.evidence), heading_prior=None, landmarks=(), **known)


def _mirrored(evidence):
    """Evidence of the mirror image of a picture, without its rival."""
    best, (top, bottom, left, right) = evidence.best, evidence.crop
    names = "probability", "sky_score", "ridge_score", "thumbnail", "sky_map"
    maps = {name: getattr(evidence, name) for name in names}
    leaves = evidence.leaves_frame
    return replace(
        evidence,
        **{name: None if value is None else value[:, ::-1] for name, value in maps.items()},
        leaves_frame=None if leaves is None else leaves[::-1],
        best=replace(best, row_px=best.row_px[::-1], confidence=best.confidence[::-1]),
        crop=(top, bottom, right, left),
        rival=None,
    )


@dataclass(frozen=True)
class EyeOptions:
    """Which elevations of the eye are tried.

    Attributes
    ----------
    offsets_cells : tuple of float
        Heights above the assumed eye, in cells of the DEM.
    sigma_cells : float
        Standard deviation of the ground's error, in cells; makes a large offset less probable.
    largest_altitude_error_m : float
        A recorded altitude farther than this from the assumed eye is not believed [m].
    least_change : float
        A hypothesis counts only if it moves some of the horizon by more than this share of the tolerance that the
        DEM's own error asks for.
    """

    offsets_cells: tuple = (-0.25, 0.15, 0.35)
    sigma_cells: float = 0.3
    largest_altitude_error_m: float = 150.0
    least_change: float = 0.5


def eye_offsets_m(cell_m, recorded_above_m=None, options=EyeOptions()):  # noqa: B008 - frozen
    """Further elevations of the eye that are worth a horizon.

    Parameters
    ----------
    cell_m : float
        Ground size of the DEM's cells [m].
    recorded_above_m : float or None
        Recorded altitude above the assumed eye [m].
    options : EyeOptions

    Returns
    -------
    list of (float, float)
        Height above the assumed eye [m] and logarithm of the prior probability relative to the assumed one.
    """
    found = [(share * cell_m, -0.5 * (share / options.sigma_cells) ** 2) for share in options.offsets_cells]
    if recorded_above_m is not None and abs(recorded_above_m) <= options.largest_altitude_error_m:
        found.append((recorded_above_m, 0.0))
    return found


def differs(horizon: HorizonProfile, other: HorizonProfile, terrain_error_cells, options=EyeOptions()):  # noqa: B008
    """Tell whether two horizons differ by more than the DEM's own error hides.

    Parameters
    ----------
    horizon, other : HorizonProfile
        On the same azimuths.
    terrain_error_cells : float
        Error of the horizon's height in cells.
    options : EyeOptions
    """
    if other.elevation_deg.shape != horizon.elevation_deg.shape:
        return True
    error_deg = np.degrees(terrain_error_cells * horizon.cell_m / np.maximum(horizon.distance_m, horizon.cell_m))
    with np.errstate(invalid="ignore"):
        moved = np.abs(other.elevation_deg - horizon.elevation_deg) > options.least_change * error_deg
    return bool(moved.any())
