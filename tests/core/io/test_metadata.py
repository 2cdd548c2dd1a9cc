"""Meaning of EXIF tags, on tags as `read_tags` gives them."""

from datetime import datetime

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import DOUBTFUL_FOCAL_SIGMA, FOCAL_SIGMA, focal_from_35mm_px
from skyline_viewshed.core.io.metadata import interpret

NAN = float("nan")
BERNE = {
    "GPSLatitude": (46.0, 57.0, 3.9),
    "GPSLatitudeRef": "N",
    "GPSLongitude": (7.0, 26.0, 19.1),
    "GPSLongitudeRef": "E",
}


def fields(**tags):
    return interpret(tags, 4000, 3000)


def test_without_tags_everything_is_unknown():
    found = fields()
    assert found.pop("orientation") == 1
    assert found.pop("notes") == ()
    assert found.pop("focal_sigma") == FOCAL_SIGMA
    assert found.pop("panorama") is False
    assert set(found.values()) == {None}


@pytest.mark.parametrize(
    "clock, date, expected",
    [
        ((7, 44, 46.26), "2019:11:21", 20_700),  # Nepal, +05:45
        ((13, 29, 40), "2019:11:21", 0),
        ((21, 29, 46), "2019:11:21", -28_800),
        ((1, 29, 45), "2019:11:21", 43_200),
        ((20, 29, 46), "2019:11:20", None),  # 17 hours are no time zone
        ((7, 20, 0), "2019:11:21", None),  # an old fix
        ((7, NAN, 46), "2019:11:21", None),
        ((7, 44, 46), "", None),
        ((7, 44), "2019:11:21", None),
    ],
)
def test_the_zone_of_the_clock_follows_from_the_time_of_the_gps(clock, date, expected):
    tags = {"DateTimeOriginal": "2019:11:21 13:29:46", "GPSTimeStamp": clock, "GPSDateStamp": date}
    assert fields(**tags)["utc_offset_s"] == expected
    assert fields(**tags, OffsetTimeOriginal="+02:00")["utc_offset_s"] == 7200


@pytest.mark.parametrize("south, north_sign", [("N", 1), ("S", -1), ("s", -1)])
@pytest.mark.parametrize("west, east_sign", [("E", 1), ("W", -1), ("w", -1)])
def test_hemispheres(south, north_sign, west, east_sign):
    found = fields(**{**BERNE, "GPSLatitudeRef": south, "GPSLongitudeRef": west})
    assert found["latitude_deg"] == pytest.approx(north_sign * (46 + 57 / 60 + 3.9 / 3600))
    assert found["longitude_deg"] == pytest.approx(east_sign * (7 + 26 / 60 + 19.1 / 3600))


def test_minutes_and_seconds_may_be_missing():
    found = fields(**{**BERNE, "GPSLatitude": (46.951083,), "GPSLongitude": (7.0, 26.318)})
    assert found["latitude_deg"] == pytest.approx(46.951083)
    assert found["longitude_deg"] == pytest.approx(7 + 26.318 / 60)


@pytest.mark.parametrize(
    "latitude, longitude, why",
    [
        ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), "are 0, 0"),
        ((NAN, NAN, NAN), (NAN, NAN, NAN), "not numbers"),
        ((48.0, 53.3, NAN), (21.0, 2.6, NAN), "not numbers"),
        ((46.0, 57.0, float("inf")), (7.0, 26.0, 0.0), "not numbers"),
        ((91.0, 0.0, 0.0), (7.0, 0.0, 0.0), "outside the range of latitude and longitude"),
        ((46.0, 0.0, 0.0), (180.0, 1.0, 0.0), "outside the range of latitude and longitude"),
    ],
)
def test_impossible_coordinates_are_ignored_and_the_reason_kept(latitude, longitude, why):
    found = fields(**{**BERNE, "GPSLatitude": latitude, "GPSLongitude": longitude})
    assert found["latitude_deg"] is None
    assert found["longitude_deg"] is None
    assert why in found["notes"][0]


def test_a_place_on_the_equator_or_the_meridian_is_a_place():
    found = fields(**{**BERNE, "GPSLatitude": (0.0, 0.0, 0.0)})
    assert found["latitude_deg"] == 0
    assert found["longitude_deg"] > 7


@pytest.mark.parametrize("latitude", [(-33.0, 51.0, 30.0), (-33.0, -51.0, -30.0), (-33.858333,), (33.858333,)])
@pytest.mark.parametrize("south, sign", [("N", 1), ("S", -1)])
def test_the_reference_decides_where_the_sign_is_given_twice(latitude, south, sign):
    found = fields(**{**BERNE, "GPSLatitude": latitude, "GPSLatitudeRef": south})
    assert found["latitude_deg"] == pytest.approx(sign * 33.858333, abs=1e-5)
    west = fields(**{**BERNE, "GPSLongitude": (-7.5,), "GPSLongitudeRef": "W"})
    assert west["longitude_deg"] == -7.5


def test_without_a_reference_the_sign_counts():
    found = fields(GPSLatitude=(-46.0, 30.0, 0.0), GPSLongitude=(-7.0,))
    assert (found["latitude_deg"], found["longitude_deg"]) == (-46.5, -7.0)


@pytest.mark.parametrize(
    "tags, error_m, said",
    [
        ({"GPSHPositioningError": (65_000.0,)}, 65_000, None),
        ({"GPSDOP": (3.0,)}, None, None),
        ({"GPSDOP": (3.0,), "GPSHPositioningError": (12.0,)}, 12, None),
        ({"GPSDOP": (99.0,)}, 495, "imprecise (DOP 99)"),
        ({"GPSDOP": (9999.0,), "GPSHPositioningError": (5.0,)}, 49_995, "imprecise (DOP 9999)"),
        ({"GPSStatus": "V"}, 495, "no fix"),
        ({"GPSStatus": "V", "GPSHPositioningError": (5.0,)}, 495, "no fix"),
        ({"GPSStatus": "V", "GPSHPositioningError": (65_000.0,)}, 65_000, "no fix"),
        ({"GPSStatus": "A"}, None, None),
    ],
)
def test_a_receiver_without_a_fix_is_said(tags, error_m, said):
    found = fields(**BERNE, **tags)
    assert found["position_error_m"] == error_m
    assert [note for note in found["notes"] if said and said in note] == list(found["notes"])
    assert bool(found["notes"]) == (said is not None)


def test_half_a_position_is_none():
    assert fields(GPSLatitude=(46.0, 0.0, 0.0), GPSLatitudeRef="N")["latitude_deg"] is None


def test_a_missing_hemisphere_is_told():
    found = fields(GPSLatitude=(46.0, 0.0, 0.0), GPSLongitude=(7.0, 0.0, 0.0))
    assert found["latitude_deg"] == 46
    assert "hemisphere" in found["notes"][0]


@pytest.mark.parametrize(
    "tags, altitude_m, reference",
    [
        ({"GPSAltitude": (2851.07,), "GPSAltitudeRef": (0.0,)}, 2851.07, "sea level"),
        ({"GPSAltitude": (2851.07,)}, 2851.07, "sea level"),
        ({"GPSAltitude": (412.0,), "GPSAltitudeRef": (1.0,)}, -412.0, "below sea level"),
        ({"GPSAltitude": (-412.0,), "GPSAltitudeRef": (1.0,)}, -412.0, "below sea level"),
        ({"GPSAltitude": (500.0,), "GPSAltitudeRef": (2.0,)}, 500.0, "ellipsoid"),
        ({"GPSAltitude": (20.0,), "GPSAltitudeRef": (3.0,)}, -20.0, "ellipsoid"),
        ({"GPSAltitude": (0.0,), "GPSAltitudeRef": (0.0,)}, 0.0, "sea level"),
        ({"GPSAltitudeRef": (0.0,)}, None, None),
        ({"GPSAltitude": (NAN,), "GPSAltitudeRef": (0.0,)}, None, None),
        ({"GPSAltitude": (4e9,)}, None, None),
    ],
)
def test_altitude_and_its_reference(tags, altitude_m, reference):
    found = fields(**tags)
    assert found["altitude_m"] == altitude_m
    assert found["altitude_reference"] == reference


@pytest.mark.parametrize(
    "tags, heading_deg, reference",
    [
        ({"GPSImgDirection": (212.9,), "GPSImgDirectionRef": "T"}, 212.9, "T"),
        ({"GPSImgDirection": (348.0,), "GPSImgDirectionRef": "M"}, 348.0, "M"),
        ({"GPSImgDirection": (360.0,), "GPSImgDirectionRef": "T"}, 0.0, "T"),
        ({"GPSImgDirection": (12.0,)}, 12.0, None),
        ({"GPSImgDirection": (12.0,), "GPSImgDirectionRef": "X"}, 12.0, None),
        ({"GPSImgDirectionRef": "T"}, None, None),
        ({"GPSImgDirection": (700.0,), "GPSImgDirectionRef": "T"}, None, None),
        ({"GPSImgDirection": (NAN,), "GPSImgDirectionRef": "T"}, None, None),
    ],
)
def test_compass_heading_and_its_reference(tags, heading_deg, reference):
    found = fields(**tags)
    assert found["compass_heading_deg"] == heading_deg
    assert found["compass_reference"] == reference


def test_zero_means_unknown_for_lengths_and_errors():
    found = fields(FocalLengthIn35mmFilm=(0.0,), FocalLength=(0.0,), GPSHPositioningError=(0.0,))
    assert found["focal_length_35mm"] is None
    assert found["focal_length_mm"] is None
    assert found["position_error_m"] is None


def test_the_recorded_equivalent_stands_as_it_is():
    # Phones have the digital zoom in it already (Khumbu: 47 to 163 mm with one and the same lens).
    found = fields(FocalLengthIn35mmFilm=(55.0,), FocalLength=(6.86,), DigitalZoomRatio=(1.14,))
    assert found["focal_length_35mm"] == 55
    assert found["notes"] == ()


def full_frame(width_px, height_px, unit, per_unit_mm, **extra):
    """Tags of a 36 x 24 mm sensor whose stored picture has the given size."""
    tags = {
        "FocalLength": (50.0,),
        "FocalPlaneXResolution": (width_px / 36 * per_unit_mm,),
        "FocalPlaneYResolution": (height_px / 24 * per_unit_mm,),
        "FocalPlaneResolutionUnit": (unit,),
        "PixelXDimension": (float(width_px),),
        "PixelYDimension": (float(height_px),),
    }
    return {**tags, **extra}


@pytest.mark.parametrize("unit, per_unit_mm", [(2.0, 25.4), (3.0, 10.0), (4.0, 1.0)])
def test_the_focal_plane_gives_the_equivalent_where_none_is_recorded(unit, per_unit_mm):
    found = interpret(full_frame(6000, 4000, unit, per_unit_mm), 6000, 4000)
    assert found["focal_length_35mm"] == pytest.approx(50.0)
    assert "derived" in found["notes"][0]


def test_a_resampled_copy_keeps_its_field_and_a_cropped_one_shows_less():
    tags = full_frame(6000, 4000, 2.0, 25.4)
    assert interpret(tags, 1500, 1000)["focal_length_35mm"] == pytest.approx(50.0)
    assert interpret(tags, 3000, 3000)["focal_length_35mm"] == pytest.approx(50.0 * np.hypot(6, 4) / np.hypot(3, 3))


CROPS = {
    "not cropped": ((4032, 3024), (4032, 3024), 1.0),
    "turned": ((4032, 3024), (3024, 4032), 1.0),
    "reduced": ((4288, 2848), (858, 570), 1.0),
    "cropped by the phone's own editor": ((4032, 3024), (2566, 3313), np.hypot(4032, 3024) / np.hypot(2566, 3313)),
    "a wide strip": ((4032, 3024), (4032, 2268), np.hypot(4032, 3024) / np.hypot(4032, 2268)),
    "a wide strip, reduced": ((4032, 3024), (1024, 576), np.hypot(4032, 3024) / np.hypot(4032, 2268)),
}


@pytest.mark.parametrize("case", CROPS)
def test_a_crop_narrows_the_field_and_is_said(case):
    (recorded_width, recorded_height), (width, height), factor = CROPS[case]
    tags = {
        "FocalLengthIn35mmFilm": (26.0,),
        "PixelXDimension": (float(recorded_width),),
        "PixelYDimension": (float(recorded_height),),
    }
    found = interpret(tags, width, height)
    assert found["focal_length_35mm"] == pytest.approx(26 * factor, rel=1e-3)
    assert any("The picture is cropped" in note for note in found["notes"]) == (factor > 1)
    # A crop keeps the angle between two pixels: the focal length in pixels is that of the camera's own picture.
    if factor > 1 and width > 2000:
        pixels = focal_from_35mm_px(width, height, found["focal_length_35mm"])
        assert pixels == pytest.approx(focal_from_35mm_px(recorded_width, recorded_height, 26.0))


@pytest.mark.parametrize(
    "size, tags, doubtful",
    [
        ((4032, 3024), {}, False),
        ((2832, 4256), {}, False),
        ((4032, 3024), {"DigitalZoomRatio": (1.0,)}, False),
        ((4032, 3024), {"DigitalZoomRatio": (0.0,)}, False),
        ((4032, 3024), {"DigitalZoomRatio": (1.9,)}, True),
        ((4032, 2268), {}, True),
        ((4032, 2268), {"PixelXDimension": (4032.0,), "PixelYDimension": (3024.0,)}, True),
        ((3000, 3000), {}, True),
    ],
)
def test_zoom_crop_and_odd_shapes_widen_the_belief_in_the_focal_length(size, tags, doubtful):
    found = interpret({"FocalLengthIn35mmFilm": (26.0,), **tags}, *size)
    assert found["focal_sigma"] == (DOUBTFUL_FOCAL_SIGMA if doubtful else FOCAL_SIGMA)


def test_digital_zoom_narrows_a_derived_field():
    tags = full_frame(6000, 4000, 2.0, 25.4, DigitalZoomRatio=(2.0,))
    assert interpret(tags, 6000, 4000)["focal_length_35mm"] == pytest.approx(100.0)


def test_an_impossible_sensor_gives_nothing():
    tags = {**full_frame(6000, 4000, 2.0, 25.4), "FocalPlaneXResolution": (72.0,), "FocalPlaneYResolution": (72.0,)}
    assert interpret(tags, 6000, 4000)["focal_length_35mm"] is None


@pytest.mark.parametrize("recorded", [1.0, 4.0, 7.9, 3001.0, 65535.0])
def test_an_equivalent_that_no_lens_has_is_ignored_and_said(recorded):
    found = fields(FocalLengthIn35mmFilm=(recorded,))
    assert found["focal_length_35mm"] is None
    assert "No lens has the recorded 35 mm equivalent" in found["notes"][0]


@pytest.mark.parametrize("recorded", [8.0, 13.0, 3000.0])
def test_extreme_lenses_are_lenses(recorded):
    assert fields(FocalLengthIn35mmFilm=(recorded,))["focal_length_35mm"] == recorded


def test_an_equivalent_much_shorter_than_the_lens_is_ignored_but_not_that_of_medium_format():
    assert fields(FocalLengthIn35mmFilm=(24.0,), FocalLength=(200.0,))["focal_length_35mm"] is None
    assert fields(FocalLengthIn35mmFilm=(63.0,), FocalLength=(80.0,))["focal_length_35mm"] == 63


def test_an_impossible_equivalent_is_replaced_by_that_of_the_sensor():
    found = interpret({**full_frame(6000, 4000, 2.0, 25.4), "FocalLengthIn35mmFilm": (1.0,)}, 6000, 4000)
    assert found["focal_length_35mm"] == pytest.approx(50.0)


def test_a_focal_length_that_contradicts_the_sensor_is_doubted():
    tags = full_frame(6000, 4000, 2.0, 25.4)
    found = interpret({**tags, "FocalLengthIn35mmFilm": (75.0,)}, 6000, 4000)
    assert found["focal_length_35mm"] == 75
    assert found["focal_sigma"] == pytest.approx(np.log(1.5))
    assert "contradicts" in found["notes"][0]
    assert interpret({**tags, "FocalLengthIn35mmFilm": (52.0,)}, 6000, 4000)["focal_sigma"] == FOCAL_SIGMA


@pytest.mark.parametrize(
    "focal, recorded, zoom, used",
    [
        (4.2, 28.0, 4.0, 112.0),  # else a sensor of 26 mm would be behind a lens of 4.2 mm
        (6.86, 33.0, 1.377, 33.0),  # iPhone 15: 24 mm, and the zoom is in it
        (6.86, 99.0, 2.05, 99.0),
        (15.66, 163.0, 1.36, 163.0),
        (6.86, 26.0, 5.0, 130.0),
        (50.0, 75.0, 2.0, 75.0),
    ],
)
def test_a_digital_zoom_that_the_equivalent_leaves_out_is_applied(focal, recorded, zoom, used):
    found = fields(FocalLength=(focal,), FocalLengthIn35mmFilm=(recorded,), DigitalZoomRatio=(zoom,))
    assert found["focal_length_35mm"] == pytest.approx(used)
    assert any("leaves out the digital zoom" in note for note in found["notes"]) == (used != recorded)


PANORAMAS = {
    "GPano": {
        "ProjectionType": "cylindrical",
        "FullPanoWidthPixels": (8000.0,),
        "CroppedAreaImageWidthPixels": (4000.0,),
    },
    "GPano, equirectangular": {"ProjectionType": "equirectangular"},
    "a phone's sweep": {"CustomRendered": (6.0,)},
    "a stitching program": {"Software": "Hugin 2022.0.0"},
    "larger than the camera's frame": {"PixelXDimension": (3000.0,), "PixelYDimension": (2000.0,)},
}


@pytest.mark.parametrize("case", PANORAMAS)
def test_a_panorama_has_no_focal_length(case):
    found = interpret({"FocalLengthIn35mmFilm": (26.0,), **PANORAMAS[case]}, 5000, 1000)
    assert found["panorama"]
    assert found["focal_length_35mm"] is None
    assert "is a panorama" in found["notes"][0]
    assert ("180 degrees" in found["notes"][0]) == (case == "GPano")


@pytest.mark.parametrize(
    "tags", [{}, {"CustomRendered": (8.0,)}, {"ProjectionType": "rectilinear"}, {"Software": "17.0"}]
)
def test_a_wide_crop_or_a_portrait_mode_is_no_panorama(tags):
    assert not interpret({"FocalLengthIn35mmFilm": (26.0,), **tags}, 5000, 1000)["panorama"]


@pytest.mark.parametrize("recorded, orientation", [(6.0, 6), (0.0, 1), (9.0, 1), (NAN, 1), (2.5, 1)])
def test_orientation_is_1_to_8(recorded, orientation):
    assert fields(Orientation=(recorded,))["orientation"] == orientation


def test_time_falls_back_and_nonsense_is_unknown():
    assert fields(DateTimeOriginal="2023:10:27 06:47:48")["taken_at"] == datetime(2023, 10, 27, 6, 47, 48)
    assert fields(DateTimeOriginal="    ", DateTime="2020:01:02 03:04:05")["taken_at"] == datetime(2020, 1, 2, 3, 4, 5)
    assert fields(DateTimeOriginal="0000:00:00 00:00:00")["taken_at"] is None


def test_maker_and_model_are_joined_without_repetition():
    assert fields(Make="Apple", Model="iPhone 15")["camera"] == "Apple iPhone 15"
    assert fields(Make="Canon", Model="Canon EOS 5D")["camera"] == "Canon EOS 5D"
    assert fields(Model="X100")["camera"] == "X100"
    assert fields(Make="Apple")["camera"] == "Apple"


NUMBERS = st.lists(st.floats(allow_nan=True, allow_infinity=True), min_size=1, max_size=4).map(tuple)
NAMES = ["GPSLatitude", "GPSLongitude", "GPSAltitude", "GPSAltitudeRef", "GPSImgDirection", "GPSHPositioningError",
         "FocalLength", "FocalLengthIn35mmFilm", "FocalPlaneXResolution", "FocalPlaneYResolution", "Orientation",
         "FocalPlaneResolutionUnit", "PixelXDimension", "PixelYDimension", "DigitalZoomRatio", "GPSDOP",
         "CustomRendered", "FullPanoWidthPixels", "CroppedAreaImageWidthPixels"]  # fmt: skip
TEXTS = ["GPSLatitudeRef", "GPSLongitudeRef", "GPSImgDirectionRef", "DateTimeOriginal", "DateTime", "Make", "Model",
         "GPSStatus", "Software", "ProjectionType"]  # fmt: skip


@settings(max_examples=300, deadline=None, derandomize=True, database=None)
@given(st.dictionaries(st.sampled_from(NAMES), NUMBERS), st.dictionaries(st.sampled_from(TEXTS), st.text(max_size=30)))
def test_whatever_the_tags_say_the_fields_are_finite_and_in_range(numbers, texts):
    found = interpret({**numbers, **texts}, 4000, 3000)
    for name in ("altitude_m", "focal_length_35mm", "focal_length_mm", "compass_heading_deg", "position_error_m"):
        assert found[name] is None or np.isfinite(found[name])
    if found["latitude_deg"] is not None:
        assert abs(found["latitude_deg"]) <= 90
        assert abs(found["longitude_deg"]) <= 180
    assert found["compass_heading_deg"] is None or 0 <= found["compass_heading_deg"] < 360


def test_maker_model_and_lens_are_kept_as_the_file_has_them():
    tags = {"Make": "NIKON CORPORATION", "Model": "NIKON D200", "LensModel": "AF Nikkor 20mm f/2.8D"}
    found = interpret(tags, 100, 80)
    assert (found["make"], found["model"], found["lens"]) == tuple(tags.values())
    assert interpret({}, 100, 80)["lens"] is None
