"""Every output of every algorithm, on a disk that is full and in a folder that is read-only."""

from __future__ import annotations

import ctypes
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.qgis

HELPER = Path(__file__).with_name("writing_faults.py")
DISK = "mount -t tmpfs -o size=1m tmpfs"
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE = 24, 1


@pytest.fixture(scope="module")
def job(scene, tmp_path_factory):
    """The scene's north photo, as `writing_faults.py` wants it."""
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
