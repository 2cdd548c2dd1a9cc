"""Raster parameters, through which QGIS opens the user's files."""

import numpy as np
import pytest
from osgeo import gdal, ogr, osr
from qgis.core import QgsProcessingContext, QgsProcessingModelAlgorithm
from rasters import make_tif

HEIGHTS = np.add.outer(np.arange(80.0), np.arange(90.0)).astype(np.float32) + 500


@pytest.fixture
def eye(tmp_path):
    """Write a layer with one point in the middle of a DEM, and the DEM in a folder of its own."""
    (tmp_path / "dem").mkdir()
    make_tif(tmp_path / "dem" / "dem.tif", HEIGHTS)
    dataset = gdal.Open(str(tmp_path / "dem" / "dem.tif"))
    x, dx, _, y, _, dy = dataset.GetGeoTransform()
    reference = osr.SpatialReference(dataset.GetProjection())
    out = ogr.GetDriverByName("GPKG").CreateDataSource(str(tmp_path / "eye.gpkg"))
    layer = out.CreateLayer("eye", reference, ogr.wkbPoint)
    feature = ogr.Feature(layer.GetLayerDefn())
    feature.SetGeometry(ogr.CreateGeometryFromWkt(f"POINT ({x + 45 * dx} {y + 40 * dy})"))
    layer.CreateFeature(feature)
    return tmp_path


def rasters_of(algorithm):
    return [found for found in algorithm.parameterDefinitions() if found.type() == "raster"]


def test_every_raster_parameter_spares_the_users_folder(provider):
    """The kind: QGIS itself opens what a raster parameter names, so each of them has to keep it from writing."""
    own = [algorithm for algorithm in provider.algorithms() if not isinstance(algorithm, QgsProcessingModelAlgorithm)]
    found = [(algorithm.id(), parameter) for algorithm in own for parameter in rasters_of(algorithm)]
    assert len(found) > 12 and "WEIGHTS" in {parameter.name() for _, parameter in found}
    plain = [f"{name} {parameter.name()}" for name, parameter in found if type(parameter).__name__ != "RasterParameter"]
    assert plain == []


def test_a_copy_keeps_label_help_and_flags(algorithm):
    owner = algorithm("locatephotos")  # the parameter lives as long as its algorithm
    weights = owner.parameterDefinition("WEIGHTS")
    copy = weights.clone()
    for what in ("name", "description", "help", "flags", "type", "defaultValue"):
        assert getattr(copy, what)() == getattr(weights, what)(), what


@pytest.mark.parametrize("option", ["", "|option:NUM_THREADS=2"])
def test_qgis_process_leaves_no_statistics_beside_the_dem(qgis_process, eye, option):
    done = qgis_process(
        "run",
        "skylineviewshed:horizonprofile",
        "--",
        f"INPUT={eye / 'eye.gpkg'}",
        f"DEM={eye / 'dem' / 'dem.tif'}{option}",
        "AZIMUTH_STEP=90",
        f"OUTPUT={eye / 'horizon.gpkg'}",
    )
    assert done.returncode == 0, done.stderr
    assert (eye / "horizon.gpkg").exists()
    assert [path.name for path in (eye / "dem").iterdir()] == ["dem.tif"]


def test_a_value_that_is_no_raster_is_refused(algorithm, tmp_path):
    (tmp_path / "text.tif").write_text("no raster")
    owner = algorithm("horizonprofile")
    parameter = owner.parameterDefinition("DEM")
    assert not parameter.checkValueIsAcceptable(None)
    assert parameter.checkValueIsAcceptable(str(tmp_path / "text.tif"))
    assert not parameter.checkValueIsAcceptable(str(tmp_path / "text.tif"), QgsProcessingContext())
