"""Calibration of p_correct: a logistic regression on what a fit knows about itself.

Fitted by `tools/fit_calibration.py`; the origin of the present figures is stated there and in docs/accuracy.md.
"""

from __future__ import annotations

import numpy as np

FEATURES = ("relative gap to the second answer", "score", "share of columns explained", "log relief in the frame")

CALIBRATION = {
    "mean": np.array([0.0855, 3.64, 0.7, 0.0]),
    "spread": np.array([0.0952, 0.867, 0.15, 0.7]),
    "weight": np.array([2.02, 0.47, 0.0, 0.0]),
    "bias": 0.636,
    "sharpness": 30.0,
}
