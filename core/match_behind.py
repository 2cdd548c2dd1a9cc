"""A second look, behind the most striking line of a picture: is that line a crest before farther terrain?

The edge of a dark plain or of a near wood stands out far more than a pale range behind it, so that the extraction
takes it for the skyline. No rule on pixels tells such a range from a bank of cloud; the DEM does: at the right
heading it shows a crest just where the striking line runs. A match with the fainter line is taken where that is so.
"""

from __future__ import annotations

import numpy as np

from .match_evidence import EDGE_ROW
from .match_geometry import project_trials

LEAST_SHARE = 0.6
"""Share of the columns in which a crest must lie on the striking line; wrong headings reach 0.4, mostly 0.1."""

REACH_PX = 4
"""Crest and line may lie this far apart [pixels of the reduced picture]."""


def crest_share(objective, trial, evidence, edges):
    """Share of the columns with a fainter line above in which a crest of the DEM lies on the striking one.

    Parameters
    ----------
    objective : match_refine.Objective
        For its camera.
    trial : (5,) array
        Of the match with `evidence.rival`.
    evidence : model.SkylineEvidence
        With a rival.
    edges : ridges.RidgeEdges
    """
    line = np.asarray(evidence.best.row_px, float) - EDGE_ROW
    doubled = np.abs(np.asarray(evidence.rival.best.row_px, float) - EDGE_ROW - line) > REACH_PX
    if not doubled.any():
        return 0.0
    x, y = (value[0] for value in project_trials(objective.camera, trial, edges.azimuth_deg, edges.elevation_deg))
    with np.errstate(invalid="ignore"):
        shown = (x > -0.5) & (x < len(line) - 0.5)
    column = np.rint(x[shown]).astype(int)
    met = np.zeros(len(line))
    met[column[np.abs(y[shown] - line[column]) <= REACH_PX]] = 1
    # Crests are points, about as dense as the columns: a neighbour's serves too.
    met = np.convolve(met, np.ones(3), "same") > 0
    return float(met[doubled].mean())
