"""Determine the 35 mm equivalent of a picture in its present crop, and how certain it is, from EXIF tags.

References
----------
.. [1] CIPA DC-008 / JEITA CP-3451, Exif 2.32 and 3.0.
"""

from __future__ import annotations

from math import hypot, isfinite, log

from ..base.camera import DIAGONAL_35MM, DOUBTFUL_FOCAL_SIGMA, FOCAL_SIGMA
from ..base.messages import Message

MILLIMETRES_PER_UNIT = {1: 25.4, 2: 25.4, 3: 10.0, 4: 1.0, 5: 0.001}
"""Values of FocalPlaneResolutionUnit: 2 inch, 3 centimetre; 1, 4 and 5 (none, mm, um) are read as ExifTool does."""

SENSOR_DIAGONALS_MM = (2.0, 80.0)
"""Range from the smallest phone to medium format; a value outside it means a wrong FocalPlaneXResolution."""

EQUIVALENTS_MM = (8.0, 3000.0)
"""Range of the 35 mm equivalents of rectilinear lenses; cameras write 1, 4 or 65535 if they do not know it."""

PHONE_FOCAL_MM, PHONE_SENSOR_MM = 12.0, 18.0
"""Behind a lens of less than 12 mm there is no sensor larger than 18 mm, unless the lens is an extreme wide angle."""

LARGEST_MISFIT = 1.15
"""Ratio between the recorded 35 mm equivalent and that of the recorded sensor from which they contradict each other."""

SENSOR_SHAPES = (4 / 3, 3 / 2)
"""Usual shapes of sensors. For pictures of other shapes phones still record the equivalent of the whole sensor, and the
diagonal rule does not account for that."""

SAME_SHAPE = 0.01
"""Relative difference between two shapes that rounding can explain."""

LEAST_CROP = 0.5
"""A picture whose shape differs from the recorded one was cropped, not reduced, if its sides are at least this share of
the recorded sides."""


def number(tags, name):
    """Give a tag's first value if it is finite, else None."""
    value = tags.get(name, (float("nan"),))[0]
    return value if isfinite(value) else None


def positive(tags, name):
    """Give a tag's first value if it is finite and above 0, else None."""
    value = number(tags, name)
    return value if value is not None and value > 0 else None


def focal_length_35mm(tags, width_px, height_px, notes):
    """Give the 35 mm equivalent of the picture in its present crop (None if unknown), and its relative sigma.

    Parameters
    ----------
    tags : dict
        Tags as `exif.read_tags` gives them.
    width_px, height_px : int
        Size of the stored picture [pixels].
    notes : list
        Receives the `Message`s for the user.

    Returns
    -------
    (float or None, float)
    """
    sensor_mm = _sensor_mm(tags, width_px, height_px)
    length, sigma = _recorded(tags, sensor_mm, notes), FOCAL_SIGMA
    derived = _from_sensor(tags, sensor_mm)
    if length is None:
        if derived is None:
            return None, FOCAL_SIGMA
        length = derived
        notes.append(Message("The 35 mm equivalent was derived from the focal length and the focal plane resolution."))
    elif derived is not None and not 1 / LARGEST_MISFIT < derived / length < LARGEST_MISFIT:
        sigma = abs(log(derived / length))
        notes.append(
            Message(
                "The recorded 35 mm equivalent of {recorded} mm contradicts the recorded focal length and sensor, from "
                "which {derived} mm follows. If you know the horizontal field of view, give it in HFOV_FIELD.",
                recorded=f"{length:.0f}",
                derived=f"{derived:.0f}",
            )
        )
    size = max(width_px, height_px), min(width_px, height_px)
    recorded = _recorded_size(tags, size)
    enlarged = _crop_factor(recorded[0], recorded[1], size[0], size[1])
    if enlarged > 1:
        notes.append(
            Message(
                "The picture is cropped: a 35 mm equivalent of {used} mm was used instead of "
                "{recorded} mm. If you know the horizontal field of view, give it in HFOV_FIELD.",
                used=f"{length * enlarged:.0f}",
                recorded=f"{length:.0f}",
            )
        )
    usual = any(_same_shape(size[0] / size[1], shape) for shape in SENSOR_SHAPES)
    if enlarged > 1 or _zoom(tags) > 1 or not usual:
        sigma = max(sigma, DOUBTFUL_FOCAL_SIGMA)
    return length * enlarged, sigma


def _zoom(tags):
    return max(positive(tags, "DigitalZoomRatio") or 1.0, 1.0)


def _recorded(tags, sensor_mm, notes):
    """Give the recorded equivalent if a lens can have it, with a digital zoom that it leaves out; else None."""
    length, focal_mm, zoom = positive(tags, "FocalLengthIn35mmFilm"), positive(tags, "FocalLength"), _zoom(tags)
    if length is None:
        return None
    too_short = focal_mm is not None and length < focal_mm * DIAGONAL_35MM / SENSOR_DIAGONALS_MM[1]
    if too_short or not EQUIVALENTS_MM[0] <= length <= EQUIVALENTS_MM[1]:
        notes.append(
            Message(
                "No lens has the recorded 35 mm equivalent of {recorded} mm; it was ignored.", recorded=f"{length:g}"
            )
        )
        return None
    if focal_mm is None or zoom < LARGEST_MISFIT:
        return length
    # The standard asks for the equivalent after digital zoom. Without it, the sensor would be this large.
    left_out = focal_mm < PHONE_FOCAL_MM and focal_mm * zoom * DIAGONAL_35MM / length > PHONE_SENSOR_MM
    if sensor_mm is not None:
        native = focal_mm * DIAGONAL_35MM / sensor_mm
        left_out = abs(log(length / native)) < abs(log(length / (native * zoom)))
    if not left_out:
        return length
    notes.append(
        Message(
            "The recorded 35 mm equivalent leaves out the digital zoom: {used} mm was used instead of {recorded} mm.",
            used=f"{length * zoom:.0f}",
            recorded=f"{length:.0f}",
        )
    )
    return length * zoom


def _recorded_size(tags, size):
    """Give the long and short side of the picture as the camera stored it; `size` if that is not recorded."""
    sides = positive(tags, "PixelXDimension"), positive(tags, "PixelYDimension")
    return size if None in sides else (max(sides), min(sides))


def _crop_factor(recorded_long, recorded_short, long, short):
    """Give the factor by which cropping narrowed the recorded field of view; 1 if the picture was not cropped.

    A copy of another shape that is not much smaller was cropped without resampling. A much smaller one is taken for a
    reduced copy of the largest crop of its shape.
    """
    kept = max(long / recorded_long, short / recorded_short)
    if _same_shape(recorded_long / recorded_short, long / short) or kept > 1:
        return 1.0
    scale = 1.0 if kept >= LEAST_CROP else kept
    return hypot(recorded_long, recorded_short) * scale / hypot(long, short)


def _same_shape(one, other):
    return abs(one - other) <= SAME_SHAPE * other


def _sensor_mm(tags, width_px, height_px):
    """Give the diagonal of the recorded frame on the sensor [mm]; None if unknown or impossible."""
    unit_mm = MILLIMETRES_PER_UNIT.get(number(tags, "FocalPlaneResolutionUnit") or 2)
    x_resolution, y_resolution = positive(tags, "FocalPlaneXResolution"), positive(tags, "FocalPlaneYResolution")
    if unit_mm is None or x_resolution is None or y_resolution is None:
        return None
    # The resolution refers to the picture as the camera stored it; a resampled copy shows the same field of view.
    stored_width = positive(tags, "PixelXDimension") or width_px
    stored_height = positive(tags, "PixelYDimension") or height_px
    sensor_mm = hypot(stored_width / x_resolution, stored_height / y_resolution) * unit_mm
    return sensor_mm if SENSOR_DIAGONALS_MM[0] <= sensor_mm <= SENSOR_DIAGONALS_MM[1] else None


def _from_sensor(tags, sensor_mm):
    """Derive the 35 mm equivalent of the recorded frame by the diagonal rule from the sensor; None if unknown."""
    focal_mm = positive(tags, "FocalLength")
    if focal_mm is None or sensor_mm is None:
        return None
    length = focal_mm * _zoom(tags) * DIAGONAL_35MM / sensor_mm
    return length if EQUIVALENTS_MM[0] <= length <= EQUIVALENTS_MM[1] else None
