"""How well could a photograph from a place be oriented, by direction and field of view, judged from the DEM alone?

A stretch of the horizon as wide as the field of view is compared with the horizon in every other direction, after the
best shift and tilt, since pitch and roll are not known. If some other stretch is alike within the tolerance that the
errors of DEM and position ask for, a matcher cannot tell the two apart. The tolerance is wide for near terrain.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

TABLE_PATH = Path(__file__).with_name("orientability.json")

SAME_DEG = 3.0
"""Directions nearer than this to the true one are the same answer [degrees]."""

LARGEST_ERROR_DEG = 30.0


@dataclass(frozen=True)
class UniqueOptions:
    """Errors that are expected.

    Attributes
    ----------
    step_deg : float
        Step of the directions [degrees].
    angle_deg : float
        Error of the skyline in the picture and of the lens [degrees].
    terrain_error_cells : float
        Error of the horizon's height in cells of the DEM.
    position_error_m : float
        Standard deviation of the position [m].
    ground_slope : float
        Height by which a metre of position raises or lowers near terrain [1].
    cap : float
        Largest misfit of one azimuth that counts [standard deviations].
    effective_columns : float
        Number of independent groups of columns in a picture.
    floor_deg : float
        Error of a heading that remains in any case [degrees].
    """

    step_deg: float = 1.0
    angle_deg: float = 0.15
    terrain_error_cells: float = 0.25
    position_error_m: float = 8.0
    ground_slope: float = 0.5
    cap: float = 3.0
    effective_columns: float = 15.0
    floor_deg: float = 0.1


@dataclass(frozen=True, eq=False)
class Orientability:
    """Prediction for every direction of one place and field of view.

    Attributes
    ----------
    heading_deg : (H,) array
        Clockwise from true north [degrees].
    probability : (H,) array
        That a photograph with a good skyline is oriented uniquely; NaN where the horizon is not known.
    error_deg : (H,) array
        Expected error of its heading if it is [degrees].
    relief_deg : (H,) array
        Spread of the horizon in the frame about a straight line [degrees].
    """

    heading_deg: np.ndarray
    probability: np.ndarray
    error_deg: np.ndarray
    relief_deg: np.ndarray

    @property
    def mean(self):
        """Mean probability over the directions that are known."""
        known = np.isfinite(self.probability)
        return float(self.probability[known].mean()) if known.any() else float("nan")

    @property
    def typical_error_deg(self):
        """Median of the expected errors [degrees]."""
        known = np.isfinite(self.error_deg)
        return float(np.median(self.error_deg[known])) if known.any() else float("nan")

    def towards(self, azimuth_deg, width_deg=45.0):
        """Mean probability of the directions within half a width of an azimuth [degrees]."""
        away = np.abs((self.heading_deg - azimuth_deg + 180) % 360 - 180)
        near = (away <= width_deg / 2) & np.isfinite(self.probability)
        return float(self.probability[near].mean()) if near.any() else float("nan")


@lru_cache(maxsize=1)
def table():
    """Read the shipped weights: from the ambiguity, the relief and the field of view to a probability."""
    return json.loads(TABLE_PATH.read_text(encoding="utf-8"))


def orientability(elevation_deg, distance_m, hfov_deg, cell_m, options=UniqueOptions()):  # noqa: B008 - frozen
    """Predict for all directions of a place how well a photograph could be oriented.

    Parameters
    ----------
    elevation_deg, distance_m : (A,) arrays
        Horizon at regular azimuths from north; NaN where unknown.
    hfov_deg : float
        Horizontal field of view [degrees].
    cell_m : float
        Size of the DEM's cells [m].
    options : UniqueOptions

    Returns
    -------
    Orientability
    """
    ambiguity, error, relief, heading = ambiguities(elevation_deg, distance_m, hfov_deg, cell_m, options)
    return Orientability(heading, probability_of(ambiguity, relief, hfov_deg), error, relief)


# parameters: a horizon, a lens, a DEM
def ambiguities(elevation_deg, distance_m, hfov_deg, cell_m, options=UniqueOptions()):  # noqa: B008 - frozen
    """Weight of all other directions against each, its expected error and relief, and the directions; (H,) arrays.

    Parameters
    ----------
    elevation_deg, distance_m, hfov_deg, cell_m, options
        As for `orientability`.
    """
    count = int(round(360 / options.step_deg))
    at = np.rint(np.arange(count) * len(elevation_deg) / count).astype(int) % len(elevation_deg)
    angle, distance = np.asarray(elevation_deg, float)[at], np.asarray(distance_m, float)[at]
    known = np.isfinite(angle) & np.isfinite(distance)
    distance = np.where(known, np.maximum(distance, cell_m), 1e5)
    angle = np.where(known, angle, 0.0)
    lift_m = np.hypot(options.terrain_error_cells * cell_m, options.ground_slope * options.position_error_m)
    sigma = np.hypot(options.angle_deg, np.degrees(lift_m / distance))
    reach = max(int(round(hfov_deg / 2 / options.step_deg)), 2)
    offset = np.arange(-reach, reach + 1)
    around = (np.arange(count)[:, None] + offset) % count
    windows, weights = angle[around], np.where(known[around], 1 / sigma[around], 0.0)
    slope = (np.roll(angle, -1) - np.roll(angle, 1)) / (2 * options.step_deg)
    ambiguity, error, relief = np.full(count, np.nan), np.full(count, np.nan), np.full(count, np.nan)
    other_deg = np.abs((np.arange(count) * options.step_deg + 180) % 360 - 180)
    for first in np.flatnonzero((weights > 0).mean(axis=1) > 0.8):
        weight = weights[first]
        basis = np.linalg.qr(np.column_stack([weight, weight * offset]))[0]
        misfit = weight * (windows - windows[first])
        misfit -= (misfit @ basis) @ basis.T
        mean = np.minimum(np.square(misfit), options.cap**2).mean(axis=1)
        likelihood = np.exp(-0.5 * options.effective_columns * mean)
        # Neighbouring directions fit together; only the best of each group is an answer of its own.
        peak = (mean <= np.roll(mean, 1)) & (mean <= np.roll(mean, -1))
        away = np.roll(other_deg, first) > SAME_DEG
        ambiguity[first] = likelihood[peak & away].sum()
        steep = weight * slope[around[first]]
        steep = steep - basis @ (basis.T @ steep)
        information = options.effective_columns * np.mean(np.square(steep))
        far_m = float(np.median(distance[around[first]]))
        shift_deg = np.degrees(np.hypot(options.position_error_m, options.terrain_error_cells * cell_m) / far_m)
        error[first] = min(np.sqrt(1 / max(information, 1e-6) + shift_deg**2 + options.floor_deg**2), LARGEST_ERROR_DEG)
        line = np.polyval(np.polyfit(offset, windows[first], 1), offset)
        relief[first] = float(np.std(windows[first] - line))
    return ambiguity, error, relief, np.arange(count) * options.step_deg


def probability_of(ambiguity, relief_deg, hfov_deg, weights=None):
    """Probability of a unique answer.

    Parameters
    ----------
    ambiguity, relief_deg : arrays
        From `ambiguities`.
    hfov_deg : float
        Horizontal field of view [degrees].
    weights : mapping or None
        None takes the shipped ones.
    """
    weights = weights or table()
    total = (
        weights["bias"]
        + weights["log_unique"] * np.log(1 / (1 + np.asarray(ambiguity)))
        + weights["log_relief"] * np.log(np.maximum(relief_deg, 0.02))
        + weights["log_hfov"] * np.log(np.asarray(hfov_deg, float))
    )
    return 1 / (1 + np.exp(-total))
