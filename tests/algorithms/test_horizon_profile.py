import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsProcessingException, QgsRectangle, QgsVectorLayer
from skyline_viewshed.core.base.terrain import Observer, Window
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.io.raster import open_dem


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
    definitions = it.parameterDefinitions()
    assert [definition.name() for definition in definitions[:10]] == [
        "INPUT", "DEM", "BAND", "DEM_UNIT", "EYE_HEIGHT", "MAX_DISTANCE", "AZIMUTH_STEP", "REFRACTION",
        "OUTPUT", "REPORT",
    ]  # fmt: skip
    flags = [definition.flags() & definition.Flag.FlagAdvanced for definition in definitions[10:]]
    assert all(flags) and [definition.name() for definition in definitions[10:]] == [
        "SKY_VIEW_EXTENT", "SKY_VIEW_DISTANCE", "SKY_VIEW",
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


class TestSkyView:
    @pytest.fixture
    def ask(self, scene, tmp_path):
        """Parameters for a raster of a part of the scene's DEM, which lies around (0, 0) of its own plane."""
        given = {"INPUT": point_layer([scene.positions["west"]]), "DEM": str(scene.dem), "OUTPUT": "memory:"}
        return {**given, "AZIMUTH_STEP": 5, "MAX_DISTANCE": 5000, "SKY_VIEW": str(tmp_path / "sky.tif")}

    def raster(self, run, ask, **changes):
        results, feedback = run("horizonprofile", {**ask, **changes})
        return gdal.Open(results["SKY_VIEW"]), feedback

    def test_cells_have_the_factor_of_their_own_horizon_and_slope(self, run, scene, ask):
        extent = QgsRectangle(-3000, -1500, 1500, 4000)
        dataset, feedback = self.raster(run, ask, SKY_VIEW_EXTENT=extent, SKY_VIEW_DISTANCE=6000)
        assert (dataset.RasterXSize, dataset.RasterYSize) == (60, 74) and sorted(feedback.fractions)[-1] >= 95
        assert feedback.fractions == sorted(feedback.fractions)
        sky, transform, dem = dataset.ReadAsArray(), dataset.GetGeoTransform(), open_dem(str(scene.dem))
        col0 = round((transform[0] - dem.geotransform[0]) / 75)
        row0 = round((transform[3] - dem.geotransform[3]) / -75)
        cells = dem.read(Window(0, 0, *dem.shape)).astype(float)
        for row, col in ((5, 7), (40, 30), (70, 55)):
            r, c = row + row0, col + col0
            place = Observer(*map(float, dem.position_of(c, r)), eye_elevation_m=cells[r, c])
            profile = horizon_profile(dem, place, HorizonOptions(azimuth_step_deg=1, max_distance_m=6000))
            # The definition as a sum over the hemisphere's patches, weighted by the cosine of incidence.
            east, north = (cells[r, c + 1] - cells[r, c - 1]) / 150, (cells[r - 1, c] - cells[r + 1, c]) / 150
            phi, angle = np.meshgrid(
                np.radians(profile.azimuth_deg), np.radians(np.arange(0.25, 90, 0.5)), indexing="ij"
            )
            normal = np.array([-east, -north, 1.0]) / np.sqrt(east**2 + north**2 + 1)
            toward = np.stack([np.cos(angle) * np.sin(phi), np.cos(angle) * np.cos(phi), np.sin(angle)])
            incidence = np.tensordot(normal, toward, 1)
            lit = (angle > np.radians(np.maximum(profile.elevation_deg, 0))[:, None]) & (incidence > 0)
            expected = (incidence * np.cos(angle) * lit).sum() * np.radians(0.5) * np.radians(1) / np.pi
            assert sky[row, col] == pytest.approx(expected, abs=0.03)

    def test_without_an_extent_it_covers_the_dem_and_is_made_only_when_asked_for(self, run, scene, ask):
        whole, _ = self.raster(run, ask, SKY_VIEW_DISTANCE=500)
        dem = open_dem(str(scene.dem))
        assert (whole.RasterYSize, whole.RasterXSize) == dem.shape
        assert whole.GetRasterBand(1).GetDescription() == "sky view factor"
        values = whole.ReadAsArray()
        assert values.min() >= 0 and values.max() <= 1 and values.std() > 0.005
        results, _ = run("horizonprofile", {key: ask[key] for key in ask if key != "SKY_VIEW"})
        assert "SKY_VIEW" not in results

    def test_an_extent_beside_the_dem_and_an_endless_range_are_refused(self, refusal, ask):
        aside = {**ask, "SKY_VIEW_EXTENT": QgsRectangle(500_000, 500_000, 600_000, 600_000)}
        assert "does not overlap the DEM" in refusal("horizonprofile", aside)
        assert "at most 900000 m" in refusal("horizonprofile", {**ask, "SKY_VIEW_DISTANCE": 2_000_000})
        assert refusal("horizonprofile", {**aside, "SKY_VIEW": None}) == ""

    def test_cancelling_leaves_no_raster(self, run, ask, listener, tmp_path):
        with pytest.raises(QgsProcessingException, match="Cancelled"):
            run("horizonprofile", ask, listener(cancel_at=50))
        assert list(tmp_path.iterdir()) == []
