"""Layers in files keep their looks: style, aliases, form and map tips lie in the file, for any project and computer."""

from __future__ import annotations

import json
import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from qgis.core import QgsExpression, QgsExpressionContext, QgsExpressionContextUtils, QgsProject, QgsVectorLayer
from qgis.PyQt.QtWidgets import QLabel

pytestmark = pytest.mark.qgis


def loaded(path, name=None):
    """The layer as a user loads it: with the style that its file has as default."""
    source = f"{path}|layername={name}" if name else str(path)
    layer = QgsVectorLayer(source, "loaded", "ogr")
    assert layer.isValid(), source
    return layer


def evaluated(layer, feature, expression):
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    return QgsExpression.replaceExpressionText(expression, context)


def picture_of(layer, feature):
    """Path of the picture in the map tip."""
    return evaluated(layer, feature, layer.mapTipTemplate()).split('src="file:///')[1].split('"')[0]


@pytest.fixture(scope="module")
def trip(scene, tmp_path_factory, qgis_process):
    """A folder with photos (one HEIC where it can be written) and the layers that qgis_process made beside them."""
    from skyline_viewshed.core.io.photo import read_metadata, read_photo
    from skyline_viewshed.core.io.write_photo import write_photo

    folder = tmp_path_factory.mktemp("trip") / "journey"
    (folder / "photos").mkdir(parents=True)
    shutil.copy(scene.folder / "north.jpg", folder / "photos")
    west = scene.folder / "west.jpg"
    pytest.importorskip("pillow_heif")
    write_photo(str(folder / "photos" / "west.heic"), read_photo(west).pixels, read_metadata(west))
    outputs = [f"OUTPUT={folder}/points.gpkg", f"POLYGONS={folder}/ground.gpkg", f"VIEWSHED={folder}/seen.tif"]
    done = qgis_process(
        "run", "skylineviewshed:photoviewshed", "--", f"FOLDER={folder}/photos", f"DEM={scene.dem}", *outputs
    )
    assert done.returncode == 0, done.stderr
    return folder


def test_a_geopackage_from_qgis_process_carries_style_aliases_form_and_map_tip(trip):
    layer = loaded(trip / "points.gpkg")
    assert layer.renderer().type() == "categorizedSymbol" and layer.renderer().classAttribute() == "status"
    index = layer.fields().lookupField("heading")
    assert layer.attributeAlias(index) == "Heading (° from true north)"
    assert "<img" in layer.mapTipTemplate()
    form = layer.editFormConfig()
    assert [tab.name() for tab in form.tabs()][:2] == ["Answer", "Match"]
    assert [child.name() for child in form.tabs()[0].children()][:3] == ["preview", "status", "heading"]
    assert loaded(trip / "ground.gpkg").attributeAlias(5) == "Ground in view (m²)"


def test_numbers_show_the_decimals_that_they_deserve(trip):
    layer = loaded(trip / "points.gpkg")
    for name, decimals in (("heading", 1), ("p_correct", 2), ("horizon_m", 0), ("pitch", 1), ("hfov", 1)):
        setup = layer.editorWidgetSetup(layer.fields().lookupField(name))
        assert (setup.type(), int(setup.config()["Precision"])) == ("Range", decimals), name


def test_heic_shows_a_jpeg_and_the_picture_is_found_when_the_folder_moves(trip, tmp_path):
    moved = tmp_path / "elsewhere" / "renamed"
    shutil.copytree(trip, moved)
    before = {path.name for path in trip.iterdir()}
    assert "points_previews" in before and not [name for name in before if name.startswith(".skyline")]
    for folder in (trip, moved):
        layer = loaded(folder / "points.gpkg")
        rows = {row["filename"]: row for row in layer.getFeatures()}
        assert rows["north"]["preview"] == "photos/north.jpg"
        assert rows["west"]["preview"] == "points_previews/west.jpg"
        for name, row in rows.items():
            picture = Path(picture_of(layer, row))
            assert picture.is_file() and folder in picture.parents, name
            assert picture.read_bytes()[:2] == b"\xff\xd8"


def test_the_form_draws_the_picture_of_the_moved_layer(trip, tmp_path, qgis_app):
    from qgis.gui import QgsAttributeForm
    from qgis.PyQt.QtTest import QTest

    moved = tmp_path / "moved"
    shutil.copytree(trip, moved)
    layer = loaded(moved / "points.gpkg")
    QgsProject.instance().addMapLayer(layer)
    (heic,) = [row for row in layer.getFeatures() if row["filename"] == "west"]
    form = QgsAttributeForm(layer, heic)
    form.resize(700, 900)
    form.show()
    QTest.qWait(500)
    drawn = [it.pixmap() for it in form.findChildren(QLabel) if it.pixmap() is not None and not it.pixmap().isNull()]
    assert max(pixmap.height() for pixmap in drawn) > 150
    form.close()
    QgsProject.instance().clear()


def test_algorithms_find_photos_that_moved_with_their_layer(trip, tmp_path, run):
    moved = tmp_path / "moved"
    shutil.copytree(trip, moved)
    layer = loaded(moved / "points.gpkg")
    assert layer.startEditing()
    for row in layer.getFeatures():  # the old place is gone
        gone = f"/gone/photos/{Path(row['photo']).name}"
        layer.changeAttributeValue(row.id(), layer.fields().lookupField("photo"), gone)
    assert layer.commitChanges()
    results, feedback = run("extractskyline", {"INPUT": layer, "OUTPUT": "memory:"})
    assert results["COUNT"] == 2 and feedback.errors == [] and feedback.warnings == []


def test_a_name_alone_counts_only_beside_the_layer(tmp_path):
    from skyline_viewshed.algorithms.shared.layers import moved_photo

    for place in ("a.jpg", "out/b.jpg", "photos/c.jpg"):
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_bytes(b"")
    out = tmp_path / "out"
    assert moved_photo("/old/photos/c.jpg", [out]) == str(tmp_path / "photos" / "c.jpg")
    assert moved_photo("C:\\old\\photos\\c.jpg", [out]) == str(tmp_path / "photos" / "c.jpg")
    assert moved_photo("/old/b.jpg", [out]) == str(out / "b.jpg")
    assert moved_photo("/old/a.jpg", [out]) == "/old/a.jpg"


def test_fields_of_the_user_s_own_have_a_tab_and_missing_ones_none(scene, tmp_path, run):
    points = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string&field=valley:string", "own", "memory")
    from qgis.core import QgsFeature, QgsGeometry

    feature = QgsFeature(points.fields())
    longitude, latitude = scene.positions["north"]
    feature.setGeometry(QgsGeometry.fromWkt(f"Point({longitude!r} {latitude!r})"))
    feature.setAttributes([str(scene.folder / "north.jpg"), "Upper"])
    points.dataProvider().addFeature(feature)
    run("orientphotos", {"INPUT": points, "DEM": str(scene.dem), "OUTPUT": str(tmp_path / "o.gpkg")})
    layer = loaded(tmp_path / "o.gpkg")
    tabs = {tab.name(): [child.name() for child in tab.children()] for tab in layer.editFormConfig().tabs()}
    assert tabs["Other fields"] == ["valley"] and "camera" not in tabs["Photo"]


@pytest.mark.parametrize("suffix", ["geojson", "shp"])
def test_formats_without_a_place_for_styles_get_one_beside_them_and_a_user_s_own_stays(suffix, scene, tmp_path, run):
    given = {"FOLDER": str(scene.folder), "OUTPUT": str(tmp_path / f"p.{suffix}")}
    run("importphotos", given)
    assert loaded(tmp_path / f"p.{suffix}").mapTipTemplate() != ""
    (tmp_path / "p.qml").write_text("mine")
    run("importphotos", given)
    assert (tmp_path / "p.qml").read_text() == "mine"


def test_a_table_that_is_added_to_a_geopackage_carries_its_style_too(scene, tmp_path, run):
    path = tmp_path / "both.gpkg"
    for table in ("first", "second", "first"):
        target = f"ogr:dbname='{path}' table=\"{table}\" (geom)"
        run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": target})
    with closing(sqlite3.connect(path)) as database:
        rows = database.execute("select f_table_name, useAsDefault from layer_styles order by 1").fetchall()
    assert [(name, bool(default)) for name, default in rows] == [("first", True), ("second", True)]
    assert loaded(path, "second").mapTipTemplate() != ""


def test_a_style_that_cannot_be_stored_leaves_no_file(scene, tmp_path, run, monkeypatch):
    from qgis.core import QgsProcessingException
    from skyline_viewshed.algorithms.shared import outputs

    monkeypatch.setattr(outputs, "store_style", lambda *_: False)
    with pytest.raises(QgsProcessingException, match="could not be written"):
        run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(tmp_path / "p.gpkg")})
    assert list(tmp_path.iterdir()) == []


def test_a_failed_run_leaves_no_previews(tmp_path):
    import numpy as np
    from skyline_viewshed.algorithms.shared.previews import Previews

    parameters = {"OUTPUT": str(tmp_path / "p.gpkg")}
    with pytest.raises(RuntimeError), Previews(parameters, None) as previews:
        previews.add("/photos/a.heic", np.zeros((30, 40, 3), np.uint8))
        raise RuntimeError("stopped")
    assert list(tmp_path.iterdir()) == []


def test_styles_are_stored_in_the_user_s_language(monkeypatch):
    from skyline_viewshed.algorithms.shared import stored_style

    monkeypatch.setattr(stored_style, "marked", str.upper)
    text = stored_style.style_document("oriented", {"heading": "Kurs"}).toString()
    assert 'label="ACCEPTED: TRUST IT"' in text and 'name="ANSWER"' in text and 'name="Kurs"' in text
    assert json.dumps("heading") in text
