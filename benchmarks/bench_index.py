"""Time, memory and size of an index of horizons as the area grows: `make bench-index DEM=file [KM2="400 1600"]`.

Each area is a square around the middle of the DEM, computed with the default options into a folder of its own, in a
process of its own, so that the peak of its memory is that of this area alone.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dem", type=Path)
    parser.add_argument("--km2", type=float, nargs="+", default=(400.0, 1600.0))
    parser.add_argument("--output", type=Path, default=Path("build/index.jsonl"))
    parser.add_argument("--alone", action="store_true", help="measure the one area in this process and print its row")
    given = parser.parse_args(arguments)
    if given.alone:
        print(json.dumps(measure(given.dem, given.km2[0])))
        return
    given.output.parent.mkdir(parents=True, exist_ok=True)
    for km2 in given.km2:
        command = [sys.executable, __file__, str(given.dem), "--alone", "--km2", str(km2)]
        row = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        with open(given.output, "a", encoding="utf-8") as file:
            file.write(json.dumps(row) + "\n")
        print(row, flush=True)


def measure(path, km2):
    """Compute the index of a square and return its figures."""
    from skyline_viewshed.core.io.raster import open_dem
    from skyline_viewshed.core.locate.places import Area, IndexOptions
    from skyline_viewshed.core.locating import index_of_area

    dem = open_dem(str(path))
    longitude, latitude = map(float, dem.position_of(dem.shape[1] / 2, dem.shape[0] / 2))
    north = np.sqrt(km2) * 500.0 / 111_195.0
    east = north / np.cos(np.radians(latitude))
    before_mb = _peak_mb()
    with tempfile.TemporaryDirectory() as folder:
        started = time.process_time()
        area = Area.box(longitude - east, latitude - north, longitude + east, latitude + north)
        index = index_of_area(dem, area, IndexOptions(), folder)
        cpu_s = time.process_time() - started
        size_mb = sum(file.stat().st_size for file in Path(folder).rglob("*") if file.is_file()) / 1e6
    row = {"km2": km2, "places": len(index), "cpu_s": round(cpu_s, 1), "size_mb": round(size_mb, 1)}
    return {**row, "before_mb": round(before_mb), "peak_mb": round(_peak_mb()), "cell_m": round(index.cell_m, 1)}


def _peak_mb():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    main()
