"""Outputs that cannot be written: a disk that is full, a folder that is none. A sentence, and nothing half done."""

from __future__ import annotations

import resource
import subprocess

import pytest
from whole_runs import arguments, outputs_in

pytestmark = pytest.mark.qgis

LIMIT_BYTES = 60_000
"""Largest file of the run on a nearly full disk: enough for QGIS's own settings, too little for a report."""


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


@pytest.mark.parametrize("first", ["REPORT", "ORIENTATIONS"])
def test_a_full_disk_ends_the_run_with_a_sentence_and_no_results(nearly_full, scene, tmp_path, first):
    outputs = outputs_in(tmp_path)
    if first == "REPORT":
        del outputs["ORIENTATIONS"]  # whose files are too large as well, and come before
    done = nearly_full(arguments(scene.folder, scene.dem, outputs))
    assert done.returncode == 1
    assert "cannot be written" in done.stderr and "free some space" in done.stderr, done.stderr
    assert not outputs["REPORT"].exists() and not outputs["OUTPUT"].exists()
    assert not list(tmp_path.rglob("*.npz")) and not list(tmp_path.rglob("*.part"))


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


@pytest.mark.parametrize("wrapped", [False, True])
def test_only_vector_layers_are_kept_in_memory(provider, wrapped):
    """Elsewhere `memory:` would become a file of that name in the working folder."""
    from qgis.core import (
        QgsProcessingContext,
        QgsProcessingOutputLayerDefinition,
        QgsProcessingParameterFeatureSink,
    )

    value = QgsProcessingOutputLayerDefinition("memory:") if wrapped else "memory:"
    ours = [algorithm for algorithm in provider.algorithms() if hasattr(algorithm, "help_text")]
    others = [
        (algorithm, definition.name())
        for algorithm in ours
        for definition in algorithm.destinationParameterDefinitions()
        if not isinstance(definition, QgsProcessingParameterFeatureSink)
    ]
    assert {"directedviewshed", "drapephoto", "photocoverage"} <= {algorithm.name() for algorithm, _ in others}
    for algorithm, output in others:
        fault = algorithm._destination_fault({output: value}, QgsProcessingContext())
        assert f"{output} cannot be kept in memory" in fault


def test_a_raster_in_memory_is_refused_before_anything_starts(refusal, scene):
    from qgis.core import QgsVectorLayer

    points = QgsVectorLayer("Point?crs=EPSG:4326&field=heading:double", "points", "memory")
    given = {"INPUT": points, "DEM": str(scene.dem), "OUTPUT": "memory:"}
    assert "OUTPUT cannot be kept in memory" in refusal("directedviewshed", given)
    assert refusal("horizonprofile", given) == ""
