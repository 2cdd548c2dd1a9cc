"""What a soft belief about the heading is worth, in units of log likelihood."""

from __future__ import annotations

import numpy as np

from .angles import difference


def log_ratio(prior, heading_deg):
    """Log of the prior's density over the uniform one, at headings [degrees].

    A Gaussian core, its copies at the prior's known faults (a phone held the other way turns its compass by 90
    degrees), and a uniform share: never below the log of that share, so that no prior can forbid an answer.
    """
    heading_deg = np.asarray(heading_deg, float)
    if prior is None:
        return np.zeros(heading_deg.shape)
    core_share = 1 - prior.outlier_share - sum(share for _, share in prior.faults)
    density = np.full(heading_deg.shape, float(prior.outlier_share))
    for turn, share in ((0.0, core_share), *prior.faults):
        density = density + share * _gaussian_ratio(difference(heading_deg, prior.heading_deg + turn), prior.sigma_deg)
    return np.log(np.maximum(density, 1e-12))


def _gaussian_ratio(turn_deg, sigma_deg):
    return 360 / (np.sqrt(2 * np.pi) * sigma_deg) * np.exp(-0.5 * np.square(turn_deg / sigma_deg))
