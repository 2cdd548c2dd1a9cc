"""Measure headings on all photographs of known pose, region by region: `make bench-regions [DATA=folder] [COMPASS=..]`.

A region is one mountain range; `khumbu` and `khumbu-trek` are one. Only figures from regions that did not choose the
method count. What is fitted (the skyline weights, the sky network, the calibration) is fitted on simulated pictures,
on public pictures with sky labels and on the 30 masks, none of which is a photograph of a region here; so each row is
measured with nothing fitted on its region, except the spread of the compass (`CompassOptions`). What a person chose
with a region in sight is listed in docs/accuracy.md.
Each folder is one run, whose compasses are tested on a sample as in the plugin. COMPASS=random replaces the recorded
readings by random ones.
Writes `build/regions-ignore.json`, `regions-prior.json` or `regions-random.json`, by the use of the compass.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from dataclasses import replace
from multiprocessing import Pool
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bench_accuracy import dem_of, read_truth, request_of, result_row  # noqa: E402

REGIONS = {"khumbu-trek": "khumbu"}
"""Folders that belong to another folder's region."""

COMPASSES = ("ignore", "prior", "random")

GROUPS = ("good", "hard", "fog")
LIMITS_DEG = (0.5, 1.0, 1.5, 3.0, 10.0)
WRONG_DEG = 3.0


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder of folders with truth.csv, photos/ and dem/")
    parser.add_argument("--compass", choices=COMPASSES, default="ignore")
    parser.add_argument("--jobs", type=int, default=max((os.cpu_count() or 1) - 1, 1))
    parser.add_argument("--output", type=Path, help="build/regions-COMPASS.json by default")
    given = parser.parse_args(arguments)
    folders = sorted(path.parent for path in given.data.glob("*/truth.csv"))
    tasks = [task for folder in folders for task in tasks_of(folder, given.compass, given.jobs)]
    with Pool(given.jobs) as pool:
        rows = pool.map(measure, tasks, chunksize=1)
    table = by_region(rows)
    for region, counts in table.items():
        print(f"{region:12} " + ", ".join(f"{key} {value}" for key, value in counts.items()))
    report = {"compass": given.compass, "photos": rows, "regions": table}
    output = given.output or Path("build") / f"regions-{given.compass}.json"
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(json.dumps(report, indent=1), encoding="utf-8")
    print(f"written: {output}")


def tasks_of(folder, compass, jobs):
    """Photographs of a folder and the options of its run: (folder, line, compass, options)."""
    from skyline_viewshed.core.cluster import spread_over
    from skyline_viewshed.core.io.raster import open_dem
    from skyline_viewshed.core.many import OrientJob
    from skyline_viewshed.core.pipeline import OrientOptions
    from skyline_viewshed.core.trusting import with_trust

    lines = [line for line in read_truth(folder) if line.get("group") in GROUPS]
    requests = [request_of(folder, line) for line in lines]
    job = OrientJob(open_dem(str(dem_of(folder))), OrientOptions(compass="ignore" if compass == "ignore" else "prior"))
    given = [(request, photo_of(request, compass)) for request in requests] if compass != "ignore" else []
    job, _ = with_trust(job, given, spread_over(None, jobs))
    return [(folder, line, compass, job.options) for line in lines]


def photo_of(request, compass):
    """The photograph with a random reading of its compass; None leaves it to the file."""
    from skyline_viewshed.core.batch import PREVIEW_PX
    from skyline_viewshed.core.io.photo import read_photo

    if compass != "random":
        return None
    photo = read_photo(request.path, PREVIEW_PX)
    reading = float(np.random.default_rng([7, *Path(request.path).name.encode()]).uniform(0, 360))
    return replace(photo, metadata=replace(photo.metadata, compass_heading_deg=reading, compass_reference="T"))


def measure(task):
    """Orient one photograph; return its answer beside its truth."""
    from skyline_viewshed.core.batch import orient_request
    from skyline_viewshed.core.io.raster import open_dem

    folder, line, compass, options = task
    start = time.process_time()
    dem, request = open_dem(str(dem_of(folder))), request_of(folder, line)
    oriented = orient_request(request, dem, options, photo=photo_of(request, compass))
    region = REGIONS.get(folder.name, folder.name)
    return {**result_row(line, oriented), "region": region, "cpu_s": time.process_time() - start}


def by_region(rows):
    """Counts of each region, and of all together.

    Parameters
    ----------
    rows : list of dict
        As `measure` returns them.

    Returns
    -------
    dict of str to dict
    """
    regions = sorted({row["region"] for row in rows})
    return {name: counts([row for row in rows if name in ("all", row["region"])]) for name in [*regions, "all"]}


def counts(rows):
    """Counts of the good photographs of known heading, and of the hard ones that were accepted."""
    good = [row for row in rows if row["group"] == "good" and row["truth_deg"] is not None]
    error = np.array([np.inf if row["error_deg"] is None else abs(row["error_deg"]) for row in good])
    accepted = np.array([row["status"] == "accepted" for row in good], bool)
    return {
        "photos": len(good),
        **{f"< {limit:g}": int((error < limit).sum()) for limit in LIMITS_DEG},
        "accepted": int(accepted.sum()),
        "of these wrong": int((accepted & (error > WRONG_DEG)).sum()),
        "interval holds": sum(bool(row["covered"]) for row in good if row["status"] == "accepted"),
        "hard": sum(row["group"] != "good" for row in rows),
        "hard accepted": sum(row["group"] != "good" and row["status"] == "accepted" for row in rows),
        "median CPU s": round(float(np.median([row["cpu_s"] for row in rows])), 2),
    }


if __name__ == "__main__":
    main()
