"""A posed photograph on a terrain, and conversion between ground, direction and pixel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .camera import Camera, Pose, in_frame, project, project_vectors, unproject
from .curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from .frame import LocalFrame
from .posed import PosedPhoto
from .terrain import Terrain, eye_elevation_m
from .uncertainty import PoseUncertainty

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, eq=False)
class View:
    """A posed photograph that has been opened on a terrain; see `open_view`.

    Attributes
    ----------
    photo : PosedPhoto
    frame : LocalFrame
        Frame around the eye; places are given in its local metres (east, north).
    eye_elevation_m : float
        Absolute elevation of the eye in the DEM's height system [m].
    refraction_coefficient : float
        See `core.base.curvature`.
    """

    photo: PosedPhoto
    frame: LocalFrame
    eye_elevation_m: float
    refraction_coefficient: float = REFRACTION_COEFFICIENT

    @property
    def camera(self) -> Camera:
        """Camera of the full upright picture."""
        return self.photo.camera

    @property
    def pose(self) -> Pose:
        """Direction and roll of the camera."""
        return self.photo.pose

    @property
    def uncertainty(self) -> PoseUncertainty:
        """Uncertainty of pose, focal length, position and heights."""
        return self.photo.uncertainty

    def ray_of(self, x_px: ArrayLike, y_px: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Give the direction of pixels: true azimuth and elevation angle above the horizontal [degrees]."""
        return unproject(self.camera, self.pose, x_px, y_px)

    def direction_of(
        self, east_m: ArrayLike, north_m: ArrayLike, elevation_m: ArrayLike
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Give the direction in which the eye sees places.

        Parameters
        ----------
        east_m, north_m : array
            Local coordinates [m].
        elevation_m : array
            Absolute elevation in the DEM's height system [m].

        Returns
        -------
        azimuth_deg, elevation_deg, distance_m : array
            True azimuth and apparent elevation angle, up positive [degrees], and ground distance [m].
        """
        distance = np.hypot(east_m, north_m)
        azimuth = np.mod(np.degrees(np.arctan2(east_m, north_m)), 360.0)
        elevation = np.degrees(np.arctan2(self.rise_of(east_m, north_m, elevation_m), distance))
        return azimuth, elevation, distance

    def pixel_of(self, east_m: ArrayLike, north_m: ArrayLike, elevation_m: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Give the pixels (x, y) of places, whether or not terrain hides them; NaN behind the camera.

        Parameters
        ----------
        east_m, north_m : array
            Local coordinates [m].
        elevation_m : array
            Absolute elevation in the DEM's height system [m].
        """
        return project_vectors(self.camera, self.pose, east_m, north_m, self.rise_of(east_m, north_m, elevation_m))

    def rise_of(self, east_m: ArrayLike, north_m: ArrayLike, elevation_m: ArrayLike) -> np.ndarray:
        """Give the apparent height of places above the eye's horizontal plane, curvature and refraction included [m].

        Parameters
        ----------
        east_m, north_m : array
            Local coordinates [m].
        elevation_m : array
            Absolute elevation in the DEM's height system [m].
        """
        drop = apparent_drop_m(np.hypot(east_m, north_m), self.refraction_coefficient)
        return np.subtract(elevation_m, self.eye_elevation_m) - drop

    def frames(self, x_px: np.ndarray, y_px: np.ndarray) -> np.ndarray:
        """Tell which pixels lie on the picture."""
        return in_frame(self.camera, x_px, y_px)

    @property
    def wedge_deg(self) -> tuple[float, float]:
        """Centre azimuth and width of the picture's outline [degrees]; the width is 360 if it shows zenith or nadir."""
        x, y = outline_px(self.camera)
        azimuth, elevation = self.ray_of(x, y)
        if elevation.max() > 89 or elevation.min() < -89 or _holds_a_pole(self):
            return self.pose.heading_deg, 360.0
        turn = np.mod(azimuth - self.pose.heading_deg + 180.0, 360.0) - 180.0
        return self.pose.heading_deg + (turn.min() + turn.max()) / 2, float(turn.max() - turn.min())


def _holds_a_pole(view: View) -> bool:
    x, y = project(view.camera, view.pose, view.pose.heading_deg, np.array([90.0, -90.0]))
    return bool(np.any(view.frames(x, y)))


def outline_px(camera: Camera, per_side: int = 33) -> tuple[np.ndarray, np.ndarray]:
    """Give (x, y) of the picture's outer edge, clockwise from the upper left and closed [pixels]."""
    t = np.linspace(0.0, 1.0, per_side)[:-1]
    x = np.concatenate([t, np.ones_like(t), 1 - t, np.zeros_like(t), [0.0]])
    y = np.concatenate([np.zeros_like(t), t, np.ones_like(t), 1 - t, [0.0]])
    return x * camera.width_px - 0.5, y * camera.height_px - 0.5


def open_view(
    terrain: Terrain,
    photo: PosedPhoto,
    max_distance_m: float,
    refraction_coefficient: float = REFRACTION_COEFFICIENT,
) -> View:
    """Place a posed photograph on a terrain.

    Parameters
    ----------
    terrain : Terrain
    photo : PosedPhoto
    max_distance_m : float
        Distance to which the view must reach [m].
    refraction_coefficient : float
        See `core.base.curvature`.

    Returns
    -------
    View

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    observer = photo.observer
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, 1.01 * max_distance_m)
    eye = eye_elevation_m(terrain, frame, observer)
    return View(photo, frame, eye, refraction_coefficient)
