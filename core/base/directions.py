"""Directions as unit vectors, so that one pose after another can project them without trigonometry."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from .camera import Camera, Pose, project, project_vectors, to_camera_axes

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

OUTSIDE = 0.25
"""Distance beyond the picture's edge up to which directions count as near it, as a share of the picture's size."""

ANGLES = 901
"""Angles that are tried for the corner, a tenth of a degree apart."""


@dataclass(frozen=True, eq=False)
class Directions:
    """Directions from one eye.

    Attributes
    ----------
    vectors : (3, N) array
        Unit vectors, east, north and up; NaN where unknown.
    """

    vectors: np.ndarray

    @classmethod
    def of(cls, azimuth_deg: ArrayLike, elevation_deg: ArrayLike) -> Directions:
        """Make them from true azimuths and elevation angles, (N,) arrays [degrees]."""
        azimuth, elevation = np.radians(np.asarray(azimuth_deg, float)), np.radians(np.asarray(elevation_deg, float))
        level = np.cos(elevation)
        return cls(np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(elevation)]))

    def ahead(self, camera: Camera, pose: Pose) -> np.ndarray:
        """Tell which directions can appear in the picture or within `OUTSIDE` of it: (N,) bool array.

        It is a cone about the optical axis, so some of them lie beyond that.
        """
        _, _, forward = to_camera_axes(pose, *self.vectors)
        with np.errstate(invalid="ignore"):
            return forward > np.cos(np.radians(corner_deg(camera)))

    def project(self, camera: Camera, pose: Pose) -> tuple[np.ndarray, np.ndarray]:
        """Map those that are `ahead` to pixels, (M,) arrays x and y; the others are left out."""
        return project_vectors(camera, pose, *self.vectors[:, self.ahead(camera, pose)])


@lru_cache(maxsize=16)
def corner_deg(camera: Camera) -> float:
    """Give the angle between the optical axis and the farthest point within `OUTSIDE` of the picture [degrees]."""
    middle_x, middle_y = camera.centre_px
    across = max(middle_x, camera.width_px - 1 - middle_x) + OUTSIDE * camera.width_px + 0.5
    down = max(middle_y, camera.height_px - 1 - middle_y) + OUTSIDE * camera.height_px + 0.5
    angle = np.linspace(0.0, 90.0, ANGLES)
    x, _ = project(camera, Pose(0.0), angle, 0.0)  # the distortion is radial
    with np.errstate(invalid="ignore"):
        within = np.flatnonzero(np.abs(x - middle_x) <= np.hypot(across, down))
    return float(angle[min(within[-1] + 1, ANGLES - 1)])
