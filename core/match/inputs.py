"""Define the inputs of a match: everything known about one photograph before the search for its heading."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..base.model import HorizonProfile, SkylineEvidence
from ..base.uncertainty import TYPICAL_POSITION_ERROR_M
from .prior import CameraPrior, HeadingPrior


@dataclass(frozen=True, eq=False)
class Eye:
    """One hypothesis of the eye's elevation, and what the DEM shows from there.

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
        Further hypotheses of the eye's elevation; see `eyes.py`.
    """

    evidence: SkylineEvidence
    camera_prior: CameraPrior
    horizon: HorizonProfile
    heading_prior: HeadingPrior | None = None
    landmarks: tuple = ()
    position_error_m: float = TYPICAL_POSITION_ERROR_M
    inner: object | None = None
    other_eyes: tuple = ()

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
