"""Estimate from the skylines of a camera's photographs how far its compass can be trusted.

A phone whose compass has lost its calibration is wrong in nearly all photographs, another phone in hardly any, so the
share of worthless readings belongs to the camera. For each photograph, `support` gives how much likelier its skyline is
if the reading is right than if it is worthless; `worthless_share` combines the ratios (Bayes' rule with a Beta prior).
"""

from __future__ import annotations

import numpy as np
from scipy.special import expit

from ..base.angles import difference

FEWEST_READINGS = 4
"""With fewer readings than this, the share of a camera stays as it is."""

KNOWN_READINGS = 1.0
"""Weight of the usual share [readings]. It is small because cameras differ: their shares lie near 0 or near 1."""

LARGEST_SHARE = 0.9
"""No share is larger: a steel roof may have misled the compass in the photographs that tested it."""


def support(photo, density, usual):
    """How much likelier the skyline is if the photograph's compass is right than if its reading is worthless.

    Parameters
    ----------
    photo : OrientedPhoto
        Oriented with the compass as a hint.
    density : callable
        Reading [degrees], headings (K,) [degrees] -> density of the heading over the uniform one, as it was used.
    usual : float
        Share of worthless readings in it.

    Returns
    -------
    float or None
        Ratio of likelihoods; 1 if the skyline decides nothing. None if there is no reading, or no answer with
        probabilities.
    """
    reading, candidates = photo.compass_true_deg, photo.orientation.candidates
    if reading is None or not candidates or any(candidate.probability is None for candidate in candidates):
        return None
    heading = np.array([candidate.pose.heading_deg for candidate in candidates])
    fitted = np.abs(difference(heading, reading)) > 1e-6  # the reading itself is among the answers
    probability, heading = np.array([candidate.probability for candidate in candidates])[fitted], heading[fitted]
    ratio = density(reading, heading)
    alone, none = probability / ratio, max(1 - float(probability.sum()), 0.0)  # takes the hint out of the answers
    total = float(alone.sum()) + none
    if total <= 0:
        return None
    right = np.maximum(ratio - usual, 0) / (1 - usual)
    return float((alone @ right + none) / total)


def worthless_share(supports, usual):
    """Expected share of worthless readings of one camera.

    Parameters
    ----------
    supports : sequence of float
        From `support`, of photographs of the camera.
    usual : float
        Expected share before any photograph is considered.

    Returns
    -------
    float
        Rounded to tenths, so that one photograph more hardly ever changes it; between `usual` and `LARGEST_SHARE`.
    """
    if len(supports) < FEWEST_READINGS:
        return usual
    # On a scale of log-odds, on which the Beta distribution has no poles at 0 and 1.
    odds = np.linspace(-100, 100, 4001)
    share = expit(odds)
    log_weight = KNOWN_READINGS * (-usual * np.logaddexp(0, -odds) - (1 - usual) * np.logaddexp(0, odds))
    for value in supports:
        log_weight = log_weight + np.log(share + expit(-odds) * value)
    weight = np.exp(log_weight - log_weight.max())
    expected = float(weight @ share / weight.sum())
    return float(np.clip(round(expected, 1), usual, LARGEST_SHARE))


def shares_of(photos, density, usual):
    """Cameras whose compasses are worse than usual, with their shares of worthless readings.

    Parameters
    ----------
    photos : iterable of OrientedPhoto
        Oriented with the compass as a hint.
    density, usual : callable, float
        As for `support`.

    Returns
    -------
    tuple of (str, float)
        By `PhotoMetadata.camera`, sorted.
    """
    told: dict = {}
    for photo in photos:
        value = support(photo, density, usual)
        if value is not None and photo.metadata is not None and photo.metadata.camera:
            told.setdefault(photo.metadata.camera, []).append(value)
    shares = {device: worthless_share(values, usual) for device, values in told.items()}
    return tuple(sorted((device, share) for device, share in shares.items() if share > usual))
