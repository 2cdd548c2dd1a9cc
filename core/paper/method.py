"""Run the published method from a photograph to a heading: field of view, skyline, search.

E. Twarog, "Skyline-Based Camera Orientation Estimation and Directed Viewshed Computation from Geotagged Mountain
Photography". The numbers of equations and sections in this package refer to that paper.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..base.camera import fov_of_focal_deg
from ..base.progress import SILENT, subtask
from .horizon import PaperHorizonOptions
from .match import PaperMatchOptions, match_paper
from .skyline import PaperSkylineOptions, extract_skyline_paper


@dataclass(frozen=True)
class PaperOptions:
    """All options of the published method.

    Attributes
    ----------
    skyline, horizon, match : PaperSkylineOptions, PaperHorizonOptions, PaperMatchOptions
        Options of the stages.
    """

    skyline: PaperSkylineOptions = field(default_factory=PaperSkylineOptions)
    horizon: PaperHorizonOptions = field(default_factory=PaperHorizonOptions)
    match: PaperMatchOptions = field(default_factory=PaperMatchOptions)


def paper_fov_deg(width_px, height_px, focal_length_35mm):
    """Fields of view by the paper's rule.

    Equation 1, HFOV = 2 atan(36 / (2 f35)), with 36 mm along the picture's long side and 24 mm along the short
    one whatever its aspect, as the published 74 and 53 degrees at f35 = 24 mm show.

    Parameters
    ----------
    width_px, height_px : int
        Size of the upright picture [pixels].
    focal_length_35mm : float
        35 mm equivalent of the focal length [mm].

    Returns
    -------
    hfov_deg, vfov_deg : float
        Horizontal and vertical field of view [degrees].
    """
    long_deg = fov_of_focal_deg(36.0, focal_length_35mm)
    short_deg = fov_of_focal_deg(24.0, focal_length_35mm)
    return (long_deg, short_deg) if width_px >= height_px else (short_deg, long_deg)


def orient_by_paper(photo, camera, horizon, options=PaperOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Find the heading of one photograph by the published method.

    Parameters
    ----------
    photo : Photo
        Photograph at full resolution, for which the paper's parameters are meant.
    camera : Camera
        Gives the fields of view if the photograph records no 35 mm equivalent.
    horizon : HorizonProfile
        See `core.paper.horizon.paper_horizon`.
    options : PaperOptions
    progress : Progress

    Returns
    -------
    orientation : Orientation
    skyline : Skyline

    Raises
    ------
    SkylineNotFoundError
        No column of the photograph has a transition from sky to terrain.
    """
    metadata = photo.metadata
    skyline = extract_skyline_paper(photo.pixels, options.skyline)
    if metadata.focal_length_35mm is None:
        fov_deg = camera.hfov_deg, camera.vfov_deg
    else:
        fov_deg = paper_fov_deg(metadata.width_px, metadata.height_px, metadata.focal_length_35mm)
    return match_paper(skyline, *fov_deg, horizon, options.match, subtask(progress, 0.5, 1.0)), skyline
