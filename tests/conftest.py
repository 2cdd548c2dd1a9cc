"""Shared fixtures: the environment, the shared data, QGIS with our provider, and a scene with known truth."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest
from hypothesis import settings

ROOT = Path(__file__).resolve().parent.parent
PLUGINS = ROOT / "build" / "plugins"
BARE_MODULES = ("cv2", "pillow_heif", "exifread")
"""Blocked if SKYLINE_BARE=1, to run the tests with only the packages that QGIS itself ships."""

# All of this must be set before NumPy and QGIS load. pytest-qgis would start QGIS before it reads any conftest.py, and
# without an X server that ends the process. pyproject.toml therefore keeps it from loading by itself, and it loads
# here.
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")
os.environ.setdefault("PYTHONPATH", str(PLUGINS))  # for the processes that tests start
if not (PLUGINS / "skyline_viewshed").exists():
    PLUGINS.mkdir(parents=True, exist_ok=True)
    (PLUGINS / "skyline_viewshed").symlink_to(Path("..", ".."), target_is_directory=True)
if os.environ.get("SKYLINE_BARE") == "1":
    for module in BARE_MODULES:
        sys.modules[module] = None

# A busy machine is no fault of the code: no test is timed.
settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")

try:
    import qgis.core  # noqa: F401
except ImportError:
    HAVE_QGIS = False
else:
    HAVE_QGIS = True

PYTEST_QGIS = ("pytest_qgis.plugin", "pytest_qgis.pytest_qgis")
"""The module of pytest-qgis, and its name before version 5."""
pytest_plugins = [name for name in PYTEST_QGIS if HAVE_QGIS and find_spec("pytest_qgis") and find_spec(name)][:1]


def pytest_ignore_collect(collection_path, config):
    """Skip the QGIS tests if there is no QGIS (make test-core in a plain environment)."""
    if not HAVE_QGIS and collection_path.is_relative_to(ROOT / "tests"):
        return True if {"algorithms", "panel"} & set(collection_path.parts[len(ROOT.parts) :]) else None
    return None


@pytest.fixture(scope="session")
def shared_data():
    """Folder of the real photographs and DEMs, which are not part of the repository."""
    for folder in (os.environ.get("SKYLINE_DATA"), ROOT.parent / "shared" / "data"):
        if folder and Path(folder).is_dir():
            return Path(folder)
    pytest.skip("the shared real data are not beside the checkout and SKYLINE_DATA is not set")


@pytest.fixture(scope="session")
def compiled(tmp_path_factory):
    """Compiled catalogues by language."""
    from skyline_viewshed.tools import make_translations

    if not (shutil.which("lrelease") or shutil.which("lrelease-qt6")):
        pytest.skip("lrelease is not installed (qttools5-dev-tools)")
    folder = tmp_path_factory.mktemp("compiled")
    return {
        language: make_translations.compile_catalogue(
            make_translations.catalogue_path(language), folder / f"{language}.qm"
        )
        for language in make_translations.LANGUAGES
    }


@pytest.fixture(scope="session")
def shell_environment(tmp_path_factory):
    """Environment in which a plain qgis_process sees the plugin, as `make env` prints it."""
    lines = subprocess.run(
        [ROOT / "tools" / "env.sh"], check=True, capture_output=True, text=True, stdin=subprocess.DEVNULL
    ).stdout
    dump = subprocess.run(
        ["bash", "-c", f"{lines}\nexec env -0"], check=True, capture_output=True, stdin=subprocess.DEVNULL
    ).stdout.decode()
    environment = dict(entry.split("=", 1) for entry in dump.split("\0") if "=" in entry)
    if os.environ.get("SKYLINE_BARE") == "1":
        stubs = tmp_path_factory.mktemp("blocked")
        for module in BARE_MODULES:
            (stubs / f"{module}.py").write_text("raise ImportError('blocked for this test')\n")
        environment["PYTHONPATH"] = f"{stubs}{os.pathsep}{environment['PYTHONPATH']}"
    return environment


@pytest.fixture(scope="session")
def provider(qgis_app, qgis_processing):
    """Our provider, registered once as the plugin does it; a second one of the same id would delete the first."""
    from skyline_viewshed import classFactory

    plugin = classFactory(None)
    plugin.initProcessing()
    yield plugin.provider
    plugin.unload()


@pytest.fixture(scope="session")
def qgis_process(shell_environment):
    """Run qgis_process with arguments and return the finished process."""
    if shutil.which("qgis_process", path=shell_environment["PATH"]) is None:
        pytest.skip("qgis_process is not installed")

    def run(*arguments, **options):
        return subprocess.run(
            ["qgis_process", *map(str, arguments)],
            env=shell_environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=900,
            cwd=ROOT,
            **options,
        )

    return run


@pytest.fixture(scope="session")
def scene(tmp_path_factory):
    """A simulated range with two photographs of known pose, and the unusual files that folders contain.

    Returns
    -------
    SimpleNamespace
        `folder` with north.jpg and west.jpg, `dem`, `truth` (heading, pitch, roll by name), `positions` (lon, lat),
        `hfov_deg`, `odd` (folder with a photo without GPS, one at 0/0, one without focal length, an empty and a
        damaged file).
    """
    from dataclasses import replace
    from types import SimpleNamespace

    from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
    from skyline_viewshed.core.base.model import PhotoMetadata
    from skyline_viewshed.core.base.terrain import Observer
    from skyline_viewshed.core.io.raster import open_dem
    from skyline_viewshed.core.io.write_photo import write_photo
    from skyline_viewshed.core.simulate.render import render_view
    from skyline_viewshed.core.simulate.scene import SceneOptions
    from skyline_viewshed.demo.dem_file import write_dem
    from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

    root = tmp_path_factory.mktemp("scene")
    folder, odd, dem_path = root / "photos", root / "odd", root / "dem.tif"
    folder.mkdir()
    odd.mkdir()
    mountains = make_mountains(5, MountainOptions(size=320, cell_m=75.0))
    write_dem(str(dem_path), mountains.elevation_m, 75.0, 8.0, 46.5)
    dem = open_dem(str(dem_path))
    width, height, f35 = 800, 600, 28.0
    camera = Camera(width, height, focal_from_35mm_px(width, height, f35))
    truth, positions, metadata = {}, {}, None
    places = {"north": ((198, 122), Pose(20.0, 2.0, 0.5)), "west": ((86, 240), Pose(200.0, 2.0, 0.5))}
    for name, (pixel, pose) in places.items():
        longitude, latitude = map(float, dem.position_of(*pixel))
        view = render_view(dem, Observer(longitude, latitude, 2.0), camera, pose, SceneOptions(len(truth)))
        path = str(folder / f"{name}.jpg")
        metadata = PhotoMetadata(
            path,
            width,
            height,
            latitude_deg=latitude,
            longitude_deg=longitude,
            altitude_m=view.eye_elevation_m,
            altitude_reference="sea level",
            focal_length_35mm=f35,
            compass_heading_deg=(pose.heading_deg + 6.0) % 360,
            compass_reference="T",
            camera="Test Camera",
        )
        write_photo(path, view.pixels, metadata)
        truth[name], positions[name] = pose, (longitude, latitude)
    nowhere = replace(metadata, latitude_deg=None, longitude_deg=None)
    write_photo(str(odd / "no_gps.jpg"), view.pixels, nowhere)
    write_photo(str(odd / "null_island.jpg"), view.pixels, replace(metadata, latitude_deg=0.0, longitude_deg=0.0))
    write_photo(str(odd / "no_focal.jpg"), view.pixels, replace(metadata, focal_length_35mm=None))
    write_photo(str(odd / "no_sky.jpg"), view.pixels[-60:, :, :].repeat(10, 0), metadata)
    (odd / "empty.heic").write_bytes(b"")
    (odd / "damaged.jpg").write_bytes((folder / "west.jpg").read_bytes()[:3000])
    return SimpleNamespace(
        folder=folder, odd=odd, dem=dem_path, truth=truth, positions=positions, hfov_deg=camera.hfov_deg
    )
