"""Compare a picture with the horizons of all places of an index, at all headings and pitches.

A horizon enters as a spread of elevation angles rather than as a line: from elsewhere in its grid cell, near terrain
stands higher or lower, in inverse proportion to its distance. In the Fourier series along the elevation that spread is
a factor per harmonic, so that it costs nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft

from ..base.progress import SILENT, checkpoint
from .picture import ROWS_PER_HARMONIC

CHUNK = 16
"""Places that are compared together."""


@dataclass(frozen=True)
class CoarseOptions:
    """Spread of a horizon's elevation angle.

    Attributes
    ----------
    angle_deg : float
        Of any horizon [degrees].
    height_share : float
        Error of the eye's height above or below the horizon's terrain, as a share of the distance between places.
    nearest_m : float
        Horizons nearer than this count as this far away [m].
    """

    angle_deg: float = 0.15
    height_share: float = 0.12
    nearest_m: float = 100.0


@dataclass(frozen=True, eq=False)
class CoarsePlaces:
    """The best pose at each of P places.

    Attributes
    ----------
    score : (P,) array
        Mean over the picture's columns, higher is better.
    trial : (P, 5) array
        Heading, pitch, roll [degrees], logarithm of the focal length relative to the camera's, 0.
    """

    score: np.ndarray
    trial: np.ndarray


def compare(index, pictures, options, belief=None, progress=SILENT, coarse=CoarseOptions()):  # noqa: B008 - frozen
    """Find the best pose at every place.

    Parameters
    ----------
    index : HorizonIndex
    pictures : sequence of Hypothesis
    options : PictureOptions
        With which the hypotheses were made.
    belief : (headings,) array or None
        Added to the score of each heading.
    progress : Progress
    coarse : CoarseOptions

    Returns
    -------
    CoarsePlaces
    """
    headings = pictures[0].spectrum.shape[1]
    stride = index.elevation.shape[1] // headings
    if stride * headings != index.elevation.shape[1]:
        raise ValueError(f"an index of {index.elevation.shape[1]} azimuths has no step of {options.step_deg} degrees")
    synthesis = _synthesis(options)
    score, trial = np.full(len(index), -np.inf), np.zeros((len(index), 5))
    for first in range(0, len(index), CHUNK):
        checkpoint(progress, first / len(index))
        places = slice(first, min(first + CHUNK, len(index)))
        spectra = _spectra(index, places, stride, options, coarse)
        for picture in pictures:
            around = fft.ifft(spectra * picture.spectrum, axis=2)
            parts = np.concatenate([around.real, around.imag], axis=1)
            table = np.matmul(synthesis, parts) + np.float32(picture.constant)
            if belief is not None:
                table += np.asarray(belief, np.float32)
            flat = table.reshape(len(table), -1)
            best = flat.argmax(axis=1)
            value = flat[np.arange(len(flat)), best]
            better = np.flatnonzero(value > score[places])
            row, heading = np.divmod(best[better], headings)
            at = first + better
            score[at] = value[better]
            trial[at, 0] = heading * options.step_deg
            trial[at, 1] = picture.pitch_deg - _shift_deg(row, len(synthesis), options)
            trial[at, 2], trial[at, 3] = picture.roll_deg, picture.log_focal
    checkpoint(progress, 1.0)
    return CoarsePlaces(score, trial)


def _synthesis(options):
    """Matrix from the harmonics' real and imaginary parts to shifts in elevation."""
    harmonic = np.arange(1, options.harmonics + 1)
    rows = ROWS_PER_HARMONIC * options.harmonics
    wave = np.exp(2j * np.pi * np.outer(np.arange(rows), harmonic) / rows) * (2 / rows)
    return np.concatenate([wave.real, -wave.imag], axis=1).astype(np.float32)


def _shift_deg(row, rows, options):
    """Shift in elevation of a row of the synthesis, from minus half to half a period [degrees]."""
    return ((row + rows // 2) % rows - rows // 2) * (options.period_deg / rows)


def _spectra(index, places, stride, options, coarse):
    """Transforms along the azimuth of the harmonics of the horizons of some places."""
    elevation, distance = index.horizons(places)
    elevation, distance = elevation[:, ::stride], distance[:, ::stride]
    known = np.isfinite(elevation)
    height_m = coarse.height_share * index.spacing_m
    spread = np.hypot(coarse.angle_deg, np.degrees(height_m / np.maximum(distance, coarse.nearest_m)))
    unit = 2 * np.pi / options.period_deg
    wave = np.exp(1j * unit * np.where(known, elevation, 0)).astype(np.complex64)
    # The spread damps harmonic k by damp ** k**2: from one to the next by damp ** (2 k + 1).
    damp = np.exp(-0.5 * np.square(unit * spread)).astype(np.float32)
    factor, growth = wave * damp, damp * damp
    harmonics = np.empty((len(elevation), options.harmonics, elevation.shape[1]), np.complex64)
    harmonics[:, 0] = factor * known
    for number in range(1, options.harmonics):
        factor *= growth
        np.multiply(harmonics[:, number - 1], factor, out=harmonics[:, number])
    return fft.fft(harmonics, axis=2, overwrite_x=True)
