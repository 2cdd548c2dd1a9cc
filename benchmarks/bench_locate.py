"""Locate photographs of known position with their position withheld: `make bench-locate [DATA=../shared/data]`.

Each photograph is searched in 20 x 20 km around a point up to 7 km off its place in either direction, and in an area
of another range, in which every answer is wrong. Writes one row for each search to `build/locate.jsonl` and continues
where an earlier run stopped; `tools/fit_locate.py` fits the calibration from these rows. Indices are kept in
`build/locate`.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bench_accuracy import dem_of, read_truth, request_of  # noqa: E402

REGIONS = {"khumbu": "khumbu-trek"}
"""Folders that share the DEM of another one."""

OTHERS = ("khumbu-trek", "mont-blanc", "annapurna", "sawatch")
HALF_SIDE_M, LARGEST_OFFSET_M, MARGIN_M = 10_000.0, 7_000.0, 14_000.0
WIDE_DEG = 40.0


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder of folders with truth.csv, photos/ and dem/")
    parser.add_argument("--output", type=Path, default=Path("build/locate.jsonl"))
    parser.add_argument("--narrowest", type=float, default=28.0, help="skip narrower fields of view [degrees]")
    parser.add_argument("--kinds", nargs="+", choices=("own", "other"), default=("own", "other"))
    given = parser.parse_args(arguments)
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.touch()
    rows = [json.loads(line) for line in given.output.read_text(encoding="utf-8").splitlines()]
    done = {(row["photo"], row["kind"]) for row in rows}
    for folder, line, kind in tasks(given.data, given.kinds):
        if (line["photo"], kind) in done:
            continue
        row = measure(given.data, folder, line, kind, given.narrowest)
        if row is not None:
            rows.append(row)
            with open(given.output, "a", encoding="utf-8") as file:
                file.write(json.dumps(row) + "\n")
            print(line_of(row), flush=True)
    for name, value in summary(rows).items():
        print(f"{name}: {value}")


def tasks(data, kinds):
    """(folder, row of truth.csv, kind) of all good photographs."""
    for path in sorted(data.glob("*/truth.csv")):
        for line in read_truth(path.parent):
            if line["group"] == "good" and (data / REGIONS.get(path.parent.name, path.parent.name)).is_dir():
                for kind in kinds:
                    yield path.parent, line, kind


def measure(data, folder, line, kind, narrowest_deg):
    """Search for one photograph and compare the answer with the truth; None if its view is too narrow."""
    from skyline_viewshed.core.base.angles import difference
    from skyline_viewshed.core.batch import PhotoRequest
    from skyline_viewshed.core.io.photo import read_photo
    from skyline_viewshed.core.locating import locate_request
    from skyline_viewshed.core.match.prior import camera_prior
    from skyline_viewshed.core.searching import LocateOptions

    request = request_of(folder, line)
    metadata = read_photo(request.path, 64).metadata
    longitude, latitude = metadata.longitude_deg, metadata.latitude_deg
    if longitude is None or (longitude, latitude) == (0, 0):
        longitude, latitude = line["longitude_deg"], line["latitude_deg"]
    metadata = replace(metadata, focal_length_35mm=request.focal_length_35mm or metadata.focal_length_35mm)
    if request.hfov_deg is None and metadata.focal_length_35mm is None:
        return None
    hfov = camera_prior(metadata, request.hfov_deg).camera.hfov_deg
    if hfov < narrowest_deg:
        return None
    home = REGIONS.get(folder.name, folder.name)
    seed = sum(map(ord, line["photo"]))
    far = [name for name in OTHERS if name != home]
    region = home if kind == "own" else far[seed % len(far)]
    dem, index = index_of(str(data), region)
    sub = index.take(square(index, (longitude, latitude) if kind == "own" else None, seed))
    request = PhotoRequest(request.path, hfov_deg=request.hfov_deg, focal_length_35mm=request.focal_length_35mm)
    started = time.process_time()
    found = locate_request(request, (dem, sub), LocateOptions())
    cpu_s = time.process_time() - started
    row = {"photo": line["photo"], "home": home, "reg": region, "kind": kind, "hfov": hfov, "n": len(sub)}
    row.update(status=found.status, p=found.p_correct, cpu=cpu_s, d=[], score=[], head_err=None, f={})
    if found.places:
        away = [distance_m(place, longitude, latitude) for place in found.places]
        near = distance_m(sub, longitude, latitude) < 1_000.0
        order = np.argsort(-found.score)
        heading = line.get("heading_deg")
        best = found.places[0].oriented.heading_deg
        row.update(
            d=away,
            score=[place.score for place in found.places],
            head_err=None if heading is None else float(abs(difference(best, heading))),
            f=found.facts.features,
            coarse_rank=int(np.flatnonzero(near[order])[0]) + 1 if near.any() else 0,
            region_km2=len(found.region) * sub.spacing_m**2 / 1e6,
            in_region=bool((distance_m(sub, longitude, latitude)[found.region] < sub.spacing_m).any()),
        )
    return row


@lru_cache(maxsize=2)
def index_of(data, region):
    """DEM and index around all photographs of a region."""
    from skyline_viewshed.core.io.raster import open_dem
    from skyline_viewshed.core.locate.places import Area, IndexOptions
    from skyline_viewshed.core.locating import index_of_area

    folder = Path(data) / region
    dem = open_dem(str(dem_of(folder)))
    places = []
    for path in (folder, *(Path(data) / name for name, other in REGIONS.items() if other == region)):
        places += [(line["longitude_deg"], line["latitude_deg"]) for line in read_truth(path) if line["longitude_deg"]]
    longitude, latitude = np.array(places).T
    north = MARGIN_M / 111_195.0
    east = north / np.cos(np.radians(latitude.mean()))
    box = longitude.min() - east, latitude.min() - north, longitude.max() + east, latitude.max() + north
    return dem, index_of_area(dem, Area.box(*map(float, box)), IndexOptions(), "build/locate")


def square(index, place, seed):
    """Places of 20 x 20 km: around a point near the photograph's place, or anywhere."""
    random = np.random.default_rng(seed)
    if place is None:
        number = random.integers(len(index))
        middle = float(index.longitude_deg[number]), float(index.latitude_deg[number])
        offset = np.zeros(2)
    else:
        middle, offset = place, random.uniform(-LARGEST_OFFSET_M, LARGEST_OFFSET_M, 2)
    scale = 111_195.0 * np.cos(np.radians(middle[1]))
    east = (index.longitude_deg - middle[0]) * scale - offset[0]
    north = (index.latitude_deg - middle[1]) * 111_195.0 - offset[1]
    return np.flatnonzero((np.abs(east) < HALF_SIDE_M) & (np.abs(north) < HALF_SIDE_M))


def distance_m(place, longitude, latitude):
    """Ground distance of a place, or of the places of an index, from a position [m]."""
    north = (place.latitude_deg - latitude) * 111_195.0
    east = (place.longitude_deg - longitude) * 111_195.0 * np.cos(np.radians(latitude))
    return np.hypot(north, east) if np.ndim(north) else float(np.hypot(north, east))


def line_of(row):
    """One search as a line of text."""
    away = ", ".join(f"{value:.0f}" for value in row["d"][:3])
    chance = "-" if row["p"] is None else f"{row['p']:.2f}"
    return (
        f"{row['photo'][:26]:26} {row['kind']:5} in {row['reg']:11} hfov {row['hfov']:3.0f}  {row['status']:9}"
        f" p {chance}  m away {away}  {row['cpu']:.1f} s"
    )


def summary(rows):
    """The table of docs/locate.md."""
    own = [row for row in rows if row["kind"] == "own"]
    wide = [row for row in own if row["hfov"] >= WIDE_DEG]
    other = [row for row in rows if row["kind"] == "other"]
    accepted = [row for row in own if row["status"] == "accepted"]
    far = [row for row in accepted if row["d"][0] > 1_000.0] + [r for r in other if r["status"] == "accepted"]

    def near(some, limit_m):
        return f"{sum(bool(row['d']) and row['d'][0] <= limit_m for row in some)} of {len(some)}"

    return {
        "field of view above 40 degrees, within 500 m": near(wide, 500.0),
        "the same, within 1 km": near(wide, 1_000.0),
        "all, within 1 km": near(own, 1_000.0),
        "accepted": f"{len(accepted)} of {len(own)}",
        "accepted and wrong by more than 1 km, other ranges included": len(far),
        "other ranges, not accepted": f"{sum(r['status'] != 'accepted' for r in other)} of {len(other)}",
        "the region of 90 % holds the place": f"{sum(row.get('in_region', False) for row in own)} of {len(own)}",
        "median CPU seconds": round(float(np.median([row["cpu"] for row in rows])), 1) if rows else None,
    }


if __name__ == "__main__":
    main()
