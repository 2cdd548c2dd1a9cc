"""Assess the answers of a fit: the evidence for and against each one, and the probability that it is right.

`examine` gathers a `Finding`, the quantities that separate right answers from wrong ones; `answers.judge` turns it into
probabilities.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.uncertainty import PoseUncertainty
from .geometry import horizon_rows


@dataclass(frozen=True, eq=False)
class Finding:
    """Answers of a fit and the evidence for and against them.

    Attributes
    ----------
    heading_deg, score : (K,) arrays
        Distinct answers, best first; the scores include priors and inner crests.
    sigma_deg : (K,) array
        Standard deviation of each heading, from the curvature of the score, the DEM and the position [degrees].
    relief_deg : float
        Spread of the horizon inside the frame about a straight line, at the best answer [degrees].
    explained : float
        Share of the columns that the best answer explains.
    residual_px : float
        Median distance of the likeliest rows from the best answer's horizon [pixels of the reduced picture].
    terrain_px : float
        Median tolerance due to the errors of the DEM and the position at the best answer [pixels of the reduced
        picture].
    sureness : float
        Mean over the columns of the probability near each column's likeliest row: how concentrated the evidence is.
    hfov_deg : float
        Horizontal field of view [degrees].
    horizon_cells : float
        Cells of the DEM, at the median distance of the horizon, that lie side by side across the frame.
    """

    heading_deg: np.ndarray
    score: np.ndarray
    sigma_deg: np.ndarray
    relief_deg: float
    explained: float
    residual_px: float = 1.0
    terrain_px: float = 1.0
    sureness: float = 0.5
    hfov_deg: float = 45.0
    horizon_cells: float = np.inf

    @property
    def gap(self):
        """Score of the best answer minus that of the second; 0 if there is no second answer."""
        return float(self.score[0] - self.score[1]) if len(self.score) > 1 else 0.0


def examine(objectives, fits, floor_deg):
    """Gather a `Finding` from distinct trials.

    Parameters
    ----------
    objectives : sequence of Objective
        One for each hypothesis of the eye.
    fits : Fits
    floor_deg : float
        Lower limit of the standard deviation of a heading [degrees].
    """
    objective, trials = objectives[fits.eye[0]], fits.trials
    sigma = np.empty(len(trials))
    for eye in np.unique(fits.eye):
        own = fits.eye == eye
        position = objectives[eye].position_error_m
        sigma[own] = heading_sigma_deg(objectives[eye], trials[own], fits.scale[own], position, floor_deg)
    columns, probability = objective.columns(1), objective.stack.probability
    row, tolerance = (value[0] for value in objective.rows(trials[:1], columns))
    inside = np.isfinite(row) & (row >= 0) & (row <= objective.stack.shape[0] - 1)
    likeliest = probability[:, columns].argmax(axis=0)
    miss = np.abs(likeliest - 0.5 - row)[inside]
    return Finding(
        trials[:, 0],
        fits.score,
        sigma,
        float(np.degrees(relief_px(columns[inside], row[inside]) / objective.camera.focal_px)),
        float(np.mean(explained(objective, trials[:1], columns))),
        float(np.median(miss)) if len(miss) else float(objective.stack.shape[0]),
        float(np.median(tolerance)),
        _sureness(probability[:, columns], likeliest),
        objective.camera.hfov_deg,
        _cells_across(objective, trials[:1]),
    )


def explained(objective, trial, columns):
    """Tell in which columns the skyline in the picture agrees with the horizon of a trial, (C,) bool.

    Parameters
    ----------
    objective : Objective
    trial : (1, 5) array
        See `geometry.PARAMETERS`.
    columns : (C,) int array
    """
    row, tolerance = (value[0] for value in objective.rows(trial, columns))
    return objective.stack.look_up(columns, row, tolerance * 1.5) > np.log(3.0)


def heading_sigma_deg(objective, trials, scale, position_error_m, floor_deg):
    """Standard deviation of each trial's heading [degrees], at most 30.

    The inverse curvature of the score gives the uncertainty that the picture leaves. Two errors shift the whole horizon
    and do not show in the curvature: that of the DEM (c cells) and that of the position, both divided by the distance
    of the terrain. If a trial fits best at a wider tolerance (`scale`), the DEM or the lens is worse here than expected
    by that factor.

    Parameters
    ----------
    objective : Objective
    trials : (K, 5) array
        See `geometry.PARAMETERS`.
    scale : (K,) array
        Multiple of the expected tolerance at which each trial fits best.
    position_error_m : float
        Standard deviation of the position [m].
    floor_deg : float
        Lower limit of the standard deviation of a heading [degrees].
    """
    covariance, terrain, distance = _spreads(objective, trials, scale)
    shift = np.degrees(position_error_m / distance)
    return np.minimum(np.sqrt(covariance[:, 0, 0] + terrain**2 + shift**2 + floor_deg**2), 30.0)


def pose_uncertainty(objective, trial, scale, floor_deg):
    """Uncertainty of the best answer's pitch, roll and focal length; that of its heading is in the `Finding`.

    Parameters
    ----------
    objective : Objective
    trial : (5,) array
        See `geometry.PARAMETERS`.
    scale : float
        Multiple of the expected tolerance at which it fits best.
    floor_deg : float
        Lower limit of the standard deviations of the angles [degrees].

    Returns
    -------
    PoseUncertainty
        The height of the eye, wrong by the slope of the ground times the error of the position, shifts near terrain up
        or down as the pitch does.
    """
    covariance, terrain, distance = (value[0] for value in _spreads(objective, trial[None], np.array([scale])))
    rise = np.degrees(objective.options.ground_slope * objective.position_error_m / distance)
    focal = float(np.sqrt(covariance[3, 3]))
    return PoseUncertainty(
        pitch_deg=min(float(np.sqrt(covariance[1, 1] + terrain**2 + rise**2 + floor_deg**2)), 30.0),
        roll_deg=min(float(np.sqrt(covariance[2, 2] + floor_deg**2)), 30.0),
        focal_relative=min(focal, 0.3),
    )


def _spreads(objective, trials, scale):
    """Covariances (K, F, F) of the free parameters, error of the DEM (K,) [degrees], distance of the terrain (K,) [m].

    Pitch and heading, roll and focal length are the first four parameters and always free.
    """
    _, _, curvature = objective.expand(trials, 1.5 * scale)
    free = np.flatnonzero(objective.free)
    information = curvature[np.ix_(range(len(trials)), free, free)] * objective.options.effective_columns
    covariance = np.linalg.pinv(information + 1e-6 * np.eye(len(free)))
    distance = _median_distance_m(objective, trials)
    terrain = np.degrees(scale * objective.options.terrain_error_cells * objective.curve.cell_m / distance)
    return covariance, terrain, distance


def _median_distance_m(objective, trials):
    """Median distance (K,) of the horizon inside the frame, for each trial [m]."""
    _, azimuth, _ = horizon_rows(objective.curve, objective.camera, trials, objective.columns(4))
    return np.median(objective.curve.distance_m[objective.curve.nearest(azimuth)], axis=1)


def _cells_across(objective, trial):
    distance = float(_median_distance_m(objective, trial)[0])
    return np.radians(objective.camera.hfov_deg) * distance / objective.curve.cell_m


def relief_px(columns, row):
    """Standard deviation of rows about a straight line [pixels]; 0 if there are too few."""
    if len(columns) < 20:
        return 0.0
    return float(np.std(row - np.polyval(np.polyfit(columns, row, 1), columns)))


def _sureness(probability, likeliest, reach_px=2):
    height, width = probability.shape
    columns = np.arange(width)
    near = [probability[np.clip(likeliest + d, 0, height - 1), columns] for d in range(-reach_px, reach_px + 1)]
    return float(np.minimum(np.sum(near, axis=0), 1).mean()) if width else 0.0
