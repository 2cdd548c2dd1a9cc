"""Rivers and rockfall: one step of erosion of a landscape.

Drainage over pits follows the minimum spanning tree, and sums along the tree are computed by pointer doubling, so that
no step needs a loop over cells.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order, minimum_spanning_tree

UPLIFT_M = 60.0
"""Uplift per step [m]."""
EROSION_M = 0.45
"""Constant of the stream-power law (m = 0.5, n = 1): erosion per step at unit slope, per metre of the square root of
area."""
HILLSLOPE_M = 600.0
"""Below a drainage area of this squared, rivers have not formed and slopes stay about even [m]."""


def wear(height, uplift, softness, cell_m, repose):
    """Compute one step: uplift, implicit stream power along the drainage tree, rockfall beyond the angle of repose.

    Parameters
    ----------
    height, uplift, softness : (N, M) arrays
        Elevations [m]; uplift and erodibility, both about 1.
    cell_m : float
        Side of a cell [m].
    repose : float
        Steepest stable slope, as a tangent.

    References
    ----------
    .. [1] Braun, J., Willett, S. D., A very efficient O(n), implicit and parallel method to solve the stream power
       equation, Geomorphology 180-181, 2013, doi:10.1016/j.geomorph.2012.10.008.
    """
    receiver, length = drainage(height)
    area = _accumulate(receiver) * cell_m**2
    factor = EROSION_M * softness.ravel() * np.sqrt(area + HILLSLOPE_M**2) / (length * cell_m)
    raised = height.ravel() + UPLIFT_M * uplift.ravel()
    raised[receiver[:-1] == receiver.size - 1] = 0.0
    worn = _solve_down(raised / (1 + factor), factor / (1 + factor), receiver)
    return slide(worn.reshape(height.shape), cell_m, repose)


NEIGHBOURS = ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1))


def drainage(height):
    """Find the receiver of every cell: its steepest lower neighbour, or the way out of its pit.

    Parameters
    ----------
    height : (N, M) array

    Returns
    -------
    receiver : (N * M + 1,) intp array
        Flat index; cells at the border drain to the last, virtual cell, which drains to itself.
    length : (N * M,) array
        Distance to the receiver [cells].
    """
    rows, cols = height.shape
    count, flat = height.size, height.ravel()
    index = np.arange(count).reshape(rows, cols)
    start, stop = [], []
    for dr, dc in NEIGHBOURS[4:]:
        here = index[: rows - dr, max(-dc, 0) : cols - max(dc, 0)]
        start.append(here.ravel())
        stop.append((here + dr * cols + dc).ravel())
    border = np.unique(np.concatenate([index[0], index[-1], index[:, 0], index[:, -1]]))
    start.append(border)
    stop.append(np.full(border.size, count))
    start, stop = np.concatenate(start), np.concatenate(stop)
    level = np.append(flat - flat.min() + 1.0, 0.5)
    weight = np.maximum(level[start], level[stop])
    graph = coo_matrix((weight, (start, stop)), shape=(count + 1, count + 1)).tocsr()
    tree = minimum_spanning_tree(graph)
    _, way_out = breadth_first_order(tree, count, directed=False)
    way_out = way_out.astype(np.intp)
    way_out[count] = count
    filled = _maximum_down(level, way_out)
    receiver, best = way_out.copy(), np.zeros(count)
    padded = np.pad(filled[:-1].reshape(rows, cols), 1, constant_values=np.inf)
    dry = filled[:-1] <= level[:-1]
    dry[border] = False
    for dr, dc in NEIGHBOURS:
        other = padded[1 + dr : 1 + dr + rows, 1 + dc : 1 + dc + cols].ravel()
        drop = (filled[:-1] - other) / np.hypot(dr, dc)
        better = dry & (drop > best)
        receiver[:-1][better] = index.ravel()[better] + dr * cols + dc
        best[better] = drop[better]
    receiver[border] = count
    step = np.abs(receiver[:-1] - np.arange(count))
    length = np.where((step == 1) | (step == cols), 1.0, np.sqrt(2.0))
    return receiver, length


def _maximum_down(level, parent):
    """Highest level on the way to the root, by pointer doubling."""
    level = level.copy()
    while True:
        level = np.maximum(level, level[parent])
        further = parent[parent]
        if np.array_equal(further, parent):
            return level
        parent = further


def _accumulate(receiver):
    """Number of cells that drain through each cell, itself included, by pointer doubling."""
    root = receiver.size - 1
    total, parent = np.ones(receiver.size), receiver
    while True:
        total[root] = 0.0
        total = total + np.bincount(parent, total, receiver.size)
        if (parent == root).all():
            return total[:-1]
        parent = parent[parent]


def _solve_down(own, share, receiver):
    """Solve h = own + share * h[receiver] along the tree by pointer doubling; the root has h = 0."""
    constant, gain, parent = np.append(own, 0.0), np.append(share, 0.0), receiver
    root = receiver.size - 1
    while not (parent == root).all():
        constant = constant + gain * constant[parent]
        gain = gain * gain[parent]
        parent = parent[parent]
    return constant[:-1]


def slide(height, cell_m, repose, passes=4):
    """Move material down wherever a slope is steeper than the repose, in all eight directions.

    Parameters
    ----------
    height : (R, C) array
        [m].
    cell_m : float
        Side of a cell [m].
    repose : float
        Steepest slope that holds, rise over run.
    passes : int

    Returns
    -------
    (R, C) array
        A new one [m].
    """
    rows, cols = height.shape
    for _ in range(passes):
        change = np.zeros_like(height)
        for dr, dc in NEIGHBOURS[4:]:
            here = np.s_[: rows - dr, max(-dc, 0) : cols - max(dc, 0)]
            there = np.s_[dr:, max(dc, 0) : cols + min(dc, 0)]
            drop = height[there] - height[here]
            excess = np.sign(drop) * np.maximum(np.abs(drop) - repose * cell_m * np.hypot(dr, dc), 0) * 0.12
            change[here] += excess
            change[there] -= excess
        height = height + change
    return height
