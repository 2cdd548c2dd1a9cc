"""The algorithms as the command line runs them, on real photographs; each photo is solved once."""

import csv
import json
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest
from osgeo import gdal, ogr
from rasters import make_tif

IDS = [
    "photoviewshed", "importphotos", "extractskyline", "horizonprofile", "orientphotos", "directedviewshed",
    "measureoffsets", "simulatephotos", "geotaggedphotos", "compassviewsheds", "viewshedlandcover",
]  # fmt: skip


def rows_of(path, layer=0):
    source = ogr.Open(str(path))
    return [feature.items() for feature in source.GetLayer(layer)]


def truth_of(folder):
    with open(folder / "truth.csv", newline="", encoding="utf-8") as file:
        return {row["photo"]: row for row in csv.DictReader(file)}


def error_deg(row, truth):
    return abs((row["heading"] - float(truth["heading_deg"]) + 180) % 360 - 180)


def test_a_plain_qgis_process_lists_all_algorithms(qgis_process):
    listed = qgis_process("list").stdout
    for name in IDS:
        assert f"skylineviewshed:{name}" in listed


@pytest.fixture(scope="module")
def khumbu(qgis_process, shared_data, tmp_path_factory):
    out = tmp_path_factory.mktemp("khumbu")
    done = qgis_process(
        "run",
        "skylineviewshed:photoviewshed",
        "--",
        f"FOLDER={shared_data / 'khumbu' / 'photos'}",
        f"DEM={shared_data / 'khumbu' / 'dem' / 'khumbu.tif'}",
        f"OUTPUT={out / 'points.gpkg'}",
        f"POLYGONS={out / 'polygons.gpkg'}",
        f"VIEWSHED={out / 'viewshed.tif'}",
        f"REPORT={out / 'report.html'}",
    )
    assert done.returncode == 0, done.stderr
    return out, done


@pytest.mark.data
def test_all_twelve_khumbu_photos_come_out(khumbu, shared_data):
    out, _ = khumbu
    truth = truth_of(shared_data / "khumbu")
    found = {row["filename"] + ".HEIC": row for row in rows_of(out / "points.gpkg")}
    assert set(found) == set(truth) and len(found) == 12
    good = [name for name, row in truth.items() if row["group"] == "good"]
    right = [name for name in good if found[name]["heading"] is not None and error_deg(found[name], truth[name]) < 1.0]
    # Seven of eight is what a machine of other rounding may cost; the accuracy benchmark asks for eight.
    assert len(right) >= 7, {name: found[name]["heading"] for name in good}
    for name, row in found.items():
        if row["status"] == "accepted" and truth[name]["heading_deg"]:
            assert error_deg(row, truth[name]) < 3.0, name


@pytest.mark.data
def test_the_photo_outside_the_dem_gets_its_message(khumbu, shared_data):
    out, done = khumbu
    outside = [name for name, row in truth_of(shared_data / "khumbu").items() if row["group"] == "outside-dem"]
    found = {row["filename"] + ".HEIC": row for row in rows_of(out / "points.gpkg")}
    assert [found[name]["status"] for name in outside] == ["failed"]
    assert "outside the DEM" in found[outside[0]]["message"]
    assert outside[0] in done.stdout + done.stderr


@pytest.mark.data
def test_khumbu_viewshed_polygons_and_report_agree(khumbu):
    out, _ = khumbu
    accepted = [row for row in rows_of(out / "points.gpkg") if row["status"] == "accepted"]
    polygons = rows_of(out / "polygons.gpkg")
    assert sorted(row["photo"] for row in polygons) == sorted(row["photo"] for row in accepted)
    seen = gdal.Open(str(out / "viewshed.tif")).ReadAsArray()
    assert seen.shape == (648, 648) and 1 <= seen[seen < 65535].max() <= len(accepted)
    assert all(row["area_m2"] > 1e5 and 500 < row["farthest_m"] <= 30_100 for row in polygons)
    report = (out / "report.html").read_text(encoding="utf-8")
    assert all(row["filename"] in report for row in accepted)


def geojson(path, features):
    """Write points: [(lon, lat, properties)]."""
    collection = {
        "type": "FeatureCollection",
        "features": [
            {"type": "Feature", "geometry": {"type": "Point", "coordinates": [lon, lat]}, "properties": properties}
            for lon, lat, properties in features
        ],
    }
    path.write_text(json.dumps(collection))
    return path


@pytest.fixture(scope="module")
def columbia(qgis_process, shared_data, tmp_path_factory):
    out, folder = tmp_path_factory.mktemp("columbia"), shared_data / "columbia"
    points = [
        (
            float(row["longitude_deg"]),
            float(row["latitude_deg"]),
            {"photo": str(folder / "photos" / name), "eye": float(row["height_orthometric_m"])},
        )
        for name, row in truth_of(folder).items()
    ]
    done = qgis_process(
        "run",
        "skylineviewshed:orientphotos",
        "--",
        f"INPUT={geojson(out / 'stations.geojson', points)}",
        f"DEM={folder / 'dem' / 'columbia.tif'}",
        "HEIGHT_FIELD=eye",
        f"OUTPUT={out / 'oriented.gpkg'}",
        f"REPORT={out / 'report.html'}",
    )
    assert done.returncode == 0, done.stderr
    return out


@pytest.mark.data
def test_columbia_photos_without_gps_take_the_points_position(columbia, shared_data):
    truth = truth_of(shared_data / "columbia")
    found = {row["photo"].rsplit("/", 1)[-1]: row for row in rows_of(columbia / "oriented.gpkg")}
    assert set(found) == set(truth)
    good = [name for name, row in truth.items() if row["group"] == "good"]
    right = [name for name in good if found[name]["heading"] is not None and error_deg(found[name], truth[name]) < 1.0]
    assert len(right) >= len(good) - 1, {name: found[name]["heading"] for name in good}
    for name, row in found.items():
        assert row["compass"] is None
        assert row["eye_z"] is None or row["eye_z"] == pytest.approx(float(truth[name]["height_orthometric_m"]))
        if row["status"] == "accepted":
            assert error_deg(row, truth[name]) < 3.0, name


@pytest.mark.data
def test_columbia_viewsheds_from_the_oriented_points(columbia, qgis_process, shared_data):
    done = qgis_process(
        "--json",
        "run",
        "skylineviewshed:directedviewshed",
        "--",
        f"INPUT={columbia / 'oriented.gpkg'}",
        f"DEM={shared_data / 'columbia' / 'dem' / 'columbia.tif'}",
        f"OUTPUT={columbia / 'viewshed.tif'}",
        f"POLYGONS={columbia / 'polygons.gpkg'}",
        "HEIGHT_FIELD=eye_z",
    )
    assert done.returncode == 0, done.stderr
    results = json.loads(done.stdout)["results"]
    oriented = rows_of(columbia / "oriented.gpkg")
    accepted = [row for row in oriented if row["status"] == "accepted"]
    doubtful = [row for row in oriented if row["status"] != "accepted" and row["heading"] is not None]
    assert doubtful, "there is a heading that must not be used"
    assert results["COUNT"] == len(accepted) > 0
    seen = {row["photo"] for row in rows_of(columbia / "polygons.gpkg")}
    assert seen == {row["photo"] for row in accepted}
    raster, dem = (gdal.Open(str(path)) for path in (columbia / "viewshed.tif",
                                                     shared_data / "columbia" / "dem" / "columbia.tif"))  # fmt: skip
    assert raster.GetGeoTransform() == dem.GetGeoTransform()
    assert np.count_nonzero(raster.ReadAsArray() == 1) > 500


def test_the_first_model_chains_import_orientation_and_viewshed(qgis_process, scene, tmp_path):
    done = qgis_process(
        "run",
        "skylineviewshed:geotaggedphotos",
        "--",
        f"FOLDER={scene.folder}",
        "RECURSIVE=false",
        f"DEM={scene.dem}",
        "MAX_DISTANCE=8000",
        f"orient:PHOTOS={tmp_path / 'points.gpkg'}",
        f"orient:REPORT={tmp_path / 'report.html'}",
        f"viewshed:VIEWSHED={tmp_path / 'viewshed.tif'}",
        f"viewshed:POLYGONS={tmp_path / 'polygons.gpkg'}",
    )
    assert done.returncode == 0, done.stderr + done.stdout
    found = {row["filename"]: row for row in rows_of(tmp_path / "points.gpkg")}
    assert found["north"]["heading"] == pytest.approx(20.0, abs=0.5)
    assert len(rows_of(tmp_path / "polygons.gpkg")) == 2
    assert np.count_nonzero(gdal.Open(str(tmp_path / "viewshed.tif")).ReadAsArray() == 1) > 50


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("north.jpg", "is a colour picture"),
        ("nowhere.tif", "has no geographic or projected coordinate reference system"),
    ],
)
def test_an_unusable_dem_ends_with_code_1_and_a_sentence(qgis_process, scene, tmp_path, name, words):
    dems, out = tmp_path / "dems", tmp_path / "out"
    dems.mkdir()
    out.mkdir()
    shutil.copy(scene.folder / "north.jpg", dems)
    make_tif(dems / "nowhere.tif", np.full((20, 20), 900, np.int16), crs=None)
    done = qgis_process(
        "run",
        "skylineviewshed:photoviewshed",
        "--",
        f"FOLDER={scene.folder}",
        f"DEM={dems / name}",
        f"OUTPUT={out / 'points.gpkg'}",
        f"POLYGONS={out / 'polygons.gpkg'}",
        f"VIEWSHED={out / 'viewshed.tif'}",
    )
    assert done.returncode == 1
    assert words in done.stderr
    assert list(out.iterdir()) == []


def test_an_interrupt_ends_soon_with_code_1_and_leaves_nothing(shell_environment, scene, tmp_path):
    command = [
        "qgis_process",
        "run",
        "skylineviewshed:photoviewshed",
        "--",
        f"FOLDER={scene.folder}",
        f"DEM={scene.dem}",
        f"OUTPUT={tmp_path / 'points.gpkg'}",
        f"POLYGONS={tmp_path / 'polygons.gpkg'}",
        f"VIEWSHED={tmp_path / 'viewshed.tif'}",
        f"REPORT={tmp_path / 'report.html'}",
    ]
    process = subprocess.Popen(
        command, env=shell_environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    for line in iter(process.stdout.readline, b""):
        if b"north.jpg (1/2)" in line:
            break
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    assert process.returncode == 1
    assert list(tmp_path.iterdir()) == []
