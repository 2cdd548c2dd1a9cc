"""The answer of a search: the best places of one photograph."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..base.messages import Message
from ..base.model import Orientation, OrientedPhoto
from .judge import Ellipse, Facts


@dataclass(frozen=True, eq=False)
class LocatedPlace:
    """One place at which a photograph may have been taken.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
    oriented : OrientedPhoto
        The photograph as seen from there, with its pose and horizon.
    score, probability : float
    ellipse : Ellipse or None
    """

    longitude_deg: float
    latitude_deg: float
    oriented: OrientedPhoto
    score: float
    probability: float
    ellipse: Ellipse | None = None


@dataclass(frozen=True, eq=False)
class Located:
    """The answer for one photograph.

    Attributes
    ----------
    path : str
    status : str
        'accepted', 'ambiguous', 'rejected' (not in this area, or undecided) or 'failed'.
    message : Message
    places : tuple of LocatedPlace
        Best first.
    p_correct : float or None
        Probability that the best place is within 500 m and its heading within 3 degrees.
    region : (M,) int array
        Places of the index that hold 90 % of the probability if the photograph was taken in the area.
    score : (P,) array
        Score of the coarse search at every place of the index.
    facts : Facts or None
    """

    path: str
    status: str
    message: Message
    places: tuple = ()
    p_correct: float | None = None
    region: np.ndarray = field(default_factory=lambda: np.zeros(0, int))
    score: np.ndarray = field(default_factory=lambda: np.zeros(0))
    facts: Facts | None = None


@dataclass(frozen=True, eq=False)
class Known:
    """What is known beside the picture.

    Attributes
    ----------
    heading_prior : core.match.prior.HeadingPrior or None
    log_weight : (P,) array or None
        Logarithms of the weights of the places of the index; -inf excludes a place.
    """

    heading_prior: object | None = None
    log_weight: np.ndarray | None = None


def oriented_at(photo, evidence, best, where, says):
    """The photograph as seen from one place.

    Parameters
    ----------
    photo : Photo
    evidence : SkylineEvidence
    best : Candidate
        Pose and camera of the full picture.
    where : (longitude_deg, latitude_deg, HorizonProfile)
    says : (status, Message)

    Returns
    -------
    OrientedPhoto
    """
    longitude_deg, latitude_deg, profile = where
    return OrientedPhoto(
        photo.metadata.path,
        Orientation(says[0], says[1], (best,), p_correct=best.probability),
        metadata=photo.metadata,
        preview=photo.pixels,
        camera=best.camera,
        skyline=evidence.best,
        evidence=evidence,
        horizon=profile,
        longitude_deg=longitude_deg,
        latitude_deg=latitude_deg,
        eye_elevation_m=profile.eye_elevation_m,
    )
