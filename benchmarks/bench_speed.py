"""Compare horizon and viewshed with other programs: speed, memory, accuracy.

Usage: python benchmarks/bench_speed.py [--quick] [--only WORD]
    Prints a table and writes build/speed.json. Runs are paired: ours and the other program's alternate, and the medians
    of times, memory and pairwise ratios are reported; three pairs, or nine if they are short. --quick makes a third of
    them; --only runs the steps whose name contains WORD and leaves the other figures of the file unchanged.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from pathlib import Path

import exact_viewshed as exact
import make_dems
import numpy as np
from osgeo import gdal
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Terrain, Window
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.io.crs import to_wgs84
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.viewshed.viewshed import ViewshedOptions, viewshed
from speed_peers import Grass, NewerGdal, PeerMissingError, engine, gdal_viewshed

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
RADIUS_M = {"A": 14_496.0, "B": 85_440.0, "C": 12_180.0}
WEDGE_DEG = 221.0, 281.0
DROP = (6 / 7) / (2 * 6_371_000.0)
SHORT_S = 1.5
"""Pairs of runs that are shorter than this are repeated three times as often, since other load affects them most."""


class Scene:
    """Benchmark DEM and its observer, at the centre of the highest cell of the middle quarter."""

    def __init__(self, name, path):
        self.name, self.path, self.radius_m = name, path, RADIUS_M[name]
        self.dem = open_dem(path)
        rows, cols = self.dem.shape
        middle = Window(rows // 2 - rows // 8, cols // 2 - cols // 8, rows // 4, cols // 4)
        cells = self.dem.read(middle)
        row, col = np.unravel_index(int(cells.argmax()), cells.shape)
        self.row, self.col = middle.row + int(row), middle.col + int(col)
        x0, dx, _, y0, _, dy = self.dem.geotransform
        self.cell_m, self.x, self.y = dx, x0 + dx * (self.col + 0.5), y0 + dy * (self.row + 0.5)
        self.observer = Observer(*map(float, to_wgs84(self.dem.crs_wkt, self.x, self.y)), 1.7)
        self.eye_m = float(cells.max()) + 1.7

    def output(self, name):
        """Path of an output file."""
        return str(BUILD / "speed" / f"{self.name}_{name}")

    def in_memory(self):
        """Return the terrain with its cells in memory and the true frame of the file."""
        cells, dem = self.dem.read(Window(0, 0, *self.dem.shape)), self.dem

        class Memory(Terrain):
            shape = dem.shape

            def read(self, window):
                return cells[window.row : window.row + window.rows, window.col : window.col + window.cols]

            def frame(self, *place):
                return dem.frame(*place)

        return Memory(), cells


class Bench:
    """Collection of measured figures as rows of a table."""

    def __init__(self, pairs):
        self.pairs, self.rows = pairs, []

    def row(self, figure, ours, peer, at_least, aim, memory_mb=None, note="", ratio=None, largest=True):
        """Add a result; `at_least` and `aim` bound `ours` (or the ratio, if there is one) from above or below."""
        judged = ours if ratio is None else ratio
        meets = judged <= at_least if largest else judged >= at_least
        self.rows.append(
            {
                "figure": figure, "ours": ours, "peer": peer, "ratio": ratio, "memory_mb": memory_mb,
                "at_least": at_least, "aim": aim, "meets": bool(meets), "note": note,
            }
        )  # fmt: skip
        print(_line(self.rows[-1]), flush=True)

    def missing(self, figure, at_least, aim, why):
        """Add a row whose peer program is not available."""
        self.rows.append(
            {
                "figure": figure, "ours": None, "peer": None, "ratio": None, "memory_mb": None,
                "at_least": at_least, "aim": aim, "meets": None, "note": why,
            }
        )  # fmt: skip
        print(_line(self.rows[-1]), flush=True)

    def paired(self, figure, ours, peer, at_least, aim, memory=None, pairs=None):
        """Time ours and the peer alternately; judge wall time, and memory in a row of its own if bounds are given."""
        try:
            runs = [(ours(), peer()) for _ in range(pairs or self.pairs)]
            if pairs is None and max(run.wall_s for run in runs[0]) < SHORT_S:
                runs += [(ours(), peer()) for _ in range(2 * self.pairs)]
        except PeerMissingError as reason:
            self.missing(figure, at_least, aim, str(reason))
            return
        mine, theirs = (statistics.median(pair[side].wall_s for pair in runs) for side in (0, 1))
        ratio = statistics.median(a.wall_s / b.wall_s for a, b in runs)
        cpu = statistics.median(a.cpu_s / b.cpu_s for a, b in runs)
        memory_mb = statistics.median(a.memory_mb for a, _ in runs)
        peer_mb = statistics.median(b.memory_mb for _, b in runs)
        note = f"CPU ratio {cpu:.2f}, peer {peer_mb:.0f} MB, {len(runs)} pair(s)"
        self.row(f"{figure}, wall s", mine, theirs, at_least, aim, memory_mb, note, ratio)
        if memory == "ratio":
            self.row(f"{figure}, memory MB", memory_mb, peer_mb, at_least, aim, memory_mb, "", memory_mb / peer_mb)
        elif memory:
            self.row(f"{figure}, memory MB", memory_mb, peer_mb, *memory, memory_mb)


def horizon_in_memory(bench, scene, seconds, rms_deg):
    """Measure the computing time of 3,600 azimuths, and the error against dense sampling of every tenth azimuth."""
    terrain, cells = scene.in_memory()
    options = HorizonOptions(max_distance_m=scene.radius_m, refraction_coefficient=1 / 7)
    walls, times = [], []
    for _ in range(max(bench.pairs, 5)):
        wall, start = time.perf_counter(), time.process_time()
        profile = horizon_profile(terrain, scene.observer, options)
        times.append(time.process_time() - start)
        walls.append(time.perf_counter() - wall)
    # One thread: on an idle machine wall and processor time agree; on a shared one only processor time is meaningful.
    note = f"processor time; wall {statistics.median(walls):.2f} s"
    bench.row(f"horizon in memory, {scene.name}, s", statistics.median(times), None, seconds, seconds / 2, note=note)
    # Both use the plane grid of the DEM (grid azimuths and grid distances), since the reference has no CRS.
    plain = ArrayTerrain(cells, scene.cell_m)
    observer = Observer(*plain.position_of(scene.col, scene.row), 1.7, scene.eye_m)
    profile = horizon_profile(plain, observer, options)
    pick = slice(3, None, 10)
    ray = cells, scene.cell_m, (scene.row, scene.col), scene.eye_m, profile.azimuth_deg[pick]
    dense = exact.horizon(*ray, 1.5 * scene.cell_m, scene.radius_m, DROP)
    error = profile.elevation_deg[pick] - dense
    rms = float(np.sqrt(np.mean(error**2)))
    note = f"{error.min():+.4f} to {error.max():+.4f}; the search finds crests between the samples"
    bench.row(f"horizon error, {scene.name}, degrees rms", rms, None, rms_deg, rms_deg / 2, note=note)


def horizon_end_to_end(bench, scene, grass):
    place = scene.path, scene.x, scene.y, scene.radius_m
    bench.paired(
        f"horizon end to end against r.horizon, {scene.name}",
        lambda: engine("horizon", *place, scene.output("horizon.csv")),
        lambda: grass().horizon(*place, scene.output("r_horizon.csv")),
        0.6, 0.3, "ratio",
    )  # fmt: skip


def wedge_end_to_end(bench, scene, newer):
    place = scene.path, scene.x, scene.y, scene.radius_m
    ours = lambda: engine("wedge", *place, scene.output("wedge.tif"), *WEDGE_DEG)  # noqa: E731
    bench.paired(
        f"60-degree viewshed against gdal_viewshed (360), {scene.name}",
        ours, lambda: gdal_viewshed(*place, scene.output("gdal.tif")), 0.6, 0.35, (400, 250),
    )  # fmt: skip
    bench.paired(
        f"60-degree viewshed against newer GDAL's wedge, {scene.name}",
        ours, lambda: newer().wedge(*place, *WEDGE_DEG, scene.output("newer.tif")), 2.0, 1.0,
    )  # fmt: skip


def circle_end_to_end(bench, scene, grass=None):
    place = scene.path, scene.x, scene.y, scene.radius_m
    ours = lambda: engine("circle", *place, scene.output("circle.tif"))  # noqa: E731
    bench.paired(
        f"full circle against gdal_viewshed, {scene.name}",
        ours, lambda: gdal_viewshed(*place, scene.output("gdal.tif")), {"A": 0.8, "B": 1.2}[scene.name], 0.7,
    )  # fmt: skip
    if grass is not None:
        bench.paired(
            f"full circle against r.viewshed, {scene.name}",
            ours, lambda: grass().viewshed(*place), 0.1, 0.03, pairs=1,
        )  # fmt: skip


def accuracy(bench, scene, count=20_000):
    """Measure the agreement of ours and GDAL's with both exact references on the same random cells."""
    _, cells = scene.in_memory()
    plain = ArrayTerrain(cells, scene.cell_m)
    observer = Observer(*plain.position_of(scene.col, scene.row), 1.7)
    options = ViewshedOptions(max_distance_m=scene.radius_m, refraction_coefficient=1 / 7)
    result = viewshed(plain, observer, options=options)
    window = result.window
    seen = np.zeros(cells.shape, bool)
    seen[window.row : window.row + window.rows, window.col : window.col + window.cols] = result.visible
    try:
        gdal_viewshed(scene.path, scene.x, scene.y, scene.radius_m, scene.output("gdal.tif"))
        theirs = _on_grid(scene, gdal.Open(scene.output("gdal.tif"))) == 255
    except PeerMissingError:
        theirs = None
    rng = np.random.default_rng(5)
    targets = rng.integers(0, cells.shape[0], (4 * count, 2))
    far = np.hypot(*(targets - np.array([scene.row, scene.col])).T) * scene.cell_m
    targets = targets[far <= scene.radius_m][:count]
    found = seen[tuple(targets.T)]
    references = {}
    for model, at_least, aim in (("crossings", 0.97, 0.985), ("bilinear", 0.95, 0.965)):
        eye = (scene.row, scene.col), scene.eye_m
        references[model] = exact.sees(cells, scene.cell_m, *eye, targets, DROP, model)
        peer = None if theirs is None else exact.iou(theirs[tuple(targets.T)], references[model])
        note = f"{len(targets)} cells, {references[model].mean():.1%} seen; peer is gdal_viewshed"
        ours = exact.iou(found, references[model])
        figure = f"viewshed IoU against exact {model}, {scene.name}"
        bench.row(figure, ours, peer, at_least, aim, note=note, largest=False)
    both = exact.iou(references["crossings"], references["bilinear"])
    print(f"    the two references agree with one another to {both:.3f}")


def _on_grid(scene, raster):
    values, transform = np.zeros(scene.dem.shape, np.uint8), raster.GetGeoTransform()
    x0, dx, _, y0, _, dy = scene.dem.geotransform
    row, col = round((transform[3] - y0) / dy), round((transform[0] - x0) / dx)
    part = raster.ReadAsArray()
    values[row : row + part.shape[0], col : col + part.shape[1]] = part
    return values


def holes(bench):
    """Count cells in range that are not evaluated: over a plane without curvature every cell must be visible."""
    side, cell_m = 4001, 10.0
    plain = ArrayTerrain(np.zeros((side, side), np.float32), cell_m)
    observer = Observer(*plain.position_of(1999.6, 2000.3), 1.7)
    result = viewshed(plain, observer, options=ViewshedOptions(max_distance_m=19_000.0, curvature=False))
    window = result.window
    row = np.arange(window.row, window.row + window.rows)[:, None] - 2000.3
    col = np.arange(window.col, window.col + window.cols)[None, :] - 1999.6
    missed = int(((np.hypot(row, col) * cell_m <= 19_000.0) & ~result.visible).sum())
    bench.row("cells in range not evaluated", missed, None, 0, 0, note=f"of {int(result.visible.sum())}")


def memory(bench, scene_a):
    """Measure whole processes against a window's bytes x 1.25 + 150 MB, and on a DEM of 40,000 x 40,000 cells."""
    place = scene_a.path, scene_a.x, scene_a.y, scene_a.radius_m
    window_mb = (2 * scene_a.radius_m / scene_a.cell_m) ** 2 * 4 / 2**20
    for task in ("horizon", "circle"):
        run = engine(task, *place, scene_a.output(f"memory_{task}"))
        bench.row(f"memory of {task}, A, MB", run.memory_mb, None, window_mb * 1.25 + 150, window_mb, run.memory_mb)
    big = BUILD / "dems" / "40000.vrt"
    source = make_dems.make(str(BUILD / "dems"), ("B",))["B"]
    gdal.Translate(str(big), source, format="VRT", width=40_000, height=40_000, resampleAlg="bilinear")
    dem = open_dem(str(big))
    x0, dx, _, y0, _, dy = dem.geotransform
    x, y = x0 + dx * 20_000.5, y0 + dy * 20_000.5
    for task in ("horizon", "packed"):
        run = engine(task, big, x, y, 85_000.0, str(BUILD / "speed" / "big.csv"))
        name = {"horizon": "horizon", "packed": "full circle"}[task]
        note = f"{run.wall_s:.0f} s, most of it the virtual raster's own resampling"
        bench.row(f"memory of {name}, 40,000 x 40,000 cells, MB", run.memory_mb, None, 1024, 1024, run.memory_mb, note)


def once(make):
    """Create a peer when it is first needed, and keep it."""
    made = []

    def get():
        if not made:
            made.append(make())
        return made[0]

    return get


def _store(path, rows, keep):
    """Write the rows; if `keep`, figures that were not run stay unchanged."""
    old = json.loads(path.read_text()) if keep and path.exists() else []
    new = {row["figure"]: row for row in rows}
    merged = [new.pop(row["figure"], row) for row in old] + list(new.values())
    path.write_text(json.dumps(merged, indent=1))


def _line(row):
    def number(value):
        return "-" if value is None else f"{value:.4g}"

    meets = {True: "yes", False: "NO", None: "?"}[row["meets"]]
    fields = [number(row[key]) for key in ("ours", "peer", "ratio", "memory_mb", "at_least", "aim")]
    return f"{row['figure']:<62}" + "".join(f"{field:>10}" for field in fields) + f"  {meets:<4}{row['note']}"


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", default="")
    options = parser.parse_args(arguments)
    gdal.UseExceptions()
    (BUILD / "speed").mkdir(parents=True, exist_ok=True)
    paths = make_dems.make(str(BUILD / "dems"), ("A", "B", "C"))
    scenes = {name: Scene(name, path) for name, path in paths.items()}
    newer = once(lambda: NewerGdal(BUILD / "peers" / "gdal"))
    grass = once(lambda: Grass(BUILD / "peers" / "grass"))
    bench = Bench(1 if options.quick else 3)
    steps = {
        "accuracy": lambda: accuracy(bench, scenes["C"]),
        "holes": lambda: holes(bench),
        "horizon memory A": lambda: horizon_in_memory(bench, scenes["A"], 1.0, 0.005),
        "horizon memory B": lambda: horizon_in_memory(bench, scenes["B"], 0.3, 0.01),
        "horizon end A": lambda: horizon_end_to_end(bench, scenes["A"], grass),
        "horizon end B": lambda: horizon_end_to_end(bench, scenes["B"], grass),
        "wedge A": lambda: wedge_end_to_end(bench, scenes["A"], newer),
        "circle A": lambda: circle_end_to_end(bench, scenes["A"]),
        "circle B": lambda: circle_end_to_end(bench, scenes["B"], grass),
        "cap": lambda: memory(bench, scenes["A"]),
    }
    titles = ("ours", "peer", "ratio", "mem. MB", "at least", "aim")
    print(f"{'figure':<62}" + "".join(f"{title:>10}" for title in titles) + "  meets")
    for name, step in steps.items():
        if options.only in name:
            step()
    _store(BUILD / "speed.json", bench.rows, keep=bool(options.only))
    return 0 if all(row["meets"] is not False for row in bench.rows) else 1


if __name__ == "__main__":
    sys.exit(main())
