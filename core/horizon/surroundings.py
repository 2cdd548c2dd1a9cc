"""The part of a horizon search that does not depend on the elevation of the eye: rays, cells, and bounds of cells.

One place may have several eyes, at different elevations. Reading the cells takes most of the time where they are small,
so they are read once for all eyes.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ..base.progress import SILENT
from ..base.terrain import Window, check_inside
from .blocks import STRIP_ROWS, HeldTerrain, aligned, block_maxima
from .rays import lay_rays

BLOCK = 8
"""Side of the blocks whose maxima bound the rays' intervals [cells]."""

MAX_PAIRS = 32_000_000
"""Most (ray, interval) pairs in memory at once; above this, blocks and intervals are doubled."""


class Surroundings:
    """Rays around one place, and the terrain along them, which is read when it is first needed.

    Only one thread may use them at a time, because cells that are not held are read into memory that is used again.

    Parameters
    ----------
    terrain : Terrain
    longitude_deg, latitude_deg : float
        WGS 84 position [degrees].
    options : HorizonOptions

    Attributes
    ----------
    terrain, options
        As given.
    frame : LocalFrame
        Frame around the position.

    Raises
    ------
    ObserverOutsideDemError
    """

    def __init__(self, terrain, longitude_deg, latitude_deg, options):
        self.terrain = terrain
        self.frame = terrain.frame(longitude_deg, latitude_deg, options.max_distance_m)
        check_inside(terrain, self.frame)
        self.options = options
        self._blocks = None

    @cached_property
    def rays(self):
        """`Rays` to the end of the search range, or to the DEM's edge."""
        options = self.options
        return lay_rays(self.frame, self.terrain.shape, options.azimuth_deg, options.max_distance_m)

    @property
    def edge_m(self):
        """(N + 1,) distances that divide each ray into intervals [m]; a single one if the DEM ends before."""
        return self._intervals[0]

    @cached_property
    def cells(self):
        """`HeldTerrain`, which keeps the cells nearest the position."""
        return HeldTerrain(self.terrain, self._window, self.frame.row_px, self.options.memory_mb)

    def blocks(self, progress=SILENT):
        """Return the `BlockMaxima` of all cells within reach, for which the terrain is read the first time."""
        if self._blocks is None:
            block = self._intervals[1]

            def columns(first_row, last_row):
                return self.rays.columns(first_row, last_row, margin_px=3 * block)

            self._blocks = block_maxima(self.cells, self._window, block, progress, columns)
        return self._blocks

    @cached_property
    def _intervals(self):
        return _intervals(self.rays, self.options.near_skip_cells * self.frame.cell_m)

    @cached_property
    def _window(self):
        return aligned(_window(self.rays, self.terrain.shape), self._intervals[1], self.terrain.shape)


def _intervals(rays, start_m):
    """Edges of the rays' intervals [m], and the block size whose bound covers the intervals."""
    furthest = float(rays.reach_m.max())
    if furthest <= start_m:
        return np.array([start_m]), BLOCK
    block = BLOCK
    while True:
        # Half an interval and the interpolation's stencil fit into one block's width.
        length = 2 * (block - 1.5) / rays.pixels_per_metre
        count = int(np.ceil((furthest - start_m) / length))
        if count * len(rays.azimuth_deg) <= MAX_PAIRS or block >= STRIP_ROWS:
            break
        block *= 2
    edge = start_m + length * np.arange(count + 1)
    edge[-1] = furthest
    return edge, block


def _window(rays, shape):
    """Rectangle of cells that the rays touch."""
    col, row = rays.at_pairs(np.arange(len(rays.reach_m)), rays.reach_m)
    inside = rays.node_m <= rays.reach_m[:, None]
    col = np.concatenate([col, rays.col_px[inside]])
    row = np.concatenate([row, rays.row_px[inside]])
    top, left = int(np.floor(row.min())) - 1, int(np.floor(col.min())) - 1
    bottom, right = int(np.ceil(row.max())) + 2, int(np.ceil(col.max())) + 2
    return Window(top, left, bottom - top, right - left).clipped(shape)
