"""What a run leaves behind when it is killed: whole results, which a repeat takes up, and nothing else."""

from __future__ import annotations

import hashlib
import signal
import subprocess
import sys
import time
from random import Random

import numpy as np
import pytest
from whole_runs import PLAIN, arguments, as_from_a_terminal, outputs_in, rows_of

pytestmark = pytest.mark.qgis

ROWS = 2000
MOMENTS = 8


def assert_whole(outputs, photos):
    """Every result that is there is a whole one; what is hidden or ends in .part is none."""
    from osgeo import gdal

    folder = outputs["OUTPUT"].parent
    rasters = [path for path in folder.rglob("*.tif") if not path.name.startswith(".")]
    for path in rasters:
        raster = gdal.Open(str(path))
        assert raster is not None and raster.ReadAsArray() is not None, path
    for path in outputs["ORIENTATIONS"].glob("*.npz"):
        with np.load(path) as archive:
            assert [archive[name] for name in archive.files], path
    if outputs["REPORT"].exists():
        assert outputs["REPORT"].read_text(encoding="utf-8").rstrip().endswith("</html>")
    for name in ("OUTPUT", "POLYGONS"):
        if outputs[name].exists():
            assert len(rows_of(outputs[name])) == photos, name
    known = set(outputs.values()) | set(rasters) | {path.with_suffix(".qml") for path in rasters}
    strangers = [path for path in folder.iterdir() if path not in known and not path.name.startswith(".")]
    assert strangers == []


def fingerprints(folder):
    """Content of all files but the statistics that QGIS itself writes beside any raster it loads (.aux.xml)."""
    files = [path for path in folder.rglob("*") if path.is_file() and not path.name.endswith(".aux.xml")]
    return {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def kill_at(environment, command, moment, kind):
    """Start a run, send it the signal when its output shows the moment, and wait for its end."""
    process = subprocess.Popen(
        ["qgis_process", *command],
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        preexec_fn=as_from_a_terminal,
    )
    for line in iter(process.stdout.readline, b""):
        if moment in line:
            break
    else:
        pytest.fail(f"{moment} was never said")
    process.send_signal(kind)
    process.communicate(timeout=120)
    return process.returncode


def test_a_killed_batch_leaves_only_whole_results_and_a_repeat_finishes(
    qgis_process, shell_environment, scene, tmp_path
):
    outputs = outputs_in(tmp_path)
    command = arguments(scene.folder, scene.dem, outputs)
    originals = fingerprints(scene.folder.parent)
    for moment, kind in (
        (b"(1/2)", signal.SIGTERM),
        (b"(2/2)", signal.SIGKILL),
        (b"2 photos:", signal.SIGKILL),
        (b"(2/2)", signal.SIGINT),
    ):
        code = kill_at(shell_environment, command, moment, kind)
        # qgis_process makes a cancellation of SIGINT, and hears it only when it gets round to its events.
        heard = code != 0 or (kind is signal.SIGINT and all(path.exists() for path in outputs.values()))
        assert heard, (moment, kind)
        assert_whole(outputs, photos=2)
    done = qgis_process(*command)
    assert done.returncode == 0, done.stderr
    assert len(rows_of(outputs["OUTPUT"])) == 2 and outputs["REPORT"].exists() and outputs["VIEWSHED"].exists()
    for photo in scene.folder.iterdir():
        assert f"taken from {outputs['ORIENTATIONS'] / photo.stem}.npz" in done.stdout
    assert_whole(outputs, photos=2)
    assert fingerprints(scene.folder.parent) == originals, "a run must leave photographs and DEM as they are"


WRITER = """
import sys
from pathlib import Path
from qgis.core import (QgsApplication, QgsCoordinateReferenceSystem, QgsField, QgsFields, QgsGeometry, QgsPointXY,
                       QgsProcessingContext, QgsWkbTypes)
from qgis.PyQt.QtCore import QVariant

app = QgsApplication([], False)
app.initQgis()
from skyline_viewshed.algorithms.import_photos import ImportPhotos
from skyline_viewshed.algorithms.shared.outputs import write_features, write_whole
from skyline_viewshed.core.io.report_file import ReportFile
from skyline_viewshed.demo.dem_file import write_dem
import numpy as np

folder, rows, times = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
algorithm, context, crs = ImportPhotos(), QgsProcessingContext(), QgsCoordinateReferenceSystem("EPSG:4326")
algorithm.initAlgorithm()
fields = QgsFields()
fields.append(QgsField("name", QVariant.String, "", 80))
features = [(QgsGeometry.fromPointXY(QgsPointXY(k % 180, k % 80)), [f"row {k}"]) for k in range(rows)]
print("ready", flush=True)
for _ in range(times):
    for suffix in ("gpkg", "shp", "geojson"):
        given = {"OUTPUT": str(folder / f"layer.{suffix}")}
        write_features(algorithm, given, "OUTPUT", context, fields, QgsWkbTypes.Type.Point, crs, features)
    write_dem(str(folder / "dem.tif"), np.arange(rows, dtype=float).reshape(-1, 100), 30.0, 8.0, 46.0)
    report = ReportFile(folder / "report.html")
    report.write("page")
    report.add("page-0001.html", report.cut(1))
    report.write("line\\n" * rows)
    report.finish(f"<html>{report.folder} ", "</html>")
    write_whole(folder / "picture.svg", "<svg>" + "line\\n" * rows + "</svg>")
print("done", flush=True)
"""


def writer_command(tmp_path, times):
    script = tmp_path / "writer.py"
    script.write_text(WRITER)
    folder = tmp_path / "results"
    folder.mkdir(exist_ok=True)
    return [sys.executable, str(script), str(folder), str(ROWS), str(times)], folder


def assert_all_present_files_are_whole(folder):
    """Look at whatever has its last name; give those names."""
    from osgeo import gdal, ogr

    names = {path.name for path in folder.iterdir() if not path.name.startswith(".")}
    for name in names & {"layer.gpkg", "layer.shp", "layer.geojson"}:
        source = ogr.Open(str(folder / name))
        found = [feature["name"] for feature in source.GetLayer(0)]
        assert found == [f"row {k}" for k in range(ROWS)], name
    if "dem.tif" in names:
        assert gdal.Open(str(folder / "dem.tif")).ReadAsArray().sum() == ROWS * (ROWS - 1) / 2
    for name in names & {"report.html", "picture.svg"}:
        text = (folder / name).read_text(encoding="utf-8")
        assert text.count("line\n") == ROWS and text.endswith((f"</{name[-4:]}>", f"</{name[-3:]}>")), name
    if "report.html" in names:
        pages = folder / (folder / "report.html").read_text(encoding="utf-8")[len("<html>") :].split(" ")[0]
        assert (pages / "page-0001.html").read_text() == "page"
    return names


def test_kills_at_random_moments_of_writing_leave_only_whole_files(tmp_path):
    command, folder = writer_command(tmp_path, times=10_000)
    random, endings, seen = Random(20261122), [], set()
    for number in range(MOMENTS):
        process = subprocess.Popen(
            command, env=PLAIN, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, preexec_fn=as_from_a_terminal
        )
        assert process.stdout.readline() == b"ready\n"
        time.sleep(random.uniform(0.0, 0.6))
        process.send_signal((signal.SIGKILL, signal.SIGTERM, signal.SIGKILL, signal.SIGINT)[number % 4])
        process.communicate(timeout=60)
        endings.append(process.returncode)
        seen |= assert_all_present_files_are_whole(folder)
    assert 0 not in endings and len(seen) > 2
    command, folder = writer_command(tmp_path, times=1)
    subprocess.run(command, env=PLAIN, stdin=subprocess.DEVNULL, capture_output=True, timeout=120, check=True)
    assert assert_all_present_files_are_whole(folder) >= {
        "layer.gpkg", "layer.shp", "layer.geojson", "dem.tif", "report.html", "picture.svg",
    }  # fmt: skip
