import numpy as np
import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsVectorLayer
from skyline_viewshed.core.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.terrain import Observer


def point_layer(points, crs="EPSG:4326"):
    layer = QgsVectorLayer(f"Point?crs={crs}&field=id:integer", "points", "memory")
    for number, (x, y) in enumerate(points):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(x, y)))
        feature.setAttributes([number])
        layer.dataProvider().addFeature(feature)
    return layer


def test_parameters_are_the_contract(algorithm):
    it = algorithm("horizonprofile")
    names = [definition.name() for definition in it.parameterDefinitions()]
    assert names == [
        "INPUT", "DEM", "BAND", "EYE_HEIGHT", "MAX_DISTANCE", "AZIMUTH_STEP", "REFRACTION", "OUTPUT", "REPORT",
    ]  # fmt: skip


def test_points_lie_where_the_core_s_horizon_has_them(run, scene, tmp_path):
    place = scene.positions["west"]
    parameters = {"INPUT": point_layer([place]), "DEM": str(scene.dem), "MAX_DISTANCE": 20_000, "AZIMUTH_STEP": 5}
    report = tmp_path / "horizon.html"
    results, _ = run("horizonprofile", {**parameters, "OUTPUT": "memory:", "REPORT": str(report)})
    found = list(results["OUTPUT"].getFeatures())
    options = HorizonOptions(azimuth_step_deg=5, max_distance_m=20_000)
    dem = open_dem(str(scene.dem))
    expected = horizon_profile(dem, Observer(*place, 1.7), options)
    assert [f["azimuth"] for f in found] == list(expected.azimuth_deg)
    np.testing.assert_allclose([f["elevation"] for f in found], expected.elevation_deg, atol=1e-9)
    np.testing.assert_array_equal([f["clipped"] for f in found], expected.clipped)
    frame = dem.frame(*place, 25_000.0)
    for feature, azimuth, distance in zip(found, expected.azimuth_deg, expected.distance_m):
        point = feature.geometry().asPoint()
        east, north = frame.to_local(*dem.pixel_of(point.x(), point.y()))
        assert np.hypot(east, north) == pytest.approx(distance, abs=2.0)
        assert (np.degrees(np.arctan2(east, north)) - azimuth + 180) % 360 - 180 == pytest.approx(0.0, abs=0.1)
    assert 0 < found[0]["svf"] < 1
    text = report.read_text(encoding="utf-8")
    assert "<svg" in text and text.rstrip().endswith("</html>")


def test_a_point_outside_the_dem_is_named_and_the_others_go_on(run, scene):
    lon, lat = scene.positions["west"]
    layer = point_layer([(lon + 5, lat), (lon, lat)])
    parameters = {"INPUT": layer, "DEM": str(scene.dem), "MAX_DISTANCE": 5000, "AZIMUTH_STEP": 30, "OUTPUT": "memory:"}
    results, feedback = run("horizonprofile", parameters)
    assert results["COUNT"] == 1 and results["OUTPUT"].featureCount() == 12
    assert any("outside the DEM" in warning for warning in feedback.warnings)


@pytest.mark.data
def test_any_dem_will_do(run, shared_data):
    """Polar, geographic HGT with voids, Web Mercator with oblong cells, the southern hemisphere."""
    from osgeo import gdal, osr

    for name in ("vestfold_epsg3031_32m.tif", "N43E007.hgt", "N43E006_3857.tiff", "S33W071.tif"):
        path = shared_data / "dem" / name
        dataset = gdal.Open(str(path))
        transform = dataset.GetGeoTransform()
        reference = dataset.GetSpatialRef()
        reference.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        values = dataset.ReadAsArray()
        # A cell with a sensible height near the middle of the valid part.
        row, col = np.nonzero((values > 20) & (values < 7000))
        pick = len(row) // 2
        x = transform[0] + (col[pick] + 0.5) * transform[1]
        y = transform[3] + (row[pick] + 0.5) * transform[5]
        crs = reference.ExportToWkt()
        layer = QgsVectorLayer("Point?field=id:integer", "points", "memory")
        from qgis.core import QgsCoordinateReferenceSystem

        layer.setCrs(QgsCoordinateReferenceSystem.fromWkt(crs))
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(x, y)))
        feature.setAttributes([1])
        layer.dataProvider().addFeature(feature)
        parameters = {"INPUT": layer, "DEM": str(path), "MAX_DISTANCE": 8000, "AZIMUTH_STEP": 15, "OUTPUT": "memory:"}
        results, feedback = run("horizonprofile", parameters)
        angles = [f["elevation"] for f in results["OUTPUT"].getFeatures()]
        assert results["COUNT"] == 1, (name, feedback.warnings)
        known = [angle for angle in angles if angle is not None and not hasattr(angle, "isNull")]
        assert len(known) >= 12 and -30 < min(known) < max(known) < 70, name
