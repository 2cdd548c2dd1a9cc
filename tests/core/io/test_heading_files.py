"""Headings for other programs: read back by the readers of XMP, KML and CSV, and by EXIF's own rules."""

from __future__ import annotations

import csv
import io
import zipfile
from fractions import Fraction
from xml.etree import ElementTree

import pytest
from skyline_viewshed.core.io.heading_files import PhotoHeading, csv_text, is_ours, kml_text, kmz_bytes, xmp_text

EXIF, CAMERA = "{http://ns.adobe.com/exif/1.0/}", "{http://pix4d.com/camera/1.0/}"
KML = "{http://www.opengis.net/kml/2.2}"
SHOT = PhotoHeading(
    "/p/a & <b>.jpg", 123.456, 8.5, 46.25, 2100.04, -3.21, 1.5, 60.0, 45.0, 122.5, 124.5, 0.98765, "accepted"
)


def description(shot):
    tree = ElementTree.fromstring(xmp_text(shot).split("?>", 1)[1].rsplit("<?xpacket", 1)[0])
    return tree[0][0].attrib


def test_the_sidecar_has_the_direction_against_true_north_and_the_camera_s_angles():
    tags = description(SHOT)
    assert Fraction(tags[f"{EXIF}GPSImgDirection"]) == Fraction("123.46")
    assert tags[f"{EXIF}GPSImgDirectionRef"] == "T"
    # Pix4D's pitch counts from straight down.
    assert (tags[f"{CAMERA}Yaw"], tags[f"{CAMERA}Pitch"], tags[f"{CAMERA}Roll"]) == ("123.46", "86.79", "1.50")


@pytest.mark.parametrize("heading", [359.999, 360.0, 0.0, -0.001])
def test_north_is_zero_and_never_360(heading):
    shot = PhotoHeading("/p/a.jpg", heading, 8.0, 46.0)
    assert Fraction(description(shot)[f"{EXIF}GPSImgDirection"]) == 0
    assert "<heading>0.00</heading>" in kml_text([shot], ["a.jpg"], "t")
    assert next(csv.DictReader(io.StringIO(csv_text([shot]))))["heading_deg"] == "0.00"


def test_what_is_unknown_is_left_out():
    shot = PhotoHeading("/p/a.jpg", 10.0)
    assert [name for name in description(shot) if "Pitch" in name or "Roll" in name or "Status" in name] == []
    row = next(csv.DictReader(io.StringIO(csv_text([shot]))))
    assert row["longitude"] == row["pitch_deg"] == row["status"] == ""
    assert "PhotoOverlay" not in kml_text([shot], ["a.jpg"], "t"), "no position, no overlay"


def test_only_our_own_sidecars_may_be_replaced(tmp_path):
    ours, foreign = tmp_path / "a.xmp", tmp_path / "b.xmp"
    ours.write_text(xmp_text(SHOT), encoding="utf-8")
    foreign.write_bytes(b'<x:xmpmeta x:xmptk="Adobe XMP Core"/>\xff')
    assert is_ours(ours) and is_ours(tmp_path / "new.xmp") and not is_ours(foreign)
    assert not is_ours(tmp_path), "what cannot be read is left alone"


def test_google_earth_gets_camera_picture_and_field_of_view():
    tree = ElementTree.fromstring(kml_text([SHOT], ["files/a%20b.jpg"], "T & t").encode())
    (overlay,) = tree.iter(f"{KML}PhotoOverlay")
    text = {node.tag[len(KML) :]: node.text for node in overlay.iter()}
    assert (text["heading"], text["tilt"], text["roll"]) == ("123.46", "86.79", "1.50")
    assert (text["longitude"], text["latitude"], text["altitude"]) == ("8.5000000", "46.2500000", "2100.0")
    assert (text["leftFov"], text["topFov"], text["altitudeMode"]) == ("-30.00", "22.50", "absolute")
    assert (text["href"], text["name"]) == ("files/a%20b.jpg", "a & <b>.jpg")


def test_kmz_holds_the_document_and_the_pictures():
    with zipfile.ZipFile(io.BytesIO(kmz_bytes("<kml/>", [("files/a.jpg", b"\xff\xd8")]))) as archive:
        assert archive.namelist() == ["doc.kml", "files/a.jpg"] and archive.read("files/a.jpg") == b"\xff\xd8"


def test_the_table_has_the_decimals_that_values_deserve():
    row = next(csv.DictReader(io.StringIO(csv_text([SHOT]))))
    assert (row["heading_deg"], row["elevation_m"], row["p_correct"]) == ("123.46", "2100.0", "0.988")
