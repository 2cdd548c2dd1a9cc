"""Photos that were oriented again update the layer that they came from, and the viewsheds follow."""

from __future__ import annotations

import json

import pytest
from qgis.core import QgsApplication, QgsFeature, QgsGeometry, QgsProject, QgsVectorLayer

pytestmark = pytest.mark.qgis

FIELDS = "&".join(
    ["field=photo:string", "field=note:string", "field=status:string", "field=message:string"]
    + [f"field={name}:double" for name in ("heading", "pitch", "roll", "hfov", "vfov")]
)


def layer_of(*rows, name="oriented"):
    layer = QgsVectorLayer(f"Point?crs=EPSG:4326&{FIELDS}", name, "memory")
    for values in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt("Point(8 46)"))
        for key, value in values.items():
            feature[key] = value
        layer.dataProvider().addFeature(feature)
    return layer


def photo(name, status, heading, note=None):
    return {"photo": f"/p/{name}.jpg", "status": status, "heading": heading, "note": note}


def found(layer):
    return [(row["photo"][3:-4], row["status"], row["heading"], row["note"]) for row in layer.getFeatures()]


def test_new_answers_enter_their_layer_and_nothing_else_changes(run):
    layer = layer_of(photo("a", "ambiguous", 10.0, "mine"), photo("b", "accepted", 20.0), photo("c", "rejected", None))
    solved = layer_of(
        photo("a", "accepted", 99.0, "theirs"), photo("c", "rejected", 5.0), photo("new", "accepted", 1.0)
    )
    results, feedback = run("mergeoriented", {"INPUT": layer, "SOLVED": solved})
    assert found(layer)[:2] == [("a", "accepted", 99.0, "mine"), ("b", "accepted", 20.0, None)]
    assert found(layer)[2][2] == 5.0 and not layer.isEditable()
    assert (results["COUNT"], results["KEPT"], results["UNKNOWN"]) == (2, 0, 1)
    assert feedback.warnings == ["new.jpg: the layer does not have this photo."]


@pytest.mark.parametrize(("only_better", "heading"), [(True, 10.0), (False, 99.0)])
def test_a_better_status_stays_unless_the_user_says_otherwise(run, only_better, heading):
    layer = layer_of(photo("a", "confirmed", 10.0))
    solved = layer_of(photo("a", "accepted", 99.0))
    results, feedback = run("mergeoriented", {"INPUT": layer, "SOLVED": solved, "ONLY_BETTER": only_better})
    assert found(layer)[0][2] == heading and results["KEPT"] == int(only_better)
    if only_better:
        assert "a.jpg: stays confirmed; the new answer is accepted." in feedback.infos


def test_answers_without_a_status_do_not_take_the_place_of_a_known_one(run):
    layer = layer_of(photo("a", "Confirmed", 10.0), photo("b", None, 20.0))
    solved = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string&field=heading:double", "solved", "memory")
    for path in ("/p/a.jpg", "/p/b.jpg"):
        feature = QgsFeature(solved.fields())
        feature.setAttributes([path, 99.0])
        solved.dataProvider().addFeature(feature)
    results, feedback = run("mergeoriented", {"INPUT": layer, "SOLVED": solved})
    assert [row[2] for row in found(layer)] == [10.0, 99.0] and results["KEPT"] == 1
    assert "a.jpg: stays confirmed; the new answer is unknown." in feedback.infos


def test_of_several_answers_the_best_status_is_used(run):
    layer = layer_of(photo("a", "rejected", None))
    solved = layer_of(photo("a", "ambiguous", 1.0), photo("a", "accepted", 2.0), photo("a", "rejected", 3.0))
    _, feedback = run("mergeoriented", {"INPUT": layer, "SOLVED": solved})
    assert found(layer)[0][1:3] == ("accepted", 2.0) and len(feedback.warnings) == 2


def test_changes_join_an_edit_session_and_can_be_undone(run):
    layer = layer_of(photo("a", "ambiguous", 10.0))
    QgsProject.instance().addMapLayer(layer)
    layer.startEditing()
    run("mergeoriented", {"INPUT": layer, "SOLVED": layer_of(photo("a", "accepted", 99.0))})
    assert layer.isEditable() and found(layer)[0][2] == 99.0
    layer.undoStack().undo()
    assert found(layer)[0][2] == 10.0
    layer.rollBack()
    QgsProject.instance().clear()


def test_layers_that_cannot_be_changed_or_have_no_headings_are_refused(refusal, tmp_path):
    (tmp_path / "p.csv").write_text("photo,heading\n/p/a.jpg,3\n")
    table = QgsVectorLayer(f"file://{tmp_path}/p.csv?type=csv", "table", "delimitedtext")
    plain = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string", "plain", "memory")
    solved = layer_of(photo("a", "accepted", 99.0))
    assert "cannot be changed. Save it as a GeoPackage" in refusal("mergeoriented", {"INPUT": table, "SOLVED": solved})
    assert "has no field heading" in refusal("mergeoriented", {"INPUT": plain, "SOLVED": solved})
    assert "has no field heading" in refusal("mergeoriented", {"INPUT": solved, "SOLVED": plain})


def test_the_algorithm_runs_in_the_main_thread_to_which_a_project_s_layers_belong(algorithm):
    it = algorithm("mergeoriented")
    assert it.flags() & it.Flag.FlagNoThreading


@pytest.fixture
def spoilt(run, scene, tmp_path):
    """A GeoPackage of the scene's photos in which one has lost its answer."""
    path = tmp_path / "points.gpkg"
    run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(tmp_path / "photos.gpkg")})
    run("orientphotos", {"INPUT": str(tmp_path / "photos.gpkg"), "DEM": str(scene.dem), "OUTPUT": str(path)})
    layer = QgsVectorLayer(str(path), "points", "ogr")
    layer.startEditing()
    for row in layer.getFeatures():
        if row["filename"] == "north":
            for name, value in (("status", "rejected"), ("heading", None)):
                layer.changeAttributeValue(row.id(), layer.fields().lookupField(name), value)
    assert layer.commitChanges()
    return path


def test_the_model_orients_again_updates_the_layer_and_renews_the_viewsheds(run, scene, spoilt, tmp_path):
    model = QgsApplication.processingRegistry().algorithmById("skylineviewshed:orientagain")
    outputs = {
        it.name(): str(tmp_path / f"{it.name().split(':')[-1]}{'.tif' if it.type().startswith('raster') else '.gpkg'}")
        for it in model.destinationParameterDefinitions()
    }
    outputs = {name: path.replace("REPORT.gpkg", "report.html") for name, path in outputs.items()}
    given = {"AGAIN": str(spoilt), "LAYER": str(spoilt), "DEM": str(scene.dem), "MAX_DISTANCE": 5000.0}
    run("orientagain", {**given, **outputs})
    rows = {row["filename"]: row for row in QgsVectorLayer(str(spoilt), "points", "ogr").getFeatures()}
    assert rows["north"]["status"] == "accepted"
    assert rows["north"]["heading"] == pytest.approx(scene.truth["north"].heading_deg, abs=0.5)
    assert QgsVectorLayer(str(tmp_path / "POLYGONS.gpkg"), "ground", "ogr").featureCount() == 2


def test_qgis_process_updates_a_file_and_answers_in_json(qgis_process, scene, spoilt, run, tmp_path):
    again = tmp_path / "again.gpkg"
    run("orientphotos", {"INPUT": str(spoilt), "DEM": str(scene.dem), "OUTPUT": str(again)})
    done = qgis_process("--json", "run", "skylineviewshed:mergeoriented", "--", f"INPUT={spoilt}", f"SOLVED={again}")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["results"]["COUNT"] == 2
    rows = {row["filename"]: row["status"] for row in QgsVectorLayer(str(spoilt), "points", "ogr").getFeatures()}
    assert rows["north"] == "accepted"
