"""Is a run linear in photographs and flat in memory? The same photographs at jittered places over a DEM of tiles.

    python benchmarks/bench_scale.py [--sizes 100,200,400] [--pixels 800] [--data ../shared/data]

Each size is a process of its own, which keeps no answer. The DEM is cut into 100 tiles that a VRT joins, and the
photographs of khumbu-trek are reduced and repeated, each time at a place up to 300 m from its own. Prints figures for
docs/scale.md; processor times are more reliable than wall times on a machine with other work.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import skyline_viewshed as sv
from osgeo import gdal
from PIL import Image

DATA = Path(os.environ.get("SKYLINE_DATA", Path(__file__).resolve().parents[2] / "shared" / "data"))
TILES = 10
JITTER_M = 300.0


def make_tiles(source, folder):
    """Cut a DEM into 10 x 10 compressed tiles and return the VRT that joins them."""
    dataset = gdal.Open(str(source))
    rows, cols = (np.linspace(0, size, TILES + 1).astype(int) for size in (dataset.RasterYSize, dataset.RasterXSize))
    tiles = []
    for row, (top, bottom) in enumerate(zip(rows[:-1].tolist(), rows[1:].tolist())):
        for col, (left, right) in enumerate(zip(cols[:-1].tolist(), cols[1:].tolist())):
            tiles.append(str(folder / f"{row}-{col}.tif"))
            window = [left, top, right - left, bottom - top]
            gdal.Translate(tiles[-1], dataset, srcWin=window, creationOptions=["COMPRESS=DEFLATE", "TILED=YES"])
    gdal.BuildVRT(str(folder / "tiles.vrt"), tiles).FlushCache()
    return folder / "tiles.vrt"


def reduced(source, folder, pixels):
    """Write a photograph at a reduced size, with its metadata, and return the path."""
    picture = Image.open(source)
    path = folder / Path(source).name
    exif = picture.info.get("exif", b"")
    picture.thumbnail((pixels, pixels))
    picture.save(path, quality=90, exif=exif)
    return str(path)


def requests(paths, count):
    """`count` photographs at jittered places, the same ones in every run."""
    rng = np.random.default_rng(7)
    found = []
    for index in range(count):
        path = paths[index % len(paths)]
        known = sv.read_metadata(path)
        east, north = rng.uniform(-JITTER_M, JITTER_M, 2) / 111_195.0
        longitude = known.longitude_deg + east / np.cos(np.radians(known.latitude_deg))
        found.append(sv.PhotoRequest(path, float(longitude), float(known.latitude_deg + north)))
    return found


def run(folder, count):
    """Orient `count` photographs in this process and print wall and processor seconds and the largest memory."""
    photos = requests([str(path) for path in sorted(folder.glob("*.jpg"))], count)
    dem = sv.open_dem(folder / "tiles.vrt")
    started, statuses = time.monotonic(), []
    for photo in sv.orient_many(photos, dem):
        statuses.append(photo.status)
    usage = resource.getrusage(resource.RUSAGE_SELF)
    cpu = usage.ru_utime + usage.ru_stime
    told = ", ".join(f"{statuses.count(name)} {name}" for name in sorted(set(statuses)))
    print(
        f"| {count} | {cpu:.0f} | {cpu / count:.2f} | {usage.ru_maxrss / 1024:.0f} | "
        f"{time.monotonic() - started:.0f} | {told} |",
        flush=True,
    )


def main():
    """Prepare files and run each size in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", default="100,200,400")
    parser.add_argument("--pixels", type=int, default=800)
    parser.add_argument("--data", type=Path, default=DATA)
    parser.add_argument("--folder", type=Path, help="used by the program itself")
    given = parser.parse_args()
    if given.folder:
        run(given.folder, int(given.sizes))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        make_tiles(given.data / "khumbu-trek" / "dem" / "dem.tif", folder)
        for path in sv.list_photos(given.data / "khumbu-trek" / "photos"):
            reduced(path, folder, given.pixels)
        print("| photographs | CPU s | CPU s each | memory MB | wall s | statuses |", "| --- " * 6 + "|", sep="\n")
        for size in given.sizes.split(","):
            subprocess.run([sys.executable, __file__, "--folder", str(folder), "--sizes", size], check=True)


if __name__ == "__main__":
    main()
