"""Is a run linear in photographs and flat in memory? The same photographs at jittered places over a DEM of tiles.

    python benchmarks/bench_scale.py [--sizes 100,200,400] [--pixels 800] [--data ../shared/data]
    python benchmarks/bench_scale.py --archive FOLDER [--sizes 10000] [--workers 2]

Each size is a process of its own, which keeps no answer. The DEM is cut into 100 tiles that a VRT joins, and the
photographs of khumbu-trek are reduced and repeated, each time at a place up to 300 m from its own. Prints figures for
docs/scale.md; processor times are more reliable than wall times on a machine with other work.

With `--archive` one run of the last size works as an archive's does: in worker processes, with a result file for each
chunk, so that it may be stopped at any time, and the same command goes on. `FOLDER/log.csv` gets a line for every
hundred photographs, and the points are joined to `FOLDER/points.gpkg` at the end. Linux only (it reads /proc).
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
from skyline_viewshed.core.cluster import CHUNK, RowsOfChunk, rows_with_files
from skyline_viewshed.core.io.vector import point_fields, write_points
from skyline_viewshed.core.many import OrientJob

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


class Log:
    """`Progress` that writes a line for every hundred photographs: seconds, processor seconds, and memory so far."""

    def __init__(self, path, count):
        self.path, self.count, self.started, self.next = path, count, time.monotonic(), 0
        if not path.exists():
            path.write_text("time,photographs of this run,wall s,CPU s,memory MB,largest worker MB\n", encoding="utf-8")

    def report(self, fraction):
        """Write a line if another hundred are done."""
        done = round(fraction * self.count)
        if done < self.next:
            return
        self.next = done + 100
        used = [usage_of(process) for process in ("self", *workers_of(os.getpid()))]
        figures = [done, time.monotonic() - self.started, sum(cpu for cpu, _ in used), used[0][1]]
        figures.append(max(memory for _, memory in used[1:] or used))
        with open(self.path, "a", encoding="utf-8") as file:
            file.write(",".join([time.strftime("%F %T"), *(f"{figure:.0f}" for figure in figures)]) + "\n")

    def cancelled(self):
        """Go on to the end."""
        return False


def workers_of(process):
    """Numbers of a process's children."""
    return Path(f"/proc/{process}/task/{process}/children").read_text(encoding="utf-8").split()


def usage_of(process):
    """Processor seconds and largest memory [MB] of a running process, without its children."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
        status = Path(f"/proc/{process}/status").read_text(encoding="utf-8")
    except OSError:  # it has ended
        return 0.0, 0.0
    kilobytes = int(status.split("VmHWM:")[1].split()[0])
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK"), kilobytes / 1024


def archive(folder, count, workers):
    """Orient `count` photographs with a result file for each chunk, and join them; go on where an earlier run ended."""
    photos = requests([str(path) for path in sorted(folder.glob("*.jpg"))], count)
    job = OrientJob(sv.open_dem(folder / "tiles.vrt"), sv.OrientOptions())
    tasks, work = [(photo, None) for photo in photos], RowsOfChunk(job, job.options.horizon.max_distance_m)
    log = Log(folder / "log.csv", count - CHUNK * len(list(folder.glob("chunks/*.json"))))
    rows = list(rows_with_files(work, tasks, folder / "chunks", workers=workers, progress=log))
    write_points(folder / "points.gpkg", point_fields(), rows)
    statuses = [row.values["status"] for row in rows]
    print(len(rows), ", ".join(f"{statuses.count(name)} {name}" for name in sorted(set(statuses))))


def prepare(folder, given):
    """Write tiles and reduced photographs."""
    make_tiles(given.data / "khumbu-trek" / "dem" / "dem.tif", folder)
    for path in sv.list_photos(given.data / "khumbu-trek" / "photos"):
        reduced(path, folder, given.pixels)


def main():
    """Prepare files and run each size in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", default="100,200,400")
    parser.add_argument("--pixels", type=int, default=800)
    parser.add_argument("--data", type=Path, default=DATA)
    parser.add_argument("--archive", type=Path, help="keep all in this folder, and go on with what lies there")
    parser.add_argument("--workers", type=int, default=2, help="with --archive")
    parser.add_argument("--folder", type=Path, help="used by the program itself")
    given = parser.parse_args()
    if given.archive:
        if not (given.archive / "tiles.vrt").exists():
            given.archive.mkdir(parents=True, exist_ok=True)
            prepare(given.archive, given)
        archive(given.archive, int(given.sizes.split(",")[-1]), given.workers)
        return
    if given.folder:
        run(given.folder, int(given.sizes))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        prepare(folder, given)
        print("| photographs | CPU s | CPU s each | memory MB | wall s | statuses |", "| --- " * 6 + "|", sep="\n")
        for size in given.sizes.split(","):
            subprocess.run([sys.executable, __file__, "--folder", str(folder), "--sizes", size], check=True)


if __name__ == "__main__":
    main()
