"""Second evidence: what a picture says beside its skyline.

`InnerEvidence` scores the picture below the skyline: its lines against the DEM's crests, its light against the DEM's
slopes.

`SideEvidence` weighs what the sky network sees above and below a trial's horizon. Sky below the horizon contradicts a
trial, more or less: a bank of cloud hides ground, and haze makes it look like sky. Ground above the horizon is common
at the right pose: trees, people, buildings and near slopes are not in the DEM. The skyline's own evidence counts each
column that they fill as a miss, as if the horizon should have been seen there. Both are log-likelihood ratios that
saturate, because neighbouring parts of a picture share their mistakes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .ground import GroundEvidence
from .ridges import RidgeEvidence


class InnerEvidence:
    """Score that the picture below the skyline adds to a trial; 0 if that part or the terrain is unknown.

    Parameters
    ----------
    objective : refine.Objective
    evidence : SkylineEvidence
    inner : InnerTerrain or None
    options : robust.RobustOptions
    """

    def __init__(self, objective, evidence, inner, options):
        self._objective = objective
        self._crests = self._ground = None
        if inner is None:
            return
        if evidence.ridge_score is not None and options.ridges.weight > 0:
            error = options.refine.terrain_error_cells
            cell_m = objective.curve.cell_m
            self._crests = RidgeEvidence(evidence.ridge_score, inner.ridges, cell_m, error, options.ridges)
        if evidence.thumbnail is not None and inner.ground is not None and options.ground.weight > 0:
            self._ground = GroundEvidence(evidence.thumbnail, inner.ground, options.ground)

    def score(self, trials):
        """Addition to the score of each of (K, 5) trials, (K,)."""
        total = np.zeros(len(trials))
        if self._crests is not None:
            rows, _ = self._objective.rows(trials, np.arange(self._objective.stack.shape[1]))
            total += self._crests.score(self._objective.camera, trials, rows)
        if self._ground is not None:
            total += self._ground.score(self._objective.camera, trials)
        return total


@dataclass(frozen=True)
class SideOptions:
    """Weights of the two sides, fitted on simulated pictures by a conditional logit over the answers to each.

    Attributes
    ----------
    ground_above : float
        Limit of the log-likelihood ratio in favour of a trial that has ground above its horizon; 0 switches it off.
    sky_below : float
        Limit of the log-likelihood ratio against a trial that has sky below its horizon; 0 switches it off.
    half_share : float
        Share of the picture at which half of a limit is reached.
    clearance : float
        Only what is farther from the horizon than this many tolerances counts.
    least_tolerance_px : float
        Smallest tolerance used for this [pixels of the reduced picture].
    """

    ground_above: float = 2.87
    sky_below: float = 1.48
    half_share: float = 0.02
    clearance: float = 2.0
    least_tolerance_px: float = 2.0


class SideEvidence:
    """Log-likelihood of trials from what lies above and below their horizons.

    Parameters
    ----------
    objective : refine.Objective
    sky : (h, w) array or None
        Probability of sky, as in `SkylineEvidence.sky_map`, NaN where it is unknown; None says nothing.
    options : SideOptions
    """

    def __init__(self, objective, sky, options=SideOptions()):  # noqa: B008 - frozen
        self._objective, self.options = objective, options
        height, width = objective.stack.shape
        sky = np.full((1, 1), np.nan) if sky is None else sky
        self._rows_per_px = sky.shape[0] / height
        self._columns = ((np.arange(sky.shape[1]) + 0.5) * width / sky.shape[1]).astype(int)
        known = np.isfinite(sky)
        self._sky_from_top, self._ground_from_top = (
            np.vstack([np.zeros(sky.shape[1]), np.where(known, part, 0.0).cumsum(axis=0)]) for part in (sky, 1 - sky)
        )
        self._known = known.sum(axis=0)

    def score(self, trials):
        """Log-likelihood of each of (K, 5) trials, (K,), but for a constant of the picture."""
        above, below = self.saturated(trials)
        return self.options.ground_above * above - self.options.sky_below * below

    def saturated(self, trials):
        """Measure how much lies on the wrong side.

        Parameters
        ----------
        trials : (K, 5) array
            See `geometry.PARAMETERS`.

        Returns
        -------
        ground_above, sky_below : (K,) arrays
            a / (a + `half_share`) with a the share of the picture [1].
        """
        row, tolerance = self._objective.rows(trials, self._columns)
        reach = self.options.clearance * np.maximum(tolerance, self.options.least_tolerance_px)
        seen = np.isfinite(row)
        area = np.maximum((seen * self._known).sum(axis=1), 1)
        above = np.where(seen, self._until(self._ground_from_top, row - reach), 0.0)
        below = np.where(seen, self._sky_from_top[-1] - self._until(self._sky_from_top, row + reach), 0.0)
        shares = (side.sum(axis=1) / area for side in (above, below))
        return tuple(share / (share + self.options.half_share) for share in shares)

    def _until(self, from_top, row_px):
        """Sum of a column from its top to a row of the reduced picture, in rows of the map."""
        last = len(from_top) - 1
        place = np.clip((np.nan_to_num(row_px) + 0.5) * self._rows_per_px, 0, last)
        first = np.minimum(place.astype(int), last - 1)
        column = np.arange(from_top.shape[1])
        upper, lower = from_top[first, column], from_top[first + 1, column]
        return upper + (place - first) * (lower - upper)
