import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer


def place_of(scene):
    layer = QgsVectorLayer("Point?crs=EPSG:4326", "places", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromWkt("Point({} {})".format(*scene.positions["north"])))
    layer.dataProvider().addFeature(feature)
    return layer


def test_photographs_are_simulated_and_judged(run, scene, tmp_path):
    report = tmp_path / "report.html"
    given = {"INPUT": place_of(scene), "DEM": str(scene.dem), "PHOTOS": 2, "WEATHER": 0, "OUTPUT": "memory:"}
    results, feedback = run("expectedaccuracy", {**given, "REPORT": str(report)})
    rows = list(results["OUTPUT"].getFeatures())
    assert len(rows) == results["COUNT"] == 2
    assert 0 <= results["WITHIN_1"] <= results["WITHIN_3"] <= 1 and results["WRONG"] <= results["ACCEPTED"] <= 2
    for row in rows:
        assert 40 <= row["hfov"] <= 70.1 and 0 <= row["predicted"] <= 1
        away = (row["heading"] - row["true_head"] + 180) % 360 - 180
        assert row["error_deg"] == pytest.approx(away, abs=1e-6)
    assert any("photographs:" in text for text in feedback.infos)
    assert report.read_text(encoding="utf-8").rstrip().endswith("</html>")


def test_the_fields_of_view_must_be_in_order(refusal, scene):
    given = {"INPUT": place_of(scene), "DEM": str(scene.dem), "HFOV_MIN": 60.0, "HFOV_MAX": 40.0}
    assert "must not be wider" in refusal("expectedaccuracy", {**given, "OUTPUT": "memory:"})
