"""Check whether the recorded position of a photograph is believable: a better place nearby is reported, never used."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from .base.angles import difference
from .base.curvature import METRES_PER_DEGREE
from .base.errors import MissingPackageError, PhotoError
from .base.messages import Message
from .base.model import OrientedPhoto
from .base.progress import SILENT, subtask
from .batch import PhotoRequest, orient_request
from .eyes import HorizonCache
from .locate.fit import FitOptions, best_over_scales, curves_of, move
from .locate.fitted import FittedPlaces, distinct
from .locate.judge import ellipse
from .pipeline import OrientOptions
from .searching import LocateOptions, SkylineProblem, horizons_at, horizons_seen, lens, picture_of


@dataclass(frozen=True)
class CheckOptions:
    """How a recorded position is checked.

    Attributes
    ----------
    radius_m : float
        Rings of places are tried out to this distance from the recorded position; the best places are then moved, by
        at most 105 m [m].
    near_m : float
        Error that any recorded position may have [m].
    doubtful_gain : float
        Gain in score from which the recorded position is doubted.
    least_score : float
        Score below which no place counts as explaining the skyline.
    locate, orient : LocateOptions, OrientOptions
    """

    radius_m: float = 500.0
    near_m: float = 30.0
    doubtful_gain: float = 0.5
    least_score: float = 3.0
    locate: LocateOptions = field(default_factory=LocateOptions)
    orient: OrientOptions = field(default_factory=OrientOptions)


@dataclass(frozen=True, eq=False)
class PositionCheck:
    """What was found about one recorded position.

    Attributes
    ----------
    path : str
    verdict : str
        'believable', 'doubtful', 'undecided' or 'failed'.
    message : Message
    oriented : OrientedPhoto
        From the recorded position.
    east_m, north_m : float or None
        From the recorded position to the better place [m].
    gain : float or None
        Score there minus the score at the recorded position.
    longitude_deg, latitude_deg : float or None
        Better place [degrees].
    ellipse : core.locate.judge.Ellipse or None
        Of the better place.
    """

    path: str
    verdict: str
    message: Message
    oriented: OrientedPhoto
    east_m: float | None = None
    north_m: float | None = None
    gain: float | None = None
    longitude_deg: float | None = None
    latitude_deg: float | None = None
    ellipse: object | None = None


# parameters: what a run shares, what a photograph brings, and its progress
def check_position(request: PhotoRequest, dem, options=CheckOptions(), cache=None, progress=SILENT):  # noqa: B008
    """Look for a place near the recorded position that explains the skyline much better.

    Parameters
    ----------
    request : PhotoRequest
    dem : core.io.raster.Dem
    options : CheckOptions
    cache : HorizonCache or None
    progress : Progress

    Returns
    -------
    PositionCheck
    """
    oriented = orient_request(request, dem, options.orient, cache or HorizonCache(), subtask(progress, 0.0, 0.5))
    if not oriented.orientation.candidates:
        return PositionCheck(request.path, "failed", oriented.orientation.message, oriented)
    try:
        photo, evidence = picture_of(request, options.locate.skyline)
        prior, _ = lens(photo.metadata, request.hfov_deg, options.locate.hfov_limits_deg)
        problem = SkylineProblem(evidence, prior, options.locate.refine)
        here, best, gain = _around(problem, dem, oriented, options, subtask(progress, 0.5, 1.0))
    except (PhotoError, MissingPackageError) as error:
        return PositionCheck(request.path, "failed", error.message, oriented)
    return _checked(request.path, oriented, (here, best, gain), problem.prior.focal_sigma, options)


def _around(problem, dem, oriented, options, progress):
    """The recorded place, the best place within the radius, and the gain."""
    poses = [candidate.pose for candidate in oriented.orientation.candidates[:3]]
    trials = np.array([(pose.heading_deg, pose.pitch_deg, pose.roll_deg, 0.0, 0.0) for pose in poses])
    offset = _rings(options)
    north = oriented.latitude_deg + offset[:, 1] / METRES_PER_DEGREE
    scale = METRES_PER_DEGREE * np.cos(np.radians(oriented.latitude_deg))
    east = oriented.longitude_deg + offset[:, 0] / scale
    profiles = horizons_at(dem, options.locate, east, north, np.nan)
    usable = np.array([number for number, profile in enumerate(profiles) if profile is not None], int)
    place = np.repeat(usable, len(trials))
    curves, starts = curves_of([profiles[number] for number in place]), np.tile(trials, (len(usable), 1))
    scales = options.locate.fit.final_scales
    fitted, score = best_over_scales(problem, curves, starts, options.near_m, (scales, 3))
    unknown = np.full((len(place), 2, 2), np.nan)
    found = FittedPlaces(place, east[place], north[place], fitted, score, unknown, unknown[:, 0], unknown[:, 0, 0])
    recorded = found.take(np.flatnonzero(np.hypot(*offset[place].T) <= options.near_m))
    order = np.argsort(-found.score, kind="stable")
    starts = found.take(order[distinct(found.take(order), 120.0, 3)])
    steps = replace(FitOptions(), stages=((0.3, 3), (0.12, 2)), separation_m=100.0)
    horizons_of = horizons_seen(dem, options.locate, problem)
    moved = move(problem, horizons_of, starts, 250.0, steps, progress)
    around = recorded.take(np.array([int(recorded.score.argmax())]))
    near = move(problem, horizons_of, around, 2 * options.near_m, steps)
    return near, moved.take(np.array([0])), float(moved.score[0] - near.score[0])


def _rings(options):
    """Displacements (N, 2) to the east and north [m]: the place itself, and rings out to the radius."""
    rings = [np.zeros((1, 2))]
    for radius in np.linspace(0.0, options.radius_m, 6)[1:]:
        count = int(np.clip(np.round(2 * np.pi * radius / 110), 8, 20))
        turn = np.arange(count) * (2 * np.pi / count)
        rings.append(radius * np.column_stack([np.sin(turn), np.cos(turn)]))
    return np.concatenate(rings)


def _checked(path, oriented, found, focal_sigma, options):
    near, best, gain = found
    north_m = float((best.latitude_deg[0] - oriented.latitude_deg) * METRES_PER_DEGREE)
    scale = METRES_PER_DEGREE * np.cos(np.radians(oriented.latitude_deg))
    east_m = float((best.longitude_deg[0] - oriented.longitude_deg) * scale)
    away_m = float(np.hypot(east_m, north_m))
    around = ellipse(best.curvature[0], best.focal_slope[0], focal_sigma, 0.5 * oriented.horizon.cell_m)
    facts = (east_m, north_m, gain, float(best.longitude_deg[0]), float(best.latitude_deg[0]), around)
    if best.score[0] < options.least_score:
        message = Message(
            "No place within {radius} m explains the skyline well. Check the field of view and the DEM, or search a "
            "larger area with Locate photos.",
            radius=f"{options.radius_m:.0f}",
        )
        return PositionCheck(path, "undecided", message, oriented, *facts)
    if gain < options.doubtful_gain or away_m <= options.near_m:
        message = Message("The skyline fits from the recorded position about as well as from anywhere near it.")
        return PositionCheck(path, "believable", message, oriented, *facts)
    message = Message(
        "The skyline fits much better {distance} m away, at azimuth {azimuth} degrees; the heading differs by {turn} "
        "degrees there. Check the recorded position, which was not changed.",
        distance=f"{away_m:.0f}",
        azimuth=f"{np.degrees(np.arctan2(east_m, north_m)) % 360:.0f}",
        turn=f"{abs(difference(best.trial[0, 0], near.trial[0, 0])):.1f}",
    )
    return PositionCheck(path, "doubtful", message, oriented, *facts)
