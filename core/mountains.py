"""Seeded procedural mountains: a range carved by rivers and rockfall, with detail below any cell size.

The land rises by a random pattern of uplift and is worn by the stream-power law along its drainage, solved
implicitly on grids that grow finer; slopes beyond the angle of repose slide. Drainage over pits follows the minimum
spanning tree, so that no step needs a loop over cells.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order, minimum_spanning_tree

from .progress import SILENT, Progress, checkpoint
from .render_noise import fractal_field, noise_tile
from .terrain import ArrayTerrain


@dataclass(frozen=True)
class MountainOptions:
    """How a range shall look.

    Attributes
    ----------
    size : int
        Cells per side of the result.
    cell_m : float
        [m].
    relief_m : float
        Highest minus lowest elevation [m].
    base_m : float
        Lowest elevation [m].
    repose_deg : float
        Steepest slope that stands at the scale of the carving grid [degrees].
    longitude_deg, latitude_deg : float
        WGS 84 position of the centre [degrees].
    """

    size: int = 512
    cell_m: float = 30.0
    relief_m: float = 2400.0
    base_m: float = 900.0
    repose_deg: float = 42.0
    longitude_deg: float = 8.0
    latitude_deg: float = 46.5

    def __post_init__(self):
        if self.size < 16 or not self.cell_m > 0 or not self.relief_m > 0 or not 5 <= self.repose_deg <= 80:
            raise ValueError(f"mountains need at least 16 cells, a positive cell and relief, not {self}")


COARSEST_CELLS = 48
"""The carving starts on a grid of about this size and doubles it."""
FINEST_CELLS = 320
"""Beyond this the carved surface is only interpolated and roughened: valleys have their shape by then."""
MARGIN = 0.12
"""Share of the carved domain cut off at each side, where rivers leave and the land sinks to the sea."""


def make_mountains(seed, options: MountainOptions | None = None, progress: Progress = SILENT) -> ArrayTerrain:
    """Make a mountain range; the same seed and options give the same range.

    References
    ----------
    .. [1] Braun, J., Willett, S. D., A very efficient O(n), implicit and parallel method to solve the stream power
       equation, Geomorphology 180-181, 2013, doi:10.1016/j.geomorph.2012.10.008.
    """
    options = options or MountainOptions()
    generator = np.random.Generator(np.random.PCG64(seed))
    whole_m = options.size * options.cell_m / (1 - 2 * MARGIN)
    carved = _carve(generator, whole_m, options, progress)
    tile_seed = int(generator.integers(2**31))
    surface = _resample_inner(carved, options.size, tile_seed)
    surface = _rescaled(surface, options)
    carved_cell_m = whole_m / len(carved)
    repose = np.tan(np.radians(options.repose_deg))
    surface = _rescaled(_slide(surface, options.cell_m, repose, passes=10), options)
    surface = surface + roughness(surface, options.cell_m, max(carved_cell_m, options.cell_m), tile_seed)
    return ArrayTerrain(surface.astype(np.float32), options.cell_m, options.longitude_deg, options.latitude_deg)


def _rescaled(surface, options):
    low, high = surface.min(), surface.max()
    return options.base_m + (surface - low) * (options.relief_m / (high - low))


def roughness(elevation_m, cell_m, coarse_cell_m, seed, strength=0.22, origin_px=(0, 0)):
    """Relief that a grid of `coarse_cell_m` does not hold, for a finer grid of `cell_m`.

    Rugged where the surface is steep and on crests, smooth on valley floors.

    Parameters
    ----------
    elevation_m : (R, C) array
        Smooth surface on the fine grid [m].
    cell_m, coarse_cell_m : float
        [m].
    seed : int
    strength : float
        Standard deviation at unit slope, in coarse cells.
    origin_px : (row, col)
        Of the array in its raster, so that any window of it gets the same roughness.

    Returns
    -------
    (R, C) array
        To be added [m].
    """
    smooth = ndimage.gaussian_filter(elevation_m, max(coarse_cell_m / cell_m, 0.7), mode="nearest", truncate=2.5)
    slope = np.hypot(*np.gradient(smooth, cell_m))
    pattern = _rough_pattern(seed, float(coarse_cell_m / cell_m))
    rows = (np.arange(elevation_m.shape[0]) + origin_px[0]) % len(pattern)
    cols = (np.arange(elevation_m.shape[1]) + origin_px[1]) % len(pattern)
    return strength * coarse_cell_m * pattern[rows][:, cols] * np.minimum(slope, 1.2)


PATTERN_CELLS = 512


@lru_cache(maxsize=4)
def _rough_pattern(seed, fine_per_coarse):
    """Periodic roughness on the fine grid: crests are sharp and gullies blunt, since noise is folded at its zeros."""
    noise = fractal_field(seed, 1.7, PATTERN_CELLS, 4.0 * fine_per_coarse)
    return 0.8 * (0.8 - np.abs(noise)) + 0.55 * noise


def _carve(generator, whole_m, options, progress):
    size, levels = COARSEST_CELLS, []
    while size <= min(FINEST_CELLS, max(options.size, COARSEST_CELLS)):
        levels.append(size)
        size = int(size * 1.6)
    steps = [max(int(40 * (levels[0] / n) ** 1.0), 5) for n in levels]
    tile = noise_tile(int(generator.integers(2**31)), 1.6)
    rock = noise_tile(int(generator.integers(2**31)), 1.0)
    height, done = None, 0
    for level, count in zip(levels, steps):
        cell_m = whole_m / level
        uplift, softness = _uplift(tile, level), _softness(rock, level)
        height = _start(generator, level, height)
        for _ in range(count):
            checkpoint(progress, done / sum(steps))
            height = _wear(height, uplift, softness, cell_m, options)
            done += 1
    return height


def _uplift(tile, size):
    """Where the land rises, 0 to about 1.8: a few massifs and cross ranges, nothing at the margin."""
    axis = (np.arange(size) + 0.5) / size
    y, x = np.meshgrid(axis, axis, indexing="ij")
    noise = tile.sample(x * 180, y * 180, 8.0)[..., 0]
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    return np.clip(0.9 + 0.5 * noise, 0.15, 2.0) * np.clip(edge / 0.05, 0, 1)


def _softness(tile, size):
    """How easily the rock wears, about 0.4 to 2.5: hard ribs become crests and bend the rivers."""
    axis = (np.arange(size) + 0.5) / size * 256
    y, x = np.meshgrid(axis, axis, indexing="ij")
    return np.exp(0.45 * tile.sample(x, y, 256 / size)[..., 0])


def _start(generator, size, height):
    jitter = generator.random((size, size))
    if height is None:
        return 50.0 * jitter
    axis = (np.arange(size) + 0.5) / size * len(height) - 0.5
    grown = ndimage.map_coordinates(height, np.meshgrid(axis, axis, indexing="ij"), order=1, mode="nearest")
    return grown + 4.0 * jitter


UPLIFT_M = 60.0
"""Uplift per step [m]."""
EROSION_M = 0.45
"""Of the stream-power law (m = 0.5, n = 1): erosion per step at unit slope, per metre of the square root of area."""
HILLSLOPE_M = 600.0
"""Below a drainage area of this squared, rivers have not begun and slopes stay about even [m]."""


def _wear(height, uplift, softness, cell_m, options):
    """One step: uplift, implicit stream power along the drainage tree, rockfall beyond the angle of repose."""
    receiver, length = drainage(height)
    area = _accumulate(receiver) * cell_m**2
    factor = EROSION_M * softness.ravel() * np.sqrt(area + HILLSLOPE_M**2) / (length * cell_m)
    raised = height.ravel() + UPLIFT_M * uplift.ravel()
    raised[receiver[:-1] == receiver.size - 1] = 0.0
    worn = _solve_down(raised / (1 + factor), factor / (1 + factor), receiver)
    return _slide(worn.reshape(height.shape), cell_m, np.tan(np.radians(options.repose_deg)))


NEIGHBOURS = ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1))


def drainage(height):
    """Receiver of every cell: its steepest lower neighbour, or the way out of its pit.

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


def _slide(height, cell_m, repose, passes=4):
    """Move material down wherever a slope is steeper than the repose, in all eight directions."""
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


def _resample_inner(carved, size, seed):
    """Cut the margin off and bring the inner part to `size` cells, bent a little so that no valley follows the grid."""
    cells = len(carved)
    axis = cells * MARGIN + (np.arange(size) + 0.5) / size * cells * (1 - 2 * MARGIN) - 0.5
    y, x = np.meshgrid(axis, axis, indexing="ij")
    bend = noise_tile(seed + 7, 1.5)
    bend_x = bend.sample(x / cells * 220, y / cells * 220, 4.0)[..., 0]
    bend_y = bend.sample(x / cells * 220 + 97, y / cells * 220 + 31, 4.0)[..., 0]
    gain = 0.014 * cells
    return ndimage.map_coordinates(carved, [y + gain * bend_y, x + gain * bend_x], order=3, mode="nearest")
