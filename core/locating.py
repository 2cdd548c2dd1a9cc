"""Find where photographs were taken: the index of an area and the search in it; docs/locate.md has the method."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from .base.errors import MissingPackageError, PhotoError, SkylineNotFoundError
from .base.messages import Message
from .base.model import Candidate
from .base.progress import SILENT, subtask
from .batch import recorded_heading_deg
from .cluster import tiles_on
from .io.array_folder import ArrayFolder, mark_of
from .locate.answer import Known, Located, LocatedPlace, oriented_at
from .locate.build import kept_index, one_after_the_other
from .locate.coarse import compare
from .locate.fit import curves_of, fit_places, lift, move
from .locate.fitted import distinct
from .locate.judge import Facts, apart_share, ellipse, gap_of, near_share, p_correct, region, shares, table, verdict
from .locate.picture import hypotheses
from .locate.places import IndexOptions
from .match.geometry import lens_of, pose_of
from .match.likelihood import EvidenceStack
from .match.prior import compass_prior, log_ratio
from .searching import LocateOptions, SkylineProblem, horizons_at, horizons_seen, lens, picture_of

LEAST_COLUMNS_SHARE = 0.15
"""Smallest share of columns with evidence for which a search is made."""

CANDIDATES = 5

FORMAT = 1
"""Version of stored indices; raise it when their content changes."""


# parameters: an area on a DEM, and where its index is computed and kept
def index_of_area(dem, area, options=IndexOptions(), folder=None, progress=SILENT, client=None):  # noqa: B008
    """Compute the index of an area, or take it from a folder of an earlier run.

    Parameters
    ----------
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
    area : Area
    options : IndexOptions
    folder : str or None
        Where indices are kept, each by a fingerprint of all on which it depends; None keeps nothing.
    progress : Progress
    client : dask.distributed.Client or None
        Its workers compute the index, tile by tile; None computes it in this process.

    Returns
    -------
    HorizonIndex

    Raises
    ------
    AreaError, OutputError
    """
    store = None
    if folder:
        content = replace(options, memory_mb=0.0)  # the limit decides whether an index is made, not what is in it
        store = ArrayFolder(Path(folder) / f"horizons-{mark_of(dem, FORMAT, area, content)}")
    return kept_index(dem, area, options, store, progress, tiles_on(client) if client else one_after_the_other)


# parameters: what a run shares, what a photograph brings, and its progress
def locate_request(request, terrain, options=LocateOptions(), log_weight=None, use_compass=False, progress=SILENT):  # noqa: B008
    """Find where one photograph was taken.

    Parameters
    ----------
    request : core.batch.PhotoRequest
        Its position is not used.
    terrain : (Dem, HorizonIndex)
    options : LocateOptions
    log_weight : (P,) array or None
        Logarithms of the weights of the places of the index; -inf excludes a place.
    use_compass : bool
        Use the recorded heading as a hint.
    progress : Progress

    Returns
    -------
    Located
        Status 'failed' with the reason if there is an error in the photograph.
    """
    try:
        photo, evidence = picture_of(request, options.skyline)
        lens_prior = lens(photo.metadata, request.hfov_deg, options.hfov_limits_deg)
        index = terrain[1]
        compass = recorded_heading_deg(photo.metadata, *index.middle_deg) if use_compass else None
        known = Known(compass_prior(compass), log_weight)
        return locate(photo, evidence, lens_prior, terrain, options, known, progress)
    except (PhotoError, MissingPackageError) as error:
        return Located(request.path, "failed", error.message)


# parameters: what a photograph brings, what a run shares, and its progress
def locate(photo, evidence, lens_prior, terrain, options=LocateOptions(), known=Known(), progress=SILENT):  # noqa: B008
    """Find the place in an area from which the horizon fits the skyline of a photograph best.

    Parameters
    ----------
    photo : Photo
    evidence : SkylineEvidence
    lens_prior : (CameraPrior, array)
        From `lens`.
    terrain : (Terrain, HorizonIndex)
        The DEM and the index of the area.
    options : LocateOptions
    known : Known
    progress : Progress

    Returns
    -------
    Located

    Raises
    ------
    SkylineNotFoundError
        Hardly any column of the picture shows a skyline.
    """
    (dem, index), (prior, log_focals) = terrain, lens_prior
    telling = EvidenceStack.informative_columns(evidence.probability)
    if len(telling) < LEAST_COLUMNS_SHARE * evidence.probability.shape[1]:
        raise SkylineNotFoundError(
            Message("Hardly any column of the picture shows a boundary between sky and terrain.")
        )
    problem, worth = SkylineProblem(evidence, prior, options.refine), table()["temperature"]
    headings = np.arange(int(round(360 / options.picture.step_deg))) * options.picture.step_deg
    belief = log_ratio(known.heading_prior, headings) / worth
    weight = np.zeros(len(index)) if known.log_weight is None else known.log_weight / worth
    pictures = hypotheses(evidence, prior.camera, options.picture, log_focals)
    coarse = compare(index, pictures, options.picture, belief, subtask(progress, 0.0, 0.4), options.coarse)
    places, trials = coarse.best(options.fit.places, weight)
    fitted = fit_places(problem, index, places, trials, options.fit, subtask(progress, 0.4, 0.7))
    fitted = fitted.plus(weight[fitted.source] + log_ratio(known.heading_prior, fitted.trial[:, 0]) / worth).once()
    starts = fitted.take(distinct(fitted, options.fit.separation_m, options.fit.stages[0][1]))
    horizons_of = horizons_seen(dem, options, problem)
    moved = move(problem, horizons_of, starts, index.spacing_m, options.fit, subtask(progress, 0.7, 1.0))
    moved = lift(problem, horizons_of, moved, options.eye_heights_m, options.fit)
    moved = moved.plus(weight[moved.source] + log_ratio(known.heading_prior, moved.trial[:, 0]) / worth)
    return _answer(photo, evidence, problem, (terrain, fitted, moved, coarse.score), options)


def _answer(photo, evidence, problem, search, options):
    (dem, index), fitted, moved, score = search
    count = min(CANDIDATES, len(moved.score))
    profiles = [
        profile
        for place in zip(moved.longitude_deg[:count], moved.latitude_deg[:count], moved.eye_height_m)
        for profile in horizons_at(dem, options, place[:1], place[1:2], place[2])
    ]
    explained, relief_deg = problem.facts(curves_of(profiles[:1]), moved.trial[0])
    camera = lens_of(problem.full_prior.camera, moved.trial[0])
    facts = Facts(float(moved.score[0]), gap_of(moved), explained, relief_deg, camera.hfov_deg, len(index))
    right = min(p_correct(facts), apart_share(moved)) * near_share(moved)
    probability = shares(moved.score, right)
    status, message = verdict(facts, probability, options.judge)
    says = status, message
    places = tuple(
        _place(photo, evidence, problem, (moved.take(np.array([k])), profiles[k], float(probability[k])), says)
        for k in range(count)
        if profiles[k] is not None
    )
    held = _region(fitted, moved)
    return Located(photo.metadata.path, status, message, places, right, held, score, facts)


def _region(fitted, moved):
    """Places of the grid that hold 90 % of the probability, the one nearest the answer included."""
    scale = np.cos(np.radians(moved.latitude_deg[0]))
    east, north = fitted.longitude_deg - moved.longitude_deg[0], fitted.latitude_deg - moved.latitude_deg[0]
    nearest = int(np.hypot(east * scale, north).argmin())
    # Moving raises scores. Only the answer's counts here: the more places were raised, the less the others would weigh.
    # It counts where the answer lies now, which need not be nearest the place from which it was moved.
    score = fitted.score.copy()
    score[nearest] = max(score[nearest], moved.score[0])
    return fitted.source[region(score)]


def _place(photo, evidence, problem, found, says):
    one, profile, probability = found
    trial, score = one.trial[0], float(one.score[0])
    best = Candidate(pose_of(trial), lens_of(problem.full_prior.camera, trial), score, probability)
    where = float(one.longitude_deg[0]), float(one.latitude_deg[0])
    oriented = oriented_at(photo, evidence, best, (*where, profile), says)
    around = ellipse(one.curvature[0], one.focal_slope[0], problem.prior.focal_sigma, 0.5 * profile.cell_m)
    return LocatedPlace(*where, oriented, score, probability, around)
