"""Fractal noise from small periodic tiles, used for the texture of ground, the shapes of clouds and the edges of trees.

A tile is made once by spectral synthesis (random phases under a power law) and can be sampled anywhere in the plane, so
that the same place always has the same texture, whatever picture shows it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

TILE_CELLS = 256
MIP_LEVELS = 6


@dataclass(frozen=True, eq=False)
class NoiseTile:
    """A periodic random field of unit standard deviation with its gradient, at several levels of blur.

    Attributes
    ----------
    channels : (L, N * N, 3) float32 array
        Value, d/dx and d/dy [per cell] at blur levels 0 (sharp) to L - 1 (features of 2^level cells).
    cells : int
        N, the period [cells], a power of two.
    """

    channels: np.ndarray
    cells: int

    def sample(self, x, y, blur_cells=None):
        """Sample value and gradient.

        Parameters
        ----------
        x, y : (...) arrays
            Positions in cells of the tile; any real number.
        blur_cells : (...) array or None
            Size of the footprint to average over [cells]; None means a point.

        Returns
        -------
        (..., 3) float32 array
            Value, d/dx, d/dy [per cell].
        """
        x, y = np.broadcast_arrays(np.asarray(x, np.float64), np.asarray(y, np.float64))
        if blur_cells is None:
            return self._level(0, x, y)
        level = np.log2(np.maximum(blur_cells, 1.0)).astype(np.intp)
        level = np.broadcast_to(np.minimum(level, len(self.channels) - 1), x.shape)
        found = np.empty(x.shape + (3,), np.float32)
        for one in np.unique(level):
            mine = level == one
            found[mine] = self._level(one, x[mine], y[mine])
        return found

    def _level(self, level, x, y):
        table, mask = self.channels[level], self.cells - 1
        x0, y0 = np.floor(x), np.floor(y)
        fx = (x - x0).astype(np.float32)[..., None]
        fy = (y - y0).astype(np.float32)[..., None]
        col, row = x0.astype(np.int64) & mask, y0.astype(np.int64) & mask
        col_next, row_next = (col + 1) & mask, (row + 1) & mask
        top = table[row * self.cells + col] * (1 - fx) + table[row * self.cells + col_next] * fx
        low = table[row_next * self.cells + col] * (1 - fx) + table[row_next * self.cells + col_next] * fx
        return top * (1 - fy) + low * fy


@lru_cache(maxsize=12)
def noise_tile(seed, slope=1.0, longest_cells=np.inf):
    """Make a tile whose amplitude falls as 1 / frequency ** `slope`.

    Waves longer than `longest_cells` are left out: a tile that is repeated many times in a picture must not have
    features of its own period.

    Parameters
    ----------
    seed : int
    slope : float
        Power of the frequency.
    longest_cells : float
        Longest wave [cells].

    Returns
    -------
    NoiseTile
    """
    cells = TILE_CELLS
    spectrum, frequency = power_spectrum(seed, slope, cells)
    spectrum = spectrum * without_long_waves(frequency / cells, longest_cells)
    levels, scale = [], 1.0
    for level in range(MIP_LEVELS):
        width = 0.0 if level == 0 else 2.0**level / 2.5
        blur = np.exp(-2 * (np.pi * width * frequency / cells) ** 2)
        value = np.fft.irfft2(spectrum * blur, s=(cells, cells))
        scale = value.std() if level == 0 else scale
        value = value / scale
        gx = (np.roll(value, -1, 1) - np.roll(value, 1, 1)) / 2
        gy = (np.roll(value, -1, 0) - np.roll(value, 1, 0)) / 2
        levels.append(np.stack([value, gx, gy], axis=-1).reshape(-1, 3))
    return NoiseTile(np.array(levels, np.float32), cells)


def without_long_waves(waves_per_cell, longest_cells):
    """Factor that removes the waves longer than `longest_cells` from a spectrum, without a sharp cut-off."""
    return 1 - np.exp(-(np.minimum(waves_per_cell * min(longest_cells, 1e6), 10.0) ** 2))


def power_spectrum(seed, slope, cells):
    """Draw a random half spectrum under a power law.

    Parameters
    ----------
    seed : int
    slope : float
        The amplitude falls as 1 / frequency ** `slope`.
    cells : int
        Period of the field [cells].

    Returns
    -------
    spectrum : (cells, cells / 2 + 1) complex array
    frequency : (cells, cells / 2 + 1) array
        [waves per period].

    References
    ----------
    .. [1] Voss, R. F., Random fractal forgeries, in: Fundamental Algorithms for Computer Graphics, Springer 1985,
       doi:10.1007/978-3-642-84574-1_34 (spectral synthesis).
    """
    generator = np.random.Generator(np.random.PCG64(seed))
    frequency = np.hypot(np.fft.rfftfreq(cells, 1.0)[None, :], np.fft.fftfreq(cells, 1.0)[:, None]) * cells
    phase = generator.random(frequency.shape) * 2 * np.pi
    # Random phases alone give equal amplitudes; a random amplitude too avoids visible regularity in small tiles.
    amplitude = np.sqrt(-np.log(1 - generator.random(frequency.shape))) / np.maximum(frequency, 1.0) ** slope
    amplitude[(frequency > cells / 2) | (frequency == 0)] = 0
    return amplitude * np.exp(1j * phase), frequency


def smoothstep(low, high, x):
    """Rise from 0 to 1 without a kink at either end.

    Parameters
    ----------
    low, high : float
        Where the rise begins and ends; falls if `high` is below `low`.
    x : array
    """
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3 - 2 * t)
