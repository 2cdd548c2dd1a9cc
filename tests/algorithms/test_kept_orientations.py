"""Orientations that a run keeps in a folder: a repeat finds the same without computing, and notices every change."""

from __future__ import annotations

import os
import re
import shutil

import pytest
from qgis.core import QgsProcessingException, QgsVectorLayer
from skyline_viewshed.core import batch
from skyline_viewshed.core.base.errors import Cancelled

pytestmark = pytest.mark.qgis

CREATED = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d")
"""When a report was written: all that tells two reports of the same apart."""


@pytest.fixture(scope="module")
def first(provider, scene, tmp_path_factory):
    """A finished run over both photographs and one without a position: its folder, parameters and results."""
    import processing

    out = tmp_path_factory.mktemp("first")
    shutil.copytree(scene.folder, out / "photos")
    shutil.copy(scene.odd / "no_gps.jpg", out / "photos" / "no_gps.jpg")
    given = {"FOLDER": str(out / "photos"), "DEM": str(scene.dem), "MAX_DISTANCE": 6000, "OWN_SKYLINE": True}
    given["ORIENTATIONS"] = str(out / "kept")
    return out, given, processing.run("skylineviewshed:photoviewshed", {**given, **outputs_in(out)})


def outputs_in(folder):
    return {
        "OUTPUT": str(folder / "points.gpkg"),
        "POLYGONS": str(folder / "ground.gpkg"),
        "VIEWSHED": str(folder / "viewshed.tif"),
        "REPORT": str(folder / "report.html"),
    }


@pytest.fixture
def again(first, run, tmp_path):
    """Run once more on a copy of what the first run has kept, with changes; gives (results, feedback)."""

    def call(**changes):
        kept = tmp_path / "kept"
        if not kept.exists():
            shutil.copytree(first[0] / "kept", kept)
        given = {**first[1], **outputs_in(tmp_path), "ORIENTATIONS": str(kept), **changes}
        return run("photoviewshed", given)

    return call


@pytest.fixture
def solved(monkeypatch):
    """Names of the photographs that are oriented from here on, in their order."""
    names, orient = [], batch.orient_request

    def counted(request, *others):
        names.append(os.path.basename(request.path))
        return orient(request, *others)

    monkeypatch.setattr(batch, "orient_request", counted)
    return names


def rows_of(path):
    """Geometry and fields of every feature; the path of a picture, which counts from the layer's folder, as a whole."""
    layer = QgsVectorLayer(str(path), "rows", "ogr")
    columns = [field.name() for field in layer.fields() if field.name() != "fid"]
    rows = []
    for feature in layer.getFeatures():
        values = {name: feature[name] for name in columns}
        if "preview" in values:
            values["preview"] = os.path.normpath(path.parent / values["preview"])
            assert os.path.isfile(values["preview"])
        rows.append((feature.geometry().asWkt(9), values))
    return rows


def test_one_file_per_photo_that_has_an_answer(first):
    out, given, results = first
    assert sorted(path.name for path in (out / "kept").iterdir()) == ["north.npz", "west.npz"]
    assert results["ORIENTATIONS"] == given["ORIENTATIONS"]
    assert all(path.stat().st_size < 4_000_000 for path in (out / "kept").iterdir())


def test_a_repeat_computes_no_orientation_and_gives_the_same_to_the_last_digit(first, again, solved, tmp_path):
    results, feedback = again()
    assert solved == ["no_gps.jpg"], "a failure is found anew: its cause may be gone"
    assert sum("taken from" in info for info in feedback.infos) == 2
    for name in ("points.gpkg", "ground.gpkg"):
        assert rows_of(first[0] / name) == rows_of(tmp_path / name)
    for name in ("COUNT", "ACCEPTED", "VIEWSHEDS"):
        assert results[name] == first[2][name]
    reports = [(folder / "report.html").read_text(encoding="utf-8") for folder in (first[0], tmp_path)]
    assert len(reports[0]) > 100_000 and CREATED.sub("", reports[0]) == CREATED.sub("", reports[1])


def test_a_run_that_was_stopped_goes_on_where_it_was(first, again, run, monkeypatch, tmp_path):
    orient, names = batch.orient_request, []

    def stopped(request, *others):
        names.append(os.path.basename(request.path))
        if len(names) == 3:
            raise Cancelled
        return orient(request, *others)

    (tmp_path / "kept").mkdir()
    monkeypatch.setattr(batch, "orient_request", stopped)
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        again()
    assert not (tmp_path / "points.gpkg").exists()
    again()
    assert names == ["no_gps.jpg", "north.jpg", "west.jpg", "no_gps.jpg", "west.jpg"]
    assert rows_of(first[0] / "points.gpkg") == rows_of(tmp_path / "points.gpkg")


@pytest.mark.parametrize(
    "change",
    [{"COMPASS": 1}, {"HORIZON_DISTANCE": 20_000.0}, {"EYE_HEIGHT": 4.0}, {"USE_ALTITUDE": True}, {"METHOD": 1}],
)
def test_other_settings_orient_anew(again, solved, change):
    again(**change)
    assert solved == ["no_gps.jpg", "north.jpg", "west.jpg"]
    del solved[:]
    again(**change)
    assert solved == ["no_gps.jpg"]


def test_settings_of_the_viewshed_alone_do_not(again, solved):
    again(MAX_DISTANCE=3000, SECTOR=1, TARGET_HEIGHT=10.0)
    assert solved == ["no_gps.jpg"]


def test_only_a_changed_photo_is_oriented_anew(first, again, solved):
    path = os.path.join(first[1]["FOLDER"], "west.jpg")
    state = os.stat(path)
    os.utime(path, ns=(1, 1))
    try:
        again()
    finally:
        os.utime(path, ns=(state.st_atime_ns, state.st_mtime_ns))
    assert solved == ["no_gps.jpg", "west.jpg"]


def test_a_damaged_file_is_written_anew(first, again, solved, tmp_path):
    shutil.copytree(first[0] / "kept", tmp_path / "kept")
    whole = (tmp_path / "kept" / "north.npz").read_bytes()
    (tmp_path / "kept" / "north.npz").write_bytes(whole[: len(whole) // 2])
    again()
    assert solved == ["no_gps.jpg", "north.jpg"] and (tmp_path / "kept" / "north.npz").read_bytes() == whole


def test_a_folder_that_cannot_be_written_ends_the_run_in_words(again, tmp_path):
    (tmp_path / "file").write_text("no folder")
    with pytest.raises(QgsProcessingException, match=re.escape(str(tmp_path / "file"))):
        again(ORIENTATIONS=str(tmp_path / "file" / "kept"))
    assert not (tmp_path / "points.gpkg").exists()


def test_orienting_points_keeps_them_too(first, run, solved, tmp_path):
    run("importphotos", {"FOLDER": first[1]["FOLDER"], "OUTPUT": str(tmp_path / "photos.gpkg")})
    given = {"INPUT": str(tmp_path / "photos.gpkg"), "DEM": first[1]["DEM"], "ORIENTATIONS": str(tmp_path / "kept")}
    for name in ("one", "two"):
        results, _ = run("orientphotos", {**given, "OUTPUT": str(tmp_path / f"{name}.gpkg")})
        assert results["ORIENTATIONS"] == given["ORIENTATIONS"] and results["ACCEPTED"] == 2
    assert solved == ["north.jpg", "west.jpg"]
    assert rows_of(tmp_path / "one.gpkg") == rows_of(tmp_path / "two.gpkg")
