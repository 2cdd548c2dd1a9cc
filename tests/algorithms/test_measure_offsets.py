import pytest
from qgis.core import QgsFeature, QgsProcessingException, QgsVectorLayer

NAMES = ("x_extracted", "y_extracted", "x_synthetic", "y_synthetic")


def table(rows, names=NAMES, extra=()):
    fields = "&".join(["field=photo:string", *(f"field={name}:double" for name in (*names, *extra))])
    layer = QgsVectorLayer(f"None?{fields}", "pairs", "memory")
    for row in rows:
        feature = QgsFeature(layer.fields())
        feature.setAttributes(list(row))
        layer.dataProvider().addFeature(feature)
    return layer


FRAME = ("width", "height", "hfov", "vfov")


def test_parameters_are_the_contract(algorithm):
    it = algorithm("measureoffsets")
    names = [definition.name() for definition in it.parameterDefinitions()]
    assert names[0] == "INPUT" and names[-1] == "OUTPUT"


def test_equation_10_by_hand(run):
    frame = (1000, 500, 60.0, 30.0)
    rows = [("a", 100, 200, 150, 190, *frame), ("a", 300, 100, 290, 105, *frame), ("b", 0, 0, 0, 50, *frame)]
    results, feedback = run("measureoffsets", {"INPUT": table(rows, extra=FRAME), "OUTPUT": "memory:"})
    lines = {f["photo"]: f for f in results["OUTPUT"].getFeatures()}
    assert lines["a"]["pairs"] == 2
    assert lines["a"]["d_az"] == pytest.approx((3.0 + 0.6) / 2)
    assert lines["a"]["bias_az"] == pytest.approx((3.0 - 0.6) / 2)
    assert lines["b"]["d_el"] == pytest.approx(3.0) and lines["b"]["bias_el"] == pytest.approx(-3.0)
    assert results["MEAN_AZIMUTH"] == pytest.approx((3.0 + 0.6 + 0.0) / 3)
    assert results["PAIRS"] == 3
    assert any("all pairs" in info for info in feedback.infos)


def test_size_and_view_come_from_the_file(run, scene):
    rows = [(str(scene.folder / "west.jpg"), 100, 200, 140, 200)]
    results, _ = run("measureoffsets", {"INPUT": table(rows), "OUTPUT": "memory:"})
    from skyline_viewshed.core.paper.method import paper_fov_deg

    assert results["MEAN_AZIMUTH"] == pytest.approx(40 / 800 * paper_fov_deg(800, 600, 28.0)[0])


def test_a_table_without_the_columns_is_refused_with_their_names(run):
    layer = table([("a", 1, 2, 3, 4)], names=("p", "q", "r", "s"))
    with pytest.raises(QgsProcessingException, match="x_extracted"):
        run("measureoffsets", {"INPUT": layer, "OUTPUT": "memory:"})
    chosen = dict(zip(("X_EXTRACTED", "Y_EXTRACTED", "X_SYNTHETIC", "Y_SYNTHETIC"), "pqrs"))
    with pytest.raises(QgsProcessingException, match="cannot be read"):
        run("measureoffsets", {"INPUT": layer, "OUTPUT": "memory:", **chosen})


def test_an_empty_table_is_refused(run):
    with pytest.raises(QgsProcessingException, match="no complete pair"):
        run("measureoffsets", {"INPUT": table([("a", 1, None, 3, 4)]), "OUTPUT": "memory:"})
