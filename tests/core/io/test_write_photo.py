from __future__ import annotations

import os
import sys
from datetime import datetime

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import MissingPackageError, OutputError
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.io.photo import read_metadata, read_photo
from skyline_viewshed.core.io.write_photo import write_photo

HEIF = pytest.mark.skipif(sys.modules.get("pillow_heif", 0) is None, reason="pillow-heif is blocked")


def gradient(height=60, width=90):
    pixels = np.zeros((height, width, 3), np.uint8)
    pixels[..., 0] = np.linspace(0, 250, width)[None, :]
    pixels[..., 1] = np.linspace(0, 250, height)[:, None]
    return pixels


def facts(**changes):
    values = {
        "latitude_deg": -27.835497,
        "longitude_deg": -86.764236,
        "altitude_m": 3865.7,
        "altitude_reference": "sea level",
        "focal_length_35mm": 47.0,
        "focal_length_mm": 5.96,
        "compass_heading_deg": 243.25,
        "compass_reference": "M",
        "position_error_m": 4.75,
        "taken_at": datetime(2024, 10, 29, 6, 12, 5),
        "camera": "Apple iPhone 15",
    }
    return PhotoMetadata("", 90, 60, **{**values, **changes})


@pytest.mark.parametrize("suffix", [".jpg", pytest.param(".heic", marks=HEIF)])
def test_every_fact_comes_back_as_it_was_written(tmp_path, suffix):
    path = str(tmp_path / ("photo" + suffix))
    write_photo(path, gradient(), facts())
    found = read_metadata(path)
    wanted = facts()
    assert found.latitude_deg == pytest.approx(wanted.latitude_deg, abs=1e-8)
    assert found.longitude_deg == pytest.approx(wanted.longitude_deg, abs=1e-8)
    assert (found.width_px, found.height_px) == (90, 60)
    for name in (
        "altitude_m",
        "altitude_reference",
        "focal_length_35mm",
        "focal_length_mm",
        "compass_heading_deg",
        "compass_reference",
        "position_error_m",
        "taken_at",
        "camera",
    ):
        assert getattr(found, name) == getattr(wanted, name), name


@pytest.mark.parametrize("suffix", [".jpg", pytest.param(".heic", marks=HEIF)])
def test_pixels_come_back_upright_and_nearly_unchanged(tmp_path, suffix):
    path = str(tmp_path / ("photo" + suffix))
    write_photo(path, gradient(), facts(), quality=95)
    assert np.abs(read_photo(path).pixels.astype(int) - gradient()).mean() < 4


@pytest.mark.parametrize("orientation", range(1, 9))
def test_a_jpeg_stored_turned_reads_upright(tmp_path, orientation):
    path = str(tmp_path / "turned.jpg")
    write_photo(path, gradient(), facts(orientation=orientation), quality=96)
    photo = read_photo(path)
    assert photo.metadata.orientation == orientation
    assert photo.pixels.shape == gradient().shape
    assert np.abs(photo.pixels.astype(int) - gradient()).mean() < 4


def test_what_is_unknown_is_not_written(tmp_path):
    path = str(tmp_path / "bare.jpg")
    write_photo(path, gradient(), PhotoMetadata("", 90, 60))
    found = read_metadata(path)
    for name in ("latitude_deg", "altitude_m", "focal_length_35mm", "compass_heading_deg", "taken_at", "camera"):
        assert getattr(found, name) is None, name


def test_below_the_sea_and_above_the_ellipsoid_are_kept(tmp_path):
    for altitude, reference in ((-12.5, "below sea level"), (163.52, "ellipsoid")):
        path = str(tmp_path / "altitude.jpg")
        write_photo(path, gradient(), facts(altitude_m=altitude, altitude_reference=reference))
        found = read_metadata(path)
        assert (found.altitude_m, found.altitude_reference) == (altitude, reference)


def test_heic_without_pillow_heif_says_what_to_install_and_jpeg_still_works(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pillow_heif", None)
    with pytest.raises(MissingPackageError, match="pillow-heif"):
        write_photo(str(tmp_path / "photo.heic"), gradient(), facts())
    assert os.listdir(tmp_path) == []
    write_photo(str(tmp_path / "photo.jpg"), gradient(), facts())
    assert os.listdir(tmp_path) == ["photo.jpg"]


def test_a_missing_folder_and_an_unknown_suffix_are_told(tmp_path):
    with pytest.raises(OutputError, match="cannot be written"):
        write_photo(str(tmp_path / "nowhere" / "photo.jpg"), gradient(), facts())
    with pytest.raises(OutputError, match="jpg or"):
        write_photo(str(tmp_path / "photo.bmp"), gradient(), facts())


def test_wrong_pixels_are_a_callers_fault(tmp_path):
    with pytest.raises(ValueError, match="uint8"):
        write_photo(str(tmp_path / "photo.jpg"), np.zeros((4, 4, 3)), facts())
