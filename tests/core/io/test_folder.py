"""Photographs of a folder, and what is said of the rest."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import SkylineViewshedError
from skyline_viewshed.core.io.folder import list_photos, scan_folder


def test_a_folder_lists_its_photographs_sorted(tmp_path):
    for name in ("b.JPG", "a.heic", "ü ß 🏔.jpeg", "._b.JPG", "notes.txt", "dem.tif"):
        (tmp_path / name).write_bytes(b"x")
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "c.heif").write_bytes(b"x")
    (tmp_path / "folder.jpg").mkdir()
    flat = [path[len(str(tmp_path)) + 1 :] for path in list_photos(tmp_path)]
    assert flat == ["a.heic", "b.JPG", "ü ß 🏔.jpeg"]
    deep = list_photos(str(tmp_path), recursive=True)
    assert len(deep) == 4
    assert deep == sorted(deep)


def test_a_folder_that_contains_itself_ends(tmp_path):
    (tmp_path / "loop").symlink_to(tmp_path)
    (tmp_path / "a.jpg").write_bytes(b"x")
    assert len(list_photos(tmp_path, recursive=True)) == 1


def test_an_empty_folder_is_empty_and_a_missing_one_is_told(tmp_path):
    assert list_photos(tmp_path) == []
    with pytest.raises(SkylineViewshedError, match="cannot be listed"):
        list_photos(tmp_path / "missing")


def test_a_large_folder_is_listed(tmp_path):
    for number in range(2000):
        (tmp_path / f"IMG_{number:05}.JPG").touch()
    assert len(list_photos(tmp_path)) == 2000


def save(path, kind, position=True):
    image = pytest.importorskip("PIL.Image")
    exif = image.Exif()
    if position:
        exif[0x8825] = {1: "N", 2: (46.0, 30.0, 0.0), 3: "E", 4: (8.0, 0.0, 0.0)}
    image.fromarray(np.zeros((6, 8, 3), np.uint8)).save(path, kind, exif=exif.tobytes())


def test_pictures_of_other_formats_and_without_suffix_count_if_they_record_a_position(tmp_path):
    save(tmp_path / "a.png", "PNG")
    save(tmp_path / "b.TIF", "TIFF")
    save(tmp_path / "IMG_0001", "JPEG")
    save(tmp_path / "screenshot.png", "PNG", position=False)
    save(tmp_path / "dem.tif", "TIFF", position=False)
    for name in ("x.dng", "y.DNG", "z.mp4", "README", ".hidden"):
        (tmp_path / name).write_bytes(b"no picture")
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "w.mp4").write_bytes(b"x")
    photos, skipped = scan_folder(str(tmp_path), recursive=True)
    assert [path.rsplit("/", 1)[-1] for path in photos] == ["IMG_0001", "a.png", "b.TIF"]
    assert skipped == {"": 1, ".dng": 2, ".mp4": 2, ".png": 1, ".tif": 1}
