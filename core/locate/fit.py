"""Fit the pose at many places, and move the best of them to where the horizon fits best."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.curvature import METRES_PER_DEGREE
from ..base.progress import SILENT, checkpoint, subtask
from .curves import CurveSet
from .fitted import FittedPlaces, distinct, joined

CHUNK = 256
"""Places that are fitted together."""

RING = np.array([(0.0, 0.0), *((np.cos(a), np.sin(a)) for a in np.arange(8) * np.pi / 4)])
"""Displacements that are tried around a place, in steps: none, and eight directions."""

LIFTED, LEAST_LIFT = 3, 0.1
"""Number of the best places at which further heights of the eye are tried, and the least gain in score that counts."""

LIFT_ERROR_M = 15.0


@dataclass(frozen=True)
class FitOptions:
    """How many places are fitted, and how finely.

    Attributes
    ----------
    places : int
        Number of the best places and headings of the coarse search that are fitted with the robust likelihood.
    scales : tuple of float
        Tolerances of that fit, as multiples of the expected tolerance.
    place_error : float
        Error of a place of the grid, as a share of the distance between places.
    separation_m : float
        Places nearer than this to a better one are not followed further [m].
    stages : tuple of (float, int)
        For each stage of moving: the step as a share of the distance between places, and the number of places. A step
        of 0 fits the place itself with its exact horizon.
    final_scales : tuple of float
        Tolerances of the fits while places are moved.
    step_error : float
        Error of a moved place, as a share of the step.
    """

    places: int = 1000
    scales: tuple = (3.0, 1.5, 1.0)
    place_error: float = 0.3
    separation_m: float = 600.0
    stages: tuple = ((0.0, 60), (0.5, 24), (0.22, 6), (0.1, 4))
    final_scales: tuple = (2.0, 1.0, 0.5)
    step_error: float = 0.5


def fit_places(problem, index, places, trials, options=FitOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Fit the pose at places of an index.

    Parameters
    ----------
    problem : object
        With `climb(curves, trials, error_m, scale, stride)`, which returns trials and scores.
    index : HorizonIndex
    places : (K,) int array
    trials : (K, 5) array
        Poses from which the fits start.
    options : FitOptions
    progress : Progress

    Returns
    -------
    FittedPlaces
        Best first.
    """
    fitted, score = np.array(trials, float), np.full(len(places), -np.inf)
    for first in range(0, len(places), CHUNK):
        checkpoint(progress, first / len(places))
        part = slice(first, first + CHUNK)
        elevation_deg, distance = index.horizons(places[part])
        curves = CurveSet(elevation_deg, distance, index.cell_m)
        error_m = options.place_error * index.spacing_m
        fitted[part], score[part] = best_over_scales(problem, curves, fitted[part], error_m, (options.scales, 6))
    found = FittedPlaces(
        np.asarray(places),
        index.longitude_deg[places],
        index.latitude_deg[places],
        fitted,
        score,
        np.full((len(places), 2, 2), np.nan),
        np.full((len(places), 2), np.nan),
        np.full(len(places), np.nan),
    )
    return found.take(np.argsort(-score, kind="stable"))


def best_over_scales(problem, curves, trials, error_m, how):
    """Fit with tolerances that shrink, and keep the best pose of each trial.

    Parameters
    ----------
    problem : object
        As for `fit_places`.
    curves : CurveSet
    trials : (K, 5) array
        Poses from which the fits start.
    error_m : float
        Standard deviation of the places [m].
    how : (scales, stride)
        Tolerances, as multiples of the expected one, and the step between the columns that count.

    Returns
    -------
    trials : (K, 5) array
    score : (K,) array
    """
    scales, stride = how
    best, best_score = trials.copy(), np.full(len(trials), -np.inf)
    for scale in scales:
        trials, score = problem.climb(curves, trials, error_m, scale, stride)
        better = score > best_score
        best[better], best_score[better] = trials[better], score[better]
    return best, best_score


def move(problem, horizons_of, found, spacing_m, options=FitOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Move places to where the horizon fits best, eye and pose together.

    Parameters
    ----------
    problem : object
        As for `fit_places`.
    horizons_of : callable
        (longitudes, latitudes, height of the eye [m], trial (5,)) -> list of HorizonProfile, known at least in the
        view of the trial, or None where there is no horizon.
    found : FittedPlaces
        Distinct places, best first.
    spacing_m : float
        Distance between the places of the index [m].
    options : FitOptions
    progress : Progress

    Returns
    -------
    FittedPlaces
        Best first.
    """
    for number, (share, count) in enumerate(options.stages):
        part = subtask(progress, number / len(options.stages), (number + 1) / len(options.stages))
        ahead, rest = np.arange(min(count, len(found.score))), np.arange(min(count, len(found.score)), len(found.score))
        moved = []
        for place in ahead:
            checkpoint(part, place / len(ahead))
            one = found.take(np.array([place]))
            moved.append(_moved(problem, horizons_of, one, (share * spacing_m, spacing_m), options))
        found = joined([*moved, found.take(rest)])
        found = found.take(np.argsort(-found.score, kind="stable"))
        found = found.take(distinct(found, options.separation_m / 2, len(found.score)))
    return found


def _moved(problem, horizons_of, one, steps_m, options):
    """One place, moved to the best of the places around it; `steps_m` is the step now and that of the index."""
    step_m, spacing_m = steps_m
    offset_m = RING * step_m if step_m > 0 else np.zeros((1, 2))
    error_m = options.step_error * step_m if step_m > 0 else options.place_error * spacing_m
    north = one.latitude_deg[0] + offset_m[:, 1] / METRES_PER_DEGREE
    scale = METRES_PER_DEGREE * np.cos(np.radians(one.latitude_deg[0]))
    east = one.longitude_deg[0] + offset_m[:, 0] / scale
    profiles = horizons_of(east, north, one.eye_height_m[0], one.trial[0])
    usable = np.array([place for place, profile in enumerate(profiles) if profile is not None], int)
    if not len(usable):
        return one
    curves = curves_of([profiles[place] for place in usable])
    start = np.repeat(one.trial, len(usable), axis=0)
    trial, score = best_over_scales(problem, curves, start, error_m, (options.final_scales, 3))
    best = int(score.argmax())
    curvature, slope = _surface(offset_m[usable], score, trial[:, 3])
    return replace(
        one,
        longitude_deg=east[usable[best] : usable[best] + 1],
        latitude_deg=north[usable[best] : usable[best] + 1],
        trial=trial[best : best + 1],
        score=score[best : best + 1],
        curvature=curvature[None],
        focal_slope=slope[None],
    )


def lift(problem, horizons_of, found, heights_m, options=FitOptions()):  # noqa: B008 - frozen
    """Try further heights of the eye at the best places; a height counts only if it fits clearly better.

    Parameters
    ----------
    problem, horizons_of, options
        As for `move`.
    found : FittedPlaces
        Best first.
    heights_m : sequence of float
        Above the DEM [m].

    Returns
    -------
    FittedPlaces
        Best first.
    """
    lifted = []
    for place in range(len(found.score)):
        one = found.take(np.array([place]))
        for height_m in heights_m if place < LIFTED else ():
            profiles = horizons_of(one.longitude_deg, one.latitude_deg, height_m, one.trial[0])
            if profiles[0] is None:
                continue
            how = options.final_scales, 3
            trial, score = best_over_scales(problem, curves_of(profiles), one.trial, LIFT_ERROR_M, how)
            if score[0] > one.score[0] + LEAST_LIFT:
                one = replace(one, trial=trial, score=score, eye_height_m=np.array([height_m]))
        lifted.append(one)
    return joined(lifted).plus(np.zeros(len(lifted)))


def curves_of(profiles):
    """The `CurveSet` of some horizon profiles of the same azimuths."""
    return CurveSet(
        np.array([profile.elevation_deg for profile in profiles]),
        np.array([profile.distance_m for profile in profiles]),
        profiles[0].cell_m,
        np.array([profile.clipped | profile.void for profile in profiles]),
    )


def _surface(offset_m, score, log_focal):
    """Curvature of the negative score, and slope of the focal length, over displaced places; NaN if too few."""
    if len(score) < 7:
        return np.full((2, 2), np.nan), np.full(2, np.nan)
    reach = np.abs(offset_m).max()
    east, north = (offset_m / reach).T
    terms = np.column_stack([np.ones(len(east)), east, north, east**2 / 2, east * north, north**2 / 2])
    quadratic = np.linalg.lstsq(terms, -score, rcond=None)[0]
    linear = np.linalg.lstsq(terms[:, :3], log_focal, rcond=None)[0]
    curvature = np.array([[quadratic[3], quadratic[4]], [quadratic[4], quadratic[5]]]) / reach**2
    return curvature, linear[1:3] / reach
