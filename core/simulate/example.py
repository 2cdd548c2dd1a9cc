"""A mountain range out of thin air, for examples and first steps: no file, no download."""

from __future__ import annotations

import numpy as np

from ..base.terrain import ArrayTerrain

ROUGHNESS = 2.1
"""Exponent of the power spectrum's amplitude; real mountains have about as much at these scales."""


def example_terrain(seed=2, size=256, cell_m=90.0, relief_m=2400.0):
    """Make a square range of fractal mountains.

    Parameters
    ----------
    seed : int
        The same seed gives the same mountains.
    size : int
        Cells per side.
    cell_m : float
        Side of a cell [m].
    relief_m : float
        Highest less lowest elevation; the lowest is 500 m [m].

    Returns
    -------
    ArrayTerrain
        Centred on 8 degrees east, 46.5 degrees north.

    Examples
    --------
    >>> example_terrain()
    <ArrayTerrain: 256 x 256 cells of 90 m, 500 to 2900 m, centre 8.00000, 46.50000>
    """
    generator = np.random.Generator(np.random.PCG64(seed))
    frequency = np.hypot(np.fft.fftfreq(size, 1.0)[:, None], np.fft.rfftfreq(size, 1.0))
    frequency[0, 0] = np.inf  # no mean
    phase = 2 * np.pi * generator.random(frequency.shape)
    surface = np.fft.irfft2(np.exp(1j * phase) / np.maximum(frequency, 3 / size) ** ROUGHNESS, s=(size, size))
    surface = (surface - surface.min()) / (surface.max() - surface.min())
    return ArrayTerrain((500.0 + relief_m * surface).astype(np.float32), cell_m, 8.0, 46.5)
