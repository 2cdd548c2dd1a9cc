"""Turn the fits of places into an answer: probability, status, region, ellipse.

The probability that the best place is right is a logistic regression on quantities that separate right places from
wrong ones. It is fitted on searches of the right area and on searches of other ranges, in which every answer is wrong
(`tools/fit_locate.py` writes `calibration.json`).
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from ..base.messages import Message
from .fitted import distance_m

TABLE_PATH = Path(__file__).with_name("calibration.json")

APART_M = 1_000.0
"""Places farther than this from the best one are other answers [m]."""

RIGHT_M = 500.0
"""A place is right within this distance of the truth [m]."""

LARGEST_STANDARD = 2.5
"""Features are clipped at this many standard deviations."""

MASS = 0.9
"""Probability that the region holds."""

NINETY = 2.146
"""Radius that holds 90 % of a two-dimensional Gaussian [standard deviations]."""


@dataclass(frozen=True)
class JudgeOptions:
    """Thresholds of the status.

    Attributes
    ----------
    accept_at : float
        Smallest p_correct of an accepted place.
    reject_below : float
        p_correct below which the photograph counts as not taken in the area.
    """

    accept_at: float = 0.85
    reject_below: float = 0.25


@dataclass(frozen=True)
class Facts:
    """Quantities of the best place, for the probability.

    Attributes
    ----------
    score : float
        Mean log-likelihood ratio over the columns.
    gap : float
        Score minus that of the best place farther than `APART_M` away, or of the worst if there is none.
    explained : float
        Share of the columns that the horizon explains.
    relief_deg : float
        Spread of the horizon in the picture about a straight line [degrees].
    hfov_deg : float
    places : int
        Number of places searched.
    """

    score: float
    gap: float
    explained: float
    relief_deg: float
    hfov_deg: float
    places: int

    @property
    def features(self):
        """Features of the regression by name."""
        return {
            "score": self.score,
            "gap": float(np.clip(self.gap, 0.0, 1.5)),
            "explained": self.explained,
            "log_relief": float(np.log(max(self.relief_deg, 0.02))),
            "log_hfov": float(np.log(self.hfov_deg)),
        }


@lru_cache(maxsize=1)
def table():
    """Read the shipped calibration table."""
    return json.loads(TABLE_PATH.read_text(encoding="utf-8"))


def p_correct(facts, calibration=None):
    """Probability that the best place is within a kilometre of the truth and its heading within 4 degrees.

    These are the limits of `tools/fit_locate.py`; `near_share` narrows the place to `RIGHT_M`.
    """
    calibration = calibration or table()
    values, total = facts.features, calibration["bias"]
    for name, entry in calibration["features"].items():
        standard = (values[name] - entry["mean"]) / entry["spread"]
        total += entry["weight"] * float(np.clip(standard, -LARGEST_STANDARD, LARGEST_STANDARD))
    # Searching more places finds more that fit by chance.
    total -= max(np.log(max(facts.places, 1) / calibration["places"]), 0.0)
    return float(1 / (1 + np.exp(-total)))


def gap_of(found):
    """Score of the best place minus that of the best one elsewhere."""
    for other in range(1, len(found.score)):
        if distance_m(found, 0, other) > APART_M:
            return float(found.score[0] - found.score[other])
    return float(found.score[0] - found.score[-1])


def apart_share(found, temperature=None):
    """Share of the best place and those near it in the likelihood of all candidates.

    Whatever the other quantities are, each of two places far apart that fit equally well is right half the time.

    Parameters
    ----------
    found : FittedPlaces
        Candidates, best first.
    temperature : float or None
        Worth of a unit of score; None takes the calibrated one.
    """
    worth = table()["temperature"] if temperature is None else temperature
    away = np.array([distance_m(found, 0, other) for other in range(len(found.score))])
    likelihood = np.exp(worth * (found.score - found.score[0]))
    return float(likelihood[away <= APART_M].sum() / likelihood.sum())


def near_share(found, temperature=None):
    """Share of the best place in the likelihood of all candidates near it, those within `RIGHT_M` of it included.

    Along the line of sight, a place and the field of view nearly make up for one another, so that a second place some
    hundred metres away may fit as well.

    Parameters
    ----------
    found : FittedPlaces
        Candidates, best first.
    temperature : float or None
        Worth of a unit of score; None takes the calibrated one.
    """
    worth = table()["temperature"] if temperature is None else temperature
    away = np.array([distance_m(found, 0, other) for other in range(len(found.score))])
    likelihood = np.exp(worth * (found.score - found.score[0]))
    return float(likelihood[away <= RIGHT_M].sum() / likelihood[away <= APART_M].sum())


def shares(score, best_probability, temperature=None):
    """Probabilities of the candidates: that of the best one, and the rest by likelihood, with a share for none of them.

    Parameters
    ----------
    score : (K,) array
        Best first.
    best_probability : float
    temperature : float or None
        Worth of a unit of score; None takes the calibrated one.
    """
    worth = table()["temperature"] if temperature is None else temperature
    likelihood = np.exp(worth * (np.asarray(score, float) - score[0]))
    others = likelihood[1:].sum()
    rest = (1 - best_probability) * likelihood[1:] / (others + 1.0) if others > 0 else np.zeros(0)
    return np.concatenate([[best_probability], rest])


def verdict(facts, probability, options=JudgeOptions()):  # noqa: B008 - frozen
    """Status, and a `Message` with the reason and what to do.

    Parameters
    ----------
    facts : Facts
    probability : (K,) array
        Of the candidates, best first.
    options : JudgeOptions
    """
    best = float(probability[0])
    share = f"{100 * facts.explained:.0f}"
    if best >= options.accept_at:
        return "accepted", Message(
            "From this place, the DEM horizon matches the skyline in {share} % of the columns; no place elsewhere in "
            "the area scores close.",
            share=share,
        )
    if best < options.reject_below:
        return "rejected", Message(
            "No place in the area fits the skyline clearly. The photo was probably not taken in this area, or clouds, "
            "trees or a narrow view hide what would decide it. Choose another area, or give a sky mask or the field "
            "of view."
        )
    return "ambiguous", Message(
        "This place fits best, but others in the area fit nearly as well, or the fit is weak. Compare the candidates, "
        "or choose a smaller area."
    )


def region(score, temperature=None):
    """Places that together hold 90 % of the probability, if one of the places is right.

    Parameters
    ----------
    score : (K,) array
        Of the fitted places of the grid.
    temperature : float or None
        Worth of a unit of score; None takes the calibrated one.

    Returns
    -------
    (M,) int array
        Indices, best first.
    """
    worth = table()["region_temperature"] if temperature is None else temperature
    score = np.asarray(score, float)
    order = np.argsort(-score, kind="stable")
    probability = np.exp(worth * (score[order] - score[order[0]]))
    total = np.cumsum(probability) / probability.sum()
    return order[: int(np.searchsorted(total, MASS)) + 1]


@dataclass(frozen=True)
class Ellipse:
    """Error ellipse of a place that holds 90 % if the place is the right one.

    Attributes
    ----------
    major_m, minor_m : float
        Half axes [m].
    azimuth_deg : float
        Direction of the long axis, 0 to 180 [degrees].
    focal_correlation : float
        Correlation of the error along the long axis with that of the focal length: -1 to 1.
    """

    major_m: float
    minor_m: float
    azimuth_deg: float
    focal_correlation: float


def ellipse(curvature, focal_slope, focal_sigma, floor_m):
    """Error ellipse of a place from the shape of the score around it.

    The pose and the focal length were fitted anew at each displaced place. The curvature is therefore that of the place
    alone, with everything else free, and the change of the fitted focal length says how far the two hide in each other.

    Parameters
    ----------
    curvature : (2, 2) array
        Of the negative score by east and north [1/m2].
    focal_slope : (2,) array
        Change of the log focal length with east and north [1/m].
    focal_sigma : float
        Relative standard deviation of the focal length if the place is known.
    floor_m : float
        Standard deviation that the DEM's cells leave in any direction [m].

    Returns
    -------
    Ellipse or None
        None if the curvature is not known.
    """
    if not np.isfinite(curvature).all():
        return None
    values, axes = np.linalg.eigh(curvature * table()["effective_columns"])
    widest_m = 20 * floor_m
    variance = np.minimum(1 / np.maximum(values, widest_m**-2), widest_m**2) + floor_m**2
    long = int(variance.argmax())
    east, north = axes[:, long]
    along = float(focal_slope @ axes[:, long])
    covariance = along * variance[long]
    spread = np.sqrt(focal_sigma**2 + along**2 * variance[long])
    return Ellipse(
        NINETY * float(np.sqrt(variance[long])),
        NINETY * float(np.sqrt(variance[1 - long])),
        float(np.degrees(np.arctan2(east, north)) % 180),
        float(covariance / (spread * np.sqrt(variance[long]))) if np.isfinite(along) else 0.0,
    )
