import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsVectorLayer
from skyline_viewshed.core.io.photo import read_metadata


def pose_layer(scene, rows):
    layer = QgsVectorLayer(
        "Point?crs=EPSG:4326&field=name:string&field=heading:double&field=pitch:double&field=hfov:double", "p", "memory"
    )
    for name, heading, pitch, hfov in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*scene.positions["west"])))
        feature.setAttributes([name, heading, pitch, hfov])
        layer.dataProvider().addFeature(feature)
    return layer


def test_parameters_are_the_contract(algorithm):
    it = algorithm("simulatephotos")
    names = [definition.name() for definition in it.parameterDefinitions()]
    assert names[:2] == ["INPUT", "DEM"] and names[-1] == "FOLDER"
    assert {"WIDTH", "HEIGHT", "HEADING_FIELD", "PITCH_FIELD", "ROLL_FIELD", "HFOV_FIELD", "SEED"} <= set(names)


def test_photos_say_where_they_look(run, scene, tmp_path):
    layer = pose_layer(scene, [("east", 90.0, 2.0, 60.0), ("east", 95.0, None, None), ("blind", None, 0.0, 60.0)])
    parameters = {"INPUT": layer, "DEM": str(scene.dem), "WIDTH": 160, "HEIGHT": 120, "FOLDER": str(tmp_path / "out")}
    results, feedback = run("simulatephotos", parameters)
    assert results["COUNT"] == 2
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["east.jpg", "east_2.jpg"]
    metadata = read_metadata(tmp_path / "out" / "east.jpg")
    assert (metadata.width_px, metadata.height_px) == (160, 120)
    assert metadata.compass_heading_deg == pytest.approx(90.0)
    assert metadata.longitude_deg == pytest.approx(scene.positions["west"][0], abs=1e-7)
    assert any("blind" in warning for warning in feedback.warnings)


def test_the_same_seed_gives_the_same_picture(run, scene, tmp_path):
    layer = pose_layer(scene, [("one", 90.0, 2.0, 60.0)])
    pictures = []
    for folder, seed in (("a", 3), ("b", 3), ("c", 4)):
        parameters = {"INPUT": layer, "DEM": str(scene.dem), "WIDTH": 128, "HEIGHT": 96, "SEED": seed}
        run("simulatephotos", {**parameters, "FOLDER": str(tmp_path / folder)})
        pictures.append((tmp_path / folder / "one.jpg").read_bytes())
    assert pictures[0] == pictures[1] != pictures[2]
