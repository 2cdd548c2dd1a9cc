"""The fit of the foreground's weight finds the weight by which made answers were drawn."""

from __future__ import annotations

import numpy as np
import pytest
from scripts import ROOT, script


@pytest.fixture
def tool(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "tools"))  # it imports its neighbour
    return script("tools/fit_foreground.py")


def drawn(weight, count=4_000, seed=3):
    """Pictures of five answers, of which the right one is drawn by score and foreground."""
    rng = np.random.default_rng(seed)
    cases = []
    for _ in range(count):
        score, above = rng.normal(0, 1, 5), rng.uniform(0, 1, 5)
        share = np.exp(score + weight * above)
        cases.append((score, above, np.arange(5) == rng.choice(5, p=share / share.sum())))
    return cases


@pytest.mark.parametrize("weight", [0.0, 2.0])
def test_the_weight_is_found(tool, weight):
    assert tool.fit(drawn(weight)) == pytest.approx(weight, abs=0.25)


def test_the_likelihood_is_that_of_the_right_answers(tool):
    case = (np.log([1.0, 2.0, 1.0]), np.array([1.0, 0.0, 0.0]), np.array([True, False, True]))
    assert tool.likelihood(np.log(3.0), [case]) == pytest.approx(np.log(4 / 6))
