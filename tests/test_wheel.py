"""The wheel: small, without tests, and at work in a plain virtual environment as well as beside GDAL."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
OFFLINE = re.compile(r"NewConnectionError|Temporary failure in name resolution|Network is unreachable|ConnectTimeout")

TEN_LINES_ON_ARRAYS = """
import skyline_viewshed as sv
dem = sv.example_terrain()
pixels = sv.simulate(dem, (8.0, 46.5), heading_deg=300, pitch_deg=3, hfov_deg=60)
photo = sv.orient(pixels, dem, longitude_deg=8.0, latitude_deg=46.5, hfov_deg=60)
assert photo.status == "accepted" and abs(photo.heading_deg - 300) < 0.5 and photo.p_correct > 0.9
assert photo.heading_interval_deg[0] < 300 < photo.heading_interval_deg[1]
horizon = sv.horizon_profile(dem, photo.observer)
seen = sv.viewshed(dem, photo.view)
lon, lat = photo.view.place(dem, [400, 400], [450, 10])
assert abs(lon[0] - 8.0) < 0.1 and str(lon[1]) == "nan" and seen.visible.any() and horizon.elevation_deg.max() > 0
assert sv.overlay(photo).size == (1280, 960) and "accepted" in repr(photo) and "<img" in photo._repr_html_()
"""

NOTHING_ELSE = """
from importlib.util import find_spec
assert [name for name in ("qgis", "cv2", "osgeo", "pillow_heif", "exifread") if find_spec(name)] == []
"""

FILES_WITHOUT_GDAL = """
import sys
import numpy as np
import skyline_viewshed as sv
photo_path, elevations = sys.argv[1:]
metadata = sv.read_metadata(photo_path)
assert metadata.focal_length_35mm == 28 and metadata.camera == "Test Camera" and metadata.latitude_deg > 46
photo = sv.orient(photo_path, sv.dem_from_array(np.load(elevations), 75.0, 8.0, 46.5))
assert photo.status == "accepted" and abs(photo.heading_deg - 20) < 1, photo
for call in (lambda: sv.open_dem("dem.tif"), lambda: sv.save_points([photo], "photos.gpkg")):
    try:
        call()
    except sv.SkylineViewshedError as error:
        assert "needs the Python package osgeo." in str(error) and "pip install" in str(error), error
    else:
        raise AssertionError("GDAL was not missed")
assert sv.orient("nothing.heic", sv.example_terrain()).status == "failed"
"""

TEN_LINES_ON_FILES = """
import sys
sys.modules["qgis"] = sys.modules["cv2"] = None
import skyline_viewshed as sv
photo_path, dem_path = sys.argv[1:]
dem = sv.open_dem(dem_path)
photo = sv.orient(photo_path, dem)
assert photo.status == "accepted" and abs(photo.heading_deg - 20) < 0.5, photo
horizon = sv.horizon_profile(dem, photo.observer)
seen = sv.viewshed(dem, photo.view)
lon, lat = photo.view.place(dem, [400, 400], [560, 10])
assert 7 < lon[0] < 9 and 46 < lat[0] < 47 and str(lon[1]) == "nan" and seen.visible.any() and len(horizon.azimuth_deg)
sv.overlay(photo).save("overlay.png")
sv.save_points([photo], "photos.gpkg")
sv.save_report([photo], "report.html")
sv.save_viewshed(seen, dem, "seen.tif")
"""


def run(*command, cwd, **environment):
    """Run a command as a shell without our paths does."""
    inherited = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "PYTHONHOME")}
    return subprocess.run(
        [*map(str, command)], cwd=cwd, env={**inherited, **environment}, capture_output=True, text=True, timeout=900
    )


def installed(*command, cwd):
    """Run pip; without a network there is nothing to test."""
    done = run(*command, cwd=cwd)
    if done.returncode and OFFLINE.search(done.stdout + done.stderr):
        pytest.skip("PyPI cannot be reached")
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built from a copy of the files that git knows, as a fresh clone has them."""
    source, target = tmp_path_factory.mktemp("clone") / "anything", tmp_path_factory.mktemp("wheel")
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        capture_output=True,
    ).stdout.decode()
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).exists() and not name.startswith("docs/images/"):
            (source / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, source / name)
    before = {path.relative_to(source) for path in source.rglob("*")}
    installed(sys.executable, "-m", "pip", "wheel", "--no-deps", "-w", target, source, cwd=target)
    assert {path.relative_to(source) for path in source.rglob("*")} == before, "building left files behind"
    (built,) = target.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def plain(wheel, tmp_path_factory):
    """`bin` folder of a virtual environment with the wheel and what it asks for, and nothing else."""
    folder = tmp_path_factory.mktemp("plain") / "venv"
    assert run(sys.executable, "-m", "venv", folder, cwd=folder.parent).returncode == 0
    bin_folder = folder / ("Scripts" if os.name == "nt" else "bin")
    installed(bin_folder / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check", wheel, cwd=folder)
    return bin_folder


@pytest.fixture(scope="module")
def beside_gdal(wheel, tmp_path_factory):
    """Folder that makes the wheel importable for the Python that runs these tests, which has GDAL."""
    pytest.importorskip("osgeo.gdal")
    folder = tmp_path_factory.mktemp("site")
    installed(sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--target", folder, wheel, cwd=folder)
    return folder


def test_the_wheel_is_small_and_holds_the_core_alone(wheel):
    version = re.search(r"^version=(.+)$", (ROOT / "metadata.txt").read_text(encoding="utf-8"), re.MULTILINE).group(1)
    assert wheel.name == f"skyline_viewshed-{version}-py3-none-any.whl"
    assert wheel.stat().st_size < 1.5e6  # the sky network alone is 0.74 MB
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        metadata = archive.read(f"skyline_viewshed-{version}.dist-info/METADATA").decode()
    ours = {name.removeprefix("skyline_viewshed/") for name in names if name.startswith("skyline_viewshed/")}
    assert {name for name in ours if not name.startswith("core/")} == {"__init__.py", "__main__.py", "metadata.txt"}
    source = {path.relative_to(ROOT).as_posix() for path in (ROOT / "core").rglob("*") if path.is_file()}
    assert {name for name in ours if name.startswith("core/")} == {name for name in source if "__pycache__" not in name}
    assert "Requires-Python: >=3.9" in metadata
    required = re.findall(r"^Requires-Dist: ([\w-]+)$", metadata, re.MULTILINE)
    assert required == ["numpy", "pillow", "scipy"] or sorted(map(str.lower, required)) == ["numpy", "pillow", "scipy"]
    extras = re.findall(r"^Provides-Extra: (\w+)$", metadata, re.MULTILINE)
    assert sorted(extras) == ["all", "dask", "exif", "gdal", "heic", "opencv"]


def test_the_ten_lines_run_on_arrays_in_a_plain_environment(plain, tmp_path):
    done = run(plain / "python", "-c", NOTHING_ELSE + TEN_LINES_ON_ARRAYS, cwd=tmp_path)
    assert done.returncode == 0, done.stderr


def test_without_gdal_photographs_are_read_and_what_needs_it_says_so(plain, scene, tmp_path):
    import numpy as np
    from skyline_viewshed.core.base.terrain import Window
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(str(scene.dem))
    np.save(tmp_path / "elevations.npy", dem.read(Window(0, 0, *dem.shape)))
    script = NOTHING_ELSE + FILES_WITHOUT_GDAL
    done = run(plain / "python", "-c", script, scene.folder / "north.jpg", "elevations.npy", cwd=tmp_path)
    assert done.returncode == 0, done.stderr


def test_the_console_script_is_there_and_misses_gdal_in_one_sentence(plain, scene, tmp_path):
    script = plain / "skyline-viewshed"
    assert re.fullmatch(r"skyline-viewshed \d+\.\d+\.\d+\n", run(script, "--version", cwd=tmp_path).stdout)
    done = run(script, "orient", scene.folder, scene.dem, "-o", "photos.gpkg", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr.startswith("skyline-viewshed: Writing points needs the Python package osgeo.ogr. Run: ")
    assert len(done.stderr.splitlines()) == 1 and list(tmp_path.iterdir()) == []


def test_the_ten_lines_run_on_files_where_gdal_is(beside_gdal, scene, tmp_path):
    arguments = scene.folder / "north.jpg", scene.dem
    done = run(sys.executable, "-c", TEN_LINES_ON_FILES, *arguments, cwd=tmp_path, PYTHONPATH=str(beside_gdal))
    assert done.returncode == 0, done.stderr
    written = {path.name for path in tmp_path.iterdir()}
    assert written == {"overlay.png", "photos.gpkg", "report.html", "seen.tif"}


def test_the_command_line_runs_from_the_wheel_where_gdal_is(beside_gdal, scene, tmp_path):
    command = [sys.executable, "-m", "skyline_viewshed", "orient", scene.folder, scene.dem, "-o", "photos.geojson"]
    done = run(*command, cwd=tmp_path, PYTHONPATH=str(beside_gdal))
    assert done.returncode == 0, done.stderr
    assert "2 photos: 2 accepted" in done.stderr and (tmp_path / "photos.geojson").exists()
