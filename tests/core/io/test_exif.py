"""Three EXIF readers, one answer."""

import io
import sys

import pytest
from PIL import Image
from PIL.TiffImagePlugin import IFDRational
from skyline_viewshed.core.io import exif
from skyline_viewshed.core.io.formats import format_of
from skyline_viewshed.core.io.metadata import interpret

READERS = {"exifread": exif._by_exifread, "pillow": exif._by_pillow, "gdal": exif._by_gdal}
LAST_RESORT_TOLERANCE = 1e-5
"""GDAL prints fractions with six digits."""


def photo_bytes(**changes):
    """A small JPEG with the tags of a phone; `changes` by tag number, 'gps' and 'exif' for the directories."""
    tags = Image.Exif()
    tags[0x010F], tags[0x0110], tags[0x0112] = "Fabrikat", "Modell 1", changes.get("orientation", 6)
    details = tags.get_ifd(0x8769)
    details.update({0x9003: "2024:07:01 12:30:00", 0x920A: IFDRational(343, 50), 0xA405: 24, 0xA002: 64, 0xA003: 48})
    details.update(changes.get("exif", {}))
    position = tags.get_ifd(0x8825)
    position.update(
        {1: "S", 2: (43.0, 35.0, 42.0), 3: "W", 4: (7.0, 26.0, 19.5), 5: b"\x01", 6: 12.5, 16: "M", 17: 271.25, 31: 4.5}
    )
    position.update(changes.get("gps", {}))
    memory = io.BytesIO()
    Image.new("RGB", (64, 48), (90, 120, 150)).save(memory, "JPEG", exif=tags)
    return memory.getvalue()


def installed(name):
    return {"exifread": "exifread", "pillow": "PIL", "gdal": "osgeo"}[name] not in [
        module for module, loaded in sys.modules.items() if loaded is None
    ]


@pytest.fixture
def phone_photo(tmp_path):
    path = tmp_path / "phone.jpg"
    path.write_bytes(photo_bytes())
    return str(path)


@pytest.mark.parametrize("name", READERS)
def test_each_reader_finds_every_tag(phone_photo, name):
    if not installed(name):
        pytest.skip(f"{name} is blocked")
    found = interpret(READERS[name](phone_photo, "jpeg"), 64, 48)
    assert found["latitude_deg"] == pytest.approx(-(43 + 35 / 60 + 42 / 3600), abs=1e-7)
    assert found["longitude_deg"] == pytest.approx(-(7 + 26 / 60 + 19.5 / 3600), abs=1e-7)
    assert (found["altitude_m"], found["altitude_reference"]) == (-12.5, "below sea level")
    assert (found["compass_heading_deg"], found["compass_reference"]) == (271.25, "M")
    assert (found["focal_length_35mm"], found["focal_length_mm"]) == (24, pytest.approx(6.86))
    assert found["orientation"] == 6
    assert found["camera"] == "Fabrikat Modell 1"
    assert found["taken_at"].isoformat() == "2024-07-01T12:30:00"
    if name != "gdal":  # its table of tags is older than this one
        assert found["position_error_m"] == 4.5


@pytest.mark.data
def test_readers_agree_on_every_real_photograph(shared_data):
    paths = sorted(
        [*shared_data.glob("exif/*/*"), *shared_data.glob("khumbu/photos/*"), *shared_data.glob("columbia/photos/*")]
    )
    compared = 0
    for path in paths:
        if path.stem.startswith("pillowheif_c") or path.stem.startswith("pillowheif_e"):
            continue
        kind = format_of(path)
        answers = {
            name: interpret(reader(str(path), kind), 100, 100) for name, reader in READERS.items() if installed(name)
        }
        answers = {name: answer for name, answer in answers.items() if READERS[name](str(path), kind)}
        for name, answer in answers.items():
            if path.name == "nikon_d5000.jpg" and name == "gdal":
                continue  # GDAL prints 0/0 seconds as 0
            for field, value in next(iter(answers.values())).items():
                if field == "notes" and name == "gdal":
                    continue
                if isinstance(value, float):
                    assert answer[field] == pytest.approx(value, rel=LAST_RESORT_TOLERANCE), (path.name, name, field)
                else:
                    assert answer[field] == value, (path.name, name, field)
                compared += 1
    assert compared > 500


@pytest.mark.parametrize("name", READERS)
def test_floating_point_instead_of_fractions_is_understood(tmp_path, name):
    if not installed(name):
        pytest.skip(f"{name} is blocked")
    path = tmp_path / "a.jpg"
    path.write_bytes(photo_bytes(exif={0x920A: 6.86}))
    assert READERS[name](str(path), "jpeg")["FocalLength"][0] == pytest.approx(6.86)


def test_a_reader_that_breaks_hands_over(phone_photo, monkeypatch):
    def broken(*_, **__):
        raise AssertionError

    exifread = pytest.importorskip("exifread")
    monkeypatch.setattr(exifread, "process_file", broken)
    assert exif.read_tags(phone_photo, "jpeg")["FocalLengthIn35mmFilm"] == (24.0,)


@pytest.mark.parametrize("blocked", [("exifread",), ("exifread", "PIL", "PIL.Image", "PIL.JpegImagePlugin")])
def test_missing_packages_change_nothing(phone_photo, monkeypatch, blocked):
    expected = interpret(exif.read_tags(phone_photo, "jpeg"), 64, 48)
    for module in blocked:
        monkeypatch.setitem(sys.modules, module, None)
    found = interpret(exif.read_tags(phone_photo, "jpeg"), 64, 48)
    found["position_error_m"] = expected["position_error_m"]  # GDAL 3.6 does not know the tag
    assert {key: value for key, value in found.items() if not isinstance(value, float)} == {
        key: value for key, value in expected.items() if not isinstance(value, float)
    }
    for key, value in expected.items():
        if isinstance(value, float):
            assert found[key] == pytest.approx(value, rel=LAST_RESORT_TOLERANCE)


def test_hostile_texts_are_cut_and_cleaned(tmp_path):
    tags = Image.Exif()
    tags[0x010F] = "A" * 5000
    tags[0x0110] = "line\nbreak\x1b[31m"
    path = tmp_path / "a.jpg"
    Image.new("RGB", (8, 8)).save(path, exif=tags)
    found = exif.read_tags(str(path), "jpeg")
    assert len(found["Make"]) == 200
    assert found["Model"].isprintable()


def test_fractions_over_zero_are_nan(tmp_path):
    path = tmp_path / "a.jpg"
    # 271.25 is stored as 1085/4; make its denominator 0.
    content = photo_bytes()
    needle = (1085).to_bytes(4, "big") + (4).to_bytes(4, "big")
    if needle not in content:
        needle = (1085).to_bytes(4, "little") + (4).to_bytes(4, "little")
    path.write_bytes(content.replace(needle, needle[:4] + bytes(4)))
    assert needle in content
    assert interpret(exif.read_tags(str(path), "jpeg"), 64, 48)["compass_heading_deg"] is None


def test_a_picture_without_metadata_has_none(tmp_path):
    path = tmp_path / "a.jpg"
    Image.new("RGB", (8, 8)).save(path)
    assert exif.read_tags(str(path), "jpeg") == {}


@pytest.mark.parametrize("text", [b"Maker", b"\xff\xfe\xfdab", b"1e2.3"])
def test_a_number_that_is_text_harms_no_other_tag(tmp_path, text):
    """Found by fuzzing: GDAL hands over text where a number belongs, and bytes where the text is no UTF-8."""
    path = tmp_path / "photo.jpg"
    path.write_bytes(photo_bytes(exif={0xA002: "Maker", 0xA405: 24}).replace(b"Maker", text))
    for name, reader in READERS.items():
        if installed(name):
            tags = reader(str(path), "jpeg")
            assert tags["FocalLengthIn35mmFilm"] == (24.0,), name
            assert all(isinstance(value, float) for value in tags.get("PixelXDimension", ())), name
