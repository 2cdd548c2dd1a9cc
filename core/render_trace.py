"""The ground behind every pixel, worked out in blocks of rows so that large pictures stay within memory."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from .progress import checkpoint
from .render_cast import first_hits_m, pixel_directions

PIXELS_PER_BLOCK = 400_000


@dataclass(frozen=True, eq=False)
class Traced:
    """Directions of all pixels and what they meet, (H, W) float32 arrays.

    Attributes
    ----------
    turn_deg, tangent : arrays
        Azimuth from the heading [degrees] and tangent of the elevation angle.
    distance_m : array
        Ground distance; inf for sky [m].
    east_m, north_m, elevation_m : arrays
        Place of the ground; NaN for sky [m].
    """

    turn_deg: np.ndarray
    tangent: np.ndarray
    distance_m: np.ndarray
    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray


def row_blocks(camera):
    """Ranges of rows of about `PIXELS_PER_BLOCK` pixels."""
    height = max(PIXELS_PER_BLOCK // camera.width_px, 1)
    return [range(start, min(start + height, camera.height_px)) for start in range(0, camera.height_px, height)]


def turns_deg(camera, pose):
    """Leftmost and rightmost azimuth in the frame, from the heading [degrees]."""
    seen = [pixel_directions(camera, pose, rows)[0] for rows in row_blocks(camera)]
    return float(min(turn.min() for turn in seen)), float(max(turn.max() for turn in seen))


def trace(fan, camera, pose, eye_m, progress):
    """Find the ground behind every pixel."""
    shape = camera.height_px, camera.width_px
    fields = [np.empty(shape, np.float32) for _ in range(6)]
    for rows in row_blocks(camera):
        checkpoint(progress, rows.start / camera.height_px)
        turn, tangent = pixel_directions(camera, pose, rows)
        angle = np.radians(pose.heading_deg + turn)
        distance = first_hits_m(fan, (pose.heading_deg + turn).ravel(), tangent.ravel()).reshape(turn.shape)
        reach = np.where(np.isfinite(distance), distance, np.nan)
        elevation = eye_m + reach * tangent + apparent_drop_m(reach, REFRACTION_COEFFICIENT)
        found = turn, tangent, distance, reach * np.sin(angle), reach * np.cos(angle), elevation
        for field, values in zip(fields, found):
            field[rows.start : rows.stop] = values
    return Traced(*fields)
