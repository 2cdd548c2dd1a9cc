"""Where inputs may lie: layers that cannot be edited, photographs on other drives, DEMs in other forms and systems."""

from __future__ import annotations

import csv
import os
import shutil
import sqlite3
import tempfile
import zipfile
from pathlib import Path

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProject,
    QgsRasterLayer,
    QgsVectorDataProvider,
    QgsVectorFileWriter,
    QgsVectorLayer,
)

pytestmark = pytest.mark.qgis

OTHER_DRIVES = ("/dev/shm", "/run", "/var/tmp", os.path.expanduser("~"))
EDITING = (
    QgsVectorDataProvider.Capability.AddFeatures,
    QgsVectorDataProvider.Capability.ChangeAttributeValues,
    QgsVectorDataProvider.Capability.AddAttributes,
)


@pytest.fixture(scope="module")
def rows(scene):
    """The north photo and what a surveyor keeps of it."""
    longitude, latitude = scene.positions["north"]
    return [
        {"photo": str(scene.folder / "north.jpg"), "who": "Zoë", "number": 7, "lon": longitude, "lat": latitude},
    ]


@pytest.fixture(scope="module")
def table(rows, tmp_path_factory):
    path = tmp_path_factory.mktemp("points") / "points.csv"
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    return path


def delimited_text(table, folder):
    uri = f"{table.as_uri()}?type=csv&delimiter=,&xField=lon&yField=lat&crs=EPSG:4326&detectTypes=yes"
    return QgsVectorLayer(uri, "text", "delimitedtext")


def view_of_a_database(table, folder):
    """A view, as databases give it: without a primary key, and not to be written."""
    saved(table, folder / "points.gpkg")
    database = sqlite3.connect(folder / "points.gpkg")
    with database:
        database.execute("CREATE VIEW seen AS SELECT fid AS OGC_FID, geom, photo, who, number FROM points")
        database.execute("INSERT INTO gpkg_contents (table_name, identifier, data_type, srs_id) "
                         "VALUES ('seen', 'seen', 'features', 4326)")  # fmt: skip
        database.execute("INSERT INTO gpkg_geometry_columns VALUES ('seen', 'geom', 'POINT', 4326, 0, 0)")
    database.close()
    layer = QgsVectorLayer(f"{folder / 'points.gpkg'}|layername=seen", "view", "ogr")
    layer.setReadOnly(True)  # OGR itself finds out at the first edit only
    return layer


def file_in_an_archive(table, folder):
    saved(table, folder / "points.geojson", "GeoJSON")
    with zipfile.ZipFile(folder / "points.zip", "w") as archive:
        archive.write(folder / "points.geojson", "points.geojson")
    return QgsVectorLayer(f"/vsizip/{folder / 'points.zip'}/points.geojson", "archive", "ogr")


def virtual_layer(table, folder):
    QgsProject.instance().addMapLayer(delimited_text(table, folder))
    return QgsVectorLayer("?query=SELECT photo, who, number, geometry FROM text", "virtual", "virtual")


def layer_in_memory_without_rights(table, folder):
    """What a WFS gives: features from elsewhere, of which the layer is told to be read-only."""
    source = delimited_text(table, folder)
    layer = QgsVectorLayer("Point?crs=EPSG:4326", "memory", "memory")
    layer.dataProvider().addAttributes(source.fields().toList())
    layer.updateFields()
    layer.dataProvider().addFeatures(list(source.getFeatures()))
    layer.setReadOnly(True)
    return layer


def saved(table, path, driver="GPKG"):
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = driver
    source = delimited_text(table, path.parent)
    failed, *_ = QgsVectorFileWriter.writeAsVectorFormatV3(
        source, str(path), QgsProject.instance().transformContext(), options
    )
    assert failed == QgsVectorFileWriter.WriterError.NoError


@pytest.fixture(
    params=[delimited_text, view_of_a_database, file_in_an_archive, virtual_layer, layer_in_memory_without_rights],
    ids=lambda make: make.__name__,
)
def read_only(request, qgis_app, table, tmp_path):
    layer = request.param(table, tmp_path)
    assert layer.isValid() and layer.featureCount() == 1, layer.error().message()
    QgsProject.instance().addMapLayer(layer)
    yield layer
    QgsProject.instance().clear()


def test_points_that_cannot_be_edited_are_oriented_and_keep_their_fields(run, scene, read_only, tmp_path):
    begun = []
    for signal in (read_only.beforeEditingStarted, read_only.editingStarted, read_only.attributeAdded):
        signal.connect(lambda *_: begun.append("edit"))
    before = {path: path.read_bytes() for path in tmp_path.iterdir() if path.suffix not in (".gpkg-wal", ".gpkg-shm")}
    results, _ = run("orientphotos", {"INPUT": read_only, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    (feature,) = results["OUTPUT"].getFeatures()
    assert feature["who"] == "Zoë" and int(feature["number"]) == 7
    assert feature["status"] == "accepted"
    assert feature["heading"] == pytest.approx(scene.truth["north"].heading_deg, abs=0.5)
    assert begun == [] and not read_only.isEditable()
    assert {path: path.read_bytes() for path in before} == before


def test_the_layers_of_these_tests_are_read_only_indeed(read_only):
    capabilities = read_only.dataProvider().capabilities()
    assert read_only.readOnly() or not any(capabilities & one for one in EDITING)


# --- photographs elsewhere ---------------------------------------------------------------------------------------


@pytest.fixture
def other_drive(tmp_path):
    """A folder on another file system than the temporary files."""
    for place in OTHER_DRIVES:
        if os.path.isdir(place) and os.access(place, os.W_OK) and os.stat(place).st_dev != tmp_path.stat().st_dev:
            folder = Path(tempfile.mkdtemp(prefix="skyline-", dir=place))
            yield folder
            shutil.rmtree(folder)
            return
    pytest.skip("all writable places are on one file system")


def test_photographs_dem_and_results_may_each_be_on_another_drive(run, scene, other_drive, tmp_path):
    photos, results = tmp_path / "photos", other_drive / "results"
    photos.mkdir()
    shutil.copy(scene.folder / "north.jpg", photos)
    outputs = {"OUTPUT": "points.gpkg", "POLYGONS": "ground.gpkg", "VIEWSHED": "seen.tif", "REPORT": "report.html"}
    outputs |= {"RASTERS": "rasters", "FIGURES": "figures"}
    given = {name: str(results / file) for name, file in outputs.items()}
    found, _ = run("photoviewshed", {"FOLDER": str(photos), "DEM": str(scene.dem), "MAX_DISTANCE": 5000, **given})
    assert found["ACCEPTED"] == 1
    assert sorted(path.name for path in results.iterdir()) == sorted([*outputs.values(), "seen.qml"])
    assert sorted(path.name for path in (results / "rasters").iterdir()) == ["north.qml", "north.tif"]


def test_photographs_on_another_drive_are_found_by_their_full_path(run, scene, other_drive):
    shutil.copy(scene.folder / "north.jpg", other_drive / "Grüße 🏔.jpg")
    results, _ = run("importphotos", {"FOLDER": str(other_drive), "OUTPUT": "memory:"})
    results, _ = run("orientphotos", {"INPUT": results["OUTPUT"], "DEM": str(scene.dem), "OUTPUT": "memory:"})
    (feature,) = results["OUTPUT"].getFeatures()
    assert feature["photo"] == str(other_drive / "Grüße 🏔.jpg") and feature["status"] == "accepted"


@pytest.mark.parametrize("beside", ["layer", "project"])
def test_relative_paths_count_from_the_layer_then_from_the_project(run, scene, other_drive, tmp_path, beside):
    home = other_drive if beside == "layer" else tmp_path
    (home / "Bilder").mkdir()
    shutil.copy(scene.folder / "north.jpg", home / "Bilder")
    longitude, latitude = scene.positions["north"]
    text = other_drive / "points.csv"
    text.write_text(f"photo,lon,lat\nBilder/north.jpg,{longitude!r},{latitude!r}\n")
    saved(text, other_drive / "points.gpkg")
    project, context = QgsProject.instance(), QgsProcessingContext()
    project.setFileName(str(tmp_path / "project.qgz"))
    layer = QgsVectorLayer(str(other_drive / "points.gpkg"), "points", "ogr")
    project.addMapLayer(layer)
    results, _ = run("orientphotos", {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:"}, context=context)
    (feature,) = results["OUTPUT"].getFeatures()
    assert feature["status"] == "accepted", feature["message"]
    project.clear()


# --- elevation models --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["VRT", "COG", "another CRS"])
def test_a_dem_layer_may_be_a_vrt_or_a_cog_or_in_another_crs_than_the_project(run, scene, tmp_path, form):
    from osgeo import gdal

    path = str(tmp_path / ("dem.vrt" if form == "VRT" else "dem.tif"))
    if form == "another CRS":
        made = gdal.Warp(path, str(scene.dem), dstSRS="EPSG:32632", resampleAlg="cubic")
    else:
        made = gdal.Translate(path, str(scene.dem), format=form)
    assert made is not None
    del made
    project = QgsProject.instance()
    project.setCrs(QgsCoordinateReferenceSystem("EPSG:3857"))
    layer = QgsRasterLayer(path, "dem", "gdal")
    project.addMapLayer(layer)
    given = {"FOLDER": str(scene.folder), "DEM": layer, "MAX_DISTANCE": 5000, "OUTPUT": "memory:"}
    given |= {"POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "seen.tif"), "REPORT": str(tmp_path / "report.html")}
    results, _ = run("photoviewshed", given)
    for feature in results["OUTPUT"].getFeatures():
        true_deg = scene.truth[Path(feature["photo"]).stem].heading_deg
        assert feature["heading"] == pytest.approx(true_deg, abs=0.5)
    seen = QgsRasterLayer(str(tmp_path / "seen.tif"), "seen", "gdal")
    # The layer itself may have lost its CRS by now: see `lost_crs`.
    own = QgsRasterLayer(path, "own", "gdal")
    assert seen.crs().toProj() == results["POLYGONS"].crs().toProj() == own.crs().toProj() != ""
    assert seen.extent() == layer.extent()
    project.clear()
