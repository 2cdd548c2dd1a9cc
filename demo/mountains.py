"""Seeded procedural mountains: a range carved by rivers and rockfall, with detail below any cell size.

The land rises by a random pattern of uplift and is eroded by the stream-power law along its drainage, solved
implicitly on grids of increasing resolution; slopes beyond the angle of repose slide (`demo.erosion`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import ndimage

from ..core.base.progress import SILENT, Progress, checkpoint
from ..core.base.terrain import ArrayTerrain
from ..core.simulate.noise import noise_tile, power_spectrum, without_long_waves
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


def roughness(elevation_m, cell_m, coarse_cell_m, seed, strength=0.22, origin_px=(0, 0)):
    """Compute the relief that a grid of `coarse_cell_m` cannot represent, for a finer grid of `cell_m`.

    It is rugged on steep slopes and crests, and smooth on valley floors.

    Parameters
    ----------
    elevation_m : (R, C) array
        Smooth surface on the fine grid [m].
    cell_m, coarse_cell_m : float
        Sides of the cells of the fine and of the coarse grid [m].
    seed : int
    strength : float
        Standard deviation at unit slope [coarse cells].
    origin_px : (row, col)
        Position of the array in its raster, so that any window of the raster gets the same roughness.

    Returns
    -------
    (R, C) array
        Relief to be added [m].
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
    noise = fractal_field(seed, 1.9, PATTERN_CELLS, 14.0 * fine_per_coarse)
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


def fractal_field(seed, slope, cells, longest_cells):
    """Make one periodic random field of unit deviation.

    Parameters
    ----------
    seed : int
    slope : float
        Its amplitude falls as 1 / frequency ** `slope`.
    cells : int
        Side of the field.
    longest_cells : float
        Longest wave [cells].

    Returns
    -------
    (cells, cells) float32 array
    """
    spectrum, frequency = power_spectrum(seed, slope, cells)
    value = np.fft.irfft2(spectrum * without_long_waves(frequency / cells, longest_cells), s=(cells, cells))
    return (value / value.std()).astype(np.float32)
