"""Refine many candidates at once by damped Newton steps on the robust evidence.

The candidates are the rows of one array and move together; each has its own damping. The score of a trial is

    S = mean over columns of B(column, row(trial); s) - L * (penalties on roll, focal length, distortion),

with s^2 = k^2 ((pixel error)^2 + (c * cell / distance * focal)^2) + (slope * position error / distance * focal)^2:
the error of the DEM at the distance of the horizon point, times a scale k that is chosen for each candidate, and the
effect of an error of the eye's position on near ground, which a good fit elsewhere does not reduce.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.progress import SILENT, checkpoint
from .geometry import focal_of, horizon_rows, project_trials
from .prior import EFFECTIVE_COLUMNS, RollPrior

LANDMARK_PROBE = np.array([0.05, 0.05, 0.1, 0.002, 0.01])
"""Steps of the numerical derivatives of landmarks, in the order of `geometry.PARAMETERS`."""

CLIPPED_FACTOR = 2.0
"""Factor on the tolerance of the horizon where the DEM ends too early or has voids."""

LARGEST_MISS = 300.0
"""Cap on a landmark's miss [standard deviations]; also the miss of a landmark behind the camera."""


@dataclass(frozen=True)
class RefineOptions:
    """Weights of the fit.

    Attributes
    ----------
    terrain_error_cells : float
        c above: error of the horizon's height in cells; 0.25 is the median of clean photographs over 90 to 100 m
        DEMs.
    pixel_error_px : float
        Error of the evidence itself [pixels of the reduced picture].
    error_scales : tuple of float
        k above: the values from which the best is chosen for each candidate.
    effective_columns : float
        Number of independent column groups: 1 / L.
    roll : RollPrior
    k1_sigma : float
        Spread of the Gaussian prior on k1; 0 holds it at the camera's own value.
    ground_slope : float
        Rise of the ground per metre, which shifts a crest up or down if the eye is displaced.
    iterations : int
        Largest number of steps of a fit at one tolerance.
    """

    terrain_error_cells: float = 0.25
    pixel_error_px: float = 2.0
    error_scales: tuple = (0.05, 0.15, 0.35, 0.7, 1.0, 1.5, 2.0, 3.0)
    effective_columns: float = EFFECTIVE_COLUMNS
    roll: RollPrior = RollPrior()
    k1_sigma: float = 0.0
    ground_slope: float = 0.5
    iterations: int = 8

    def __post_init__(self):
        if not (self.terrain_error_cells > 0 and self.pixel_error_px > 0 and self.effective_columns > 0):
            raise ValueError("errors and the number of effective columns must be positive")
        if not self.ground_slope >= 0:
            raise ValueError(f"the ground's slope must be 0 or more, not {self.ground_slope}")


class Objective:
    """Score of trials against one photograph's evidence.

    Parameters
    ----------
    stack : EvidenceStack
    prior : CameraPrior
        Camera of the reduced picture and the relative spread of its focal length.
    curve : HorizonCurve
    options : RefineOptions
    landmarks : sequence of Landmark, optional
        In pixels of the reduced picture.
    position_error_m : float
        Standard deviation of the eye's position [m].
    """

    def __init__(self, stack, prior, curve, options=RefineOptions(), landmarks=(), position_error_m=0.0):  # noqa: B008
        self.stack, self.camera, self.curve = stack, prior.camera, curve
        self.options, self.landmarks = options, tuple(landmarks)
        self.position_error_m = position_error_m
        self.sigma = np.array([np.inf, np.inf, np.inf, prior.focal_sigma, options.k1_sigma])
        self.free = self.sigma > 0
        self._eye_error_m = options.ground_slope * position_error_m
        place = [(m.azimuth_deg, m.elevation_deg, m.x_px, m.y_px, m.sigma_px) for m in self.landmarks]
        self._landmark = np.array(place, float).reshape(-1, 5).T

    def columns(self, stride):
        """Every `stride`-th column of the picture that has evidence."""
        return self.stack.informative[stride // 2 :: stride]

    def rows(self, trials, columns, scale=1.0):
        """Rows of the horizon and their tolerances.

        Parameters
        ----------
        trials : (K, 5) array
            See `geometry.PARAMETERS`.
        columns : (C,) int array
        scale : float or (K,) array
            k above: multiple of the expected tolerance.

        Returns
        -------
        row_px, tolerance_px : (K, C) arrays
            [pixels of the reduced picture]; rows are NaN where the horizon is unknown or not in the column.
        """
        row, azimuth, _ = horizon_rows(self.curve, self.camera, trials, columns)
        return self._known_rows(trials, row, azimuth, scale)

    def _known_rows(self, trials, row, azimuth, scale):
        nearest = self.curve.nearest(azimuth)
        px_per_metre = focal_of(self.camera, trials) / self.curve.distance_m[nearest]
        terrain = self.options.terrain_error_cells * self.curve.cell_m * px_per_metre
        clipped = np.where(self.curve.clipped[nearest], CLIPPED_FACTOR, 1.0)
        scaled = np.reshape(scale, (-1, 1)) * clipped * np.hypot(self.options.pixel_error_px, terrain)
        row = np.where(self.curve.known[nearest], row, np.nan)
        return row, np.hypot(scaled, self._eye_error_m * px_per_metre)

    def score(self, trials, scale, stride=1):
        """Penalised scores of trials.

        Parameters
        ----------
        trials : (K, 5) array
            See `geometry.PARAMETERS`.
        scale : float or (K,) array
            k above: multiple of the expected tolerance.
        stride : int
            Only every `stride`-th column is used.

        Returns
        -------
        (K,) array
        """
        columns = self.columns(stride)
        row, tolerance = self.rows(trials, columns, scale)
        value = self.stack.look_up(columns, row, tolerance)
        return value.mean(axis=1) - self._penalty(trials)

    def expand(self, trials, scale, stride=1):
        """Penalised scores of trials, with their derivatives.

        Parameters
        ----------
        trials, scale, stride
            As for `score`.

        Returns
        -------
        score : (K,) array
        gradient : (K, 5) array
        curvature : (K, 5, 5) array
            Of the negative score, so that it is positive.
        """
        columns = self.columns(stride)
        row, azimuth, jacobian = horizon_rows(self.curve, self.camera, trials, columns, derivatives=True)
        row, tolerance = self._known_rows(trials, row, azimuth, scale)
        value = self.stack.look_up(columns, row, tolerance)
        reach = 0.5 * tolerance
        slope = self.stack.look_up(columns, row + reach, tolerance) - self.stack.look_up(
            columns, row - reach, tolerance
        )
        usable = np.isfinite(row) & (value > 0)
        jacobian[~usable] = 0.0
        slope = np.where(usable, slope / (2 * reach), 0.0)
        # Share of the column that the horizon explains: only columns that it explains constrain the fit.
        weight = np.where(usable, (1 - np.exp(-np.maximum(value, 0))) / (np.square(tolerance) + 1), 0.0)
        gradient = np.einsum("kc,kcj->kj", slope, jacobian) / len(columns)
        curvature = np.matmul(jacobian.transpose(0, 2, 1), weight[..., None] * jacobian) / len(columns)
        pull, stiffness = self._penalty_derivatives(trials)
        return value.mean(axis=1) - self._penalty(trials), gradient - pull, curvature + stiffness

    def landmark_residual(self, trials):
        """Misses of the landmarks, in their standard deviations: (K, 2 M)."""
        azimuth, elevation, x, y, sigma = self._landmark
        seen_x, seen_y = project_trials(self.camera, trials, azimuth, elevation)
        miss = np.concatenate([(seen_x - x) / sigma, (seen_y - y) / sigma], axis=1)
        return np.nan_to_num(np.clip(miss, -LARGEST_MISS, LARGEST_MISS), nan=LARGEST_MISS)

    def _penalty(self, trials):
        total = self.options.roll.cost(trials[:, 2])
        for parameter in (3, 4):
            if self.free[parameter]:
                total = total + 0.5 * np.square(trials[:, parameter] / self.sigma[parameter])
        if self.landmarks:
            total = total + 0.5 * np.square(self.landmark_residual(trials)).sum(axis=1)
        return total / self.options.effective_columns

    def _penalty_derivatives(self, trials):
        pull, stiffness = np.zeros_like(trials), np.zeros((len(trials), 5, 5))
        stiffness[:, 2, 2] = self.options.roll.stiffness(trials[:, 2])
        pull[:, 2] = trials[:, 2] * stiffness[:, 2, 2]
        for parameter in (3, 4):
            if self.free[parameter]:
                pull[:, parameter] = trials[:, parameter] / self.sigma[parameter] ** 2
                stiffness[:, parameter, parameter] = 1 / self.sigma[parameter] ** 2
        if self.landmarks:
            more_pull, more_stiffness = self._landmark_derivatives(trials)
            pull, stiffness = pull + more_pull, stiffness + more_stiffness
        return pull / self.options.effective_columns, stiffness / self.options.effective_columns

    def _landmark_derivatives(self, trials):
        miss = self.landmark_residual(trials)
        jacobian = np.zeros((*miss.shape, len(LANDMARK_PROBE)))
        for parameter in np.flatnonzero(self.free):
            moved = trials.copy()
            moved[:, parameter] += LANDMARK_PROBE[parameter]
            jacobian[..., parameter] = (self.landmark_residual(moved) - miss) / LANDMARK_PROBE[parameter]
        return np.einsum("km,kmj->kj", miss, jacobian), np.einsum("kmi,kmj->kij", jacobian, jacobian)


def refine(objective, trials, scale, stride=1, progress=SILENT):
    """Climb from every trial to a maximum of its score at one tolerance scale.

    Parameters
    ----------
    objective : Objective
    trials : (K, 5) array
        See `geometry.PARAMETERS`; the given array is not changed.
    scale : float or (K,) array
        Multiple of the expected tolerance.
    stride : int
        Only every `stride`-th column is used.
    progress : Progress

    Returns
    -------
    trials : (K, 5) array
    score : (K,) array
    """
    trials = np.array(trials, float)
    score, gradient, curvature = objective.expand(trials, scale, stride)
    # The curvature counts every explained column in full and is about twice too large: start below it.
    stiffness = np.full(len(trials), 0.5)
    free = np.flatnonzero(objective.free)
    iterations = objective.options.iterations
    for iteration in range(iterations):
        checkpoint(progress, iteration / iterations)
        moved = trials + _bounded(_newton(gradient, curvature * stiffness[:, None, None], free))
        expanded = objective.expand(moved, scale, stride)
        gain = expanded[0] > score
        trials[gain] = moved[gain]
        score, gradient, curvature = (
            np.where(gain.reshape(-1, *[1] * (new.ndim - 1)), new, old)
            for new, old in zip(expanded, (score, gradient, curvature))
        )
        stiffness = np.clip(np.where(gain, stiffness * 0.6, stiffness * 4), 0.15, 1e4)
        if (stiffness > 100).all():
            break
    return trials, score


def _newton(gradient, curvature, free):
    """Newton steps (K, 5) up the gradient; parameters that are not free do not move."""
    step = np.zeros_like(gradient)
    matrix = curvature[np.ix_(range(len(gradient)), free, free)]
    matrix = matrix + 1e-9 * np.eye(len(free))
    step[:, free] = np.linalg.solve(matrix, gradient[:, free][..., None])[..., 0]
    return step


def _bounded(move):
    """Shorten steps that leave the neighbourhood in which the derivatives are valid."""
    limit = np.array([1.5, 1.5, 2.0, 0.02, 0.05])
    excess = np.max(np.abs(move) / limit, axis=1, keepdims=True)
    return move / np.maximum(excess, 1.0)
