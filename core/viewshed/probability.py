"""The probability that a photograph shows a cell, given the errors of pose, position and DEM.

There are two independent questions. *Can the cell be seen from there?* The sweep gives its clearance, the height above
the line of sight. An error of the DEM turns the sharp answer into a normal probability, and a few sweeps from places
around the camera's position average over the position's error. *Does it lie in the frame?* Samples of heading, pitch,
roll and focal length are projected with the cells' directions, which stay the same: no sweep is repeated for them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.special import ndtr

from ..base.angles import difference
from ..base.camera import Pose, in_frame, project
from ..base.curvature import apparent_drop_m
from ..base.errors import ObserverError
from ..base.progress import SILENT, checkpoint, subtask
from ..base.terrain import Window
from .layers import ClearanceSink
from .sector import PhotoFrame, Wedge
from .viewshed import ViewshedOptions, viewshed

TILE_ROWS = 256


@dataclass(frozen=True)
class SampleOptions:
    """How the errors of pose and focal length are sampled.

    Attributes
    ----------
    frames : int
        Number of samples of pose and focal length.
    seed : int
    """

    frames: int = 24
    seed: int = 0

    def __post_init__(self):
        if self.frames < 1:
            raise ValueError(f"at least one sample of the frame is needed, not {self.frames}")


@dataclass(frozen=True, eq=False)
class VisibilityProbability:
    """Probability that the photograph shows each cell.

    Attributes
    ----------
    window : Window
        Part of the raster that the values cover; outside it the probability is 0.
    values : (rows, cols) float32 array
        0 to 1; NaN where the DEM has no data.
    cell_area_m2 : float
        Area of a cell at the observer [m2].
    """

    window: Window
    values: np.ndarray
    cell_area_m2: float

    def area_m2(self, level):
        """Area of the ground with at least this probability [m2]."""
        with np.errstate(invalid="ignore"):
            return float((self.values >= level).sum() * self.cell_area_m2)

    def share(self, level):
        """Share of the ground expected in view (sum of the probabilities) that has at least this probability."""
        expected = float(np.nansum(self.values, dtype=float))
        with np.errstate(invalid="ignore"):
            sure = float(self.values[self.values >= level].sum(dtype=float))
        return sure / expected if expected else 0.0


def visibility_probability(
    terrain, photo, options=ViewshedOptions(), sampling=SampleOptions(), progress=SILENT  # noqa: B008 - frozen
):  # fmt: skip
    """Propagate the uncertainty of a photograph's pose to the ground that it shows.

    Parameters
    ----------
    terrain : Terrain
    photo : PosedPhoto
        Photograph with its uncertainty. The error of the eye's elevation is not used: it moves all lines of sight
        together, and the error of the DEM stands for it.
    options : ViewshedOptions
    sampling : SampleOptions
    progress : Progress

    Returns
    -------
    VisibilityProbability

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError, UnusableDemError
        Raised for the stated position only; shifted positions off the DEM are left out.
    """
    samples = _frame_samples(photo, sampling)
    sector = _sector(photo, samples)
    window, seen, frame, eye_m = _seen(terrain, photo, sector, options, subtask(progress, 0.0, 0.8))
    for first in range(0, window.rows, TILE_ROWS):
        checkpoint(progress, 0.8 + 0.2 * first / max(window.rows, 1))
        strip = seen[first : first + TILE_ROWS]
        row, col = np.nonzero(strip > 1e-3)
        if len(row):
            piece = terrain.read(Window(window.row + first, window.col, len(strip), window.cols))[row, col]
            place = frame.to_local(col + window.col, row + window.row + first)
            strip[row, col] *= _in_frame_share(piece + options.target_height_m, place, eye_m, options, samples)
        with np.errstate(invalid="ignore"):
            strip[strip <= 1e-3] = 0.0
    return VisibilityProbability(window, seen, float(np.prod(frame.cell_size_m)))


def _sector(photo, samples):
    """Wedge that holds the frame with its errors of heading and focal length, and all samples of the frame."""
    uncertainty = photo.uncertainty
    start, width = PhotoFrame(photo.camera, photo.pose).azimuth_range_deg
    middle = start + width / 2
    half = width / 2 + 3 * float(np.hypot(uncertainty.heading_deg, width / 2 * uncertainty.focal_relative))
    for sample in samples:  # a corner that rolls outwards lies outside the level frame
        start, width = PhotoFrame(*sample).azimuth_range_deg
        half = max(half, abs(float(difference(start + width / 2, middle))) + width / 2)
    return Wedge(middle % 360, min(2 * half, 360.0))


def _seen(terrain, photo, sector, options, progress):
    """Compute the probability that each cell can be seen at all: (window, probability, frame, eye elevation)."""
    uncertainty = photo.uncertainty
    places = _positions(photo.observer, uncertainty.position_m)
    total = weight = None
    for index, place in enumerate(places):
        part = subtask(progress, index / len(places), (index + 1) / len(places))
        sink = ClearanceSink
        if total is None:
            result = viewshed(terrain, place, sector, options, part, sink)
            window, frame, eye_m = result.window, result.frame, result.eye_elevation_m
            total, weight = _probability(result.values, uncertainty.dem_m), 1
            continue
        try:
            other = viewshed(terrain, place, sector, options, part, sink)
        except ObserverError:  # a shifted position may lie off the DEM or in a void
            continue
        _accumulate(total, window, _probability(other.values, uncertainty.dem_m), other.window)
        weight += 1
    total /= weight
    return window, total, frame, eye_m


def _positions(observer, sigma_m):
    """The stated position and four around it, whose mean and variance are those of the error."""
    if sigma_m == 0:
        return [observer]
    step = sigma_m * np.sqrt(2.5)  # four of the five positions carry the variance
    north = np.degrees(step / 6_371_000.0)
    east = north / max(np.cos(np.radians(observer.latitude_deg)), 1e-3)
    shifts = (0, 0), (east, 0), (-east, 0), (0, north), (0, -north)
    return [
        replace(observer, longitude_deg=observer.longitude_deg + dx, latitude_deg=observer.latitude_deg + dy)
        for dx, dy in shifts
    ]


def _probability(clearance, dem_m):
    """Probability that a cell stands above its line of sight, in the clearance's own memory.

    NaN stays NaN, and 0 (outside the sector) stays 0.
    """
    for first in range(0, len(clearance), TILE_ROWS):
        strip = clearance[first : first + TILE_ROWS]
        asked = strip != 0
        if dem_m == 0:
            strip[asked] = np.where(np.isnan(strip), strip, strip > 0)[asked]
        else:
            strip[asked] = ndtr(np.clip(strip[asked] / np.float32(dem_m), -9, 9))
    return clearance


def _accumulate(total, window, other, other_window):
    """Add the part of another window's values that lies in this window."""
    top, left = max(window.row, other_window.row), max(window.col, other_window.col)
    bottom = min(window.row + window.rows, other_window.row + other_window.rows)
    right = min(window.col + window.cols, other_window.col + other_window.cols)
    if top < bottom and left < right:
        mine = total[top - window.row : bottom - window.row, left - window.col : right - window.col]
        mine += other[
            top - other_window.row : bottom - other_window.row, left - other_window.col : right - other_window.col
        ]


def _frame_samples(photo, sampling):
    """Draw cameras and poses from the errors, in pairs of opposite sign so that their mean is exact."""
    camera, pose, uncertainty = photo.camera, photo.pose, photo.uncertainty
    half = -(-sampling.frames // 2)
    draw = np.random.default_rng(sampling.seed).standard_normal((half, 4))
    draw = np.concatenate([draw, -draw])[: max(sampling.frames, 1)]
    scale = uncertainty.heading_deg, uncertainty.pitch_deg, uncertainty.roll_deg, uncertainty.focal_relative
    return [
        (
            replace(camera, focal_px=camera.focal_px * max(1 + focal, 0.1)),
            Pose(pose.heading_deg + heading, pose.pitch_deg + pitch, pose.roll_deg + roll),
        )
        for heading, pitch, roll, focal in draw * scale
    ]


def _in_frame_share(elevation_m, place, eye_m, options, samples):
    """Share of the samples in which cells lie in the frame."""
    east, north = place
    distance = np.maximum(np.hypot(east, north), 1e-3)
    drop = apparent_drop_m(distance, options.refraction_coefficient) if options.curvature else 0.0
    azimuth = np.degrees(np.arctan2(east, north))
    angle = np.degrees(np.arctan2(elevation_m - eye_m - drop, distance))
    inside = sum(in_frame(camera, *project(camera, pose, azimuth, angle)) for camera, pose in samples)
    return (inside / len(samples)).astype(np.float32)
