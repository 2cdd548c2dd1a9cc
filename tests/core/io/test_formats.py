import os
import struct

import pytest
from skyline_viewshed.core.errors import UnreadablePhotoError
from skyline_viewshed.core.io.formats import MAX_PIXELS, check_size, format_of, is_photo_name


def box(kind, payload):
    return struct.pack(">I", 8 + len(payload)) + kind + payload


FTYP = box(b"ftyp", b"heic\0\0\0\0mif1heic")
ILOC = box(b"iloc", bytes.fromhex("00000000 4400 0001 0001 0000 0001") + struct.pack(">II", 8, 16))
META = box(b"meta", bytes(4) + ILOC)
HEADS = {
    "jpeg": b"\xff\xd8\xff\xe0rest",
    "heif": FTYP + META + box(b"mdat", b"pixels"),
    "png": b"\x89PNG\r\n\x1a\nrest",
    "tiff": b"II*\0rest",
    "webp": b"RIFF\0\0\0\0WEBPrest",
}


@pytest.mark.parametrize("kind", HEADS)
def test_content_decides_and_not_the_name(tmp_path, kind):
    for name in ("a.heic", "b.jpg", "c"):
        (tmp_path / name).write_bytes(HEADS[kind])
        assert format_of(tmp_path / name) == kind


def test_a_compatible_brand_is_enough(tmp_path):
    (tmp_path / "a.heic").write_bytes(box(b"ftyp", b"MSNV\0\0\0\0isomheic") + META + box(b"mdat", b""))
    assert format_of(tmp_path / "a.heic") == "heif"


@pytest.mark.parametrize(
    "content, reason",
    [
        (b"", "empty"),
        (b"%PDF-1.7", "no JPEG, HEIC"),
        (b"\0" * 100, "no JPEG, HEIC"),
        (box(b"ftyp", b"qt  \0\0\0\0qt  "), "no JPEG, HEIC"),
        (FTYP + struct.pack(">I", 1000) + b"mdat" + b"half", "ends too early"),
        (FTYP + struct.pack(">I", 1) + b"mdat" + struct.pack(">Q", 10**12), "ends too early"),
        (FTYP + box(b"free", b"") * 20_000, "ends too early"),
        (FTYP + box(b"mdat", b"no directory"), "directory is damaged"),
    ],
)
def test_what_is_no_picture_is_refused_with_the_reason(tmp_path, content, reason):
    (tmp_path / "a.heic").write_bytes(content)
    with pytest.raises(UnreadablePhotoError, match=reason):
        format_of(tmp_path / "a.heic")


def test_something_appended_by_the_maker_does_no_harm(tmp_path):
    (tmp_path / "a.heic").write_bytes(HEADS["heif"] + b"SEFT trailer of some phone")
    (tmp_path / "b.heic").write_bytes(FTYP + META + struct.pack(">I", 0) + b"mdat to the end")
    assert format_of(tmp_path / "a.heic") == "heif"
    assert format_of(tmp_path / "b.heic") == "heif"


def test_missing_files_folders_and_pipes_are_refused_at_once(tmp_path):
    os.mkfifo(tmp_path / "pipe.jpg")
    for path, reason in (
        (tmp_path / "no.jpg", "no such file"),
        (tmp_path, "folder"),
        (tmp_path / "pipe.jpg", "device"),
    ):
        with pytest.raises(UnreadablePhotoError, match=reason):
            format_of(path)
    with pytest.raises(UnreadablePhotoError):
        format_of("bad\0name.jpg")


def test_sizes_have_a_limit():
    check_size("a.jpg", 16_320, 12_240)  # a 200 megapixel phone
    with pytest.raises(UnreadablePhotoError, match="megapixels"):
        check_size("a.jpg", 50_000, 50_000)
    with pytest.raises(UnreadablePhotoError, match="no pixels"):
        check_size("a.jpg", 0, 100)
    assert MAX_PIXELS >= 16_320 * 12_240


def test_names_of_photographs():
    assert all(is_photo_name(name) for name in ("a.jpg", "B.JPG", "c.Jpeg", "d.HEIC", "e.heif", "f.hif"))
    assert not any(is_photo_name(name) for name in ("._a.jpg", ".hidden.heic", "a.tif", "a.png", "jpg", "a.jpg.txt"))
