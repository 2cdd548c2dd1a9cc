"""Warnings about points whose place or height is unlikely, from which terrain is about to be computed."""

from __future__ import annotations

from ...core.base.errors import PhotoError
from ...core.base.place import doubts_of_place
from .feedback import warn
from .photo_points import ACCURACY_FIELD, value_of


def warn_of_place(feedback, point, terrain, observer):
    """Warn if the position is uncertain by a kilometre or more, or the eye lies far below or above the ground.

    A place off the DEM is not spoken of here: computing from it has its own message.

    Parameters
    ----------
    feedback : QgsProcessingFeedback
    point : PointRow or PhotoPoint
        With a feature and a name.
    terrain : core.io.raster.Dem
    observer : Observer or None
        None: the point has no position.
    """
    if observer is None:
        return
    try:
        doubts = doubts_of_place(terrain, observer, value_of(point.feature, ACCURACY_FIELD))
    except PhotoError:
        return
    for doubt in doubts:
        warn(feedback, point.name, doubt)
