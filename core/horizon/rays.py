"""Rays of true azimuth and true ground distance, laid over a raster of any CRS."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

NODES = 9, 65
"""Fewest and most nodes along a ray, between which pixel positions are interpolated."""

BEND_PX = 0.002
"""Largest deviation of a ray from its true course between two nodes, unless even the most nodes exceed it [cells]."""

OUTLINE_RAYS = 360
"""Number of rays that outline the area they cover."""


@dataclass(frozen=True, eq=False)
class Rays:
    """Pixel positions of rays around one observer.

    Attributes
    ----------
    azimuth_deg : (A,) array
        Clockwise from true north [degrees].
    node_m : (M,) array
        Regular ground distances from 0 [m].
    col_px, row_px : (A, M) arrays
        Position of the nodes in the whole raster [pixels].
    reach_m : (A,) array
        Distance at which each ray leaves the raster's cells, at most the last node [m].
    """

    azimuth_deg: np.ndarray
    node_m: np.ndarray
    col_px: np.ndarray
    row_px: np.ndarray
    reach_m: np.ndarray

    def at(self, distance_m, rays=slice(None)):
        """(col, row) of every chosen ray at every distance [pixels]: (a, D) arrays for (D,) distances."""
        weights = self.weights(distance_m)
        return tuple(table[rays] @ weights for table in (self.col_px, self.row_px))

    def weights(self, distance_m):
        """Shares of the nodes in the positions at some distances: (M, D).

        A matrix product is faster than looking them up.
        """
        place = np.asarray(distance_m) / self.node_m[1]
        low = np.minimum(place.astype(np.intp), len(self.node_m) - 2)
        weights, share, number = np.zeros((len(self.node_m), len(place))), place - low, np.arange(len(place))
        weights[low, number], weights[low + 1, number] = 1 - share, share
        return weights

    def at_pairs(self, ray, distance_m):
        """(col, row) of single (ray, distance) pairs [pixels]; `ray` and `distance_m` broadcast together."""
        place = distance_m / self.node_m[1]
        low = np.minimum(place.astype(np.intp), len(self.node_m) - 2)
        share = place - low
        return tuple(
            table[ray, low] * (1 - share) + table[ray, low + 1] * share for table in (self.col_px, self.row_px)
        )

    def columns(self, first_row, last_row, margin_px):
        """Find the first and last column that rays touch between two rows; None if there are too few rays.

        Parameters
        ----------
        first_row, last_row : int
            Rows of the whole raster.
        margin_px : int
            Margin added on all sides [cells].

        Notes
        -----
        Rays lie around the observer like the ribs of a fan, so that their ends, close together, outline the area that
        they cover; between two ends lies no more than the distance between them.
        """
        col, row = self._ends
        if len(col) < OUTLINE_RAYS:
            return None
        gap = np.hypot(np.diff(col, append=col[0]), np.diff(row, append=row[0])).max() + margin_px
        near = (row >= first_row - gap) & (row <= last_row + gap)
        found = np.append(col[near], self.col_px[0, 0])
        return int(np.floor(found.min() - gap)), int(np.ceil(found.max() + gap))

    @cached_property
    def _ends(self):
        return self.at_pairs(np.arange(len(self.reach_m)), self.reach_m)

    @property
    def pixels_per_metre(self):
        """Fastest change of column or row along any ray, within the raster."""
        step = self.node_m[1]
        inside = self.node_m[None, :-1] <= self.reach_m[:, None]
        change = np.maximum(np.abs(np.diff(self.col_px)), np.abs(np.diff(self.row_px)))
        return float(change[inside].max()) / step


@dataclass(frozen=True, eq=False)
class EyeRays:
    """The data that every tangent needs: rays, interval edges, eye and curvature.

    Attributes
    ----------
    rays : Rays
    edge_m : (N + 1,) array
        Ground distances that divide each ray into intervals [m].
    eye_m : float
        Elevation of the eye [m].
    drop_per_m2 : float
        Apparent drop over distance squared [1/m].
    lines_per_cell : int
        Grid lines per cell, in columns and in rows, on which samples lie.
    cell_m : float
        Ground size of a cell [m].
    """

    rays: Rays
    edge_m: np.ndarray
    eye_m: float
    drop_per_m2: float
    lines_per_cell: int
    cell_m: float

    def tangent(self, elevation_m, distance_m):
        """Tangent of the elevation angle at which terrain at a distance is seen."""
        return (elevation_m - self.eye_m) / distance_m - self.drop_per_m2 * distance_m


@dataclass(frozen=True, eq=False)
class IntervalJobs:
    """Intervals of rays that are to be sampled.

    Attributes
    ----------
    ray, interval : (J,) int arrays
    floor : (J,) array
        Tangents that the caller already has; intervals that stay well below are not examined more closely.
    doubtful : (J,) bool array
        Intervals that may have cells without data around them; all others have none.
    """

    ray: np.ndarray
    interval: np.ndarray
    floor: np.ndarray
    doubtful: np.ndarray


@dataclass(frozen=True, eq=False)
class Stretches:
    """The intervals as they lie on the raster.

    Attributes
    ----------
    ends : tuple of four (J,) arrays
        Column and row of their starts, then column and row of their ends [pixels].
    start_m, end_m : (J,) arrays
        Distances of the starts and of the ends [m].
    """

    ends: tuple
    start_m: np.ndarray
    end_m: np.ndarray

    def part(self, chosen):
        """Return some of the stretches."""
        return Stretches(tuple(place[chosen] for place in self.ends), self.start_m[chosen], self.end_m[chosen])


def lay_rays(frame, shape, azimuth_deg, max_distance_m):
    """Lay rays from the frame's observer over a raster.

    Parameters
    ----------
    frame : LocalFrame
    shape : (rows, columns)
        Shape of the raster.
    azimuth_deg : (A,) array
        True azimuths [degrees].
    max_distance_m : float
        Length of the rays [m].

    Returns
    -------
    Rays

    Notes
    -----
    A ray ends where it leaves the outer cells' area for the first time, or at `max_distance_m`.
    """
    limit = max_distance_m
    for _ in range(2):  # a small raster in a long range: place the nodes where the raster is
        nodes = _nodes(frame, limit)
        node_m = np.linspace(0.0, limit, nodes)
        turn = np.radians(azimuth_deg)[:, None]
        col, row = frame.to_pixel(node_m * np.sin(turn), node_m * np.cos(turn))
        reach = _reach(node_m, col, row, shape)
        furthest = float(reach.max())
        if not 0 < furthest < 0.5 * limit:
            break
        limit = min(limit, furthest * 1.02)
    return Rays(np.asarray(azimuth_deg, float), node_m, col, row, reach)


def _nodes(frame, limit_m):
    """Number of nodes that rays need in a frame with this much bending."""
    table = frame.remainder_px
    if table is None:
        return 2
    bend_px = max(np.abs(np.diff(table, 2, axis=axis)).max(initial=0.0) for axis in (1, 2))
    table_step_m = 2 * frame.radius_m / (table.shape[-1] - 1)
    # Along a ray the bends of both axes and the mixed term can add up to twice the larger one; between nodes an eighth
    # remains.
    step_m = table_step_m * np.sqrt(BEND_PX * 8 / (2 * max(bend_px, 1e-12)))
    return int(np.clip(np.ceil(limit_m / step_m) + 1, *NODES))


def _reach(node_m, col, row, shape):
    """Distance at which each ray first leaves [-0.5, count - 0.5] in columns or rows [m]."""
    excess = np.maximum.reduce([-0.5 - col, col - (shape[1] - 0.5), -0.5 - row, row - (shape[0] - 0.5)])
    outside = excess > 0
    first = np.where(outside.any(axis=1), outside.argmax(axis=1), len(node_m))
    reach = np.full(len(col), node_m[-1])
    leaves = np.flatnonzero(first < len(node_m))
    at = first[leaves]
    before = np.maximum(at - 1, 0)
    share = np.ones(len(leaves))
    for line, low, high in ((col, -0.5, shape[1] - 0.5), (row, -0.5, shape[0] - 0.5)):
        start, end = line[leaves, before], line[leaves, at]
        bound = np.where(end > start, high, low)
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (bound - start) / (end - start)
        share = np.minimum(share, np.where(part >= 0, part, 1.0))
    reach[leaves] = node_m[before] + (node_m[at] - node_m[before]) * np.where(at == 0, 0.0, share)
    return reach
