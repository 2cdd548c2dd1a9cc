"""Small files that are pictures of many gigabytes: refused before they are unpacked, in little memory."""

from __future__ import annotations

import subprocess
import sys

from whole_runs import PLAIN

BYTES_FOR_A_REFUSAL = 32 * 2**20

BOMBS = """
import struct, sys, zlib
from pathlib import Path
from osgeo import gdal
from skyline_viewshed.core.base.errors import PhotoError
from skyline_viewshed.core.io.photo import read_metadata, read_photo

folder = Path(sys.argv[1])

def chunk(kind, payload):
    return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))

def png(path, side):
    squeezed, zeros = zlib.compressobj(1), bytes(3 * side + 1)
    rows = b"".join(squeezed.compress(zeros) for _ in range(side)) + squeezed.flush()
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0))
    path.write_bytes(b"\\x89PNG\\r\\n\\x1a\\n" + header + chunk(b"IDAT", rows) + chunk(b"IEND", b""))

def tiff(path, side):
    options = ["TILED=YES", "SPARSE_OK=TRUE", "COMPRESS=DEFLATE", "BIGTIFF=YES"]
    gdal.GetDriverByName("GTiff").Create(str(path), side, side, 3, gdal.GDT_Byte, options)

png(folder / "honest.png", 500)
tiff(folder / "honest.tif", 500)
png(folder / "bomb.png", int(sys.argv[2]))
tiff(folder / "bomb.tif", 50_000)
for name in ("honest.png", "honest.tif"):
    read_photo(str(folder / name), 1600)

def peak():
    # Of this program alone: ru_maxrss begins with what the process that started it held.
    return int(Path("/proc/self/status").read_text().split("VmHWM:")[1].split()[0]) * 1024

before = peak()
for name in ("bomb.png", "bomb.tif"):
    for read in (read_metadata, read_photo):
        try:
            read(str(folder / name))
        except PhotoError as error:
            assert "megapixels" in str(error), error
        else:
            raise AssertionError(name)
print(peak() - before)
"""


def test_true_pictures_of_many_gigabytes_are_refused_before_they_are_unpacked(tmp_path):
    script = tmp_path / "bombs.py"
    script.write_text(BOMBS)
    command = [sys.executable, str(script), str(tmp_path), "16000"]
    done = subprocess.run(command, env=PLAIN, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "bomb.png").stat().st_size < 10_000_000, "small on the disk, 768 MB unpacked"
    assert int(done.stdout.split()[-1]) < BYTES_FOR_A_REFUSAL
