"""Fitted places: sorted, thinned out and joined."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.curvature import METRES_PER_DEGREE


@dataclass(frozen=True, eq=False)
class FittedPlaces:
    """Places with the best pose at each; (K,) arrays, best first.

    Attributes
    ----------
    source : int array
        Place of the index from which each comes.
    longitude_deg, latitude_deg : arrays
    trial : (K, 5) array
        See `core.match.geometry.PARAMETERS`.
    score : array
        Mean log-likelihood ratio over the columns.
    curvature : (K, 2, 2) array
        Of the negative score by east and north, with the pose fitted anew at each place [1/m2]; NaN if not known.
    focal_slope : (K, 2) array
        Change of the fitted log focal length with east and north [1/m].
    eye_height_m : (K,) array
        Height of the eye above the DEM [m]; NaN for the height of the index.
    """

    source: np.ndarray
    longitude_deg: np.ndarray
    latitude_deg: np.ndarray
    trial: np.ndarray
    score: np.ndarray
    curvature: np.ndarray
    focal_slope: np.ndarray
    eye_height_m: np.ndarray

    def take(self, order):
        """The places of these indices."""
        return FittedPlaces(*(getattr(self, name)[order] for name in self.__dataclass_fields__))

    def plus(self, gain):
        """The places with `gain` (K,) added to their scores, best first again."""
        moved = replace(self, score=self.score + gain)
        return moved.take(np.argsort(-moved.score, kind="stable"))

    def once(self):
        """The places with only the best pose of each; best first."""
        return self.take(np.sort(np.unique(self.source, return_index=True)[1]))


def distinct(found, separation_m, count):
    """Indices of the best places that are farther than `separation_m` from one another.

    Parameters
    ----------
    found : FittedPlaces
        Best first.
    separation_m : float
    count : int
        Largest number of places.
    """
    kept: list[int] = []
    for place in range(len(found.score)):
        if all(distance_m(found, place, other) > separation_m for other in kept):
            kept.append(place)
            if len(kept) == count:
                break
    return np.array(kept, int)


def distance_m(found, place, other):
    """Ground distance between two places [m], exact enough within an area.

    Parameters
    ----------
    found : FittedPlaces
    place, other : int
    """
    north = (found.latitude_deg[place] - found.latitude_deg[other]) * METRES_PER_DEGREE
    east = (found.longitude_deg[place] - found.longitude_deg[other]) * METRES_PER_DEGREE
    return float(np.hypot(east * np.cos(np.radians(found.latitude_deg[place])), north))


def joined(parts):
    """All places of several `FittedPlaces`, in their order."""
    names = FittedPlaces.__dataclass_fields__
    return FittedPlaces(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))
