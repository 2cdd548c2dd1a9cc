"""The exact pinhole camera: fields of view from EXIF, pose, and conversion between pixels and directions.

Pixel coordinates start at the centre of the upright picture's first pixel, with x to the right and y down::

        up, y_up                         north
        |   forward (optical axis)       |  heading
        |  /                             | /
        | / pitch above the horizon      |/______ east
        |/______ right, x

Heading is clockwise from true north, pitch is positive upwards, roll is positive when the camera's right side is
down (clockwise seen from behind); a positive roll makes the horizon climb to the right in the picture.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

DIAGONAL_35MM = float(np.hypot(36.0, 24.0))
"""Diagonal of the 35 mm frame [mm], to which EXIF's FocalLengthIn35mmFilm refers (CIPA DCG-001, Exif 2.32)."""

FOCAL_SIGMA = 0.025
"""Relative standard deviation of a focal length from EXIF or the user; EXIF values were found to be up to 4 % off."""

DOUBTFUL_FOCAL_SIGMA = 0.05
"""The same after digital zoom or a crop, and for shapes that no sensor has, since EXIF's frame is unclear then; and for
ultra-wide lenses, whose distortion the camera's correction trades against the focal length (13 mm was off by 8 %)."""

ULTRA_WIDE_MM = 18.0
"""Lenses with a 35 mm equivalent below this are ultra-wide [mm]."""


@dataclass(frozen=True)
class Pose:
    """Direction in which a camera looks, and its roll.

    Attributes
    ----------
    heading_deg : float
        Azimuth of the optical axis, clockwise from true north [degrees].
    pitch_deg : float
        Angle of the optical axis above (+) or below (-) the horizontal [degrees].
    roll_deg : float
        Rotation about the optical axis, + with the right side down [degrees].
    """

    heading_deg: float
    pitch_deg: float = 0.0
    roll_deg: float = 0.0


@dataclass(frozen=True)
class Camera:
    """Size of an upright picture, and its lens.

    Attributes
    ----------
    width_px, height_px : int
        Size of the upright picture [pixels].
    focal_px : float
        Focal length [pixels of this picture].
    offset_x_px, offset_y_px : float
        Offset of the principal point from the picture's centre, + right and + down [pixels].
    k1, k2 : float
        Radial distortion: x_distorted = x (1 + k1 r^2 + k2 r^4) with r in focal lengths (Brown 1971, as in OpenCV).
    """

    width_px: int
    height_px: int
    focal_px: float
    offset_x_px: float = 0.0
    offset_y_px: float = 0.0
    k1: float = 0.0
    k2: float = 0.0

    def __post_init__(self) -> None:
        if self.width_px < 1 or self.height_px < 1 or not self.focal_px > 0:
            raise ValueError(f"a camera needs a positive size and focal length, not {self}")

    @property
    def centre_px(self) -> tuple[float, float]:
        """Principal point (x, y) [pixels]."""
        return (self.width_px - 1) / 2 + self.offset_x_px, (self.height_px - 1) / 2 + self.offset_y_px

    @property
    def hfov_deg(self) -> float:
        """Horizontal field of view across the picture's middle [degrees]."""
        return fov_of_focal_deg(self.width_px, self.focal_px)

    @property
    def vfov_deg(self) -> float:
        """Vertical field of view across the picture's middle [degrees]."""
        return fov_of_focal_deg(self.height_px, self.focal_px)

    def scaled(self, width_px: int, height_px: int) -> Camera:
        """Give the camera of the same picture resampled to another size [pixels]."""
        factor = width_px / self.width_px
        return replace(
            self,
            width_px=width_px,
            height_px=height_px,
            focal_px=self.focal_px * factor,
            offset_x_px=self.offset_x_px * factor,
            offset_y_px=self.offset_y_px * height_px / self.height_px,
        )


def folds(camera: Camera) -> bool:
    """Tell whether the distortion turns back within the picture, so that its corners show nothing."""
    radius = np.hypot(camera.width_px, camera.height_px) / 2 / camera.focal_px
    r2 = np.linspace(0.0, 4 * radius, 200) ** 2
    gain = 1 + camera.k1 * r2 + camera.k2 * r2 * r2
    slope = 1 + 3 * camera.k1 * r2 + 5 * camera.k2 * r2 * r2
    # Only the part that appears in the picture has to be one-to-one.
    reached = np.cumsum(slope <= 0) > 0
    return bool((np.sqrt(r2) * gain)[~reached].max() < radius and reached.any())


def fov_of_focal_deg(side_px: float, focal_px: float) -> float:
    """Give the full angle that a side of `side_px` subtends at a focal length of `focal_px` [degrees]."""
    return float(np.degrees(2 * np.arctan(side_px / (2 * focal_px))))


def focal_of_fov_px(side_px: float, fov_deg: float) -> float:
    """Give the focal length [pixels] at which a side of `side_px` subtends the full angle `fov_deg` [degrees]."""
    if not 0 < fov_deg < 180:
        raise ValueError(f"a field of view must lie between 0 and 180 degrees, not {fov_deg}")
    return float(side_px / (2 * np.tan(np.radians(fov_deg) / 2)))


def focal_from_35mm_px(width_px: float, height_px: float, focal_length_35mm: float) -> float:
    """Give the focal length [pixels] for EXIF's 35 mm equivalent by the diagonal rule, for any shape and orientation.

    Parameters
    ----------
    width_px, height_px : float
        Size of the upright picture [pixels].
    focal_length_35mm : float
        FocalLengthIn35mmFilm [mm].

    References
    ----------
    .. [1] CIPA DCG-001; Exif 2.32, tag FocalLengthIn35mmFilm: the equivalent refers to the diagonal.
    """
    return float(np.hypot(width_px, height_px) * focal_length_35mm / DIAGONAL_35MM)


def project(
    camera: Camera, pose: Pose, azimuth_deg: ArrayLike, elevation_deg: ArrayLike
) -> tuple[np.ndarray, np.ndarray]:
    """Map directions to pixels.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    azimuth_deg, elevation_deg : array
        True azimuth, and elevation angle above the horizontal [degrees]; broadcast together.

    Returns
    -------
    x_px, y_px : array
        Pixels, NaN for directions behind the camera (more than about 89.9 degrees off the axis).
    """
    azimuth, elevation = np.radians(azimuth_deg), np.radians(elevation_deg)
    level = np.cos(elevation)
    return project_vectors(camera, pose, level * np.sin(azimuth), level * np.cos(azimuth), np.sin(elevation))


def project_vectors(
    camera: Camera, pose: Pose, east: ArrayLike, north: ArrayLike, up: ArrayLike
) -> tuple[np.ndarray, np.ndarray]:
    """Map directions given as vectors of any length to pixels, like `project` but without its trigonometry.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    east, north, up : array
        Components of the vectors, all in the same unit; broadcast together.

    Returns
    -------
    x_px, y_px : array
        Pixels, NaN for directions behind the camera (more than about 89.9 degrees off the axis).
    """
    right, down, forward = to_camera_axes(pose, east, north, up)
    with np.errstate(divide="ignore", invalid="ignore"):
        forward = np.where(forward > 1e-3 * np.sqrt(right**2 + down**2 + forward**2), forward, np.nan)
        x, y = right / forward, down / forward
    x, y = _distort(camera, x, y)
    centre_x, centre_y = camera.centre_px
    return centre_x + camera.focal_px * x, centre_y + camera.focal_px * y


def to_camera_axes(
    pose: Pose, east: ArrayLike, north: ArrayLike, up: ArrayLike
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rotate vectors from (east, north, up) to the camera's axes; their lengths do not change.

    Parameters
    ----------
    pose : Pose
    east, north, up : array
        Components of the vectors, all in the same unit; broadcast together.

    Returns
    -------
    right, down, forward : array
        Components in the same unit; `forward` is along the optical axis.
    """
    heading, pitch, roll = np.radians(pose.heading_deg), np.radians(pose.pitch_deg), np.radians(pose.roll_deg)
    aside = np.multiply(east, np.cos(heading)) - np.multiply(north, np.sin(heading))
    level = np.multiply(east, np.sin(heading)) + np.multiply(north, np.cos(heading))
    forward = level * np.cos(pitch) + np.multiply(up, np.sin(pitch))
    above = np.multiply(up, np.cos(pitch)) - level * np.sin(pitch)
    right = aside * np.cos(roll) - above * np.sin(roll)
    return right, -above * np.cos(roll) - aside * np.sin(roll), forward


def unproject(camera: Camera, pose: Pose, x_px: ArrayLike, y_px: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Map pixels to directions; the inverse of `project`.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    x_px, y_px : array
        Pixels of the camera's picture; broadcast together.

    Returns
    -------
    azimuth_deg, elevation_deg : array
        True azimuth in [0, 360), and elevation angle above the horizontal [degrees].
    """
    centre_x, centre_y = camera.centre_px
    x = np.subtract(x_px, centre_x) / camera.focal_px
    y = np.subtract(y_px, centre_y) / camera.focal_px
    x, y = _undistort(camera, x, y)
    pitch, roll = np.radians(pose.pitch_deg), np.radians(pose.roll_deg)
    right = x * np.cos(roll) - y * np.sin(roll)
    up = -y * np.cos(roll) - x * np.sin(roll)
    level = np.cos(pitch) - up * np.sin(pitch)
    rise = up * np.cos(pitch) + np.sin(pitch)
    azimuth = np.degrees(np.arctan2(right, level)) + pose.heading_deg
    return np.mod(azimuth, 360.0), np.degrees(np.arctan2(rise, np.hypot(right, level)))


def in_frame(camera: Camera, x_px: np.ndarray, y_px: np.ndarray) -> np.ndarray:
    """Tell which pixels lie on the picture, outer half pixels included.

    Parameters
    ----------
    camera : Camera
    x_px, y_px : array
        Coordinates [pixels]; NaN counts as outside.

    Returns
    -------
    bool array
    """
    with np.errstate(invalid="ignore"):
        across = (x_px >= -0.5) & (x_px <= camera.width_px - 0.5)
        return across & (y_px >= -0.5) & (y_px <= camera.height_px - 0.5)


def _distort(camera: Camera, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    if camera.k1 == 0 and camera.k2 == 0:
        return x, y
    r2 = x * x + y * y
    # Beyond the radius at which the polynomial turns back, it would fold distant directions into the picture.
    gain = 1 + camera.k1 * r2 + camera.k2 * r2 * r2
    slope = 1 + 3 * camera.k1 * r2 + 5 * camera.k2 * r2 * r2
    gain = np.where(slope > 0, gain, np.nan)
    return x * gain, y * gain


def _undistort(camera: Camera, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    if camera.k1 == 0 and camera.k2 == 0:
        return x, y
    x0, y0 = x, y
    for _ in range(20):  # converges quickly for |k1| r^2 well below 1
        r2 = x * x + y * y
        gain = 1 + camera.k1 * r2 + camera.k2 * r2 * r2
        x, y = x0 / gain, y0 / gain
    return x, y
