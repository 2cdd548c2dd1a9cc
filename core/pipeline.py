"""Run the stages for one photograph in order (skyline, horizon, match), on arrays and without files."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from .base.errors import ObserverError, SkylineNotFoundError
from .base.imaging import thumbnail
from .base.model import HorizonProfile, Orientation, OrientedPhoto, SkylineEvidence
from .base.progress import SILENT, subtask
from .base.terrain import Observer, ground_elevation_m
from .base.uncertainty import TYPICAL_POSITION_ERROR_M
from .eyes import cast_horizon
from .horizon.horizon import HorizonOptions
from .horizon.inner import InnerOptions, InnerTerrain, inner_terrain
from .match.inputs import EyeOptions, MatchInputs
from .match.landmarks import match_with_landmarks
from .match.prior import CameraPrior, HeadingPrior
from .match.robust import RobustOptions, match_robust
from .paper.method import PaperOptions, orient_by_paper
from .skyline.evidence import SkylineOptions, skyline_evidence
from .skyline.plausible import check_skyline

METHODS = ("robust", "paper")
COMPASS_USES = ("ignore", "prior")


@dataclass(frozen=True)
class OrientOptions:
    """Options for orienting photographs.

    Attributes
    ----------
    method : str
        'robust', or 'paper' for the published method, which has its own field of view, range and straight rays.
    compass : str
        'ignore' never uses the recorded heading; 'prior' uses it as a soft prior.
    horizon, inner, eyes, skyline, robust : HorizonOptions, InnerOptions, EyeOptions, SkylineOptions, RobustOptions
        Options of the stages of the robust method.
    paper : PaperOptions
        Options of the published method.
    compass_shares : tuple of (str, float)
        Cameras whose compasses are worse than usual, and their shares of worthless readings (`core.trusting`).
    """

    method: str = "robust"
    compass: str = "ignore"
    horizon: HorizonOptions = field(default_factory=HorizonOptions)
    inner: InnerOptions = field(default_factory=InnerOptions)
    eyes: EyeOptions = field(default_factory=EyeOptions)
    skyline: SkylineOptions = field(default_factory=SkylineOptions)
    robust: RobustOptions = field(default_factory=RobustOptions)
    paper: PaperOptions = field(default_factory=PaperOptions)
    compass_shares: tuple = ()

    def __post_init__(self):
        if self.method not in METHODS or self.compass not in COMPASS_USES:
            raise ValueError(f"method must be one of {METHODS} and compass one of {COMPASS_USES}, not {self}")

    @property
    def horizon_of_method(self):
        """Horizon options of the chosen method; their type selects the engine in `core.eyes`."""
        if self.method == "robust":
            return self.horizon
        rays = self.paper.horizon
        return replace(rays, max_distance_m=min(rays.max_distance_m, self.horizon.max_distance_m))


@dataclass(frozen=True)
class Hints:
    """Optional information from a person, for photographs that the picture alone does not decide.

    Attributes
    ----------
    heading : HeadingPrior or None
    landmarks : tuple of Landmark
        Pixels of the full picture with the direction of their map points.
    evidence : SkylineEvidence or None
        Evidence from a drawn skyline or a sky mask; it replaces the extraction.
    recorded_heading_deg : float or None
        True compass heading that takes no part in the match, but may cast doubt on its result [degrees].
    """

    heading: HeadingPrior | None = None
    landmarks: tuple = ()
    evidence: SkylineEvidence | None = None
    recorded_heading_deg: float | None = None


@dataclass(frozen=True, eq=False)
class Setting:
    """Everything known about one photograph except its picture.

    Attributes
    ----------
    observer : Observer
    prior : CameraPrior
        See `camera_prior`.
    hints : Hints
    horizon : HorizonProfile or None
        Horizon of this observer, if it was already computed for a photo from the same station.
    inner : InnerTerrain or None
        Terrain below that horizon, likewise.
    position_error_m : float
        Standard deviation of the position [m].
    other_eyes : tuple of Eye
        See `core.eyes.other_eyes`.
    """

    observer: Observer
    prior: CameraPrior
    hints: Hints = field(default_factory=Hints)
    horizon: HorizonProfile | None = None
    inner: InnerTerrain | None = None
    position_error_m: float = TYPICAL_POSITION_ERROR_M
    other_eyes: tuple = ()


def orient_photo(photo, terrain, setting, options=OrientOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Find the heading, pitch and roll of the camera for one photograph.

    Parameters
    ----------
    photo : Photo
        Pixels at full or reduced size; the published method needs full size.
    terrain : Terrain
    setting : Setting
        Everything known about the photograph except its picture.
    options : OrientOptions
    progress : Progress

    Returns
    -------
    OrientedPhoto

    Raises
    ------
    PhotoError
        There is no horizon at this position.
    """
    observer, horizon = setting.observer, setting.horizon
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, 1_000.0)
    if horizon is None:
        horizon = cast_horizon(terrain, observer, options.horizon_of_method, subtask(progress, 0.0, 0.4))
    rest = subtask(progress, 0.4, 1.0)
    evidence = None
    try:
        if options.method == "paper":
            orientation, skyline = orient_by_paper(photo, setting.prior.camera, horizon, options.paper, rest)
        else:
            inner = setting.inner
            if inner is None:
                inner = inner_terrain(terrain, observer, options.inner)
            orientation, evidence = _robustly(photo, replace(setting, horizon=horizon, inner=inner), options, rest)
            skyline = evidence.best
    except SkylineNotFoundError as error:
        orientation, skyline = Orientation("rejected", error.message), None
    best = orientation.best
    if orientation.eye:
        horizon = setting.other_eyes[orientation.eye - 1].horizon
    return OrientedPhoto(
        photo.metadata.path,
        orientation,
        metadata=photo.metadata,
        camera=setting.prior.camera if best is None else best.camera,
        skyline=skyline,
        evidence=evidence,
        horizon=horizon,
        longitude_deg=observer.longitude_deg,
        latitude_deg=observer.latitude_deg,
        eye_elevation_m=horizon.eye_elevation_m,
        ground_elevation_m=_ground(terrain, frame),
        convergence_deg=frame.convergence_deg,
    )


def _robustly(photo, setting, options, progress):
    """Orient by the robust method; return the orientation and the evidence that it matched."""
    metadata, hints = photo.metadata, setting.hints
    evidence = hints.evidence
    if evidence is None:
        evidence = skyline_evidence(photo.pixels, options.skyline, metadata.width_px, metadata.height_px)
        check_skyline(evidence, needed=not hints.landmarks)
    else:
        # A given skyline comes without what the picture shows below it, which helps to choose between answers.
        evidence = replace(evidence, thumbnail=thumbnail(photo.pixels))
    known = hints.heading, hints.landmarks, setting.position_error_m, setting.inner, setting.other_eyes
    inputs = MatchInputs(evidence, setting.prior, setting.horizon, *known, hints.recorded_heading_deg)
    orientation = match_with_landmarks(match_robust, inputs, options.robust, subtask(progress, 0.4, 1.0))
    return orientation, evidence.rival if orientation.behind else evidence


def _ground(terrain, frame):
    try:
        return ground_elevation_m(terrain, frame)
    except ObserverError:  # an eye elevation was given above a void
        return None
