"""Place a line of whole rows on the edge that it follows, to a fraction of a row.

Lens, sharpening and compression spread the step from sky to terrain over several rows. The score of a row finds this
ramp but prefers its upper end, since some features count the rest of the ramp as clutter above the boundary. The line
is moved in two steps: to the ramp's centre of gravity, then to the row that parts the ramp into the same areas of sky
and terrain (Tabatabai and Mitchell 1984, doi 10.1109/TPAMI.1984.4767502). For a symmetric blur that fits into these
rows, both are the place of the step.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter1d

from .appearance import EDGE_SIGMAS_PX

CENTRE_REACH_PX = 2
"""Distance from the line within which the centre of gravity is sought; farther down, the texture of the terrain would
draw the line into the ground [rows]."""

AREA_REACH_PX = 4
"""Distance from the centre within which the areas of sky and terrain are compared [rows]."""

LEVEL_ROWS = 3
"""Number of outermost rows on each side whose mean colour counts as pure sky or pure terrain."""

SMOOTHING_PX = 2.0
"""Standard deviation of the weighted mean along the columns, which share the pixels of one blurred edge [columns]."""

LARGEST_STEP_PX = 8
"""The mean does not extend across a larger step between neighbouring columns, where another ridge or a tree begins
[rows]."""


def placed_between_rows(line, appearance):
    """Place a line between the rows; `docs/sky-model.md` gives the reasons for the constants.

    Parameters
    ----------
    line : (W,) int array
        Row per column; row y is the boundary between y - 1 and y.
    appearance : Appearance
        Of the reduced picture, (H, W).

    Returns
    -------
    (W,) float array
        Row per column [rows].
    """
    centre = centre_of_edge(line, appearance.edges[EDGE_SIGMAS_PX[0]])
    placed = row_of_equal_areas(centre, appearance.lab)
    parts = np.split(placed, np.flatnonzero(np.abs(np.diff(line)) > LARGEST_STEP_PX) + 1)
    return np.concatenate([gaussian_filter1d(part, SMOOTHING_PX, mode="nearest") for part in parts])


def centre_of_edge(line, edge, reach_px=CENTRE_REACH_PX):
    """Centre of gravity of the edge within reach of a line.

    The weakest edge within reach is taken for the texture's own and subtracted.

    Parameters
    ----------
    line : (W,) int array
        Row per column.
    edge : (H, W) array
        Strength of the edge at the boundary between each row and the one above it, not negative.
    reach_px : int
        Rows on each side that are looked at.

    Returns
    -------
    (W,) float array
        `line` itself where no edge is within reach.
    """
    steps = np.arange(-reach_px, reach_px + 1)[:, None]
    rows = line + steps
    inside = (rows >= 1) & (rows < len(edge))
    near = edge[np.clip(rows, 0, len(edge) - 1), np.arange(edge.shape[1])].astype(float)
    weight = np.where(inside, near - np.where(inside, near, np.inf).min(0), 0)
    total = weight.sum(0)
    return line + (weight * steps).sum(0) / np.where(total > 0, total, 1)


def row_of_equal_areas(line, lab):
    """Row of the sharp step that holds the same areas of sky and of terrain as the ramp around a line.

    Parameters
    ----------
    line : (W,) array
        Row per column.
    lab : (H, W, 3) array
        Colours in which distances are meaningful.

    Returns
    -------
    (W,) float array
        `line` itself where sky and terrain have the same colour, or the rows reach beyond the picture.
    """
    first = np.rint(line).astype(int)
    rows = first + np.arange(-AREA_REACH_PX, AREA_REACH_PX)[:, None]
    colour = lab[np.clip(rows, 0, len(lab) - 1), np.arange(lab.shape[1])].astype(float)
    sky, terrain = colour[:LEVEL_ROWS].mean(0), colour[-LEVEL_ROWS:].mean(0)
    contrast = terrain - sky
    square = (contrast**2).sum(-1)
    share = ((colour - sky) * contrast).sum(-1) / np.where(square > 0, square, 1)
    row = first + AREA_REACH_PX - np.clip(share, 0, 1).sum(0)
    inside = (rows[0] >= 0) & (rows[-1] < len(lab))
    return np.where(inside & (square > 0), row, line)
