"""Angles that drones record in XMP, by their makers' conventions."""

import numpy as np
import pytest
from PIL import Image
from skyline_viewshed.core.io.gimbal import PREFIXES, gimbal_tags
from skyline_viewshed.core.io.photo import read_metadata

DJI = {"GimbalYawDegree": "-117.30", "GimbalPitchDegree": "-4.50", "GimbalRollDegree": "+0.20"}
PACKET = """<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF><rdf:Description {attributes}/></rdf:RDF></x:xmpmeta>"""


def tags(prefix, **properties):
    return gimbal_tags({**{known: {} for known in PREFIXES}, prefix: properties})


@pytest.mark.parametrize(
    "prefix, properties",
    [
        ("drone-dji", DJI),
        ("drone-parrot", {"CameraYawDegree": "-117.3", "CameraPitchDegree": "-4.5", "CameraRollDegree": "0.2"}),
        ("Camera", {"Yaw": "-117.300000", "Pitch": "85.500000", "Roll": "0.200000"}),
        ("Camera", {"Yaw": "-11730/100", "Pitch": "8550/100", "Roll": "20/100"}),
    ],
)
def test_every_convention_gives_the_same_angles(prefix, properties):
    found = {name: value for name, (value,) in tags(prefix, **properties).items()}
    assert found == pytest.approx({"GimbalYaw": -117.3, "GimbalPitch": -4.5, "GimbalRoll": 0.2})


def test_missing_pitch_and_roll_are_left_out():
    assert tags("drone-dji", GimbalYawDegree="12.5") == {"GimbalYaw": (12.5,)}


@pytest.mark.parametrize(
    "properties",
    [
        {},
        {"Pitch": "85"},
        {"Yaw": "north"},
        {"Yaw": "nan"},
        {"Yaw": "1/0"},
        {"Yaw": "9999"},
        {"Yaw": "0/100", "Pitch": "0/100", "Roll": "0/100"},
    ],
)
def test_without_a_measured_yaw_there_is_nothing(properties):
    assert tags("Camera", **properties) == {}


def drone_photo(path, direction_deg=None):
    """JPEG with DJI's properties in its XMP, and GPSImgDirection (magnetic) if given."""
    attributes = " ".join(f'drone-dji:{name}="{text}"' for name, text in DJI.items())
    exif = Image.Exif()
    exif[0x010F] = "DJI"
    if direction_deg is not None:
        exif.get_ifd(0x8825).update({16: "M", 17: direction_deg})
    picture = Image.fromarray(np.zeros((30, 40, 3), np.uint8))
    picture.save(path, exif=exif, xmp=PACKET.format(attributes=attributes).encode())
    return str(path)


def test_the_yaw_is_the_recorded_true_heading_of_a_photo_without_one(tmp_path):
    found = read_metadata(drone_photo(tmp_path / "a.jpg"))
    assert found.compass_heading_deg == pytest.approx(242.7)
    assert found.compass_reference == "T"
    assert (found.gimbal_pitch_deg, found.gimbal_roll_deg) == (-4.5, 0.2)


def test_a_recorded_direction_takes_precedence(tmp_path):
    found = read_metadata(drone_photo(tmp_path / "a.jpg", 100.0))
    assert (found.compass_heading_deg, found.compass_reference) == (100.0, "M")
