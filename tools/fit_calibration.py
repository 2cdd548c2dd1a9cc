"""Fit the table that turns the quantities of a fit into a probability: `core/match/calibration.json`.

    python tools/fit_calibration.py collect rows.jsonl --count 400 --seed 11
    python tools/fit_calibration.py fit rows.jsonl [--test other.jsonl] [--former table.json] [--write]

`collect` renders simulated photographs (benchmarks/simulated_cases.py, level 'full'), solves them without the truth and
writes one line per photograph: features, errors and scores of all answers. `fit` fits a logistic regression with a
small ridge penalty, prints the reliability of the probabilities on unseen photographs (two-fold, or --test), and
replaces the table if --write is given. With --former the penalty draws the weights towards those of a former table
instead of 0: a few hundred photographs say little about the weaker quantities.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "build" / "plugins"), str(ROOT / "benchmarks")]

from skyline_viewshed.core.base.angles import difference  # noqa: E402
from skyline_viewshed.core.match.posterior import LARGEST_STANDARD, TABLE_PATH, features, likelihood_share  # noqa: E402

USED = ("relative_gap", "score", "log_relief", "log_misfit", "log_hfov")
RIGHT_DEG = 3.0
PENALTY = 1.0
LEAST_FACTOR = 1.0


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    taking = commands.add_parser("collect")
    taking.add_argument("rows", type=Path)
    taking.add_argument("--count", type=int, default=400)
    taking.add_argument("--seed", type=int, default=11)
    fitting = commands.add_parser("fit")
    fitting.add_argument("rows", type=Path)
    fitting.add_argument("--test", type=Path)
    fitting.add_argument("--origin", default=None, help="one sentence on where the rows come from")
    fitting.add_argument("--former", type=Path, help="table towards whose weights the penalty draws")
    fitting.add_argument("--write", action="store_true")
    given = parser.parse_args(arguments)
    if given.command == "collect":
        collect(given.rows, given.count, given.seed)
    else:
        former = json.loads(given.former.read_text(encoding="utf-8")) if given.former else None
        study(read_rows(given.rows), given.test and read_rows(given.test), former, given.origin, given.write)


def collect(path, count, seed):
    """Solve `count` simulated photographs and append a line for each."""
    from simulated_cases import dem_of, dem_paths, draw_case, take

    paths = dem_paths(ROOT / "build" / "simulated")
    with open(path, "a", encoding="utf-8") as file, tempfile.TemporaryDirectory() as folder:
        for index in range(count):
            case = draw_case(seed, index, "full", paths)
            photo_path, _ = take(case, folder)
            solved = solve(photo_path, dem_of(case.dem_path))
            Path(photo_path).unlink()
            if solved is None:
                continue
            finding = solved[0].finding
            error = difference(finding.heading_deg, case.pose.heading_deg)
            file.write(json.dumps(_row(case.name, finding, error)) + "\n")
            file.flush()


def solve(path, dem):
    """Find the matcher's answers before they are judged, and the evidence; None if there is no skyline to match."""
    from skyline_viewshed.core.base.errors import PhotoError
    from skyline_viewshed.core.base.terrain import Observer
    from skyline_viewshed.core.base.uncertainty import TYPICAL_POSITION_ERROR_M
    from skyline_viewshed.core.eyes import HorizonCache, other_eyes
    from skyline_viewshed.core.io.photo import read_photo
    from skyline_viewshed.core.match.inputs import MatchInputs
    from skyline_viewshed.core.match.prior import camera_prior
    from skyline_viewshed.core.match.robust import find_answers
    from skyline_viewshed.core.pipeline import OrientOptions
    from skyline_viewshed.core.skyline.evidence import skyline_evidence

    options = OrientOptions()
    photo = read_photo(path, 1024)
    metadata = photo.metadata
    observer = Observer(metadata.longitude_deg, metadata.latitude_deg)
    try:
        evidence = skyline_evidence(photo.pixels, options.skyline, metadata.width_px, metadata.height_px)
        cache = HorizonCache()
        with cache.station():
            horizon = cache.profile(dem, observer, options.horizon)
            inner = cache.inner(dem, observer, options.inner)
            eyes = other_eyes(dem, observer, horizon, metadata.altitude_m, options, cache)
    except PhotoError:
        return None
    position = metadata.position_error_m or TYPICAL_POSITION_ERROR_M
    facts = {"position_error_m": position, "inner": inner, "other_eyes": eyes}
    inputs = MatchInputs(evidence, camera_prior(metadata), horizon, **facts)
    return find_answers(inputs, options.robust), evidence


def _row(name, finding, error_deg):
    return {
        "photo": name,
        "features": features(finding),
        "error_deg": np.round(error_deg, 4).tolist(),
        "score": np.round(finding.score, 5).tolist(),
        "sigma_deg": np.round(finding.sigma_deg, 4).tolist(),
    }


def read_rows(path):
    """Read rows as written by `collect`."""
    return [json.loads(line) for line in Path(path).read_text(encoding="utf-8").splitlines() if line.strip()]


def study(rows, test, former, origin, write):
    """Fit, print the check on unseen rows, and write the table if requested."""
    if test:
        print_check("other photographs", probabilities(fit_table(rows, former), test), test)
    else:
        halves = rows[::2], rows[1::2]
        unseen = [probabilities(fit_table(halves[1 - i], former), halves[i]) for i in (0, 1)]
        print_check("two-fold", np.concatenate(unseen), halves[0] + halves[1])
    table = fit_table(rows + (test or []), former)
    table = {"origin": origin or f"{len(rows) + len(test or [])} simulated photographs", **table}
    print(json.dumps(table, indent=1))
    if write:
        TABLE_PATH.write_text(json.dumps(table, indent=1) + "\n", encoding="utf-8")
        print(f"written: {TABLE_PATH}")


def fit_table(rows, former=None):
    """Fit the logistic regression, the temperature and the widening of the intervals."""
    values = np.array([[row["features"][name] for name in USED] for row in rows])
    right = np.array([abs(row["error_deg"][0]) < RIGHT_DEG for row in rows])
    mean, spread = values.mean(axis=0), values.std(axis=0) + 1e-9
    standard = np.clip((values - mean) / spread, -LARGEST_STANDARD, LARGEST_STANDARD)
    sign = 2.0 * right - 1
    centre = np.array([former["features"][name]["weight"] if former else 0.0 for name in USED])

    def loss(weight):
        drawn = weight[1:] - centre
        return np.logaddexp(0, -sign * (standard @ weight[1:] + weight[0])).sum() + PENALTY * drawn @ drawn

    weight = minimize(loss, np.zeros(len(USED) + 1)).x
    entries = {
        name: {"mean": round(m, 4), "spread": round(s, 4), "weight": round(w, 4)}
        for name, m, s, w in zip(USED, mean.tolist(), spread.tolist(), weight[1:].tolist())
    }
    return {
        "features": entries,
        "bias": round(float(weight[0]), 4),
        "temperature": fit_temperature(rows),
        "sigma_factor": fit_sigma_factor(rows),
    }


def fit_temperature(rows):
    """Fit the temperature T at which exp(T score) predicts the right one of a photograph's answers with least loss."""

    def surprise(temperature):
        total = 0.0
        for row in rows:
            right = np.flatnonzero(np.abs(row["error_deg"]) < RIGHT_DEG)
            if len(right):
                scaled = temperature * np.array(row["score"])
                total += np.logaddexp.reduce(scaled) - scaled[right[0]]
        return total

    grid = np.arange(1.0, 30.5, 0.5)
    return float(grid[int(np.argmin([surprise(t) for t in grid]))])


def fit_sigma_factor(rows):
    """Fit the widening with which 90 % of the right headings lie within their 90 % interval, never below a floor.

    The floor allows for errors that no simulated scene has: those of the truth, the DEM and the clock.
    """
    ratio = [abs(r["error_deg"][0]) / r["sigma_deg"][0] for r in rows if abs(r["error_deg"][0]) < RIGHT_DEG]
    return round(max(float(np.percentile(ratio, 90)) / 1.645, LEAST_FACTOR), 3)


def probabilities(table, rows):
    """Compute p_correct of rows by a table."""
    total = np.full(len(rows), table["bias"])
    for name, entry in table["features"].items():
        value = np.array([row["features"][name] for row in rows])
        standard = np.clip((value - entry["mean"]) / entry["spread"], -LARGEST_STANDARD, LARGEST_STANDARD)
        total += entry["weight"] * standard
    limit = np.array([likelihood_share(row["score"], table["temperature"]) for row in rows])
    return np.minimum(1 / (1 + np.exp(-total)), limit)


def print_check(name, probability, rows):
    """Print reliability, and risk against coverage."""
    right = np.array([abs(row["error_deg"][0]) < RIGHT_DEG for row in rows])
    print(f"{name}: {len(rows)} photographs, {right.mean():.0%} right")
    for low, high in ((0, 0.2), (0.2, 0.5), (0.5, 0.8), (0.8, 0.9), (0.9, 0.95), (0.95, 1.01)):
        held = (probability >= low) & (probability < high)
        if held.any():
            print(f"  p {low:.2f} to {high:.2f}: {held.sum():4d}, said {probability[held].mean():.2f},"
                  f" right {right[held].mean():.2f}")  # fmt: skip
    for limit in (0.85, 0.9, 0.92, 0.95):
        held = probability >= limit
        print(
            f"  accepted at {limit}: {(held & right).sum()} of {right.sum()} right ones, {(held & ~right).sum()} wrong"
        )


if __name__ == "__main__":
    main()
