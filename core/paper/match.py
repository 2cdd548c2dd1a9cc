"""Search for the heading as published: linear angles, a shift for the tilt, normalised cross-correlation.

These are steps 4 and 5 of the paper, equations 5 to 8; `core.base.curves.row_ncc` computes equations 7 and 8.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.camera import Camera, Pose, focal_of_fov_px
from ..base.curves import curve_peaks, row_ncc, sharpness
from ..base.messages import Message
from ..base.model import Candidate, Orientation
from ..base.progress import SILENT, checkpoint


@dataclass(frozen=True)
class PaperMatchOptions:
    """Parameters of the published search.

    Attributes
    ----------
    heading_step_deg : float
        Step of the headings; the paper uses 0.5 [degrees].
    peak_separation_deg : float
        A second peak is a local maximum at least this far from the first (our choice; the paper does not define it).
    min_valid_share : float
        Smallest share of columns with a skyline that is accepted (our choice).
    """

    heading_step_deg: float = 0.5
    peak_separation_deg: float = 5.0
    min_valid_share: float = 0.3

    def __post_init__(self):
        if not 0 < self.heading_step_deg <= 30:
            raise ValueError(f"the heading step must lie between 0 and 30 degrees, not {self.heading_step_deg}")


def skyline_angles(skyline, hfov_deg, vfov_deg):
    """Offsets and elevations of a skyline by the paper's linear model.

    Parameters
    ----------
    skyline : Skyline
    hfov_deg, vfov_deg : float
        Fields of view of the picture [degrees].

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
    skyline : Skyline
        On the full picture, or on a reduced one of the same aspect.
    hfov_deg, vfov_deg : float
        Fields of view by the paper's rule, `core.paper.method.paper_fov_deg` [degrees].
    horizon : HorizonProfile
    options : PaperMatchOptions
    progress : Progress

    Returns
    -------
    Orientation
        Status 'ambiguous' at best, because the method does not test its own answer: an NCC of 0.97 with a wrong heading
        is common. The whole NCC curve is kept.

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
        return Orientation(
            "rejected",
            Message(
                "The skyline or the DEM's horizon is a straight line, which cannot be matched. Use a photo that "
                "shows a mountain skyline."
            ),
        )
    peaks = curve_peaks(heading, curve, options.peak_separation_deg)
    camera = Camera(skyline.width_px, skyline.height_px, focal_of_fov_px(skyline.width_px, hfov_deg))
    candidates = tuple(Candidate(Pose(float(heading[i]), float(tilt[i])), camera, float(curve[i])) for i in peaks[:3])
    first, second = curve[peaks[0]], curve[peaks[1]] if len(peaks) > 1 else None
    return Orientation(
        "ambiguous",
        Message("The paper method does not test its result. Check the overlay, or use the robust method."),
        candidates,
        curve_heading_deg=heading,
        curve_score=curve,
        ncc=float(first),
        ncc_second=None if second is None else float(second),
        sharpness=sharpness(heading, curve, heading[peaks[0]]),
    )


def correlate(heading_deg, offset_deg, elevation_deg, horizon, progress=SILENT):
    """NCC (equation 8) and tilt (equation 7) of a skyline against the horizon at every heading.

    Parameters
    ----------
    heading_deg : (N,) array
        [degrees]
    offset_deg, elevation_deg : (W,) arrays
        See `skyline_angles`; only columns that have a skyline.
    horizon : HorizonProfile
    progress : Progress

    Returns
    -------
    ncc : (N,) array
        -1 to 1; NaN if the horizon is unknown along more than half of the skyline, or straight.
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
        ncc[part], tilt[part] = row_ncc(elevation_deg, seen)
    return ncc, tilt


def _too_little(share):
    return Message(
        "A skyline was found in only {share} % of the columns. Use a photo that shows more of the skyline, "
        "or supply a sky mask or a drawn skyline.",
        share=f"{100 * share:.0f}",
    )
