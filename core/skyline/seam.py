"""Treat the skyline as a chain along the columns: find the best line and the probability of each row.

Line and probability both run from column to column over an (H, W) array of log-scores; a step of several rows costs
more than a small one. References: Viterbi 1967, doi 10.1109/TIT.1967.1054010; forward-backward, Rabiner 1989,
doi 10.1109/5.18626.
"""

from __future__ import annotations

import numpy as np


def best_line(score, cost_per_px, reach_px=10, cap_px=8):
    """Row per column of the line with the largest sum of scores minus step costs (Viterbi).

    Parameters
    ----------
    score : (H, W) array
        Score of "the boundary of this column lies at this row".
    cost_per_px : float
        Cost of a step of one row between neighbouring columns.
    reach_px : int
        Largest step [rows].
    cap_px : int
        Larger steps cost no more than this one, so that a very steep flank of a summit costs no more than a steep one
        [rows].

    Returns
    -------
    (W,) int array
    """
    height, width = score.shape
    steps = np.arange(-reach_px, reach_px + 1)
    cost = cost_per_px * np.minimum(np.abs(steps), cap_px)
    rows = np.arange(height)
    came_from = np.zeros((width, height), np.int32)
    total = np.ascontiguousarray(score.T, dtype=float)
    padded = np.full(height + 2 * reach_px, -np.inf)
    windows = np.lib.stride_tricks.sliding_window_view(padded, len(steps))
    for x in range(1, width):
        padded[reach_px:-reach_px] = total[x - 1]
        options = windows - cost
        chosen = options.argmax(1)
        came_from[x] = rows + chosen - reach_px
        total[x] += options[rows, chosen]
    line = np.zeros(width, int)
    line[-1] = total[-1].argmax()
    for x in range(width - 1, 0, -1):
        line[x - 1] = came_from[x][line[x]]
    return line


def row_marginals(log_score, cost_per_px, jump_share, reach_px=14):
    """Probability of each row in each column, given its own column and all others (forward-backward).

    Parameters
    ----------
    log_score : (H, W) array
        Log-likelihood of each row, up to a constant per column.
    cost_per_px : float
        A step of d rows has probability proportional to exp(-cost |d|).
    jump_share : float
        Probability that the line jumps to any row, as at a tree or where a nearer ridge begins.
    reach_px : int
        Steps beyond this happen only as jumps [rows].

    Returns
    -------
    (H, W) float array, columns sum to 1.
    """
    height = log_score.shape[0]
    kernel = np.exp(-cost_per_px * np.abs(np.arange(-reach_px, reach_px + 1)))
    kernel /= kernel.sum()
    own = np.exp(log_score - log_score.max(0)).T
    own /= own.sum(1, keepdims=True)
    forward = _walk(own, kernel, jump_share)
    backward = _walk(own[::-1], kernel, jump_share)[::-1]
    both = forward * backward / np.maximum(own, 1e-30)
    total = both.sum(1, keepdims=True)
    # If the two directions exclude each other, nothing is known of this column's row.
    both = np.where(total > 0, both / np.where(total > 0, total, 1), 1 / height)
    return both.T


def _walk(own, kernel, jump_share):
    """Pass probabilities from the first column to the last; (W, H) in, (W, H) out, rows normalised."""
    width, height = own.shape
    reach = len(kernel) // 2
    belief = np.empty_like(own)
    belief[0] = own[0]
    for x in range(1, width):
        spread = np.convolve(belief[x - 1], kernel)[reach : reach + height]
        here = ((1 - jump_share) * spread + jump_share / height) * own[x]
        belief[x] = here / here.sum()
    return belief
