"""Fit the probability of a place, `core/locate/calibration.json`, from searches: `fit_locate.py rows.jsonl [--write]`.

The rows come from `benchmarks/bench_locate.py`: one search each, in the right area or in another range. A third kind is
derived from the searches of the right area: without the candidates near the true place, the rest is the answer of a
search of an area in which the photograph was not taken. The regression is checked with each region left out in turn.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np

TABLE = Path(__file__).resolve().parent.parent / "core" / "locate" / "calibration.json"
FEATURES = ("gap", "score")
RIGHT_M, NEAR_M, APART_M = 1_000.0, 2_000.0, 1_000.0
RIDGE = 0.3
TEMPERATURE = 8.0
"""Worth of a unit of score. Of 60 searches, `apart_share` has its greatest log-likelihood here: -19.2, against -20.2 at
6.5 and -20.9 at 10."""
LARGEST_GAP, LARGEST_STANDARD = 1.5, 2.5


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", type=Path)
    parser.add_argument("--write", action="store_true", help="write the table")
    given = parser.parse_args(arguments)
    rows = unique(json.loads(line) for line in given.rows.read_text(encoding="utf-8").splitlines())
    cases = cases_of(rows)
    region = np.array([case["region"] for case in cases])
    right = np.array([case["right"] for case in cases])
    values = np.array([[case[name] for name in FEATURES] for case in cases])
    held = np.zeros(len(cases))
    for left_out in sorted(set(region)):
        inside = region == left_out
        model = fit(values[~inside], right[~inside])
        held[inside] = predict(model, values[inside])
    for low, high in ((0, 0.1), (0.1, 0.5), (0.5, 0.85), (0.85, 1.01)):
        part = (held >= low) & (held < high)
        print(f"left out: p in [{low}, {high}): {part.sum()} cases, {right[part].sum()} right, {held[part].mean():.2f}"
              if part.any() else f"left out: p in [{low}, {high}): none")  # fmt: skip
    for index in np.flatnonzero((held >= 0.85) & ~right):
        print("accepted and wrong:", cases[index])
    model = fit(values, right)
    kinds = {kind: sum(case["kind"] == kind for case in cases) for kind in ("own", "other", "derived")}
    table = {
        "origin": f"tools/fit_locate.py on {kinds['own']} searches of the right area, {kinds['other']} of other "
        f"ranges, and {kinds['derived']} derived from the first",
        "bias": round(model[2][0], 3),
        "temperature": TEMPERATURE,
        "region_temperature": 6.5,
        "effective_columns": 15.0,
        "places": 5200,
        "features": {
            name: {"mean": round(mean, 3), "spread": round(spread, 3), "weight": round(weight, 3)}
            for name, mean, spread, weight in zip(FEATURES, model[0], model[1], model[2][1:])
        },
    }
    print(json.dumps(table, indent=1))
    if given.write:
        TABLE.write_text(json.dumps(table, indent=1) + "\n", encoding="utf-8")


def unique(rows):
    """One row for each photograph, region and kind; the last one counts."""
    return list({(row["photo"], row["reg"], row["kind"]): row for row in rows}.values())


def cases_of(rows):
    """Right and wrong answers with their features."""
    cases = []
    for row in rows:
        own = row["kind"] == "own"
        right = bool(own and row["d"][0] < RIGHT_M and (row["head_err"] is None or row["head_err"] < 4.0))
        gap = min(max(row["f"]["gap"], 0.0), LARGEST_GAP)
        case = {"region": row["home"], "photo": row["photo"], "gap": gap, "score": row["f"]["score"], "right": right}
        cases.append({**case, "kind": "own" if own else "other"})
        rest = [(d, score) for d, score in zip(row["d"], row["score"]) if d > NEAR_M]
        if right and rest:
            apart = [score for d, score in rest[1:] if abs(d - rest[0][0]) > APART_M]
            gap = rest[0][1] - (apart[0] if apart else rest[-1][1])
            cases.append({**case, "gap": gap, "score": rest[0][1], "right": False, "kind": "derived"})
    return cases


def fit(values, right):
    """Mean, spread and weights of a logistic regression with a ridge, by Newton's method."""
    mean, spread = values.mean(axis=0), values.std(axis=0) + 1e-9
    terms = design(values, mean, spread)
    weights = np.zeros(terms.shape[1])
    for _ in range(50):
        chance = 1 / (1 + np.exp(-terms @ weights))
        penalty = RIDGE * np.r_[0.0, np.ones(len(weights) - 1)]
        gradient = terms.T @ (right - chance) - penalty * weights
        hessian = (terms * (chance * (1 - chance))[:, None]).T @ terms + np.diag(penalty + 1e-9)
        weights = weights + np.linalg.solve(hessian, gradient)
    return mean, spread, weights


def design(values, mean, spread):
    standard = np.clip((values - mean) / spread, -LARGEST_STANDARD, LARGEST_STANDARD)
    return np.column_stack([np.ones(len(values)), standard])


def predict(model, values):
    return 1 / (1 + np.exp(-design(values, model[0], model[1]) @ model[2]))


if __name__ == "__main__":
    main()
