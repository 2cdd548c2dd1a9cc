"""Measure accuracy and calibration on simulated photographs: `make bench-simulated [COUNT=240] [SEED=1] [JOBS=1]`.

Each case is a real JPEG with EXIF, read and oriented through `core.batch`, as the algorithms do. The levels are perfect
(true skyline, the matcher's own DEM), exact (clear weather, ordinary lenses, the matcher's own DEM), clean (the same
scenes on mountains finer than the DEM) and full (clouds, haze, snow, trees, noise, fields of view from 4 to 75 degrees,
roll up to 8 degrees, GPS error up to 30 m). The benchmark writes `build/simulated.json`.

`--dump folder` writes photographs and their truth instead (`truth.csv`, `truth.jsonl`, `rows/*.npz` with
`skyline_row_px` and `skyline_visible` per column), for fitting and calibration.
"""

from __future__ import annotations

import argparse
import csv
import json
import sys
import tempfile
import time
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from skyline_viewshed.core.base.angles import difference

sys.path.insert(0, str(Path(__file__).resolve().parent))
from simulated_cases import LEVELS, ORDINARY, dem_of, dem_paths, draw_case, take, truth_row  # noqa: E402

LIMITS_DEG = (0.2, 0.5, 1.0, 3.0)
BINS = (0.0, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 0.99, 1.0001)
FOV_BINS_DEG = (0, 12, 25, 45, 90)
SHARES = {"perfect": 0.2, "exact": 0.2, "clean": 0.2, "full": 0.4, "adverse": 0.4, "anywhere": 0.4}


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=240, help="photographs in all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--levels", nargs="+", choices=LEVELS, default=list(ORDINARY))
    parser.add_argument("--dump", type=Path, help="write photographs and truth here instead of measuring")
    parser.add_argument("--long-side", type=int, default=None, help="pixels; 1024, or 640 with --dump")
    parser.add_argument(
        "--dems", type=Path, nargs="+", help="take the scenes from these DEMs instead of the usual ones"
    )
    parser.add_argument("--work", type=Path, default=Path("build/simulated"), help="folder for procedural DEMs")
    parser.add_argument("--output", type=Path, default=Path("build/simulated.json"))
    given = parser.parse_args(arguments)
    paths = [str(path.resolve()) for path in given.dems] if given.dems else dem_paths(given.work)
    if given.dump:
        levels = [level for level in given.levels if level != "perfect"]
        dump(given.dump, given.count, given.seed, paths, levels, given.long_side or 640, given.jobs)
        return
    tasks = [
        (given.seed, index, level, paths, given.long_side or 1024)
        for level in given.levels
        for index in range(_count(given.count, level, given.levels))
    ]
    rows = []
    for row in _map(measure, tasks, given.jobs):
        rows.append(row)
        print(line_of(row), flush=True)
    report = {"seed": given.seed, "count": len(rows), "photos": rows, "summary": summarise(rows)}
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.write_text(json.dumps(report, indent=1), encoding="utf-8")
    print_summary(report["summary"])
    print(f"written: {given.output}")


def _count(count, level, levels):
    return int(round(count * SHARES[level] / sum(SHARES[one] for one in levels)))


def _map(work, tasks, jobs):
    if jobs <= 1:
        yield from map(work, tasks)
        return
    with get_context("spawn").Pool(jobs) as pool:
        yield from pool.imap(work, tasks)


def measure(task):
    """Render, write, read and orient one photograph; return its row."""
    # Imported here and not above: --dump must run even while the stages are being reworked and do not run.
    from skyline_viewshed.core.batch import PhotoRequest, orient_request

    seed, index, level, paths, long_side = task
    case = draw_case(seed, index, level, paths, long_side)
    with tempfile.TemporaryDirectory() as folder:
        path, view = take(case, folder)
        row = truth_row(case, view)
        drawn = None
        if level == "perfect":
            known = np.flatnonzero(np.isfinite(view.skyline_row_px))
            drawn = tuple(zip(known.tolist(), view.skyline_row_px[known].tolist()))
        started = time.process_time()
        answer = orient_request(PhotoRequest(path, drawn_skyline=drawn), dem_of(case.dem_path)).orientation
    row["cpu_s"] = time.process_time() - started
    row["status"], row["message"], row["p_correct"] = answer.status, answer.message, answer.p_correct
    best = answer.best
    row["found_heading_deg"] = best and best.pose.heading_deg
    row["error_deg"] = None if best is None else float(difference(best.pose.heading_deg, case.pose.heading_deg))
    row["pitch_error_deg"] = None if best is None else float(best.pose.pitch_deg - case.pose.pitch_deg)
    row["covered"] = row["interval_deg"] = None
    if best is not None and answer.heading_lo_deg is not None:
        row["interval_deg"] = float((answer.heading_hi_deg - answer.heading_lo_deg) % 360)
        row["covered"] = bool((case.pose.heading_deg - answer.heading_lo_deg) % 360 <= row["interval_deg"])
    return row


def line_of(row):
    error = "   none" if row["error_deg"] is None else f"{row['error_deg']:7.2f}"
    sure = "  - " if row["p_correct"] is None else f"{row['p_correct']:.2f}"
    return (
        f"{row['photo']:<22} {error} deg  p {sure}  {row['status']:<9} hfov {row['hfov_deg']:4.0f}  "
        f"{row['clouds']:<7}{row['foreground']:<7} hidden {row['hidden_share']:.2f}  {Path(row['dem']).name}"
    )


def summarise(rows):
    """Compute accuracy and calibration, overall per level and by difficulty within the full level."""
    measured = [level for level in LEVELS if level in ORDINARY or any(r["group"] == level for r in rows)]
    summary = {level: accuracy([r for r in rows if r["group"] == level]) for level in measured}
    full = [r for r in rows if r["group"] == "full"]
    by = {}
    for key in ("clouds", "foreground"):
        by.update({f"{key}={v}": accuracy([r for r in full if r[key] == v]) for v in sorted({r[key] for r in full})})
    for low, high in zip(FOV_BINS_DEG, FOV_BINS_DEG[1:]):
        by[f"hfov {low}-{high}"] = accuracy([r for r in full if low <= r["hfov_deg"] < high])
    for name in sorted({Path(r["dem"]).name for r in full}):
        by[name] = accuracy([r for r in full if Path(r["dem"]).name == name])
    images = [r for r in rows if r["group"] in ("clean", "full", "adverse")]
    return {"levels": summary, "full_by": by, "reliability": reliability(images), "images": accuracy(images)}


def accuracy(rows):
    """Compute counts within the limits, statuses, and coverage of the 90 % interval."""
    if not rows:
        return {"photos": 0}
    error = np.array([np.inf if r["error_deg"] is None else abs(r["error_deg"]) for r in rows])
    accepted = np.array([r["status"] == "accepted" for r in rows])
    covered = [r["covered"] for r in rows if r["covered"] is not None]
    sure_covered = [r["covered"] for r in rows if r["covered"] is not None and r["status"] == "accepted"]
    return {
        "photos": len(rows),
        **{f"within_{limit:g}": float((error < limit).mean()) for limit in LIMITS_DEG},
        "median_deg": float(np.median(error)) if np.isfinite(np.median(error)) else None,
        "accepted": float(accepted.mean()),
        "accepted_wrong": int((accepted & (error >= 3)).sum()),
        "coverage_90": float(np.mean(covered)) if covered else None,
        "coverage_90_accepted": float(np.mean(sure_covered)) if sure_covered else None,
        "failed": int(sum(r["status"] == "failed" for r in rows)),
    }


def reliability(rows):
    """Compare predicted and observed correctness: bins of p_correct with their share within 3 degrees."""
    known = [r for r in rows if r["p_correct"] is not None and r["error_deg"] is not None]
    table = []
    for low, high in zip(BINS, BINS[1:]):
        inside = [r for r in known if low <= r["p_correct"] < high]
        if inside:
            table.append(
                {
                    "from": low,
                    "to": min(high, 1.0),
                    "photos": len(inside),
                    "promised": float(np.mean([r["p_correct"] for r in inside])),
                    "kept": float(np.mean([abs(r["error_deg"]) < 3 for r in inside])),
                }
            )
    return table


def print_summary(summary):
    print(f"\n{'':<24}photos  <0.2  <0.5    <1    <3  accepted wrong  cover90")
    for name, row in {**summary["levels"], **summary["full_by"], "all images": summary["images"]}.items():
        if not row["photos"]:
            continue
        within = "".join(f"{100 * row[f'within_{limit:g}']:6.0f}" for limit in LIMITS_DEG)
        cover = "    -" if row["coverage_90"] is None else f"{100 * row['coverage_90']:5.0f}"
        print(
            f"{name[:23]:<24}{row['photos']:6}{within}{100 * row['accepted']:10.0f}{row['accepted_wrong']:6}    {cover}"
        )
    print("\np_correct promised / kept within 3 degrees")
    for row in summary["reliability"]:
        print(f"  {row['from']:.2f}-{row['to']:.2f}  n {row['photos']:4}  {row['promised']:.2f} / {row['kept']:.2f}")


def dump(folder, count, seed, paths, levels, long_side, jobs=1):
    """Write photographs with their truth, as a training or calibration set."""
    for name in ("photos", "rows"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    tasks = []
    for level in levels:
        tasks += [(seed, k, level, paths, long_side, str(folder)) for k in range(_count(count, level, levels))]
    rows = []
    with open(folder / "truth.jsonl", "w", encoding="utf-8") as lines:
        for row in _map(dump_one, tasks, jobs):
            rows.append(row)
            lines.write(json.dumps(row) + "\n")
    with open(folder / "truth.csv", "w", newline="", encoding="utf-8") as table:
        writer = csv.DictWriter(table, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    print(f"{len(rows)} photographs in {folder}")


def dump_one(task):
    """Write one photograph and its skyline."""
    seed, index, level, paths, long_side, folder = task
    case = draw_case(seed, index, level, paths, long_side)
    _, view = take(case, str(Path(folder) / "photos"))
    np.savez_compressed(
        Path(folder) / "rows" / f"{case.name}.npz",
        skyline_row_px=view.skyline_row_px.astype(np.float32),
        skyline_visible=view.skyline_visible,
    )
    return truth_row(case, view)


if __name__ == "__main__":
    main()
