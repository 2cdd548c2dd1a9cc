import math
import os
import re
import subprocess
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from qgis.core import NULL, QgsFeatureRequest, QgsProcessingException, QgsVectorLayer, QgsWkbTypes
from whole_runs import rows_of

NATIVE_FIELDS = [
    "photo", "filename", "directory", "altitude", "direction", "rotation", "longitude", "latitude", "timestamp",
]  # fmt: skip
OUR_FIELDS = ["f35", "hfov", "vfov", "width", "height", "dir_ref", "h_acc", "camera"]

MANY = 10_000
BYTES_PER_PHOTO = 10_000
"""What the list of a folder may hold for each photograph."""


def features(results, name="OUTPUT"):
    layer = results[name]
    return {f["filename"]: f for f in layer.getFeatures(QgsFeatureRequest())}


def test_parameters_are_the_contract(algorithm):
    it = algorithm("importphotos")
    names = [definition.name() for definition in it.parameterDefinitions()]
    assert names == ["FOLDER", "RECURSIVE", "OUTPUT", "REJECTED"]


def test_settings_say_what_the_algorithm_is(algorithm):
    it = algorithm("importphotos")
    assert it.displayName() and it.shortHelpString() and it.shortDescription() and it.tags() and it.group()
    assert not it.parameterDefinition("REJECTED").createByDefault()
    assert not it.icon().isNull()


def test_fields_are_qgis_own_nine_and_then_ours(run, scene):
    results, _ = run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})
    layer = results["OUTPUT"]
    assert layer.fields().names() == NATIVE_FIELDS + OUR_FIELDS + ["preview"]
    assert layer.wkbType() == QgsWkbTypes.Type.PointZ
    assert layer.crs().authid() == "EPSG:4326"
    assert results["COUNT"] == 2


def test_values_are_those_of_the_files(run, scene):
    results, _ = run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})
    north = features(results)["north"]
    longitude, latitude = scene.positions["north"]
    assert north["photo"] == str(scene.folder / "north.jpg")
    assert float(north["longitude"]) == pytest.approx(longitude, abs=1e-7)
    assert north.geometry().constGet().y() == pytest.approx(latitude, abs=1e-7)
    assert north["direction"] == pytest.approx(26.0, abs=0.01)
    assert north["dir_ref"] == "T"
    assert north["f35"] == 28
    assert north["hfov"] == pytest.approx(scene.hfov_deg, abs=1e-6)
    assert (north["width"], north["height"]) == (800, 600)
    diagonal = 2 * math.degrees(math.atan(43.2666 / 2 / 28))
    assert math.hypot(math.tan(math.radians(north["hfov"] / 2)), math.tan(math.radians(north["vfov"] / 2))) == (
        pytest.approx(math.tan(math.radians(diagonal / 2)), rel=1e-4)
    )


def test_native_import_agrees_on_the_nine_fields(run, scene):
    import processing

    native = processing.run("native:importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})["OUTPUT"]
    ours, _ = run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})
    ours = features(ours)
    for theirs in native.getFeatures():
        mine = ours[theirs["filename"]]
        assert mine["photo"] == theirs["photo"] and mine["directory"] == theirs["directory"]
        assert mine["altitude"] == pytest.approx(theirs["altitude"], abs=0.01)
        assert mine["direction"] == pytest.approx(theirs["direction"], abs=0.01)
        assert float(mine["latitude"]) == pytest.approx(float(theirs["latitude"]), abs=1e-7)
        assert mine.geometry().asPoint().distance(theirs.geometry().asPoint()) < 1e-7


def test_unusable_files_go_to_the_rejected_with_a_reason(run, scene):
    results, feedback = run("importphotos", {"FOLDER": str(scene.odd), "OUTPUT": "memory:", "REJECTED": "memory:"})
    reasons = {f["filename"]: f["reason"] for f in results["REJECTED"].getFeatures()}
    assert set(reasons) == {"no_gps", "null_island", "empty"}
    assert "no GPS position" in reasons["no_gps"]
    assert "cannot be read" in reasons["empty"]
    assert results["REJECTED_COUNT"] == 3 and results["COUNT"] == 3
    assert any("empty.heic" in error for error in feedback.errors)
    assert features(results)["no_focal"].attribute("hfov") in (None, NULL)


@pytest.mark.parametrize(("content", "words"), [(None, "does not exist"), ([], "No photograph")])
def test_a_folder_without_photos_is_refused(run, tmp_path, content, words):
    folder = tmp_path / "folder"
    if content is not None:
        folder.mkdir()
        (folder / "notes.txt").write_text("no photo")
    with pytest.raises(QgsProcessingException, match=words):
        run("importphotos", {"FOLDER": str(folder), "OUTPUT": "memory:"})


def test_folders_below_are_read_on_request(run, scene):
    parameters = {"FOLDER": str(scene.folder.parent), "RECURSIVE": True, "OUTPUT": "memory:"}
    results, _ = run("importphotos", parameters)
    assert {"north", "west", "no_focal"} <= set(features(results))


def test_cancelling_leaves_no_layer(run, scene, listener, tmp_path):
    target = tmp_path / "photos.gpkg"
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(target)}, listener(cancel_at=30))
    assert not target.exists()


def test_output_is_readable_from_a_geopackage(run, scene, tmp_path):
    target = tmp_path / "new folder" / "photos ü.gpkg"
    results, _ = run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(target)})
    assert results["COUNT"] == 2
    assert QgsVectorLayer(str(target), "photos", "ogr").featureCount() == 2


def peak_bytes(environment, *arguments):
    """Run qgis_process; gives its exit code and the most memory that it held.

    Asked while it runs, for what wait4 tells is at least what pytest held when it made the process.
    """
    process = subprocess.Popen(
        ["qgis_process", *arguments],
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    peak = 0
    while process.poll() is None:
        with suppress(OSError):
            held = re.search(r"VmHWM:\s+(\d+) kB", Path(f"/proc/{process.pid}/status").read_text())
            peak = max(peak, int(held.group(1)) * 1024 if held else 0)
        time.sleep(0.02)
    return process.returncode, peak


def test_a_folder_of_ten_thousand_photographs_is_read_in_little_memory(qgis_process, shell_environment, tmp_path):
    from skyline_viewshed.core.base.model import PhotoMetadata
    from skyline_viewshed.core.io.write_photo import write_photo

    folder, few, output = tmp_path / "many", tmp_path / "few", tmp_path / "photos.gpkg"
    folder.mkdir()
    few.mkdir()
    first = folder / "00000.jpg"
    metadata = PhotoMetadata(str(first), 64, 48, latitude_deg=46.5, longitude_deg=8.0, focal_length_35mm=28.0)
    write_photo(str(first), np.zeros((48, 64, 3), np.uint8), metadata)
    for number in range(1, MANY):
        os.link(first, folder / f"{number:05d}.jpg")
    os.link(first, few / first.name)
    peaks = []
    for photos in (few, folder):
        arguments = ("run", "skylineviewshed:importphotos", "--", f"FOLDER={photos}", f"OUTPUT={output}")
        code, peak = peak_bytes(shell_environment, *arguments)
        assert code == 0, qgis_process(*arguments).stderr
        assert peak > 50 * 2**20, "QGIS alone takes as much"
        peaks.append(peak)
    assert len(rows_of(output)) == MANY
    assert peaks[1] - peaks[0] < MANY * BYTES_PER_PHOTO, peaks


def test_what_a_folder_holds_besides_photographs_is_said_by_kind_and_count(run, scene, tmp_path):
    import shutil

    shutil.copy(scene.folder / "north.jpg", tmp_path / "north.jpg")
    for name in ("a.dng", "b.dng", "notes"):
        (tmp_path / name).write_bytes(b"x")
    results, feedback = run("importphotos", {"FOLDER": str(tmp_path), "OUTPUT": "memory:"})
    assert results["COUNT"] == 1
    assert "Files that were not read as photographs: without suffix (1), .dng (2)" in feedback.infos
