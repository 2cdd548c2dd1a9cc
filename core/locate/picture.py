"""A picture's skyline evidence, prepared for the comparison with many horizons at all headings and pitches.

For an assumed pitch, roll and focal length, the evidence is resampled from the picture to azimuth and elevation by the
pinhole model. A heading is then a shift in azimuth, and a further pitch is nearly a shift in elevation. Along the
elevation the raster is kept as a short Fourier series: the score of a horizon at one azimuth is then a sum over a few
harmonics, and the scores at all headings are a few correlations along the azimuth.

The score of a column saturates, as that of `core.match.likelihood` does: a column whose skyline is a cloud or a tree
costs no more than a column without information.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import fft, ndimage

from ..base import imaging
from ..base.camera import Camera, Pose, focal_of_fov_px, project

EDGE_ROW = 0.5
"""Rows of evidence are first terrain pixels: their upper edge is half a row above."""

ROWS_PER_HARMONIC = 3
"""Rows of the raster per harmonic; at least two."""

FOCAL_STEP = 0.07
"""Step of the log focal lengths that are tried if the field of view is not known."""

MARGIN = 1.08
"""The raster reaches this much farther than half the field of view, for pitched and rolled pictures."""


@dataclass(frozen=True)
class PictureOptions:
    """How the evidence is compared.

    Attributes
    ----------
    step_deg : float
        Step of the headings [degrees]; the azimuths of the index must be a multiple.
    period_deg : float
        Range of elevation angles that the Fourier series covers before it repeats [degrees].
    harmonics : int
        Number of harmonics; with the period they limit the resolution in elevation.
    tolerance_deg : float
        Blur of the evidence [degrees].
    outlier_share : float
        Share of the columns whose boundary is something other than the horizon.
    horizon_deg : tuple of float
        Assumed elevation angles of the horizon in the middle of the picture; with the row of the skyline they give
        the pitch [degrees]. Farther off, a change of pitch is not a plain shift in a wide picture.
    rolls_deg : tuple of float
        Assumed rolls [degrees]. A wide picture that is rolled by 5 degrees fits hardly better at the true heading than
        at others if no roll is assumed.
    """

    step_deg: float = 1.0
    period_deg: float = 32.0
    harmonics: int = 24
    tolerance_deg: float = 0.35
    outlier_share: float = 0.3
    horizon_deg: tuple = (6.0,)
    rolls_deg: tuple = (-5.0, -2.5, 0.0, 2.5, 5.0)


@dataclass(frozen=True, eq=False)
class Hypothesis:
    """Evidence resampled for one assumed pitch, roll and focal length.

    Attributes
    ----------
    pitch_deg, roll_deg : float
    log_focal : float
        Logarithm of the focal length relative to the camera's.
    spectrum : (harmonics, headings) complex64 array
        Conjugate of the transform along the azimuth.
    constant : float
        Mean over the elevation, summed over the columns: the score of a horizon of unknown elevation.
    """

    pitch_deg: float
    roll_deg: float
    log_focal: float
    spectrum: np.ndarray
    constant: float


def hypotheses(evidence, camera, options=PictureOptions(), log_focals=(0.0,)):  # noqa: B008 - frozen
    """Prepare a picture under all assumed pitches, rolls and focal lengths.

    Parameters
    ----------
    evidence : SkylineEvidence
    camera : Camera
        At any scale.
    options : PictureOptions
    log_focals : sequence of float
        Logarithms of the focal lengths to assume, relative to the camera's.

    Returns
    -------
    list of Hypothesis
    """
    height, width = evidence.probability.shape
    camera = camera.scaled(width, height)
    found = []
    for log_focal in log_focals:
        lens = replace(camera, focal_px=float(camera.focal_px * np.exp(log_focal)))
        value = _value(evidence.probability, lens, options)
        for horizon_deg in options.horizon_deg:
            for roll_deg in options.rolls_deg:
                found.append(_resampled(value, evidence, (lens, log_focal), (horizon_deg, roll_deg), options))
    return found


def unknown_lens(width_px, height_px, limits_deg):
    """Camera in the middle of the fields of view to try, the spread of its log focal length, and the values to try.

    Parameters
    ----------
    width_px, height_px : int
        Size of the upright picture [pixels].
    limits_deg : (float, float)
        Narrowest and widest field of view [degrees].
    """
    wide, narrow = (np.log(focal_of_fov_px(width_px, limit)) for limit in sorted(limits_deg, reverse=True))
    half = (narrow - wide) / 2
    count = int(np.ceil(2 * half / FOCAL_STEP)) + 1
    camera = Camera(width_px, height_px, float(np.exp((wide + narrow) / 2)))
    return camera, max(float(half), FOCAL_STEP), np.linspace(-half, half, count)


def _value(probability, camera, options):
    """Score of a horizon at each row of each column: 0 without information, and saturating."""
    tolerance_px = max(1.0, np.radians(options.tolerance_deg) * camera.focal_px)
    density = ndimage.gaussian_filter1d(probability, tolerance_px, axis=0, mode="constant") * len(probability)
    odds = (1 - options.outlier_share) / options.outlier_share
    return np.log1p(odds * np.maximum(density - 1, 0)).astype(np.float32)


def _resampled(value, evidence, lens, angles, options):
    camera, log_focal = lens
    horizon_deg, roll_deg = angles
    width = value.shape[1]
    rows = ROWS_PER_HARMONIC * options.harmonics
    spacing = options.period_deg / rows
    line_px = float(np.median(evidence.best.row_px))
    pitch_deg = horizon_deg - float(np.degrees(np.arctan((camera.centre_px[1] - line_px) / camera.focal_px)))
    pitch_deg = float(np.clip(pitch_deg, -75.0, 75.0))
    headings = int(round(360 / options.step_deg))
    reach = int(np.ceil(MARGIN * camera.hfov_deg / 2 / options.step_deg))
    offset = np.arange(-reach, reach + 1)
    offset_deg = offset * options.step_deg
    first_deg = horizon_deg - rows // 2 * spacing
    x, y = project(
        camera, Pose(0.0, pitch_deg, roll_deg), offset_deg[None], first_deg + spacing * np.arange(rows)[:, None]
    )
    seen = np.nan_to_num(imaging.sample_bilinear(value, np.nan_to_num(x, nan=-9), np.nan_to_num(y + EDGE_ROW, nan=-9)))
    # d(column)/d(azimuth): every column of the picture counts the same.
    share = np.radians(options.step_deg) * camera.focal_px / np.cos(np.radians(np.clip(offset_deg, -80, 80))) ** 2
    seen *= share / width
    harmonic = np.arange(1, options.harmonics + 1)[:, None]
    series = fft.fft(seen, axis=0)[1 : options.harmonics + 1]
    series = series * np.exp(-2j * np.pi * harmonic * first_deg / options.period_deg)
    around = np.zeros((options.harmonics, headings), np.complex64)
    for column, at in enumerate(offset % headings):  # a view of more than half the circle may meet itself
        around[:, at] += np.conj(series[:, column])
    spectrum = np.conj(fft.fft(around, axis=1)).astype(np.complex64)
    return Hypothesis(pitch_deg, roll_deg, float(log_focal), spectrum, float(seen.sum() / rows))
