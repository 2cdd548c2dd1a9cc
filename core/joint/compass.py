"""What photographs of one device and hour share: the error of the compass.

Steel and calibration mislead a compass in much the same way for an hour. The common error is an unknown of its own, of
which nothing is known beforehand: so a compass tells how the headings of photographs differ, and never a heading alone.
"""

from __future__ import annotations

import numpy as np

from ..base.angles import difference, wrap_360
from .circle import mixture

HOUR_S = 3600.0
SIGMA_DEG = 4.0
"""Spread of a reading once the error that it shares with its neighbours is removed."""
WIDE, WIDE_SHARE = 3.0, 0.3
"""A share of the readings spreads so many times as far."""
FAULTS = ((90.0, 0.02), (-90.0, 0.02), (180.0, 0.01))
"""Turns of a phone that is held another way, and the share of each."""
WORTHLESS_SHARE = 0.15
"""Share of the readings that say nothing, among them those after the common error has changed."""


def reading_error():
    """Density of a reading's own error on the grid of `circle`."""
    whole = 1 - WORTHLESS_SHARE - sum(share for _, share in FAULTS)
    turns = np.array([0.0, *(turn for turn, _ in FAULTS)])
    shares = np.array([whole, *(share for _, share in FAULTS)])
    spread = SIGMA_DEG * np.repeat([1.0, WIDE], len(turns))
    parts = np.concatenate([(1 - WIDE_SHARE) * shares, WIDE_SHARE * shares])
    return mixture(np.tile(turns, 2), spread, parts)


def device_hours(photos):
    """Number the groups of photographs with a compass from one device within an hour.

    Parameters
    ----------
    photos : sequence of OrientedPhoto

    Returns
    -------
    dict of int to int
        Group of a photograph; those without reading, time or device have none.
    """
    usable = [
        (photo.metadata.camera, photo.metadata.taken_at, number)
        for number, photo in enumerate(photos)
        if photo.compass_true_deg is not None
        and photo.metadata is not None
        and photo.metadata.taken_at is not None
        and photo.metadata.camera
    ]
    groups: dict = {}
    group, began = -1, (None, None)
    for camera, taken_at, number in sorted(usable, key=lambda entry: (entry[0], entry[1].isoformat(), entry[2])):
        if began[0] != camera or (taken_at - began[1]).total_seconds() > HOUR_S:
            group, began = group + 1, (camera, taken_at)
        groups[number] = group
    return groups


def reading_of_tree(photos, tree, headings, groups):
    """Reading of the compass for tied photographs, as one: they were taken at one place, and share its iron.

    Parameters
    ----------
    photos : sequence of OrientedPhoto
    tree : sequence of int
        Their numbers, the root first.
    headings : dict of int to float
        Headings that are consistent with the ties [degrees].
    groups : dict of int to int
        From `device_hours`.

    Returns
    -------
    group, reading_deg, told : int, float, list of int
        Of the root, and the photographs whose readings it unites; None if there are none.
    """
    told = [number for number in tree if number in groups]
    if not told:
        return None
    kinds = [groups[number] for number in told]
    group = max(set(kinds), key=lambda kind: (kinds.count(kind), -kind))
    root = headings[tree[0]]
    told = [number for number in told if groups[number] == group]
    readings = [photos[number].compass_true_deg - float(difference(headings[number], root)) for number in told]
    return group, float(wrap_360(readings[0] + np.median(difference(readings, readings[0])))), told
