"""What a search for places takes from the other rooms: lens, picture, the fit of a skyline, and exact horizons."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from .base.errors import MissingMetadataError, PhotoError
from .base.imaging import shrink_to
from .base.terrain import Observer
from .batch import PREVIEW_PX
from .horizon.horizon import HorizonOptions, horizon_profile
from .horizon.sector import sector_profile
from .io.photo import read_photo
from .locate.coarse import CoarseOptions
from .locate.fit import FitOptions
from .locate.judge import JudgeOptions
from .locate.picture import PictureOptions, unknown_lens
from .locate.places import IndexOptions
from .match.geometry import lens_of
from .match.likelihood import EvidenceStack, LikelihoodOptions
from .match.prior import CameraPrior, camera_prior
from .match.refine import Objective, RefineOptions, refine
from .skyline.evidence import SkylineOptions, skyline_evidence
from .skyline.given import evidence_from_line, evidence_from_mask

VIEW_SHARE, MARGIN_DEG = 1.2, 24.0
"""Width of the sector in which a picture's horizon is computed: a share of its field of view, since a pitched picture
shows more, and a margin by which a fit may turn [degrees]."""


@dataclass(frozen=True)
class LocateOptions:
    """Options of a search.

    Attributes
    ----------
    index, skyline, picture, coarse, fit, horizon, refine, judge
        Options of the stages.
    hfov_limits_deg : (float, float)
        Fields of view that are tried if neither the file nor the request gives one [degrees].
    eye_heights_m : tuple of float
        Further heights of the eye above the DEM that are tried at the best places [m].
    """

    index: IndexOptions = field(default_factory=IndexOptions)
    skyline: SkylineOptions = field(default_factory=SkylineOptions)
    picture: PictureOptions = field(default_factory=PictureOptions)
    coarse: CoarseOptions = field(default_factory=CoarseOptions)
    fit: FitOptions = field(default_factory=FitOptions)
    horizon: HorizonOptions = field(
        default_factory=lambda: HorizonOptions(azimuth_step_deg=0.25, max_distance_m=60_000.0)
    )
    refine: RefineOptions = field(default_factory=RefineOptions)
    judge: JudgeOptions = field(default_factory=JudgeOptions)
    hfov_limits_deg: tuple = (30.0, 75.0)
    eye_heights_m: tuple = ()

    @classmethod
    def of(cls, index, hfov_limits_deg, eye_max_m):
        """Make the options of a run.

        Parameters
        ----------
        index : IndexOptions
        hfov_limits_deg : (float, float)
            Fields of view to try if none is known [degrees].
        eye_max_m : float
            Greatest height of the eye above the DEM [m].
        """
        ray = {"max_distance_m": index.max_distance_m, "refraction_coefficient": index.refraction_coefficient}
        heights = np.linspace(index.eye_height_m, max(eye_max_m, index.eye_height_m), 4)[1:]
        heights = tuple(float(height) for height in heights if height > index.eye_height_m)
        horizon = HorizonOptions(azimuth_step_deg=0.25, **ray)
        return cls(index=index, horizon=horizon, hfov_limits_deg=hfov_limits_deg, eye_heights_m=heights)


class SkylineProblem:
    """The fit of one picture at many places, with the likelihood that also finds headings.

    Parameters
    ----------
    evidence : SkylineEvidence
    prior : CameraPrior
        Lens of the full upright picture.
    options : RefineOptions
    """

    def __init__(self, evidence, prior, options=RefineOptions()):  # noqa: B008 - frozen
        height, width = evidence.probability.shape
        self.stack = EvidenceStack(evidence.probability, LikelihoodOptions(), evidence.leaves_frame)
        self.full_prior = prior
        self.prior = replace(prior, camera=prior.camera.scaled(width, height))
        self.options = options

    # parameters: the state of a fit
    def climb(self, curves, trials, error_m, scale, stride):
        """Fit the pose of each trial at its own place.

        Parameters
        ----------
        curves : CurveSet
            One horizon for each trial.
        trials : (K, 5) array
        error_m : float
            Standard deviation of the places [m].
        scale, stride : float, int
            See `core.match.refine.refine`.
        """
        objective = Objective(self.stack, self.prior, curves, self.options, (), error_m)
        return refine(objective, trials, scale, stride)

    def view_of(self, trial):
        """Heading and horizontal field of view of a trial [degrees]."""
        return float(trial[0]), lens_of(self.full_prior.camera, trial).hfov_deg

    def facts(self, curves, trial):
        """Share of the columns that a horizon explains, and the spread of the horizon about a line [degrees]."""
        objective = Objective(self.stack, self.prior, curves, self.options, (), 0.0)
        columns = objective.columns(1)
        row, tolerance = (values[0] for values in objective.rows(trial[None], columns))
        value = self.stack.look_up(columns, row, 1.5 * tolerance)
        inside = np.isfinite(row) & (row >= 0) & (row <= self.stack.shape[0] - 1)
        relief_px = 0.0
        if inside.sum() >= 20:
            x, y = columns[inside], row[inside]
            relief_px = float(np.std(y - np.polyval(np.polyfit(x, y, 1), x)))
        return float(np.mean(value > np.log(3.0))), float(np.degrees(relief_px / self.prior.camera.focal_px))


def lens(metadata, hfov_deg, limits_deg):
    """Prior of the lens, and the log focal lengths to try: one if the field of view is known, else several.

    Parameters
    ----------
    metadata : PhotoMetadata
    hfov_deg : float or None
        As given for the upright picture [degrees].
    limits_deg : (float, float)
        Fields of view to try otherwise [degrees].
    """
    try:
        return camera_prior(metadata, hfov_deg), np.zeros(1)
    except MissingMetadataError:
        camera, sigma, log_focals = unknown_lens(metadata.width_px, metadata.height_px, limits_deg)
        return CameraPrior(camera, sigma), log_focals


def picture_of(request, options=SkylineOptions()):  # noqa: B008 - frozen
    """Read a photograph, reduced, and where its skyline may lie: as drawn or masked by a person, else extracted."""
    photo = read_photo(request.path, PREVIEW_PX)
    if request.focal_length_35mm is not None:
        photo = replace(photo, metadata=replace(photo.metadata, focal_length_35mm=request.focal_length_35mm))
    size = photo.metadata.width_px, photo.metadata.height_px
    if request.sky_mask_path is not None:
        evidence = evidence_from_mask(read_photo(request.sky_mask_path, PREVIEW_PX).pixels, *size)
    elif request.drawn_skyline is not None:
        x_px, y_px = np.asarray(request.drawn_skyline, float).reshape(-1, 2).T
        evidence = evidence_from_line(x_px, y_px, *size)
    else:
        evidence = skyline_evidence(photo.pixels, options, *size)
    return replace(photo, pixels=np.rint(shrink_to(photo.pixels, PREVIEW_PX)).astype(np.uint8)), evidence


# parameters: a terrain and its options, positions, and what of the horizon is needed
def horizons_at(dem, options, longitude_deg, latitude_deg, eye_height_m, view=None):
    """Horizon profiles at positions; None where the DEM has no horizon.

    Parameters
    ----------
    dem : Terrain
    options : LocateOptions
    longitude_deg, latitude_deg : (N,) arrays
        WGS 84 [degrees].
    eye_height_m : float
        Above the DEM; NaN takes the height of the index [m].
    view : (heading_deg, hfov_deg) or None
        The horizon is needed in this view only, which takes a third of the time, and is not known elsewhere; None
        takes the whole circle.
    """
    profiles = []
    height_m = eye_height_m if np.isfinite(eye_height_m) else options.index.eye_height_m
    for place in zip(longitude_deg, latitude_deg):
        try:
            observer = Observer(float(place[0]), float(place[1]), float(height_m))
            if view is None:
                profiles.append(horizon_profile(dem, observer, options.horizon))
            else:
                width_deg = VIEW_SHARE * view[1] + MARGIN_DEG
                profiles.append(sector_profile(dem, observer, options.horizon, view[0], width_deg))
        except PhotoError:
            profiles.append(None)
    return profiles


def horizons_seen(dem, options, problem):
    """Return `horizons_at` as a function of (longitudes, latitudes, height of the eye, trial) for the trial's view.

    Parameters
    ----------
    dem : Terrain
    options : LocateOptions
    problem : SkylineProblem
    """

    def horizons_of(longitude_deg, latitude_deg, eye_height_m, trial):
        return horizons_at(dem, options, longitude_deg, latitude_deg, eye_height_m, problem.view_of(trial))

    return horizons_of
