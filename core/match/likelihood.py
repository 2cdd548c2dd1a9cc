"""Compute the robust log likelihood of a skyline row in each column, for every tolerance.

The evidence map gives p(row | column). Let the horizon be predicted at row y with a Gaussian error of s rows, and let
each column be explained by something else altogether with probability e. The log likelihood ratio against an uninformed
column is then

    B(column, y; s) = log((1 - e) / e * (H * (p(. | column) convolved with N(0, s))(y) + t / q * Phi(-y / s))
                          + P(below) + a P(above)),

where `below` and `above` refer to the side of y on which the column's boundary lies, t is the probability that the
ridge leaves the frame at the top, and q is that probability in an uninformed column. Clouds and haze hide the ridge, so
that the visible boundary lies below the horizon, more often than trees and people rise above it: a < 1. B saturates: a
column that the horizon does not explain costs at most log(a). Above the frame B is log((1 - e) / e * t / q + 1 - t).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft, special

from ..base import imaging

EDGE_ROW = 0.5
"""Rows of evidence are first terrain pixels: a boundary at r, in pixel centres, is the upper edge of row r + 0.5."""

INFORMATIVE = 1.5
"""A column is informative if its likeliest row has more than this multiple of the flat probability."""


@dataclass(frozen=True)
class LikelihoodOptions:
    """Options of the conversion from evidence to a score.

    Attributes
    ----------
    outlier_share : float
        e above: share of the columns whose boundary is something else (cloud, tree, person).
    above_share : float
        a above.
    leaving_share : float
        q above: share of the columns of a mountain photograph whose ridge leaves the frame.
    finest_px, coarsest_px, levels : float, float, int
        Tolerances for which B is tabulated, in geometric progression [pixels of the reduced picture].
    """

    outlier_share: float = 0.2
    above_share: float = 0.5
    leaving_share: float = 0.08
    finest_px: float = 0.7
    coarsest_px: float = 30.0
    levels: int = 9

    def __post_init__(self):
        if not 0 < self.outlier_share < 1:
            raise ValueError(f"the outlier share must lie between 0 and 1, not {self.outlier_share}")
        if not 0 < self.above_share <= 1:
            raise ValueError(f"above_share must lie in (0, 1], not {self.above_share}")
        if not 0 < self.leaving_share < 1:
            raise ValueError(f"leaving_share must lie between 0 and 1, not {self.leaving_share}")
        if not 0 < self.finest_px < self.coarsest_px or self.levels < 2:
            raise ValueError("tolerances must grow from finest_px > 0 over at least two levels")


class EvidenceStack:
    """B for a series of tolerances, interpolated at any row and tolerance.

    Parameters
    ----------
    probability : (h, w) array
        p(row | column), as in `SkylineEvidence`.
    options : LikelihoodOptions
    leaves_frame : (w,) array or None
        Probability that the ridge leaves the frame.

    Attributes
    ----------
    probability : (h, w) float32 array
        As given.
    above_frame : (w,) array
        B of a horizon above the picture.
    shape : tuple
        (h, w) of the reduced picture.
    informative : (M,) int array
        Columns with any information about the skyline; all columns if none has any.
    """

    def __init__(self, probability, options=LikelihoodOptions(), leaves_frame=None):  # noqa: B008 - frozen
        self.options = options
        self.shape = probability.shape
        leaves = np.zeros(self.shape[1]) if leaves_frame is None else np.asarray(leaves_frame, float)
        self._leaving = (leaves / options.leaving_share).astype(np.float32)
        odds = (1 - options.outlier_share) / options.outlier_share
        self.above_frame = np.log(odds * self._leaving + 1 - leaves)
        self.tolerance_px = np.geomspace(options.finest_px, options.coarsest_px, options.levels)
        self.probability = np.asarray(probability, np.float32)
        telling = self.informative_columns(probability, self._leaving)
        self.informative = telling if len(telling) else np.arange(self.shape[1])
        self._table = self._blurred(self.tolerance_px)
        self._log_step = np.log(self.tolerance_px[1] / self.tolerance_px[0])

    @staticmethod
    def informative_columns(probability, leaving=0.0):
        """Indices of the columns with any information about the skyline; `leaving` is t / q above."""
        return np.flatnonzero(np.maximum(probability.max(axis=0) * probability.shape[0], leaving) > INFORMATIVE)

    def at_tolerance(self, tolerance_px):
        """B as an (h, w) map for one tolerance [pixels of the reduced picture]."""
        return self._blurred(np.array([tolerance_px]))[0]

    def look_up(self, column, row_px, tolerance_px):
        """Interpolate B between rows and between levels of tolerance.

        Parameters
        ----------
        column : int array
        row_px, tolerance_px : array
            Broadcast together with `column`; NaN rows are out of the frame and give 0.

        Returns
        -------
        array
            B; `above_frame` above the picture and log(a) below it.
        """
        height = self.shape[0]
        row_px = row_px + EDGE_ROW
        inside = (row_px >= 0) & (row_px <= height - 1)
        row = np.where(inside, row_px, 0.0)
        low = np.minimum(row.astype(np.intp), height - 2)
        level = np.log(np.maximum(tolerance_px, 1e-6) / self.tolerance_px[0]) / self._log_step
        level = np.clip(level, 0, len(self.tolerance_px) - 1)
        tier = np.minimum(level.astype(np.intp), len(self.tolerance_px) - 2)
        between_rows, between_tiers = row - low, level - tier
        flat = self._table.reshape(-1)
        width = self.shape[1]
        first = (tier * height + low) * width + column
        tall = height * width
        fine = flat[first] * (1 - between_rows) + flat[first + width] * between_rows
        wide = flat[first + tall] * (1 - between_rows) + flat[first + tall + width] * between_rows
        value = fine * (1 - between_tiers) + wide * between_tiers
        outside = np.where(row_px > height - 1, np.log(self.options.above_share), self.above_frame[column])
        outside = np.where(np.isnan(row_px), 0.0, outside)
        return np.where(inside, value, outside)

    def _blurred(self, tolerance_px):
        """B for each tolerance, (tolerances, h, w): Gaussians along the columns in the frequency domain."""
        height, share = self.shape[0], self.options.outlier_share
        size = fft.next_fast_len(int(height + 4 * np.max(tolerance_px)), real=True)
        spectrum = fft.rfft(self.probability, n=size, axis=0)
        frequency = 2 * np.pi * np.arange(spectrum.shape[0]) / size
        table = np.empty((len(tolerance_px), *self.shape), np.float32)
        leaves = self._leaving * np.float32(self.options.leaving_share)
        for level, tolerance in enumerate(tolerance_px):
            damp = np.exp(-0.5 * np.square(tolerance * frequency)).astype(np.float32)
            blurred = fft.irfft(spectrum * damp[:, None], n=size, axis=0)[:height]
            blurred = np.maximum(blurred, 0)
            above = np.minimum(imaging.accumulate_down(np.add, blurred) + leaves, 1)
            other = 1 - (1 - self.options.above_share) * above
            top = special.ndtr(-np.arange(height) / tolerance).astype(np.float32)[:, None] * self._leaving
            table[level] = np.log((1 - share) / share * (height * blurred + top) + other)
        return table
