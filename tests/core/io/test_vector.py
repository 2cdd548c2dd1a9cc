"""Points in GeoPackage, GeoJSON and CSV: all kinds of values, whole or not at all."""

import json
import os
from datetime import datetime

import pytest

ogr = pytest.importorskip("osgeo.ogr")
from skyline_viewshed.core.base.attributes import FieldSpec  # noqa: E402
from skyline_viewshed.core.base.errors import OutputError  # noqa: E402
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto  # noqa: E402
from skyline_viewshed.core.io.vector import PointRow, driver_of, photo_row, point_fields, write_points  # noqa: E402

FIELDS = [FieldSpec(kind, kind, f"a {kind}") for kind in ("text", "real", "whole", "yes", "time")]
VALUES = {"text": 'Höhe "1", 🏔', "real": 0.1, "whole": 7, "yes": True, "time": datetime(2024, 7, 14, 11, 30, 5)}
ROWS = [PointRow((8.1234567, 46.5, 2000.5), VALUES), PointRow(None, {"text": "nowhere"})]


def test_a_geopackage_holds_all_kinds(tmp_path):
    path = tmp_path / "points.gpkg"
    write_points(path, FIELDS, ROWS)
    source = ogr.Open(str(path))
    layer = source.GetLayer(0)
    first, second = layer
    assert layer.GetName() == "points" and layer.GetSpatialRef().GetAuthorityCode(None) == "4326"
    found = first.items()
    assert found["text"] == VALUES["text"] and found["real"] == 0.1 and found["whole"] == 7 and found["yes"] == 1
    assert found["time"].startswith("2024/07/14 11:30:05")
    assert first.GetGeometryRef().GetPoint() == (8.1234567, 46.5, 2000.5)
    assert second.GetGeometryRef() is None and second["real"] is None


def test_geojson_is_longitude_first(tmp_path):
    write_points(tmp_path / "p.geojson", FIELDS, ROWS)
    first, second = json.loads((tmp_path / "p.geojson").read_text(encoding="utf-8"))["features"]
    assert first["geometry"]["coordinates"] == [8.1234567, 46.5, 2000.5]
    assert second["geometry"] is None and second["properties"]["text"] == "nowhere"


def test_an_older_file_stays_until_the_new_one_is_whole(tmp_path):
    path = tmp_path / "p.gpkg"
    write_points(path, FIELDS, ROWS)
    before = path.read_bytes()

    def faulty():
        yield ROWS[0]
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_points(path, FIELDS, faulty())
    assert path.read_bytes() == before and os.listdir(tmp_path) == ["p.gpkg"]
    write_points(path, FIELDS, ROWS[:1])
    source = ogr.Open(str(path))
    assert source.GetLayer(0).GetFeatureCount() == 1


def test_where_nothing_can_be_written_it_says_so(tmp_path):
    with pytest.raises(OutputError, match="the folder .*nowhere does not exist"):
        write_points(tmp_path / "nowhere" / "p.gpkg", FIELDS, ROWS)
    with pytest.raises(ValueError, match="must end in one of .gpkg"):
        driver_of("p.shp")


def test_a_photo_that_failed_keeps_what_its_file_says(scene, painted):
    names = [spec.name for spec in point_fields()]
    assert len(set(names)) == len(names) and names[0] == "photo" and names[-1] == "azim_2"
    path = str(scene.folder / "north.jpg")
    failed = photo_row(OrientedPhoto(path, Orientation("failed", "Why.")), 6e4)
    assert failed.position[:2] == pytest.approx(scene.positions["north"], abs=1e-6)
    assert failed.values["hfov"] == pytest.approx(scene.hfov_deg) and failed.values["heading"] is None
    missing = photo_row(OrientedPhoto("/x/missing.jpg", Orientation("failed", "Why.")), 6e4)
    assert missing.position is None and missing.values["filename"] == "missing"
    assert photo_row(painted(), 6e4).position == (8.0, 46.5, 2000.0)
