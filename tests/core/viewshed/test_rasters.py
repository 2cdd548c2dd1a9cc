"""Viewsheds over files: every CRS, close to a pole, real DEMs, and beside GDAL's."""

import numpy as np
import pytest
from reference.landscapes import fractal, summits, write_summits
from reference.sight_lines import sees
from reference.views import UNKNOWN, look, overlap, spread
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Window
from skyline_viewshed.core.viewshed.viewshed import ViewshedOptions, Wedge, viewshed

CENTRE = (-149.5, 61.1)


@pytest.fixture(scope="module")
def views(tmp_path_factory):
    """What one mountain group shows, in many coordinate systems: (dem, Viewshed)."""
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    folder = tmp_path_factory.mktemp("crs")
    found = {}
    for name, crs, cell, south_up in (
        ("utm", "EPSG:32606", (40, 40), False),
        ("south up", "EPSG:32606", (40, 40), True),
        ("polar stereographic", "EPSG:3413", (40, 40), False),
        ("web mercator, not square", "EPSG:3857", (80, 100), False),
        ("geographic", "EPSG:4326", (0.0008, 0.0004), False),
    ):
        dem = open_dem(write_summits(folder / f"{name}.tif", crs, cell, CENTRE, south_up=south_up))
        eye = float(summits(*CENTRE, CENTRE)) + 20
        observer = Observer(*CENTRE, eye_elevation_m=eye)
        found[name] = dem, viewshed(dem, observer, Wedge(10.0, 200.0), ViewshedOptions(max_distance_m=11_000.0))
    return found


def seen_at(view, east, north):
    """Values of a viewshed at local places."""
    _, result = view
    col, row = result.frame.to_pixel(east, north)
    row, col = np.rint(row).astype(int) - result.window.row, np.rint(col).astype(int) - result.window.col
    inside = (row >= 0) & (row < result.window.rows) & (col >= 0) & (col < result.window.cols)
    return np.where(inside, result.values[np.where(inside, row, 0), np.where(inside, col, 0)], 0)


@pytest.mark.parametrize("name", ["south up", "polar stereographic", "web mercator, not square", "geographic"])
def test_one_mountain_shows_the_same_ground_in_any_crs(views, name):
    east, north = np.meshgrid(np.arange(-10_500, 10_501, 100.0), np.arange(-10_500, 10_501, 100.0))
    inside = np.hypot(east, north) < 10_800
    a, b = (seen_at(views[key], east[inside], north[inside]) == 1 for key in ("utm", name))
    assert a.mean() > 0.05
    assert overlap(a, b) > 0.93  # edges of the ground in view fall on other cells


@pytest.mark.parametrize("name", ["utm", "polar stereographic", "web mercator, not square", "geographic"])
def test_in_any_crs_cells_agree_with_sight_lines_over_the_true_ground(views, name):
    """Sampled along geodesics of the local frame, bilinear, every quarter cell."""
    dem, result = views[name]
    rng = np.random.default_rng(1)
    rows, cols = (rng.integers(0, count, 800) for count in result.values.shape)
    east, north = result.frame.to_local(cols + result.window.col, rows + result.window.row)
    keep = (np.hypot(east, north) < 10_900) & (np.hypot(east, north) > 200)
    azimuth = np.degrees(np.arctan2(east, north))
    keep &= np.abs((azimuth - 10 + 180) % 360 - 180) < 99.9
    from skyline_viewshed.core.base.terrain import bilinear

    ground = dem.read(Window(0, 0, *dem.shape)).astype(float)
    agree, seen = [], []
    for row, col, e, n in zip(rows[keep], cols[keep], east[keep], north[keep]):
        distance = np.hypot(e, n)
        share = np.append(np.arange(60.0, distance, 10.0), distance) / distance
        c, r = result.frame.to_pixel(e * share, n * share)
        d = share * distance
        tangent = (bilinear(ground, r, c) - result.eye_elevation_m) / d - 0.87 * d / (2 * 6_371_000)
        free = tangent[-1] >= tangent[:-2].max(initial=-np.inf) - 1e-9
        agree.append(free == (result.values[row, col] == 1))
        seen.append(free)
    assert 0.05 < np.mean(seen) < 0.95
    assert np.mean(agree) > 0.97


@pytest.mark.parametrize(
    ("crs", "cell", "centre"),
    [("EPSG:4326", (0.004, 0.0005), (15.0, 84.0)), ("EPSG:3031", (60, 60), (-68.0, -78.0))],
)
def test_close_to_a_pole(tmp_path, crs, cell, centre):
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(write_summits(tmp_path / "dem.tif", crs, cell, centre))
    observer = Observer(*centre, eye_elevation_m=float(summits(*centre, centre)) + 20)
    result = viewshed(dem, observer, Wedge(0.0, 30.0), ViewshedOptions(max_distance_m=9_500.0))
    col, row = result.frame.to_pixel(0.0, 7_000.0)  # the near side of the northern summit
    assert result.values[int(round(row)) - result.window.row, int(round(col)) - result.window.col] == 1
    rows, cols = np.nonzero(result.visible)
    east, north = result.frame.to_local(cols + result.window.col, rows + result.window.row)
    far = np.hypot(east, north) > 300
    assert (np.abs(np.degrees(np.arctan2(east, north)))[far] < 15.01).all()
    assert np.hypot(east, north).max() < 9_500.5


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "position"),
    [
        ("vestfold_epsg3031_32m.tif", None),
        ("AST_L1A_00303182012144228_Z.tif", None),
        ("N43E007.hgt", (7.3, 43.85)),
        ("N43E006_3857.tiff", None),
        ("S33W071.tif", (-70.01, -32.65)),
        ("dem_SouthGlacier.tif", None),
        ("LisbonElevation.tif", None),
    ],
)
def test_every_elevation_model_of_the_zoo_has_a_viewshed(shared_data, name, position):
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(str(shared_data / "dem" / name))
    if position is None:
        known = np.argwhere(np.isfinite(dem.read(Window(dem.shape[0] // 2, 0, 1, dem.shape[1]))))
        position = tuple(map(float, dem.position_of(known[len(known) // 2][1], dem.shape[0] // 2)))
    result = viewshed(dem, Observer(*position, 10.0), options=ViewshedOptions(max_distance_m=8_000.0))
    cells = dem.read(result.window)
    assert set(np.unique(result.values)) <= {0, 1, UNKNOWN}
    assert not (np.isnan(cells) & result.visible).any()
    row, col = int(round(result.frame.row_px)) - result.window.row, int(round(result.frame.col_px)) - result.window.col
    assert result.values[row, col] == 1
    # Twenty cells against the exact line of sight over the DEM's own cells, where the grid is nearly plane.
    if np.isnan(cells).any():
        return
    rng = np.random.default_rng(2)
    agree = []
    for r, c in zip(*(rng.integers(0, count, 60) for count in cells.shape)):
        east, north = result.frame.to_local(c + result.window.col, r + result.window.row)
        if not 100 < np.hypot(east, north) < 7_900:
            continue
        distance = np.hypot(east, north)
        share = np.arange(1.2 * result.frame.cell_m, distance, result.frame.cell_m / 4) / distance
        cols, rows = result.frame.to_pixel(east * share, north * share)
        from skyline_viewshed.core.base.terrain import bilinear

        d = np.append(share[: max(len(share) - 3, 0)] * distance, distance)
        z = np.append(bilinear(cells, rows - result.window.row, cols - result.window.col)[: len(d) - 1], cells[r, c])
        tangent = (z - result.eye_elevation_m) / d - 0.87 * d / (2 * 6_371_000)
        agree.append((tangent[-1] >= tangent[:-1].max(initial=-9)) == (result.values[r, c] == 1))
    assert np.mean(agree) > 0.9


def test_where_gdal_viewshed_differs_the_exact_lines_are_more_often_with_us(tmp_path):
    gdal = pytest.importorskip("osgeo.gdal")
    if not hasattr(gdal, "ViewshedGenerate"):
        pytest.skip("this GDAL has no viewshed")
    ground, row, col = fractal(121, seed=21), 60, 60
    raster = gdal.GetDriverByName("MEM").Create("", 121, 121, 1, gdal.GDT_Float32)
    raster.SetGeoTransform((0, 30, 0, 3630, 0, -30))
    raster.GetRasterBand(1).WriteArray(ground)
    peer = gdal.ViewshedGenerate(
        raster.GetRasterBand(1), "MEM", "", [], (col + 0.5) * 30, 3630 - (row + 0.5) * 30, 20.0, 0.0,
        1, 0, 0, -1, 0.87, gdal.GVM_Edge, 0, heightMode=gdal.GVOT_NORMAL,
    ).ReadAsArray() == 1  # fmt: skip
    ours = look(ground, 30.0, row, col, eye_height_m=20.0) == 1
    eye = float(ground[row, col]) + 20.0
    pick = np.argwhere(peer != ours)[::7]
    exact = np.array([sees(ground, 30.0, row, col, eye, r, c) for r, c in pick])
    right = np.mean(ours[tuple(pick.T)] == exact)
    assert right > 0.5


def test_array_terrain_and_file_give_the_same(tmp_path):
    gdal = pytest.importorskip("osgeo.gdal")
    from osgeo import osr
    from skyline_viewshed.core.io.raster import open_dem

    ground = fractal(151, seed=22)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32632)
    raster = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "dem.tif"), 151, 151, 1, gdal.GDT_Float32)
    raster.SetGeoTransform((500_000 - 151 * 15, 30, 0, 5_200_000 + 151 * 15, 0, -30))
    raster.SetProjection(reference.ExportToWkt())
    raster.GetRasterBand(1).WriteArray(ground)
    raster = None
    dem = open_dem(str(tmp_path / "dem.tif"))
    position = dem.position_of(75.0, 75.0)
    found = spread(viewshed(dem, Observer(*map(float, position), 10.0)), ground.shape) == 1
    plain = ArrayTerrain(ground, 30.0)
    assert (
        overlap(found, spread(viewshed(plain, Observer(*plain.position_of(75.0, 75.0), 10.0)), ground.shape) == 1)
        > 0.98
    )
