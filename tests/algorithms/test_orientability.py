from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer


def layer_of(kind, wkt):
    layer = QgsVectorLayer(f"{kind}?crs=EPSG:4326", "places", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromWkt(wkt))
    layer.dataProvider().addFeature(feature)
    return layer


def test_points_get_a_probability_for_each_field_of_view_and_a_rose(run, scene, tmp_path):
    x, y = scene.positions["north"]
    report = tmp_path / "roses.html"
    given = {"INPUT": layer_of("Point", f"Point({x} {y})"), "DEM": str(scene.dem), "HFOVS": "20, 60"}
    given.update(MAX_DISTANCE=15_000.0, OUTPUT="memory:", REPORT=str(report))
    results, _ = run("orientability", given)
    narrow, wide = results["OUTPUT"].getFeatures()
    assert (narrow["hfov"], wide["hfov"]) == (20, 60) and results["COUNT"] == 1
    assert 0 <= narrow["p_mean"] <= wide["p_mean"] <= 1
    assert wide["error_deg"] < narrow["error_deg"] + 0.5
    assert all(0 <= wide[f"p_{name}"] <= 1 for name in ("n", "ne", "e", "se", "s", "sw", "w", "nw"))
    text = report.read_text(encoding="utf-8")
    assert text.rstrip().endswith("</html>") and text.count("<svg") >= 3


def test_lines_give_places_at_the_step(run, scene):
    x, y = scene.positions["north"]
    line = layer_of("LineString", f"LineString({x} {y}, {x + 0.013} {y})")
    given = {"INPUT": line, "STEP": 500.0, "DEM": str(scene.dem), "HFOVS": "50", "MAX_DISTANCE": 8_000.0}
    results, _ = run("orientability", {**given, "OUTPUT": "memory:"})
    places = [feature.geometry().asPoint().x() for feature in results["OUTPUT"].getFeatures()]
    assert len(places) == 3 and places[0] == pytest.approx(x, abs=1e-6) and places[-1] == pytest.approx(x + 0.013)


def test_a_raster_has_a_band_for_each_direction(run, scene, tmp_path):
    x, y = scene.positions["north"]
    path = str(tmp_path / "raster.tif")
    given = {"DEM": str(scene.dem), "EXTENT": f"{x},{x + 0.03},{y},{y + 0.02} [EPSG:4326]", "CELL": 750.0}
    results, _ = run("orientability", {**given, "HFOVS": "50", "MAX_DISTANCE": 8_000.0, "RASTER": path})
    file = gdal.Open(results["RASTER"])
    assert file.RasterCount == 10 and file.GetRasterBand(2).GetDescription() == "N"
    mean = file.GetRasterBand(1).ReadAsArray()
    known = mean != file.GetRasterBand(1).GetNoDataValue()
    assert known.any() and (mean[known] >= 0).all() and (mean[known] <= 1).all()
    assert file.GetGeoTransform()[1] == pytest.approx(750.0)
    assert np.isfinite(mean).all() and Path(path).exists()


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({}, "Choose places"),
        ({"RASTER": "x.tif"}, "Choose the extent"),
        ({"HFOVS": "wide"}, "between 5 and 120"),
        ({"HFOVS": "200"}, "between 5 and 120"),
    ],
)
def test_unusable_input_is_refused(refusal, scene, given, sentence):
    place = {} if not given or "RASTER" in given else {"INPUT": layer_of("Point", "Point(8 46.5)")}
    assert sentence in refusal("orientability", {"DEM": str(scene.dem), "OUTPUT": "memory:", **place, **given})
