"""Lines of equal azimuth and of equal elevation angle in a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.camera import in_frame, project, unproject
from ..base.view import outline_px

STEPS_DEG = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0)


@dataclass(frozen=True, eq=False)
class GraticuleLine:
    """A line of the graticule.

    Attributes
    ----------
    kind : str
        'azimuth' or 'elevation'.
    value_deg : float
        True azimuth in [0, 360), or elevation angle [degrees].
    x_px, y_px : (N,) arrays
        Vertices [pixels of the full upright picture]; NaN outside the picture.
    """

    kind: str
    value_deg: float
    x_px: np.ndarray
    y_px: np.ndarray


def graticule(camera, pose, lines=8):
    """Draw a graticule over a picture.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    lines : int
        Largest number of lines across the picture's wider side.

    Returns
    -------
    list of GraticuleLine
    """
    azimuth, elevation = unproject(camera, pose, *outline_px(camera))
    offset = np.mod(azimuth - pose.heading_deg + 180.0, 360.0) - 180.0
    step = next((s for s in STEPS_DEG if max(np.ptp(offset), np.ptp(elevation)) <= s * lines), STEPS_DEG[-1])
    low, high = float(max(elevation.min() - step, -89.0)), float(min(elevation.max() + step, 89.0))
    left, right = pose.heading_deg + float(offset.min()) - step, pose.heading_deg + float(offset.max()) + step
    along, around = np.linspace(low, high, 60), np.linspace(left, right, 120)
    drawn = [
        _line(camera, pose, "azimuth", float(value % 360.0), value, along) for value in _multiples(left, right, step)
    ]
    drawn += [_line(camera, pose, "elevation", float(value), around, value) for value in _multiples(low, high, step)]
    return [line for line in drawn if np.isfinite(line.x_px).any()]


def _multiples(low, high, step):
    return np.arange(np.ceil(low / step), np.floor(high / step) + 1) * step


def _line(camera, pose, kind, value_deg, azimuth_deg, elevation_deg):
    x, y = project(camera, pose, *np.broadcast_arrays(azimuth_deg, elevation_deg))
    inside = in_frame(camera, x, y)
    # A vertex outside stays where its neighbour is inside, so that the line reaches the picture's edge.
    near = inside | np.r_[False, inside[:-1]] | np.r_[inside[1:], False]
    return GraticuleLine(kind, round(value_deg, 6), np.where(near, x, np.nan), np.where(near, y, np.nan))
