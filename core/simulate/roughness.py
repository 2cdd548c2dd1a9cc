"""Relief that the cells of a terrain model cannot represent, drawn at random."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy import ndimage

from .noise import power_spectrum, without_long_waves

PATTERN_CELLS = 512


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


@lru_cache(maxsize=4)
def _rough_pattern(seed, fine_per_coarse):
    """Periodic roughness on the fine grid: crests are sharp and gullies blunt, since noise is folded at its zeros."""
    noise = fractal_field(seed, 1.9, PATTERN_CELLS, 14.0 * fine_per_coarse)
    return 0.8 * (0.8 - np.abs(noise)) + 0.55 * noise


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
