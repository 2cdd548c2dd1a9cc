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


LARGEST_SLIP_PX = 1.0
"""A point that is farther than this from its column after the last step was not found."""


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
    heading, pitch, roll, log_focal, k1 = (column[:, None] for column in np.atleast_2d(trials).T)
    plain = replace(camera, k1=0.0, k2=0.0)
    centre_x, centre_y = camera.centre_px
    x, y = project(plain, Pose(heading, pitch, roll), azimuth_deg, elevation_deg)
    x, y = (x - centre_x) / camera.focal_px, (y - centre_y) / camera.focal_px
    radius2 = x * x + y * y
    gain = 1 + (camera.k1 + k1) * radius2 + camera.k2 * radius2 * radius2
    focal = camera.focal_px * np.exp(log_focal)
    return centre_x + focal * gain * x, centre_y + focal * gain * y


def horizon_rows(curve, camera, trials, columns):
    """Row at which each trial camera sees the horizon in each column.

    Parameters
    ----------
    curve : HorizonCurve
    camera : Camera
    trials : (K, 5) array
        See `PARAMETERS`.
    columns : (C,) array
        Pixels.

    Returns
    -------
    row_px : (K, C) array
        NaN where no point of the horizon comes to lie on the column.
    azimuth_deg : (K, C) array
        Azimuth of the horizon point that is seen there.
    """
    trials = np.atleast_2d(trials)
    columns = np.asarray(columns, float)
    focal = camera.focal_px * np.exp(trials[:, 3:4])
    across = (columns - camera.centre_px[0]) / focal
    turn = np.arctan(across / np.cos(np.radians(trials[:, 1:2])))
    for step in range(FIXED_POINT_STEPS):
        azimuth = trials[:, :1] + np.degrees(turn)
        x, y = project_trials(camera, trials, azimuth, curve.elevation_at(azimuth))
        if step < FIXED_POINT_STEPS - 1:
            turn = np.clip(turn + (columns - x) / focal / (1 + np.square(across)), -1.5, 1.5)
    return np.where(np.abs(x - columns) < LARGEST_SLIP_PX, y, np.nan), azimuth
