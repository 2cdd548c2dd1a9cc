"""Run the main job through qgis_process, draw a map of the result, and compare headings with the truth.

Usage: demo.py OUT [--photos FOLDER --dem RASTER]

Without photographs and a DEM, it makes a small simulated sample first. `make demo` calls it with everything in place.
"""

from __future__ import annotations

import argparse
import csv
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MAP_CELLS = 1400


def main():
    """Run the demo."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("out", type=Path)
    arguments.add_argument("--photos", type=Path)
    arguments.add_argument("--dem", type=Path)
    given = arguments.parse_args()
    if bool(given.photos) != bool(given.dem):
        raise SystemExit("Give both: make demo PHOTOS=folder DEM=raster")
    out = given.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    photos, dem = (given.photos, given.dem) if given.photos else sample(out / "sample")
    results = run(photos.resolve(), dem.resolve(), out)
    draw_map(results, dem, out / "map.png")
    table(results, photos)
    print("\nLook at:")
    for name in ("report.html", "map.png", "figures", "skyline.gpkg", "viewshed.tif"):
        print(f"  {(out / name).relative_to(ROOT) if out.is_relative_to(ROOT) else out / name}")


def sample(folder):
    """Make simulated photographs and their DEM, once."""
    if not (folder / "truth.csv").exists():
        print("Making the sample: a mountain range and photographs of it ...", flush=True)
        subprocess.run([sys.executable, ROOT / "tools" / "make_sample.py", folder], check=True)
    dems = sorted((folder / "dem").glob("*.tif"))
    return folder / "photos", dems[0]


def run(photos, dem, out):
    """Orient the photographs and compute what they show; return the paths of the outputs."""
    results = {"points": out / "skyline.gpkg", "viewshed": out / "viewshed.tif", "report": out / "report.html"}
    for path in [*results.values(), *(out / "figures").glob("*.png")]:
        path.unlink(missing_ok=True)
    command = [
        shutil.which("qgis_process.bin") or "qgis_process",
        "run",
        "skylineviewshed:photoviewshed",
        "--",
        f"FOLDER={photos}",
        f"DEM={dem}",
        f"OUTPUT=ogr:dbname='{results['points']}' table=\"photos\" (geom)",
        f"POLYGONS=ogr:dbname='{results['points']}' table=\"ground_in_view\" (geom)",
        f"VIEWSHED={results['viewshed']}",
        f"REPORT={results['report']}",
        f"FIGURES={out / 'figures'}",
    ]
    print(" ".join(command[1:3]), photos, dem, flush=True)
    start = time.monotonic()
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0 or not results["points"].exists():
        raise SystemExit(f"qgis_process failed ({done.returncode}):\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    print(f"done in {time.monotonic() - start:.0f} s")
    return results


def oriented_points(path):
    """Read the attributes of the oriented photographs, by file name."""
    from osgeo import ogr

    source = ogr.Open(str(path))
    return {Path(row["photo"]).name: row for row in (feature.items() for feature in source.GetLayerByName("photos"))}


def draw_map(results, dem_path, target):
    """Draw a shaded relief with the cameras and the ground in their photographs."""
    from osgeo import gdal, ogr
    from skyline_viewshed.core.base.terrain import Window
    from skyline_viewshed.core.figures.ground import GroundMapOptions, SeenGround, ground_map
    from skyline_viewshed.core.figures.map import MapObserver, map_image
    from skyline_viewshed.core.figures.raster import encode_png
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(dem_path)
    source = ogr.Open(str(results["points"]))
    observers, places = [], []
    for feature in source.GetLayerByName("photos"):
        shape, row = feature.GetGeometryRef(), feature.items()
        if shape is None:
            continue
        col_px, row_px = (float(value) for value in dem.pixel_of(shape.GetX(), shape.GetY()))
        if 0 <= col_px < dem.shape[1] and 0 <= row_px < dem.shape[0]:
            places.append((shape.GetX(), shape.GetY()))
            trusted = row["heading"] if row["status"] == "accepted" else None
            observers.append(MapObserver(col_px, row_px, trusted, row["hfov"], Path(row["photo"]).stem))
    rows, cols = dem.shape
    middle = places[0] if places else dem.position_of(cols / 2, rows / 2)
    counts = gdal.Open(str(results["viewshed"])).ReadAsArray()
    data = ground_map(
        dem,
        dem.frame(*middle, 1000.0),
        SeenGround(Window(0, 0, rows, cols), counts, unknown=65535),
        observers,
        options=GroundMapOptions(len(observers), MAP_CELLS),
    )
    target.write_bytes(encode_png(map_image(data, 1400)))


def table(results, photos):
    """Print the headings found, beside the true ones if they are known."""
    truth_path = photos.parent / "truth.csv"
    truth = {}
    if truth_path.exists():
        with open(truth_path, newline="", encoding="utf-8") as file:
            truth = {Path(row["photo"]).name: row for row in csv.DictReader(file)}
    print(f"\n{'photo':24} {'status':10} {'true':>7} {'found':>7} {'error':>6}  90 % interval")
    for name, row in sorted(oriented_points(results["points"]).items()):
        true = truth.get(name, {}).get("heading_deg")
        found = row["heading"]
        error = "" if not true or found is None else f"{(found - float(true) + 180) % 360 - 180:+.2f}"
        interval = "" if row["heading_lo"] is None else f"{row['heading_lo']:.1f} to {row['heading_hi']:.1f}"
        true, found = f"{float(true):.2f}" if true else "", "" if found is None else f"{found:.2f}"
        print(f"{name:24} {row['status']:10} {true:>7} {found:>7} {error:>6}  {interval}")


if __name__ == "__main__":
    main()
