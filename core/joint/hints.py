"""Hints on headings from accepted photographs: by features in common, and by the error of the compass.

A compass is wrong in much the same way for an hour, as the steel and the calibration that mislead it stay the same. Its
error at accepted photographs therefore corrects its readings at the others.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.messages import Message
from .ties import features, turn_between, turned

TRUSTED = ("accepted", "confirmed")
NEAR_M = 25.0
"""Photographs whose positions differ by less may differ by a turn."""
TIE_SIGMA_DEG = 1.5
MOST_TIES = 4
HOUR_S = 3600.0
LEAST_READINGS = 2
"""Accepted photographs within an hour that must agree on the compass's error."""
AGREEING_DEG = 6.0
"""Largest spread of their errors."""
COMPASS_SIGMA_DEG = 4.0
"""Spread of a reading once the error that it shares with its neighbours is removed."""
METRES_PER_DEGREE = 111_195.0


@dataclass(frozen=True)
class NeighbourHint:
    """An approximate heading from other photographs.

    Attributes
    ----------
    heading_deg, sigma_deg : float
        True heading and its standard deviation [degrees].
    note : Message
        Which photographs helped, and how.
    """

    heading_deg: float
    sigma_deg: float
    note: Message

    def applied(self, request):
        """Give a `PhotoRequest` that heading; a tolerance counts as two standard deviations."""
        return replace(request, heading_deg=self.heading_deg, heading_tolerance_deg=2 * self.sigma_deg)


def neighbour_hints(photos):
    """Find hints for the photographs of a run that no skyline decides alone.

    Parameters
    ----------
    photos : list of OrientedPhoto

    Returns
    -------
    dict
        `NeighbourHint` by the photograph's index.
    """
    trusted = [index for index, photo in enumerate(photos) if photo.status in TRUSTED]
    open_ones = [index for index, photo in enumerate(photos) if photo.status in ("ambiguous", "rejected")]
    known: dict = {}
    found: dict = {}
    for index in open_ones:
        hint = _by_features(photos, index, trusted, known) or _by_compass(photos, index, trusted)
        if hint is not None:
            found[index] = hint
    return found


def better(alone, again, hint):
    """Choose between a photograph's answer alone and the one with a hint; the note says which photograph helped.

    An answer that is not accepted replaces the first one only if that contradicts the hint, so that no answer is lost.

    Parameters
    ----------
    alone, again : OrientedPhoto
    hint : NeighbourHint
    """
    if again.heading_deg is None:
        return alone
    contradicts = alone.heading_deg is None or _away(alone, hint) > max(3 * hint.sigma_deg, 5.0)
    if again.status not in TRUSTED and not (contradicts and _away(again, hint) <= 2 * hint.sigma_deg):
        return alone
    return replace(again, orientation=replace(again.orientation, notes=(*again.orientation.notes, hint.note)))


def _away(photo, hint):
    return abs(float(difference(photo.heading_deg, hint.heading_deg)))


def _by_features(photos, index, trusted, known):
    """Heading from the photographs at the same place whose features match."""
    photo, found = photos[index], []
    near = [other for other in trusted if _distance_m(photo, photos[other]) < NEAR_M]
    near.sort(key=lambda other: _apart_s(photo, photos[other]))
    for other in near[:MOST_TIES]:
        rotation = _rotation(photos, other, index, known)
        if rotation is not None:
            found.append((other, turned(photos[other].orientation.best.pose, rotation).heading_deg))
    if not found:
        return None
    headings = np.array([heading for _, heading in found])
    middle = float(wrap_360(headings[0] + np.median(difference(headings, headings[0]))))
    spread = float(np.abs(difference(headings, middle)).max())
    if spread > AGREEING_DEG:
        return None
    names = ", ".join(_name(photos[other]) for other, _ in found)
    note = Message("Features that it shares with {photos} gave the approximate heading.", photos=names)
    return NeighbourHint(middle, max(TIE_SIGMA_DEG, spread), note)


def _rotation(photos, one, other, known):
    views = []
    for index in (one, other):
        if index not in known:
            known[index] = features(photos[index].preview)
        if known[index] is None or photos[index].camera is None:
            return None
        shape = photos[index].preview.shape
        views.append(((shape, known[index]), photos[index].camera.focal_px * shape[1] / photos[index].camera.width_px))
    return turn_between(views[0][0], views[1][0], views[0][1], views[1][1])


def _by_compass(photos, index, trusted):
    """Heading from the compass, corrected by its error at accepted photographs of the same camera and hour."""
    photo = photos[index]
    if photo.compass_true_deg is None or photo.metadata is None or photo.metadata.taken_at is None:
        return None
    same = [
        other
        for other in trusted
        if photos[other].compass_true_deg is not None
        and photos[other].metadata.camera == photo.metadata.camera
        and _apart_s(photo, photos[other]) <= HOUR_S
    ]
    if len(same) < LEAST_READINGS:
        return None
    errors = np.array([float(difference(photos[o].compass_true_deg, photos[o].heading_deg)) for o in same])
    bias = float(np.median(errors))
    agreeing = [other for other, error in zip(same, errors) if abs(error - bias) <= AGREEING_DEG]
    if len(agreeing) < max(LEAST_READINGS, 0.7 * len(same)):
        return None
    sigma = float(np.hypot(COMPASS_SIGMA_DEG, COMPASS_SIGMA_DEG / np.sqrt(len(agreeing))))
    note = Message(
        "The compass, corrected by its error of {error}° at {count} photos of the same hour (such as {photo}), gave "
        "the approximate heading.",
        error=f"{bias:.1f}",
        count=len(agreeing),
        photo=_name(photos[agreeing[0]]),
    )
    return NeighbourHint(float(wrap_360(photo.compass_true_deg - bias)), sigma, note)


def _distance_m(one, other):
    if None in (one.longitude_deg, other.longitude_deg, one.latitude_deg, other.latitude_deg):
        return np.inf
    north = one.latitude_deg - other.latitude_deg
    east = difference(one.longitude_deg, other.longitude_deg) * np.cos(np.radians(one.latitude_deg))
    return METRES_PER_DEGREE * float(np.hypot(east, north))


def _apart_s(one, other):
    times = [photo.metadata and photo.metadata.taken_at for photo in (one, other)]
    return np.inf if None in times else abs((times[0] - times[1]).total_seconds())


def _name(photo):
    return photo.path.replace("\\", "/").rsplit("/", 1)[-1]
