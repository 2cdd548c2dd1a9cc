"""Elevation models through GDAL: real ones, and small ones made here for every oddity."""

import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from osgeo import gdal, osr
from skyline_viewshed.core.errors import ObserverOutsideDemError, UnusableDemError
from skyline_viewshed.core.io.crs import from_wgs84
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.terrain import Window, ground_elevation_m


def make_tif(path, values, geotransform=(600_000, 30, 0, 5_100_000, 0, -30), crs="EPSG:32632", nodata=None, **extra):
    """Write a raster with GDAL alone, so that our own writer proves nothing here."""
    values = np.asarray(values)
    code = {"int16": gdal.GDT_Int16, "float32": gdal.GDT_Float32, "float64": gdal.GDT_Float64, "uint8": gdal.GDT_Byte,
            "int32": gdal.GDT_Int32}[values.dtype.name]  # fmt: skip
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), values.shape[1], values.shape[0], 1, code)
    if geotransform is not None:
        dataset.SetGeoTransform(geotransform)
    if crs is not None:
        reference = osr.SpatialReference()
        reference.SetFromUserInput(crs)
        dataset.SetProjection(reference.ExportToWkt())
    band = dataset.GetRasterBand(1)
    if nodata is not None:
        band.SetNoDataValue(nodata)
    if "unit" in extra:
        band.SetUnitType(extra["unit"])
    if "scale" in extra:
        band.SetScale(extra["scale"])
        band.SetOffset(extra["offset"])
    band.WriteArray(values)
    dataset.FlushCache()
    return str(path)


@pytest.fixture
def hills():
    rows, cols = np.mgrid[0:60, 0:80]
    return (1500 + 20 * rows + 3 * cols).astype(np.float32)


def whole(dem):
    return dem.read(Window(0, 0, *dem.shape))


# --- values -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("dtype", ["int16", "int32", "float32", "float64"])
def test_every_type_reads_as_float32_with_nan_for_nodata(tmp_path, hills, dtype):
    hills[3, 4] = -9999
    dem = open_dem(make_tif(tmp_path / "a.tif", hills.astype(dtype), nodata=-9999))
    values = whole(dem)
    assert values.dtype == np.float32
    assert np.isnan(values[3, 4])
    assert np.isnan(values).sum() == 1
    assert values[10, 20] == hills[10, 20]


@pytest.mark.parametrize("fill", [-9999.0, -32768.0, -3.4e38, 1e20, 32767.0, np.nan, np.inf])
def test_usual_fill_values_are_void_without_a_tag(tmp_path, hills, fill):
    hills[0, :5] = fill
    assert np.isnan(whole(open_dem(make_tif(tmp_path / "a.tif", hills)))[0, :5]).all()


def test_double_precision_fill_beyond_float32_is_void(tmp_path, hills):
    values = hills.astype(np.float64)
    values[5, 5] = -1.7976931348623157e308
    dem = open_dem(make_tif(tmp_path / "a.tif", values, nodata=-1.7976931348623157e308))
    assert np.argwhere(np.isnan(whole(dem))).tolist() == [[5, 5]]


def test_a_window_is_that_part_of_the_whole(tmp_path, hills):
    dem = open_dem(make_tif(tmp_path / "a.tif", hills))
    assert np.array_equal(dem.read(Window(7, 11, 20, 30)), hills[7:27, 11:41])
    assert dem.read(Window(7, 11, 0, 30)).shape == (0, 30)
    with pytest.raises(ValueError, match="beyond"):
        dem.read(Window(50, 0, 20, 10))


def test_strips_join_without_a_seam(tmp_path, hills, monkeypatch):
    dem = open_dem(make_tif(tmp_path / "a.tif", hills))
    monkeypatch.setattr("skyline_viewshed.core.io.raster.STRIP_BYTES", 7 * 4 * 80)
    assert np.array_equal(whole(dem), hills)


def test_reading_leaves_gdals_cache_and_messages_as_the_host_had_them(tmp_path, hills):
    before = gdal.GetCacheMax()
    whole(open_dem(make_tif(tmp_path / "a.tif", hills)))
    assert gdal.GetCacheMax() == before


def test_feet_scale_and_offset_become_metres(tmp_path, hills):
    feet = open_dem(make_tif(tmp_path / "ft.tif", hills, unit="ft"))
    assert np.allclose(whole(feet), hills * 0.3048)
    packed = open_dem(make_tif(tmp_path / "cm.tif", hills.astype(np.int16), scale=0.5, offset=100.0))
    assert np.allclose(whole(packed), hills * 0.5 + 100)


def test_an_internal_mask_counts(tmp_path, hills):
    path = make_tif(tmp_path / "a.tif", hills)
    with_mask = gdal.Open(path, gdal.GA_Update)
    with_mask.CreateMaskBand(gdal.GMF_PER_DATASET)
    mask = np.full(hills.shape, 255, np.uint8)
    mask[:, :10] = 0
    with_mask.GetRasterBand(1).GetMaskBand().WriteArray(mask)
    with_mask.FlushCache()
    del with_mask
    values = whole(open_dem(path))
    assert np.isnan(values[:, :10]).all()
    assert np.isfinite(values[:, 10:]).all()


# --- zeros along the edges --------------------------------------------------------------------------------------


def test_zero_borders_of_a_highland_are_void(tmp_path, hills):
    hills[:, :7] = 0
    dem = open_dem(make_tif(tmp_path / "a.tif", hills.astype(np.int16)))
    assert dem.zero_is_void
    assert np.isnan(whole(dem)[:, :7]).all()
    assert np.isfinite(whole(dem)[:, 7:]).all()


def test_a_coast_keeps_its_sea(tmp_path, hills):
    hills[:, :30] = 0
    hills[:, 30:40] = np.arange(2, 12)  # a beach
    dem = open_dem(make_tif(tmp_path / "a.tif", hills.astype(np.int16)))
    assert not dem.zero_is_void
    assert (whole(dem)[:, :30] == 0).all()


def test_zeros_in_the_middle_of_a_highland_are_left_alone(tmp_path, hills):
    hills[30:40, 30:50] = 0
    assert not open_dem(make_tif(tmp_path / "a.tif", hills)).zero_is_void


@pytest.mark.data
def test_aletsch_has_void_borders_and_lisbon_a_sea(shared_data):
    aletsch = open_dem(shared_data / "aletsch/dem/AletschGlacierDEM.tiff")
    assert aletsch.zero_is_void
    assert np.nanmin(whole(aletsch)) > 800
    assert not open_dem(shared_data / "dem/LisbonElevation.tif").zero_is_void
    assert not open_dem(shared_data / "dem/N43E007.hgt").zero_is_void


# --- refusals ---------------------------------------------------------------------------------------------------


def test_what_is_no_dem_is_refused_in_a_sentence(tmp_path, hills):
    (tmp_path / "text.tif").write_text("no raster")
    (tmp_path / "empty.tif").write_bytes(b"")
    cases = {
        "does not exist": (tmp_path / "missing.tif", 1),
        "not a raster": (tmp_path / "text.tif", 1),
        "no band 2": (make_tif(tmp_path / "one.tif", hills), 2),
        "no band 0": (make_tif(tmp_path / "zero.tif", hills), 0),
        "no coordinate reference system": (make_tif(tmp_path / "bare.tif", hills, crs=None), 1),
        "coordinate reference system on the Earth": (make_tif(tmp_path / "local.tif", hills, crs=LOCAL_CRS), 1),
        "not georeferenced": (make_tif(tmp_path / "nogt.tif", hills, geotransform=None), 1),
        "rotated": (make_tif(tmp_path / "rot.tif", hills, geotransform=(0, 20, 5, 0, 5, -20)), 1),
        "no valid cell": (make_tif(tmp_path / "void.tif", np.full((50, 60), -5.0, np.float32), nodata=-5.0), 1),
    }
    for message, (path, band) in cases.items():
        with pytest.raises(UnusableDemError, match=message):
            open_dem(path, band)
    with pytest.raises(UnusableDemError, match="not a raster"):
        open_dem(tmp_path / "empty.tif")


LOCAL_CRS = 'LOCAL_CS["site grid",UNIT["metre",1]]'


def test_one_valid_cell_anywhere_is_enough(tmp_path):
    values = np.full((300, 200), -5.0, np.float32)
    values[123, 57] = 800
    assert np.nanmax(whole(open_dem(make_tif(tmp_path / "a.tif", values, nodata=-5.0)))) == 800


def test_a_damaged_file_is_refused_when_its_cells_are_read(tmp_path):
    values = np.random.default_rng(1).normal(1000, 200, (400, 400)).astype(np.float32)
    path = tmp_path / "a.tif"
    make_tif(path, values)
    path.write_bytes(path.read_bytes()[: values.nbytes // 2])
    with pytest.raises(UnusableDemError):
        whole(open_dem(path))


def test_paths_with_spaces_umlauts_and_emoji(tmp_path, hills):
    folder = tmp_path / ("Höhen 🏔 " + "x" * 150)
    folder.mkdir()
    assert open_dem(make_tif(folder / "dem ä.tif", hills)).shape == (60, 80)


# --- formats ----------------------------------------------------------------------------------------------------


def test_vrt_and_cog_give_the_same_cells(tmp_path, hills):
    source = make_tif(tmp_path / "a.tif", hills)
    gdal.BuildVRT(str(tmp_path / "a.vrt"), [source]).FlushCache()
    gdal.Translate(str(tmp_path / "cog.tif"), source, format="COG").FlushCache()
    for name in ("a.vrt", "cog.tif"):
        assert np.array_equal(whole(open_dem(tmp_path / name)), hills)


@pytest.mark.data
@pytest.mark.parametrize(
    "name, lowest_m, highest_m, void_share",
    [
        ("vestfold_epsg3031_32m.tif", 18.1, 332.6, 0.538),
        ("AST_L1A_00303182012144228_Z.tif", 317.7, 3959.9, 0.027),
        ("N43E007.hgt", -16, 2060, 0.0),
        ("N43E006_3857.tiff", -12, 1923, 0.0),
        ("S33W071.tif", 250, 6929, 0.0),
        ("dem_SouthGlacier.tif", 1684.6, 3165.2, 0.0),
        ("LisbonElevation.tif", -6.8, 217.9, 0.0),
    ],
)
def test_real_models_have_plausible_heights(shared_data, name, lowest_m, highest_m, void_share):
    values = whole(open_dem(shared_data / "dem" / name))
    assert np.nanmin(values) == pytest.approx(lowest_m, abs=0.1)
    assert np.nanmax(values) == pytest.approx(highest_m, abs=0.1)
    assert np.isnan(values).mean() == pytest.approx(void_share, abs=1e-3)


@pytest.mark.data
def test_named_summits_are_where_they_should_be(shared_data):
    everest = open_dem(shared_data / "khumbu/dem/khumbu.tif").frame(86.9250, 27.9881, 5000.0)
    dem = open_dem(shared_data / "khumbu/dem/khumbu.tif")
    row, col = int(everest.row_px), int(everest.col_px)
    assert dem.read(Window(row - 5, col - 5, 11, 11)).max() > 8700
    aconcagua = open_dem(shared_data / "dem/S33W071.tif")
    col, row = aconcagua.pixel_of(-70.0109, -32.6532)
    assert aconcagua.read(Window(int(row) - 5, int(col) - 5, 11, 11)).max() > 6850


# --- frames -----------------------------------------------------------------------------------------------------


def vincenty_direct(longitude_deg, latitude_deg, azimuth_deg, distance_m):
    """Geodesic from a point on WGS 84 (Vincenty 1975, Survey Review XXIII 176): (longitude, latitude) [degrees]."""
    a, f = 6_378_137.0, 1 / 298.257223563
    b, azimuth = a * (1 - f), np.radians(azimuth_deg)
    u1 = np.arctan((1 - f) * np.tan(np.radians(latitude_deg)))
    sigma1 = np.arctan2(np.tan(u1), np.cos(azimuth))
    sin_alpha = np.cos(u1) * np.sin(azimuth)
    cos2_alpha = 1 - sin_alpha**2
    u2 = cos2_alpha * (a**2 - b**2) / b**2
    big_a = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)))
    big_b = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)))
    sigma = distance_m / (b * big_a)
    for _ in range(50):
        middle = np.cos(2 * sigma1 + sigma)
        change = (
            big_b
            * np.sin(sigma)
            * (
                middle
                + big_b
                / 4
                * (
                    np.cos(sigma) * (2 * middle**2 - 1)
                    - big_b / 6 * middle * (4 * np.sin(sigma) ** 2 - 3) * (4 * middle**2 - 3)
                )
            )
        )
        sigma = distance_m / (b * big_a) + change
    sin_u1, cos_u1, sin_s, cos_s = np.sin(u1), np.cos(u1), np.sin(sigma), np.cos(sigma)
    latitude = np.arctan2(
        sin_u1 * cos_s + cos_u1 * sin_s * np.cos(azimuth),
        (1 - f) * np.hypot(sin_alpha, sin_u1 * sin_s - cos_u1 * cos_s * np.cos(azimuth)),
    )
    turn = np.arctan2(sin_s * np.sin(azimuth), cos_u1 * cos_s - sin_u1 * sin_s * np.cos(azimuth))
    c = f / 16 * cos2_alpha * (4 + f * (4 - 3 * cos2_alpha))
    middle = np.cos(2 * sigma1 + sigma)
    turn -= (1 - c) * f * sin_alpha * (sigma + c * sin_s * (middle + c * cos_s * (2 * middle**2 - 1)))
    return longitude_deg + np.degrees(turn), np.degrees(latitude)


CUSTOM = "+proj=tmerc +lat_0=0 +lon_0=-146 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m"

PLACES = [
    ("EPSG:32606", -149.5, 61.1),
    ("EPSG:3413", -149.5, 61.1),
    ("EPSG:3031", 78.25, -68.47),
    ("EPSG:3857", 6.5, 43.5),
    ("EPSG:3857", -149.5, 61.1),
    ("EPSG:4326", -149.5, 61.1),
    ("EPSG:4326", 86.83, 27.89),
    ("EPSG:4326", 15.0, 78.2),
    ("EPSG:4326", 179.9, -16.8),
    ("EPSG:4326", -179.9, 66.0),
    ("EPSG:3857", 179.9, -16.8),
    ("EPSG:32701", -179.95, -16.8),
    (CUSTOM, -147.0, 61.2),
]


def dem_around(tmp_path, crs, longitude_deg, latitude_deg, cell_m=50.0, south_up=False, side=64):
    """Small raster whose middle lies at a place; cells of about `cell_m`, non-square in degrees."""
    x, y = from_wgs84(crs, longitude_deg, latitude_deg)
    if crs == "EPSG:4326":
        cell_x, cell_y = cell_m / 111_320 / np.cos(np.radians(latitude_deg)), cell_m / 111_320
    else:
        cell_x, cell_y = cell_m, 1.25 * cell_m
    sign = -1 if south_up else 1
    transform = (x - side / 2 * cell_x, cell_x, 0, y + sign * side / 2 * cell_y, 0, -sign * cell_y)
    return open_dem(make_tif(tmp_path / "dem.tif", np.full((side, side), 500, np.float32), transform, crs))


def wrapped_distance_m(dem, crs, col, row, longitude_deg, latitude_deg):
    """Ground distance between pixels and positions, modulo turns of the world [m], by small-angle arithmetic."""
    found_longitude, found_latitude = dem.position_of(col, row)
    turn = (found_longitude - longitude_deg + 180) % 360 - 180
    return 111_320 * np.hypot(found_latitude - latitude_deg, turn * np.cos(np.radians(latitude_deg)))


@pytest.mark.parametrize("crs, longitude_deg, latitude_deg", PLACES)
def test_frame_follows_geodesics_in_any_crs(tmp_path, crs, longitude_deg, latitude_deg):
    dem = dem_around(tmp_path, crs, longitude_deg, latitude_deg)
    radius_m = 60_000.0
    frame = dem.frame(longitude_deg, latitude_deg, radius_m)
    azimuth_deg, distance_m = np.meshgrid(np.arange(0, 360, 15.0) + 3.7, [50.0, 1000, 12_345, 40_000, 59_000])
    azimuth = np.radians(azimuth_deg)
    col, row = frame.to_pixel(distance_m * np.sin(azimuth), distance_m * np.cos(azimuth))
    expected = vincenty_direct(longitude_deg, latitude_deg, azimuth_deg, distance_m)
    error_m = wrapped_distance_m(dem, crs, col, row, *expected)
    # Interpolation costs at most 0.1 m here, in longitude and latitude at 78 degrees north (measured; 1.1 m at 200 km).
    assert error_m.max() < 0.3


@pytest.mark.parametrize("crs, longitude_deg, latitude_deg", PLACES)
def test_frame_goes_both_ways(tmp_path, crs, longitude_deg, latitude_deg):
    frame = dem_around(tmp_path, crs, longitude_deg, latitude_deg).frame(longitude_deg, latitude_deg, 30_000.0)
    east_m, north_m = np.array([-20_000.0, 300, 15_000]), np.array([5000.0, -12_000, 21_000])
    back = frame.to_local(*frame.to_pixel(east_m, north_m))
    assert np.allclose(back, (east_m, north_m), atol=0.5)


def test_convergence_of_frames_has_the_standard_sense(tmp_path):
    for crs, expected_deg in (("EPSG:3413", -104.5), ("EPSG:32606", -2.19), ("EPSG:3857", 0.0), ("EPSG:4326", 0.0)):
        frame = dem_around(tmp_path, crs, -149.5, 61.1).frame(-149.5, 61.1, 1000.0)
        assert frame.convergence_deg == pytest.approx(expected_deg, abs=0.005)


def test_cell_sizes_are_ground_metres(tmp_path):
    frame = dem_around(tmp_path, "EPSG:3857", -149.5, 61.1).frame(-149.5, 61.1, 1000.0)
    # Mercator's scale at 61.1 N is 1 / cos up to the ellipsoid's fraction of a percent.
    assert frame.cell_size_m == pytest.approx(
        (50 * np.cos(np.radians(61.1)), 62.5 * np.cos(np.radians(61.1))), rel=0.006
    )
    polar = dem_around(tmp_path, "EPSG:3413", -149.5, 61.1).frame(-149.5, 61.1, 1000.0)
    assert polar.cell_size_m == pytest.approx((50 / 1.035, 62.5 / 1.035), rel=0.002)


def test_south_up_rasters_give_the_same_ground(tmp_path):
    place = ("EPSG:32606", -149.5, 61.1)
    upright, flipped = dem_around(tmp_path, *place), None
    frame = upright.frame(-149.5, 61.1, 5000.0)
    flipped = dem_around(tmp_path, *place, south_up=True).frame(-149.5, 61.1, 5000.0)
    col, row = frame.to_pixel(700.0, 900.0)
    assert flipped.to_pixel(700.0, 900.0) == pytest.approx((col, 63 - row), abs=1e-6)
    assert flipped.convergence_deg == pytest.approx(frame.convergence_deg, abs=1e-6)


def test_longitudes_from_0_to_360_are_the_same_place(tmp_path):
    values = np.full((100, 100), 900, np.float32)
    dem = open_dem(make_tif(tmp_path / "a.tif", values, (210.0, 0.01, 0, 61.6, 0, -0.01), "EPSG:4326"))
    frame = dem.frame(-149.5, 61.1, 5000.0)
    assert (frame.col_px, frame.row_px) == pytest.approx((49.5, 49.5), abs=1e-6)
    assert ground_elevation_m(dem, frame) == 900


def test_a_raster_across_the_antimeridian_is_whole(tmp_path):
    values = np.tile(np.arange(200, dtype=np.float32), (200, 1)) + 1000
    dem = open_dem(make_tif(tmp_path / "a.tif", values, (179.0, 0.01, 0, -16.0, 0, -0.01), "EPSG:4326"))
    frame = dem.frame(-179.99, -17.0, 40_000.0)  # col 100.5
    west, east = frame.to_pixel(np.array([-30_000.0, 30_000.0]), 0.0)[0]
    assert west == pytest.approx(100.5 - 28.2, abs=0.3)
    assert east == pytest.approx(100.5 + 28.2, abs=0.3)


def test_a_place_beyond_the_crs_or_the_raster_is_outside(tmp_path):
    dem = dem_around(tmp_path, "EPSG:32606", -149.5, 61.1)
    with pytest.raises(ObserverOutsideDemError):
        ground_elevation_m(dem, dem.frame(-120.0, 61.1, 5000.0))
    with pytest.raises(ObserverOutsideDemError):
        ground_elevation_m(dem, dem.frame(31.0, 1.0, 5000.0))


def test_the_observers_place_within_a_cell_counts(tmp_path):
    dem = dem_around(tmp_path, "EPSG:32606", -149.5, 61.1)
    here, there = dem.frame(-149.5, 61.1, 1000.0), dem.frame(-149.4999, 61.1, 1000.0)
    shift_m = 0.0001 * 111_320 * np.cos(np.radians(61.1))
    assert np.hypot((there.col_px - here.col_px) * 50, (there.row_px - here.row_px) * 62.5) == pytest.approx(
        shift_m, rel=0.01
    )


@settings(max_examples=40, deadline=None, derandomize=True, database=None)
@given(st.floats(0, 647), st.floats(0, 647))
def test_pixels_and_positions_are_inverse(khumbu, col_px, row_px):
    assert khumbu.pixel_of(*khumbu.position_of(col_px, row_px)) == pytest.approx((col_px, row_px), abs=1e-6)


@pytest.fixture(scope="module")
def khumbu(shared_data):
    return open_dem(shared_data / "khumbu/dem/khumbu.tif")


# --- damaged headers --------------------------------------------------------------------------------------------


@settings(max_examples=150, deadline=None, derandomize=True, database=None)
@given(st.data())
def test_no_damaged_header_does_worse_than_a_sentence(tmp_path_factory, data):
    folder = tmp_path_factory.getbasetemp()
    rows, cols = np.mgrid[0:24, 0:24]
    source = folder / "fuzz-source.tif"
    if not source.exists():
        make_tif(source, (1500 + 20 * rows + 3 * cols).astype(np.int16))
    content = bytearray(source.read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        content[data.draw(st.integers(0, min(len(content), 700) - 1))] = data.draw(st.integers(0, 255))
    path = folder / "fuzz.tif"
    path.write_bytes(bytes(content))
    try:
        dem = open_dem(path)
        dem.read(Window(0, 0, 24, 24).clipped(dem.shape))
    except UnusableDemError as error:
        assert str(error).endswith(".")
    finally:
        for leftover in folder.glob("fuzz.tif.aux.xml"):
            os.remove(leftover)
