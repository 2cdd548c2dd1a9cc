"""Thumbnails before the picture in TIFF files, and raw files."""

import struct

import numpy as np
import pytest
from osgeo import gdal
from PIL import Image
from skyline_viewshed.core.base.errors import UnreadablePhotoError
from skyline_viewshed.core.io.formats import format_of


def pages(path, *sizes, **options):
    pictures = [Image.fromarray(np.full((height, width, 3), 90, np.uint8)) for width, height in sizes]
    pictures[0].save(path, "TIFF", save_all=True, append_images=pictures[1:], **options)
    return path


@pytest.mark.parametrize("big", [False, True])
def test_a_first_page_that_is_smaller_than_another_is_refused(tmp_path, big):
    path = pages(tmp_path / "a.tif", (16, 12), (64, 48), big_tiff=big)
    with pytest.raises(UnreadablePhotoError, match="first page of 16 x 12 pixels is a thumbnail"):
        format_of(path)


def test_thumbnails_behind_the_picture_do_no_harm(tmp_path):
    assert format_of(pages(tmp_path / "a.tif", (64, 48), (16, 12))) == "tiff"
    assert format_of(pages(tmp_path / "b.tif", (64, 48))) == "tiff"


def directory(entries, following=0, order="<"):
    body = b"".join(struct.pack(order + "HHII", tag, 4, 1, value) for tag, value in sorted(entries.items()))
    return struct.pack(order + "H", len(entries)) + body + struct.pack(order + "I", following)


@pytest.mark.parametrize("order, mark", [("<", b"II"), (">", b"MM")])
def test_a_thumbnail_whose_picture_is_in_a_sub_directory_is_refused(tmp_path, order, mark):
    first = directory({254: 1, 256: 160, 257: 120, 330: 100}, order=order)
    content = mark + struct.pack(order + "HI", 42, 8) + first
    content = content.ljust(100, b"\0") + directory({254: 0, 256: 4000, 257: 3000}, order=order)
    (tmp_path / "a.nef").write_bytes(content)
    with pytest.raises(UnreadablePhotoError, match="160 x 120 pixels is a thumbnail"):
        format_of(tmp_path / "a.nef")


@pytest.mark.parametrize("entries, prefix", [({50706: 1}, b""), ({262: 32803}, b""), ({256: 10}, b"CR\2\0")])
def test_raw_files_are_called_raw(tmp_path, entries, prefix):
    start = 8 + len(prefix)
    (tmp_path / "a.dng").write_bytes(b"II*\0" + struct.pack("<I", start) + prefix + directory(entries))
    with pytest.raises(UnreadablePhotoError, match="raw file of a camera, which must be exported as JPEG"):
        format_of(tmp_path / "a.dng")


@pytest.mark.parametrize("loop", [8, 9999])
def test_directories_that_point_at_themselves_or_nowhere_end(tmp_path, loop):
    (tmp_path / "a.tif").write_bytes(b"II*\0" + struct.pack("<I", 8) + directory({256: 10, 257: 10}, loop))
    assert format_of(tmp_path / "a.tif") == "tiff"


def test_a_geotiff_with_overviews_is_one_picture(tmp_path):
    dataset = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "a.tif"), 256, 256, 3)
    dataset.BuildOverviews("NEAREST", [2, 4])
    del dataset
    assert format_of(tmp_path / "a.tif") == "tiff"
