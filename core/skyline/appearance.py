"""Measure edges, long edges, texture and colour at each pixel of a reduced picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base import imaging

EDGE_SIGMAS_PX = (0.8, 1.6, 3.2, 6.4)
LINES_PX = ((6, 1.0, 2), (12, 1.5, 4))
"""Half length, blur and spacing of the samples along the lines on which long edges are sought [pixels]."""

SLOPES = (-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0)


@dataclass(frozen=True, eq=False)
class Appearance:
    """Per-pixel measurements of one reduced picture, each (H, W) unless stated otherwise.

    Attributes
    ----------
    lab : (H, W, 3) array
        CIE L*a*b*.
    texture : array
        Log of the local contrast.
    edges : dict of float to array
        Log of the colour gradient in units of the picture's own noise, by the blur's sigma [pixels].
    long_edges : dict of int to array
        The same for gradients that keep their sign along a line, by the line's half length [pixels].
    colour : (H, W, 4) array
        Input of the colour model: slightly blurred L*a*b* and texture.
    """

    lab: np.ndarray
    texture: np.ndarray
    edges: dict
    long_edges: dict
    colour: np.ndarray

    @property
    def edge(self):
        """Mean of the three finest edge maps: one measure of the strength of an edge."""
        return sum(self.edges[sigma] for sigma in EDGE_SIGMAS_PX[:3]) / 3


def measure(rgb):
    """Measure edges, texture and colour of a reduced RGB picture, (H, W, 3), 0 to 255."""
    lab = imaging.rgb_to_lab(rgb)
    edges = {sigma: _edge_strength(lab, sigma) for sigma in EDGE_SIGMAS_PX}
    long_edges = {half: _long_edge_strength(lab, half, sigma, step) for half, sigma, step in LINES_PX}
    lightness = np.ascontiguousarray(lab[..., 0])
    fine = lightness - imaging.gaussian_blur(lightness, 2.0)
    texture = np.log(np.sqrt(np.maximum(imaging.box_mean(fine * fine, 7, 7), 0)) + 0.15)
    colour = np.dstack([imaging.gaussian_blur(lab, 1.0), texture]).astype(np.float32)
    return Appearance(lab, texture, edges, long_edges, colour)


def _step_down(blurred):
    """Difference of each row from the one above it, 0 in the first."""
    down = np.zeros_like(blurred)
    np.subtract(blurred[1:], blurred[:-1], out=down[1:])
    return down


def _edge_strength(lab, sigma_px):
    """Log of the gradient across a nearly level boundary, in units of the quietest tenth of the picture."""
    blurred = imaging.gaussian_blur(lab, sigma_px)
    down = _step_down(blurred)
    across = np.zeros_like(blurred)
    across[:, 1:-1] = (blurred[:, 2:] - blurred[:, :-2]) / 2
    square = np.einsum("ijk,ijk->ij", down, down) + 0.5 * np.einsum("ijk,ijk->ij", across, across)
    strength = np.sqrt(square) * sigma_px
    return np.log1p(strength / (np.percentile(strength, 10) + 1.3)).astype(np.float32)


def _long_edge_strength(lab, half_px, sigma_px, step_px):
    """Log of the largest mean gradient along a line through the pixel, over lines of several slopes.

    The gradients are averaged as vectors in colour space, so that rock texture cancels out and a faint ridge against
    haze adds up.
    """
    down = _step_down(imaging.gaussian_blur(lab, sigma_px))
    height, width = down.shape[:2]
    padded = np.pad(down, ((half_px, half_px), (half_px, half_px), (0, 0)), mode="edge")
    strongest = np.zeros((height, width), np.float32)
    samples = range(-half_px, half_px + 1, step_px)
    total = np.empty_like(down)
    for slope in SLOPES:
        length = np.hypot(1, slope)
        total[:] = 0
        for along in samples:
            x, y = half_px + round(along / length), half_px + round(along * slope / length)
            total += padded[y : y + height, x : x + width]
        np.maximum(strongest, np.einsum("ijk,ijk->ij", total, total), out=strongest)
    mean = np.sqrt(strongest) / len(samples)
    return np.log1p(mean / (np.percentile(mean, 10) + 0.4)).astype(np.float32)
