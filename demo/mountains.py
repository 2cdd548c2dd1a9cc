"""Seeded procedural mountains: a range carved by rivers and rockfall, with detail below any cell size.

The land rises by a random pattern of uplift and is eroded by the stream-power law along its drainage, solved
implicitly on grids of increasing resolution; slopes beyond the angle of repose slide (`demo.erosion`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ..core.base.progress import SILENT, Progress, checkpoint
from ..core.base.terrain import ArrayTerrain
from ..core.simulate.noise import noise_tile
from ..core.simulate.roughness import roughness
from .erosion import slide, wear


@dataclass(frozen=True)
class MountainOptions:
    """The shape of a mountain range.

    Attributes
    ----------
    size : int
        Cells per side of the result.
    cell_m : float
        Side of a cell [m].
    relief_m : float
        Highest minus lowest elevation [m].
    base_m : float
        Lowest elevation [m].
    repose_deg : float
        Steepest stable slope at the scale of the carving grid [degrees].
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
"""Above this size the carved surface is only interpolated and roughened: valleys have their shape by then."""
MARGIN = 0.12
"""Share of the carved domain that is cut off at each side, where rivers leave and the land sinks to the sea."""


def make_mountains(seed, options: MountainOptions | None = None, progress: Progress = SILENT) -> ArrayTerrain:
    """Make a mountain range; the same seed and options give the same range.

    Parameters
    ----------
    seed : int
    options : MountainOptions or None
    progress : Progress

    Returns
    -------
    ArrayTerrain
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
    surface = _rescaled(slide(surface, options.cell_m, repose, passes=10), options)
    surface = surface + roughness(surface, options.cell_m, max(carved_cell_m, options.cell_m), tile_seed)
    return ArrayTerrain(surface.astype(np.float32), options.cell_m, options.longitude_deg, options.latitude_deg)


def _rescaled(surface, options):
    low, high = surface.min(), surface.max()
    return options.base_m + (surface - low) * (options.relief_m / (high - low))


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
            height = wear(height, uplift, softness, cell_m, np.tan(np.radians(options.repose_deg)))
            done += 1
    return height


def _uplift(tile, size):
    """Rate of uplift, 0 to about 1.8: a few massifs and cross ranges, nothing at the margin."""
    axis = (np.arange(size) + 0.5) / size
    y, x = np.meshgrid(axis, axis, indexing="ij")
    noise = tile.sample(x * 180, y * 180, 8.0)[..., 0]
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    return np.clip(0.9 + 0.5 * noise, 0.15, 2.0) * np.clip(edge / 0.05, 0, 1)


def _softness(tile, size):
    """Erodibility of the rock, about 0.4 to 2.5: hard ribs become crests and bend the rivers."""
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


def _resample_inner(carved, size, seed):
    """Cut off the margin and resample the rest to `size` cells, slightly bent so that no valley follows the grid."""
    cells = len(carved)
    axis = cells * MARGIN + (np.arange(size) + 0.5) / size * cells * (1 - 2 * MARGIN) - 0.5
    y, x = np.meshgrid(axis, axis, indexing="ij")
    bend = noise_tile(seed + 7, 1.5)
    bend_x = bend.sample(x / cells * 220, y / cells * 220, 4.0)[..., 0]
    bend_y = bend.sample(x / cells * 220 + 97, y / cells * 220 + 31, 4.0)[..., 0]
    gain = 0.014 * cells
    return ndimage.map_coordinates(carved, [y + gain * bend_y, x + gain * bend_x], order=3, mode="nearest")
