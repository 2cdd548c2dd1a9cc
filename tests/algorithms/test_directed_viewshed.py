import numpy as np
import pytest
from osgeo import gdal
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingException,
    QgsProject,
    QgsVectorLayer,
)
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, in_frame, project
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.io.raster import open_dem

FIELDS = "&".join(f"field={name}:double" for name in ("heading", "pitch", "roll", "hfov", "vfov"))


def oriented_layer(scene, names=("north", "west"), crs="EPSG:4326", **changes):
    """Oriented points at the scene's positions; `changes` overrides attributes (None is NULL)."""
    layer = QgsVectorLayer(f"Point?crs={crs}&field=photo:string&{FIELDS}", "oriented", "memory")
    to_crs = QgsCoordinateTransform(
        QgsCoordinateReferenceSystem("EPSG:4326"), QgsCoordinateReferenceSystem(crs), QgsProject.instance()
    )
    for name in names:
        pose = scene.truth[name]
        values = {"photo": f"{name}.jpg", "heading": pose.heading_deg, "pitch": pose.pitch_deg}
        values = {**values, "roll": pose.roll_deg, "hfov": scene.hfov_deg, "vfov": 49.7, **changes}
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(to_crs.transform(QgsPointXY(*scene.positions[name]))))
        feature.setAttributes([values[field.name()] for field in layer.fields()])
        layer.dataProvider().addFeature(feature)
    return layer


def cells(path):
    dataset = gdal.Open(str(path))
    return dataset.ReadAsArray(), dataset.GetGeoTransform()


@pytest.fixture
def call(run, scene, tmp_path):
    def go(layer, feedback=None, **parameters):
        target = tmp_path / f"viewshed_{len(list(tmp_path.iterdir()))}.tif"
        given = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": str(target), "POLYGONS": "memory:"}
        results, feedback = run("directedviewshed", {**given, **parameters}, feedback)
        return results, feedback

    return go


def test_parameters_are_the_contract(algorithm):
    it = algorithm("directedviewshed")
    names = {definition.name() for definition in it.parameterDefinitions()}
    wanted = (
        "INPUT DEM BAND HEADING_FIELD HFOV_FIELD PITCH_FIELD ROLL_FIELD VFOV_FIELD SECTOR EYE_HEIGHT TARGET_HEIGHT "
    )
    wanted += "MIN_DISTANCE MAX_DISTANCE REFRACTION OUTPUT POLYGONS RASTERS"
    assert set(wanted.split()) <= names
    sector = it.parameterDefinition("SECTOR")
    assert sector.options() == ["photo frame", "heading wedge", "full circle"] and sector.defaultValue() == 0


def test_the_raster_lies_on_the_dem_s_grid(call, scene):
    results, _ = call(oriented_layer(scene), MAX_DISTANCE=8000)
    values, transform = cells(results["OUTPUT"])
    dem_values, dem_transform = cells(scene.dem)
    assert values.shape == dem_values.shape and transform == dem_transform
    assert set(np.unique(values)) <= {0, 1, 2} and (values > 0).sum() > 50


def test_all_that_is_claimed_lies_in_the_picture(call, scene):
    results, _ = call(oriented_layer(scene, ["west"]), MAX_DISTANCE=10_000)
    values, _ = cells(results["OUTPUT"])
    dem = open_dem(str(scene.dem))
    longitude, latitude = scene.positions["west"]
    frame = dem.frame(longitude, latitude, 20_000.0)
    row, col = np.nonzero(values == 1)
    east, north = frame.to_local(col, row)
    elevation = dem.read(Window(0, 0, *dem.shape))
    eye = elevation[240, 86] + 1.7
    distance = np.hypot(east, north)
    rise = elevation[row, col] - eye - 0.87 * distance**2 / (2 * 6_371_000.0)
    camera = Camera(800, 600, focal_of_fov_px(800, scene.hfov_deg))
    pose = Pose(scene.truth["west"].heading_deg, scene.truth["west"].pitch_deg, scene.truth["west"].roll_deg)
    x, y = project(camera, pose, np.degrees(np.arctan2(east, north)), np.degrees(np.arctan2(rise, distance)))
    margin = 8.0  # the eye's ground lies between cells
    near = in_frame(camera, x, y)
    slack = (x > -margin) & (x < 799 + margin) & (y > -margin) & (y < 599 + margin)
    assert slack.all() and near.mean() > 0.97


def test_frame_and_wedge_lie_in_the_circle(call, scene):
    layer = oriented_layer(scene, ["west"])
    frame, wedge, circle = (cells(call(layer, SECTOR=kind, MAX_DISTANCE=6000)[0]["OUTPUT"])[0] for kind in range(3))
    assert ((frame == 1) <= (circle == 1)).all() and ((wedge == 1) <= (circle == 1)).all()
    assert 0 < (frame == 1).sum() < (circle == 1).sum() and 0 < (wedge == 1).sum() < (circle == 1).sum()
    assert ((frame == 1) & (wedge == 1)).sum() > 0.9 * (frame == 1).sum()


def test_polygons_tell_the_raster_s_area_and_reach(call, scene, tmp_path):
    rasters = tmp_path / "each"
    results, _ = call(oriented_layer(scene), MAX_DISTANCE=8000, RASTERS=str(rasters))
    found = list(results["POLYGONS"].getFeatures())
    assert [f["photo"] for f in found] == ["north.jpg", "west.jpg"] and results["COUNT"] == 2
    for feature in found:
        own = gdal.Open(str(rasters / feature["photo"].replace(".jpg", ".tif")))
        seen = (own.ReadAsArray() == 1).sum()
        assert feature.geometry().isGeosValid()
        assert feature.geometry().area() == pytest.approx(seen * 75.0**2, rel=0.02)  # outlines are simplified
        assert feature["area_m2"] == pytest.approx(seen * 75.0**2, rel=1e-3)
        assert 500 < feature["farthest_m"] <= 8000 + 110


def test_points_in_another_crs_give_the_same_ground(call, scene):
    plain = call(oriented_layer(scene, ["west"]), MAX_DISTANCE=6000)[0]
    utm = call(oriented_layer(scene, ["west"], "EPSG:32632"), MAX_DISTANCE=6000)[0]
    np.testing.assert_array_equal(cells(plain["OUTPUT"])[0], cells(utm["OUTPUT"])[0])


def test_distances_are_kept(call, scene):
    results, _ = call(oriented_layer(scene, ["west"]), SECTOR=2, MIN_DISTANCE=2000, MAX_DISTANCE=4000)
    values, _ = cells(results["OUTPUT"])
    dem = open_dem(str(scene.dem))
    row, col = np.nonzero(values == 1)
    distance = np.hypot(*dem.frame(*scene.positions["west"], 10_000.0).to_local(col, row))
    assert distance.min() >= 1999 and distance.max() <= 4001


def test_without_pitch_the_wedge_stands_in_and_says_so(call, scene):
    results, feedback = call(oriented_layer(scene, ["west"], pitch=None), MAX_DISTANCE=5000)
    wedge, _ = call(oriented_layer(scene, ["west"]), SECTOR=1, MAX_DISTANCE=5000)
    np.testing.assert_array_equal(cells(results["OUTPUT"])[0], cells(wedge["OUTPUT"])[0])
    assert any("heading wedge" in warning for warning in feedback.warnings)


@pytest.mark.parametrize(
    ("changes", "words"), [({"heading": None}, "heading"), ({"hfov": None}, "field of view"), ({"hfov": 200.0}, "180")]
)
def test_points_without_enough_knowledge_are_left_out_and_named(call, scene, changes, words):
    results, feedback = call(oriented_layer(scene, ["west"], **changes), MAX_DISTANCE=5000)
    assert results["COUNT"] == 0
    assert any("west.jpg" in warning and words in warning for warning in feedback.warnings)
    assert not (cells(results["OUTPUT"])[0] == 1).any()


def test_senseless_distances_are_refused(refusal, scene):
    parameters = {"INPUT": oriented_layer(scene), "DEM": str(scene.dem), "OUTPUT": "TEMPORARY_OUTPUT"}
    assert "smaller" in refusal("directedviewshed", {**parameters, "MIN_DISTANCE": 5000, "MAX_DISTANCE": 1000})


def test_a_missing_field_is_named(refusal, scene, tmp_path):
    parameters = {"INPUT": oriented_layer(scene), "DEM": str(scene.dem), "OUTPUT": str(tmp_path / "v.tif")}
    assert "nonsense" in refusal("directedviewshed", {**parameters, "HEADING_FIELD": "nonsense"})
    bare = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string", "bare", "memory")
    assert "no heading" in refusal("directedviewshed", {**parameters, "INPUT": bare})
    assert refusal("directedviewshed", {**parameters, "INPUT": bare, "SECTOR": 2}) == ""


def test_cancelling_leaves_nothing(run, scene, listener, tmp_path):
    target, polygons = tmp_path / "v.tif", tmp_path / "p.gpkg"
    parameters = {
        "INPUT": oriented_layer(scene),
        "DEM": str(scene.dem),
        "OUTPUT": str(target),
        "POLYGONS": str(polygons),
    }
    for percent in (10, 60):
        with pytest.raises(QgsProcessingException, match="Cancelled"):
            run("directedviewshed", parameters, listener(cancel_at=percent))
        assert list(tmp_path.iterdir()) == []


def test_a_repeated_run_takes_what_an_earlier_one_has_finished(call, scene, tmp_path):
    rasters = tmp_path / "each"
    layer = oriented_layer(scene)
    first, _ = call(layer, MAX_DISTANCE=6000, RASTERS=str(rasters))
    (rasters / "west.tif").unlink()  # as if the run had been killed before the second photo
    stamp = (rasters / "north.tif").stat().st_mtime_ns
    second, feedback = call(layer, MAX_DISTANCE=6000, RASTERS=str(rasters))
    assert any("north.jpg: taken from" in info for info in feedback.infos)
    assert not any("west.jpg: taken from" in info for info in feedback.infos)
    assert (rasters / "north.tif").stat().st_mtime_ns == stamp and (rasters / "west.tif").exists()
    np.testing.assert_array_equal(cells(first["OUTPUT"])[0], cells(second["OUTPUT"])[0])
    areas = [[f["area_m2"] for f in results["POLYGONS"].getFeatures()] for results in (first, second)]
    assert areas[0] == pytest.approx(areas[1])
    _, feedback = call(layer, MAX_DISTANCE=5000, RASTERS=str(rasters))
    assert not any("taken from" in info for info in feedback.infos)
