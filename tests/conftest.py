"""What all tests share: the shared data, QGIS with our provider, a photographed scene with known truth."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
BARE_MODULES = ("cv2", "pillow_heif", "exifread")
"""Blocked when SKYLINE_BARE=1, to run the tests on what QGIS itself ships."""

if not (ROOT / "build" / "plugins" / "skyline_viewshed").exists():
    raise pytest.UsageError("The package's link is missing. Run: make link")
if os.environ.get("SKYLINE_BARE") == "1":
    for module in BARE_MODULES:
        sys.modules[module] = None
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

try:
    import qgis.core  # noqa: F401
except ImportError:
    HAVE_QGIS = False
else:
    HAVE_QGIS = True


def pytest_ignore_collect(collection_path, config):
    """Leave out the QGIS tests where there is no QGIS (make test-core in a plain environment)."""
    if not HAVE_QGIS and "algorithms" in collection_path.parts and collection_path.is_relative_to(ROOT / "tests"):
        return True
    return None


@pytest.fixture(scope="session")
def shared_data():
    """Folder of the real photographs and DEMs, which are no part of the repository."""
    for folder in (os.environ.get("SKYLINE_DATA"), ROOT.parent / "shared" / "data"):
        if folder and Path(folder).is_dir():
            return Path(folder)
    pytest.skip("the shared real data are not beside the checkout and SKYLINE_DATA is not set")


@pytest.fixture(scope="session")
def shell_environment():
    """Environment in which a plain qgis_process sees the plugin, as `make env` prints it."""
    lines = subprocess.run(
        [ROOT / "tools" / "env.sh"], check=True, capture_output=True, text=True, stdin=subprocess.DEVNULL
    ).stdout
    dump = subprocess.run(
        ["bash", "-c", f"{lines}\nexec env -0"], check=True, capture_output=True, stdin=subprocess.DEVNULL
    ).stdout.decode()
    return dict(entry.split("=", 1) for entry in dump.split("\0") if "=" in entry)


@pytest.fixture(scope="session")
def qgis_process(shell_environment):
    """Run qgis_process with arguments and give the finished process."""
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
