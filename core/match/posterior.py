"""Turn scores into an answer with its certainty: probabilities, interval, status, advice.

The probability of the best answer is a logistic regression on quantities that separate right answers from wrong ones.
Its weights, means and spreads are in `calibration.json`, which `tools/fit_calibration.py` fits on simulated
photographs.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.messages import Message
from .prior import compass_prior, log_ratio

TABLE_PATH = Path(__file__).with_name("calibration.json")
LARGEST_STANDARD = 3.0
"""Features are clipped at this many standard deviations: values outside the fitted range add no certainty."""

POSE_NUMBERS = 3.0
"""Heading, pitch and roll: what a fit takes from a horizon; the focal length is nearly known."""


@dataclass(frozen=True)
class PosteriorOptions:
    """Thresholds of the status.

    Attributes
    ----------
    accept_at : float
        Smallest p_correct of an accepted answer.
    reject_below : float
        p_correct below which the answer is rejected.
    min_relief_deg : float
        A horizon flatter than this inside the frame cannot be matched.
    least_ncc : float
        Smallest correlation of the horizon with the extracted skyline of an accepted answer.
    compass_limit_deg : float
        An accepted answer that differs by more than this from a recorded compass heading must be so certain that it
        would be accepted if the compass took part [degrees].
    """

    accept_at: float = 0.85
    reject_below: float = 0.1
    min_relief_deg: float = 0.1
    least_ncc: float = 0.3
    compass_limit_deg: float = 30.0


@lru_cache(maxsize=1)
def table():
    """Read the shipped calibration table as plain values."""
    return json.loads(TABLE_PATH.read_text(encoding="utf-8"))


def features(finding):
    """Quantities that separate right answers from wrong ones, by name."""
    top = max(float(finding.score[0]), 1e-3)
    return {
        "relative_gap": min(max(finding.gap, 0.0) / top, 0.5),
        "score": top,
        "explained": finding.explained,
        "log_relief": float(np.log(max(finding.relief_deg, 0.02))),
        "log_misfit": float(np.log(max(finding.residual_px, 0.2) / max(finding.terrain_px, 0.2))),
        "sureness": finding.sureness,
        "log_hfov": float(np.log(finding.hfov_deg)),
    }


def p_correct(finding, calibration=None):
    """Probability that the best answer is within 3 degrees of the truth.

    It is the value of the regression, but never more than the best answer's share of the likelihood among all answers:
    whatever the other quantities are, each of two equal answers is right half the time. Near terrain is believed less,
    down to a half: a horizon of few cells of the DEM has no more numbers than the pose that is fitted to it.
    """
    calibration = calibration or table()
    values = features(finding)
    total = calibration["bias"]
    for name, entry in calibration["features"].items():
        standard = (values[name] - entry["mean"]) / entry["spread"]
        total += entry["weight"] * float(np.clip(standard, -LARGEST_STANDARD, LARGEST_STANDARD))
    believed = min(1 / (1 + np.exp(-total)), likelihood_share(finding.score, calibration["temperature"]))
    resolved = 1 / (1 + (POSE_NUMBERS / finding.horizon_cells) ** 2)
    return float(believed * (1 + resolved) / 2)


def likelihood_share(score, temperature):
    """Share of the first score in the sum of all likelihoods exp(temperature * score)."""
    score = np.asarray(score, float)
    return float(1 / np.exp(temperature * (score - score[0])).sum())


def answer_probabilities(finding, best_probability):
    """Divide `1 - best_probability` among the other answers by their scores; the rest is 'none of them'."""
    likelihood = np.exp(table()["temperature"] * (finding.score - finding.score[0]))
    others = likelihood[1:].sum()
    share = (1 - best_probability) * likelihood[1:] / (others + 1.0) if others > 0 else np.zeros(0)
    return np.concatenate([[best_probability], share])


def weigh(probability, heading_deg, prior):
    """Combine the probabilities from the picture with a heading prior by Bayes' rule.

    Parameters
    ----------
    probability : (K,) array
        Probabilities of the answers from the picture alone; the remainder to 1 is 'none of them', spread over the
        circle.
    heading_deg : (K,) array
    prior : HeadingPrior or None
    """
    weighted = probability * np.exp(log_ratio(prior, heading_deg))
    return weighted / (weighted.sum() + max(1 - probability.sum(), 0.0))


def interval(finding, probability, mass=0.9, step_deg=0.05):
    """Shortest arc that holds `mass` of the posterior over the circle.

    The posterior is a Gaussian at each answer with its probability, and a uniform remainder.

    Parameters
    ----------
    finding : Finding
        Supplies the headings and their spreads.
    probability : (k,) array
        Probabilities of the first k answers; the uniform part is the remainder to 1.
    mass : float
        Probability that the arc holds.
    step_deg : float
        Resolution of the circle [degrees].

    Returns
    -------
    lo_deg, hi_deg : float
        Clockwise from lo to hi [degrees].
    """
    factor = table()["sigma_factor"]
    heading = np.arange(0, 360, step_deg)
    density = np.full(len(heading), max(1 - probability.sum(), 0.0) / len(heading))
    for centre, sigma, share in zip(finding.heading_deg, finding.sigma_deg, probability):
        spread = max(sigma * factor, step_deg)
        kernel = np.exp(-0.5 * np.square(difference(heading, centre) / spread))
        density += share * kernel / kernel.sum()
    total = np.concatenate([[0.0], np.cumsum(np.concatenate([density, density]))])
    start = np.arange(len(heading))
    stop = np.searchsorted(total, total[start] + mass * total[len(heading)])
    length = np.where(stop - start <= len(heading), stop - start, len(heading))
    # Among equally short arcs, take the one centred on the best answer.
    centre = start + length / 2
    offset = np.abs(difference(centre * step_deg, finding.heading_deg[0]))
    first = int(np.lexsort((offset, length))[0])
    return float(wrap_360(heading[first])), float(wrap_360(heading[first] + length[first] * step_deg))


def verdict(finding, probability, options=PosteriorOptions(), has_landmarks=False):
    """Return the status, and a `Message` with the reason and what to do.

    Parameters
    ----------
    finding : Finding
    probability : (K,) array
        Probabilities of the answers, best first.
    options : PosteriorOptions
    has_landmarks : bool
        Whether there are landmarks, which determine the answer even if the horizon is too flat to do so.
    """
    best = probability[0]
    if finding.relief_deg < options.min_relief_deg and not has_landmarks:
        return "rejected", Message(
            "The horizon is almost straight here, so it fits many headings. Give an approximate heading or a landmark."
        )
    if best >= options.accept_at:
        return "accepted", Message(
            "The DEM horizon matches the skyline in {share} % of the columns; no other heading scores close.",
            share=f"{100 * finding.explained:.0f}",
        )
    if best < options.reject_below:
        return "rejected", Message(
            "No heading fits the skyline. Check the position and the field of view, or give a sky mask, a "
            "drawn skyline, a landmark or an approximate heading."
        )
    if len(probability) > 1 and probability[1] > 0.5 * (1 - best):
        return "ambiguous", Message(
            "A heading of {heading} degrees fits nearly as well. Compare the overlays, or give an approximate"
            " heading or a landmark.",
            heading=f"{wrap_360(finding.heading_deg[1]):.0f}",
        )
    return "ambiguous", Message(
        "The fit is weak. Check the overlay, or give an approximate heading, a landmark or a sky mask."
    )


def doubt(candidates, ncc, recorded_heading_deg, options=PosteriorOptions()):  # noqa: B008 - frozen
    """Tell what a person would object to an accepted answer at first sight.

    Parameters
    ----------
    candidates : sequence of Candidate
        Best first, with their probabilities.
    ncc : float or None
        Correlation of the best answer's horizon with the extracted skyline.
    recorded_heading_deg : float or None
        True compass heading [degrees].
    options : PosteriorOptions

    Returns
    -------
    Message or None
        The objection, and what to do.
    """
    if ncc is not None and ncc < options.least_ncc:
        return Message(
            "The DEM horizon does not follow the skyline that was found in the picture. Check the overlay, or give a "
            "sky mask, a drawn skyline or an approximate heading."
        )
    compass = compass_prior(recorded_heading_deg)
    if compass is None:
        return None
    heading_deg = np.array([candidate.pose.heading_deg for candidate in candidates])
    if abs(difference(heading_deg[0], recorded_heading_deg)) <= options.compass_limit_deg:
        return None
    probability = np.array([candidate.probability for candidate in candidates])
    if weigh(probability, heading_deg, compass)[0] >= options.accept_at:
        return None
    return Message(
        "The photo's compass says {heading} degrees, which contradicts the heading found. Check the overlay, use "
        "the compass as a hint (COMPASS), or give an approximate heading.",
        heading=f"{recorded_heading_deg:.0f}",
    )
