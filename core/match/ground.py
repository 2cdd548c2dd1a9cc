"""Score how well the ground in the DEM explains the light and colour of the picture below the horizon.

At the right pose, brightness and colour follow the terrain: slopes facing the sun and facing away from it, snow on flat
and on high ground, haze over distant terrain. None of this needs to be known beforehand. By Lambert's law light is
linear in the surface normal, whatever the position of the sun. A multivariate regression of the picture on the normal,
distance and elevation of the ground therefore measures how much a pose explains beyond a plane fitted to the picture.
With E0 and E1 the cross products of the residuals without and with the ground, Wilks' statistic gives the log
likelihood ratio

    log L = n / 2 * log(|E0| / |E1|)

(Wilks 1932, doi:10.1093/biomet/24.3-4.471). Neighbouring pixels are far from independent; n is the number of
independent patches, in proportion to the share of the picture that shows ground.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base import imaging
from ..base.camera import unproject
from .geometry import lens_of, pose_of

LEAST_PIXELS = 60
"""Smallest number of ground pixels for which a pose is scored."""

RIDGE_SHARE = 1e-3
"""Ridge penalty of the regression, as a share of the attributes' variance."""


@dataclass(frozen=True)
class GroundMatchOptions:
    """Weight of the appearance of the ground.

    Attributes
    ----------
    weight : float
        Score per unit of log(|E0| / |E1|) / 2 for a picture full of ground; 0 switches it off.
    clearance_px : int
        Ground nearer to the sky or to unknown ground than this, up or down, is left out, since the pose is no more
        exact than that [pixels of the thumbnail].
    """

    weight: float = 6.0
    clearance_px: int = 2


class GroundEvidence:
    """Score of how well the visible ground explains a picture, for any pose.

    Parameters
    ----------
    picture : (h, w, 3) float array
        As returned by `core.base.imaging.thumbnail`.
    view : core.horizon.inner.GroundView
    options : GroundMatchOptions
    """

    def __init__(self, picture, view, options=GroundMatchOptions()):  # noqa: B008 - frozen
        self.view, self.options = view, options
        height, width = picture.shape[:2]
        self._x, self._y = np.meshgrid(np.arange(width, dtype=float), np.arange(height, dtype=float))
        light = np.log1p(np.asarray(picture, float))
        self._light = np.stack([light.mean(axis=2), light[..., 0] - light[..., 2]], axis=2)
        self._plane = np.stack([np.ones_like(self._x), self._x / width - 0.5, self._y / height - 0.5], axis=2)
        self._shown = np.isfinite(self._light).all(axis=2)

    def score(self, camera, trials):
        """Score of each trial, to be added to the skyline's; 0 if hardly any ground is in the frame.

        Parameters
        ----------
        camera : Camera
            Camera of the picture, at any scale.
        trials : (K, 5) array
            See `geometry.PARAMETERS`.
        """
        camera = camera.scaled(self._x.shape[1], self._x.shape[0])
        return self.options.weight * np.array([self._explained(camera, trial) for trial in trials])

    def _explained(self, camera, trial):
        """Share of the picture that is ground, times log(|E0| / |E1|) / 2."""
        ground = self.view.at(*unproject(lens_of(camera, trial), pose_of(trial), self._x, self._y))
        seen = np.isfinite(ground).all(axis=0) & self._shown
        seen = imaging.erode(seen, 1, 2 * self.options.clearance_px + 1)
        if seen.sum() < LEAST_PIXELS:
            return 0.0
        plane, _ = np.linalg.qr(self._plane[seen])
        light = _without(plane, self._light[seen])
        attributes = _without(plane, _regressors(ground[:, seen]))
        spread = np.sqrt(np.mean(attributes**2, axis=0))
        attributes = attributes[:, spread > 1e-6] / spread[spread > 1e-6]
        inner = attributes.T @ attributes + RIDGE_SHARE * len(attributes) * np.eye(attributes.shape[1])
        left = light - attributes @ np.linalg.solve(inner, attributes.T @ light)
        return float(seen.mean() * 0.5 * (_log_det(light) - _log_det(left)))


def _regressors(ground):
    """Attributes of the ground (N, 7); the squares model snow on gentle slopes and haze that levels off."""
    _, _, up, log_distance, _ = ground
    return np.concatenate([ground, [up**2, log_distance**2]]).T.astype(float)


def _without(basis, values):
    """Part of the columns that is orthogonal to an orthonormal basis."""
    return values - basis @ (basis.T @ values)


def _log_det(residual):
    """Log determinant of the cross products; the small addition covers a picture without contrast."""
    return np.linalg.slogdet(residual.T @ residual + 1e-6 * np.eye(residual.shape[1]))[1]
