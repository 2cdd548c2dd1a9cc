"""Exact marginals of headings that differ by known turns, where the turns form a forest (sum-product algorithm)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .circle import mirrored, moved

LEAST = 1e-12
"""Smallest relative density, so that a product of many stays above zero."""


@dataclass(frozen=True, eq=False)
class Turn:
    """The heading of `other` is that of `one` plus a turn and an error.

    Attributes
    ----------
    one, other : int
        Numbers of the headings.
    turn_deg : float
        Clockwise [degrees].
    error : (CELLS,) array
        Density of the error, relative to the uniform one.
    """

    one: int
    other: int
    turn_deg: float
    error: np.ndarray

    def seen_from(self, node):
        """Return the other end, and what the density at `node` says of it, as a function."""
        if node == self.one:
            return self.other, lambda density: moved(density, self.turn_deg, self.error)
        return self.one, lambda density: moved(density, -self.turn_deg, mirrored(self.error))


def marginals(own, turns):
    """Find the density of each heading, given what is known of each by itself and the turns between them.

    Parameters
    ----------
    own : (N, CELLS) array
        Density of each heading by itself, relative to the uniform one.
    turns : sequence of Turn
        Without loops: information that came back to its source would count twice.

    Returns
    -------
    beliefs : (N, CELLS) array
    heard : dict
        By (from, to): the density that one heading gives to another, from all on its side.

    Raises
    ------
    ValueError
        The turns form a loop.
    """
    log_own = np.log(np.maximum(own, LEAST))
    around: dict = {node: [] for node in range(len(own))}
    for turn in turns:
        around[turn.one].append(turn)
        around[turn.other].append(turn)
    heard: dict = {}
    order = _leaves_last(around)
    for node, parent in reversed(order):
        if parent is not None:
            _tell(node, parent, around, log_own, heard)
    for node, parent in order:
        for turn in around[node]:
            other, _ = turn.seen_from(node)
            if other != parent:
                _tell(node, other, around, log_own, heard)
    beliefs = np.array([_together(node, None, around, log_own, heard) for node in range(len(own))])
    return beliefs.reshape(own.shape), heard


def _leaves_last(around):
    """Return (node, parent) of all trees, each parent before its children."""
    order, seen = [], set()
    for root in around:
        waiting = [] if root in seen else [(root, None)]
        while waiting:
            node, parent = waiting.pop()
            if node in seen:
                raise ValueError("the turns form a loop")
            seen.add(node)
            order.append((node, parent))
            others = [turn.seen_from(node)[0] for turn in around[node]]
            if len(set(others)) < len(others):
                raise ValueError("the turns form a loop")
            waiting += [(other, node) for other in others if other != parent]
    return order


def _tell(node, other, around, log_own, heard):
    turn = next(turn for turn in around[node] if turn.seen_from(node)[0] == other)
    heard[node, other] = turn.seen_from(node)[1](_together(node, other, around, log_own, heard))


def _together(node, without, around, log_own, heard):
    """Density at a node from itself and all neighbours but one."""
    total = log_own[node].copy()
    for turn in around[node]:
        other, _ = turn.seen_from(node)
        if other != without:
            total += np.log(np.maximum(heard[other, node], LEAST))
    density = np.exp(total - total.max())
    return density / density.mean()
