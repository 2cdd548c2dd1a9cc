import os
import struct

import pytest
from skyline_viewshed.core.base.errors import UnreadablePhotoError
from skyline_viewshed.core.io.formats import MAX_PIXELS, check_size, format_of, is_photo_name, is_whole


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
        (b"%PDF-1.7", "not a JPEG, HEIC"),
        (b"\0" * 100, "not a JPEG, HEIC"),
        (box(b"ftyp", b"qt  \0\0\0\0qt  "), "not a JPEG, HEIC"),
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


def location_box(extents, version=0, method=0, base=0, sizes=0x4440):
    """ItemLocationBox with one item per (offset, length)."""
    wide = ">I" if version == 2 else ">H"
    content = struct.pack(">BxxxH", version, sizes) + struct.pack(wide, len(extents))
    for number, (offset, length) in enumerate(extents, start=1):
        content += struct.pack(wide, number) + (struct.pack(">H", method) if version else b"")
        content += struct.pack(">HIHII", 0, base, 1, offset, length)
    return box(b"iloc", content)


def whole(tmp_path, *boxes):
    (tmp_path / "a.heic").write_bytes(b"".join(boxes))
    return is_whole(tmp_path / "a.heic")


def meta(*children):
    return box(b"meta", bytes(4) + b"".join(children))


@pytest.mark.parametrize("version", [0, 1, 2])
def test_extents_within_the_file_are_whole_and_one_byte_further_is_not(tmp_path, version):
    size = len(FTYP) + len(meta(location_box([(0, 0)], version))) + 8 + 50
    pixels = box(b"mdat", bytes(50))
    assert whole(tmp_path, FTYP, meta(location_box([(size - 50, 50)], version)), pixels)
    assert not whole(tmp_path, FTYP, meta(location_box([(size - 50, 51)], version)), pixels)
    assert not whole(tmp_path, FTYP, meta(location_box([(size - 50, 50)], version, base=1)), pixels)


def test_extents_that_wrap_around_64_bit_are_caught(tmp_path):
    content = struct.pack(">IHHHHHQQ", 0, 0x8800, 1, 1, 0, 1, 2**64 - 8, 16)
    assert not whole(tmp_path, FTYP, meta(box(b"iloc", content)), box(b"mdat", bytes(50)))


def test_empty_extents_pass_only_where_the_decoder_survives_them(tmp_path):
    whole(tmp_path, FTYP, meta(location_box([(8, 0)])), box(b"mdat", bytes(50)))
    assert is_whole(tmp_path / "a.heic")
    assert not is_whole(tmp_path / "a.heic", empty_allowed=False)


def test_a_length_beyond_any_file_is_not_sought(tmp_path):
    endless = struct.pack(">I", 1) + b"free" + struct.pack(">Q", 2**64 - 1)
    assert not whole(tmp_path, FTYP, endless)


def test_items_inside_the_directory_are_measured_against_it(tmp_path):
    inner = box(b"idat", bytes(10))
    assert whole(tmp_path, FTYP, meta(location_box([(0, 10)], 1, method=1), inner))
    assert not whole(tmp_path, FTYP, meta(location_box([(1, 10)], 1, method=1), inner))


@pytest.mark.parametrize(
    "directory",
    [
        meta(),
        meta(box(b"iloc", b"")),
        meta(box(b"iloc", struct.pack(">BxxxHH", 0, 0x4440, 65_535))),
        meta(struct.pack(">I", 10**6) + b"iloc" + bytes(8)),
    ],
)
def test_a_damaged_directory_is_not_whole(tmp_path, directory):
    assert not whole(tmp_path, FTYP, directory, box(b"mdat", bytes(50)))


@pytest.mark.data
def test_every_real_heic_is_whole(shared_data):
    paths = [*shared_data.glob("khumbu/photos/*.HEIC"), *shared_data.glob("exif/heic/*.*")]
    broken = {path.name for path in paths if path.stat().st_size and not is_whole(path)}
    assert broken == {"pillowheif_corrupted.heic"}
    assert len(paths) > 15
