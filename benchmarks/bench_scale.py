"""Is a run linear in photographs and flat in memory? The same photographs at jittered places over a DEM of tiles.

    python benchmarks/bench_scale.py [--sizes 100,200,400] [--distinct 300] [--fine] [--pixels 800] [--data DATA]
    python benchmarks/bench_scale.py --archive FOLDER [--sizes 10000] [--distinct 300] [--fine] [--workers 2]

Each size is a process of its own, which keeps no answer. The DEM is cut into 100 tiles that a VRT joins, and the
photographs of khumbu-trek are reduced and repeated, each time at a place up to 300 m from its own; with `--distinct
N`, N different pictures of four regions (scale_photos.py), and with `--fine` over DEMs of 30 m. Prints figures for
docs/scale.md; processor times are more reliable than wall times on a machine with other work.

With `--archive` one run of the last size works as an archive's does: in worker processes, with a result file for each
chunk, so that it may be stopped at any time, and the same command goes on. `FOLDER/log.csv` gets a line for every
hundred photographs, and the points are joined to `FOLDER/points.gpkg` at the end. A folder that holds photographs
already keeps them, whatever `--distinct`, `--fine` and `--pixels` say. Linux only (it reads /proc).
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

import skyline_viewshed as sv
from skyline_viewshed.core.cluster import CHUNK, RowsOfChunk, rows_with_files
from skyline_viewshed.core.io.raster import Dem
from skyline_viewshed.core.io.vector import point_fields, write_points
from skyline_viewshed.core.many import OrientJob

sys.path.insert(0, str(Path(__file__).resolve().parent))
from scale_photos import KNOWN, prepare, requests  # noqa: E402

DATA = Path(os.environ.get("SKYLINE_DATA", Path(__file__).resolve().parents[2] / "shared" / "data"))


EACH = "DEM windows each", "million cells each", "MB read each"


class DemReads:
    """Counts the windows and cells that are read of elevation models, and the bytes that this process reads."""

    def __init__(self):
        self.windows = self.cells = 0
        self._before, read_into = bytes_read("self"), Dem.read_into

        def counted(dem, window, out):
            self.windows, self.cells = self.windows + 1, self.cells + window.rows * window.cols
            read_into(dem, window, out)

        Dem.read_into = counted

    @property
    def megabytes(self):
        """Read by this process since, also of photographs [MB]."""
        return (bytes_read("self") - self._before) / 1e6


def bytes_read(process):
    """Bytes that a process has read so far, from files or the cache of the system."""
    return int(Path(f"/proc/{process}/io").read_text(encoding="utf-8").split()[1])


def run(folder, count):
    """Orient `count` photographs in this process and print seconds, the largest memory, and reads of the DEM."""
    photos, dem, reads = requests(folder, count), sv.open_dem(folder / "tiles.vrt"), DemReads()
    started, statuses = time.monotonic(), []
    for photo in sv.orient_many(photos, dem):
        statuses.append(photo.status)
    usage = resource.getrusage(resource.RUSAGE_SELF)
    cpu = usage.ru_utime + usage.ru_stime
    told = ", ".join(f"{statuses.count(name)} {name}" for name in sorted(set(statuses)))
    wall = time.monotonic() - started
    print(
        f"| {count} | {cpu:.0f} | {cpu / count:.2f} | {usage.ru_maxrss / 1024:.0f} | {wall:.0f} | "
        f"{reads.windows / count:.1f} | {reads.cells / count / 1e6:.2f} | {reads.megabytes / count:.2f} | {told} |",
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
    photos = requests(folder, count)
    job = OrientJob(sv.open_dem(folder / "tiles.vrt"), sv.OrientOptions())
    tasks, work = [(photo, None) for photo in photos], RowsOfChunk(job, job.options.horizon.max_distance_m)
    log = Log(folder / "log.csv", count - CHUNK * len(list(folder.glob("chunks/*.json"))))
    rows = list(rows_with_files(work, tasks, folder / "chunks", workers=workers, progress=log))
    write_points(folder / "points.gpkg", point_fields(), rows)
    statuses = [row.values["status"] for row in rows]
    print(len(rows), ", ".join(f"{statuses.count(name)} {name}" for name in sorted(set(statuses))))


def main():
    """Prepare files and run each size in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", default="100,200,400")
    parser.add_argument("--pixels", type=int, default=800)
    parser.add_argument("--distinct", type=int, help="pictures that differ, of four regions, most of them views")
    parser.add_argument("--fine", action="store_true", help="DEMs with cells of about 30 m that reach 100 km")
    parser.add_argument("--data", type=Path, default=DATA)
    parser.add_argument("--archive", type=Path, help="keep all in this folder, and go on with what lies there")
    parser.add_argument("--workers", type=int, default=2, help="with --archive")
    parser.add_argument("--folder", type=Path, help="used by the program itself")
    given = parser.parse_args()
    if given.archive:
        if not (given.archive / KNOWN).exists():
            given.archive.mkdir(parents=True, exist_ok=True)
            prepare(given.archive, given.data, given.pixels, given.distinct, given.fine)
        archive(given.archive, int(given.sizes.split(",")[-1]), given.workers)
        return
    if given.folder:
        run(given.folder, int(given.sizes))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        prepare(folder, given.data, given.pixels, given.distinct, given.fine)
        titles = "photographs", "CPU s", "CPU s each", "memory MB", "wall s", *EACH, "statuses"
        print("| " + " | ".join(titles) + " |", "| --- " * len(titles) + "|", sep="\n")
        for size in given.sizes.split(","):
            subprocess.run([sys.executable, __file__, "--folder", str(folder), "--sizes", size], check=True)


if __name__ == "__main__":
    main()
