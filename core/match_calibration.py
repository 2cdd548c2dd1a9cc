"""The calibration table: how what a fit knows about itself turns into a probability.

`match_calibration.json` holds a logistic regression on the quantities of `features`, the temperature that makes
scores into likelihoods, and the factor by which the headings' standard deviations are widened. It is fitted on
simulated photographs by `tools/fit_calibration.py`, which also states how well it does on others.
"""

from __future__ import annotations

import json
from functools import lru_cache
from pathlib import Path

import numpy as np

TABLE_PATH = Path(__file__).with_name("match_calibration.json")
LARGEST_STANDARD = 3.0
"""Features are cut at this many standard deviations: beyond what the table has seen nothing becomes surer."""


def features(finding):
    """What tells right answers from wrong ones, by name."""
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


@lru_cache(maxsize=1)
def table():
    """The shipped table as plain values."""
    return json.loads(TABLE_PATH.read_text(encoding="utf-8"))


def p_correct(finding, calibration=None):
    """Probability that the best answer is within 3 degrees of the truth.

    The regression's word, but never more than the best answer's share of the likelihood among all answers: whatever
    else speaks for a fit, of two equal ones each is right half the time.
    """
    calibration = calibration or table()
    values = features(finding)
    total = calibration["bias"]
    for name, entry in calibration["features"].items():
        standard = (values[name] - entry["mean"]) / entry["spread"]
        total += entry["weight"] * float(np.clip(standard, -LARGEST_STANDARD, LARGEST_STANDARD))
    return float(min(1 / (1 + np.exp(-total)), likelihood_share(finding.score, calibration["temperature"])))


def likelihood_share(score, temperature):
    """Share of the first of some scores in the sum of their likelihoods exp(temperature * score)."""
    score = np.asarray(score, float)
    return float(1 / np.exp(temperature * (score - score[0])).sum())
