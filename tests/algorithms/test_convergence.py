"""The same mountain in two coordinate systems: one heading, one ground.

Near 149.5 W, 61.1 N the columns of EPSG:3413 (ArcticDEM) run 104.5 degrees off true north, those of UTM 6N 2.2.
"""

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsVectorLayer,
)
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer, bilinear
from skyline_viewshed.core.io.crs import WGS84, Transformer, local_plane, spatial_reference
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

LON, LAT, CELL_M, SIZE = -149.5, 61.1, 60.0, 400
POSE = Pose(260.0, 3.0, 1.0)
EYE_HEIGHT_M = 60.0
"""Above the slope before the camera, on which two grids differ most."""
SYSTEMS = ("EPSG:3413", "EPSG:32606")


def write_in(crs, mountains, path):
    """Sample the mountains on a grid of a CRS around the middle."""
    x0, y0 = (float(value) for value in Transformer(WGS84, crs)(LON, LAT))
    half = SIZE * CELL_M / 2
    x, y = np.meshgrid(x0 - half + CELL_M * (np.arange(SIZE) + 0.5), y0 + half - CELL_M * (np.arange(SIZE) + 0.5))
    east, north = Transformer(crs, local_plane(LON, LAT))(x, y)
    rows, cols = mountains.shape
    z = bilinear(
        mountains.elevation_m, (rows - 1) / 2 - north / mountains.cell_m, (cols - 1) / 2 + east / mountains.cell_m
    )
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), SIZE, SIZE, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((x0 - half, CELL_M, 0, y0 + half, 0, -CELL_M))
    dataset.SetSpatialRef(spatial_reference(crs))
    band = dataset.GetRasterBand(1)
    band.SetNoDataValue(-9999)
    band.WriteArray(np.where(np.isfinite(z), z, -9999).astype(np.float32))
    dataset.FlushCache()


@pytest.fixture(scope="module")
def outcome(provider, tmp_path_factory):
    """Heading, convergence and ground of one photograph by both DEMs."""
    import processing

    folder = tmp_path_factory.mktemp("convergence")
    mountains = make_mountains(5, MountainOptions(size=600, cell_m=60.0))
    dems = {crs: folder / f"{crs[5:]}.tif" for crs in SYSTEMS}
    for crs, path in dems.items():
        write_in(crs, mountains, path)
    camera = Camera(800, 600, focal_from_35mm_px(800, 600, 28.0))
    view = render_view(
        open_dem(str(dems["EPSG:32606"])), Observer(LON, LAT, EYE_HEIGHT_M), camera, POSE, SceneOptions(1)
    )
    photo = folder / "photo.jpg"
    metadata = PhotoMetadata(str(photo), 800, 600, latitude_deg=LAT, longitude_deg=LON, focal_length_35mm=28.0)
    write_photo(str(photo), view.pixels, metadata)
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string", "photo", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(LON, LAT)))
    feature.setAttributes([str(photo)])
    layer.dataProvider().addFeature(feature)
    found = {}
    for crs, path in dems.items():
        common = {"DEM": str(path), "MAX_DISTANCE": 12_000, "EYE_HEIGHT": EYE_HEIGHT_M}
        points = processing.run("skylineviewshed:orientphotos", {**common, "INPUT": layer, "OUTPUT": "memory:"})
        row = next(points["OUTPUT"].getFeatures())
        outputs = {"OUTPUT": str(folder / f"seen_{crs[5:]}.tif"), "POLYGONS": "memory:", "SECTOR": 1}
        seen = processing.run("skylineviewshed:directedviewshed", {**common, "INPUT": points["OUTPUT"], **outputs})
        ground = next(seen["POLYGONS"].getFeatures())
        shape = QgsGeometry(ground.geometry())
        to_utm = QgsCoordinateTransform(
            QgsCoordinateReferenceSystem(crs), QgsCoordinateReferenceSystem("EPSG:32606"), QgsProject.instance()
        )
        shape.transform(to_utm)
        found[crs] = {"row": row, "shape": shape.makeValid(), "area_m2": ground["area_m2"]}
    return found


def test_both_find_the_true_heading(outcome):
    headings = [outcome[crs]["row"]["heading"] for crs in SYSTEMS]
    assert headings[0] == pytest.approx(POSE.heading_deg, abs=0.5)
    assert headings[1] == pytest.approx(POSE.heading_deg, abs=0.5)
    assert headings[0] == pytest.approx(headings[1], abs=0.3)


def test_convergence_is_that_of_the_standard_sense(outcome):
    assert outcome["EPSG:3413"]["row"]["grid_conv"] == pytest.approx(-104.5, abs=0.1)
    assert outcome["EPSG:32606"]["row"]["grid_conv"] == pytest.approx(-2.19, abs=0.05)


def test_both_show_the_same_ground_within_a_cell(outcome):
    polar, utm = (outcome[crs]["shape"] for crs in SYSTEMS)
    overlap = polar.intersection(utm).area() / polar.combine(utm).area()
    # Cells at the ragged edge of the visible ground fall differently on the two grids.
    assert overlap > 0.8
    within = utm.buffer(1.5 * CELL_M, 4)
    assert polar.difference(within).area() < 0.05 * polar.area()
    areas = [outcome[crs]["area_m2"] for crs in SYSTEMS]
    assert areas[0] == pytest.approx(areas[1], rel=0.06)
