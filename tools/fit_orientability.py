"""Fit the weights of `orientability`: `fit_orientability.py DATA --photos P.json --views V.json --simulated S.json`.

DATA is the folder that `benchmarks/bench_accuracy.py` and `benchmarks/bench_views.py` measured, and the files are what
these and `benchmarks/bench_simulated.py` wrote. Each photograph's horizon is computed at its true place and described
in its true direction, from the DEM alone; its answer is right within 3 degrees. The weights cannot be negative, since
each quantity is one in which more is easier, and small data would otherwise turn some around. The regression is checked
on all pictures with each region (photographs, views and simulated scenes) left out in turn. `--write` writes
`core/locate/orientability.json`.
"""

from __future__ import annotations

import argparse
import csv
import json
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import minimize
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.horizon.horizon import horizon_profile
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.locate.unique import LARGEST_STANDARD, SAME_DEG, TABLE_PATH, features_of, traits_of
from skyline_viewshed.core.planning import PredictOptions

sys.path.insert(0, str(Path(__file__).resolve().parent))
from orientability_figure import drawing  # noqa: E402

FEATURES = ("log_gap",)
RIDGE = 3.0
RASTERS = (".tif", ".tiff", ".hgt", ".vrt", ".asc", ".img")
FILES = ("photos", "views", "simulated")
KINDS = (*FILES, "anywhere")
"""Simulated views of a ridge, and simulated views from any place, are told apart."""


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder of folders with truth.csv and dem/")
    for kind in FILES:
        parser.add_argument(f"--{kind}", type=Path, nargs="*", default=[])
    parser.add_argument("--write", action="store_true", help="write the table")
    parser.add_argument("--figure", type=Path, help="draw the ROC curves and the calibration as SVG")
    given = parser.parse_args(arguments)
    cases = [case for kind in FILES for path in getattr(given, kind) for case in read_cases(kind, path, given.data)]
    cases = list(described(cases))
    values = np.array([case["values"] for case in cases])
    twins, right = (np.array([case[name] for case in cases]) for name in ("twins", "right"))
    region, kind = (np.array([case[name] for case in cases]) for name in ("region", "kind"))
    held = np.zeros(len(cases))
    for left_out in sorted(set(region)):
        inside = region == left_out
        held[inside] = predict(fit(values[~inside], twins[~inside], right[~inside]), values[inside], twins[inside])
    parts = {name: (kind == name) | (name == "all") for name in (*KINDS, "all")}
    parts["photos and views"] = (kind == "photos") | (kind == "views")
    parts["all simulated"] = ~parts["photos and views"]
    clear = np.array([case.get("clear", False) for case in cases])
    parts["simulated, no clouds and no foreground"] = parts["all simulated"] & clear
    parts["simulated, the others"] = parts["all simulated"] & ~clear
    for name, part in parts.items():
        report(name, held[part], right[part])
    if len(FEATURES) == 1:
        # One quantity sorts the pictures the same with any weights, so that its order owes nothing to a fit.
        areas = ", ".join(f"{name} {auc(values[part, 0], right[part]):.3f}" for name, part in parts.items())
        print(f"AUC of {FEATURES[0]} itself: {areas}")
    if given.figure:
        names = "photos and views", "all simulated", "all"
        groups = [(name, held[parts[name]], right[parts[name]]) for name in names if parts[name].any()]
        given.figure.write_text(drawing(groups, bands_of(held, right)), encoding="utf-8")
    model = fit(values, twins, right)
    counts = ", ".join(f"{int((kind == name).sum())} {name} ({int(right[kind == name].sum())} right)" for name in KINDS)
    table = table_of(model, counts)
    print(json.dumps(table, indent=1))
    if given.write:
        TABLE_PATH.write_text(json.dumps(table, indent=1) + "\n", encoding="utf-8")


def read_cases(kind, path, data):
    """Place, direction, lens and answer of each photograph of a benchmark's file."""
    rows = json.loads(path.read_text(encoding="utf-8"))
    rows = rows if isinstance(rows, list) else rows["views" if kind == "views" else "photos"]
    for row in rows:
        case = {"kind": kind, "photo": row["photo"], "hfov_deg": row["hfov_deg"]}
        case["right"] = row["error_deg"] is not None and abs(row["error_deg"]) < SAME_DEG
        if kind == "simulated":
            dem = Path(row["dem"])
            if not dem.exists():
                sys.exit(f"{path}: {dem} does not exist; make the scenes anew with benchmarks/bench_simulated.py")
            case["clear"] = row["clouds"] == row["foreground"] == "none"
            case["kind"] = "anywhere" if row["group"] == "anywhere" else kind
            place = row["true_longitude_deg"], row["true_latitude_deg"]
            case.update(dem=dem, place=place, heading_deg=row["heading_deg"], region=simulated_region(dem, data))
        else:
            folder = data / row["folder"]
            dem = next(one for one in sorted((folder / "dem").iterdir()) if one.suffix.lower() in RASTERS)
            case.update(dem=dem, place=place_of(folder, row["photo"]), heading_deg=row["truth_deg"])
            case["region"] = region_of(row["folder"])
        if None not in (case["heading_deg"], case["hfov_deg"], *case["place"]):
            yield case


def region_of(folder):
    """Region of a folder; photographs of one trek in two folders must not check each other."""
    return folder.split("-")[0] if folder.startswith("khumbu") else folder


def simulated_region(dem, data):
    """A scene on the DEM of a region of photographs belongs to that region."""
    inside = dem.parent.name == "dem" and (data / dem.parent.parent.name / "truth.csv").exists()
    return region_of(dem.parent.parent.name) if inside else dem.stem


def place_of(folder, photo):
    """(longitude, latitude) of a row of truth.csv [degrees]; None where it is empty."""
    with open(folder / "truth.csv", newline="", encoding="utf-8-sig") as file:
        row = next(line for line in csv.DictReader(file) if line["photo"] == photo)
    return tuple(float(row[name]) if row.get(name) else None for name in ("longitude_deg", "latitude_deg"))


def described(cases):
    """Add the quantities of the horizon; photographs without a usable one are left out."""
    horizons = {}
    for case in cases:
        key = str(case["dem"]), *case["place"]
        try:
            if key not in horizons:
                horizons[key] = horizon_profile(open_dem(key[0]), Observer(*case["place"]), PredictOptions().horizon)
        except PhotoError as error:
            print(f"{case['photo']}: {error.message}")
            continue
        horizon, at = horizons[key], int(round(case["heading_deg"])) % 360
        traits = traits_of(
            horizon.elevation_deg, horizon.distance_m, case["hfov_deg"], horizon.cell_m, PredictOptions().unique, [at]
        )
        values = [features_of(traits)[name][at] for name in FEATURES]
        if np.isfinite(values).all():
            yield {**case, "values": values, "twins": traits.twins[at]}


def fit(values, twins, right):
    """Mean, spread, bias and weights of the regression whose promise is shared among the twins."""
    mean, spread = values.mean(axis=0), values.std(axis=0) + 1e-9

    def loss(parameters):
        chance = np.clip(predict((mean, spread, parameters), values, twins), 1e-6, 1 - 1e-6)
        likelihood = np.where(right, np.log(chance), np.log(1 - chance)).sum()
        return RIDGE * np.square(parameters[1:]).sum() / 2 - likelihood

    bounds = [(None, None)] + [(0, None)] * values.shape[1]
    return mean, spread, minimize(loss, np.r_[1.0, np.full(values.shape[1], 0.3)], bounds=bounds).x


def predict(model, values, twins):
    mean, spread, parameters = model
    standard = np.clip((values - mean) / spread, -LARGEST_STANDARD, LARGEST_STANDARD)
    return 1 / (1 + np.exp(-parameters[0] - standard @ parameters[1:])) / (1 + twins)


def auc(chance, right):
    """Share of pairs of a right and a wrong answer in which the right one has the larger probability."""
    if right.all() or not right.any():
        return float("nan")
    more = chance[right][:, None] - chance[~right]
    return float(((more > 0) + 0.5 * (more == 0)).mean())


def bands_of(chance, right, count=10):
    """Mean probability, share of right answers and number of pictures of equal groups, the least likely first."""
    groups = [at for at in np.array_split(np.argsort(chance, kind="stable"), count) if len(at)]
    return [(float(chance[at].mean()), float(right[at].mean()), len(at)) for at in groups]


def report(name, chance, right):
    """Print the AUC and the calibration in tenths."""
    if not len(right):
        return
    bands = bands_of(chance, right)
    shares = ", ".join(f"{predicted:.2f}/{share:.2f}" for predicted, share, _ in bands)
    error = np.average([abs(predicted - share) for predicted, share, _ in bands], weights=[n for *_, n in bands])
    wrong = int((~right).sum())
    print(f"{name}: {len(right)}, {wrong} wrong, AUC {auc(chance, right):.3f}, mean error {error:.2f}; {shares}")


def table_of(model, counts):
    mean, spread, parameters = model
    rows = zip(FEATURES, mean, spread, parameters[1:])
    return {
        "origin": f"tools/fit_orientability.py on {counts}",
        "bias": round(float(parameters[0]), 3),
        "features": {
            name: {"mean": round(float(m), 3), "spread": round(float(s), 3), "weight": round(float(w), 3)}
            for name, m, s, w in rows
        },
    }


if __name__ == "__main__":
    main()
