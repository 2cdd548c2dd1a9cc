"""Photographs through every decoder: upright once, right size, right colours, clear refusals."""

import io
import struct
import sys
import zlib

import numpy as np
import pytest
from PIL import Image, ImageOps
from skyline_viewshed.core.base.errors import UnreadablePhotoError
from skyline_viewshed.core.base.imaging import shrink
from skyline_viewshed.core.base.optional import available
from skyline_viewshed.core.io import photo as photo_module
from skyline_viewshed.core.io import pixels as pixels_module
from skyline_viewshed.core.io.photo import read_metadata, read_photo

PILLOW = ("PIL", "PIL.Image", "PIL.JpegImagePlugin")


def block(monkeypatch, *modules):
    for module in modules:
        monkeypatch.setitem(sys.modules, module, None)


def scene(width=192, height=144):
    """An unmistakable picture: sky above, a red left and a green right half of ground below, a yellow corner."""
    picture = np.zeros((height, width, 3), np.uint8)
    picture[: height // 2] = (120, 160, 220)
    picture[height // 2 :, : width // 2] = (180, 40, 40)
    picture[height // 2 :, width // 2 :] = (40, 140, 60)
    picture[: height // 6, : width // 6] = (230, 220, 40)
    return picture


def save(path, picture, orientation=None, mode=None, **options):
    image = Image.fromarray(picture)
    if mode:
        image = image.convert(mode)
    if orientation:
        tags = Image.Exif()
        tags[0x0112] = orientation
        options["exif"] = tags
    image.save(path, **options)
    return str(path)


# --- orientation ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("without_pillow", [False, True])
@pytest.mark.parametrize("orientation", range(1, 9))
def test_all_eight_orientations_come_upright_once(tmp_path, monkeypatch, orientation, without_pillow):
    path = save(tmp_path / "a.jpg", scene(), orientation, quality=95)
    with Image.open(path) as stored:
        expected = np.asarray(ImageOps.exif_transpose(stored)).astype(int)
    if without_pillow:
        block(monkeypatch, "exifread", *PILLOW)
    photo = read_photo(path)
    assert photo.pixels.shape == expected.shape
    assert np.abs(photo.pixels - expected).mean() < 1.0
    assert (photo.metadata.height_px, photo.metadata.width_px) == expected.shape[:2]
    assert photo.metadata.orientation == orientation
    assert read_metadata(path) == photo.metadata


def test_every_stored_orientation_of_one_scene_gives_that_scene(tmp_path):
    upright = scene()
    stored = {
        1: upright, 2: upright[:, ::-1], 3: upright[::-1, ::-1], 4: upright[::-1],
        5: upright.swapaxes(0, 1), 6: np.rot90(upright),
        7: upright[::-1, ::-1].swapaxes(0, 1), 8: np.rot90(upright, -1),
    }  # fmt: skip
    for orientation, picture in stored.items():
        path = save(tmp_path / f"{orientation}.png", np.ascontiguousarray(picture), orientation)
        assert np.array_equal(read_photo(path).pixels, upright), orientation


@pytest.mark.data
def test_six_real_orientations_show_the_same_upright_picture(shared_data):
    for shape in ("landscape", "portrait"):
        pictures = [read_photo(path).pixels for path in sorted(shared_data.glob(f"exif/orientation/{shape}_*.jpg"))]
        grey = [shrink(picture, 30, 30).mean(axis=2) for picture in pictures]
        for other in grey[1:]:
            assert np.corrcoef(grey[0].ravel(), other.ravel())[0, 1] > 0.9


@pytest.mark.data
@pytest.mark.parametrize("without_pillow_heif", [False, True])
def test_a_portrait_heic_is_turned_by_its_decoder_and_not_again(shared_data, monkeypatch, without_pillow_heif):
    if without_pillow_heif:
        block(monkeypatch, "pillow_heif")
    photo = read_photo(shared_data / "khumbu/photos/IMG_1512.HEIC", max_side_px=400)
    assert (photo.metadata.width_px, photo.metadata.height_px) == (3024, 4032)
    assert photo.metadata.orientation == 6
    assert photo.pixels.shape == (400, 300, 3)
    blueness = photo.pixels[..., 2].astype(int) - photo.pixels[..., 0]
    assert blueness[:60].mean() > blueness[-60:].mean() + 20  # sky above, ground below


@pytest.mark.data
def test_both_heic_decoders_give_the_same_pixels(shared_data, monkeypatch):
    path = shared_data / "exif/heic/glaciernp_image1.HEIC"
    first = read_photo(path).pixels.astype(int)
    block(monkeypatch, "pillow_heif")
    assert np.abs(read_photo(path).pixels - first).mean() < 0.5


# --- size -------------------------------------------------------------------------------------------------------


def textured(width, height, seed=3):
    rng = np.random.default_rng(seed)
    coarse = Image.fromarray(rng.integers(0, 255, (height // 16, width // 16, 3), dtype=np.uint8))
    return np.asarray(coarse.resize((width, height), Image.BICUBIC))


@pytest.mark.parametrize("width, height", [(1600, 1200), (1601, 1203), (1200, 1600), (1504, 1000)])
def test_reduced_decoding_is_area_averaging_of_the_whole(tmp_path, width, height):
    path = save(tmp_path / "a.jpg", textured(width, height), quality=95)
    full = read_photo(path)
    small = read_photo(path, max_side_px=300)
    assert max(small.pixels.shape) == 300
    assert small.metadata == full.metadata
    rows, cols = small.pixels.shape[:2]
    exact = shrink(full.pixels, cols, rows)
    assert np.abs(small.pixels - exact).mean() < 1.5
    # No shift: the best offset between the two is nil to a hundredth of a pixel, by least squares.
    slope = np.gradient(exact[..., 1], axis=1)
    shift = (slope * (small.pixels[..., 1] - exact[..., 1])).sum() / (slope**2).sum()
    assert abs(shift) < 0.02


def test_a_small_picture_is_not_enlarged(tmp_path):
    path = save(tmp_path / "a.jpg", scene())
    assert read_photo(path, max_side_px=5000).pixels.shape == (144, 192, 3)


def test_extreme_aspects_keep_one_pixel(tmp_path):
    path = save(tmp_path / "a.jpg", textured(3200, 16))
    assert read_photo(path, max_side_px=100).pixels.shape == (1, 100, 3)


@pytest.mark.data
def test_decoders_agree_on_real_photographs(shared_data, monkeypatch):
    path = shared_data / "columbia/photos/AK10_20090818_143408.JPG"
    first = read_photo(path, max_side_px=800).pixels.astype(int)
    block(monkeypatch, *PILLOW)
    assert np.abs(read_photo(path, max_side_px=800).pixels - first).mean() < 1.0


# --- kinds of pixels --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("without_pillow", [False, True])
@pytest.mark.parametrize("name, mode", [("a.jpg", "L"), ("a.jpg", "CMYK"), ("a.png", "RGBA"), ("a.png", "L")])
def test_grey_cmyk_alpha_and_palette_become_rgb(tmp_path, monkeypatch, name, mode, without_pillow):
    picture = scene()
    path = save(tmp_path / name, picture, mode=mode)
    expected = np.asarray(Image.fromarray(picture).convert("L")) if mode == "L" else picture
    expected = np.atleast_3d(expected).astype(int)
    if without_pillow:
        block(monkeypatch, *PILLOW)
    found = read_photo(path).pixels
    assert found.shape == (144, 192, 3)
    assert found.dtype == np.uint8
    assert np.abs(found - expected).mean() < 4


def test_palettes_become_colours_or_are_refused(tmp_path, monkeypatch):
    path = str(tmp_path / "a.png")
    Image.fromarray(scene()).quantize(16).save(path)
    assert np.abs(read_photo(path).pixels.astype(int) - scene()).mean() < 4
    block(monkeypatch, *PILLOW)
    with pytest.raises(UnreadablePhotoError):
        read_photo(path)


def test_sixteen_bit_becomes_eight(tmp_path):
    ramp = np.linspace(0, 65535, 256).astype(np.uint16)
    Image.fromarray(np.tile(ramp, (20, 1))).save(tmp_path / "a.png")
    found = read_photo(tmp_path / "a.png").pixels
    assert found.shape == (20, 256, 3)
    assert np.abs(found[0, :, 0].astype(int) - np.arange(256)).max() <= 1


def test_a_lying_extension_is_seen_through(tmp_path):
    memory = io.BytesIO()
    Image.fromarray(scene()).save(memory, "JPEG")
    (tmp_path / "photo.heic").write_bytes(memory.getvalue())
    assert read_photo(tmp_path / "photo.heic").pixels.shape == (144, 192, 3)


# --- bad files --------------------------------------------------------------------------------------------------


def refused(path):
    with pytest.raises(UnreadablePhotoError) as metadata_error:
        read_metadata(path)
    with pytest.raises(UnreadablePhotoError) as pixel_error:
        read_photo(path)
    assert str(metadata_error.value).endswith(".")
    return str(pixel_error.value)


@pytest.mark.parametrize("without_pillow", [False, True])
@pytest.mark.parametrize("share", [0.02, 0.5, 0.98])
def test_a_truncated_jpeg_is_refused(tmp_path, monkeypatch, share, without_pillow):
    memory = io.BytesIO()
    Image.fromarray(textured(640, 480)).save(memory, "JPEG", quality=90)
    (tmp_path / "a.jpg").write_bytes(memory.getvalue()[: int(len(memory.getvalue()) * share)])
    if without_pillow:
        block(monkeypatch, *PILLOW)
    with pytest.raises(UnreadablePhotoError, match="damaged or incomplete"):
        read_photo(tmp_path / "a.jpg")


@pytest.mark.data
@pytest.mark.parametrize("share", [0.001, 0.3, 0.9])
def test_a_truncated_heic_is_refused(shared_data, tmp_path, share):
    content = (shared_data / "exif/heic/glaciernp_image1.HEIC").read_bytes()
    (tmp_path / "a.heic").write_bytes(content[: int(len(content) * share)])
    assert "too early" in refused(tmp_path / "a.heic") or share < 0.01


@pytest.mark.data
@pytest.mark.parametrize("name, reason", [("pillowheif_corrupted.heic", "damaged"), ("pillowheif_empty.heic", "empty")])
def test_real_bad_heics_are_refused(shared_data, name, reason):
    assert reason in refused(shared_data / "exif/heic" / name)


@pytest.mark.data
def test_broken_metadata_does_not_cost_the_picture(shared_data):
    for path in [*shared_data.glob("exif/invalid/*.jpg"), *shared_data.glob("exif/odd/*.jpg")]:
        photo = read_photo(path)
        assert photo.pixels.shape == (photo.metadata.height_px, photo.metadata.width_px, 3)
        assert photo.metadata.latitude_deg is None


def png_header(width, height):
    """A valid PNG of that size by its header, whose few bytes of pixels mean nothing."""

    def chunk(kind, payload):
        return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(100))) + chunk(b"IEND", b"")
    )


def test_decompression_bombs_are_refused_by_their_header(tmp_path):
    (tmp_path / "bomb.png").write_bytes(png_header(50_000, 50_000))
    assert "2" in refused(tmp_path / "bomb.png")
    memory = io.BytesIO()
    Image.fromarray(scene()).save(memory, "JPEG")
    content = bytearray(memory.getvalue())
    frame = content.index(b"\xff\xc0")
    content[frame + 5 : frame + 9] = struct.pack(">HH", 65_000, 65_000)
    (tmp_path / "bomb.jpg").write_bytes(bytes(content))
    assert "4225" in refused(tmp_path / "bomb.jpg") or "megapixels" in refused(tmp_path / "bomb.jpg")


def test_a_picture_beyond_the_memory_is_one_photos_fault(tmp_path, monkeypatch):
    def no_memory(*_):
        raise MemoryError

    monkeypatch.setattr(pixels_module, "_decode_pillow", no_memory)
    with pytest.raises(UnreadablePhotoError, match="memory"):
        read_photo(save(tmp_path / "a.jpg", scene()))


@pytest.mark.data
def test_heic_without_any_decoder_says_what_to_install(shared_data, monkeypatch):
    block(monkeypatch, "pillow_heif", "osgeo", "osgeo.gdal")
    with pytest.raises(UnreadablePhotoError, match="pip install .*pillow-heif"):
        read_photo(shared_data / "exif/heic/glaciernp_image1.HEIC")


# --- what QGIS ships --------------------------------------------------------------------------------------------


@pytest.mark.data
@pytest.mark.parametrize("more", [(), PILLOW])
def test_jpeg_reads_the_same_on_what_qgis_ships(shared_data, monkeypatch, more):
    path = shared_data / "exif/gps/iphone_hdr_NO.jpg"
    expected = read_photo(path, 600)
    block(monkeypatch, "cv2", "pillow_heif", "exifread", *more)
    found = read_photo(path, 600)
    assert np.abs(found.pixels.astype(int) - expected.pixels).mean() < 1.0
    assert found.metadata.latitude_deg == pytest.approx(expected.metadata.latitude_deg, abs=1e-7)
    assert found.metadata.longitude_deg == pytest.approx(expected.metadata.longitude_deg, abs=1e-7)
    assert found.metadata.compass_heading_deg == pytest.approx(expected.metadata.compass_heading_deg, abs=1e-3)
    assert found.metadata.taken_at == expected.metadata.taken_at


# --- real metadata ----------------------------------------------------------------------------------------------


@pytest.mark.data
@pytest.mark.parametrize(
    "path, expected",
    [
        ("gps/iphone_hdr_NO.jpg", {"latitude_deg": 40.446972, "longitude_deg": -3.724753, "altitude_m": 639.588,
                                   "altitude_reference": "sea level", "focal_length_35mm": 57.0,
                                   "compass_heading_deg": 212.872, "compass_reference": "T"}),
        ("gps/DSCN0010.jpg", {"altitude_m": None, "altitude_reference": None, "compass_heading_deg": None,
                              "compass_reference": None, "focal_length_35mm": 112.0}),
        ("gps/Kodak_CX7530.jpg", {"latitude_deg": -0.3713, "longitude_deg": 36.056417}),
        ("gps/issue173.jpg", {"altitude_m": -848.0, "altitude_reference": "below sea level"}),
        ("gps/nikon_d5000.jpg", {"latitude_deg": None, "longitude_deg": None, "altitude_m": 324.145}),
        ("gps/oppo_r7plus.jpg", {"altitude_m": 0.0, "focal_length_35mm": None, "focal_length_mm": 3.46,
                                 "width_px": 3120, "height_px": 4160}),
        ("heic/IMG_5195.HEIC", {"compass_reference": "M", "position_error_m": 38.813,
                                "camera": "Apple iPhone 11 Pro Max"}),
        ("heic/issue487.heic", {"latitude_deg": None, "width_px": 3024, "height_px": 4032}),
        ("heic/pillowheif_arrow.heic", {"latitude_deg": None, "focal_length_35mm": 28.0}),
    ],
)  # fmt: skip
def test_metadata_of_real_photographs(shared_data, path, expected):
    if available("exifread") is None and available("pillow_heif") is None and "position_error_m" in expected:
        expected = {**expected, "position_error_m": read_metadata(shared_data / "exif" / path).position_error_m}
    found = read_metadata(shared_data / "exif" / path)
    for name, value in expected.items():
        approx = pytest.approx(value, rel=1e-5) if isinstance(value, float) else value
        assert getattr(found, name) == approx, name


@pytest.mark.data
def test_ignored_coordinates_leave_a_note(shared_data):
    assert "ignored" in read_metadata(shared_data / "exif/gps/nikon_d5000.jpg").notes[0]
    assert "ignored" in read_metadata(shared_data / "exif/heic/issue487.heic").notes[0]


def test_reading_changes_nothing_on_disk(tmp_path):
    path = save(tmp_path / "a.jpg", scene(), orientation=6)
    before = (tmp_path / "a.jpg").read_bytes()
    read_photo(path, 100)
    assert (tmp_path / "a.jpg").read_bytes() == before
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.jpg"]
    assert photo_module.read_metadata(path).path == path
