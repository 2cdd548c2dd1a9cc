"""Score the picture below the skyline: its lines against the DEM's crests, its light against the DEM's slopes."""

from __future__ import annotations

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

    def __bool__(self):
        """Whether any inner evidence is available."""
        return self._crests is not None or self._ground is not None

    def score(self, trials):
        """Addition to the score of each of (K, 5) trials, (K,)."""
        total = np.zeros(len(trials))
        if self._crests is not None:
            rows, _ = self._objective.rows(trials, np.arange(self._objective.stack.shape[1]))
            total += self._crests.score(self._objective.camera, trials, rows)
        if self._ground is not None:
            total += self._ground.score(self._objective.camera, trials)
        return total
