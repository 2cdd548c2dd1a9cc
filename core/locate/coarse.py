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
    """Spread of a horizon's elevation angle, and how many headings are kept.

    Attributes
    ----------
    angle_deg : float
        Of any horizon [degrees].
    height_share : float
        Error of the eye's height above or below the horizon's terrain, as a share of the distance between places.
    nearest_m : float
        Horizons nearer than this count as this far away [m].
    headings : int
        Number of headings that are kept at each place: a rolled picture may fit better in a wrong direction.
    apart_deg : float
        Smallest angle between two of them [degrees].
    """

    angle_deg: float = 0.15
    height_share: float = 0.12
    nearest_m: float = 100.0
    headings: int = 3
    apart_deg: float = 8.0


@dataclass(frozen=True, eq=False)
class CoarsePlaces:
    """The best poses at each of P places, one for each of H headings, the best of them first.

    Attributes
    ----------
    scores : (P, H) array
        Mean over the picture's columns, higher is better.
    trials : (P, H, 5) array
        Heading, pitch, roll [degrees], logarithm of the focal length relative to the camera's, 0.
    """

    scores: np.ndarray
    trials: np.ndarray

    @property
    def score(self):
        """Score of the best pose at each place (P,)."""
        return self.scores[:, 0]

    @property
    def trial(self):
        """The best pose at each place (P, 5)."""
        return self.trials[:, 0]

    def best(self, count, gain):
        """Places (K,) and poses (K, 5) of the best scores, after adding `gain` (P,) to those of each place; best first.

        A place occurs once for each of its headings among them; a gain of -inf excludes a place.
        """
        wanted = (self.scores + gain[:, None]).ravel()
        usable = np.flatnonzero(np.isfinite(wanted))
        chosen = usable[np.argsort(-wanted[usable], kind="stable")[:count]]
        return chosen // self.scores.shape[1], self.trials.reshape(-1, 5)[chosen]


def compare(index, pictures, options, belief=None, progress=SILENT, coarse=CoarseOptions()):  # noqa: B008 - frozen
    """Find the best poses at every place.

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
    scores = np.full((len(index), coarse.headings), -np.inf)
    trials = np.zeros((len(index), coarse.headings, 5))
    for first in range(0, len(index), CHUNK):
        checkpoint(progress, first / len(index))
        places = slice(first, min(first + CHUNK, len(index)))
        spectra = _spectra(index, places, stride, options, coarse)
        value = np.full((len(spectra), headings), -np.inf, np.float32)
        row, which = np.zeros(value.shape, int), np.zeros(value.shape, int)
        for number, picture in enumerate(pictures):
            around = fft.ifft(spectra * picture.spectrum, axis=2)
            parts = np.concatenate([around.real, around.imag], axis=1)
            table = np.matmul(synthesis, parts) + np.float32(picture.constant)
            highest = table.max(axis=1)
            better = highest > value
            row[better], which[better] = table.argmax(axis=1)[better], number
            value[better] = highest[better]
        if belief is not None:
            value += np.asarray(belief, np.float32)
        poses = np.array([(p.pitch_deg, p.roll_deg, p.log_focal) for p in pictures])
        apart = int(round(coarse.apart_deg / options.step_deg))
        every = np.arange(len(value))
        for rank in range(coarse.headings):
            best = value.argmax(axis=1)
            scores[places, rank] = value[every, best]
            trials[places, rank, 0] = best * options.step_deg
            trials[places, rank, 1:4] = poses[which[every, best]]
            trials[places, rank, 1] -= _shift_deg(row[every, best], len(synthesis), options)
            value[every[:, None], (best[:, None] + np.arange(-apart, apart + 1)) % headings] = -np.inf
    checkpoint(progress, 1.0)
    return CoarsePlaces(scores, trials)


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
