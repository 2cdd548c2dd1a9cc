"""Fit the weight of ground above the horizon: `ForegroundOptions` in core/match/second.py.

    python tools/fit_foreground.py collect rows.jsonl --level full --count 240 --seed 9001
    python tools/fit_foreground.py collect rows.jsonl --level adverse --count 200 --seed 9002
    python tools/fit_foreground.py fit rows.jsonl

`collect` renders simulated photographs, solves them without the truth and appends one line per photograph: for each
answer its error, its score without the foreground, and how much ground lies above its horizon. `fit` fits a conditional
logit over the answers to each picture, with the scores at the calibrated temperature, and prints the weight and the
log-likelihood of pictures that did not take part (four-fold). Copy the weight to `ForegroundOptions.limit`.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from pathlib import Path

import numpy as np
from fit_calibration import RIGHT_DEG, ROOT, read_rows, solve
from scipy.optimize import minimize_scalar
from scipy.special import logsumexp
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.match.posterior import table
from skyline_viewshed.core.match.second import ForegroundEvidence, ForegroundOptions

PENALTY = 0.1
"""Ridge penalty on the weight."""


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    taking = commands.add_parser("collect")
    taking.add_argument("rows", type=Path)
    taking.add_argument("--level", choices=("clean", "full", "adverse"), default="full")
    taking.add_argument("--count", type=int, default=240)
    taking.add_argument("--seed", type=int, default=9001)
    commands.add_parser("fit").add_argument("rows", type=Path)
    given = parser.parse_args(arguments)
    if given.command == "collect":
        collect(given.rows, given.level, given.count, given.seed)
    else:
        study(read_rows(given.rows))


def collect(path, level, count, seed):
    """Solve `count` simulated photographs and append a line for each."""
    from simulated_cases import dem_of, dem_paths, draw_case, take

    paths = dem_paths(ROOT / "build" / "simulated")
    with tempfile.TemporaryDirectory() as folder:
        for index in range(count):
            case = draw_case(seed, index, level, paths)
            photo_path, _ = take(case, folder)
            solved = solve(photo_path, dem_of(case.dem_path))
            Path(photo_path).unlink()
            if solved is not None:
                with open(path, "a", encoding="utf-8") as file:
                    file.write(json.dumps(_row(case, *solved)) + "\n")


def _row(case, answers, evidence):
    above, log_likelihood = np.zeros(len(answers.trials)), np.zeros(len(answers.trials))
    for index, (eye, trial) in enumerate(zip(answers.eye, answers.trials)):
        one = ForegroundEvidence(answers.objectives[eye], evidence.sky_map)
        above[index], log_likelihood[index] = one.saturated(trial[None])[0], one.score(trial[None])[0]
    # The scores hold the foreground, relative to the answer for which it says most.
    score = answers.finding.score - (log_likelihood - log_likelihood.max()) / table()["temperature"]
    error = difference(answers.finding.heading_deg, case.pose.heading_deg)
    return {"photo": case.name, "error_deg": error.tolist(), "score": score.tolist(), "above": above.tolist()}


def study(rows):
    """Fit, and print the weight and the log-likelihood of unseen pictures, with the foreground and without."""
    cases = [_case(row) for row in rows if (np.abs(row["error_deg"]) < RIGHT_DEG).any()]
    folds = [cases[start::4] for start in range(4)]
    unseen = sum(
        likelihood(fit([case for other in folds if other is not fold for case in other]), fold) for fold in folds
    )
    print(f"{len(cases)} pictures with a right answer among all")
    print(f"log-likelihood of unseen ones: {unseen:.1f}; without the foreground: {likelihood(0.0, cases):.1f}")
    print(f"limit {fit(cases):.2f}; now {ForegroundOptions().limit}")


def _case(row):
    return np.array(row["score"]) * table()["temperature"], np.array(row["above"]), np.abs(row["error_deg"]) < RIGHT_DEG


def fit(cases):
    """Weight of ground above the horizon."""
    return minimize_scalar(lambda weight: PENALTY * weight**2 - likelihood(weight, cases), (0.0, 1.0)).x


def likelihood(weight, cases):
    """Sum over pictures of the logarithm of the right answers' share."""
    total = 0.0
    for score, above, right in cases:
        value = score + weight * above
        total += logsumexp(value[right]) - logsumexp(value)
    return total


if __name__ == "__main__":
    main()
