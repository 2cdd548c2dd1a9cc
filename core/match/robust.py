"""Find the heading robustly: build the evidence, search coarsely, refine many candidates, compute the posterior.

docs/accuracy.md describes the stages and the measurements.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial

import numpy as np

from ..base.curves import correlation, sharpness
from ..base.doubt import DOUBTED_PROBABILITY
from ..base.messages import Message
from ..base.model import Candidate, Orientation
from ..base.progress import SILENT, subtask
from .answers import Answers, judge
from .finding import examine, pose_uncertainty, relief_px
from .fitting import Scorer, fit
from .geometry import HorizonCurve, lens_of, pose_of
from .ground import GroundMatchOptions
from .landmarks import landmark_notes, scale_landmarks, starting_pose
from .likelihood import EDGE_ROW, EvidenceStack, LikelihoodOptions
from .notes import BEHIND_NOTE, HINT_MESSAGE, MIRROR_MESSAGE, compass_note, edge_notes, refusal
from .posterior import PosteriorOptions, doubt, interval, table, verdict
from .prior import log_ratio
from .refine import Objective, RefineOptions
from .ridges import BEHIND_SHARE, RidgeMatchOptions, crest_share
from .search import SearchOptions, coarse_search
from .second import ForegroundEvidence, ForegroundOptions, InnerEvidence


@dataclass(frozen=True)
class RobustOptions:
    """All options of the robust search.

    Attributes
    ----------
    likelihood, search, refine, ridges, ground, foreground, posterior
        Options of the stages.
    short_scales : tuple of float
        Tolerances of the short fits, as multiples of the expected tolerance. The first is wide enough to converge and
        each one after it is finer: at a wide tolerance a wrong answer scores like a right one, and near terrain scores
        as if there were none.
    full_fits : int
        Number of candidates that get the full fit.
    same_answer_deg : float
        Headings closer than this count as one answer [degrees].
    heading_floor_deg : float
        Lower limit of the standard deviation of a heading [degrees].
    second_misled : float
        Probability that the evidence from the inside of the picture is misleading; bounds its weight.
    """

    likelihood: LikelihoodOptions = field(default_factory=LikelihoodOptions)
    search: SearchOptions = field(default_factory=SearchOptions)
    refine: RefineOptions = field(default_factory=RefineOptions)
    ridges: RidgeMatchOptions = field(default_factory=RidgeMatchOptions)
    ground: GroundMatchOptions = field(default_factory=GroundMatchOptions)
    foreground: ForegroundOptions = field(default_factory=ForegroundOptions)
    posterior: PosteriorOptions = field(default_factory=PosteriorOptions)
    short_scales: tuple = (3.0, 1.0, 0.5, 0.15)
    full_fits: int = 14
    same_answer_deg: float = 1.5
    heading_floor_deg: float = 0.1
    second_misled: float = 0.1


def match_robust(inputs, options=RobustOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Find the pose of a photograph and the certainty of its heading.

    Parameters
    ----------
    inputs : MatchInputs
        Everything known about the photograph.
    options : RobustOptions
    progress : Progress

    Returns
    -------
    Orientation
        Candidates are distinct answers, best first. Headings are clockwise from true north, pitch is positive upwards,
        roll is positive with the right side down.
    """
    landmarks, full = inputs.landmarks, inputs.camera_prior.camera
    hopeless = refusal(inputs.evidence, inputs.horizon, landmarks)
    if hopeless:
        return Orientation("rejected", hopeless)
    found, behind = _look(inputs, options, progress)
    inputs = inputs.behind if behind else inputs
    answers, probability = found.answers, found.probability
    finding, trials, score = answers.finding, answers.trials, answers.finding.score
    sigma_deg = finding.sigma_deg * table()["sigma_factor"]
    candidates = tuple(
        Candidate(pose_of(trial), lens_of(full, trial), float(value), float(share), float(sigma))
        for trial, value, share, sigma in zip(trials, score, probability, sigma_deg)
    )
    curve = answers.curve()
    residual, ncc = _skyline_residual(answers.objective, trials[:1], inputs.evidence, full)
    objection = _objection(found, candidates, ncc, inputs, options)
    status = "ambiguous" if objection else found.status
    # For an accepted answer the interval gives only its precision; p_correct gives its certainty.
    lo, hi = interval(finding, np.ones(1) if status == "accepted" else probability)
    second = None
    if len(trials) > 1:
        _, second = _skyline_residual(answers.objective, trials[1:2], inputs.evidence, full)
    return Orientation(
        status,
        objection or found.message,
        candidates,
        heading_lo_deg=lo,
        heading_hi_deg=hi,
        p_correct=min(found.right, DOUBTED_PROBABILITY) if objection else found.right,
        curve_heading_deg=curve[0],
        curve_score=curve[1],
        ncc=ncc,
        ncc_second=second,
        sharpness=sharpness(answers.coarse.heading_deg, answers.coarse.score, candidates[0].pose.heading_deg),
        residual_px=residual,
        notes=landmark_notes(landmarks, candidates[0].camera, candidates[0].pose)
        + edge_notes(answers, status)
        + ((BEHIND_NOTE,) if behind else ())
        + compass_note(status, objection, inputs.recorded_heading_deg),
        behind=behind,
        eye=int(answers.eye[0]),
        uncertainty=pose_uncertainty(answers.objective, trials[0], answers.scale[0], answers.floor_deg),
    )


@dataclass(frozen=True, eq=False)
class Judged:
    """Answers from one evidence, the probability of each, and the status and message of the best one."""

    answers: Answers
    probability: np.ndarray
    right: float
    status: str
    message: Message


def _objection(found, candidates, ncc, inputs, options):
    """Message that takes back an acceptance, or None; landmarks are a person's own check."""
    if found.status != "accepted" or inputs.landmarks:
        return None
    objection = doubt(candidates, ncc, inputs.recorded_heading_deg, options.posterior)
    if objection is None and mirror_fits_better(inputs, found.answers, options):
        return MIRROR_MESSAGE
    return objection


def _look(inputs, options, progress):
    """Find the judged answers, and whether they come from the evidence's rival line."""
    if inputs.evidence.rival is None or inputs.inner is None:
        return _judged(inputs, options, progress), False
    found = _judged(inputs, options, subtask(progress, 0.0, 0.6))
    if found.status == "accepted":
        return found, False
    behind = _judged(inputs.behind, options, subtask(progress, 0.6, 1.0))
    eye = inputs.eyes[behind.answers.eye[0]]
    share = crest_share(behind.answers.objective, behind.answers.trials[0], inputs.evidence, eye.inner.ridges)
    if share < BEHIND_SHARE or behind.right <= found.right:
        return found, False
    return behind, True


def _judged(inputs, options, progress):
    answers, probability, right = judge(find_answers(inputs, options, progress), inputs.heading_prior)
    if answers.hint == 0:
        return Judged(answers, probability, right, "ambiguous", HINT_MESSAGE)
    says = verdict(
        answers.finding, np.concatenate([[right], probability[1:]]), options.posterior, bool(inputs.landmarks)
    )
    return Judged(answers, probability, right, *says)


def find_answers(inputs, options=RobustOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Search and fit without judging; `match_robust` and the calibration share this part.

    Parameters
    ----------
    inputs : MatchInputs
        Everything known about the photograph.
    options : RobustOptions
    progress : Progress

    Returns
    -------
    Answers
    """
    objectives, coarse = _searched(inputs, options, subtask(progress, 0.0, 0.4))
    return _fitted(inputs, objectives, coarse, options, subtask(progress, 0.4, 1.0))


def mirror_fits_better(inputs, answers, options):
    """Tell whether the mirror image of a picture scores higher than the best answer, from the same eye.

    The mirror image of a view is a view that no place has, so that the DEM fits it only by chance. It is fitted only
    if its coarse search scores as high as that of the picture itself, which is rare.

    Parameters
    ----------
    inputs : MatchInputs
    answers : Answers
        To the picture itself.
    options : RobustOptions
    """
    image = inputs.mirrored(inputs.eyes[answers.eye[0]])
    objectives, coarse = _searched(image, options, SILENT)
    if coarse[0].score.max() < answers.coarse.score.max():
        return False
    return bool(_fitted(image, objectives, coarse, options, SILENT).finding.score[0] > answers.finding.score[0])


def _searched(inputs, options, progress):
    """Objectives and coarse searches, one of each for every hypothesis of the eye."""
    evidence, prior, eyes = inputs.evidence, inputs.reduced_prior, inputs.eyes
    stack = EvidenceStack(evidence.probability, options.likelihood, evidence.leaves_frame)
    marks = scale_landmarks(inputs.landmarks, inputs.camera_prior.camera, prior.camera)
    curves = [HorizonCurve(eye.horizon) for eye in eyes]
    objectives = tuple(
        Objective(stack, prior, curve, options.refine, marks, inputs.position_error_m) for curve in curves
    )
    grid = options.search.for_picture(prior.camera.hfov_deg, skyline_relief_deg(stack, prior.camera))
    belief = partial(_belief, inputs.heading_prior)
    return objectives, coarse_search(stack, prior.camera, curves, grid, belief, progress)


def _fitted(inputs, objectives, coarse, options, progress):
    """Fit the candidates of the coarse searches and the poses that landmarks suggest."""
    camera = inputs.reduced_prior.camera
    marks = scale_landmarks(inputs.landmarks, inputs.camera_prior.camera, camera)
    starts = [starting_pose(camera, mark) for mark in marks]
    starts = np.array([(pose.heading_deg, pose.pitch_deg, pose.roll_deg) for pose in starts]).reshape(-1, 3)
    scorers = [
        Scorer(
            objective,
            InnerEvidence(objective, inputs.evidence, eye.inner, options),
            ForegroundEvidence(objective, inputs.evidence.sky_map, options.foreground),
            eye.log_prior / table()["temperature"],
        )
        for objective, eye in zip(objectives, inputs.eyes)
    ]
    starts = [np.concatenate([starts, found.candidates]) for found in coarse]
    fits = fit(scorers, starts, partial(_belief, inputs.heading_prior), options, progress)
    finding = examine(objectives, fits, options.heading_floor_deg)
    around = coarse[fits.eye[0]]
    return Answers(objectives, around, fits.trials, fits.eye, fits.scale, finding, options.heading_floor_deg)


def skyline_relief_deg(stack, camera):
    """Spread of the likeliest rows about a straight line [degrees]: the relief by which headings can be separated."""
    columns = stack.informative
    spread_px = relief_px(columns, stack.probability[:, columns].argmax(axis=0))
    return float(np.degrees(spread_px / camera.focal_px))


def _belief(heading_prior, heading_deg):
    """Score that the prior adds when candidates are chosen: its log ratio in units of the score."""
    return log_ratio(heading_prior, heading_deg) / table()["temperature"]


def _skyline_residual(objective, trial, evidence, full):
    """Best skyline minus projected horizon (w,) [pixels of the full picture], and their NCC."""
    columns = np.arange(objective.stack.shape[1])
    row = objective.rows(trial, columns)[0][0]
    best = evidence.best
    usable = best.valid & np.isfinite(row) & (row >= 0) & (row <= objective.stack.shape[0] - 1)
    residual = np.where(usable, best.row_px - EDGE_ROW - row, np.nan) * full.width_px / objective.stack.shape[1]
    return residual, correlation(-np.asarray(best.row_px, float)[usable], -row[usable])
