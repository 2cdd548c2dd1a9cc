"""Headings for other programs: sidecars beside the photos, KMZ and table; the originals stay as they are."""

from __future__ import annotations

import csv
import errno
import hashlib
import json
import shutil
import zipfile
from pathlib import Path

import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsProcessingException, QgsVectorLayer

pytestmark = pytest.mark.qgis

FIELDS = "&".join(
    ["field=photo:string", "field=status:string"]
    + [f"field={name}:double" for name in ("heading", "pitch", "roll", "hfov", "vfov", "eye_z")]
)


@pytest.fixture
def trip(scene, tmp_path):
    """Two folders with a photo of the same name each, and their oriented points."""
    layer = QgsVectorLayer(f"Point?crs=EPSG:4326&{FIELDS}", "oriented", "memory")
    for day, name, status in (("1", "north", "accepted"), ("2", "west", "ambiguous")):
        (tmp_path / "photos" / day).mkdir(parents=True)
        path = tmp_path / "photos" / day / "IMG_1.jpg"
        shutil.copy(scene.folder / f"{name}.jpg", path)
        longitude, latitude = scene.positions[name]
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(f"Point({longitude!r} {latitude!r})"))
        feature.setAttributes([str(path), status, scene.truth[name].heading_deg, 2.0, 0.5, scene.hfov_deg, 50.0, 900.0])
        layer.dataProvider().addFeature(feature)
    return layer, tmp_path / "photos"


def contents(folder):
    return {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.rglob("*.jpg")}


def test_sidecars_lie_beside_their_photos_which_stay_untouched(run, trip):
    layer, folder = trip
    before = contents(folder)
    results, feedback = run("exportheadings", {"INPUT": layer, "SIDECARS": str(folder), "DOUBTFUL": True})
    assert results["COUNT"] == 2 and contents(folder) == before
    sidecars = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.xmp"))
    assert sidecars == ["1/IMG_1.jpg.xmp", "2/IMG_1.jpg.xmp"]
    assert 'GPSImgDirection="2000/100"' in (folder / sidecars[0]).read_text(encoding="utf-8")
    assert 'GPSImgDirection="20000/100"' in (folder / sidecars[1]).read_text(encoding="utf-8")
    assert feedback.warnings == []


def test_sidecars_of_other_programs_stay_and_ours_are_renewed(run, trip):
    layer, folder = trip
    foreign, ours = folder / "1" / "IMG_1.jpg.xmp", folder / "2" / "IMG_1.jpg.xmp"
    foreign.write_text("edited elsewhere")
    for _ in range(2):
        _, feedback = run("exportheadings", {"INPUT": layer, "SIDECARS": str(folder), "DOUBTFUL": True})
    assert foreign.read_text() == "edited elsewhere" and "Skyline Viewshed" in ours.read_text(encoding="utf-8")
    assert len(feedback.warnings) == 1 and "another program wrote" in feedback.warnings[0]


def test_doubtful_photos_are_left_out_by_name_unless_requested(run, trip, tmp_path):
    layer, _ = trip
    table = tmp_path / "headings.csv"
    results, feedback = run("exportheadings", {"INPUT": layer, "TABLE": str(table)})
    assert (results["COUNT"], results["LEFT_OUT"]) == (1, 1)
    assert feedback.warnings == ["IMG_1.jpg: left out, because its status is ambiguous."]
    with open(table, newline="", encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert (row["heading_deg"], row["pitch_deg"], row["elevation_m"]) == ("20.00", "2.00", "900.0")


def test_kmz_has_reduced_pictures_and_kml_points_to_the_originals(run, trip, tmp_path):
    layer, _ = trip
    run("exportheadings", {"INPUT": layer, "KML": str(tmp_path / "a.kmz"), "DOUBTFUL": True})
    with zipfile.ZipFile(tmp_path / "a.kmz") as archive:
        assert sorted(archive.namelist()) == ["doc.kml", "files/IMG_1.jpg", "files/IMG_1_2.jpg"]
        assert archive.read("doc.kml").count(b"<PhotoOverlay>") == 2
        assert archive.read("files/IMG_1.jpg")[:2] == b"\xff\xd8"
    run("exportheadings", {"INPUT": layer, "KML": str(tmp_path / "a.kml"), "DOUBTFUL": True})
    assert "<href>photos/1/IMG_1.jpg</href>" in (tmp_path / "a.kml").read_text(encoding="utf-8")


def test_a_full_disk_leaves_none_of_the_outputs(run, trip, tmp_path, monkeypatch):
    layer, folder = trip
    (tmp_path / "t.csv").write_text("older")
    write, written = Path.write_bytes, []

    def fill_up(path, data):
        written.append(path)
        if len(written) == 4:  # the table, the KML file and the first sidecar still find room
            raise OSError(errno.ENOSPC, "No space left on device")
        return write(path, data)

    monkeypatch.setattr(Path, "write_bytes", fill_up)
    outputs = {"TABLE": str(tmp_path / "t.csv"), "KML": str(tmp_path / "a.kml"), "SIDECARS": str(folder)}
    with pytest.raises(QgsProcessingException, match="2/IMG_1.jpg.xmp.*No space left"):
        run("exportheadings", {"INPUT": layer, "DOUBTFUL": True, **outputs})
    assert (tmp_path / "t.csv").read_text() == "older"
    left = sorted(path.name for path in tmp_path.rglob("*") if path.is_file())
    assert left == ["IMG_1.jpg", "IMG_1.jpg", "t.csv"]


def test_what_a_point_lacks_is_named(run, trip, tmp_path):
    layer, _ = trip
    layer.dataProvider().changeGeometryValues({1: QgsGeometry()})
    layer.dataProvider().changeAttributeValues({2: {0: None}})
    given = {"INPUT": layer, "DOUBTFUL": True, "TABLE": str(tmp_path / "t.csv"), "KML": str(tmp_path / "a.kml")}
    results, feedback = run("exportheadings", given)
    assert (results["COUNT"], results["LEFT_OUT"]) == (1, 1)
    assert "The point names no photo" in feedback.warnings[0]
    assert feedback.warnings[1:] == ["IMG_1.jpg: left out of the KML file, because its point has no position."]
    assert "PhotoOverlay" not in (tmp_path / "a.kml").read_text(encoding="utf-8")


def test_nothing_to_write_and_nothing_to_export_are_said(run, refusal, trip, tmp_path):
    layer, _ = trip
    assert "Choose at least one output" in refusal("exportheadings", {"INPUT": layer})
    layer.dataProvider().changeAttributeValues({1: {2: None}, 2: {2: None}})
    with pytest.raises(QgsProcessingException, match="Orient the photos first"):
        run("exportheadings", {"INPUT": layer, "TABLE": str(tmp_path / "t.csv")})
    assert not (tmp_path / "t.csv").exists()


def test_qgis_process_writes_all_three_and_answers_in_json(qgis_process, run, scene, tmp_path):
    run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(tmp_path / "p.gpkg")})
    outputs = [f"SIDECARS={tmp_path}/xmp", f"KML={tmp_path}/p.kmz", f"TABLE={tmp_path}/p.csv"]
    given = [f"INPUT={tmp_path}/p.gpkg", "HEADING_FIELD=direction", *outputs]
    done = qgis_process("--json", "run", "skylineviewshed:exportheadings", "--", *given)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["results"]["COUNT"] == 2
    assert sorted(path.name for path in (tmp_path / "xmp").iterdir()) == ["north.jpg.xmp", "west.jpg.xmp"]
