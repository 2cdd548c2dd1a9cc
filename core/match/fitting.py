"""Fit many candidates under every hypothesis of the eye, and keep the best of each distinct heading."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import wrap_360
from ..base.curves import distinct_headings
from ..base.progress import subtask
from .answers import Fits
from .posterior import table
from .refine import Objective, refine
from .second import ForegroundEvidence, InnerEvidence


@dataclass(frozen=True, eq=False)
class Scorer:
    """How trials are scored under one hypothesis of the eye.

    Attributes
    ----------
    objective : Objective
        The skyline.
    second : InnerEvidence
        The picture below the horizon.
    foreground : ForegroundEvidence
        Ground above the horizon.
    prior : float
        Of the eye.
    """

    objective: Objective
    second: InnerEvidence
    foreground: ForegroundEvidence
    prior: float


def fit(scorers, starts, belief, options, progress):
    """Fit all candidates of every eye briefly, and the best distinct ones of them in full.

    The heading prior helps to choose the candidates that get a full fit; the scores come from the picture alone.

    Parameters
    ----------
    scorers : sequence of Scorer
        One for each hypothesis of the eye.
    starts : sequence of (N, 3) arrays
        Heading, pitch and roll of the candidates of each eye [degrees].
    belief : callable
        Headings [degrees] -> what the heading prior adds to a score.
    options : RobustOptions
    progress : Progress

    Returns
    -------
    Fits
        Of distinct headings, best first.
    """
    short = []
    for index, (scorer, candidates) in enumerate(zip(scorers, starts)):
        part = subtask(progress, 0.5 * index / len(scorers), 0.5 * (index + 1) / len(scorers))
        trials = np.column_stack([candidates, np.zeros((len(candidates), 2))])
        trials, score, scale = _best_over_scales(scorer.objective, trials, options.short_scales, 4, part)
        score = score + scorer.prior + belief(trials[:, 0])
        short.append(Fits(trials, np.full(len(trials), index), score, scale))
    kept = _distinct(_joined(short), options)
    kept = kept.take(np.arange(min(options.full_fits, len(kept.score))))
    # Each from where the short fit left it: at a wide tolerance an answer may drift from a place that is already right.
    scales, full = sorted(options.refine.error_scales, reverse=True), []
    for index, scorer in enumerate(scorers):
        own = kept.take(np.flatnonzero(kept.eye == index))
        if not len(own.score):
            continue
        part = subtask(progress, 0.5 + 0.5 * index / len(scorers), 0.5 + 0.5 * (index + 1) / len(scorers))
        trials, score, scale = _best_over_scales(scorer.objective, own.trials, scales, 1, part, chained=False)
        full.append(Fits(trials, own.eye, score + scorer.prior, scale))
    fits = _distinct(_joined(full), options)
    fits = _with_second_evidence(fits, scorers, options)
    fits.trials[:, 0] = wrap_360(fits.trials[:, 0])
    return fits


def _with_second_evidence(fits, scorers, options):
    """Add the evidence from either side of the skyline to the scores, and sort the fits by them.

    With the probability `second_misled` the evidence from the inside of the picture is misleading (snow, cloud shadow,
    forest) and carries no information. This bounds the weight that it can have for one answer against another, so that
    it decides between answers that the skyline leaves open and never overrules a clear skyline. That of the foreground
    is bounded by itself. Only differences between the answers count.
    """
    inside, foreground = np.zeros(len(fits.score)), np.zeros(len(fits.score))
    for index, scorer in enumerate(scorers):
        own = fits.eye == index
        if own.any():
            inside[own] = scorer.second.score(fits.trials[own])
            foreground[own] = scorer.foreground.score(fits.trials[own])
    worth, misled = table()["temperature"], options.second_misled
    foreground -= foreground.max()
    likelihood = np.log(misled + (1 - misled) * np.exp(worth * (inside - inside.max()))) + foreground
    fits = replace(fits, score=fits.score + likelihood / worth)
    return fits.take(np.argsort(-fits.score, kind="stable"))


def _joined(fits):
    """Fits of several eyes as one."""
    return Fits(
        *(np.concatenate([getattr(part, name) for part in fits]) for name in ("trials", "eye", "score", "scale"))
    )


def _distinct(fits, options):
    """The best fit of each distinct heading, best first."""
    return fits.take(distinct_headings(fits.trials[:, 0], fits.score, options.same_answer_deg))


def _best_over_scales(objective, trials, scales, stride, progress, chained=True):
    """Fit all trials at each tolerance in turn; each trial keeps its best parameters, score and scale.

    If `chained`, each tolerance starts from the result of the one before; otherwise it starts from the given trials.
    """
    best, best_score, best_scale = trials.copy(), np.full(len(trials), -np.inf), np.ones(len(trials))
    for index, scale in enumerate(scales):
        part = subtask(progress, index / len(scales), (index + 1) / len(scales))
        fitted, score = refine(objective, trials, scale, stride, progress=part)
        better = score > best_score
        best[better], best_score[better], best_scale[better] = fitted[better], score[better], scale
        trials = fitted if chained else trials
    return best, best_score, best_scale
