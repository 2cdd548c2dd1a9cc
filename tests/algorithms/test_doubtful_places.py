"""Points whose place or height is unlikely: every step that computes terrain from them says so."""

import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsVectorLayer
from skyline_viewshed.algorithms.shared.doubtful_places import warn_of_place
from skyline_viewshed.algorithms.shared.layers import PointRow
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.io.raster import open_dem

FIELDS = ["heading", "pitch", "roll", "hfov", "vfov", "eye_z", "h_acc"]


def point_of(scene, shift_deg=0.0, **values):
    """Layer with the scene's north photo, oriented, and these values."""
    pose, (lon, lat) = scene.truth["north"], scene.positions["north"]
    known = {"heading": pose.heading_deg, "pitch": pose.pitch_deg, "roll": 0.0, "hfov": scene.hfov_deg, "vfov": 49.7}
    columns = "&".join(f"field={name}:double" for name in FIELDS)
    layer = QgsVectorLayer(f"Point?crs=EPSG:4326&field=photo:string&{columns}", "points", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(lon + shift_deg, lat)))
    known.update(values)
    feature.setAttributes([str(scene.folder / "north.jpg"), *(known.get(name) for name in FIELDS)])
    layer.dataProvider().addFeature(feature)
    return layer


def said(scene, listener, eye_m=None, **values):
    layer, feedback = point_of(scene, **values), listener()
    feature = next(layer.getFeatures())
    lon, lat = scene.positions["north"]
    dem = open_dem(str(scene.dem))
    warn_of_place(feedback, PointRow(feature, "north", lon, lat), dem, Observer(lon, lat, 1.7, eye_m))
    return feedback.warnings


@pytest.mark.parametrize("error_m, warns", [(None, False), (20.0, False), (999.0, False), (1000.0, True), (65e3, True)])
def test_a_position_that_is_uncertain_by_a_kilometre_is_said(scene, listener, error_m, warns):
    found = said(scene, listener, h_acc=error_m)
    assert bool(found) == warns
    assert not warns or "clear h_acc" in found[0] and f"{error_m / 1000:.1f} km" in found[0]


def test_an_eye_off_the_ground_is_said_and_a_drone_is_not(scene, listener):
    from skyline_viewshed.core.base.terrain import ground_elevation_m

    dem = open_dem(str(scene.dem))
    ground_m = ground_elevation_m(dem, dem.frame(*scene.positions["north"], 1_000.0))
    for above_m in (-50.0, 0.0, 500.0):
        assert said(scene, listener, ground_m + above_m) == []
    (below,) = said(scene, listener, ground_m - 300.0)
    assert "300 m below the DEM's surface" in below and "HEIGHT_FIELD" in below
    (above,) = said(scene, listener, ground_m + 4500.0)
    assert "4500 m above the DEM's surface" in above


STEPS = {
    "directedviewshed": {"MAX_DISTANCE": 500.0, "OUTPUT": "seen.tif"},
    "horizonprofile": {"MAX_DISTANCE": 500.0, "AZIMUTH_STEP": 90.0, "OUTPUT": "memory:"},
    "panorama": {"MAX_DISTANCE": 500.0, "AZIMUTH_STEP": 5.0, "FOLDER": "folder"},
    "labelpeaks": {"MAX_DISTANCE": 500.0, "OUTPUT": "memory:"},
}


@pytest.mark.parametrize("step", STEPS)
def test_each_step_that_computes_terrain_warns_once(run, scene, tmp_path, step):
    files = {
        name: str(tmp_path / value) if value in ("seen.tif", "folder") else value for name, value in STEPS[step].items()
    }
    given = {"INPUT": point_of(scene, h_acc=238e3), "DEM": str(scene.dem), **files}
    _, feedback = run(step, given)
    assert [warning for warning in feedback.warnings if "uncertain by 238.0 km" in warning] == [
        "north.jpg: " + feedback.warnings[0].split(": ", 1)[1]
    ]


def test_a_height_above_the_sea_given_as_one_above_the_ground_is_said(run, scene):
    given = {"DEM": str(scene.dem), "MAX_DISTANCE": 500.0, "AZIMUTH_STEP": 90.0, "OUTPUT": "memory:"}
    _, feedback = run("horizonprofile", {"INPUT": point_of(scene), **given, "EYE_HEIGHT": 2300.0})
    assert "2300 m above the DEM's surface" in feedback.warnings[0] and "EYE_HEIGHT" in feedback.warnings[0]


def test_a_point_off_the_dem_has_its_own_message_only(run, scene):
    given = {"DEM": str(scene.dem), "MAX_DISTANCE": 500.0, "AZIMUTH_STEP": 90.0, "OUTPUT": "memory:"}
    _, feedback = run("horizonprofile", {"INPUT": point_of(scene, shift_deg=30.0), **given})
    assert len(feedback.warnings) == 1 and "outside the DEM" in feedback.warnings[0]
