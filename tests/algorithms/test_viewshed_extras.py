"""What directedviewshed gives beyond seen and not seen: layers, probabilities, skyline limits, shared stations."""

import numpy as np
import pytest
from osgeo import gdal, osr
from qgis.core import (
    QgsDistanceArea,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingException,
    QgsRasterLayer,
    QgsVectorLayer,
)
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.io.raster import open_dem

FIELDS = ("heading", "pitch", "roll", "hfov", "vfov", "heading_lo", "heading_hi")
BANDS = ("distance", "elevation angle", "height above the line of sight", "column in the photograph")
REACH_M = 7000


@pytest.fixture
def points(scene):
    """Make a layer of oriented points: (name of the position, photo, attributes that differ) each."""

    def make(*photos):
        fields = "&".join(f"field={name}:double" for name in FIELDS)
        layer = QgsVectorLayer(f"Point?crs=EPSG:4326&field=photo:string&{fields}", "oriented", "memory")
        for place, photo, changes in photos:
            pose = scene.truth[place]
            values = {"heading": pose.heading_deg, "pitch": pose.pitch_deg, "roll": pose.roll_deg, "photo": photo}
            values = {**values, "hfov": scene.hfov_deg, "vfov": 49.7, **changes}
            feature = QgsFeature(layer.fields())
            feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*scene.positions[place])))
            feature.setAttributes([values.get(field.name()) for field in layer.fields()])
            layer.dataProvider().addFeature(feature)
        return layer

    return make


@pytest.fixture
def call(run, scene, tmp_path):
    def go(layer, **parameters):
        target = str(tmp_path / f"count_{len(list(tmp_path.iterdir()))}.tif")
        given = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": target, "POLYGONS": "memory:"}
        return run("directedviewshed", {**given, "MAX_DISTANCE": REACH_M, **parameters})

    return go


def raster(path):
    """(bands, top row, left column, dataset) on the scene's DEM of 75 m cells."""
    dataset = gdal.Open(str(path))
    values = dataset.ReadAsArray()
    return (values if values.ndim == 3 else values[None]), dataset


def on_dem(path, scene, fill):
    """First band of a raster on the whole DEM's grid, and all bands."""
    bands, dataset = raster(path)
    whole, own = gdal.Open(str(scene.dem)), dataset.GetGeoTransform()
    there = whole.GetGeoTransform()
    row, col = round((own[3] - there[3]) / there[5]), round((own[0] - there[0]) / there[1])
    out = np.full((len(bands), whole.RasterYSize, whole.RasterXSize), fill, float)
    out[:, row : row + bands.shape[1], col : col + bands.shape[2]] = bands
    return out


def rows_of(results):
    return {feature["photo"]: feature for feature in results["POLYGONS"].getFeatures()}


def test_nothing_more_is_written_unless_asked_for(call, points, tmp_path):
    results, _ = call(points(("west", "a.jpg", {})))
    assert not {"LAYERS", "PROBABILITIES"} & set(results)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["count_0.qml", "count_0.tif"]
    row = rows_of(results)["a.jpg"]
    assert row["p90_m2"] is None or row.attribute("p90_m2").isNull()
    assert 0 < row["terr_share"] < 1


class TestLayers:
    @pytest.fixture
    def found(self, call, points, tmp_path, scene):
        layer = points(("west", "a.jpg", {}))
        call(layer, LAYERS=str(tmp_path / "layers"), RASTERS=str(tmp_path / "seen"))
        bands, dataset = raster(tmp_path / "layers" / "a.tif")
        return on_dem(tmp_path / "layers" / "a.tif", scene, np.nan), dataset, tmp_path

    def test_bands_say_what_they_are(self, found):
        _, dataset, _ = found
        bands = [dataset.GetRasterBand(number) for number in range(1, 6)]
        assert dataset.RasterCount == 5 and tuple(band.GetDescription() for band in bands)[:4] == BANDS
        assert [band.GetUnitType() for band in bands] == ["m", "degrees", "m", "px", "px"]
        assert all(np.isnan(band.GetNoDataValue()) for band in bands)

    def test_qgis_draws_each_file_with_its_style(self, found):
        folder = found[2]
        for name, band, labels in (("layers", 3, 7), ("seen", 1, 2)):
            layer = QgsRasterLayer(str(folder / name / "a.tif"), name)
            assert (layer.renderer().type(), layer.renderer().band()) == ("singlebandpseudocolor", band)
            assert len(layer.renderer().shader().rasterShaderFunction().colorRampItemList()) == labels

    def test_distances_are_those_on_the_ellipsoid(self, found, scene):
        measure = QgsDistanceArea()
        measure.setEllipsoid("EPSG:7030")
        distance, dem = found[0][0], open_dem(str(scene.dem))
        known = np.argwhere(np.isfinite(distance))
        assert len(known) > 300
        for row, col in known[:: len(known) // 25]:
            place = QgsPointXY(*map(float, dem.position_of(col, row)))
            exact = measure.measureLine(QgsPointXY(*scene.positions["west"]), place)
            assert distance[row, col] == pytest.approx(exact, abs=0.5)
        assert np.nanmax(distance) <= REACH_M

    def test_elevation_angles_and_places_are_those_of_a_pinhole(self, found, scene):
        distance, angle, _, column, line = found[0]
        dem = open_dem(str(scene.dem))
        heights = dem.read(Window(0, 0, *dem.shape)).astype(float)
        row, col = np.argwhere(np.isfinite(distance)).T
        eye = heights[240, 86] + 1.7
        far = distance[row, col]
        rise = heights[row, col] - eye - (1 - 0.13) * far**2 / (2 * 6_371_000.0)
        np.testing.assert_allclose(angle[row, col], np.degrees(np.arctan2(rise, far)), atol=0.05)
        # The pose as a matrix, from scratch: along, right of and above the optical axis.
        pose = scene.truth["west"]
        h, p, r = np.radians([pose.heading_deg, pose.pitch_deg, pose.roll_deg])
        east, north = dem.frame(*scene.positions["west"], 2.0 * REACH_M).to_local(col, row)
        forward = np.array([np.sin(h) * np.cos(p), np.cos(h) * np.cos(p), np.sin(p)])
        right = np.array([np.cos(h), -np.sin(h), 0.0])
        up = np.cross(right, forward)
        right, up = np.cos(r) * right - np.sin(r) * up, np.sin(r) * right + np.cos(r) * up
        ray = np.stack([east, north, rise])
        focal = 4000 / 2 / np.tan(np.radians(scene.hfov_deg / 2))
        height = 2 * focal * np.tan(np.radians(49.7 / 2))
        x = 1999.5 + focal * (right @ ray) / (forward @ ray)
        y = (height - 1) / 2 - focal * (up @ ray) / (forward @ ray)
        assert np.abs(column[row, col] - x).max() < 4 and np.abs(line[row, col] - y).max() < 4
        assert x.min() > -5 and x.max() < 4004 and y.min() > -5 and y.max() < height + 5

    def test_a_target_raised_by_the_missing_height_is_seen(self, found, call, points, scene):
        above, folder = found[0][2], found[2]
        seen = on_dem(folder / "seen" / "a.tif", scene, 0)[0] == 1
        inside = np.isfinite(above)
        assert (above[seen] >= 0).all() and (above[inside & ~seen] < 0).all() and (inside & ~seen).sum() > 100
        call(points(("west", "b.jpg", {})), RASTERS=str(folder / "raised"), TARGET_HEIGHT=40.0, SECTOR=2)
        raised = on_dem(folder / "raised" / "b.tif", scene, 0)[0] == 1
        clear = inside & (np.abs(above + 40.0) > 0.01)
        np.testing.assert_array_equal(raised[clear], above[clear] > -40.0)

    def test_without_a_pose_there_is_no_place_in_the_picture(self, call, points, tmp_path):
        call(points(("west", "a.jpg", {"pitch": None})), LAYERS=str(tmp_path / "layers"), SECTOR=2)
        assert gdal.Open(str(tmp_path / "layers" / "a.tif")).RasterCount == 3


class TestProbabilities:
    def test_without_errors_they_are_the_viewshed(self, call, points, scene, tmp_path):
        sure = {"heading_lo": scene.truth["west"].heading_deg, "heading_hi": scene.truth["west"].heading_deg}
        none = {"POSITION_ERROR": 0, "DEM_ERROR": 0, "PITCH_ERROR": 0, "ROLL_ERROR": 0, "FOCAL_ERROR": 0}
        folders = {"PROBABILITIES": str(tmp_path / "p"), "RASTERS": str(tmp_path / "r")}
        results, _ = call(points(("west", "a.jpg", {**sure, "roll": 0.0})), **folders, **none)
        chance = on_dem(tmp_path / "p" / "a.tif", scene, 0.0)[0]
        seen = on_dem(tmp_path / "r" / "a.tif", scene, 0)[0] == 1
        assert (chance[seen] > 0.99).mean() > 0.95 and (chance[~seen] > 0.5).sum() < 0.03 * seen.sum()
        row = rows_of(results)["a.jpg"]
        assert row["p90_m2"] == pytest.approx(row["area_m2"], rel=0.08)

    def test_less_certain_photos_show_less_for_sure(self, call, points, scene, tmp_path):
        heading = scene.truth["west"].heading_deg
        wide = {"heading_lo": heading - 12, "heading_hi": heading + 12}
        results, _ = call(points(("west", "a.jpg", {}), ("west", "b.jpg", wide)), PROBABILITIES=str(tmp_path / "p"))
        sure, doubtful = (rows_of(results)[name] for name in ("a.jpg", "b.jpg"))
        assert 0 < doubtful["p90_m2"] < sure["p90_m2"] < sure["p50_m2"]
        for name, row in (("a", sure), ("b", doubtful)):
            bands, dataset = raster(tmp_path / "p" / f"{name}.tif")
            assert np.nanmin(bands) >= 0 and np.nanmax(bands) <= 1
            assert row["p50_m2"] == pytest.approx((bands >= 0.5).sum() * 75.0**2, rel=0.01)
            assert "probability" in dataset.GetRasterBand(1).GetDescription()
            assert (tmp_path / "p" / f"{name}.qml").exists()

    def test_an_unsure_roll_shows_less_for_sure_and_the_usual_one_is_half_a_degree(self, call, points, tmp_path):
        # Looking down, so that ground fills the picture to its corners.
        layer, folder = points(("west", "a.jpg", {"pitch": -20.0})), {"PROBABILITIES": str(tmp_path / "p")}
        usual, _ = call(layer, **folder)
        same, feedback = call(layer, **folder, ROLL_ERROR=0.5)
        assert any("taken from" in info for info in feedback.infos), "what older runs have left still counts"
        unsure, feedback = call(layer, **folder, ROLL_ERROR=15.0)
        assert not any("taken from" in info for info in feedback.infos)
        usual, same, unsure = (rows_of(results)["a.jpg"]["p90_m2"] for results in (usual, same, unsure))
        assert 0 < unsure < 0.95 * usual and same == usual

    def test_other_areas_have_none_and_say_so(self, call, points, tmp_path):
        results, feedback = call(points(("west", "a.jpg", {})), PROBABILITIES=str(tmp_path / "p"), SECTOR=2)
        assert any("a.jpg" in text and "photo frame" in text for text in feedback.warnings)
        assert not (tmp_path / "p").exists()


def test_a_repeated_run_repeats_neither_layers_nor_probabilities(call, points, tmp_path):
    folders = {name: str(tmp_path / name) for name in ("RASTERS", "LAYERS", "PROBABILITIES")}
    layer = points(("west", "a.jpg", {}), ("north", "b.jpg", {}))
    first, _ = call(layer, **folders)
    (tmp_path / "LAYERS" / "b.tif").unlink()  # as if the run had been killed there
    stamps = {path: path.stat().st_mtime_ns for path in tmp_path.glob("*/*.tif")}
    second, feedback = call(layer, **folders)
    assert len(stamps) == 5 and all(path.stat().st_mtime_ns == stamp for path, stamp in stamps.items())
    assert (tmp_path / "LAYERS" / "b.tif").exists()
    assert sum("taken from" in info for info in feedback.infos) == 5
    for name in ("a.jpg", "b.jpg"):
        assert rows_of(first)[name].attributes() == rows_of(second)[name].attributes()
    call(layer, **folders, DEM_ERROR=5.0)
    assert (tmp_path / "PROBABILITIES" / "a.tif").stat().st_mtime_ns != stamps[tmp_path / "PROBABILITIES" / "a.tif"]


def test_photos_from_one_place_are_what_each_is_alone(call, points, scene, tmp_path):
    photos = [("west", "a.jpg", {}), ("north", "n.jpg", {}), ("west", "b.jpg", {"heading": 230.0, "pitch": -4.0})]
    together, _ = call(points(*photos), RASTERS=str(tmp_path / "together"))
    assert [row["photo"] for row in together["POLYGONS"].getFeatures()] == ["a.jpg", "n.jpg", "b.jpg"]
    for photo in photos:
        alone, _ = call(points(photo), RASTERS=str(tmp_path / "alone"))
        name = photo[1].replace("jpg", "tif")
        np.testing.assert_array_equal(raster(tmp_path / "together" / name)[0], raster(tmp_path / "alone" / name)[0])
        for field in ("area_m2", "farthest_m", "terr_share", "heading"):
            assert rows_of(together)[photo[1]][field] == rows_of(alone)[photo[1]][field]


def test_small_parts_are_left_out(call, points):
    plain, _ = call(points(("west", "a.jpg", {})))
    coarse, _ = call(points(("west", "a.jpg", {})), MIN_AREA=60_000.0)
    parts = [part.area() for part in rows_of(coarse)["a.jpg"].geometry().asGeometryCollection()]
    every = [part.area() for part in rows_of(plain)["a.jpg"].geometry().asGeometryCollection()]
    assert 0 < len(parts) < len(every) and min(parts) > 40_000 > min(every)
    assert 0 < rows_of(coarse)["a.jpg"]["area_m2"] < rows_of(plain)["a.jpg"]["area_m2"]


class TestTerrainShare:
    @pytest.mark.parametrize(("pitch", "expected"), [(60.0, 0.0), (-70.0, 1.0)])
    def test_sky_has_none_and_ground_all(self, call, points, pitch, expected):
        results, _ = call(points(("west", "a.jpg", {"pitch": pitch})))
        assert rows_of(results)["a.jpg"]["terr_share"] == expected

    def test_it_is_the_rendered_picture_s(self, call, points, scene):
        from skyline_viewshed.core.base.camera import Camera, focal_of_fov_px
        from skyline_viewshed.core.base.terrain import Observer
        from skyline_viewshed.core.simulate.render import render_view
        from skyline_viewshed.core.simulate.scene import SceneOptions

        focal = focal_of_fov_px(400, scene.hfov_deg)
        camera = Camera(400, round(2 * focal * np.tan(np.radians(49.7 / 2))), focal)
        dem = open_dem(str(scene.dem))
        view = render_view(dem, Observer(*scene.positions["west"], 1.7), camera, scene.truth["west"], SceneOptions(1))
        rows = np.clip(np.nan_to_num(view.skyline_row_px, nan=camera.height_px), 0, camera.height_px)
        results, _ = call(points(("west", "a.jpg", {})), MAX_DISTANCE=40_000)
        share = 1 - rows.mean() / camera.height_px
        assert rows_of(results)["a.jpg"]["terr_share"] == pytest.approx(share, abs=0.02)


class TestSkylines:
    @pytest.fixture
    def table(self):
        def make(rows, fields="field=photo:string&field=column:double&field=row:double&field=confidence:double"):
            layer = QgsVectorLayer(f"None?{fields}", "skylines", "memory")
            for values in rows:
                feature = QgsFeature(layer.fields())
                feature.setAttributes(list(values))
                layer.dataProvider().addFeature(feature)
            return layer

        return make

    @staticmethod
    def line(row, confidence=1.0, photo="/elsewhere/a.jpg"):
        """A level skyline on a picture 800 px wide, as a table of 100 columns gives it."""
        return [(photo, (column + 0.5) * 8 - 0.5, row, confidence) for column in range(100)]

    def seen(self, call, points, scene, tmp_path, **parameters):
        folder = tmp_path / f"r{len(list(tmp_path.iterdir()))}"
        _, feedback = call(points(("west", "a.jpg", {})), RASTERS=str(folder), **parameters)
        return on_dem(folder / "a.tif", scene, 0)[0] == 1, feedback

    def test_ground_above_the_line_is_not_claimed(self, call, points, scene, table, tmp_path):
        free, _ = self.seen(call, points, scene, tmp_path, LAYERS=str(tmp_path / "layers"))
        line = on_dem(tmp_path / "layers" / "a.tif", scene, np.nan)[4] / 5  # 4000 px there, 800 px in the table
        for row, tolerance in ((300.0, 0.0), (300.0, 2.0), (0.0, 0.0)):
            limits = {"SKYLINES": table(self.line(row)), "SKYLINE_TOLERANCE": tolerance}
            found, _ = self.seen(call, points, scene, tmp_path, **limits)
            focal = 400 / np.tan(np.radians(scene.hfov_deg / 2))
            limit = row - focal * np.tan(np.radians(tolerance))
            clear = np.abs(line - limit) > 1
            np.testing.assert_array_equal(found[free & clear], (line > limit)[free & clear])
            assert not (found & ~free).any() and found.any()
        found, _ = self.seen(call, points, scene, tmp_path, SKYLINES=table(self.line(700.0)))
        assert not found.any()

    def test_unsure_columns_limit_nothing(self, call, points, scene, table, tmp_path):
        free, _ = self.seen(call, points, scene, tmp_path)
        found, _ = self.seen(call, points, scene, tmp_path, SKYLINES=table(self.line(700.0, 0.2)))
        assert (found != free).sum() <= 2  # the frame's edges, met by another number of pixels

    def test_a_photo_that_the_table_does_not_know_is_named_and_left_whole(self, call, points, scene, table, tmp_path):
        free, _ = self.seen(call, points, scene, tmp_path)
        other = table(self.line(700.0, photo="other.jpg"))
        found, feedback = self.seen(call, points, scene, tmp_path, SKYLINES=other)
        np.testing.assert_array_equal(found, free)
        assert any("a.jpg" in text and "skylines" in text for text in feedback.warnings)

    def test_another_table_is_refused(self, refusal, points, scene, table, tmp_path):
        wrong = table([], "field=photo:string&field=x:double")
        given = {"INPUT": points(("west", "a.jpg", {})), "DEM": str(scene.dem), "OUTPUT": str(tmp_path / "v.tif")}
        assert "no field column" in refusal("directedviewshed", {**given, "SKYLINES": wrong})


def test_extras_of_too_large_a_window_are_refused_in_words(call, points, tmp_path, monkeypatch):
    from skyline_viewshed.algorithms.shared import viewshed_extras
    from skyline_viewshed.core.viewshed import station

    monkeypatch.setattr(viewshed_extras, "LAYER_CELLS", 100)
    monkeypatch.setattr(station, "PACKED_CELLS", 100)
    layer = points(("west", "a.jpg", {}))
    packed, feedback = call(layer, LAYERS=str(tmp_path / "l"), RASTERS=str(tmp_path / "r"))
    assert any("shorter" in text for text in feedback.warnings) and not (tmp_path / "l").exists()
    again, _ = call(layer, RASTERS=str(tmp_path / "r"))
    monkeypatch.undo()
    plain, _ = call(layer)
    for results in (packed, again):
        np.testing.assert_array_equal(raster(results["OUTPUT"])[0], raster(plain["OUTPUT"])[0])
        assert rows_of(results)["a.jpg"].attributes() == rows_of(plain)["a.jpg"].attributes()


def test_a_dem_across_180_degrees_is_one_piece(run, tmp_path):
    """Points of both signs of longitude see both sides; the count and the polygons lie where the DEM does."""
    cells = np.full((120, 120), 100.0, np.float32)
    dataset = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "dem.tif"), 120, 120, 1, gdal.GDT_Float32)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(4326)
    dataset.SetProjection(reference.ExportToWkt())
    dataset.SetGeoTransform((179.94, 0.001, 0, 10.06, 0, -0.001))
    dataset.GetRasterBand(1).WriteArray(cells)
    dataset = None
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string&field=heading:double", "points", "memory")
    for longitude in (-179.9995, 179.9995):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(longitude, 10.0)))
        feature.setAttributes([f"{longitude}.jpg", 0.0])
        layer.dataProvider().addFeature(feature)
    given = {"INPUT": layer, "DEM": str(tmp_path / "dem.tif"), "OUTPUT": str(tmp_path / "v.tif"), "SECTOR": 2}
    results, _ = run("directedviewshed", {**given, "POLYGONS": "memory:", "MAX_DISTANCE": 4000, "EYE_HEIGHT": 500})
    count = gdal.Open(results["OUTPUT"]).ReadAsArray()
    assert results["COUNT"] == 2 and (count[:, :60] == 2).sum() > 500 and (count[:, 60:] == 2).sum() > 500
    for row in results["POLYGONS"].getFeatures():
        box = row.geometry().boundingBox()
        assert 179.94 <= box.xMinimum() < 180 < box.xMaximum() <= 180.06
        assert row["area_m2"] == pytest.approx(np.pi * 4000**2, rel=0.02)


def test_progress_only_grows_and_extras_can_be_cancelled(run, points, scene, listener, tmp_path):
    layer = points(("west", "a.jpg", {}), ("west", "b.jpg", {"heading": 90.0}), ("north", "c.jpg", {}))
    given = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": str(tmp_path / "v.tif"), "MAX_DISTANCE": REACH_M}
    given = {**given, "POLYGONS": "memory:", "PROBABILITIES": str(tmp_path / "p")}
    _, feedback = run("directedviewshed", given)
    assert feedback.fractions == sorted(feedback.fractions) and len(feedback.fractions) > 10

    class AtTheFirstProbability(listener):
        def isCanceled(self):
            return (tmp_path / "q" / "a.tif").exists()

    with pytest.raises(QgsProcessingException, match="Cancelled"):
        given = {**given, "PROBABILITIES": str(tmp_path / "q"), "OUTPUT": str(tmp_path / "w.tif")}
        run("directedviewshed", given, AtTheFirstProbability())
    assert [path.name for path in (tmp_path / "q").glob("*.tif")] == ["a.tif"] and not (tmp_path / "w.tif").exists()
