"""Throughput of worker processes: the same photographs with one and with two processes, and whether all is the same.

    python benchmarks/bench_many.py [--photos 60] [--workers 2] [--joined] [--data ../shared/data]

Photographs are taken from every folder of real data that has `photos/` and `dem/dem.tif`. Each folder is
a run of its own; with `--joined` a VRT joins the DEMs, and all photographs are one run. Prints figures for
docs/scale.md. On a machine with other work the ratio of wall times says little; CPU seconds per photograph, also
printed, are more reliable.
"""

from __future__ import annotations

import argparse
import os
import resource
import tempfile
import time
from pathlib import Path

import skyline_viewshed as sv
from osgeo import gdal

DATA = Path(os.environ.get("SKYLINE_DATA", Path(__file__).resolve().parents[2] / "shared" / "data"))
SETS = ("khumbu-trek", "mont-blanc", "annapurna", "sawatch")


def chosen(data, count):
    """Return [(DEM, photographs)] with `count` photographs together."""
    found = []
    for name in SETS:
        paths = sv.list_photos(data / name / "photos")[:count] if (data / name / "photos").is_dir() else []
        count -= len(paths)
        if paths:
            found.append((data / name / "dem" / "dem.tif", paths))
    return found


def answers(sets, workers):
    """Orient all; return answers, wall seconds, and CPU seconds of this process and its children."""
    started, before = time.monotonic(), os.times()
    found = []
    for dem, paths in sets:
        photos = sv.orient_many(paths, sv.open_dem(dem), workers=workers)
        found += [(photo.path, photo.status, *everything(photo.orientation)) for photo in photos]
    after = os.times()
    cpu = sum(after[:4]) - sum(before[:4])
    return found, time.monotonic() - started, cpu


def joined(sets, folder):
    """Return the photographs as one set, over a VRT that joins their DEMs."""
    path = str(Path(folder) / "joined.vrt")
    options = {"resolution": "highest", "resampleAlg": "bilinear", "srcNodata": -32768, "VRTNodata": -32768}
    gdal.BuildVRT(path, [str(dem) for dem, _ in sets], **options).FlushCache()
    return [(path, [photo for _, photos in sets for photo in photos])]


def everything(orientation):
    """Return all numbers of an answer."""
    poses = tuple(
        (one.pose.heading_deg, one.pose.pitch_deg, one.pose.roll_deg, one.camera.focal_px, one.score, one.probability)
        for one in orientation.candidates
    )
    return orientation.p_correct, orientation.heading_lo_deg, orientation.heading_hi_deg, poses


def main():
    """Print the comparison."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--photos", type=int, default=60)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--joined", action="store_true")
    parser.add_argument("--data", type=Path, default=DATA)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        sets = chosen(given.data, given.photos)
        compare(joined(sets, folder) if given.joined else sets, given.workers)


def compare(sets, workers):
    """Print the figures of one process and of several."""
    several, wall_several, cpu_several = answers(sets, workers)
    worker_mb = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    one, wall_one, cpu_one = answers(sets, 1)
    print(f"{len(one)} photographs, load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    differing = [Path(first[0]).name for first, second in zip(one, several) if first != second]
    print(f"all numbers of {len(one) - len(differing)} answers are the same; they differ for {differing or 'none'}")
    print(
        f"wall: {wall_one:.0f} s with one process, {wall_several:.0f} s with {workers}: "
        f"{wall_one / wall_several:.2f} times the throughput"
    )
    print(
        f"CPU per photograph: {cpu_one / len(one):.2f} s and {cpu_several / len(one):.2f} s; "
        f"largest worker {worker_mb:.0f} MB"
    )


if __name__ == "__main__":
    main()
