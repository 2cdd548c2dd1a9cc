"""Search for places and directions worth a simulated photograph: a ridge in the frame, not the nearest slope."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..core.base.camera import Camera, Pose
from ..core.base.errors import ObserverError, TerrainError
from ..core.base.messages import Message
from ..core.base.posed import PosedPhoto
from ..core.base.progress import SILENT
from ..core.base.terrain import Observer, Terrain, ground_elevation_m
from ..core.base.view import View
from ..core.simulate.cast import cast_fan
from ..core.simulate.patch import read_patch

SCOUT_FOCAL_PX = 60.0
"""Focal length of the search camera, which samples the view at half a degree [pixels]."""


@dataclass(frozen=True)
class ViewpointOptions:
    """The criteria for a view.

    Attributes
    ----------
    eye_height_m : float
        Height above the terrain [m].
    near_m : float
        A horizon nearer than this is the slope on which the observer stands [m].
    range_m : float
        Distance up to which the search looks [m].
    least_relief_deg : float
        Least standard deviation of the horizon's elevation angle within the frame [degrees].
    roll_sigma_deg, largest_roll_deg : float
        Standard deviation of the roll, and its largest value [degrees].
    tries : int
        Number of places that are tried before the search fails.
    """

    eye_height_m: float = 1.7
    near_m: float = 1500.0
    range_m: float = 60_000.0
    least_relief_deg: float = 0.5
    roll_sigma_deg: float = 2.5
    largest_roll_deg: float = 8.0
    tries: int = 200


def find_view(
    terrain: Terrain,
    camera: Camera,
    generator,
    position_of,
    options: ViewpointOptions | None = None,
    finer: Terrain | None = None,
):
    """Draw a random place and direction from which the camera sees a ridge.

    Parameters
    ----------
    terrain : Terrain
    camera : Camera
    generator : numpy.random.Generator
    position_of : callable
        (col, row) -> (longitude_deg, latitude_deg) of the terrain's raster.
    options : ViewpointOptions or None
    finer : Terrain or None
        The terrain that the camera will really see; its humps close by must not hide the view that `terrain` promises.

    Returns
    -------
    (Observer, Pose)

    Raises
    ------
    TerrainError
        No such place was found.
    """
    options = options or ViewpointOptions()
    rows, cols = terrain.shape
    for _ in range(options.tries):
        col, row = (0.08 + 0.84 * generator.random(2)) * (cols - 1, rows - 1)
        observer = Observer(*map(float, position_of(col, row)), eye_height_m=options.eye_height_m)
        try:
            frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, options.range_m * 1.01)
            eye_m = ground_elevation_m(terrain, frame) + options.eye_height_m
            pose = _look(terrain, frame, eye_m, camera, generator, options)
            # Beside a void, the finer terrain may have no ground where the coarse one has.
            if pose is not None and (finer is None or _clear(terrain, finer, observer, camera, pose, options)):
                return observer, pose
        except ObserverError:
            continue
    raise TerrainError(
        Message("No view of a ridge was found in {count} places. Use a DEM with more relief.", count=options.tries)
    )


def _look(terrain, frame, eye_m, camera, generator, options):
    """Return a pose that frames a distant and varied part of this place's horizon, or None."""
    scout = Camera(2, 2, SCOUT_FOCAL_PX)
    turns = (-180.0, 180.0)
    patch = read_patch(terrain, frame, turns, 0.0, options.range_m)
    view = View(PosedPhoto(scout, Pose(0.0), Observer(frame.longitude_deg, frame.latitude_deg)), frame, eye_m)
    fan = cast_fan(patch, view, turns, options.range_m, SILENT)
    tangent = fan.highest[:, -1]
    distance = fan.distance_m[np.argmax(fan.tangent, axis=1)]
    elevation = np.degrees(np.arctan(tangent))
    azimuth = np.mod(fan.azimuth_deg, 360.0)
    for _ in range(6):
        heading = 360.0 * generator.random()
        inside = np.abs((azimuth - heading + 180) % 360 - 180) < camera.hfov_deg / 2
        seen = elevation[inside]
        far = (distance[inside] > options.near_m) & (seen > -60)
        if far.mean() < 0.75 or seen.std() < options.least_relief_deg * min(1.0, camera.hfov_deg / 20):
            continue
        middle, half = (seen.min() + seen.max()) / 2, camera.vfov_deg / 2
        if np.ptp(seen) > 1.7 * half:
            continue
        # The ridge may lie anywhere in the frame, mostly above its middle, and rarely leaves it.
        slack = half - np.ptp(seen) / 2
        pitch = middle - slack * (0.9 * generator.random() - 0.3)
        roll = np.clip(options.roll_sigma_deg * _normal(generator), -options.largest_roll_deg, options.largest_roll_deg)
        return Pose(float(heading), float(pitch), float(roll))
    return None


def _clear(terrain, finer, observer, camera, pose, options):
    """Return whether the finer terrain close by leaves most of the coarse terrain's horizon visible."""
    horizons = []
    for model, range_m in ((terrain, options.range_m), (finer, 2_500.0)):
        frame = model.frame(observer.longitude_deg, observer.latitude_deg, range_m * 1.01)
        eye_m = ground_elevation_m(model, frame) + options.eye_height_m
        turns = -camera.hfov_deg / 2 - 1, camera.hfov_deg / 2 + 1
        patch = read_patch(model, frame, turns, pose.heading_deg, range_m)
        view = View(PosedPhoto(Camera(2, 2, 4 * SCOUT_FOCAL_PX), pose, observer), frame, eye_m)
        fan = cast_fan(patch, view, turns, range_m, SILENT)
        horizons.append(np.degrees(np.arctan(fan.highest[:, -1])))
    return bool(np.mean(horizons[1] > horizons[0] + 0.5) < 0.15)


def _normal(generator):
    """Draw a normal deviate by the Box-Muller method: uniform numbers are the same in every version of NumPy."""
    first, second = generator.random(2)
    return float(np.sqrt(-2 * np.log(1 - first)) * np.cos(2 * np.pi * second))
