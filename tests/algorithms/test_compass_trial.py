"""A run that uses the compass tries it on a sample first."""

from __future__ import annotations

import pytest
from misled import CAMERA, misled_photos

TRIED = "4 photos try the compass of each camera first."


@pytest.fixture
def misled_layer(run, scene, tmp_path):
    """Points of four photographs whose compass is lost."""
    folder = tmp_path / "misled"
    folder.mkdir()
    misled_photos(scene, folder)
    return run("importphotos", {"FOLDER": str(folder), "OUTPUT": "memory:"})[0]["OUTPUT"]


def test_a_lost_compass_is_told_of_and_does_not_mislead(run, scene, misled_layer, tmp_path):
    given = {"INPUT": misled_layer, "DEM": str(scene.dem), "COMPASS": 1, "OUTPUT": "memory:", "WORKERS": 1}
    results, feedback = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert TRIED in feedback.infos
    assert any(CAMERA in text and "contradicts the skylines" in text for text in feedback.warnings)
    photos = sorted(results["OUTPUT"].getFeatures(), key=lambda photo: photo["photo"])
    for photo, name in zip(photos, ("north", "west") * 2):
        assert photo["heading"] == pytest.approx(scene.truth[name].heading_deg % 360, abs=0.5)
        assert "counts for little" in photo["message"]
    again, told = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert [p["heading"] for p in again["OUTPUT"].getFeatures()] == [p["heading"] for p in results["OUTPUT"].getFeatures()]
    assert any(CAMERA in text for text in told.warnings)


def test_a_sound_compass_orients_each_photograph_once(run, scene, tmp_path):
    folder = tmp_path / "sound"
    folder.mkdir()
    misled_photos(scene, folder, (2.0, -3.0, 4.0, 0.0))
    layer = run("importphotos", {"FOLDER": str(folder), "OUTPUT": "memory:"})[0]["OUTPUT"]
    given = {"INPUT": layer, "DEM": str(scene.dem), "COMPASS": 1, "OUTPUT": "memory:", "WORKERS": 1}
    results, feedback = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert TRIED in feedback.infos and not feedback.warnings
    assert results["COUNT"] == results["ACCEPTED"] == 4
    files = {path: path.stat().st_mtime_ns for path in (tmp_path / "kept").iterdir()}
    assert len(files) == 4
    _, told = run("orientphotos", {**given, "ORIENTATIONS": str(tmp_path / "kept")})
    assert sum("taken from" in text for text in told.infos) == 4
    assert {path: path.stat().st_mtime_ns for path in (tmp_path / "kept").iterdir()} == files


def test_no_sample_is_tried_without_the_compass(run, scene, misled_layer):
    given = {"INPUT": misled_layer, "DEM": str(scene.dem), "OUTPUT": "memory:", "MAX_DISTANCE": 8000, "WORKERS": 1}
    assert TRIED not in run("orientphotos", given)[1].infos
