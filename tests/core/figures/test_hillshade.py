"""Shaded relief against closed forms and against GDAL's."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.figures.hillshade import hillshade


def plane(east_slope, north_slope, cell=(10.0, 20.0), shape=(7, 9)):
    rows, cols = np.indices(shape)
    return east_slope * cols * cell[0] - north_slope * rows * cell[1]


@pytest.mark.parametrize(("east_slope", "north_slope"), [(0, 0), (0.5, 0), (0, 0.5), (-0.3, 0.4), (2, -1)])
@pytest.mark.parametrize("azimuth_deg", [0, 90, 315])
def test_a_plane_is_as_bright_as_the_cosine_between_its_normal_and_the_light(east_slope, north_slope, azimuth_deg):
    normal = np.array([-east_slope, -north_slope, 1.0])
    normal /= np.linalg.norm(normal)
    azimuth, altitude = np.radians(azimuth_deg), np.radians(40)
    light = np.array([np.sin(azimuth) * np.cos(altitude), np.cos(azimuth) * np.cos(altitude), np.sin(altitude)])
    shade = hillshade(plane(east_slope, north_slope), (10.0, 20.0), azimuth_deg, 40)
    assert np.allclose(shade, max(normal @ light, 0), atol=1e-5)


def test_unknown_cells_stay_unknown_and_spoil_no_neighbour():
    elevation = plane(0.5, 0.2)
    whole = hillshade(elevation, (10.0, 20.0))
    elevation[3, 4] = np.nan
    shade = hillshade(elevation, (10.0, 20.0))
    assert np.isnan(shade[3, 4])
    assert np.isfinite(shade).sum() == shade.size - 1
    assert np.nanmax(np.abs(shade - whole)) < 1e-5


def test_a_lone_cell_is_flat():
    elevation = np.full((5, 5), np.nan)
    elevation[2, 2] = 100
    assert hillshade(elevation, 10.0)[2, 2] == pytest.approx(np.sin(np.radians(45)))
    assert hillshade(np.zeros((0, 4)), 10.0).shape == (0, 4)
    assert hillshade(np.zeros((1, 1)), 10.0).shape == (1, 1)


def test_exaggeration_steepens():
    assert hillshade(plane(0.2, 0), 10.0, 90, exaggeration=3)[3, 3] < hillshade(plane(0.2, 0), 10.0, 90)[3, 3]


def test_a_cell_of_no_size_is_refused():
    with pytest.raises(ValueError, match="positive"):
        hillshade(np.zeros((3, 3)), 0)


def test_gdal_shades_the_same_hills():
    gdal = pytest.importorskip("osgeo.gdal")
    rng = np.random.default_rng(3)
    elevation = np.cumsum(np.cumsum(rng.normal(size=(60, 80)), axis=0), axis=1).astype(np.float32)
    dataset = gdal.GetDriverByName("MEM").Create("", 80, 60, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((0, 25, 0, 0, 0, -25))
    dataset.GetRasterBand(1).WriteArray(elevation)
    theirs = gdal.DEMProcessing("", dataset, "hillshade", format="MEM").ReadAsArray().astype(float)
    ours = 1 + 254 * hillshade(elevation, 25.0)
    assert np.abs(ours - theirs)[1:-1, 1:-1].max() < 1.5
