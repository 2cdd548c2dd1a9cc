import struct

import pytest
from skyline_viewshed.core.io.heif_boxes import is_whole


def box(kind, payload):
    return struct.pack(">I", 8 + len(payload)) + kind + payload


FTYP = box(b"ftyp", b"heic\0\0\0\0mif1heic")


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
