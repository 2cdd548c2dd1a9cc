"""Project the DEM's horizon through many trial cameras at once: one row per picture column and trial.

A trial is a vector of five parameters, in the order of `PARAMETERS`. The projection is that of
`core.base.camera.project`, written out so that its derivatives are available. After the turn by heading and pitch, a
horizon point at azimuth a from the axis, with t the tangent of its elevation angle, lies at

    u = sin a / F,  v = (t cos p - cos a sin p) / F,  F = cos a cos p + t sin p,

to the right and up, in focal lengths. The roll rotates (u, v); distortion and focal length scale them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import wrap_360
from ..base.camera import Pose

PARAMETERS = ("heading_deg", "pitch_deg", "roll_deg", "log_focal", "k1")
"""Columns of a (K, 5) array of trials; log_focal is relative to the prior camera, k1 adds to the camera's own."""

NEWTON_STEPS = 3
"""Number of projections that move a horizon point onto its column; the rest is corrected along the tangent."""

LARGEST_SLIP = 0.02
"""A point farther than this from its column after the last step counts as not found [focal lengths]."""

STEEPEST = 10.0
"""Limit on the horizon's slope in the picture, where overhangs and edges make it unbounded."""


def pose_of(trial):
    """Pose of one trial."""
    return Pose(float(wrap_360(trial[0])), float(trial[1]), float(trial[2]))


def lens_of(camera, trial):
    """Camera of one trial, from the prior camera at any scale."""
    return replace(camera, focal_px=float(camera.focal_px * np.exp(trial[3])), k1=float(camera.k1 + trial[4]))


class HorizonCurve:
    """A horizon profile prepared for look-ups at any azimuth.

    Parameters
    ----------
    horizon : HorizonProfile

    Attributes
    ----------
    elevation_deg, distance_m : (A,) arrays
        Values of unknown azimuths are interpolated; `known` is False there.
    clipped : (A,) bool array
        The horizon is a lower bound there.
    """

    def __init__(self, horizon):
        elevation = np.asarray(horizon.elevation_deg, float)
        distance = np.asarray(horizon.distance_m, float)
        self.known = np.isfinite(elevation) & np.isfinite(distance)
        if not self.known.any():
            raise ValueError("a horizon without any known azimuth cannot be matched")
        self.step_deg = 360.0 / len(elevation)
        self.elevation_deg = _filled(elevation, self.known)
        self.distance_m = np.maximum(_filled(distance, self.known), horizon.cell_m)
        self.cell_m = horizon.cell_m
        self.clipped = np.asarray(horizon.clipped, bool) | np.asarray(horizon.void, bool)
        self._tangent = np.tan(np.radians(np.clip(self.elevation_deg, -89.0, 89.0)))
        self._slope = (np.roll(self._tangent, -1) - self._tangent) / np.radians(self.step_deg)

    def tangent_at(self, azimuth_deg):
        """Interpolated tangent of the elevation angle, and its slope per radian of azimuth."""
        position = np.mod(azimuth_deg, 360.0) / self.step_deg
        low = position.astype(np.intp) % len(self._tangent)
        slope = self._slope[low]
        return self._tangent[low] + slope * (np.radians(self.step_deg) * (position - np.floor(position))), slope

    def elevation_at(self, azimuth_deg):
        """Interpolated elevation angle [degrees]."""
        return np.degrees(np.arctan(self.tangent_at(azimuth_deg)[0]))

    def nearest(self, azimuth_deg):
        """Index of the nearest azimuth of the profile."""
        size = len(self.elevation_deg)
        return np.rint(np.mod(azimuth_deg, 360.0) / self.step_deg).astype(np.intp) % size


def _filled(values, known):
    if known.all():
        return values
    index = np.arange(len(values))
    return np.interp(index, index[known], values[known], period=len(values))


@dataclass(frozen=True, eq=False)
class Seen:
    """Points in the image planes of trial cameras; (K, N) arrays.

    Attributes
    ----------
    x, y : right and up of the axis, after roll, before distortion [focal lengths]; NaN behind the camera.
    gain : factor of the distortion.
    along_x, along_y : change of x and y per radian of azimuth, following the tangent's slope.
    heading_x, heading_y, pitch_x, pitch_y : change per radian of the camera's heading and pitch.
    """

    x: np.ndarray
    y: np.ndarray
    gain: np.ndarray
    along_x: np.ndarray
    along_y: np.ndarray
    heading_x: np.ndarray | None = None
    heading_y: np.ndarray | None = None
    pitch_x: np.ndarray | None = None
    pitch_y: np.ndarray | None = None


def see(camera, trials, turn, tangent, slope=0.0, derivatives=False):
    """Project points through trial cameras.

    Parameters
    ----------
    camera : Camera
        Its distortion is used.
    trials : (K, 5) array
        See `PARAMETERS`.
    turn : (K, N) array
        Azimuth to the right of the trials' headings [radians].
    tangent, slope : array
        Tangent of the points' elevation angles, and its change per radian of azimuth.
    derivatives : bool
        Whether to return the derivatives by heading and pitch as well.

    Returns
    -------
    Seen
    """
    pitch, roll = np.radians(trials[:, 1:2]), np.radians(trials[:, 2:3])
    cos_p, sin_p, cos_r, sin_r = np.cos(pitch), np.sin(pitch), np.cos(roll), np.sin(roll)
    sin_a, cos_a = np.sin(turn), np.cos(turn)
    forward = cos_a * cos_p + tangent * sin_p
    forward = np.where(forward > 1e-3, forward, np.nan)
    u, v = sin_a / forward, (tangent * cos_p - cos_a * sin_p) / forward
    stretch = slope * sin_p - sin_a * cos_p
    along_u = (cos_a - u * stretch) / forward
    along_v = (slope * cos_p + sin_a * sin_p - v * stretch) / forward
    radius2 = u * u + v * v
    gain = 1 + (camera.k1 + trials[:, 4:5]) * radius2 + camera.k2 * radius2 * radius2

    def rolled(right, up):
        return right * cos_r - up * sin_r, up * cos_r + right * sin_r

    if not derivatives:
        return Seen(*rolled(u, v), gain, *rolled(along_u, along_v))
    turned = rolled(-(cos_a + u * sin_a * cos_p) / forward, -(sin_a * sin_p + v * sin_a * cos_p) / forward)
    return Seen(*rolled(u, v), gain, *rolled(along_u, along_v), *turned, *rolled(-u * v, -1 - v * v))


def project_trials(camera, trials, azimuth_deg, elevation_deg):
    """Pixels at which each trial camera sees directions.

    Parameters
    ----------
    camera : Camera
        Prior camera of the (reduced) picture.
    trials : (K, 5) array
        See `PARAMETERS`.
    azimuth_deg, elevation_deg : (K, N) or (N,) arrays
        [degrees]

    Returns
    -------
    x_px, y_px : (K, N) arrays
        NaN behind the camera.
    """
    trials = np.atleast_2d(trials)
    turn = np.radians(np.subtract(azimuth_deg, trials[:, :1]))
    seen = see(camera, trials, turn, np.tan(np.radians(elevation_deg)))
    scale = focal_of(camera, trials) * seen.gain
    centre_x, centre_y = camera.centre_px
    return centre_x + scale * seen.x, centre_y - scale * seen.y


def focal_of(camera, trials):
    """Focal length of each trial camera, (K, 1) [pixels].

    The logarithms are copied first: NumPy computes functions such as `exp` with other instructions, and another last
    digit, if the memory between the values of a view reaches into that of the result, which differs from run to run.
    """
    return camera.focal_px * np.exp(np.ascontiguousarray(trials[:, 3:4]))


def horizon_rows(curve, camera, trials, columns, derivatives=False):
    """Row at which each trial camera sees the horizon in each column.

    Parameters
    ----------
    curve : HorizonCurve
    camera : Camera
    trials : (K, 5) array
        See `PARAMETERS`.
    columns : (C,) array
        Pixels.
    derivatives : bool
        Whether to return the derivatives of the rows as well.

    Returns
    -------
    row_px : (K, C) array
        NaN if no point of the horizon lies on the column.
    azimuth_deg : (K, C) array
        Azimuth of the horizon point that is seen there.
    jacobian : (K, C, 5) array or None
        Change of the row at the fixed column, per unit of each parameter.
    """
    trials = np.atleast_2d(trials)
    focal = focal_of(camera, trials)
    across = (np.asarray(columns, float) - camera.centre_px[0]) / focal
    nominal = 1 + np.square(across)
    turn = np.arctan(across / np.cos(np.radians(trials[:, 1:2])))
    for step in range(NEWTON_STEPS):
        azimuth = trials[:, :1] + np.degrees(turn)
        last = step == NEWTON_STEPS - 1
        seen = see(camera, trials, turn, *curve.tangent_at(azimuth), derivatives=derivatives and last)
        miss = across - seen.x * seen.gain
        if not last:
            turn = np.clip(turn + miss / np.maximum(seen.along_x, 0.5 * nominal), -1.5, 1.5)
    slope = np.clip(seen.along_y / np.maximum(seen.along_x, 0.05 * nominal), -STEEPEST, STEEPEST)
    up = seen.y * seen.gain + slope * miss
    row = np.where(np.abs(miss) < LARGEST_SLIP, camera.centre_px[1] - focal * up, np.nan)
    return row, azimuth, _jacobian(seen, slope, focal) if derivatives else None


def _jacobian(seen, slope, focal):
    """Derivative of the row at a fixed column by each parameter: vertical shift minus slope times horizontal shift."""
    scale = -focal * seen.gain
    degree = np.pi / 180
    lift = seen.y - slope * seen.x
    radius2 = np.square(seen.x) + np.square(seen.y)
    return np.stack(
        [
            scale * degree * (seen.heading_y - slope * seen.heading_x),
            scale * degree * (seen.pitch_y - slope * seen.pitch_x),
            scale * degree * (seen.x + slope * seen.y),
            scale * lift,
            -focal * radius2 * lift,
        ],
        axis=2,
    )
