"""What photographs of one lens share: how much its focal length differs from the recorded one."""

from __future__ import annotations

import numpy as np

from ..base.camera import focal_from_35mm_px
from ..base.status import RELIABLE

LEAST_PHOTOS = 2
"""Accepted photographs of a lens that must tell its scale."""
LENS_SIGMA = 0.005
"""Spread of the scale between pictures of one lens: focus, stabilisation."""
USUAL_ERROR = 0.01
"""Error of a fitted focal length that is not known."""
MOST = 3.0
"""Largest weight of the lens for or against a candidate: other things shift a focal length too."""


def lens_ratios(photos, alones):
    """How much better or worse each candidate fits the lens than a candidate of unknown focal length would.

    Parameters
    ----------
    photos : sequence of OrientedPhoto
    alones : sequence of Alone or None

    Returns
    -------
    list of (K,) array
        Likelihood ratios.
    """
    scales = [_log_scales(photo, alone) for photo, alone in zip(photos, alones)]
    lenses: dict = {}
    for number, photo in enumerate(photos):
        if scales[number] is not None and len(scales[number]) and photo.status in RELIABLE:
            lenses.setdefault(_lens(photo), []).append(number)
    found = []
    for number, (photo, alone) in enumerate(zip(photos, alones)):
        ratio = np.ones(0 if alone is None else len(alone.candidates))
        others = [other for other in lenses.get(_lens(photo), ()) if other != number]
        if scales[number] is not None and len(others) >= LEAST_PHOTOS:
            known = np.array([scales[other][0] for other in others])
            errors = np.array([_error(photos[other]) for other in others])
            common = float(np.median(known))
            sigma = np.sqrt((1.25**2) * np.median(errors) ** 2 / len(others) + LENS_SIGMA**2 + _error(photo) ** 2)
            usual = np.hypot(photo.metadata.focal_sigma, _error(photo))
            log_ratio = _log_normal(scales[number] - common, sigma) - _log_normal(scales[number], usual)
            ratio = np.exp(np.clip(log_ratio, -np.log(MOST), np.log(MOST)))
        found.append(ratio)
    return found


def _log_scales(photo, alone):
    """Logarithm of the fitted over the recorded focal length, for each candidate; None without a recorded one."""
    if alone is None or photo.metadata is None or photo.metadata.focal_length_35mm is None:
        return None
    metadata = photo.metadata
    recorded = focal_from_35mm_px(metadata.width_px, metadata.height_px, metadata.focal_length_35mm)
    return np.log([candidate.camera.focal_px / recorded for candidate in alone.candidates] or [1.0])[
        : len(alone.candidates)
    ]


def _lens(photo):
    metadata = photo.metadata
    return metadata and (metadata.camera, metadata.focal_length_35mm, metadata.focal_length_mm)


def _error(photo):
    uncertainty = photo.orientation.uncertainty
    return USUAL_ERROR if uncertainty is None else uncertainty.focal_relative


def _log_normal(away, sigma):
    return -0.5 * np.square(away / sigma) - np.log(sigma)
