"""JOINT on real photographs of one place, as users meet it: in a script, from the dialog, in a model and in a shell.

IMG_2307 alone comes out wrong by more than 30 degrees, because a person hides most of its skyline. IMG_2315, which was
taken five minutes later 22 m away through a longer lens, is accepted.
"""

from __future__ import annotations

import json
import shutil

import pytest
from qgis.core import (
    QgsApplication,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
)
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.joint.ties import has_features
from whole_runs import rows_of

pytestmark = pytest.mark.qgis

TRUTH_DEG = {"IMG_2307": 77.7, "IMG_2315": 78.8}


@pytest.fixture(scope="module")
def walk(shared_data, tmp_path_factory):
    """A folder with the two photographs, and the DEM."""
    if not has_features():
        pytest.skip("OpenCV, which compares the photographs, is not installed")
    folder = tmp_path_factory.mktemp("joint") / "photos"
    folder.mkdir()
    for name in TRUTH_DEG:
        shutil.copy(shared_data / "khumbu-trek" / "photos" / f"{name}.jpg", folder)
    return folder, shared_data / "khumbu-trek" / "dem" / "dem.tif"


@pytest.fixture
def points(run, walk, tmp_path):
    run("importphotos", {"FOLDER": str(walk[0]), "OUTPUT": str(tmp_path / "photos.gpkg")})
    return str(tmp_path / "photos.gpkg")


def together(path):
    """Check that both photographs of an output are right and accepted, and that one names the other."""
    rows = {row["filename"]: row for row in rows_of(path)}
    assert set(rows) == set(TRUTH_DEG)
    for name, row in rows.items():
        assert row["status"] == "accepted", row["message"]
        assert abs(difference(row["heading"], TRUTH_DEG[name])) < 1.5
    assert "IMG_2315" in rows["IMG_2307"]["message"]


def test_a_script_and_the_photograph_alone(run, walk, points, tmp_path):
    given = {"INPUT": points, "DEM": str(walk[1]), "WORKERS": 1}
    results, feedback = run("orientphotos", {**given, "OUTPUT": str(tmp_path / "joint.gpkg"), "JOINT": True})
    together(tmp_path / "joint.gpkg")
    assert results["ACCEPTED"] == 2 and "1 photos gained from their neighbours." in feedback.infos
    alone = [text for text in feedback.infos if text.startswith("IMG_2307.jpg: ambiguous")]
    assert len(alone) == 1
    assert abs(difference(float(alone[0].split()[-1].rstrip("°")), TRUTH_DEG["IMG_2307"])) > 30


def test_the_dialog(provider, qgis_iface, walk, points, tmp_path):
    import processing
    from qgis.gui import QgsBrowserGuiModel, QgsLayerTreeView
    from qgis.PyQt.QtTest import QTest

    model, tree = QgsBrowserGuiModel(), QgsLayerTreeView()
    qgis_iface.browserModel, qgis_iface.layerTreeView = lambda: model, lambda: tree
    given = {"INPUT": points, "DEM": str(walk[1]), "WORKERS": 1, "JOINT": True}
    dialog = processing.createAlgorithmDialog(
        "skylineviewshed:orientphotos", {**given, "OUTPUT": str(tmp_path / "dialog.gpkg")}
    )
    dialog.show()
    dialog.runButton().click()
    for _ in range(6000):
        QTest.qWait(100)
        if dialog.results():
            break
    assert dialog.results()["ACCEPTED"] == 2
    dialog.close()
    together(tmp_path / "dialog.gpkg")


def test_a_model(provider, walk, points, tmp_path):
    """A model with `orientphotos` as its step, saved and read again."""
    child = QgsProcessingModelChildAlgorithm("skylineviewshed:orientphotos")
    child.setChildId("orient")
    static = {"INPUT": points, "DEM": str(walk[1]), "WORKERS": 1, "JOINT": True, "METHOD": 0, "COMPASS": 0}
    for name, value in static.items():
        child.addParameterSources(name, [QgsProcessingModelChildParameterSource.fromStaticValue(value)])
    output = QgsProcessingModelOutput("oriented", "oriented")
    output.setChildId("orient")
    output.setChildOutputName("OUTPUT")
    child.setModelOutputs({"oriented": output})
    model = QgsProcessingModelAlgorithm("walk", "walk")
    model.addChildAlgorithm(child)
    model.updateDestinationParameters()
    assert model.toFile(str(tmp_path / "walk.model3"))
    saved = QgsProcessingModelAlgorithm()
    assert saved.fromFile(str(tmp_path / "walk.model3"))
    import processing

    registry = QgsApplication.processingRegistry()
    assert registry.algorithmById("skylineviewshed:orientphotos") is not None
    # QGIS names the output of a model in one way up to 3.34 and in another later.
    (output,) = saved.destinationParameterDefinitions()
    processing.run(saved, {output.name(): str(tmp_path / "model.gpkg")})
    together(tmp_path / "model.gpkg")


def test_qgis_process(qgis_process, walk, points, tmp_path):
    given = {"INPUT": points, "DEM": str(walk[1]), "OUTPUT": str(tmp_path / "shell.gpkg"), "JOINT": True, "WORKERS": 1}
    ended = qgis_process(
        "--json", "run", "skylineviewshed:orientphotos", "--", *[f"{name}={value}" for name, value in given.items()]
    )
    assert ended.returncode == 0, ended.stderr
    assert json.loads(ended.stdout)["results"]["ACCEPTED"] == 2
    together(tmp_path / "shell.gpkg")
