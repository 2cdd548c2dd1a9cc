"""The command line: real runs on simulated photographs, exit codes, faults, Ctrl+C."""

from __future__ import annotations

import csv
import io
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import skyline_viewshed
from skyline_viewshed.core import batch, cli
from skyline_viewshed.core.base.angles import difference

ROOT = Path(__file__).resolve().parent.parent.parent
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT / "build" / "plugins")}


@pytest.fixture(scope="module")
def run(scene, tmp_path_factory):
    """A whole run on two good photographs and one unreadable one."""
    folder = tmp_path_factory.mktemp("run")
    command = [sys.executable, "-m", "skyline_viewshed", "orient", scene.folder, scene.odd / "damaged.jpg", scene.dem]
    command += [
        "-o",
        folder / "photos.gpkg",
        "--report",
        folder / "report.html",
        "--viewsheds",
        folder / "seen" / "deep",
    ]
    done = subprocess.run(command, env=ENVIRONMENT, cwd=folder, capture_output=True, text=True, timeout=300)
    return folder, done


def test_a_run_writes_points_report_and_viewsheds(scene, run):
    ogr = pytest.importorskip("osgeo.ogr")
    gdal = pytest.importorskip("osgeo.gdal")
    folder, done = run
    source = ogr.Open(str(folder / "photos.gpkg"))
    rows = {row["filename"]: row for row in (feature.items() for feature in source.GetLayer(0))}
    assert sorted(rows) == ["damaged", "north", "west"]
    for name, pose in scene.truth.items():
        assert rows[name]["status"] == "accepted"
        assert abs(difference(rows[name]["heading"], pose.heading_deg)) < 0.5
        values = gdal.Open(str(folder / "seen" / "deep" / f"{name}.tif")).ReadAsArray()
        assert (values == 1).any() and (values == 0).any()
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert "north.jpg" in page and "damaged.jpg" in page and "dem.tif" in page
    assert sorted(path.name for path in folder.iterdir()) == ["photos.gpkg", "report.html", "seen"]
    assert sorted(path.name for path in (folder / "seen" / "deep").iterdir()) == ["north.tif", "west.tif"]


def test_an_unreadable_photo_is_said_in_one_sentence_and_the_exit_code(run):
    _, done = run
    assert done.returncode == cli.SOME_FAILED
    lines = done.stderr.splitlines()
    assert [line for line in lines if line.startswith("skyline-viewshed: damaged.jpg: The photo ")]
    assert lines[-1].startswith("3 photos: 2 accepted, 1 failed. Written to ")
    assert "Traceback" not in done.stderr and "\r" not in done.stderr and done.stdout == ""


def test_the_fields_are_those_of_the_algorithm(run):
    qgis = pytest.importorskip("qgis.core")
    from skyline_viewshed.algorithms.shared.fields import joined_fields, photo_specs, qgis_fields
    from skyline_viewshed.algorithms.shared.oriented import oriented_specs

    wanted, _ = joined_fields(qgis_fields(photo_specs()), oriented_specs())
    layer = qgis.QgsVectorLayer(str(run[0] / "photos.gpkg"), "photos", "ogr")
    assert [field.name() for field in layer.fields()][1:] == [field.name() for field in wanted]  # the first is fid
    assert [field.typeName() for field in layer.fields()][1:5] == ["String", "String", "String", "Real"]
    assert layer.crs().authid() == "EPSG:4326" and layer.featureCount() == 3


def test_all_is_well_and_quiet(scene, tmp_path, capsys):
    arguments = [
        "orient",
        str(scene.folder / "north.jpg"),
        str(scene.dem),
        "-o",
        str(tmp_path / "p.geojson"),
        "--quiet",
    ]
    assert cli.main(arguments) == cli.ANSWERED
    assert capsys.readouterr() == ("", "")
    (feature,) = json.loads((tmp_path / "p.geojson").read_text(encoding="utf-8"))["features"]
    assert feature["geometry"]["coordinates"][:2] == pytest.approx(scene.positions["north"], abs=1e-6)
    assert abs(difference(feature["properties"]["heading"], scene.truth["north"].heading_deg)) < 0.5


def test_options_reach_the_core(scene, tmp_path, capsys):
    longitude, latitude = scene.positions["west"]
    out = tmp_path / "p.csv"
    arguments = ["orient", str(scene.odd / "no_gps.jpg"), str(scene.dem), "-o", str(out), "--max-distance", "30000"]
    assert cli.main(arguments) == cli.SOME_FAILED
    assert "Give it by --position." in capsys.readouterr().err
    place = ["--position", str(longitude), str(latitude), "--hfov", str(scene.hfov_deg), "--compass", "prior"]
    assert cli.main([*arguments, *place]) == cli.ANSWERED
    with open(out, newline="", encoding="utf-8") as table:
        (row,) = csv.DictReader(table)
    assert abs(difference(float(row["heading"]), scene.truth["west"].heading_deg)) < 0.5
    assert float(row["radius"]) == 30_000
    assert cli.main([*arguments, *place, "--method", "paper"]) == cli.ANSWERED
    with open(out, newline="", encoding="utf-8") as table:
        (row,) = csv.DictReader(table)
    assert row["p_correct"] == ""


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"dem": "missing.tif"}, "does not exist"),
        ({"dem": __file__}, "is not a raster that GDAL can read"),
        ({"band": "7"}, "no band 7"),
        ({"photos": "empty"}, "no photograph"),
        ({"out": "nowhere/p.gpkg"}, "does not exist or is read-only"),
        ({"out": "p.shp"}, "must end in one of"),
        ({"report": "nowhere/r.html"}, "does not exist or is read-only"),
        ({"max_distance": "-1"}, "must be positive"),
    ],
)
def test_what_cannot_work_ends_with_2_and_one_sentence(scene, tmp_path, capsys, monkeypatch, change, words):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    given = {"photos": str(scene.folder), "dem": str(scene.dem), "out": "p.gpkg", "band": "1", "report": "r.html"}
    given.update({"max_distance": "1e5", **change})
    arguments = ["orient", given["photos"], given["dem"], "-o", given["out"], "--band", given["band"]]
    arguments += ["--report", given["report"], "--max-distance", given["max_distance"]]
    assert cli.main(arguments) == cli.WRONG_USAGE
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1 and said[0].startswith("skyline-viewshed: ") and words in said[0]
    assert [path.name for path in tmp_path.iterdir()] == ["empty"]


@pytest.mark.parametrize("arguments", [[], ["orient", "a.jpg", "-o", "p.csv"], ["orient", "a", "b", "--method", "x"]])
def test_wrong_arguments_are_refused(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        cli.main(arguments)
    assert ended.value.code == 2
    assert "usage: skyline-viewshed" in capsys.readouterr().err


def test_help_has_examples_and_the_version_is_that_of_the_plugin(capsys):
    for arguments in (["--help"], ["orient", "--help"]):
        with pytest.raises(SystemExit) as ended:
            cli.main(arguments)
        assert ended.value.code == 0
        text = capsys.readouterr().out
        assert "skyline-viewshed orient photos/ dem.tif -o photos.gpkg" in text and "exit codes" in text
    with pytest.raises(SystemExit):
        cli.main(["--version"])
    assert capsys.readouterr().out == f"skyline-viewshed {skyline_viewshed.__version__}\n"


def test_every_example_of_the_help_is_understood():
    lines = [line.split()[1:] for line in cli.EXAMPLES.splitlines() if line.startswith("  skyline-viewshed ")]
    assert len(lines) >= 4
    for line in lines:
        assert callable(cli._parser().parse_args(line).run)


@pytest.mark.parametrize("delay_s", [0.4, 2.5])
def test_ctrl_c_leaves_nothing_half_written(scene, tmp_path, delay_s):
    """Once while the program still loads or starts, once in the middle of the work."""
    command = [sys.executable, "-m", "skyline_viewshed", "orient", *[scene.folder] * 8, scene.dem]
    command += ["-o", tmp_path / "p.gpkg", "--report", tmp_path / "r.html", "--viewsheds", tmp_path / "seen"]
    child = subprocess.Popen(command, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True)
    time.sleep(delay_s)
    child.send_signal(signal.SIGINT)
    _, said = child.communicate(timeout=60)
    if delay_s > 1:
        assert child.returncode == cli.INTERRUPTED, said
        assert "interrupted" in said and "Traceback" not in said
    assert child.returncode != 0
    left = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert all(path.parent.name == "seen" and path.suffix == ".tif" for path in left), left


def test_horizon_and_viewshed_of_a_place(scene, tmp_path, capsys):
    gdal = pytest.importorskip("osgeo.gdal")
    place = [str(scene.dem), *map(str, scene.positions["north"])]
    assert cli.main(["horizon", *place, "--max-distance", "20000", "-q"]) == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert len(rows) == 3600 and float(rows[900]["azimuth_deg"]) == 90.0
    assert cli.main(["horizon", *place, "--max-distance", "20000", "-o", str(tmp_path / "h.csv")]) == 0
    assert list(csv.DictReader((tmp_path / "h.csv").read_text(encoding="utf-8").splitlines())) == rows
    whole, part = str(tmp_path / "whole.tif"), str(tmp_path / "part.tif")
    assert cli.main(["viewshed", *place, "-o", whole, "--max-distance", "8000"]) == 0
    assert "seen" in capsys.readouterr().err
    assert cli.main(["viewshed", *place, "-o", part, "--max-distance", "8000", "--heading", "20", "--hfov", "40"]) == 0
    seen = [(gdal.Open(path).ReadAsArray() == 1).sum() for path in (whole, part)]
    assert seen[0] > seen[1] > 0
    assert cli.main(["horizon", str(scene.dem), "0", "0"]) == cli.WRONG_USAGE
    assert "lies outside the DEM" in capsys.readouterr().err


def test_an_unexpected_error_is_a_sentence_and_its_details_go_to_the_log(scene, tmp_path, capsys, monkeypatch):
    def faulty(*arguments):
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(batch, "orient_request", faulty)
    arguments = ["orient", str(scene.folder / "north.jpg"), str(scene.dem), "-o", str(tmp_path / "p.csv")]
    assert cli.main([*arguments, "--log", str(tmp_path / "log.txt")]) == cli.SOME_FAILED
    said = capsys.readouterr().err
    assert "north.jpg: An unexpected error occurred on this photo." in said and "Traceback" not in said
    assert "ZeroDivisionError: by zero" in (tmp_path / "log.txt").read_text(encoding="utf-8")
    assert "ZeroDivisionError: by zero" in (tmp_path / "p.csv").read_text(encoding="utf-8")
    assert cli.main([*arguments, "--log", str(tmp_path / "nowhere" / "log.txt")]) == cli.WRONG_USAGE
