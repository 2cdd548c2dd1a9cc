"""The DEM parameter: what the user has set on the layer in QGIS, and what the plugin leaves beside the file."""

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsProcessingContext, QgsRasterLayer, QgsRasterRange
from rasters import make_tif, whole

VALUES = np.add.outer(np.arange(40.0), np.arange(50.0)).astype(np.float32) + 500


@pytest.fixture
def source(algorithm, tmp_path):
    """Give the DEM that the algorithms open for a value of the parameter."""
    from skyline_viewshed.algorithms.shared.elevation import dem_source

    make_tif(tmp_path / "a.tif", VALUES, nodata=510)

    def find(dem=None, **parameters):
        context = QgsProcessingContext()
        wanted = {"DEM": str(tmp_path / "a.tif") if dem is None else dem, **parameters}
        return dem_source(algorithm("horizonprofile"), wanted, context).open()

    return find


def layer(tmp_path):
    found = QgsRasterLayer(str(tmp_path / "a.tif"), "dem", "gdal")
    assert found.isValid()
    return found


def test_nodata_set_on_the_layer_counts(source, tmp_path):
    dem = layer(tmp_path)
    dem.dataProvider().setUserNoDataValue(1, [QgsRasterRange(520, 530), QgsRasterRange(500, 500)])
    expected = ((VALUES >= 520) & (VALUES <= 530)) | (VALUES == 500) | (VALUES == 510)
    assert np.array_equal(np.isnan(whole(source(dem))), expected)


def test_nodata_switched_off_on_the_layer_is_data(source, tmp_path):
    dem = layer(tmp_path)
    assert np.isnan(whole(source(dem))).sum() == (VALUES == 510).sum()
    dem.dataProvider().setUseSourceNoDataValue(1, False)
    assert np.isfinite(whole(source(dem))).all()


def test_the_unit_is_applied_and_metres_are_the_default(source):
    assert np.nanmax(whole(source())) == VALUES.max()
    assert np.nanmax(whole(source(DEM_UNIT=2))) == pytest.approx(VALUES.max() * 0.3048)
    assert np.nanmax(whole(source(DEM_UNIT=4))) == pytest.approx(VALUES.max() / 10)


def test_every_algorithm_with_a_dem_has_the_unit(provider):
    from skyline_viewshed.algorithms.base import DemAlgorithm

    own = [algorithm for algorithm in provider.algorithms() if isinstance(algorithm, DemAlgorithm)]
    assert len(own) >= 12
    for algorithm in own:
        definition = algorithm.parameterDefinition("DEM")
        unit = algorithm.parameterDefinition("DEM_UNIT")
        assert definition is not None, algorithm.id()
        assert unit is not None, algorithm.id()
        assert unit.flags() & unit.Flag.FlagOptional


def test_open_options_of_a_layer_are_used(source, tmp_path):
    assert source(f"{tmp_path}/a.tif|option:NUM_THREADS=2").shape == VALUES.shape


def test_looking_at_a_dem_writes_no_statistics_beside_it(algorithm, source, tmp_path):
    source()
    passed, _ = algorithm("horizonprofile").checkParameterValues(
        {"INPUT": "missing", "DEM": str(tmp_path / "a.tif"), "OUTPUT": "memory:"}, QgsProcessingContext()
    )
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.tif"]


def test_a_sidecar_that_is_there_is_read(source, tmp_path):
    dataset = gdal.Open(str(tmp_path / "a.tif"))
    dataset.GetRasterBand(1).SetUnitType("ft")
    del dataset
    assert (tmp_path / "a.tif.aux.xml").exists()
    assert np.nanmax(whole(source())) == pytest.approx(VALUES.max() * 0.3048)
