"""Fitted places with given positions and scores: `from fitted_places import places`."""

from __future__ import annotations

import numpy as np
from skyline_viewshed.core.locate.fitted import FittedPlaces


def places(longitude, latitude, score):
    """Places whose poses are all zero."""
    count = len(score)
    return FittedPlaces(
        np.arange(count),
        np.array(longitude, float),
        np.array(latitude, float),
        np.zeros((count, 5)),
        np.array(score, float),
        np.full((count, 2, 2), np.nan),
        np.full((count, 2), np.nan),
        np.full(count, np.nan),
    )
