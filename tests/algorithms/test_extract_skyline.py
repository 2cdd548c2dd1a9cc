import numpy as np
import pytest


@pytest.fixture(scope="session")
def photos(provider, scene):
    import processing
    from qgis.core import QgsProject

    layer = processing.run("skylineviewshed:importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})["OUTPUT"]
    QgsProject.instance().addMapLayer(layer)
    return layer


def rows_of(results, name):
    found = [f for f in results["OUTPUT"].getFeatures() if f["photo"].endswith(name)]
    return np.array([[f["column"], f["row"], f["confidence"]] for f in found])


def test_parameters_are_the_contract(algorithm):
    it = algorithm("extractskyline")
    names = [definition.name() for definition in it.parameterDefinitions()]
    assert names == ["INPUT", "PHOTO_FIELD", "METHOD", "OUTPUT", "OVERLAYS", "WORKERS"]


@pytest.mark.parametrize(("method", "largest_px"), [(0, 3.0), (1, 60.0)])
def test_rows_are_pixels_of_the_full_picture(run, photos, scene, method, largest_px):
    from skyline_viewshed.core.base.camera import Camera, focal_of_fov_px
    from skyline_viewshed.core.base.overlay_lines import horizon_line
    from skyline_viewshed.core.base.terrain import Observer
    from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
    from skyline_viewshed.core.io.raster import open_dem

    results, _ = run("extractskyline", {"INPUT": photos, "METHOD": method, "OUTPUT": "memory:"})
    assert results["OUTPUT"].fields().names() == ["photo", "column", "row", "confidence"]
    found = rows_of(results, "west.jpg")
    column, row, confidence = found.T
    assert column.min() >= -0.5 and column.max() <= 799.5
    assert confidence.min() >= 0 and confidence.max() <= 1
    options = HorizonOptions(max_distance_m=30_000)
    profile = horizon_profile(open_dem(str(scene.dem)), Observer(*scene.positions["west"], 2.0), options)
    camera = Camera(800, 600, focal_of_fov_px(800, scene.hfov_deg))
    line = horizon_line(profile, camera, scene.truth["west"])
    known = np.isfinite(line.x_px) & np.isfinite(line.y_px)
    order = np.argsort(line.x_px[known])
    truth = np.interp(column, line.x_px[known][order], line.y_px[known][order])
    error = np.abs(row - truth)[confidence > 0]
    assert np.median(error) < largest_px


def test_overlays_are_pictures_named_like_the_photos(run, photos, tmp_path):
    run("extractskyline", {"INPUT": photos, "OUTPUT": "memory:", "OVERLAYS": str(tmp_path / "new")})
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == ["north.png", "west.png"]
    assert (tmp_path / "new" / "west.png").read_bytes().startswith(b"\x89PNG")


def test_a_bad_photo_is_named_and_the_batch_goes_on(run, scene):
    from qgis.core import QgsFeature, QgsVectorLayer

    layer = QgsVectorLayer("None?field=photo:string", "paths", "memory")
    for path in (scene.odd / "damaged.jpg", scene.folder / "west.jpg"):
        feature = QgsFeature(layer.fields())
        feature.setAttributes([str(path)])
        layer.dataProvider().addFeature(feature)
    results, feedback = run("extractskyline", {"INPUT": layer, "OUTPUT": "memory:"})
    assert results["COUNT"] == 1
    assert any("damaged.jpg" in warning for warning in feedback.warnings)
