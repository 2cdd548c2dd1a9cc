"""The robust heading search: evidence, coarse search, refinement of many candidates, posterior.

Stages and measurements are described in docs/accuracy.md.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial

import numpy as np

from ..base.angles import wrap_360
from ..base.curves import correlation, distinct_headings, sharpness
from ..base.messages import Message
from ..base.model import Candidate, Orientation
from ..base.progress import SILENT, subtask
from .finding import Answers, examine, judge, relief_px
from .geometry import HorizonCurve, horizon_rows, lens_of, pose_of
from .ground import GroundMatchOptions
from .inner import InnerEvidence
from .landmarks import landmark_notes, scale_landmarks, starting_pose
from .likelihood import EDGE_ROW, EvidenceStack, LikelihoodOptions
from .posterior import PosteriorOptions, interval, table, verdict
from .prior import log_ratio
from .refine import Objective, RefineOptions, refine
from .ridges import BEHIND_SHARE, RidgeMatchOptions, crest_share
from .search import SearchOptions, coarse_search
from .turn import TurnOptions, turn

LEAST_COLUMNS_SHARE = 0.05
"""Fewer columns with evidence than this share are not worth a search."""

BEHIND_NOTE = Message(
    "According to the DEM, the most distinct line in the picture is a nearby crest; the fainter line "
    "behind it was used as the skyline."
)


@dataclass(frozen=True)
class RobustOptions:
    """All options of the robust search.

    Attributes
    ----------
    likelihood, search, refine, ridges, ground, turn, posterior : options of the stages
    short_scales : tuple of float
        Tolerances of the short fits, in multiples of the expected one: wide enough to arrive, then finer and finer,
        since at a wide tolerance a wrong answer scores like a right one, and near terrain like none at all.
    full_fits : int
        Candidates that get the full fit.
    same_answer_deg : float
        Headings closer than this are one answer.
    heading_floor_deg : float
        Smallest standard deviation that a heading is credited with.
    """

    likelihood: LikelihoodOptions = field(default_factory=LikelihoodOptions)
    search: SearchOptions = field(default_factory=SearchOptions)
    refine: RefineOptions = field(default_factory=RefineOptions)
    ridges: RidgeMatchOptions = field(default_factory=RidgeMatchOptions)
    ground: GroundMatchOptions = field(default_factory=GroundMatchOptions)
    turn: TurnOptions = field(default_factory=TurnOptions)
    posterior: PosteriorOptions = field(default_factory=PosteriorOptions)
    short_scales: tuple = (3.0, 1.0, 0.5, 0.15)
    full_fits: int = 14
    same_answer_deg: float = 1.5
    heading_floor_deg: float = 0.1


def match_robust(inputs, options=RobustOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Find where a photograph looks, and say how sure that is.

    Parameters
    ----------
    inputs : MatchInputs
        What is known of the photograph.
    options : RobustOptions
    progress : Progress

    Returns
    -------
    model.Orientation
        Candidates are distinct answers, best first; headings clockwise from true north, pitch + upwards, roll +
        with the right side down.
    """
    landmarks, full = inputs.landmarks, inputs.camera_prior.camera
    refusal = _refusal(inputs.evidence, inputs.horizon, landmarks)
    if refusal:
        return Orientation("rejected", refusal)
    found, behind = _look(inputs, options, progress)
    evidence = inputs.evidence.rival if behind else inputs.evidence
    answers, probability, status = found.answers, found.probability, found.status
    finding, trials, score = answers.finding, answers.trials, answers.finding.score
    # Of an accepted answer the interval tells how exact it is; how sure it is, p_correct tells.
    lo, hi = interval(finding, np.ones(1) if status == "accepted" else probability)
    candidates = tuple(
        Candidate(pose_of(trial), lens_of(full, trial), float(value), float(share))
        for trial, value, share in zip(trials, score, probability)
    )
    residual, ncc = _skyline_residual(answers.objective, trials[:1], evidence, full)
    _, second = _skyline_residual(answers.objective, trials[1:2], evidence, full) if len(trials) > 1 else (None, None)
    return Orientation(
        status,
        found.message,
        candidates,
        heading_lo_deg=lo,
        heading_hi_deg=hi,
        p_correct=float(probability[0]),
        curve_heading_deg=answers.coarse.heading_deg,
        curve_score=answers.coarse.score.astype(float),
        ncc=ncc,
        ncc_second=second,
        sharpness=sharpness(answers.coarse.heading_deg, answers.coarse.score, candidates[0].pose.heading_deg),
        residual_px=residual,
        notes=landmark_notes(landmarks, candidates[0].camera, candidates[0].pose)
        + _edge_notes(answers)
        + ((BEHIND_NOTE,) if behind else ()),
        behind=behind,
    )


@dataclass(frozen=True, eq=False)
class Judged:
    """Answers to one evidence, the probability of each, and the best one's status and message."""

    answers: Answers
    probability: np.ndarray
    status: str
    message: Message


def _look(inputs, options, progress):
    """Judged answers, and whether they are those to the evidence's rival."""
    if inputs.evidence.rival is None or inputs.inner is None:
        return _judged(inputs, options, progress), False
    found = _judged(inputs, options, subtask(progress, 0.0, 0.6))
    if found.status == "accepted":
        return found, False
    behind = _judged(inputs.behind, options, subtask(progress, 0.6, 1.0))
    share = crest_share(behind.answers.objective, behind.answers.trials[0], inputs.evidence, inputs.inner.ridges)
    if share < BEHIND_SHARE or behind.probability[0] <= found.probability[0]:
        return found, False
    return behind, True


def _judged(inputs, options, progress):
    answers, probability = judge(find_answers(inputs, options, progress), inputs.heading_prior)
    says = verdict(answers.finding, probability, options.posterior, bool(inputs.landmarks))
    return Judged(answers, probability, *says)


def _edge_notes(answers):
    """Remark on a frame whose horizon is only a lower bound."""
    objective = answers.objective
    _, azimuth, _ = horizon_rows(objective.curve, objective.camera, answers.trials[:1], objective.columns(4))
    share = float(objective.curve.clipped[objective.curve.nearest(azimuth)].mean())
    if share < 0.2:
        return ()
    note = Message(
        "In {share} % of the frame the DEM ends or has voids before higher terrain can be ruled out. Use "
        "a larger DEM to make the heading more certain.",
        share=f"{100 * share:.0f}",
    )
    return (note,)


def _refusal(evidence, horizon, landmarks):
    """Why there is nothing to match, or None."""
    width = evidence.probability.shape[1]
    telling = len(EvidenceStack.informative_columns(evidence.probability))
    if telling < LEAST_COLUMNS_SHARE * width and not landmarks:
        return Message(
            "Hardly any column of the picture shows a boundary between sky and terrain. Use a photo with a skyline, "
            "or supply a sky mask or a drawn skyline."
        )
    if not np.isfinite(horizon.elevation_deg).any():
        return Message("The DEM has no terrain around this position. Use a DEM that reaches farther.")
    return None


def find_answers(inputs, options=RobustOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Search and fit without judging: what `match_robust` and the calibration share.

    Parameters
    ----------
    inputs : MatchInputs
        What is known of the photograph.
    options : RobustOptions
    progress : Progress

    Returns
    -------
    Answers
    """
    evidence, prior, curve = inputs.evidence, inputs.reduced_prior, HorizonCurve(inputs.horizon)
    stack = EvidenceStack(evidence.probability, options.likelihood, evidence.leaves_frame)
    marks = scale_landmarks(inputs.landmarks, inputs.camera_prior.camera, prior.camera)
    objective = Objective(stack, prior, curve, options.refine, marks, inputs.position_error_m)
    grid = options.search.for_picture(prior.camera.hfov_deg, _skyline_relief_deg(stack, prior.camera))
    belief = partial(_belief, inputs.heading_prior)
    coarse = coarse_search(stack, prior.camera, curve, grid, belief, subtask(progress, 0.0, 0.4))
    starts = [starting_pose(prior.camera, mark) for mark in marks]
    starts = np.array([(pose.heading_deg, pose.pitch_deg, pose.roll_deg) for pose in starts]).reshape(-1, 3)
    starts = np.concatenate([starts, coarse.candidates])
    second = InnerEvidence(objective, inputs, options)
    trials, score, scale = _fit(objective, starts, second, belief, options, subtask(progress, 0.4, 1.0))
    finding = examine(objective, trials, score, scale, options.heading_floor_deg)
    return Answers(objective, coarse, trials, scale, finding, options.heading_floor_deg)


def _skyline_relief_deg(stack, camera):
    """Spread of the likeliest rows about a straight line [degrees]: what the search has to tell headings apart."""
    columns = stack.informative
    spread_px = relief_px(columns, stack.probability[:, columns].argmax(axis=0))
    return float(np.degrees(spread_px / camera.focal_px))


def _belief(heading_prior, heading_deg):
    """What the prior adds to a score when candidates are chosen: its log ratio, at the worth of a unit of score."""
    return log_ratio(heading_prior, heading_deg) / table()["temperature"]


def _fit(objective, starts, second, belief, options, progress):
    """Short fits of all candidates, full fits of the best distinct ones.

    Gives distinct trials, their scores and their scales of tolerance, best first. The belief in a heading helps to
    choose what is looked at; the scores are the picture's alone.
    """
    trials = np.column_stack([starts, np.zeros((len(starts), 2))])
    trials, score, _ = _best_over_scales(objective, trials, options.short_scales, 4, subtask(progress, 0.0, 0.5))
    score = score + second.score(trials) + belief(trials[:, 0])
    kept = distinct_headings(trials[:, 0], score, options.same_answer_deg)[: options.full_fits]
    scales = sorted(options.refine.error_scales, reverse=True)
    # Each from where the short fit left it: at a wide tolerance an answer may drift from a place that is already right.
    part = subtask(progress, 0.5, 1.0)
    best, best_score, scale = _best_over_scales(objective, trials[kept], scales, 1, part, chained=False)
    best_score = best_score + second.score(best)
    first = int(best_score.argmax())
    if second and options.turn.reach_deg > 0:
        best[first], best_score[first] = turn(objective, second, best[first], scale[first], options.turn)
    kept = distinct_headings(best[:, 0], best_score, options.same_answer_deg)
    best[:, 0] = wrap_360(best[:, 0])
    return best[kept], best_score[kept], scale[kept]


def _best_over_scales(objective, trials, scales, stride, progress, chained=True):
    """Fit all trials at one tolerance after the other; each keeps its best place, score and scale.

    Where `chained`, a tolerance starts from where the one before ended, else from the given trials.
    """
    best, best_score, best_scale = trials.copy(), np.full(len(trials), -np.inf), np.ones(len(trials))
    for index, scale in enumerate(scales):
        part = subtask(progress, index / len(scales), (index + 1) / len(scales))
        fitted, score = refine(objective, trials, scale, stride, progress=part)
        better = score > best_score
        best[better], best_score[better], best_scale[better] = fitted[better], score[better], scale
        trials = fitted if chained else trials
    return best, best_score, best_scale


def _skyline_residual(objective, trial, evidence, full):
    """Drawn skyline minus projected horizon (w,) [pixels of the full picture], and their NCC."""
    columns = np.arange(objective.stack.shape[1])
    row = objective.rows(trial, columns)[0][0]
    best = evidence.best
    usable = best.valid & np.isfinite(row) & (row >= 0) & (row <= objective.stack.shape[0] - 1)
    residual = np.where(usable, best.row_px - EDGE_ROW - row, np.nan) * full.width_px / objective.stack.shape[1]
    return residual, correlation(-np.asarray(best.row_px, float)[usable], -row[usable])
