"""Draping a photograph over the terrain: every visible cell takes the colour of the pixel that shows it.

The viewshed decides which cells are visible; it is not computed again here. A cell's colour is the mean over the patch
of the picture that it covers; cells at pixels that show sky get none. Photographs are blended by nearness and fade out
towards their edges.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..base.camera import project_vectors
from ..base.progress import SILENT, checkpoint
from ..base.surface import local_places, normal_of, patch_around, sampling_distance_m
from ..base.terrain import Window, bilinear

TILE_CELLS = 512
NEARNESS_POWER = 4
"""A photo's weight falls with this power of its ground sampling distance: the nearer one dominates, without a seam."""

FADE_SHARE = 0.04
"""Share of the picture's width over which its weight fades towards the edge, if it overlaps another photo."""


@dataclass(eq=False)
class Tile:
    """A square of the mosaic.

    Attributes
    ----------
    rgba : uint8 (T, T, 4) array
        Alpha 255 where seen.
    gsd_m : float32 (2, T, T) array
        Ground sampling distance of the nearest photo, across and along the line of sight [m]; NaN where unseen.
    """

    rgba: np.ndarray
    gsd_m: np.ndarray
    weight: np.ndarray


@dataclass(eq=False)
class Mosaic:
    """A draped raster under construction: only tiles with visible cells take memory.

    Attributes
    ----------
    window : Window
        Cells of the DEM that the mosaic covers.
    refine : int
        Cells of the mosaic per side of a DEM cell.
    tiles : dict
        (tile row, tile column) -> Tile.
    """

    window: Window
    refine: int = 1
    tiles: dict = field(default_factory=dict)

    @property
    def shape(self):
        """(rows, columns) of the mosaic."""
        return self.window.rows * self.refine, self.window.cols * self.refine

    def tile(self, key):
        """Tile of a key, created on first use."""
        if key not in self.tiles:
            side = (TILE_CELLS, TILE_CELLS)
            self.tiles[key] = Tile(
                np.zeros((*side, 4), np.uint8), np.full((2, *side), np.nan, np.float32), np.zeros(side, np.float32)
            )
        return self.tiles[key]

    def read(self, row, rows):
        """(rgba, gsd_m) of some rows of the mosaic: uint8 (rows, C, 4) and float32 (2, rows, C)."""
        cols = self.shape[1]
        rgba, gsd = np.zeros((rows, cols, 4), np.uint8), np.full((2, rows, cols), np.nan, np.float32)
        for (i, j), tile in self.tiles.items():
            top, left = i * TILE_CELLS, j * TILE_CELLS
            a, b = max(row, top), min(row + rows, top + TILE_CELLS)
            width = min(TILE_CELLS, cols - left)
            if a < b:
                rgba[a - row : b - row, left : left + width] = tile.rgba[a - top : b - top, :width]
                gsd[:, a - row : b - row, left : left + width] = tile.gsd_m[:, a - top : b - top, :width]
        return rgba, gsd


def drape_photo(mosaic, terrain, view, picture, seen, progress=SILENT):
    """Add one photograph to a mosaic.

    Parameters
    ----------
    mosaic : Mosaic
        Changed in place.
    terrain : Terrain
    view : View
        Its camera is that of the full picture; `picture` may be a reduced copy.
    picture : PicturePyramid
    seen : Viewshed
        Viewshed of the photograph.
    progress : Progress

    Returns
    -------
    int
        Number of cells of the mosaic that this photograph coloured.
    """
    visible = seen.visible
    keys = _tiles_touched(mosaic, visible, seen.window)
    coloured = 0
    for count, key in enumerate(keys):
        checkpoint(progress, count / len(keys))
        cells = _seen_cells(mosaic, key, visible, seen.window)
        if cells[0].size:
            coloured += _drape_tile(mosaic, key, terrain, view, picture, cells)
    return coloured


def _tiles_touched(mosaic, seen, window):
    """Keys of the mosaic's tiles over the bounding box of the visible cells."""
    rows, cols = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
    if not rows.size:
        return []
    first = np.array([rows[0] + window.row - mosaic.window.row, cols[0] + window.col - mosaic.window.col])
    last = np.array([rows[-1] + window.row - mosaic.window.row, cols[-1] + window.col - mosaic.window.col])
    first = np.maximum(first, 0) * mosaic.refine // TILE_CELLS
    limit = np.array([mosaic.window.rows, mosaic.window.cols]) - 1
    last = (np.minimum(last, limit) + 1) * mosaic.refine // TILE_CELLS
    return [(i, j) for i in range(first[0], last[0] + 1) for j in range(first[1], last[1] + 1)]


def _seen_cells(mosaic, key, seen, window):
    """Rows and columns, in the mosaic, of a tile's cells whose DEM cell is visible."""
    refine = mosaic.refine
    top, left = key[0] * TILE_CELLS, key[1] * TILE_CELLS
    bottom, right = (min(edge + TILE_CELLS, size) for edge, size in zip((top, left), mosaic.shape))
    r0, c0 = top // refine + mosaic.window.row - window.row, left // refine + mosaic.window.col - window.col
    r1 = -(-bottom // refine) + mosaic.window.row - window.row
    c1 = -(-right // refine) + mosaic.window.col - window.col
    a, b, c, d = max(r0, 0), min(r1, window.rows), max(c0, 0), min(c1, window.cols)
    none = np.zeros(0, np.intp)
    if a >= b or c >= d:
        return none, none
    row, col = np.nonzero(seen[a:b, c:d])
    row, col = row + a + window.row - mosaic.window.row, col + c + window.col - mosaic.window.col
    if refine > 1:
        sub = np.arange(refine)
        row = np.repeat((row[:, None] * refine + sub).ravel(), refine)
        col = np.repeat(col[:, None] * refine + sub, refine, axis=0).ravel()
        row, col = row.reshape(-1), col.reshape(-1)
    inside = (row >= top) & (row < bottom) & (col >= left) & (col < right)
    return row[inside], col[inside]


def _drape_tile(mosaic, key, terrain, view, picture, cells):
    row, col = cells
    dem_row = (row + 0.5) / mosaic.refine - 0.5 + mosaic.window.row
    dem_col = (col + 0.5) / mosaic.refine - 0.5 + mosaic.window.col
    z, r, c = patch_around(terrain, dem_row, dem_col)
    east, north = local_places(view.frame, dem_row, dem_col)
    elevation = z[r.astype(np.intp), c.astype(np.intp)] if mosaic.refine == 1 else bilinear(z, r, c)
    rise = view.rise_of(east, north, elevation)
    x, y = project_vectors(view.camera, view.pose, east, north, rise)
    use = np.flatnonzero(view.frames(x, y))
    use = use[~picture.is_sky((x[use] + 0.5) / view.camera.width_px, (y[use] + 0.5) / view.camera.height_px)]
    if not use.size:
        return 0
    if use.size < x.size:
        x, y, east, north, rise, r, c, row, col = (value[use] for value in (x, y, east, north, rise, r, c, row, col))
    across, along = sampling_distance_m(view, east, north, rise, normal_of(z, r, c, view.frame))
    cell_m = view.frame.cell_m / mosaic.refine
    scale = picture.size_px[0] / view.camera.width_px
    footprint = (cell_m * scale) / np.sqrt(across * along)
    colour = picture.sample((x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5, footprint)
    at = row % TILE_CELLS * TILE_CELLS + col % TILE_CELLS
    _blend(mosaic.tile(key), at, colour, (across, along), _fade(view.camera, x, y))
    return int(use.size)


def _fade(camera, x_px, y_px):
    """Weight that falls towards the picture's edge, 1 inside."""
    edge = np.minimum(np.minimum(x_px, camera.width_px - 1 - x_px), np.minimum(y_px, camera.height_px - 1 - y_px))
    return np.clip((edge + 1) / (FADE_SHARE * camera.width_px), 0.01, 1.0)


def _blend(tile, at, colour, gsd_m, fade):
    """Blend colours into cells of a tile, given by their positions in the flattened tile."""
    across, along = gsd_m
    rgba, gsd, weights = tile.rgba.reshape(-1, 4), tile.gsd_m.reshape(2, -1), tile.weight.reshape(-1)
    weight = (fade / across**NEARNESS_POWER).astype(np.float32)
    before = weights[at]
    nearer = slice(None)
    if before.any():
        share = (weight / (before + weight))[:, None]
        old = rgba[at, :3].astype(np.float32)
        colour = old + (colour - old) * share
        nearer = ~(gsd[0, at] <= across)
    opaque = np.full((at.size, 4), 255, np.uint8)
    opaque[:, :3] = np.rint(colour)
    rgba[at] = opaque
    weights[at] = before + weight
    gsd[0, at[nearer]], gsd[1, at[nearer]] = across[nearer], along[nearer]
