"""Which photographs of a run are tied by features, how well, and the trees that the ties make."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from ..base.angles import difference
from ..base.curvature import METRES_PER_DEGREE
from ..base.progress import checkpoint
from ..base.uncertainty import TYPICAL_POSITION_ERROR_M
from .ties import features, turn_between

NEAR_M = 200.0
"""Photographs farther apart are not compared: near terrain would move against far terrain."""
MOST_TIES = 6
"""Neighbours with which a photograph is compared, the nearest in time."""
TIE_SIGMA_DEG = 0.4
"""Error of a turn from features: the lens. 26 ties of khumbu-trek are within 0.5 degrees of the known headings."""
PARALLAX_SHARE = 0.5
"""Share of the parallax at the horizon by which a turn is wrong: the features lie on both sides of that distance."""
USUAL_DISTANCE_M = 5_000.0
"""Distance of the terrain if a photograph has no horizon."""
LARGEST_SIGMA_DEG = 3.0
"""A turn that is less certain is not looked for."""
UNKNOWN_MOVE_M = 2 * TYPICAL_POSITION_ERROR_M
"""Error of the distance between two recorded positions [m]."""
STEP_M, PACE_M_S = 2.0, 1.5
"""A person moves so far between two photographs at once, and so fast after that."""


@dataclass(frozen=True, eq=False)
class Tie:
    """Turn of the camera between two photographs.

    Attributes
    ----------
    one, other : int
        Their numbers.
    rotation : (3, 3) array
        From the axes of one camera to those of the other.
    sigma_deg : float
        Standard deviation about each axis [degrees].
    count : int
        Features that agree on it.
    """

    one: int
    other: int
    rotation: np.ndarray
    sigma_deg: float
    count: int = 0

    def towards(self, number):
        """Rotation that leads to one of the two."""
        return self.rotation if number == self.other else self.rotation.T


def ties_between(photos, progress):
    """Compare the features of photographs that were taken near one another.

    Parameters
    ----------
    photos : list of OrientedPhoto
    progress : Progress

    Returns
    -------
    list of Tie
    """
    pairs, found = near_pairs(photos), []
    known: dict = {}
    for done, (one, other) in enumerate(pairs):
        checkpoint(progress, done / len(pairs))
        sigma_deg = _sigma_deg(photos[one], photos[other])
        if sigma_deg > LARGEST_SIGMA_DEG:
            continue
        views = [_view(photos[number], number, known) for number in (one, other)]
        if None in views:
            continue
        turn = turn_between(views[0][:2], views[1][:2], views[0][2], views[1][2])
        if turn is not None:
            found.append(Tie(one, other, turn[0], sigma_deg, turn[1]))
    return consistent(found)


def near_pairs(photos):
    """Pairs of photographs to compare: each with the nearest in time of those close by."""
    pairs: set = set()
    for one, photo in enumerate(photos):
        near = [
            (apart_s(photo, photos[other]), other)
            for other in range(len(photos))
            if other != one and distance_m(photo, photos[other]) < NEAR_M
        ]
        pairs.update((min(one, other), max(one, other)) for _, other in sorted(near)[:MOST_TIES])
    return sorted(pairs)


def consistent(ties):
    """Drop ties that belong to triangles none of which closes: the wrong turn of repeated or moving features."""
    known = {frozenset((tie.one, tie.other)): tie for tie in ties}
    around: dict = {}
    for tie in ties:
        around.setdefault(tie.one, set()).add(tie.other)
        around.setdefault(tie.other, set()).add(tie.one)
    kept = []
    for tie in ties:
        closes = [
            _closes(tie, known[frozenset((tie.other, third))], known[frozenset((tie.one, third))], third)
            for third in around[tie.one] & around[tie.other]
        ]
        if not closes or any(closes):
            kept.append(tie)
    return kept


def _closes(tie, to_third, from_third, third):
    around = from_third.towards(tie.one) @ to_third.towards(third) @ tie.rotation
    angle = np.degrees(np.arccos(np.clip((np.trace(around) - 1) / 2, -1, 1)))
    return angle <= 4 * np.sqrt(tie.sigma_deg**2 + to_third.sigma_deg**2 + from_third.sigma_deg**2)


def trees(count, ties, trust):
    """Give the tree of the most certain ties from the most trusted photograph of every group of tied ones.

    Parameters
    ----------
    count : int
        Of the photographs.
    ties : list of Tie
    trust : (count,) array
        Which photograph is the root of its group: that with the largest value.

    Returns
    -------
    list of list of (int, Tie or None)
        For each group the photographs, each after the one that its tie leads from; the root comes first.
    """
    variance = [tie.sigma_deg**2 for tie in ties]
    ends = np.array([(tie.one, tie.other) for tie in ties], int).reshape(-1, 2)
    graph = coo_matrix((variance, (ends[:, 0], ends[:, 1])), (count, count)).tocsr()
    between = {frozenset((tie.one, tie.other)): tie for tie in ties}
    found = []
    seen: set = set()
    for root in sorted(range(count), key=lambda number: (-trust[number], number)):
        if root in seen:
            continue
        away, before = dijkstra(graph, directed=False, indices=root, return_predecessors=True)
        tree = []
        for number in sorted(np.flatnonzero(np.isfinite(away)), key=lambda number: (away[number], number)):
            tie = None if number == root else between[frozenset((int(number), int(before[number])))]
            tree.append((int(number), tie))
        seen.update(number for number, _ in tree)
        found.append(tree)
    return found


def distance_m(one, other):
    """Distance between two photographs on the ground [m]; infinite if a position is unknown."""
    if None in (one.longitude_deg, other.longitude_deg, one.latitude_deg, other.latitude_deg):
        return np.inf
    north = one.latitude_deg - other.latitude_deg
    east = difference(one.longitude_deg, other.longitude_deg) * np.cos(np.radians(one.latitude_deg))
    return METRES_PER_DEGREE * float(np.hypot(east, north))


def apart_s(one, other):
    """Time between two photographs [s]; infinite if one is unknown."""
    times = [photo.metadata and photo.metadata.taken_at for photo in (one, other)]
    return np.inf if None in times else abs((times[0] - times[1]).total_seconds())


def _view(photo, number, known):
    if photo.camera is None or photo.preview is None:
        return None
    if number not in known:
        known[number] = features(photo.preview, photo.skyline)
    shape = photo.preview.shape
    return known[number] and (shape, known[number], photo.camera.focal_px * shape[1] / photo.camera.width_px)


def _sigma_deg(one, other):
    apart = float(np.hypot(distance_m(one, other), min(UNKNOWN_MOVE_M, STEP_M + PACE_M_S * apart_s(one, other))))
    return float(np.hypot(TIE_SIGMA_DEG, PARALLAX_SHARE * np.degrees(apart / min(map(_terrain_m, (one, other))))))


def _terrain_m(photo):
    """Median distance of the horizon inside the frame [m]; of the whole circle if the heading is unknown."""
    if photo.horizon is None or not np.isfinite(photo.horizon.distance_m).any():
        return USUAL_DISTANCE_M
    inside = np.ones(len(photo.horizon.azimuth_deg), bool)
    if photo.heading_deg is not None:
        inside = np.abs(difference(photo.horizon.azimuth_deg, photo.heading_deg)) <= photo.hfov_deg / 2
    distance = photo.horizon.distance_m[inside]
    return float(max(np.nanmedian(distance), 100.0)) if np.isfinite(distance).any() else USUAL_DISTANCE_M
