"""Mutated photographs: an answer or a sentence, never a hang, a crash or a heap of memory."""

import io
import signal
import sys
from contextlib import contextmanager

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image
from PIL.TiffImagePlugin import IFDRational
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.io.photo import read_metadata, read_photo

SECONDS = 20
"""Far above the slowest honest reading (0.5 s here): only a loop without end takes longer."""

EXAMPLES = settings(
    max_examples=60, deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck)
)
REACH = 6000
"""Headers and metadata lie in the first bytes; mutated pixels teach little."""

SAMPLES = [
    "exif/gps/DSCN0010.jpg",
    "exif/gps/nikon_d5000.jpg",
    "exif/invalid/image00971.jpg",
    "exif/invalid/image01137.jpg",
    "exif/invalid/image01713.jpg",
    "exif/odd/no_exif.jpg",
    "exif/orientation/portrait_6.jpg",
    "exif/heic/pillowheif_corrupted.heic",
    "exif/heic/IMG_5195.HEIC",
]


class HangError(BaseException):
    """A reader did not come back; no handler of ordinary errors may swallow it."""


@contextmanager
def at_most(seconds):
    """Break off Python code that runs for ever (main thread of a POSIX system; elsewhere no guard)."""
    if not hasattr(signal, "SIGALRM"):
        yield
        return

    def ring(*_):
        raise HangError

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def mutate(draw, content):
    """Overwrite some bytes, preferably with lengths and offsets of all ones or zeros, or cut some out."""
    content = bytearray(content)
    for _ in range(draw(st.integers(1, 6))):
        place = draw(st.integers(0, max(min(len(content), REACH) - 1, 0)))
        replacement = draw(
            st.one_of(
                st.binary(min_size=1, max_size=4),
                st.sampled_from([b"\xff\xff\xff\xff", b"\0\0\0\0", b"\x7f\xff\xff\xff", b"\0\0\0\x08", b"\x08\0\0\0"]),
            )
        )
        keep = draw(st.booleans())
        content[place : place + len(replacement)] = replacement if keep else b""
    return bytes(content)


def read_everything(path, pixels):
    """Read as the program does; a refusal must be a sentence."""
    with at_most(SECONDS):
        try:
            metadata = read_metadata(path)
            if pixels:
                photo = read_photo(path, max_side_px=64)
                assert photo.pixels.dtype == np.uint8
                assert max(photo.pixels.shape) <= 64
        except PhotoError as error:
            assert str(error).endswith(".")
            return
    assert metadata.width_px > 0
    assert metadata.latitude_deg is None or abs(metadata.latitude_deg) <= 90
    assert metadata.camera is None or metadata.camera.isprintable()


@pytest.mark.data
@pytest.mark.parametrize("sample", SAMPLES)
def test_mutations_of_real_photographs(shared_data, tmp_path, sample):
    content = (shared_data / sample).read_bytes()
    path = str(tmp_path / "mutated.bin")

    @EXAMPLES
    @given(st.data())
    def check(data):
        mutated = mutate(data.draw, content)
        with open(path, "wb") as file:
            file.write(mutated)
        read_everything(path, pixels=len(content) < 300_000)

    check()


def synthetic_jpeg():
    tags = Image.Exif()
    tags[0x0112], tags[0x0110] = 6, "Model"
    tags.get_ifd(0x8769).update({0x920A: IFDRational(343, 50), 0xA405: 24})
    tags.get_ifd(0x8825).update({1: "N", 2: (46.0, 30.0, 12.5), 3: "E", 4: (8.0, 1.0, 2.0), 17: 12.25})
    memory = io.BytesIO()
    Image.effect_noise((96, 64), 60).save(memory, "JPEG", exif=tags)
    return memory.getvalue()


@pytest.mark.parametrize("blocked", [(), ("exifread",), ("exifread", "PIL", "PIL.Image", "PIL.JpegImagePlugin")])
def test_mutations_of_a_synthetic_photograph_by_every_reader(tmp_path, monkeypatch, blocked):
    content, path = synthetic_jpeg(), str(tmp_path / "mutated.bin")
    for module in blocked:
        monkeypatch.setitem(sys.modules, module, None)

    @EXAMPLES
    @given(st.data())
    def check(data):
        with open(path, "wb") as file:
            file.write(mutate(data.draw, content))
        read_everything(path, pixels=True)

    check()


@EXAMPLES
@given(
    content=st.binary(max_size=300), head=st.sampled_from([b"\xff\xd8\xff\xe1", b"\0\0\0\x18ftypheic", b"II*\0", b""])
)
def test_random_bytes_under_a_true_head(tmp_path_factory, content, head):
    path = tmp_path_factory.getbasetemp() / "random.bin"
    path.write_bytes(head + content)
    read_everything(str(path), pixels=True)


def test_the_guard_itself_works():
    def forever():
        while True:
            pass

    if hasattr(signal, "SIGALRM"):
        with pytest.raises(HangError), at_most(0.05):
            forever()
