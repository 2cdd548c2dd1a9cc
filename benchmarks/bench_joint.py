"""Compare the photographs of a walk solved together with the same ones alone: `make bench-joint [DATA=folder]`.

All photographs of each folder with truth.csv take part. Scored are those of known heading (group `good`). The lines of
the folders count only those with a neighbour, which is another photograph within 200 m, or one of the same camera
within an hour. The last line counts all. Writes `build/joint.json`.
"""

from __future__ import annotations

import argparse
import json
import sys
from functools import partial
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bench_accuracy import dem_of, read_truth, request_of, result_row  # noqa: E402
from skyline_viewshed.core.base.progress import SILENT  # noqa: E402
from skyline_viewshed.core.cluster import spread_over  # noqa: E402
from skyline_viewshed.core.io.raster import open_dem  # noqa: E402
from skyline_viewshed.core.joint.pairs import apart_s, near_pairs  # noqa: E402
from skyline_viewshed.core.many import OrientJob, answers_of, look_again  # noqa: E402
from skyline_viewshed.core.pipeline import OrientOptions  # noqa: E402
from skyline_viewshed.core.trusting import trusted_outcomes  # noqa: E402

RIGHT_DEG = 3.0
HOUR_S = 3600.0


def main(arguments=None):
    """Measure all folders, print a line for each, and write the file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder of folders with truth.csv, photos/ and dem/")
    parser.add_argument("--compass", choices=("ignore", "prior"), default="ignore")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--output", type=Path, default=Path("build/joint.json"))
    given = parser.parse_args(arguments)
    report = {}
    for folder in sorted(path.parent for path in given.data.glob("*/truth.csv")):
        rows = measure(folder, given.compass, given.jobs)
        report[folder.name] = {"counts": counts([row for row in rows if row["neighboured"]]), "photos": rows}
        print(line_of(folder.name, report[folder.name]["counts"]), flush=True)
    whole = counts([row for part in report.values() for row in part["photos"]])
    print(line_of("all", whole))
    report["all"] = {"counts": whole}
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.write_text(json.dumps(report, indent=1), encoding="utf-8")
    print(f"written: {given.output}")


def measure(folder, compass, jobs):
    """Orient the photographs of a folder alone and together by `jobs` processes; return rows of those scored."""
    lines, dem = list(read_truth(folder)), open_dem(str(dem_of(folder)))
    tasks, orient_all = [(request_of(folder, line), None) for line in lines], spread_over(None, jobs)
    job, outcomes = trusted_outcomes(OrientJob(dem, OrientOptions(compass=compass)), tasks, orient_all)
    alone = list(answers_of(outcomes, tasks))
    together = look_again(tasks, alone, partial(orient_all, job), SILENT, job.options)
    return [
        {
            "photo": line["photo"],
            "neighboured": near,
            "alone": result_row(line, before),
            "together": result_row(line, after),
        }
        for line, before, after, near in zip(lines, alone, together, neighboured(alone))
        if line["group"] == "good" and line.get("heading_deg") is not None
    ]


def line_of(name, found):
    """Format counts as a line."""
    return f"{name:12} " + ", ".join(f"{key} {value}" for key, value in found.items())


def neighboured(photos):
    """Tell of each photograph whether another one was taken near it, or by the same camera within an hour."""
    near = {number for pair in near_pairs(photos) for number in pair}
    known = [None if photo.metadata is None else photo.metadata.camera for photo in photos]
    for one, camera in enumerate(known):
        same = [other for other, theirs in enumerate(known) if other != one and theirs == camera and camera is not None]
        if any(apart_s(photos[one], photos[other]) <= HOUR_S for other in same):
            near.add(one)
    return [number in near for number in range(len(photos))]


def counts(rows):
    """Counts for a table: right, accepted and wrong, alone and together."""
    right = {way: np.array([_is_within(row[way], RIGHT_DEG) for row in rows], bool) for way in ("alone", "together")}
    accepted = {way: np.array([row[way]["status"] == "accepted" for row in rows], bool) for way in right}
    covered = np.array([bool(row["together"]["covered"]) for row in rows], bool)
    return {
        "photos": len(rows),
        "< 0.5 together": sum(_is_within(row["together"], 0.5) for row in rows),
        "< 1 together": sum(_is_within(row["together"], 1.0) for row in rows),
        "right alone": int(right["alone"].sum()),
        "right together": int(right["together"].sum()),
        "accepted alone": int(accepted["alone"].sum()),
        "accepted together": int(accepted["together"].sum()),
        "accepted but wrong": int((accepted["together"] & ~right["together"]).sum()),
        "worse": int((right["alone"] & ~right["together"]).sum()),
        "interval holds": int(covered.sum()),
        "of accepted ones": int((covered & accepted["together"]).sum()),
    }


def _is_within(row, limit_deg):
    return row["error_deg"] is not None and abs(row["error_deg"]) < limit_deg


if __name__ == "__main__":
    main()
