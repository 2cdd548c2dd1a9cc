"""A finer version of a terrain model: crests sharper and slopes rougher than its cells can represent.

Every elevation model smooths. A simulated photograph of the model itself would fit it better than any real photograph
does. This finer terrain stands in for the mountain of which the model is the blurred copy.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy import ndimage

from ..base.frame import LocalFrame
from ..base.terrain import Terrain, Window
from .roughness import roughness

MARGIN_CELLS = 6
"""Coarse cells read around a window, so that its edge does not affect the filters."""


@dataclass(frozen=True, eq=False)
class DetailedTerrain(Terrain):
    """A finer terrain around a coarse one.

    Attributes
    ----------
    terrain : Terrain
        The coarse model.
    factor : int
        Fine cells per coarse cell and direction.
    seed : int
        Seed of the detail; the same seed gives the same mountain, whatever window is read.
    strength : float
        Standard deviation of the detail at unit slope [coarse cells].
    sharpening : float
        How far crests rise above, and hollows sink below, the smoothed model (1: what a blur of one cell removed).
    """

    terrain: Any
    factor: int = 4
    seed: int = 0
    strength: float = 0.22
    sharpening: float = 0.8

    def __post_init__(self):
        if self.factor < 1 or self.strength < 0:
            raise ValueError(f"detail needs a factor of at least 1 and no negative strength, not {self}")

    @property
    def shape(self):  # type: ignore[override]  # nobody sets a terrain's shape from outside
        """(rows, columns) of the fine raster."""
        rows, cols = self.terrain.shape
        return rows * self.factor, cols * self.factor

    def frame(self, longitude_deg, latitude_deg, radius_m) -> LocalFrame:
        """See `Terrain.frame`."""
        coarse = self.terrain.frame(longitude_deg, latitude_deg, radius_m)
        remainder = coarse.remainder_px
        return replace(
            coarse,
            col_px=self._finer(coarse.col_px),
            row_px=self._finer(coarse.row_px),
            jacobian_px_per_m=coarse.jacobian_px_per_m * self.factor,
            remainder_px=None if remainder is None else remainder * self.factor,
        )

    def position_of(self, col_px, row_px):
        """(longitude, latitude) of fine pixels [degrees]."""
        return self.terrain.position_of(self._coarser(np.asarray(col_px)), self._coarser(np.asarray(row_px)))

    def read(self, window):
        """See `Terrain.read`."""
        top, left = window.row // self.factor - MARGIN_CELLS, window.col // self.factor - MARGIN_CELLS
        bottom = (window.row + window.rows - 1) // self.factor + MARGIN_CELLS + 1
        right = (window.col + window.cols - 1) // self.factor + MARGIN_CELLS + 1
        source = Window(top, left, bottom - top, right - left).clipped(self.terrain.shape)
        coarse = np.asarray(self.terrain.read(source), np.float64)
        unknown = ~np.isfinite(coarse)
        if unknown.all():
            return np.full((window.rows, window.cols), np.nan, np.float32)
        if unknown.any():
            nearest = ndimage.distance_transform_edt(unknown, return_distances=False, return_indices=True)
            coarse = coarse[tuple(nearest)]
        coarse = coarse + self.sharpening * (coarse - ndimage.gaussian_filter(coarse, 0.8, mode="nearest"))
        # Compute all fine rows over the source, then cut the window: filters of the roughness need its surroundings
        # too.
        rows = np.arange(source.row * self.factor, (source.row + source.rows) * self.factor)
        cols = np.arange(source.col * self.factor, (source.col + source.cols) * self.factor)
        fine = _upsample(_upsample(coarse, self.factor).T, self.factor).T
        cell_m = self._cell_m()
        fine += roughness(fine, cell_m / self.factor, cell_m, self.seed, self.strength, (int(rows[0]), int(cols[0])))
        if unknown.any():
            lost = unknown.repeat(self.factor, 0).repeat(self.factor, 1)
            fine[lost] = np.nan
        row, col = window.row - int(rows[0]), window.col - int(cols[0])
        return fine[row : row + window.rows, col : col + window.cols].astype(np.float32)

    def _cell_m(self):
        """Ground size of a coarse cell at the raster's centre [m]."""
        rows, cols = self.terrain.shape
        return self.terrain.frame(*map(float, self.terrain.position_of(cols / 2, rows / 2)), 2_000.0).cell_m

    def _finer(self, pixel):
        return (pixel + 0.5) * self.factor - 0.5

    def _coarser(self, pixel):
        return (pixel + 0.5) / self.factor - 0.5


def _upsample(values, factor):
    """Interpolate `factor` rows for each row by cubic convolution (Keys 1981, doi:10.1109/TASSP.1981.1163711)."""
    padded = np.pad(values, ((2, 2), (0, 0)), mode="edge")
    fine = np.empty((values.shape[0] * factor, values.shape[1]))
    for phase in range(factor):
        offset = (phase + 0.5) / factor - 0.5
        first = 1 if offset < 0 else 2  # the padded row at or before the sampled position
        t = offset + 1 if offset < 0 else offset
        weights = (
            ((2 - t) * t - 1) * t / 2,
            ((3 * t - 5) * t * t + 2) / 2,
            ((4 - 3 * t) * t + 1) * t / 2,
            (t - 1) * t * t / 2,
        )
        fine[phase::factor] = sum(
            weight * padded[first - 1 + k : first - 1 + k + len(values)] for k, weight in enumerate(weights)
        )
    return fine
