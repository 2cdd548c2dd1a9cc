"""A run that uses the compass tests it on a sample first."""

from __future__ import annotations

import pytest
from misled import CAMERA, misled_photos

TESTED = "4 photos are oriented first to test the compasses of the cameras."


@pytest.fixture
def misled_layer(run, scene, tmp_path):
    """Points of four photographs whose compass is lost."""
    folder = tmp_path / "misled"
    misled_photos(scene, folder)
    return run("importphotos", {"FOLDER": str(folder), "OUTPUT": "memory:"})[0]["OUTPUT"]


def times(folder):
    return {path: path.stat().st_mtime_ns for path in folder.iterdir()}


def test_a_lost_compass_is_told_of_and_does_not_mislead(run, scene, misled_layer, tmp_path):
    given = {"INPUT": misled_layer, "DEM": str(scene.dem), "COMPASS": 1, "OUTPUT": "memory:", "WORKERS": 1}
    results, feedback = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert TESTED in feedback.infos
    assert any(CAMERA in text and "treated as worthless" in text for text in feedback.warnings)
    photos = sorted(results["OUTPUT"].getFeatures(), key=lambda photo: photo["photo"])
    for photo, name in zip(photos, ("north", "west") * 2):
        assert photo["heading"] == pytest.approx(scene.truth[name].heading_deg % 360, abs=0.5)
        assert "counts for less" in photo["message"]
    files = times(tmp_path / "kept")
    assert sorted(path.suffix for path in files) == [".json", *[".npz"] * 4]
    again, told = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert [p["heading"] for p in again["OUTPUT"].getFeatures()] == [
        p["heading"] for p in results["OUTPUT"].getFeatures()
    ]
    assert TESTED not in told.infos and sum("taken from" in text for text in told.infos) == 4
    assert any(CAMERA in text for text in told.warnings)
    assert times(tmp_path / "kept") == files


def test_a_sound_compass_orients_each_photograph_once(run, scene, tmp_path):
    folder = tmp_path / "sound"
    misled_photos(scene, folder, (2.0, -3.0, 4.0, 0.0))
    layer = run("importphotos", {"FOLDER": str(folder), "OUTPUT": "memory:"})[0]["OUTPUT"]
    given = {"INPUT": layer, "DEM": str(scene.dem), "COMPASS": 1, "OUTPUT": "memory:", "WORKERS": 1}
    results, feedback = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert TESTED in feedback.infos and not feedback.warnings
    assert results["COUNT"] == results["ACCEPTED"] == 4
    files = times(tmp_path / "kept")
    assert sorted(path.suffix for path in files) == [".json", *[".npz"] * 4]
    _, told = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert TESTED not in told.infos and sum("taken from" in text for text in told.infos) == 4
    assert times(tmp_path / "kept") == files


def test_no_compass_is_tested_without_the_compass(run, scene, misled_layer):
    given = {"INPUT": misled_layer, "DEM": str(scene.dem), "OUTPUT": "memory:", "MAX_DISTANCE": 8000, "WORKERS": 1}
    assert TESTED not in run("orientphotos", given)[1].infos


def test_a_run_that_is_cancelled_during_the_test_says_so(run, scene, misled_layer, listener):
    told = listener()
    told.setProgressText = lambda text: told.cancel()
    given = {"INPUT": misled_layer, "DEM": str(scene.dem), "COMPASS": 1, "OUTPUT": "memory:", "WORKERS": 1}
    with pytest.raises(Exception, match="ancel"):
        run("orientphotos", given, told)
    assert any("Cancelled after 0 of 4 photos" in text for text in told.warnings)
