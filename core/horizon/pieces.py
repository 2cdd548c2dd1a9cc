"""The terrain around many scattered intervals of rays, read piece by piece into one array and sampled together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.terrain import Window

TILE = 256
"""Intervals whose midpoints lie in one square of this side share a piece [cells]."""

HELD_CELLS = 1_000_000
"""Cells of pieces in memory at once: 4 MB, which stay in the processor's cache."""


@dataclass(frozen=True, eq=False)
class Pieces:
    """Windows of a terrain, one after the other in a flat array, and the window of each job.

    Attributes
    ----------
    cells : (N,) float32 array
        Elevations [m], NaN where unknown.
    corner, top, left, rows, cols : (J,) int arrays
        Window of each job: position of its first cell in `cells`, first row and column in the raster, and size.
    """

    cells: np.ndarray
    corner: np.ndarray
    top: np.ndarray
    left: np.ndarray
    rows: np.ndarray
    cols: np.ndarray

    def part(self, chosen):
        """Pieces of some of the jobs."""
        places = self.corner, self.top, self.left, self.rows, self.cols
        return Pieces(self.cells, *(place[chosen] for place in places))

    def elevation_m(self, row_px, col_px):
        """Bilinear elevation at (J, K) pixels of the whole raster, K per job [m]; NaN where unknown.

        Positions up to half a cell beyond the raster's outer centres take the outer cells. Shares are computed before a
        window's origin is subtracted, so that the result is the same to the last bit whichever window the cells come
        from. (`bilinear` cannot guarantee that, and reads one window at a time.)
        """
        row0, row_share = _split(row_px, self.top, self.rows)
        col0, col_share = _split(col_px, self.left, self.cols)
        corner = row0 * self.cols[:, None]
        corner += col0
        corner += self.corner[:, None]
        down = np.where(self.rows > 1, self.cols, 0)[:, None]
        across = 1 if self.cols.min(initial=2) > 1 else 0
        low = corner + down
        values = [self.cells.take(place) for place in (corner, corner + across, low, low + across)]
        upper = values[0] + (values[1] - values[0]) * col_share
        lower = values[2] + (values[3] - values[2]) * col_share
        elevation = upper + (lower - upper) * row_share
        unknown = np.isnan(elevation)
        if unknown.any():
            known = [value[unknown] for value in values]
            elevation[unknown] = _of_known(known, row_share[unknown], col_share[unknown])
        return elevation

    def on_lines_m(self, line, place_px, columns):
        """Elevation where rays cross whole columns (or rows): (J, K) [m]; `elevation_m` needs twice the work.

        Parameters
        ----------
        line : (J, K) array
            Columns (or rows) of the raster, whole numbers.
        place_px : (J, K) array
            Row (or column) of the crossings, monotonic along each job.
        columns : bool
            The lines are columns.
        """
        first, count = (self.top, self.rows) if columns else (self.left, self.cols)
        whole = np.floor(place_px)
        lowest, highest = first[:, None], (first + np.maximum(count - 2, 0))[:, None]
        ends = whole[:, [0, -1]]
        outside = (ends < lowest).any() or (ends > highest).any()
        if outside:  # up to half a cell beyond the outer centres
            whole = np.minimum(np.maximum(whole, lowest, out=whole), highest)
        share = place_px - whole
        if outside:
            share = np.minimum(np.maximum(share, 0.0, out=share), 1.0)
        row, col = (whole, line) if columns else (line, whole)
        corner = row * self.cols[:, None]
        corner += col
        corner += (self.corner - self.top * self.cols - self.left)[:, None]
        corner = corner.astype(np.intp)
        low = self.cells.take(corner)
        corner += np.where(count > 1, self.cols if columns else 1, 0)[:, None]
        high = self.cells.take(corner)
        high -= low
        share *= high
        share += low
        return share


def _split(place_px, first, count):
    """Row (or column) before each pixel, counted from its window's first, and the share of the next one."""
    whole = np.floor(place_px)
    share = place_px - whole
    index = whole.astype(np.intp) - first[:, None]
    last = np.maximum(count - 2, 0)[:, None]
    before, after = index < 0, index > last
    share[before], share[after] = 0.0, 1.0
    np.maximum(index, 0, out=index)
    return np.minimum(index, last, out=index), share


def _of_known(values, row_share, col_share):
    """Interpolate cells of which some corners are NaN: a corner without weight does not make a sample unknown."""
    weights = [a * b for a in (1 - row_share, row_share) for b in (1 - col_share, col_share)]
    return sum(np.where(weight > 0, weight * value, 0.0) for weight, value in zip(weights, values))


def one_piece(cells, window, count):
    """Make `Pieces` for jobs that all lie in one window.

    Parameters
    ----------
    cells : (rows, cols) float32 array
        Elevations in the window [m].
    window : Window
    count : int
        Number of jobs.
    """
    place = 0, window.row, window.col, window.rows, window.cols
    return Pieces(np.ascontiguousarray(cells).reshape(-1), *(np.full(count, number) for number in place))


def read_transient_pieces(terrain, row_px, col_px, margin_px):
    """Read the terrain around positions, square by square.

    Parameters
    ----------
    terrain : Terrain
    row_px, col_px : (J,) arrays
        Midpoint of each job [pixels].
    margin_px : int
        Distance that a job reaches from its midpoint, with the interpolation's stencil [cells].

    Yields
    ------
    jobs : int array
    pieces : Pieces
        Pieces of these jobs, in their order; the next iteration overwrites their cells.
    """
    if len(row_px) == 0:
        return
    order, key = by_tiles(row_px, col_px, terrain.shape)
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    windows = _windows(row_px[order], col_px[order], starts, margin_px, terrain.shape)
    ends = np.append(starts[1:], len(order))
    size = [window.rows * window.cols for window in windows]
    buffer = np.empty(max(min(sum(size), HELD_CELLS), max(size)), np.float32)  # reused: new memory is slow
    first = 0
    while first < len(windows):
        last, total = first + 1, size[first]
        while last < len(windows) and total + size[last] <= HELD_CELLS:
            total += size[last]
            last += 1
        count = ends[first:last] - starts[first:last]
        yield order[starts[first] : ends[last - 1]], _read(terrain, windows[first:last], count, buffer[:total])
        first = last


def by_tiles(row_px, col_px, shape):
    """Sort positions by the squares that they lie in.

    Parameters
    ----------
    row_px, col_px : (J,) arrays
        Positions [pixels].
    shape : (rows, columns)
        Shape of the raster.

    Returns
    -------
    order : (J,) int array
        Order in which positions of one square follow one another.
    key : (J,) int array
        Number of each position's square, not yet in that order.
    """
    rows, cols = shape
    tile_row = np.clip(row_px, 0, rows - 1).astype(np.intp) // TILE
    tile_col = np.clip(col_px, 0, cols - 1).astype(np.intp) // TILE
    key = tile_row * (cols // TILE + 1) + tile_col
    return np.argsort(key, kind="stable"), key


def _windows(row_px, col_px, starts, margin_px, shape):
    """Smallest rectangle around each group of jobs, so that a single ridge does not cost a whole square."""
    top, left = (np.minimum.reduceat(place, starts) - margin_px for place in (row_px, col_px))
    bottom, right = (np.maximum.reduceat(place, starts) + margin_px + 1 for place in (row_px, col_px))
    edges = zip(top.tolist(), left.tolist(), bottom.tolist(), right.tolist())
    return [Window(int(a) - 1, int(b) - 1, int(c - a) + 3, int(d - b) + 3).clipped(shape) for a, b, c, d in edges]


def _read(terrain, windows, count, cells):
    corners, corner = [], 0
    for window in windows:
        size = window.rows * window.cols
        terrain.read_into(window, cells[corner : corner + size].reshape(window.rows, window.cols))
        corners.append(corner)
        corner += size
    places = [(window.row, window.col, window.rows, window.cols) for window in windows]
    return Pieces(cells, *(np.repeat(place, count) for place in (corners, *zip(*places))))
