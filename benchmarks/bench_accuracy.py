"""Measure the accuracy on photographs of known heading: `make bench-accuracy DATA=folder [METHOD=..] [COMPASS=..]`.

`folder/truth.csv` has the columns photo, group, latitude_deg, longitude_deg, heading_deg, pitch_deg, roll_deg and
optionally height_orthometric_m, given_hfov_deg, focal_length_35mm (for an empty cell the value comes from EXIF or the
DEM). `folder/photos/` holds the pictures and `folder/dem/` one raster. Positions come from EXIF if present, otherwise
from the table. The benchmark uses `core.batch`, as the algorithms do, and writes `build/accuracy.json`.
"""

from __future__ import annotations

import argparse
import csv
import json
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.batch import PhotoRequest, orient_request
from skyline_viewshed.core.eyes import HorizonCache
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.pipeline import OrientOptions

LIMITS_DEG = (0.5, 1.0, 1.5, 3.0, 10.0)
RASTERS = (".tif", ".tiff", ".hgt", ".vrt", ".asc", ".img")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder with truth.csv, photos/ and dem/")
    parser.add_argument("--method", choices=("robust", "paper"), default="robust")
    parser.add_argument("--compass", choices=("ignore", "prior"), default="ignore")
    parser.add_argument("--eye", choices=("dem", "table"), default="dem", help="eye from the DEM or from the table")
    parser.add_argument("--no-paper", action="store_true", help="leave out the paper's method beside the robust one")
    parser.add_argument("--output", type=Path, default=Path("build/accuracy.json"))
    given = parser.parse_args(arguments)
    report = measure(given.data, given.method, given.compass, given.eye, not given.no_paper)
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.write_text(json.dumps(report, indent=1), encoding="utf-8")
    print(f"written: {given.output}")


def measure(folder, method="robust", compass="ignore", eye="dem", beside_paper=True):
    """Orient every photograph of a folder, print the results, and return rows and summaries."""
    dem = open_dem(str(dem_of(folder)))
    options = OrientOptions(method=method, compass=compass)
    caches = HorizonCache(), HorizonCache()
    rows = []
    for line in read_truth(folder):
        started = time.process_time()
        request = request_of(folder, line, eye)
        row = result_row(line, orient_request(request, dem, options, caches[0]))
        row["cpu_s"] = time.process_time() - started
        if beside_paper and method != "paper":
            paper = result_row(line, orient_request(request, dem, replace(options, method="paper"), caches[1]))
            row["paper_error_deg"] = paper["error_deg"]
        rows.append(row)
        print(line_of(row), flush=True)
    report = {"folder": str(folder), "method": method, "compass": compass, "eye": eye, "photos": rows}
    report["summary"] = summarise(rows)
    print_summary(report["summary"])
    return report


def dem_of(folder):
    """Path of the raster in folder/dem."""
    found = sorted(p for p in (Path(folder) / "dem").iterdir() if p.suffix.lower() in RASTERS)
    if len(found) != 1:
        sys.exit(f"{folder}/dem must hold exactly one raster, not {len(found)}")
    return found[0]


def read_truth(folder):
    """Read the rows of truth.csv; numbers as floats, empty cells as None."""
    with open(Path(folder) / "truth.csv", newline="", encoding="utf-8-sig") as file:
        for line in csv.DictReader(file):
            yield {key: _number(value) if key not in ("photo", "group") else value for key, value in line.items()}


def _number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def request_of(folder, line, eye="dem"):
    """Build the request for one photograph from its row of the table."""
    return PhotoRequest(
        str(Path(folder) / "photos" / line["photo"]),
        longitude_deg=line.get("longitude_deg"),
        latitude_deg=line.get("latitude_deg"),
        prefer_photo_position=True,
        eye_elevation_m=line.get("height_orthometric_m") if eye == "table" else None,
        hfov_deg=line.get("given_hfov_deg"),
        focal_length_35mm=line.get("focal_length_35mm"),
    )


def result_row(line, oriented):
    """Combine the answer for one photograph with its truth."""
    answer, best = oriented.orientation, oriented.orientation.best
    truth = line.get("heading_deg")
    compass = oriented.compass_true_deg
    covered = None
    if best is not None and truth is not None and answer.heading_lo_deg is not None:
        width = (answer.heading_hi_deg - answer.heading_lo_deg) % 360
        covered = bool((truth - answer.heading_lo_deg) % 360 <= width)
    return {
        "photo": line["photo"],
        "group": line.get("group", ""),
        "truth_deg": truth,
        "heading_deg": best and best.pose.heading_deg,
        "pitch_deg": best and best.pose.pitch_deg,
        "roll_deg": best and best.pose.roll_deg,
        "hfov_deg": best and best.camera.hfov_deg,
        "error_deg": _error(best and best.pose.heading_deg, truth),
        "compass_error_deg": _error(compass, truth),
        "heading_lo_deg": answer.heading_lo_deg,
        "heading_hi_deg": answer.heading_hi_deg,
        "covered": covered,
        "p_correct": answer.p_correct,
        "status": answer.status,
        "message": answer.message,
        "heading_2_deg": answer.candidates[1].pose.heading_deg if len(answer.candidates) > 1 else None,
        "ncc": answer.ncc,
        "notes": list(answer.notes),
    }


def _error(found, truth):
    return None if found is None or truth is None else float(difference(found, truth))


def line_of(row):
    """Format one result as a line of text."""

    def show(value, form="7.2f"):
        return " " * (int(form.split(".")[0]) - 1) + "-" if value is None else format(value, form)

    text = (
        f"{row['photo'][:26]:26} {row['group'][:11]:11} {row['status']:9} heading {show(row['heading_deg'])}"
        f" error {show(row['error_deg'])} in [{show(row['heading_lo_deg'])}, {show(row['heading_hi_deg'])}]"
        f" p {show(row['p_correct'], '5.2f')} compass {show(row['compass_error_deg'])}"
    )
    if "paper_error_deg" in row:
        text += f" paper {show(row['paper_error_deg'])}"
    text += f" {row['cpu_s']:5.1f} s"
    return text if row["status"] != "failed" else f"{text}  {row['message']}"


def summarise(rows):
    """Compute counts within the limits, medians, statuses and risk against coverage."""
    known = [row for row in rows if row["truth_deg"] is not None]
    summary = {"all": _counts(known, "error_deg")}
    for group in sorted({row["group"] for row in known}):
        summary[group] = _counts([row for row in known if row["group"] == group], "error_deg")
    summary["compass alone"] = _counts([r for r in known if r["compass_error_deg"] is not None], "compass_error_deg")
    if known and "paper_error_deg" in known[0]:
        summary["paper's method"] = _counts(known, "paper_error_deg")
    for status in ("accepted", "ambiguous", "rejected", "failed"):
        summary[status] = _counts([row for row in known if row["status"] == status], "error_deg")
        summary[status]["without truth"] = sum(r["status"] == status for r in rows if r["truth_deg"] is None)
    covered = [row["covered"] for row in known if row["covered"] is not None]
    summary["interval"] = {"photos": len(covered), "covered": sum(covered)}
    summary["risk and coverage"] = risk_coverage(known)
    return summary


def _counts(rows, key):
    error = np.array([np.inf if row[key] is None else abs(row[key]) for row in rows])
    counts = {"photos": len(rows)}
    counts.update({f"< {limit:g}": int((error < limit).sum()) for limit in LIMITS_DEG})
    counts["median"] = float(np.median(error)) if len(error) and np.isfinite(np.median(error)) else None
    return counts


def risk_coverage(rows, limit_deg=3.0):
    """Share of wrong answers among the 25, 50, 75 and 100 % with the highest p_correct."""
    scored = sorted((row for row in rows if row["p_correct"] is not None), key=lambda row: -row["p_correct"])
    table = []
    for share in (0.25, 0.5, 0.75, 1.0):
        kept = scored[: int(np.ceil(share * len(scored)))]
        wrong = sum(abs(row["error_deg"]) > limit_deg for row in kept)
        table.append({"coverage": share, "photos": len(kept), "wrong": wrong})
    return table


def print_summary(summary):
    """Print the summary as a table."""
    for name, counts in summary.items():
        if isinstance(counts, list):
            print(f"{name}: " + ", ".join(f"{c['coverage']:.0%}: {c['wrong']} of {c['photos']} wrong" for c in counts))
        else:
            shown = (
                f"{key} {value:.2f}" if isinstance(value, float) else f"{key} {value}" for key, value in counts.items()
            )
            print(f"{name}: " + ", ".join(shown))


if __name__ == "__main__":
    main()
