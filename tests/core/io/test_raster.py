"""Elevation models through GDAL: values, voids and formats, real ones and small ones made here for every oddity."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from rasters import make_tif, whole
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.io import raster
from skyline_viewshed.core.io.raster import open_dem

READ_BYTES = Path("/proc/self/io")


def bytes_read():
    """Bytes that this process has read so far."""
    return int(READ_BYTES.read_text(encoding="utf-8").split()[1])


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


@pytest.mark.parametrize("dtype", ["int16", "float32", "float64"])
@pytest.mark.parametrize("compressed", [False, True])
def test_a_window_is_read_into_memory_of_any_order(tmp_path, hills, dtype, compressed):
    path = make_tif(tmp_path / "a.tif", hills.astype(dtype), nodata=int(hills[8, 12]))
    if compressed:
        options = ["COMPRESS=DEFLATE", "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"]
        path = gdal.Translate(str(tmp_path / "b.tif"), path, creationOptions=options).GetDescription()
    dem, window = open_dem(path), Window(7, 11, 20, 30)
    memory = np.zeros((40, 50), np.float32)
    dem.read_into(window, memory[30:10:-1, 4:34])
    assert np.array_equal(memory[30:10:-1, 4:34], dem.read(window), equal_nan=True)
    memory[30:10:-1, 4:34] = 0
    assert not memory.any()


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


def test_vrt_and_cog_give_the_same_cells(tmp_path, hills):
    source = make_tif(tmp_path / "a.tif", hills)
    gdal.BuildVRT(str(tmp_path / "a.vrt"), [source]).FlushCache()
    gdal.Translate(str(tmp_path / "cog.tif"), source, format="COG").FlushCache()
    for name in ("a.vrt", "cog.tif"):
        assert np.array_equal(whole(open_dem(tmp_path / name)), hills)


@pytest.mark.skipif(not READ_BYTES.exists(), reason="Linux counts the bytes that a process reads")
def test_a_mosaic_of_large_blocks_is_read_once(tmp_path):
    """The mosaic's own blocks are small, so GDAL must keep the rows of its tiles' blocks from strip to strip."""
    heights = np.random.default_rng(4).uniform(0, 3000, (1024, 4096)).astype(np.float32)
    blocks = ["TILED=YES", "BLOCKXSIZE=1024", "BLOCKYSIZE=1024"]
    tile = str(tmp_path / "tile.tif")
    gdal.Translate(tile, make_tif(tmp_path / "a.tif", heights), creationOptions=blocks).FlushCache()
    gdal.BuildVRT(str(tmp_path / "a.vrt"), [tile]).FlushCache()
    before, dem = bytes_read(), open_dem(tmp_path / "a.vrt")
    for row in range(0, 1024, 256):
        assert np.array_equal(dem.read(Window(row, 0, 256, 4096)), heights[row : row + 256])
    assert bytes_read() - before < 1.5 * 1024 * 4096 * 4


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


@pytest.mark.parametrize("cols", [7, 1500])
@pytest.mark.parametrize("odd", [np.nan, -np.nan, np.inf, -np.inf, -5.0, -0.0, 4000.0])
def test_the_quick_range_of_a_strip_holds_all_values_or_is_not_given(cols, odd):
    strip = np.random.default_rng(1).uniform(0, 3000, (9, cols)).astype(np.float32)
    for cells in (strip, strip[::-1, 1:]):
        quick, exact = raster._ranges(cells)
        assert quick == (0.0, cells.max())
        assert exact == (cells.min(), cells.max())
    strip[3, 4] = odd
    for value in (1.0, -0.0):
        strip[5, 6] = value
        *quick, exact = raster._ranges(strip)
        assert np.array_equal(exact, (strip.min(), strip.max()), equal_nan=True)
        assert quick == ([(0.0, 4000.0)] if odd == 4000.0 and value > 0 else [])
