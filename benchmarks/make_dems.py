"""Make the benchmark's elevation models from a seed: ridged mountains, float32 GeoTIFF in EPSG:32606.

Usage: python benchmarks/make_dems.py build/dems [A B C AZ]
    A   15001 x 15001 cells of 2 m (900 MB); AZ is the same as a DEFLATE-compressed, tiled file with overviews
    B   6001 x 6001 cells of 30 m
    C   1001 x 1001 cells of 30 m
"""

from __future__ import annotations

import os
import sys

import numpy as np
from osgeo import gdal, osr
from scipy.ndimage import zoom

CASES = {"A": (15001, 2.0, 2550.0, 1), "B": (6001, 30.0, 3260.0, 2), "C": (1001, 30.0, 2400.0, 3)}
"""Cells per side, cell size [m], relief [m], seed."""

CENTRE = (500_000.0, 6_800_000.0)
LONGEST_M, EXPONENT = 11_000.0, 2.2
"""Longest wavelength of the relief [m], and exponent of the decrease of amplitude with frequency."""

COARSE = 4096
"""Largest spectral synthesis [cells]; finer detail is added in tiles, so that A needs no 4 GB transform."""


def fractal(size, exponent, longest_cells, rng):
    """Make a periodic random field of unit variance: power-law spectrum below a longest wavelength, flat above it."""
    frequency = np.fft.rfftfreq(size)[None, :] ** 2 + np.fft.fftfreq(size)[:, None] ** 2
    amplitude = np.maximum(frequency, 1.0 / longest_cells**2) ** (-exponent / 2)
    amplitude[0, 0] = 0.0
    noise = rng.standard_normal((size, size), dtype=np.float32)
    field = np.fft.irfft2(np.fft.rfft2(noise) * amplitude, s=(size, size))
    return (field / field.std()).astype(np.float32)


def mountains(size, relief_m, cell_m, seed):
    """Make elevations (size, size) float32 [m]."""
    rng = np.random.default_rng(seed)
    base = min(size, COARSE)
    longest = LONGEST_M / cell_m * base / size
    ridged = 1.0 - np.abs(fractal(base, EXPONENT, longest, rng))
    coarse = ridged + 0.5 * fractal(base, EXPONENT, longest, rng)
    coarse = (coarse - coarse.min()) / (coarse.max() - coarse.min()) * relief_m
    if base == size:
        return coarse.astype(np.float32)
    terrain = zoom(coarse, size / base, order=1, grid_mode=True, mode="nearest")[:size, :size].astype(np.float32)
    del coarse
    tile = 1024
    detail = fractal(tile, EXPONENT, 64, rng) * np.float32(0.7 * cell_m)
    for row in range(0, size, tile):  # flipped copies of one tile join without a seam
        for col in range(0, size, tile):
            part = detail[:: -1 if row // tile % 2 else 1, :: -1 if col // tile % 2 else 1]
            place = terrain[row : row + tile, col : col + tile]
            place += part[: place.shape[0], : place.shape[1]]
    return terrain


def write(path, elevation, cell_m, options=("TILED=YES",)):
    """Write a GeoTIFF under a temporary name, then rename."""
    rows, cols = elevation.shape
    partial = path + ".part.tif"
    raster = gdal.GetDriverByName("GTiff").Create(partial, cols, rows, 1, gdal.GDT_Float32, options=list(options))
    left, top = CENTRE[0] - cols * cell_m / 2, CENTRE[1] + rows * cell_m / 2
    raster.SetGeoTransform((left, cell_m, 0, top, 0, -cell_m))
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32606)
    raster.SetProjection(reference.ExportToWkt())
    raster.GetRasterBand(1).WriteArray(elevation)
    raster = None  # closes the file
    os.replace(partial, path)


def make(folder, names=("A", "B", "C")):
    """Make the missing DEMs and return {name: path}."""
    os.makedirs(folder, exist_ok=True)
    paths = {name: os.path.join(folder, f"{name}.tif") for name in names}
    for name, path in paths.items():
        if os.path.exists(path):
            continue
        if name == "AZ":
            source = make(folder, ("A",))["A"]
            partial = path + ".part.tif"
            gdal.Translate(
                partial, source, creationOptions=["TILED=YES", "COMPRESS=DEFLATE", "PREDICTOR=3", "NUM_THREADS=2"]
            )
            os.replace(partial, path)
            continue
        size, cell_m, relief_m, seed = CASES[name]
        write(path, mountains(size, relief_m, cell_m, seed), cell_m)
    return paths


if __name__ == "__main__":
    gdal.UseExceptions()
    print(make(sys.argv[1], tuple(sys.argv[2:]) or ("A", "B", "C")))
