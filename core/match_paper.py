"""The heading search as published: linear angles, a shift for the tilt, normalised cross-correlation.

E. Twarog, "Skyline-Based Camera Orientation Estimation and Directed Viewshed Computation from Geotagged Mountain
Photography", steps 4 and 5, equations 5 to 8.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .camera import Camera, Pose, focal_of_fov_px
from .model import Candidate, Orientation
from .progress import SILENT, checkpoint

SIDELOBE_EXCLUSION_DEG = 5.0
"""Neighbourhood of the peak that is not counted among its sidelobes."""


@dataclass(frozen=True)
class PaperMatchOptions:
    """Parameters of the published search.

    Attributes
    ----------
    heading_step_deg : float
        The paper's 0.5.
    peak_separation_deg : float
        A second peak is a local maximum at least this far from the first (ours; the paper does not define it).
    min_valid_share : float
        Fewer columns with a skyline than this share are refused (ours).
    """

    heading_step_deg: float = 0.5
    peak_separation_deg: float = 5.0
    min_valid_share: float = 0.3

    def __post_init__(self):
        if not 0 < self.heading_step_deg <= 30:
            raise ValueError(f"the heading step must lie between 0 and 30 degrees, not {self.heading_step_deg}")


def skyline_angles(skyline, hfov_deg, vfov_deg):
    """Offsets and elevations of a skyline by the paper's linear model.

    Returns
    -------
    offset_deg : (W,) array
        phi(x) = (2 x - (W - 1)) / (W - 1) * HFOV / 2, equation 5 [degrees right of the axis].
    elevation_deg : (W,) array
        e(x) = ((H - 1) / 2 - p) / ((H - 1) / 2) * VFOV / 2, equation 6 [degrees above the axis].
    """
    last_x, half_y = skyline.width_px - 1, (skyline.height_px - 1) / 2
    column = np.arange(skyline.width_px)
    offset = (2 * column - last_x) / last_x * hfov_deg / 2
    return offset, (half_y - np.asarray(skyline.row_px, float)) / half_y * vfov_deg / 2


def match_paper(skyline, hfov_deg, vfov_deg, horizon, options=PaperMatchOptions(), progress=SILENT):
    """Find the heading whose stretch of horizon has the skyline's shape.

    Parameters
    ----------
    skyline : model.Skyline
        On the full picture, or on a reduced one of the same aspect.
    hfov_deg, vfov_deg : float
        By the paper's rule, `camera.paper_fov_deg` [degrees].
    horizon : model.HorizonProfile
    options : PaperMatchOptions
    progress : Progress

    Returns
    -------
    model.Orientation
        Status 'ambiguous' at best, because the method has no test of its own answer: an NCC of 0.97 with a wrong
        heading is common. The whole NCC curve is kept.

    Notes
    -----
    `sharpness` is the peak-to-sidelobe ratio [1]_: (peak - mean) / standard deviation, of the curve outside the
    peak's neighbourhood.

    References
    ----------
    .. [1] Bolme et al., Visual object tracking using adaptive correlation filters, CVPR 2010,
       doi:10.1109/CVPR.2010.5539960.
    """
    valid = np.asarray(skyline.valid) & np.isfinite(skyline.row_px)
    if valid.mean() < options.min_valid_share:
        return Orientation("rejected", _too_little(valid.mean()))
    offset, elevation = skyline_angles(skyline, hfov_deg, vfov_deg)
    heading = np.arange(0.0, 360.0, options.heading_step_deg)
    curve, tilt = correlate(heading, offset[valid], elevation[valid], horizon, progress)
    if not np.isfinite(curve).any():
        return Orientation("rejected", "The skyline or the DEM's horizon is a straight line, which cannot be matched.")
    peaks = curve_peaks(heading, curve, options.peak_separation_deg)
    camera = Camera(skyline.width_px, skyline.height_px, focal_of_fov_px(skyline.width_px, hfov_deg))
    candidates = tuple(Candidate(Pose(float(heading[i]), float(tilt[i])), camera, float(curve[i])) for i in peaks[:3])
    first, second = curve[peaks[0]], curve[peaks[1]] if len(peaks) > 1 else None
    return Orientation(
        "ambiguous",
        "The paper's method does not test its answer: compare the overlay, or use the robust method.",
        candidates,
        curve_heading_deg=heading,
        curve_score=curve,
        ncc=float(first),
        ncc_second=None if second is None else float(second),
        sharpness=sharpness(heading, curve, heading[peaks[0]]),
    )


def correlate(heading_deg, offset_deg, elevation_deg, horizon, progress=SILENT):
    """NCC (equation 8) and tilt (equation 7) of a skyline against the horizon at every heading.

    Returns
    -------
    ncc : (N,) array
        -1 to 1; NaN where the horizon is unknown along more than half of the skyline, or straight.
    tilt_deg : (N,) array
        Mean of horizon minus skyline: the pitch of the axis, + upwards [degrees].
    """
    ncc, tilt = np.full(len(heading_deg), np.nan), np.full(len(heading_deg), np.nan)
    size = len(horizon.azimuth_deg)
    step = 360.0 / size
    for start in range(0, len(heading_deg), 32):
        checkpoint(progress, start / len(heading_deg))
        part = slice(start, start + 32)
        position = np.mod(heading_deg[part, None] + offset_deg, 360.0) / step
        low = position.astype(np.intp) % size
        fraction = position - np.floor(position)
        seen = horizon.elevation_deg[low] * (1 - fraction) + horizon.elevation_deg[(low + 1) % size] * fraction
        ncc[part], tilt[part] = _ncc(elevation_deg, seen)
    return ncc, tilt


def _ncc(image, seen):
    """Equation 8 along the last axis, over the places where both are known; and equation 7."""
    known = np.isfinite(seen)
    count = np.maximum(known.sum(axis=-1), 1)
    seen = np.where(known, seen, 0.0)
    image = np.where(known, image, 0.0)
    mean_seen, mean_image = seen.sum(axis=-1) / count, image.sum(axis=-1) / count
    a = np.where(known, image - mean_image[..., None], 0.0)
    b = np.where(known, seen - mean_seen[..., None], 0.0)
    norm = np.sqrt(np.square(a).sum(axis=-1) * np.square(b).sum(axis=-1))
    usable = (norm > 1e-9 * count) & (2 * count > seen.shape[-1])
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(usable, (a * b).sum(axis=-1) / norm, np.nan), mean_seen - mean_image


def correlation(a, b):
    """NCC (equation 8) of two curves, or None where one is straight or both are short."""
    if len(a) < 10:
        return None
    ncc, _ = _ncc(np.asarray(a, float), np.asarray(b, float))
    return float(ncc) if np.isfinite(ncc) else None


def curve_peaks(heading_deg, curve, separation_deg):
    """Indices of the curve's highest point and of further local maxima, at least `separation_deg` apart."""
    filled = np.where(np.isfinite(curve), curve, -np.inf)
    local = (filled >= np.roll(filled, 1)) & (filled >= np.roll(filled, -1)) & np.isfinite(curve)
    order = np.flatnonzero(local)[np.argsort(-filled[local], kind="stable")]
    kept = []
    for index in order:
        turn = np.abs((heading_deg[kept] - heading_deg[index] + 180) % 360 - 180) if kept else np.zeros(0)
        if (turn >= separation_deg).all():
            kept.append(int(index))
    return kept


def sharpness(heading_deg, curve, peak_deg):
    """Peak-to-sidelobe ratio of a curve over the circle, or None where it has no sidelobes."""
    away = np.abs((heading_deg - peak_deg + 180) % 360 - 180) > SIDELOBE_EXCLUSION_DEG
    lobes = curve[away & np.isfinite(curve)]
    if len(lobes) < 2 or lobes.std() == 0:
        return None
    peak = np.nanmax(np.where(away, np.nan, curve))
    return float((peak - lobes.mean()) / lobes.std())


def _too_little(share):
    return (
        f"A skyline was found in only {100 * share:.0f} % of the columns. Use a photo that shows more of the skyline, "
        "or supply a sky mask or a drawn skyline."
    )
