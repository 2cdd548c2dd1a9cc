"""Second evidence: what a picture says beside its skyline.

`InnerEvidence` scores the picture below the skyline: its lines against the DEM's crests, its light against the DEM's
slopes.

`ForegroundEvidence` weighs ground that the sky network sees above a trial's horizon. It is common at the right pose:
trees, people, buildings and near slopes are not in the DEM. The skyline's own evidence counts each column that they
fill as a miss, as if the horizon should have been seen there. The log-likelihood ratio saturates, because neighbouring
parts of a picture share their mistakes.
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
class ForegroundOptions:
    """Weight of the ground above the horizon, which `tools/fit_foreground.py` fits on simulated pictures.

    The other numbers are choices: half shares of 1 and 5 % served photographs and views as well as 2 %.

    Attributes
    ----------
    limit : float
        Largest log-likelihood ratio in favour of a trial with ground above its horizon; 0 switches it off.
    half_share : float
        Share of the picture at which half of the limit is reached.
    clearance : float
        Only what is farther above the horizon than this many tolerances counts.
    least_tolerance_px : float
        Smallest tolerance used for this [pixels of the reduced picture].
    """

    limit: float = 2.15
    half_share: float = 0.02
    clearance: float = 2.0
    least_tolerance_px: float = 2.0


class ForegroundEvidence:
    """Log-likelihood of trials from the ground above their horizons.

    Parameters
    ----------
    objective : refine.Objective
    sky : (h, w) array or None
        Probability of sky, as in `SkylineEvidence.sky_map`, NaN where it is unknown; None says nothing.
    options : ForegroundOptions
    """

    def __init__(self, objective, sky, options=ForegroundOptions()):  # noqa: B008 - frozen
        self._objective, self.options = objective, options
        height, width = objective.stack.shape
        sky = np.full((1, 1), np.nan) if sky is None else sky
        self._rows_per_px = sky.shape[0] / height
        self._columns = ((np.arange(sky.shape[1]) + 0.5) * width / sky.shape[1]).astype(int)
        known = np.isfinite(sky)
        from_top = np.where(known, 1 - sky, 0.0).cumsum(axis=0)
        self._from_top, self._known = np.vstack([np.zeros(sky.shape[1]), from_top]), known.sum(axis=0)

    def score(self, trials):
        """Log-likelihood of each of (K, 5) trials, (K,), but for a constant of the picture."""
        return self.options.limit * self.saturated(trials)

    def saturated(self, trials):
        """Measure how much ground lies above the horizon.

        Parameters
        ----------
        trials : (K, 5) array
            See `geometry.PARAMETERS`.

        Returns
        -------
        (K,) array
            a / (a + `half_share`) with a the share of the picture [1].
        """
        row, tolerance = self._objective.rows(trials, self._columns)
        seen = np.isfinite(row)
        row = row - self.options.clearance * np.maximum(tolerance, self.options.least_tolerance_px)
        above = np.where(seen, self._until(row), 0.0).sum(axis=1)
        share = above / np.maximum((seen * self._known).sum(axis=1), 1)
        return share / (share + self.options.half_share)

    def _until(self, row_px):
        """Ground of each column from its top to a row of the reduced picture, in rows of the map."""
        last = len(self._from_top) - 1
        place = np.clip((np.nan_to_num(row_px) + 0.5) * self._rows_per_px, 0, last)
        first = np.minimum(place.astype(int), last - 1)
        column = np.arange(self._from_top.shape[1])
        upper, lower = self._from_top[first, column], self._from_top[first + 1, column]
        return upper + (place - first) * (lower - upper)
