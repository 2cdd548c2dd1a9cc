"""All algorithms under a handicap: without a network, on a full disk, in a read-only folder; and what they touch."""

from __future__ import annotations

import ctypes
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.qgis

HELPER = Path(__file__).with_name("handicaps.py")
DISK = "mount -t tmpfs -o size=1m tmpfs"
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE = 24, 1


@pytest.fixture(scope="module")
def job(scene, tmp_path_factory):
    """The scene's north photo, as `handicaps.py` wants it."""
    folder = tmp_path_factory.mktemp("job")
    shutil.copytree(scene.odd, folder / "odd")
    pose, (longitude, latitude) = scene.truth["north"], scene.positions["north"]
    line = "".join(f"north.jpg,{x},{y},{kind}\n" for x, y, kind in (
        (300, 500, "1,line"), (420, 505, "1,line"), (100, 500, "2,area"), (200, 500, "2,area"), (150, 540, "2,area")
    ))  # fmt: skip
    facts = {"photo": str(scene.folder / "north.jpg"), "folder": str(scene.folder), "dem": str(scene.dem)}
    facts |= {"longitude": longitude, "latitude": latitude, "hfov": scene.hfov_deg, "vfov": 50.0, "line": line}
    facts |= {"heading": pose.heading_deg, "pitch": pose.pitch_deg, "roll": pose.roll_deg}
    facts["seen"] = f"Point({longitude + 0.003} {latitude + 0.006})"
    (folder / "scene.json").write_text(json.dumps(facts))
    return folder


def may_mount():
    """Whether this user may give a folder a disk of its own, in a mount namespace that ends with the process."""
    command = ["unshare", "--mount", "bash", "-c", f"{DISK} /mnt"]
    return shutil.which("unshare") and subprocess.run(command, capture_output=True).returncode == 0


def heed_modes():
    """Take from root the right to write where modes forbid it."""
    if os.geteuid() == 0 and ctypes.CDLL(None, use_errno=True).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0):
        os._exit(77)


@pytest.fixture
def house(tmp_path):
    """A user's home, temporary folder, working folder and results, all empty, and the variables that say so."""
    folders = {name: tmp_path / name for name in ("home", "temp", "work", "results")}
    for folder in folders.values():
        folder.mkdir()
    moved = {"HOME": "home", "XDG_CACHE_HOME": "home", "XDG_CONFIG_HOME": "home", "XDG_DATA_HOME": "home"}
    moved |= dict.fromkeys(("TMPDIR", "TEMP", "TMP", "CPL_TMPDIR"), "temp")
    # Qt 5 lists the network's interfaces every ten seconds, by a socket of its own; not while we watch.
    patience = {"QT_BEARER_POLL_TIMEOUT": "100000000"}
    return folders, {**os.environ, **patience, **{name: str(folders[place]) for name, place in moved.items()}}


def state_of(folder):
    """Content and time of every file; QGIS itself writes statistics beside each raster it loads (.aux.xml)."""
    files = [path for path in folder.rglob("*") if path.is_file() and not path.name.endswith(".aux.xml")]
    return {path: (path.stat().st_mtime_ns, hashlib.sha256(path.read_bytes()).hexdigest()) for path in files}


def offline(job, house, *algorithms, **more):
    folders, environment = house
    command = [sys.executable, str(HELPER), "offline", str(job), str(folders["results"]), *algorithms]
    return subprocess.run(
        command, cwd=folders["work"], env={**environment, **more}, stdin=subprocess.DEVNULL, capture_output=True,
        text=True, timeout=600,
    )  # fmt: skip


def test_no_algorithm_asks_the_internet_or_writes_elsewhere_or_touches_originals(job, house, scene, algorithm_outputs):
    before, folders = state_of(scene.folder.parent), house[0]
    offline(job, house, "none of them")
    qgis_own = {path.name[:7] for path in folders["temp"].iterdir()} | {"process"}  # as in processing_AbCdEf
    done = offline(job, house)
    if done.returncode == 77:
        pytest.skip("the kernel lets nobody forbid sockets here")
    assert done.returncode == 0, (done.returncode, done.stderr)
    found = json.loads(done.stdout.splitlines()[-1])
    assert set(found) == {case.split(":")[0] for case in algorithm_outputs}
    for name, (said, outputs) in found.items():
        assert said == "succeeded", name
        assert all(Path(path).exists() for path in outputs), name
    assert state_of(scene.folder.parent) == before
    wanted = {Path(path) for _, outputs in found.values() for path in outputs}
    # Documented in docs/troubleshooting.md: a raster's style lies beside it, and so do the pictures of HEIC photos.
    wanted |= {path.with_suffix(".qml") for path in wanted if path.suffix == ".tif"}
    wanted |= {path.with_name(f"{path.stem}_previews") for path in wanted if path.suffix == ".gpkg"}
    strangers = [path for path in folders["results"].iterdir() if path not in wanted and path.suffix != ".xml"]
    assert strangers == [] and list(folders["work"].iterdir()) == []
    assert {path.name[:7] for path in folders["temp"].iterdir()} <= qgis_own
    # Settings and caches are QGIS's; nothing in them is called after us.
    ours = [path for path in folders["home"].rglob("*") if "skyline" in path.name.lower()]
    assert ours == []


def test_the_kernel_ends_a_process_that_asks_the_internet(job, house):
    done = offline(job, house, TRY_INTERNET="1")
    assert done.returncode in (-signal.SIGSYS, 77)


@pytest.fixture(scope="module")
def cases(job, tmp_path_factory):
    """Run the helper in a mode: {algorithm:output: (message, older result unharmed, what is new)}."""

    def run(mode):
        folder = tmp_path_factory.mktemp(mode)
        command = [sys.executable, str(HELPER), mode, str(job), str(folder)]
        if mode == "full":
            command = ["unshare", "--mount", "bash", "-c", f'{DISK} "$5" && exec "$@"', "bash", *command]
        before = heed_modes if mode == "closed" else None
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=600, preexec_fn=before
        )
        folder.chmod(0o755)
        if done.returncode == 77:
            pytest.skip("root cannot lay down its right to write everywhere")
        assert done.returncode == 0, done.stderr
        return folder, json.loads(done.stdout.splitlines()[-1])

    return run


@pytest.mark.parametrize("mode", ["full", "closed"])
def test_every_output_that_cannot_be_written_is_said_and_harms_nothing(cases, algorithm_outputs, mode):
    if mode == "full" and not may_mount():
        mode = "limit"
    folder, found = cases(mode)
    assert set(found) == algorithm_outputs, "each output of each algorithm has its case"
    for case, (said, unharmed, new) in found.items():
        first = said.split("\n")[1 if said.startswith("Unable to execute") else 0]
        assert "Traceback" not in said and "succeeded" not in said, (case, said)
        assert "cannot be written" in first and first.endswith("."), (case, said)
        assert str(folder) in first or mode == "limit", (case, said)
        assert unharmed, case
        # An output that is a folder may have been made; nothing is in it.
        assert new in ([], [case.replace(":", "_").lower()]), (case, new)


@pytest.fixture
def algorithm_outputs(qgis_app):
    """Names of all outputs of all algorithms that are written by us; models have none of their own."""
    from qgis.core import QgsApplication, QgsProcessingModelAlgorithm
    from skyline_viewshed.processing_provider.provider import SkylineViewshedProvider

    registry = QgsApplication.processingRegistry()
    provider = registry.providerById("skylineviewshed")
    added = None
    if provider is None:
        provider = added = SkylineViewshedProvider()
        registry.addProvider(added)
    names = {
        f"{algorithm.name()}:{definition.name()}"
        for algorithm in provider.algorithms()
        if not isinstance(algorithm, QgsProcessingModelAlgorithm)
        for definition in algorithm.parameterDefinitions()
        if definition.isDestination()
    }
    if added is not None:
        registry.removeProvider(added)
    return names
