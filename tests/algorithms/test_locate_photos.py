from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import QgsFeature, QgsField, QgsGeometry, QgsPointXY, QgsProcessingException, QgsVectorLayer
from qgis.PyQt.QtCore import QVariant

CONTRACT = [
    "photo", "rank", "heading", "pitch", "roll", "hfov", "vfov", "eye_z", "p_correct", "score", "semi_maj", "semi_min",
    "semi_az", "hfov_corr", "moved_m", "status", "message",
]  # fmt: skip


def away_m(geometry, position):
    point = geometry.asPoint()
    return (((point.x() - position[0]) * 76_500) ** 2 + ((point.y() - position[1]) * 111_195) ** 2) ** 0.5


def around(position, half_deg=0.03):
    x, y = position
    return f"{x - half_deg},{x + 0.7 * half_deg},{y - half_deg},{y + 0.6 * half_deg} [EPSG:4326]"


def layer_of(kind, wkts, fields=(), rows=None):
    layer = QgsVectorLayer(f"{kind}?crs=EPSG:4326", "layer", "memory")
    layer.dataProvider().addAttributes([QgsField(name, QVariant.String) for name in fields])
    layer.updateFields()
    for number, wkt in enumerate(wkts):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(wkt))
        feature.setAttributes(list(rows[number]) if rows else [])
        layer.dataProvider().addFeature(feature)
    return layer


@pytest.fixture(scope="module")
def setting(scene, tmp_path_factory):
    """What all searches of the scene have in common."""
    folder = tmp_path_factory.mktemp("index")
    common = {"DEM": str(scene.dem), "SPACING": 450.0, "MAX_DISTANCE": 15_000.0, "INDEX": str(folder)}
    return {**common, "OUTPUT": "memory:", "CANDIDATES": "memory:", "REGION": "memory:"}


@pytest.fixture(scope="module")
def located(provider, scene, setting, tmp_path_factory):
    """The photograph to the north, searched in some 20 km2 around its place."""
    import processing

    report = tmp_path_factory.mktemp("located") / "report.html"
    point = QgsGeometry.fromPointXY(QgsPointXY(*scene.positions["north"])).asWkt()
    layer = layer_of("Point", [point], ["photo"], [[str(scene.folder / "north.jpg")]])
    given = {"INPUT": layer, "EXTENT": around(scene.positions["north"]), "REPORT": str(report)}
    return processing.run("skylineviewshed:locatephotos", {**setting, **given})


def test_the_place_and_heading_are_those_of_the_scene(located, scene):
    (found,) = located["OUTPUT"].getFeatures()
    assert located["COUNT"] == 1
    assert away_m(found.geometry(), scene.positions["north"]) < 300, found["message"]
    assert found["heading"] == pytest.approx(scene.truth["north"].heading_deg, abs=2.0)
    assert found["moved_m"] == pytest.approx(away_m(found.geometry(), scene.positions["north"]), rel=0.05, abs=3)
    assert [field.name() for field in located["OUTPUT"].fields()] == CONTRACT
    assert found["status"] == ("accepted" if found["p_correct"] >= 0.85 else "ambiguous")


def test_candidates_are_ranked_and_the_region_holds_the_place(located, scene):
    ranks = [feature["rank"] for feature in located["CANDIDATES"].getFeatures()]
    scores = [feature["score"] for feature in located["CANDIDATES"].getFeatures()]
    assert ranks == list(range(1, len(ranks) + 1)) and scores == sorted(scores, reverse=True)
    (region,) = located["REGION"].getFeatures()
    place = QgsGeometry.fromPointXY(QgsPointXY(*scene.positions["north"]))
    assert region.geometry().distance(place) < 0.005
    assert 0 < region["area_km2"] < 20


def test_the_report_has_the_overlays_and_the_map(located):
    text = Path(located["REPORT"]).read_text(encoding="utf-8")
    assert text.rstrip().endswith("</html>") and "north.jpg" in text and text.count("data:image/") >= 3


def test_the_index_is_used_again_and_paths_narrow_the_search(located, run, scene, setting):
    (kept,) = Path(setting["INDEX"]).iterdir()
    before = kept.stat().st_mtime_ns
    x, y = scene.positions["north"]
    near = layer_of("LineString", [f"LineString({x - 0.02} {y}, {x + 0.015} {y})"])
    given = {"FOLDER": str(scene.folder), "EXTENT": around((x, y)), "PATHS": near, "PATH_DISTANCE": 400.0}
    results, feedback = run("locatephotos", {**setting, **given})
    assert kept.stat().st_mtime_ns == before
    assert len(list(Path(setting["INDEX"]).iterdir())) == 2
    found = {Path(feature["photo"]).name: feature for feature in results["OUTPUT"].getFeatures()}
    assert away_m(found["north.jpg"].geometry(), (x, y)) < 400
    places = [text for text in feedback.infos if "places are searched" in text]
    assert len(places) == 1 and int(places[0].split()[0]) < 60


def test_a_raster_of_weights_excludes_places(run, scene, setting, tmp_path):
    x, y = scene.positions["north"]
    path = str(tmp_path / "weights.tif")
    file = gdal.GetDriverByName("GTiff").Create(path, 2, 1, 1, gdal.GDT_Float32)
    file.SetGeoTransform((x - 0.04, 0.035, 0, y + 0.04, 0, -0.08))  # the place lies in the western half, excluded
    file.SetProjection('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
                       'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]]')  # fmt: skip
    import numpy as np

    file.GetRasterBand(1).WriteArray(np.array([[1.0, 0.0]], np.float32))
    file = None
    folder = tmp_path / "one"
    folder.mkdir()
    (folder / "north.jpg").write_bytes((scene.folder / "north.jpg").read_bytes())
    given = {"FOLDER": str(folder), "EXTENT": around((x, y)), "WEIGHTS": path}
    results, _ = run("locatephotos", {**setting, **given})
    places = [feature.geometry().asPoint().x() for feature in results["CANDIDATES"].getFeatures()]
    assert places and max(places) < x - 0.001


def test_bad_photographs_fail_with_a_sentence_and_the_others_go_on(run, scene, setting):
    given = {"FOLDER": str(scene.odd), "RADIUS": 1_500.0}
    results, feedback = run("locatephotos", {**setting, **given})
    found = {Path(feature["photo"]).name: feature for feature in results["OUTPUT"].getFeatures()}
    assert found["no_gps.jpg"]["status"] == "failed" and "search around" in found["no_gps.jpg"]["message"]
    assert found["damaged.jpg"]["status"] == "failed" and found["empty.heic"]["status"] == "failed"
    assert found["no_focal.jpg"]["status"] in ("accepted", "ambiguous", "rejected")
    assert results["COUNT"] == len(found)
    assert any("no_gps.jpg" in warning for warning in feedback.warnings)


def test_around_recorded_positions_a_photo_with_a_bad_one_fails_alone(run, scene, setting):
    x, y = scene.positions["north"]
    path = str(scene.folder / "north.jpg")
    points = [f"Point({x} {y})", "Point(30 10)", "Point(0 0)", f"Point({x} {y})"]
    layer = layer_of("Point", points, ["photo"], [[path], [path], [path], [None]])
    results, feedback = run("locatephotos", {**setting, "INPUT": layer, "RADIUS": 1_000.0})
    good, outside, nowhere, pathless = results["OUTPUT"].getFeatures()
    assert away_m(good.geometry(), (x, y)) < 400 and good["status"] in ("accepted", "ambiguous")
    assert outside["status"] == "failed" and "lies inside the DEM" in outside["message"]
    assert nowhere["status"] == "failed" and "search around" in nowhere["message"]
    assert pathless["status"] == "failed" and "names no photo" in pathless["message"]
    assert results["COUNT"] == 4 and len(feedback.warnings) >= 3


def test_paths_that_are_far_from_one_photo_fail_it_alone(run, scene, setting):
    x, y = scene.positions["north"]
    near = layer_of("LineString", [f"LineString({x - 0.02} {y}, {x + 0.015} {y})"])
    given = {"FOLDER": str(scene.folder), "RADIUS": 1_000.0, "PATHS": near, "PATH_DISTANCE": 400.0}
    results, _ = run("locatephotos", {**setting, **given})
    found = {Path(feature["photo"]).name: feature for feature in results["OUTPUT"].getFeatures()}
    assert found["west.jpg"]["status"] == "failed" and "area is empty" in found["west.jpg"]["message"]
    assert found["north.jpg"]["status"] != "failed"


def test_unusable_areas_are_refused(refusal, run, scene, setting):
    given = {"FOLDER": str(scene.folder), "DEM": str(scene.dem), "OUTPUT": "memory:"}
    none = {"CANDIDATES": None, "REGION": None, "REPORT": None}
    assert "Choose where to search" in refusal("locatephotos", {**given, **none})
    with pytest.raises(QgsProcessingException, match="lies inside the DEM"):
        run("locatephotos", {**setting, **given, "EXTENT": "20,20.1,10,10.1 [EPSG:4326]"})
    tight = {**setting, **given, "INDEX": None, "MEMORY": 1.0, "SPACING": 150.0}
    with pytest.raises(QgsProcessingException, match="at most .* km2"):
        run("locatephotos", {**tight, "EXTENT": around(scene.positions["north"], 0.08)})
