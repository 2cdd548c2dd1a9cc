"""Many photographs: the orientation of one as a task for other processes, and the photographs that share a station."""

from __future__ import annotations

import logging
import traceback
from dataclasses import dataclass
from typing import Any

from . import batch
from .base.blas import one_blas_thread
from .base.errors import PhotoError, TerrainError
from .base.messages import Message
from .base.model import Orientation, OrientedPhoto
from .base.progress import subtask
from .eyes import HorizonCache
from .io.photo import read_photo
from .joint.alone import alone_of
from .joint.answers import Limits, answers_together
from .joint.hints import predictions
from .joint.lens import lens_ratios
from .joint.pairs import ties_between
from .joint.together import beliefs
from .match.posterior import table
from .paper.skyline import extract_skyline_paper
from .pipeline import OrientOptions
from .skyline.evidence import skyline_evidence
from .viewshed.station import viewsheds_at
from .workers.interpreter import worker_count
from .workers.pool import WorkerLostError
from .workers.team import Team

JOINT_PART = 0.7
"""Share of the progress at which all photographs of a walk have been oriented alone."""

UNEXPECTED = Message("An unexpected error occurred on this photo. Please report it and attach the log.")


@dataclass(frozen=True, eq=False)
class OrientJob:
    """The job of a `Team` that orients photographs: calling it gives the function for one of them.

    Attributes
    ----------
    dem : Dem or ArrayTerrain
        Another process opens a `Dem` itself.
    options : OrientOptions
    """

    dem: Any
    options: OrientOptions

    def __call__(self):
        """Return the function of ((request, photo or None), progress) that gives an `OrientedPhoto`."""
        cache = HorizonCache()

        def orient(task, progress):
            request, photo = task
            return batch.orient_request(request, self.dem, self.options, cache, progress, photo)

        return orient


@dataclass(frozen=True, eq=False)
class ViewshedJob:
    """The same for the viewsheds of the photographs at one place.

    Attributes
    ----------
    dem : Dem or ArrayTerrain
    options : ViewshedOptions
    """

    dem: Any
    options: Any

    def __call__(self):
        """Return the function of ((observer, sectors), progress) that gives a list of `Viewshed`."""
        return lambda task, progress: list(viewsheds_at(self.dem, task[0], task[1], self.options, progress))


@dataclass(frozen=True)
class SkylineJob:
    """The same for skylines alone.

    Attributes
    ----------
    method : str
        'robust' or 'paper'.
    preview_px : int
        Long side of the picture that the result keeps [pixels].
    """

    method: str
    preview_px: int

    def __call__(self):
        """Return the function of (path, progress) that gives an `OrientedPhoto` without orientation."""
        return lambda path, progress: extract_skyline(path, self.method, self.preview_px)


def extract_skyline(path, method, preview_px):
    """Extract the skyline of a photograph file without orienting it.

    Parameters
    ----------
    path : str or None
    method : str
        'robust' or 'paper'.
    preview_px : int
        Long side of the picture that the `OrientedPhoto`, which has no orientation, keeps [pixels].

    Raises
    ------
    PhotoError, MissingPackageError
    """
    if path is None:
        raise PhotoError(Message("The point names no photo. Fill its path field."))
    options, evidence = OrientOptions(), None
    with one_blas_thread():
        photo = read_photo(path, None if method == "paper" else preview_px)
        metadata = photo.metadata
        if method == "paper":
            skyline = extract_skyline_paper(photo.pixels, options.paper.skyline)
        else:
            evidence = skyline_evidence(photo.pixels, options.skyline, metadata.width_px, metadata.height_px)
            skyline = evidence.best
    return OrientedPhoto(path, Orientation("", ""), metadata, preview=photo.pixels, skyline=skyline, evidence=evidence)


def outcomes_of(job, tasks, progress, workers):
    """Orient photographs here or in worker processes.

    Parameters
    ----------
    job : OrientJob
    tasks : list of (PhotoRequest, Photo or None)
    progress : Progress
    workers : int
        See `worker_count`.

    Yields
    ------
    Outcome
        In order.
    """
    with Team(job, worker_count(workers, len(tasks))) as team:
        team.begin(tasks, progress, [station_of(request) for request, _ in tasks])
        for index in range(len(tasks)):
            yield team.take(subtask(progress, index / len(tasks), (index + 1) / len(tasks)))


def answers_of(outcomes, tasks):
    """Yield the `OrientedPhoto` of each outcome; a wrong DEM or argument ends the run, our own fault only its photo.

    Parameters
    ----------
    outcomes : iterable of Outcome
    tasks : list of (PhotoRequest, Photo or None)
        In the same order.

    Raises
    ------
    TerrainError, TypeError
    """
    for outcome, (request, _) in zip(outcomes, tasks):
        if isinstance(outcome.error, (TerrainError, TypeError)):
            raise outcome.error
        if outcome.error is None:
            yield outcome.value
        else:
            logging.getLogger(__name__).error("%s\n%s", request.path, outcome.details, exc_info=outcome.error)
            yield fallen(request.path, outcome.error, (f"{type(outcome.error).__name__}: {outcome.error}",))


def look_again(tasks, photos, orient_all, progress, options=OrientOptions()):  # noqa: B008 - frozen
    """Solve the photographs of a walk together, after each has been oriented alone.

    Where others predict a heading that a photograph has not found, it is oriented again near that heading before the
    problem is solved.

    Parameters
    ----------
    tasks : list of (PhotoRequest or None, Photo or None)
    photos : list of OrientedPhoto
        Results of the tasks.
    orient_all : callable
        Gives the outcomes of (tasks, progress) in order, as `outcomes_of` and `cluster_outcomes` do.
    progress : Progress
    options : OrientOptions
        Of the run.

    Returns
    -------
    list of OrientedPhoto
        Photographs for which the others say nothing, those that stay accepted, and those for which the user has given
        a heading are the same objects.
    """
    alones = [alone_of(photo) if photo.camera is not None else None for photo in photos]
    alones = [alone and alone.favoured(ratio) for alone, ratio in zip(alones, lens_ratios(photos, alones))]
    ties = ties_between(photos, subtask(progress, 0.0, 0.4))
    with_compass = options.compass != "prior"  # then each photograph has used its reading already
    known = beliefs(photos, alones, ties, with_compass)
    free = {number for number, (request, _) in enumerate(tasks) if request is not None and request.heading_deg is None}
    hints = {number: hint for number, hint in predictions(photos, known).items() if number in free}
    wanted = [(hint.applied(tasks[number][0]), tasks[number][1]) for number, hint in hints.items()]
    again = {}
    outcomes = orient_all(wanted, subtask(progress, 0.4, 1.0))
    for outcome, (number, hint) in zip(outcomes, hints.items()):
        found = None if outcome.error is not None else hint.found_in(outcome.value)
        if found is not None:
            again[number] = outcome.value
            alones[number] = alones[number].joined(found, table()["temperature"])
    if again:
        known = beliefs(photos, alones, ties, with_compass)
    limits = Limits(options.robust.posterior.accept_at, options.robust.posterior.reject_below)
    together = answers_together(photos, again, known, ties, limits)
    return [after if number in free else photos[number] for number, after in enumerate(together)]


def together_or_alone(tasks, photos, orient_all, progress, options=OrientOptions()):  # noqa: B008 - frozen
    """Solve the photographs of a walk together as `look_again` does; a fault of ours leaves each its own answer.

    Parameters
    ----------
    tasks, photos, orient_all, progress, options
        As for `look_again`.

    Returns
    -------
    list of OrientedPhoto
    str or None
        Traceback of the fault.
    """
    try:
        return look_again(tasks, photos, orient_all, progress, options), None
    except Exception:
        details = traceback.format_exc()
        logging.getLogger(__name__).error("%s", details)
        return photos, details


def station_of(request):
    """Give what photographs from one place have in common, for `Pool.map`; None if only the file has the position."""
    if request.longitude_deg is None or request.latitude_deg is None or request.prefer_photo_position:
        return None
    return request.longitude_deg, request.latitude_deg, request.eye_elevation_m, request.eye_height_m


def fallen(path, error, notes=()):
    """Make the result for a photo whose computation failed for a reason that does not lie in the photo.

    Parameters
    ----------
    path : str
    error : Exception
    notes : tuple of str
    """
    message = error.message if isinstance(error, WorkerLostError) else UNEXPECTED
    return OrientedPhoto(path, Orientation("failed", message, notes=tuple(notes)))
