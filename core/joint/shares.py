"""How much each photograph of tied ones adds to the evidence of those before it.

Two photographs of the same crest share the errors of the DEM, the clouds on it and whatever misled the skyline. What
both show must not count twice, or two wrong answers that agree would be taken for a right one.
"""

from __future__ import annotations

import numpy as np

from ..base.camera import project, unproject

COMMON = 0.7
"""Correlation of the evidence of two photographs in the part of the crest that both show."""
SAMPLES = 64


def evidence_weights(photos, poses, order):
    """Weights of the log-likelihoods of tied photographs.

    Parameters
    ----------
    photos : sequence of OrientedPhoto
    poses : dict of int to Pose
        Consistent with the ties, by the photographs' numbers.
    order : sequence of int
        Numbers of the photographs, the most certain first: it counts in full, and each one after it by the part of its
        skyline that those before it do not show.

    Returns
    -------
    dict of int to float
    """
    weights: dict = {}
    before: list = []
    for number in order:
        azimuth, elevation = _skyline_directions(photos[number], poses[number])
        covered = np.zeros(len(azimuth), bool)
        for other in before:
            covered |= _shows(photos[other].camera, poses[other], azimuth, elevation)
        weights[number] = 1.0 - COMMON * float(covered.mean())
        before.append(number)
    return weights


def _skyline_directions(photo, pose):
    camera, skyline = photo.camera, photo.skyline
    x = np.linspace(0, camera.width_px - 1, SAMPLES)
    y = np.full(SAMPLES, (camera.height_px - 1) / 2)
    if skyline is not None and skyline.valid.any():
        at = (x + 0.5) * skyline.width_px / camera.width_px - 0.5
        row = np.interp(at, np.flatnonzero(skyline.valid), skyline.row_px[skyline.valid])
        y = (row + 0.5) * camera.height_px / skyline.height_px - 0.5
    return unproject(camera, pose, x, y)


def _shows(camera, pose, azimuth_deg, elevation_deg):
    x, y = project(camera, pose, azimuth_deg, elevation_deg)
    with np.errstate(invalid="ignore"):
        return (x >= 0) & (x <= camera.width_px - 1) & (y >= 0) & (y <= camera.height_px - 1)
