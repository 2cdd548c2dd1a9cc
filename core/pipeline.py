"""The stages in order, for one photograph: skyline, horizon, match. Arrays in, results out, no files."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from .base.camera import FOCAL_SIGMA, Camera, focal_from_35mm_px, focal_of_fov_px, paper_fov_deg
from .base.errors import MissingMetadataError, ObserverError, SkylineNotFoundError
from .base.imaging import thumbnail
from .base.messages import Message
from .base.model import Orientation, OrientedPhoto, SkylineEvidence
from .base.progress import SILENT, subtask
from .base.terrain import ground_elevation_m
from .base.uncertainty import TYPICAL_POSITION_ERROR_M
from .horizon.horizon import HorizonOptions, horizon_profile
from .horizon.inner import InnerOptions, inner_terrain
from .match.prior import CameraPrior, HeadingPrior
from .match.robust import RobustOptions, match_robust
from .paper.horizon import PaperHorizonOptions, paper_horizon
from .paper.match import PaperMatchOptions, match_paper
from .paper.skyline import PaperSkylineOptions, extract_skyline_paper
from .skyline.evidence import EvidenceOptions as SkylineOptions
from .skyline.evidence import skyline_evidence

METHODS = ("robust", "paper")
COMPASS_USES = ("ignore", "prior")


@dataclass(frozen=True)
class OrientOptions:
    """How to orient photographs.

    Attributes
    ----------
    method : str
        'robust', or 'paper' for the published method with its own field of view, range and straight rays.
    compass : str
        'ignore' never looks at the recorded heading, 'prior' takes it as a soft belief.
    horizon, inner, skyline, robust : options of the robust method's stages
    paper_skyline, paper_horizon, paper_match : options of the published method's stages
    """

    method: str = "robust"
    compass: str = "ignore"
    horizon: HorizonOptions = field(default_factory=HorizonOptions)
    inner: InnerOptions = field(default_factory=InnerOptions)
    skyline: SkylineOptions = field(default_factory=SkylineOptions)
    robust: RobustOptions = field(default_factory=RobustOptions)
    paper_skyline: PaperSkylineOptions = field(default_factory=PaperSkylineOptions)
    paper_horizon: PaperHorizonOptions = field(default_factory=PaperHorizonOptions)
    paper_match: PaperMatchOptions = field(default_factory=PaperMatchOptions)

    def __post_init__(self):
        if self.method not in METHODS or self.compass not in COMPASS_USES:
            raise ValueError(f"method must be one of {METHODS} and compass one of {COMPASS_USES}, not {self}")

    @property
    def horizon_of_method(self):
        """Horizon options of the chosen method; they tell `cast_horizon` which engine is meant."""
        if self.method == "robust":
            return self.horizon
        return replace(
            self.paper_horizon, max_distance_m=min(self.paper_horizon.max_distance_m, self.horizon.max_distance_m)
        )


@dataclass(frozen=True)
class Hints:
    """What a person adds where the picture alone does not decide; all optional.

    Attributes
    ----------
    heading : HeadingPrior or None
        Approximate heading.
    landmarks : tuple of Landmark
        Pixels of the full picture with the direction of their map points.
    evidence : SkylineEvidence or None
        From a drawn skyline or a sky mask; replaces the extraction.
    """

    heading: HeadingPrior | None = None
    landmarks: tuple = ()
    evidence: SkylineEvidence | None = None


def cast_horizon(terrain, observer, options, progress=SILENT):
    """Cast the horizon of either method: `options` are `HorizonOptions` or `PaperHorizonOptions`."""
    if isinstance(options, PaperHorizonOptions):
        return paper_horizon(terrain, observer, replace(options, eye_height_m=observer.eye_height_m), progress)
    return horizon_profile(terrain, observer, options, progress)


def camera_prior(metadata, hfov_deg=None):
    """What is known of the lens before the fit.

    Parameters
    ----------
    metadata : PhotoMetadata
    hfov_deg : float or None
        Horizontal field of view of the upright picture, where it is given [degrees]; else the 35 mm equivalent by
        the diagonal rule, with the spread that the metadata tell.

    Raises
    ------
    MissingMetadataError
    """
    width, height = metadata.width_px, metadata.height_px
    if hfov_deg is not None:
        focal, sigma = focal_of_fov_px(width, hfov_deg), FOCAL_SIGMA
    elif metadata.focal_length_35mm is not None:
        focal, sigma = focal_from_35mm_px(width, height, metadata.focal_length_35mm), metadata.focal_sigma
    else:
        raise MissingMetadataError(
            Message(
                "The photo has no focal length (35 mm equivalent). Give the horizontal field of view in HFOV_FIELD."
            )
        )
    return CameraPrior(Camera(width, height, focal), sigma)


def orient_photo(
    photo,
    terrain,
    observer,
    prior,
    options=OrientOptions(),  # noqa: B008 - frozen
    hints=Hints(),  # noqa: B008 - frozen
    horizon=None,
    inner=None,
    position_error_m=TYPICAL_POSITION_ERROR_M,
    progress=SILENT,
):
    """Find where one photograph looks.

    Parameters
    ----------
    photo : Photo
        Pixels full or reduced; the paper's method wants them full.
    terrain : Terrain
    observer : Observer
    prior : CameraPrior
        See `camera_prior`.
    options : OrientOptions
    hints : Hints
    horizon : HorizonProfile or None
        Of this observer, where a photo of the same station has it already.
    inner : InnerTerrain or None
        The same of the terrain below it.
    position_error_m : float
        Standard deviation of the position [m].
    progress : Progress

    Returns
    -------
    OrientedPhoto

    Raises
    ------
    PhotoError
        No horizon at this position.
    """
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, 1_000.0)
    if horizon is None:
        horizon = cast_horizon(terrain, observer, options.horizon_of_method, subtask(progress, 0.0, 0.4))
    rest = subtask(progress, 0.4, 1.0)
    try:
        if options.method == "paper":
            orientation, skyline, evidence = _by_paper(photo, prior, horizon, options, rest)
        else:
            if inner is None:
                inner = inner_terrain(terrain, observer, options.inner)
            orientation, skyline, evidence = _robustly(
                photo, prior, horizon, inner, options, hints, position_error_m, rest
            )
    except SkylineNotFoundError as error:
        orientation, skyline, evidence = Orientation("rejected", error.message), None, None
    best = orientation.best
    return OrientedPhoto(
        photo.metadata.path,
        orientation,
        metadata=photo.metadata,
        camera=prior.camera if best is None else best.camera,
        skyline=skyline,
        evidence=evidence,
        horizon=horizon,
        longitude_deg=observer.longitude_deg,
        latitude_deg=observer.latitude_deg,
        eye_elevation_m=horizon.eye_elevation_m,
        ground_elevation_m=_ground(terrain, frame),
        convergence_deg=frame.convergence_deg,
    )


def _robustly(photo, prior, horizon, inner, options, hints, position_error_m, progress):
    metadata, robust = photo.metadata, options.robust
    evidence = hints.evidence
    if evidence is None:
        evidence = skyline_evidence(photo.pixels, options.skyline, metadata.width_px, metadata.height_px)
    else:
        # A given skyline places the answer better than the small picture of the ground below it, which tells which.
        evidence = replace(evidence, thumbnail=thumbnail(photo.pixels))
        robust = replace(robust, turn=replace(robust.turn, reach_deg=0.0))
    orientation = match_robust(
        evidence,
        prior,
        horizon,
        robust,
        hints.heading,
        hints.landmarks,
        position_error_m,
        inner,
        subtask(progress, 0.4, 1.0),
    )
    if orientation.behind:
        evidence = evidence.rival
    return orientation, evidence.best, evidence


def _by_paper(photo, prior, horizon, options, progress):
    metadata = photo.metadata
    skyline = extract_skyline_paper(photo.pixels, options.paper_skyline)
    if metadata.focal_length_35mm is None:
        fov = prior.camera.hfov_deg, prior.camera.vfov_deg
    else:
        fov = paper_fov_deg(metadata.width_px, metadata.height_px, metadata.focal_length_35mm)
    return match_paper(skyline, *fov, horizon, options.paper_match, subtask(progress, 0.5, 1.0)), skyline, None


def _ground(terrain, frame):
    try:
        return ground_elevation_m(terrain, frame)
    except ObserverError:  # an eye elevation was given above a void
        return None
