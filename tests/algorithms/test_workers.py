"""Worker processes in the algorithms: the same results in order, deaths that cost one photo, and cancelling."""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
import worker_jobs
from qgis.core import QgsField, QgsProcessingException, QgsVectorLayer, edit
from qgis.PyQt.QtCore import QVariant
from skyline_viewshed.core import many
from skyline_viewshed.core.base.camera import Pose
from skyline_viewshed.core.joint.pairs import Tie
from skyline_viewshed.core.joint.ties import axes_of
from skyline_viewshed.core.workers import pool as pools
from whole_runs import as_from_a_terminal, rows_of

pytestmark = pytest.mark.qgis

CREATED = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d")
SETTING = re.compile(r"Worker processes</td><td><bdi>\d")


@pytest.fixture(scope="module")
def photos(scene, tmp_path_factory):
    """A folder of four photographs, one of them without a position, and a point layer of the others."""
    folder = tmp_path_factory.mktemp("many") / "photos"
    shutil.copytree(scene.folder, folder)
    shutil.copy(scene.odd / "no_gps.jpg", folder / "m_no_gps.jpg")
    shutil.copy(folder / "north.jpg", folder / "north2.jpg")
    return folder


def attributes(path):
    layer = QgsVectorLayer(str(path), "rows", "ogr")
    columns = [field.name() for field in layer.fields() if field.name() != "fid"]
    return [(f.geometry().asWkt(9), [f[name] for name in columns]) for f in layer.getFeatures()]


def outputs(folder):
    folder.mkdir()
    return {"OUTPUT": str(folder / "points.gpkg"), "POLYGONS": str(folder / "ground.gpkg"),
            "VIEWSHED": str(folder / "seen.tif"), "REPORT": str(folder / "report.html"),
            "RASTERS": str(folder / "rasters")}  # fmt: skip


def cells(path):
    from osgeo import gdal

    return gdal.Open(str(path)).ReadAsArray()


def test_photoviewshed_and_directedviewshed_give_the_same_with_two_processes(run, scene, photos, tmp_path):
    given = {"FOLDER": str(photos), "DEM": str(scene.dem), "MAX_DISTANCE": 6000}
    for count in (1, 2):
        folder = tmp_path / str(count)
        results, feedback = run("photoviewshed", {**given, **outputs(folder), "WORKERS": count})
        assert any("2 processes" in text for text in feedback.infos) == (count == 2)
        assert results["COUNT"] == 4 and results["VIEWSHEDS"] == 3
        seen = {"INPUT": str(folder / "points.gpkg"), "DEM": str(scene.dem), "MAX_DISTANCE": 6000, "WORKERS": count}
        run("directedviewshed", {**seen, "OUTPUT": str(folder / "d.tif"), "POLYGONS": str(folder / "d.gpkg")})
    one, two = tmp_path / "1", tmp_path / "2"
    for name in ("points.gpkg", "ground.gpkg", "d.gpkg"):
        assert attributes(one / name) == attributes(two / name)
    for name in ("seen.tif", "d.tif"):
        np.testing.assert_array_equal(cells(one / name), cells(two / name))
    reports = [(folder / "report.html").read_text(encoding="utf-8") for folder in (one, two)]
    reports = [SETTING.sub("", CREATED.sub("", text)) for text in reports]
    assert len(reports[0]) > 100_000 and reports[0] == reports[1]


def test_extractskyline_gives_the_same_with_two_processes(run, scene, photos, tmp_path):
    run("importphotos", {"FOLDER": str(photos), "OUTPUT": str(tmp_path / "photos.gpkg")})
    for count in (1, 2):
        given = {"INPUT": str(tmp_path / "photos.gpkg"), "OUTPUT": str(tmp_path / f"{count}.gpkg"), "WORKERS": count}
        results, _ = run("extractskyline", {**given, "OVERLAYS": str(tmp_path / f"o{count}")})
        assert results["COUNT"] == 3
    assert attributes(tmp_path / "1.gpkg") == attributes(tmp_path / "2.gpkg")
    for picture in (tmp_path / "o1").iterdir():
        assert picture.read_bytes() == (tmp_path / "o2" / picture.name).read_bytes()


def test_a_joint_run_tells_the_final_verdicts_and_keeps_given_headings(run, scene, photos, tmp_path, monkeypatch):
    """Two photographs are ambiguous alone; one of them is tied to the one that has a heading from its field."""
    turn = Tie(0, 1, axes_of(Pose(220.0)) @ axes_of(Pose(0.0)).T, 0.4)
    monkeypatch.setattr(many, "OrientJob", worker_jobs.Hinted)
    monkeypatch.setattr(many, "ties_between", lambda photos, progress: [turn])
    run("importphotos", {"FOLDER": str(photos), "OUTPUT": str(tmp_path / "photos.gpkg")})
    layer = QgsVectorLayer(str(tmp_path / "photos.gpkg"), "photos", "ogr")
    names = [feature["filename"] for feature in layer.getFeatures()]
    with edit(layer):
        layer.addAttribute(QgsField("hint", QVariant.Double))
        layer.updateFields()
        second = list(layer.getFeatures())[1]
        layer.changeAttributeValue(second.id(), layer.fields().lookupField("hint"), 250.0)
    given = {"INPUT": str(tmp_path / "photos.gpkg"), "DEM": str(scene.dem), "HEADING_HINT_FIELD": "hint", "JOINT": True}
    results, feedback = run("orientphotos", {**given, "OUTPUT": str(tmp_path / "o.gpkg"), "WORKERS": 1})
    rows = {row["filename"]: row for row in rows_of(tmp_path / "o.gpkg")}
    assert [rows[name]["heading"] for name in names[:3]] == pytest.approx([30.0, 250.0, 200.0], abs=0.3)
    assert results["ACCEPTED"] == 2
    assert "1 photos gained from their neighbours." in feedback.infos
    assert f"{names[0]}.jpg: accepted, heading 30.0°" in feedback.infos
    checked = [text for text in feedback.infos if text.startswith("Check these photos")]
    assert len(checked) == 1 and names[0] not in re.split(r"[ ,.]+", checked[0]) and names[2] in checked[0]


def test_a_worker_that_dies_costs_its_photo_and_not_the_run(run, scene, photos, tmp_path, monkeypatch):
    monkeypatch.setattr(many, "OrientJob", worker_jobs.Deadly)
    folder = tmp_path / "photos"
    shutil.copytree(photos, folder)
    shutil.copy(folder / "west.jpg", folder / "deadly.jpg")
    given = {"FOLDER": str(folder), "DEM": str(scene.dem), "MAX_DISTANCE": 6000, "WORKERS": 2}
    results, feedback = run("photoviewshed", {**given, **outputs(tmp_path / "out")})
    rows = {Path(row["photo"]).stem: row for row in rows_of(tmp_path / "out" / "points.gpkg")}
    assert list(rows) == ["deadly", "m_no_gps", "north", "north2", "west"]
    assert rows["deadly"]["status"] == "failed" and "ended unexpectedly" in rows["deadly"]["message"]
    assert [rows[name]["status"] for name in ("north", "north2", "west")] == ["accepted"] * 3
    assert any("deadly.jpg" in text and "ended unexpectedly" in text for text in feedback.warnings)


def test_without_a_python_one_process_does_the_work_and_says_so(run, scene, photos, tmp_path, monkeypatch):
    monkeypatch.setattr(pools, "interpreters", lambda: [])
    run("importphotos", {"FOLDER": str(photos), "OUTPUT": str(tmp_path / "photos.gpkg")})
    given = {"INPUT": str(tmp_path / "photos.gpkg"), "OUTPUT": str(tmp_path / "lines.gpkg"), "WORKERS": 3}
    results, feedback = run("extractskyline", given)
    assert results["COUNT"] == 3 and any("No worker processes" in text for text in feedback.warnings)


def test_cancelling_with_workers_ends_within_two_seconds(provider, scene, photos, tmp_path, monkeypatch):
    from qgis.core import QgsProcessingContext, QgsProcessingFeedback
    from skyline_viewshed.algorithms.photo_viewshed import PhotoViewshed

    class Feedback(QgsProcessingFeedback):
        at = None

        def setProgressText(self, text):
            if "(1/4)" in text:
                self.cancel()
                Feedback.at = time.monotonic()

    algorithm = PhotoViewshed()
    algorithm.initAlgorithm()
    given = {"FOLDER": str(photos), "DEM": str(scene.dem), "WORKERS": 4, **outputs(tmp_path / "out")}
    context = QgsProcessingContext()
    algorithm.prepare(given, context, Feedback())
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        algorithm.processAlgorithm(given, context, Feedback())
    assert time.monotonic() - Feedback.at < 2.0
    assert list((tmp_path / "out").iterdir()) == []


def workers_of(pid):
    """Ids of the worker processes that belong to a process."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # the process has ended meanwhile
            parent = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
            if parent == pid and b"worker.serve" in (folder / "cmdline").read_bytes():
                found.append(int(folder.name))
    return found


def test_a_killed_run_with_four_workers_leaves_no_process_and_a_repeat_finishes(
    qgis_process, shell_environment, scene, photos, tmp_path
):
    kept = tmp_path / "kept"
    given = {"FOLDER": photos, "DEM": scene.dem, "MAX_DISTANCE": 6000, "WORKERS": 4, "ORIENTATIONS": kept,
             **outputs(tmp_path / "out")}  # fmt: skip
    command = ["run", "skylineviewshed:photoviewshed", "--", *(f"{name}={value}" for name, value in given.items())]
    for moment, kind in ((b"(2/4)", signal.SIGKILL), (b"(3/4)", signal.SIGINT)):
        process = subprocess.Popen(
            ["qgis_process", *command], env=shell_environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL, preexec_fn=as_from_a_terminal,
        )  # fmt: skip
        next(line for line in iter(process.stdout.readline, b"") if moment in line)
        workers = workers_of(process.pid)
        process.send_signal(kind)
        process.communicate(timeout=120)
        assert workers or kind is signal.SIGINT, "what is left may need no worker"
        deadline = time.monotonic() + 2
        while time.monotonic() < deadline and any(map(is_alive, workers)):
            time.sleep(0.05)
        assert not any(map(is_alive, workers))
        for path in kept.glob("*.npz"):
            with np.load(path) as archive:
                assert [archive[name] for name in archive.files], path
    done = qgis_process(*command)
    assert done.returncode == 0, done.stderr
    assert len(rows_of(tmp_path / "out" / "points.gpkg")) == 4 and (tmp_path / "out" / "report.html").exists()


def is_alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False
