"""What a run leaves behind when it is killed, when the disk is full, and when names and DEMs are odd."""

from __future__ import annotations

import hashlib
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from random import Random

import numpy as np
import pytest

pytestmark = pytest.mark.qgis

LIMIT_BYTES = 60_000
"""Largest file of the run on a nearly full disk: enough for QGIS's own settings, too little for a report."""
MANY = 10_000
BYTES_PER_PHOTO = 10_000
"""What the list of a folder may hold for each photograph."""
BYTES_FOR_A_REFUSAL = 32 * 2**20
HOSTILE = 'it\'s <img src=x onerror=alert(1)> & "100 %" 🏔 Säntis.jpg'


def outputs_in(folder):
    return {
        "OUTPUT": folder / "points.gpkg",
        "POLYGONS": folder / "ground.gpkg",
        "VIEWSHED": folder / "viewshed.tif",
        "REPORT": folder / "report.html",
        "RASTERS": folder / "rasters",
    }


def arguments(photos, dem, outputs):
    given = {"FOLDER": photos, "DEM": dem, "MAX_DISTANCE": 8000, **outputs}
    pairs = [f"{name}={value}" for name, value in given.items()]
    return ["run", "skylineviewshed:photoviewshed", "--", *pairs]


def rows_of(path):
    ogr = pytest.importorskip("osgeo.ogr")
    source = ogr.Open(str(path))
    return [feature.items() for feature in source.GetLayer(0)] if source and source.GetLayerCount() else []


def assert_whole(outputs, photos):
    """Every result that is there is a whole one; what is hidden or ends in .part is none."""
    from osgeo import gdal

    folder = outputs["OUTPUT"].parent
    rasters = [path for path in folder.rglob("*.tif") if not path.name.startswith(".")]
    for path in rasters:
        raster = gdal.Open(str(path))
        assert raster is not None and raster.ReadAsArray() is not None, path
    if outputs["REPORT"].exists():
        assert outputs["REPORT"].read_text(encoding="utf-8").rstrip().endswith("</html>")
    for name in ("OUTPUT", "POLYGONS"):
        if outputs[name].exists():
            assert len(rows_of(outputs[name])) == photos, name
    known = set(outputs.values()) | set(rasters)
    strangers = [path for path in folder.iterdir() if path not in known and not path.name.startswith(".")]
    assert strangers == []


def fingerprints(folder):
    """Content of all files but the statistics that QGIS itself writes beside any raster it loads (.aux.xml)."""
    files = [path for path in folder.rglob("*") if path.is_file() and not path.name.endswith(".aux.xml")]
    return {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def as_from_a_terminal():
    """Undo what a shell does to its background jobs, in which these tests may run: they do not hear SIGINT."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


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
from skyline_viewshed.algorithms.outputs import write_features, write_whole
from skyline_viewshed.core.io.report_file import ReportFile
from skyline_viewshed.core.io.write_raster import write_dem
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
    report.write("line\\n" * rows)
    report.finish("<html>", "</html>")
    write_whole(folder / "picture.svg", "<svg>" + "line\\n" * rows + "</svg>")
print("done", flush=True)
"""
PLAIN = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parent.parent / "build" / "plugins")}
ROWS = 2000
MOMENTS = 8


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


@pytest.fixture
def nearly_full(shell_environment):
    """Run qgis_process where no file can grow beyond LIMIT_BYTES."""

    def run(command):
        return subprocess.run(
            ["qgis_process", *command],
            # Python would keep half a module that it has compiled, and fall over it next time.
            env={**shell_environment, "PYTHONDONTWRITEBYTECODE": "1"},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=300,
            restore_signals=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT_BYTES, LIMIT_BYTES)),
        )

    return run


def test_a_full_disk_ends_the_run_with_a_sentence_and_no_results(nearly_full, scene, tmp_path):
    outputs = outputs_in(tmp_path)
    done = nearly_full(arguments(scene.folder, scene.dem, outputs))
    assert done.returncode == 1
    assert "cannot be written" in done.stderr and "free some space" in done.stderr, done.stderr
    assert not outputs["REPORT"].exists() and not outputs["OUTPUT"].exists()


def test_a_layer_that_does_not_fit_on_the_disk_is_taken_away_again(nearly_full, scene, tmp_path):
    output = tmp_path / "photos.gpkg"
    done = nearly_full(["run", "skylineviewshed:importphotos", "--", f"FOLDER={scene.folder}", f"OUTPUT={output}"])
    assert done.returncode == 1
    assert f"{output} could not be written" in done.stderr, done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["OUTPUT", "VIEWSHED", "REPORT"])
def test_an_output_below_a_file_is_refused_in_words(qgis_process, scene, tmp_path, name):
    outputs = outputs_in(tmp_path)
    (tmp_path / "file").write_text("no folder")
    outputs[name] = tmp_path / "file" / outputs[name].name
    done = qgis_process(*arguments(scene.folder / "..", scene.dem, outputs))
    said = done.stderr + done.stdout
    assert done.returncode == 1
    assert "Traceback" not in said and str(tmp_path / "file") in said, said


@pytest.fixture(scope="module")
def odd_run(qgis_process, scene, tmp_path_factory):
    """One run in a folder of spaces, umlauts, an emoji and more than 200 characters, with the DEM as a VRT in it."""
    from osgeo import gdal

    folder = tmp_path_factory.mktemp("odd") / "Fotos für Zoë 🏔" / ("lang" * 45) / "50% & more"
    photos, results = folder / "Bilder", folder / "out put"
    photos.mkdir(parents=True)
    assert len(str(photos)) > 200
    shutil.copy(scene.folder / "north.jpg", photos / HOSTILE)
    dem = folder / "Höhen modell.vrt"
    assert gdal.BuildVRT(str(dem), [str(scene.dem)]) is not None
    outputs = outputs_in(results)
    return outputs, photos, qgis_process(*arguments(photos, dem, outputs))


def test_odd_paths_and_a_vrt_work(odd_run, scene):
    outputs, photos, done = odd_run
    assert done.returncode == 0, done.stderr
    (row,) = rows_of(outputs["OUTPUT"])
    assert row["photo"] == str(photos / HOSTILE)
    assert row["heading"] == pytest.approx(scene.truth["north"].heading_deg, abs=0.5)
    assert len(list(outputs["RASTERS"].glob("*.tif"))) == 1 and outputs["VIEWSHED"].exists()


def test_a_hostile_file_name_stays_text_in_the_report(odd_run):
    report = odd_run[0]["REPORT"].read_text(encoding="utf-8")
    assert "<img src=x" not in report and "&lt;img src=x onerror=alert(1)&gt;" in report


def peak_bytes(environment, *arguments):
    """Run qgis_process; gives its exit code and the most memory that it held.

    Asked while it runs, for what wait4 tells is at least what pytest held when it made the process.
    """
    process = subprocess.Popen(
        ["qgis_process", *arguments],
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    peak = 0
    while process.poll() is None:
        with suppress(OSError):
            held = re.search(r"VmHWM:\s+(\d+) kB", Path(f"/proc/{process.pid}/status").read_text())
            peak = max(peak, int(held.group(1)) * 1024 if held else 0)
        time.sleep(0.02)
    return process.returncode, peak


def test_a_folder_of_ten_thousand_photographs_is_read_in_little_memory(qgis_process, shell_environment, tmp_path):
    from skyline_viewshed.core.io.write_photo import write_photo
    from skyline_viewshed.core.model import PhotoMetadata

    folder, few, output = tmp_path / "many", tmp_path / "few", tmp_path / "photos.gpkg"
    folder.mkdir()
    few.mkdir()
    first = folder / "00000.jpg"
    metadata = PhotoMetadata(str(first), 64, 48, latitude_deg=46.5, longitude_deg=8.0, focal_length_35mm=28.0)
    write_photo(str(first), np.zeros((48, 64, 3), np.uint8), metadata)
    for number in range(1, MANY):
        os.link(first, folder / f"{number:05d}.jpg")
    os.link(first, few / first.name)
    peaks = []
    for photos in (few, folder):
        arguments = ("run", "skylineviewshed:importphotos", "--", f"FOLDER={photos}", f"OUTPUT={output}")
        code, peak = peak_bytes(shell_environment, *arguments)
        assert code == 0, qgis_process(*arguments).stderr
        assert peak > 50 * 2**20, "QGIS alone takes as much"
        peaks.append(peak)
    assert len(rows_of(output)) == MANY
    assert peaks[1] - peaks[0] < MANY * BYTES_PER_PHOTO, peaks


BOMBS = """
import struct, sys, zlib
from pathlib import Path
from osgeo import gdal
from skyline_viewshed.core.errors import PhotoError
from skyline_viewshed.core.io.photo import read_metadata, read_photo

folder = Path(sys.argv[1])

def chunk(kind, payload):
    return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))

def png(path, side):
    squeezed, zeros = zlib.compressobj(1), bytes(3 * side + 1)
    rows = b"".join(squeezed.compress(zeros) for _ in range(side)) + squeezed.flush()
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0))
    path.write_bytes(b"\\x89PNG\\r\\n\\x1a\\n" + header + chunk(b"IDAT", rows) + chunk(b"IEND", b""))

def tiff(path, side):
    options = ["TILED=YES", "SPARSE_OK=TRUE", "COMPRESS=DEFLATE", "BIGTIFF=YES"]
    gdal.GetDriverByName("GTiff").Create(str(path), side, side, 3, gdal.GDT_Byte, options)

png(folder / "honest.png", 500)
tiff(folder / "honest.tif", 500)
png(folder / "bomb.png", int(sys.argv[2]))
tiff(folder / "bomb.tif", 50_000)
for name in ("honest.png", "honest.tif"):
    read_photo(str(folder / name), 1600)

def peak():
    # Of this program alone: ru_maxrss begins with what the process that started it held.
    return int(Path("/proc/self/status").read_text().split("VmHWM:")[1].split()[0]) * 1024

before = peak()
for name in ("bomb.png", "bomb.tif"):
    for read in (read_metadata, read_photo):
        try:
            read(str(folder / name))
        except PhotoError as error:
            assert "megapixels" in str(error), error
        else:
            raise AssertionError(name)
print(peak() - before)
"""


def test_true_pictures_of_many_gigabytes_are_refused_before_they_are_unpacked(tmp_path):
    script = tmp_path / "bombs.py"
    script.write_text(BOMBS)
    command = [sys.executable, str(script), str(tmp_path), "16000"]
    done = subprocess.run(command, env=PLAIN, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "bomb.png").stat().st_size < 10_000_000, "small on the disk, 768 MB unpacked"
    assert int(done.stdout.split()[-1]) < BYTES_FOR_A_REFUSAL


def test_the_same_dem_as_cog_and_in_other_coordinate_systems_gives_the_same_heading(scene, tmp_path):
    from osgeo import gdal
    from skyline_viewshed.core.batch import PhotoRequest, orient_request
    from skyline_viewshed.core.io.raster import open_dem

    cog, utm, degrees = (str(tmp_path / f"{name}.tif") for name in ("cog", "utm", "degrees"))
    assert gdal.Translate(cog, str(scene.dem), format="COG") is not None
    gdal.Warp(utm, str(scene.dem), dstSRS="EPSG:32632", resampleAlg="cubic")
    gdal.Warp(degrees, str(scene.dem), dstSRS="EPSG:4326", resampleAlg="cubic")
    request = PhotoRequest(str(scene.folder / "north.jpg"))
    found = {
        path: orient_request(request, open_dem(path)).orientation.best.pose
        for path in (str(scene.dem), cog, utm, degrees)
    }
    first = found[str(scene.dem)]
    assert found[cog].heading_deg == pytest.approx(first.heading_deg, abs=1e-6)
    for path in (utm, degrees):
        assert found[path].heading_deg == pytest.approx(first.heading_deg, abs=0.15), path
        assert found[path].pitch_deg == pytest.approx(first.pitch_deg, abs=0.15), path
