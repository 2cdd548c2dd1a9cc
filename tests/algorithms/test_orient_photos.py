from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import (
    NULL,
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsField,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingException,
    QgsProcessingFeatureSourceDefinition,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QVariant
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.write_photo import write_photo

CONTRACT = [
    "heading", "pitch", "roll", "hfov", "vfov", "ncc", "ncc_2nd", "heading_2", "heading_3", "sharpness", "heading_lo",
    "heading_hi", "pitch_lo", "pitch_hi", "roll_lo", "roll_hi", "hfov_lo", "hfov_hi", "p_correct", "status", "message",
    "compass", "compass_df", "grid_conv", "horizon_m", "eye_z", "observ_hgt", "radius", "azim_1", "azim_2",
]  # fmt: skip


@pytest.fixture(scope="session")
def photo_layer(provider, scene):
    """Our own import of the scene's photographs, as a memory layer."""
    import processing

    layer = processing.run("skylineviewshed:importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})["OUTPUT"]
    QgsProject.instance().addMapLayer(layer)
    return layer


@pytest.fixture(scope="session")
def solved(provider, photo_layer, scene, tmp_path_factory):
    """The scene solved once: (results, attributes by name)."""
    import processing

    report = tmp_path_factory.mktemp("solved") / "report.html"
    results = processing.run(
        "skylineviewshed:orientphotos",
        {"INPUT": photo_layer, "DEM": str(scene.dem), "OUTPUT": "memory:", "REPORT": str(report)},
    )
    return results, {f["filename"]: f for f in results["OUTPUT"].getFeatures()}


def points(fields, rows, crs="EPSG:4326"):
    """Memory layer from rows of ((x, y) or None, attributes)."""
    layer = QgsVectorLayer(f"Point?crs={crs}", "points", "memory")
    layer.dataProvider().addAttributes(
        [QgsField(name, QVariant.Double if kind is float else QVariant.String) for name, kind in fields]
    )
    layer.updateFields()
    for position, attributes in rows:
        feature = QgsFeature(layer.fields())
        if position is not None:
            feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*position)))
        feature.setAttributes(attributes)
        layer.dataProvider().addFeature(feature)
    return layer


def test_parameters_are_the_contract(algorithm):
    it = algorithm("orientphotos")
    names = [definition.name() for definition in it.parameterDefinitions()]
    wanted = ["INPUT", "PHOTO_FIELD", "DEM", "BAND", "DEM_UNIT", "METHOD", "COMPASS"]
    wanted += ["HFOV_FIELD", "HEIGHT_FIELD", "POSITION_ERROR_FIELD", "EYE_HEIGHT"]
    assert names[: len(wanted) + 2] == [*wanted, "MAX_DISTANCE", "REFRACTION"]
    assert {"SKY_MASKS", "LANDMARKS", "SKYLINES", "USE_ALTITUDE", "HFOV", "OUTPUT", "REPORT"} <= set(names)
    assert it.parameterDefinition("METHOD").options()[0] == "robust"
    assert it.parameterDefinition("PHOTO_FIELD").defaultValue() == "photo"
    assert it.parameterDefinition("EYE_HEIGHT").defaultValue() == 1.7


def test_headings_and_pitches_are_those_of_the_scene(solved, scene):
    _, found = solved
    for name, pose in scene.truth.items():
        feature = found[name]
        assert feature["status"] == "accepted", feature["message"]
        assert feature["heading"] == pytest.approx(pose.heading_deg, abs=0.5)
        assert feature["pitch"] == pytest.approx(pose.pitch_deg, abs=0.3)
        assert feature["roll"] == pytest.approx(pose.roll_deg, abs=0.7)


def test_all_fields_are_there_and_the_source_s_stay(solved, photo_layer):
    results, found = solved
    names = results["OUTPUT"].fields().names()
    assert [name for name in names if name in CONTRACT] == CONTRACT
    assert set(photo_layer.fields().names()) <= set(names)
    assert all(len(name) <= 10 for name in names)
    assert found["north"]["f35"] == 28
    assert results["COUNT"] == 2 and results["ACCEPTED"] == 2


def test_derived_fields_follow_from_the_pose(solved, scene):
    feature = solved[1]["north"]
    assert feature["compass"] == pytest.approx(26.0, abs=0.01)
    assert feature["compass_df"] == pytest.approx(6.0, abs=0.6)
    left, right = feature["azim_1"], feature["azim_2"]
    assert (right - left) % 360 == pytest.approx(feature["hfov"], abs=1e-6)
    middle = (left + ((right - left) % 360) / 2 + feature["grid_conv"]) % 360
    assert middle == pytest.approx(feature["heading"], abs=1e-6)
    assert feature["observ_hgt"] == pytest.approx(1.7, abs=1e-6)
    assert 500 < feature["horizon_m"] < 30_000
    assert feature["heading_lo"] < 20 < feature["heading_hi"]
    for name in ("pitch", "roll", "hfov"):
        assert feature[f"{name}_lo"] < feature[name] < feature[f"{name}_hi"], name


def test_the_report_is_whole_and_names_each_photo(solved):
    text = Path(solved[0]["REPORT"]).read_text(encoding="utf-8")
    assert text.rstrip().endswith("</html>")
    assert "north.jpg" in text and "west.jpg" in text
    assert "http://" not in text.replace("http://www.w3.org/2000/svg", "")


def test_the_recorded_altitude_is_used_where_it_is_wanted(run, scene, solved, tmp_path):
    photo = read_photo(str(scene.folder / "north.jpg"))
    ground_m = solved[1]["north"]["eye_z"] - 1.7
    path = tmp_path / "tower.jpg"
    write_photo(str(path), photo.pixels, replace(photo.metadata, altitude_m=ground_m + 45.0))
    layer = points([("photo", str)], [(scene.positions["north"], [str(path)])])
    wanted = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:", "USE_ALTITUDE": True}
    (found,) = run("orientphotos", wanted)[0]["OUTPUT"].getFeatures()
    assert found["eye_z"] == pytest.approx(ground_m + 45.0, abs=0.1)
    assert found["observ_hgt"] == pytest.approx(45.0, abs=0.1)
    assert "and was used" in found["message"]


def test_bad_rows_fail_with_a_sentence_and_the_others_go_on(run, scene):
    lon, lat = scene.positions["west"]
    rows = [
        ((lon, lat), [str(scene.folder / "missing.jpg"), None]),
        ((lon, lat), [str(scene.odd / "empty.heic"), None]),
        ((lon, lat), [str(scene.odd / "damaged.jpg"), None]),
        (None, [str(scene.odd / "no_gps.jpg"), None]),
        ((0.0, 0.0), [str(scene.odd / "null_island.jpg"), None]),
        ((lon, lat), [str(scene.odd / "no_focal.jpg"), None]),
        ((lon + 3, lat), [str(scene.folder / "west.jpg"), None]),
        ((lon, lat), [None, None]),
    ]
    layer = points([("photo", str), ("fov", float)], rows)
    results, feedback = run("orientphotos", {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    found = list(results["OUTPUT"].getFeatures())
    assert [f["status"] for f in found] == ["failed"] * len(rows)
    words = ["no such file", "empty", "damaged", "GPS", "GPS", "HFOV_FIELD", "outside the DEM", "no photo"]
    for feature, word in zip(found, words):
        assert word in feature["message"], feature["message"]
        assert feature["heading"] in (None, NULL) and feature["p_correct"] in (None, NULL)
    assert len(feedback.warnings) == len(rows)


def test_a_picture_without_sky_gets_no_accepted_heading(run, scene):
    layer = points([("photo", str)], [(scene.positions["west"], [str(scene.odd / "no_sky.jpg")])])
    results, _ = run("orientphotos", {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    feature = next(results["OUTPUT"].getFeatures())
    assert feature["status"] in ("rejected", "ambiguous") and feature["message"]


def test_position_height_and_field_of_view_come_from_the_layer_in_any_crs(run, scene):
    from qgis.core import QgsCoordinateTransform

    utm = QgsCoordinateReferenceSystem("EPSG:32632")
    to_utm = QgsCoordinateTransform(QgsCoordinateReferenceSystem("EPSG:4326"), utm, QgsProject.instance())
    point = to_utm.transform(QgsPointXY(*scene.positions["west"]))
    rows = [((point.x(), point.y()), [str(scene.odd / "no_focal.jpg"), scene.hfov_deg])]
    layer = points([("picture", str), ("fov", float)], rows, "EPSG:32632")
    results, _ = run(
        "orientphotos",
        {"INPUT": layer, "PHOTO_FIELD": "picture", "HFOV_FIELD": "fov", "DEM": str(scene.dem), "OUTPUT": "memory:"},
    )
    feature = next(results["OUTPUT"].getFeatures())
    assert feature["heading"] == pytest.approx(scene.truth["west"].heading_deg, abs=0.5)
    assert results["OUTPUT"].crs().authid() == "EPSG:32632"


def test_selected_features_only(run, scene, photo_layer):
    photo_layer.selectByExpression("\"filename\" = 'west'")
    source = QgsProcessingFeatureSourceDefinition(photo_layer.id(), True)
    results, _ = run("orientphotos", {"INPUT": source, "DEM": str(scene.dem), "METHOD": 1, "OUTPUT": "memory:"})
    photo_layer.removeSelection()
    found = list(results["OUTPUT"].getFeatures())
    assert [f["filename"] for f in found] == ["west"]
    assert 0.5 < found[0]["ncc"] <= 1.0


def test_native_import_serves_as_it_is(run, scene):
    import processing

    native = processing.run("native:importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})["OUTPUT"]
    native.selectByExpression("\"filename\" = 'north'")
    QgsProject.instance().addMapLayer(native)
    source = QgsProcessingFeatureSourceDefinition(native.id(), True)
    results, _ = run("orientphotos", {"INPUT": source, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    feature = next(results["OUTPUT"].getFeatures())
    assert feature["heading"] == pytest.approx(20.0, abs=0.5)


def test_an_approximate_heading_narrows_the_search(run, scene):
    rows = [(scene.positions["west"], [str(scene.folder / "west.jpg"), 195.0, 15.0])]
    layer = points([("photo", str), ("about", float), ("within", float)], rows)
    parameters = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:"}
    results, _ = run("orientphotos", {**parameters, "HEADING_HINT_FIELD": "about", "TOLERANCE_FIELD": "within"})
    assert next(results["OUTPUT"].getFeatures())["heading"] == pytest.approx(200.0, abs=0.5)


def test_a_table_of_skylines_takes_the_place_of_the_extraction(run, scene, photo_layer):
    photo_layer.selectByExpression("\"filename\" = 'west'")
    source = QgsProcessingFeatureSourceDefinition(photo_layer.id(), True)
    skylines, _ = run("extractskyline", {"INPUT": source, "OUTPUT": "memory:"})
    QgsProject.instance().addMapLayer(skylines["OUTPUT"])
    parameters = {"INPUT": source, "DEM": str(scene.dem), "SKYLINES": skylines["OUTPUT"], "OUTPUT": "memory:"}
    results, _ = run("orientphotos", parameters)
    photo_layer.removeSelection()
    assert next(results["OUTPUT"].getFeatures())["heading"] == pytest.approx(200.0, abs=0.5)


def test_cancelling_leaves_nothing(run, scene, photo_layer, listener, tmp_path):
    target, report = tmp_path / "points.gpkg", tmp_path / "report.html"
    parameters = {"INPUT": photo_layer, "DEM": str(scene.dem), "OUTPUT": str(target), "REPORT": str(report)}
    feedback = listener(cancel_at=20)
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("orientphotos", parameters, feedback)
    assert list(tmp_path.iterdir()) == []
    assert any("Cancelled after 0 of 2" in warning for warning in feedback.warnings)


def test_progress_grows_and_names_the_photos(run, scene, photo_layer, listener):
    feedback = listener()
    run("orientphotos", {"INPUT": photo_layer, "DEM": str(scene.dem), "METHOD": 1, "OUTPUT": "memory:"}, feedback)
    assert feedback.fractions == sorted(feedback.fractions)
    assert any("north.jpg (1/2)" in text for text in feedback.texts)


def dem_copy(path, source, crs=True, void=False):
    from osgeo import gdal

    dataset = gdal.Translate(str(path), str(source), outputType=gdal.GDT_Float32)
    if not crs:
        dataset.SetProjection("")
    if void:
        dataset.GetRasterBand(1).SetNoDataValue(-9999)
        dataset.GetRasterBand(1).Fill(-9999)
    dataset.FlushCache()
    dataset = None
    return str(path)


def test_unusable_dems_stop_before_anything_runs(refusal, scene, photo_layer, tmp_path):
    without_crs = dem_copy(tmp_path / "no_crs.tif", scene.dem, crs=False)
    void = dem_copy(tmp_path / "void.tif", scene.dem, void=True)
    ask = {"INPUT": photo_layer, "OUTPUT": "memory:"}
    assert "coordinate" in refusal("orientphotos", {**ask, "DEM": without_crs})
    assert "no valid cell" in refusal("orientphotos", {**ask, "DEM": void})
    assert refusal("orientphotos", {**ask, "DEM": str(tmp_path / "nothing.tif")})
    assert refusal("orientphotos", {**ask, "DEM": str(scene.dem)}) == ""
    assert "band" in refusal("orientphotos", {**ask, "DEM": str(scene.dem), "BAND": 7}).lower()


def test_a_layer_that_cannot_serve_is_refused_before_anything_runs(refusal, scene):
    layer = points([("something", str)], [(scene.positions["west"], ["x"])])
    parameters = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:"}
    assert "no field" in refusal("orientphotos", parameters)
    assert "nonsense" in refusal("orientphotos", {**parameters, "PHOTO_FIELD": "something", "HFOV_FIELD": "nonsense"})
    lost = points([("photo", str)], [((7.0, 46.0), ["x"])])
    lost.setCrs(QgsCoordinateReferenceSystem())
    assert "no coordinate reference system" in refusal("orientphotos", {**parameters, "INPUT": lost})


def test_a_fault_of_our_own_costs_one_photo_and_is_logged(run, scene, photo_layer, monkeypatch):
    from skyline_viewshed.core import batch
    from skyline_viewshed.core.base.model import Orientation, OrientedPhoto

    def shaky(request, *others):
        if request.path.endswith("north.jpg"):
            raise ZeroDivisionError("a bug")
        return OrientedPhoto(request.path, Orientation("rejected", "fine"))

    monkeypatch.setattr(batch, "orient_request", shaky)
    results, feedback = run("orientphotos", {"INPUT": photo_layer, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    found = {f["filename"]: f for f in results["OUTPUT"].getFeatures()}
    assert found["north"]["status"] == "failed" and "report it" in found["north"]["message"]
    assert found["west"]["status"] == "rejected"
    assert any("ZeroDivisionError" in text for text in feedback.details)


def test_a_fault_of_the_dem_ends_the_batch(run, scene, photo_layer, monkeypatch):
    from skyline_viewshed.core import batch
    from skyline_viewshed.core.base.errors import UnusableDemError

    def broken(*arguments):
        raise UnusableDemError("The DEM is damaged.")

    monkeypatch.setattr(batch, "orient_request", broken)
    with pytest.raises(QgsProcessingException, match="damaged"):
        run("orientphotos", {"INPUT": photo_layer, "DEM": str(scene.dem), "OUTPUT": "memory:"})


def test_a_crs_assigned_in_qgis_counts(run, refusal, scene, photo_layer, tmp_path):
    from qgis.core import QgsRasterLayer

    bare = QgsRasterLayer(dem_copy(tmp_path / "no_crs.tif", scene.dem, crs=False), "dem")
    parameters = {"INPUT": photo_layer, "DEM": bare, "METHOD": 1, "OUTPUT": "memory:"}
    assert "coordinate" in refusal("orientphotos", parameters)
    bare.setCrs(QgsRasterLayer(str(scene.dem), "own").crs())
    assert refusal("orientphotos", parameters) == ""
    results, _ = run("orientphotos", parameters)
    assert [f["status"] for f in results["OUTPUT"].getFeatures()] == ["ambiguous"] * 2
