import pytest
from qgis.core import QgsFeature, QgsField, QgsGeometry, QgsPointXY, QgsVectorLayer
from qgis.PyQt.QtCore import QVariant

FIELDS = ["verdict", "dx", "dy", "gain", "semi_maj", "semi_min", "semi_az", "heading", "p_correct", "message"]


@pytest.fixture(scope="module")
def checked(provider, scene):
    """One photograph at its place, the same one shifted to the east, and one that is missing."""
    import processing

    layer = QgsVectorLayer("Point?crs=EPSG:4326", "photos", "memory")
    layer.dataProvider().addAttributes([QgsField("photo", QVariant.String)])
    layer.updateFields()
    x, y = scene.positions["north"]
    rows = ((0.0, "north.jpg"), (0.0045, "north.jpg"), (0.0, "missing.jpg"))
    for shift, name in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(x + shift, y)))
        feature.setAttributes([str(scene.folder / name)])
        layer.dataProvider().addFeature(feature)
    given = {"INPUT": layer, "DEM": str(scene.dem), "MAX_DISTANCE": 15_000.0, "OUTPUT": "memory:"}
    results = processing.run("skylineviewshed:positioncheck", given)
    return results, list(results["OUTPUT"].getFeatures())


def test_a_true_position_is_believable(checked):
    true = checked[1][0]
    assert true["verdict"] == "believable", true["message"]
    assert true["gain"] < 0.5


def test_a_shifted_position_is_doubted_and_the_way_back_is_given(checked, scene):
    shifted = checked[1][1]
    assert shifted["verdict"] == "doubtful", shifted["message"]
    assert shifted["dx"] == pytest.approx(-0.0045 * 76_500, abs=130) and abs(shifted["dy"]) < 130
    assert shifted["gain"] >= 0.5
    # It is reported and never applied.
    assert shifted.geometry().asPoint().x() == pytest.approx(scene.positions["north"][0] + 0.0045)
    assert checked[0]["DOUBTFUL"] == 1


def test_the_range_and_the_refraction_hold_for_the_orientation_too(algorithm):
    from qgis.core import QgsProcessingContext

    given = {"MAX_DISTANCE": 15_000.0, "REFRACTION": 0.2, "RADIUS": 300.0, "EYE_HEIGHT": 4.0}
    options = algorithm("positioncheck")._options(given, QgsProcessingContext())
    for horizon in (options.orient.horizon, options.locate.horizon):
        assert (horizon.max_distance_m, horizon.refraction_coefficient) == (15_000.0, 0.2)
    assert options.radius_m == 300.0 and options.locate.index.eye_height_m == 4.0


def test_a_missing_photograph_fails_alone(checked):
    missing = checked[1][2]
    assert missing["verdict"] == "failed" and "cannot be read" in missing["message"]
    assert checked[0]["COUNT"] == 3
    assert [name for name in checked[0]["OUTPUT"].fields().names() if name != "photo"] == FIELDS
