"""Search coarsely over all headings and pitches at once, by correlating azimuth-elevation rasters.

For a trial pitch and roll, the evidence is resampled from the picture to relative azimuth and elevation by the exact
pinhole model. A heading is then a shift in azimuth, and a small change of pitch is a shift in elevation, so that one
circular correlation with the DEM's horizon, drawn as a line, gives the scores of all headings.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import fft

from ..base import imaging
from ..base.camera import Pose, project
from ..base.progress import SILENT, checkpoint
from .likelihood import EDGE_ROW
from .prior import EFFECTIVE_COLUMNS, RollPrior

ELEVATION_RANGE_DEG = (-60.0, 85.0)
"""Elevation angles of the raster; horizons from inside gorges rise above 50 degrees."""

ABOVE_FRAME_DEG = 10.0
"""Largest distance above the picture at which a horizon counts as leaving the frame."""


@dataclass(frozen=True)
class SearchOptions:
    """Grid of the coarse search.

    Attributes
    ----------
    step_deg : float
        Step of the raster in azimuth and elevation [degrees].
    tolerance_deg : float
        Blur of the evidence [degrees].
    pitch_step_deg : float
        Pitch between resamplings; smaller changes of pitch are shifts of the raster [degrees].
    largest_roll_deg : float
        Largest trial roll to either side [degrees]; the field of view determines their spacing (`rolls_deg`).
    roll, effective_columns : RollPrior, float
        As in `RefineOptions`.
    keep, separation_deg : int, float
        Number of candidates returned, and the smallest distance between them [degrees].
    narrow_deg : float
        Fields of view below this, and skylines whose relief is below a step, are searched at half the step (a quarter
        if the relief is below half a step, as over the sea) with more and closer candidates: they span few steps, and
        if a rival is missed, a wrong answer looks certain.
    """

    step_deg: float = 0.4
    tolerance_deg: float = 0.3
    pitch_step_deg: float = 3.0
    largest_roll_deg: float = 15.0
    roll: RollPrior = RollPrior()
    effective_columns: float = EFFECTIVE_COLUMNS
    keep: int = 60
    separation_deg: float = 2.0
    narrow_deg: float = 24.0

    def for_picture(self, hfov_deg, relief_deg):
        """Options for a picture's field of view and the relief of its skyline."""
        fine = hfov_deg < self.narrow_deg or relief_deg < self.step_deg
        halvings = 2 if relief_deg < 0.5 * self.step_deg else int(fine)
        if not halvings:
            return self
        return replace(
            self,
            step_deg=0.5**halvings * self.step_deg,
            tolerance_deg=0.67**halvings * self.tolerance_deg,
            keep=int(1.5**halvings * self.keep),
            separation_deg=0.75**halvings * self.separation_deg,
        )

    def rolls_deg(self, hfov_deg):
        """Trial rolls for a picture's field of view: half a step tilts the skyline by about 1.25 tolerances (rms).

        Between trials farther apart, one side of a wide horizon would rise and the other sink beyond the tolerance.
        """
        columns_rms_deg = hfov_deg / np.sqrt(12)
        half_step = np.degrees(np.arctan(1.25 * self.tolerance_deg / columns_rms_deg))
        count = max(int(np.ceil(self.largest_roll_deg / (2 * half_step))), 1)
        return np.linspace(-self.largest_roll_deg, self.largest_roll_deg, 2 * count + 1)

    def __post_init__(self):
        if not 0 < self.step_deg <= 2 or not self.largest_roll_deg > 0 or self.keep < 1:
            raise ValueError(f"unusable search grid {self}")


@dataclass(frozen=True, eq=False)
class CoarseResult:
    """Scores of the coarse search.

    Attributes
    ----------
    heading_deg, score, pitch_deg, roll_deg : (N,) arrays
        Best score over pitch and roll for every heading of the grid, and its pitch and roll [degrees].
    candidates : (K, 3) array
        Heading, pitch, roll of distinct peaks, best first [degrees].
    """

    heading_deg: np.ndarray
    score: np.ndarray
    candidates: np.ndarray
    pitch_deg: np.ndarray
    roll_deg: np.ndarray


@dataclass(frozen=True, eq=False)
class DrawnHorizon:
    """Horizon drawn as a line in the azimuth-elevation raster, prepared for the correlation.

    Attributes
    ----------
    spectrum : (rows, N // 2 + 1) complex array
        Fourier transform of the raster's rows along the azimuth.
    held_rows : tuple of int
        First and last row that hold any of the line.
    step_deg : float
        As in `SearchOptions`.
    """

    spectrum: np.ndarray
    held_rows: tuple
    step_deg: float


def coarse_search(stack, camera, curves, options=SearchOptions(), belief=None, progress=SILENT):  # noqa: B008 - frozen
    """Score all headings and pitches against one or several horizons.

    Parameters
    ----------
    stack : EvidenceStack
    camera : Camera
        Of the reduced picture.
    curves : sequence of HorizonCurve
        One for each hypothesis of the eye.
    options : SearchOptions
    belief : callable or None
        Headings (N,) [degrees] -> what is added to their scores when candidates are chosen, and only then.
    progress : Progress

    Returns
    -------
    list of CoarseResult, one for each horizon
    """
    step = options.step_deg
    heading = np.arange(int(round(360 / step))) * step
    elevations = [curve.elevation_at(heading) for curve in curves]
    drawn = [
        _drawn(elevation, step, curve.known[curve.nearest(heading)]) for elevation, curve in zip(elevations, curves)
    ]
    evidence = stack.at_tolerance(max(1.0, np.radians(options.tolerance_deg) * camera.focal_px))
    # An additional row stands for everything above the picture.
    evidence = np.vstack([stack.above_frame[None], evidence]).astype(np.float32)
    pitches = _trial_pitches(stack.probability, camera, np.concatenate(elevations), options.pitch_step_deg)
    best = [_Best(heading) for _ in curves]
    for index, pitch in enumerate(pitches):
        checkpoint(progress, index / len(pitches))
        for roll in options.rolls_deg(camera.hfov_deg):
            trial, cost = Pose(0.0, pitch, roll), options.roll.cost(roll) / options.effective_columns
            found = _correlate(evidence, camera, trial, drawn, options.pitch_step_deg)
            for one, (scores, shifts) in zip(best, found):
                one.add(trial, (scores - cost, shifts))
    return [one.result(options, belief) for one in best]


class _Best:
    """Best score over pitch and roll of every heading, with that pitch and roll."""

    def __init__(self, heading_deg):
        self.heading_deg, count = heading_deg, len(heading_deg)
        self.step_deg, self.score = heading_deg[1] - heading_deg[0], np.full(count, -np.inf)
        self.pitch_deg, self.roll_deg = np.zeros(count), np.zeros(count)

    def add(self, trial, found):
        """Take the scores (shifts, N) around one trial, and their shifts of its pitch, where they are better."""
        scores, shifts = found
        winner = scores.argmax(axis=0)
        top = scores[winner, np.arange(scores.shape[1])]
        better = top > self.score
        self.score[better] = top[better]
        self.pitch_deg[better] = trial.pitch_deg + shifts[winner[better]] * self.step_deg
        self.roll_deg[better] = trial.roll_deg

    def result(self, options, belief):
        wanted = self.score if belief is None else self.score + belief(self.heading_deg)
        peaks = distinct_peaks(self.heading_deg, wanted, options.keep, options.separation_deg)
        candidates = np.column_stack([self.heading_deg[peaks], self.pitch_deg[peaks], self.roll_deg[peaks]])
        return CoarseResult(self.heading_deg, self.score, candidates, self.pitch_deg, self.roll_deg)


def distinct_peaks(heading_deg, score, keep, separation_deg):
    """Indices of the best headings on a regular circle, best first.

    Parameters
    ----------
    heading_deg, score : (N,) arrays
        The circle in equal steps; scores of -inf are never chosen.
    keep : int
        Largest number of headings.
    separation_deg : float
        Smallest distance between two of them, across north as elsewhere [degrees].
    """
    remaining = np.array(score, float)
    step = 360.0 / len(remaining)
    reach = int(np.ceil(separation_deg / step)) - 1
    peaks = []
    while len(peaks) < keep:
        peak = int(remaining.argmax())
        if not np.isfinite(remaining[peak]):
            break
        peaks.append(peak)
        remaining[np.arange(peak - reach, peak + reach + 1) % len(remaining)] = -np.inf
    return np.array(peaks, int)


def _drawn_line(elevation_deg, step, known):
    """Draw the horizon as a line one pixel wide, shared between the two nearest rows; (rows, N) float32."""
    low, high = ELEVATION_RANGE_DEG
    rows = int((high - low) / step)
    position = np.clip((elevation_deg - low) / step, 0, rows - 2)
    first = position.astype(int)
    fraction = position - first
    line = np.zeros((rows, len(elevation_deg)), np.float32)
    azimuth = np.arange(len(elevation_deg))
    line[first, azimuth] = (1 - fraction) * known
    line[first + 1, azimuth] = fraction * known
    return line


def _rows_held(line):
    """First and last row that hold any of the horizon; the others cannot contribute to the correlation."""
    rows = np.flatnonzero(line.any(axis=1))
    return (int(rows[0]), int(rows[-1])) if len(rows) else (0, 0)


def _trial_pitches(probability, camera, elevation_deg, pitch_step_deg):
    """Pitches at which the rows with evidence fall on elevations of the horizon."""
    mass = probability.sum(axis=1)
    share = np.cumsum(mass) / mass.sum()
    top, bottom = np.searchsorted(share, [0.03, 0.97])
    _, centre_y = camera.centre_px
    above = np.degrees(np.arctan((centre_y - top) / camera.focal_px))
    below = np.degrees(np.arctan((centre_y - bottom) / camera.focal_px))
    low = np.percentile(elevation_deg, 2) - above
    high = np.percentile(elevation_deg, 98) - below
    count = max(int(np.ceil((high - low) / pitch_step_deg)), 1)
    return np.clip(low + (np.arange(count) + 0.5) * (high - low) / count, -60.0, 60.0)


def _correlate(evidence, camera, trial, drawn, pitch_step_deg):
    """Scores (shifts, N) of all headings for pitches around one trial, and the shifts in rows, for each drawn horizon.

    The first row of `evidence` stands for everything above the picture; the trial is a `Pose` of heading 0.
    """
    step = drawn[0].step_deg
    held = min(line.held_rows[0] for line in drawn), max(line.held_rows[1] for line in drawn)
    height, width = evidence.shape[0] - 1, evidence.shape[1]
    half_diagonal = np.degrees(np.arctan(np.hypot(width, height) / 2 / camera.focal_px))
    reach = int(np.ceil((half_diagonal + 1) / step))
    offset = np.arange(-reach, reach + 1) * step
    rows, count = drawn[0].spectrum.shape[0], (drawn[0].spectrum.shape[1] - 1) * 2
    half_height = np.degrees(np.arctan(height / 2 / camera.focal_px))
    low = ELEVATION_RANGE_DEG[0]
    half = int(np.ceil(pitch_step_deg / 2 / step))
    shifts = np.arange(-half, half + 1)
    first = max(int(np.floor((trial.pitch_deg - half_height - 4 - low) / step)), held[0] - half)
    last = min(int(np.ceil((trial.pitch_deg + half_height + ABOVE_FRAME_DEG - low) / step)), held[1] + half)
    first, last = max(first, 0), min(last, rows - 1)
    if first > last:
        return [(np.zeros((len(shifts), count), np.float32), shifts)] * len(drawn)
    elevation = low + np.arange(first, last + 1) * step
    x, y = project(camera, trial, offset[None, :], elevation[:, None])
    y = np.maximum(y + EDGE_ROW, -1) + 1
    seen = imaging.sample_bilinear(evidence, np.nan_to_num(x, nan=-9), np.nan_to_num(y, nan=-9))
    # d(column)/d(azimuth): every picture column counts the same.
    seen *= (np.radians(step) * camera.focal_px / np.cos(np.radians(offset)) ** 2 / width)[None, :]
    raster = np.zeros((len(elevation), count), np.float32)
    raster[:, np.arange(-reach, reach + 1) % count] = seen
    spectrum = np.conj(fft.rfft(raster, axis=1))
    return [(_correlated(line.spectrum, spectrum, first, shifts, count), shifts) for line in drawn]


def _correlated(line, spectrum, first, shifts, count):
    """Circular correlation (shifts, count) along the azimuth, summed over the rows at which both are known."""
    rows, last = line.shape[0], first + len(spectrum) - 1
    product = np.zeros((len(shifts), spectrum.shape[1]), np.complex64)
    for index, shift in enumerate(shifts):
        start, stop = max(first + shift, 0), min(last + 1 + shift, rows)
        part = slice(start - shift - first, stop - shift - first)
        product[index] = np.einsum("ea,ea->a", line[start:stop], spectrum[part])
    return fft.irfft(product, n=count, axis=1)


def _drawn(elevation_deg, step, known):
    """The `DrawnHorizon` of elevation angles in steps of azimuth."""
    line = _drawn_line(elevation_deg, step, known)
    return DrawnHorizon(fft.rfft(line, axis=1), _rows_held(line), step)
