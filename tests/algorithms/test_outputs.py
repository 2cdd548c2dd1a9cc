"""Layers that a run writes: a file gets its name when it is whole, and QGIS still finds, names and styles it."""

from __future__ import annotations

import os
import sqlite3

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsField,
    QgsFields,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingOutputLayerDefinition,
    QgsProject,
    QgsProperty,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QVariant
from skyline_viewshed.algorithms.shared import outputs
from skyline_viewshed.algorithms.shared.outputs import write_features
from skyline_viewshed.algorithms.shared.styling import LayerStyler, style_on_completion

pytestmark = pytest.mark.qgis

ROWS = [(QgsGeometry.fromPointXY(QgsPointXY(8 + k, 46)), [f"row {k}"]) for k in range(5)]


@pytest.fixture
def context():
    made = QgsProcessingContext()
    made.setProject(QgsProject.instance())
    return made


@pytest.fixture
def write(algorithm, context):
    """Write ROWS to a destination as an algorithm does; gives the layer's identifier."""

    def call(destination, rows=ROWS):
        fields = QgsFields()
        fields.append(QgsField("name", QVariant.String, "", 80))
        crs = QgsCoordinateReferenceSystem("EPSG:4326")
        given = {"OUTPUT": destination}
        return write_features(
            algorithm("importphotos"), given, "OUTPUT", context, fields, QgsWkbTypes.Type.Point, crs, rows
        )

    return call


@pytest.mark.parametrize("suffix", [".gpkg", ".shp", ".geojson", ".csv", ".kml", ".sqlite"])
def test_a_file_is_written_and_written_over_under_its_name_only(write, tmp_path, suffix):
    path = tmp_path / f"Fotos Zoë{suffix}"
    for rows in (ROWS, ROWS[:2]):
        identifier = write(str(path), rows)
        layer = QgsVectorLayer(identifier, "again", "ogr")
        assert layer.isValid() and layer.featureCount() == len(rows)
        del layer
    assert identifier == str(path)
    assert {name.split(".")[0] for name in os.listdir(tmp_path)} == {"Fotos Zoë"}


def test_the_layer_in_the_file_is_called_after_the_file(write, tmp_path):
    path = write(str(tmp_path / "ground.gpkg"))
    database = sqlite3.connect(path)
    tables = {name for (name,) in database.execute("SELECT table_name FROM gpkg_contents")}
    assert tables == {"ground", "layer_styles"}
    database.close()


def test_the_file_has_no_name_while_it_is_written_and_the_older_one_stays(write, tmp_path, monkeypatch):
    path, fill, seen = tmp_path / "ground.gpkg", outputs._fill, []
    write(str(path))
    older = path.read_bytes()

    def watched(sink, fields, rows):
        done = fill(sink, fields, rows)
        seen.append(path.read_bytes() == older)
        return done

    monkeypatch.setattr(outputs, "_fill", watched)
    write(str(path), ROWS[:1])
    assert seen == [True] and path.read_bytes() != older


def test_a_layer_that_cannot_be_filled_leaves_the_older_file(write, tmp_path, monkeypatch):
    path = tmp_path / "ground.gpkg"
    write(str(path))
    older = path.read_bytes()
    monkeypatch.setattr(outputs, "_fill", lambda *_: False)
    with pytest.raises(QgsProcessingException, match="ground.gpkg could not be written"):
        write(str(path))
    assert path.read_bytes() == older and os.listdir(tmp_path) == ["ground.gpkg"]


def test_a_file_that_has_lost_features_is_refused(write, tmp_path, monkeypatch):
    fill = outputs._fill
    monkeypatch.setattr(outputs, "_fill", lambda sink, fields, rows: fill(sink, fields, rows[:-1]))
    with pytest.raises(QgsProcessingException, match="ground.gpkg could not be written"):
        write(str(tmp_path / "ground.gpkg"))
    assert os.listdir(tmp_path) == []


def test_qgis_loads_names_and_styles_the_layer_from_its_last_place(write, context, tmp_path):
    path = str(tmp_path / "ground.gpkg")
    wanted = QgsProcessingOutputLayerDefinition(path, QgsProject.instance())
    wanted.destinationName = "My ground"
    identifier = write(wanted)
    style_on_completion(context, identifier, "photos", "Photos")
    layers = context.layersToLoadOnCompletion()
    assert identifier == path and list(layers) == [path]
    assert layers[path].name == "My ground" and isinstance(layers[path].postProcessor(), LayerStyler)


def test_a_property_and_a_name_without_suffix_work(write, tmp_path):
    assert write(QgsProperty.fromValue(str(tmp_path / "one.gpkg"))) == str(tmp_path / "one.gpkg")
    assert write(str(tmp_path / "new" / "two")) == str(tmp_path / "new" / "two.gpkg")
    assert sorted(os.listdir(tmp_path)) == ["new", "one.gpkg"]


def test_a_table_of_an_existing_database_is_added_and_its_neighbours_stay(write, tmp_path):
    path = write(str(tmp_path / "all.gpkg"))
    second = write(f"ogr:dbname='{path}' table=\"second\" (geom)", ROWS[:2])
    for identifier, count in ((f"{path}|layername=all", 5), (second, 2)):
        layer = QgsVectorLayer(identifier, "table", "ogr")
        assert layer.isValid() and layer.featureCount() == count, identifier
        del layer


@pytest.mark.parametrize("destination", ["memory:", "TEMPORARY_OUTPUT"])
def test_a_layer_in_memory_stays_in_memory(write, context, tmp_path, monkeypatch, destination):
    monkeypatch.chdir(tmp_path)
    layer = context.temporaryLayerStore().mapLayer(write(destination))
    assert layer.dataProvider().name() == "memory" and layer.featureCount() == 5
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(
    ("destination", "plain"),
    [
        ("/data/ground.gpkg", True),
        ("C:\\data\\ground.gpkg", True),
        ("ground.shp", True),
        ("postgis:dbname='x' table=\"y\" (geom)", False),
        ("spatialite:dbname='x.sqlite'", False),
        ("/data/all.gpkg|layername=ground", False),
        ("/vsimem/ground.gpkg", False),
        ("", False),
        (None, False),
    ],
)
def test_only_plain_files_are_written_elsewhere_first(destination, plain):
    assert outputs.is_plain_file(destination) is plain
