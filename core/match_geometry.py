"""The DEM's horizon seen through many trial cameras at once: one row per picture column and trial.

A trial is a row of parameters (heading, pitch, roll, log focal scale, k1). The column order is `PARAMETERS`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .camera import Pose, project

PARAMETERS = ("heading_deg", "pitch_deg", "roll_deg", "log_focal", "k1")
"""Columns of a (K, 5) array of trials; log_focal is relative to the prior camera, k1 adds to the camera's own."""

FIXED_POINT_STEPS = 4
"""Steps that bring a horizon point onto its column: each leaves about a quarter of the error at 8 degrees of roll."""


class HorizonCurve:
    """A horizon profile prepared for look-ups at any azimuth.

    Parameters
    ----------
    horizon : model.HorizonProfile

    Attributes
    ----------
    elevation_deg, distance_m : (A,) arrays
        With unknown azimuths filled; `known` tells which those were.
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

    def elevation_at(self, azimuth_deg):
        """Elevation angle between the profile's azimuths [degrees]."""
        position = np.mod(azimuth_deg, 360.0) / self.step_deg
        low = position.astype(np.intp)
        fraction = position - low
        size = len(self.elevation_deg)
        low = np.where(low >= size, 0, low)
        return self.elevation_deg[low] * (1 - fraction) + self.elevation_deg[(low + 1) % size] * fraction

    def nearest(self, azimuth_deg):
        """Index of the nearest azimuth of the profile."""
        size = len(self.elevation_deg)
        return np.rint(np.mod(azimuth_deg, 360.0) / self.step_deg).astype(np.intp) % size


def _filled(values, known):
    if known.all():
        return values
    index = np.arange(len(values))
    return np.interp(index, index[known], values[known], period=len(values))


def horizon_rows(curve, camera, trials, columns):
    """Row at which each trial camera sees the horizon in each column.

    Parameters
    ----------
    curve : HorizonCurve
    camera : Camera
        Prior camera of the (reduced) picture.
    trials : (K, 5) array
        See `PARAMETERS`.
    columns : (C,) array
        Pixels.

    Returns
    -------
    row_px : (K, C) array
        NaN where the horizon cannot be brought onto the column (behind the camera).
    azimuth_deg : (K, C) array
        Azimuth of the horizon point that is seen there.
    """
    trials = np.atleast_2d(trials)
    heading, pitch, roll, log_focal, k1 = (column[:, None] for column in trials.T)
    focal = camera.focal_px * np.exp(log_focal)
    centre_x, centre_y = camera.centre_px
    across = (np.asarray(columns, float) - centre_x) / focal
    pose = Pose(heading, pitch, roll)
    plain = replace(camera, k1=0.0, k2=0.0)
    turn = np.arctan(across / np.cos(np.radians(pitch)))
    for step in range(FIXED_POINT_STEPS):
        azimuth = heading + np.degrees(turn)
        x, y = project(plain, pose, azimuth, curve.elevation_at(azimuth))
        x, y = (x - centre_x) / camera.focal_px, (y - centre_y) / camera.focal_px
        gain = _radial_gain(camera, k1, x, y)
        if step < FIXED_POINT_STEPS - 1:
            turn = turn + (across - x * gain) / (1 + np.square(across))
            turn = np.clip(turn, -1.5, 1.5)
    return centre_y + focal * y * gain, azimuth


def _radial_gain(camera, k1, x, y):
    radius2 = x * x + y * y
    return 1 + (camera.k1 + k1) * radius2 + camera.k2 * radius2 * radius2
