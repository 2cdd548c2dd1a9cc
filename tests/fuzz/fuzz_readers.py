"""Coverage-guided fuzzing of everything that reads a user's file (make fuzz; no part of make test).

    fuzz_readers.py [--seconds N] [TARGET...]      all targets where none is named, N seconds in all

Each target reads what the fuzzer has made of its seeds, as the program does. A reader may answer, or refuse in a
sentence; anything else is a fault. So are a hang of more than SECONDS_EACH, a crash of the process, and more than
HEADROOM_BYTES of memory beyond what the loaded libraries take: the address space is limited to that. Faults are kept in
build/fuzz/faults, what has been learned in build/fuzz/<target>; every fault found has become a test of its module.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib
import json
import os
import re
import resource
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "fuzz"
DATA = Path(os.environ.get("SKYLINE_DATA") or ROOT.parent / "shared" / "data") / "exif"
SECONDS_EACH = 20
HEADROOM_BYTES = 2**30
LONGEST_INPUT = 2**16
SAMPLE_BYTES = 1_000_000
"""Larger samples hold more pixels, not more kinds of metadata."""

PHOTO_TARGETS = {
    "metadata": (),
    "metadata_pillow": ("exifread",),
    "metadata_gdal": ("exifread", "PIL.Image"),
    "pixels": (),
}
"""Target and the modules that are blocked, so that the next reader has to do the work."""
TARGETS = (*PHOTO_TARGETS, "heif_boxes", "heif_gdal", "masks", "tables", "dem")


def main():
    """Fuzz one target in this process, or all of them one after the other in processes of their own."""
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("targets", nargs="*", choices=[*TARGETS, []], metavar="TARGET")
    options.add_argument("--seconds", type=int, default=600)
    options.add_argument("--inside", action="store_true", help="this process is the fuzzer of its one target")
    options.add_argument("--replay", metavar="FILE", help="read one kept input")
    given = options.parse_args()
    targets = given.targets or list(TARGETS)
    if given.replay:
        reader(targets[0])(Path(given.replay).read_bytes())
    elif given.inside:
        fuzz(targets[0], given.seconds)
    else:
        sys.exit(fuzz_all(targets, max(given.seconds // len(targets), 1)))


def fuzz_all(targets, seconds):
    """Run each target in its own process and print a table; gives 1 where any has a fault."""
    rows, failed = [], 0
    for target in targets:
        command = [sys.executable, __file__, target, "--inside", "--seconds", str(seconds)]
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", stdin=subprocess.DEVNULL)
        log = BUILD / f"{target}.log"
        log.write_text(done.stdout + done.stderr)
        runs = re.findall(r"#(\d+)\s.*?cov: (\d+)", done.stderr) or [("0", "0")]
        faults = [path for path in (BUILD / "faults").glob(f"{target}-*") if path.suffix != ".txt"]
        rows.append((target, runs[-1][0], runs[0][1], runs[-1][1], len(faults), done.returncode))
        failed |= bool(faults) or done.returncode != 0
    print(f"{'target':16} {'inputs':>9} {'covered by seeds':>17} {'covered':>8} {'faults':>7} {'ended with':>11}")
    for row in rows:
        print("{:16} {:>9} {:>17} {:>8} {:>7} {:>11}".format(*row))
    return int(failed)


def fuzz(target, seconds):
    """Hand this process over to libFuzzer."""
    import atheris

    # Modules that the readers import when they need them are imported now, as long as they can be instrumented. GDAL
    # calls its handler of messages with a pending error at times, in which no tracing code may run.
    included, left_out = ["skyline_viewshed.core", "exifread", "PIL"], ["skyline_viewshed.core.io.gdal_quiet"]
    with atheris.instrument_imports(include=included, exclude=left_out):
        for module in ("exifread", "PIL.JpegImagePlugin", "PIL.TiffImagePlugin", "PIL.PngImagePlugin"):
            if target != "metadata_gdal" and not (target == "metadata_pillow" and module == "exifread"):
                importlib.import_module(module)
        read = reader(target)
    corpus, faults = BUILD / target, BUILD / "faults"
    corpus.mkdir(parents=True, exist_ok=True)
    faults.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(seeds(target)):
        (corpus / f"seed-{number:02}").write_bytes(seed[:LONGEST_INPUT])
    known = set()

    def one(content):
        try:
            read(content)
        except Exception as error:
            place = str(traceback.extract_tb(error.__traceback__)[-1][:2]) + type(error).__name__
            if place not in known:
                known.add(place)
                name = f"{target}-{hashlib.sha1(place.encode()).hexdigest()[:8]}"
                (faults / name).write_bytes(content)
                (faults / f"{name}.txt").write_text(traceback.format_exc())
                print("FAULT", name, repr(error)[:200], flush=True)

    limit_memory()
    flags = [f"-max_total_time={seconds}", f"-timeout={SECONDS_EACH}", f"-max_len={LONGEST_INPUT}"]
    flags += ["-rss_limit_mb=0", "-malloc_limit_mb=0", f"-artifact_prefix={faults}/{target}-", "-print_final_stats=1"]
    atheris.Setup([sys.argv[0], str(corpus), *flags], one)
    atheris.Fuzz()


def limit_memory():
    """Allow `HEADROOM_BYTES` of address space beyond what this process has mapped by now."""
    mapped = int(re.search(r"VmSize:\s+(\d+) kB", Path("/proc/self/status").read_text()).group(1)) * 1024
    resource.setrlimit(resource.RLIMIT_AS, (mapped + HEADROOM_BYTES, mapped + HEADROOM_BYTES))


def reader(target):
    """Give the function that reads bytes as the target does; what it raises is a fault."""
    folder = Path(tempfile.mkdtemp(prefix="skyline-fuzz-", dir="/dev/shm" if os.path.isdir("/dev/shm") else None))
    if target in PHOTO_TARGETS:
        return photo_reader(folder / "photo.bin", PHOTO_TARGETS[target], pixels=target == "pixels")
    return {
        "heif_boxes": heif_reader,
        "heif_gdal": lambda path: photo_reader(path, ("exifread", "pillow_heif"), pixels=True),
        "masks": mask_reader,
        "tables": table_reader,
        "dem": dem_reader,
    }[target](folder / "input.bin")


def photo_reader(path, blocked, pixels):
    for module in blocked:
        sys.modules[module] = None
    from skyline_viewshed.core.base.errors import PhotoError
    from skyline_viewshed.core.io.photo import read_metadata, read_photo

    def read(content):
        path.write_bytes(content)
        try:
            metadata = read_metadata(str(path))
            photo = read_photo(str(path), max_side_px=64) if pixels else None
        except PhotoError as error:
            assert_sentence(error)
            return
        assert metadata.width_px > 0 and metadata.height_px > 0
        assert metadata.latitude_deg is None or abs(metadata.latitude_deg) <= 90
        assert metadata.longitude_deg is None or abs(metadata.longitude_deg) <= 180
        assert metadata.compass_heading_deg is None or 0 <= metadata.compass_heading_deg < 360
        assert metadata.camera is None or metadata.camera.isprintable()
        assert photo is None or max(photo.pixels.shape[:2]) <= 64

    return read


def heif_reader(path):
    from skyline_viewshed.core.io.formats import is_whole

    def read(content):
        path.write_bytes(content)
        assert is_whole(str(path)) in (True, False)
        assert is_whole(str(path), empty_allowed=False) in (True, False)

    return read


def mask_reader(path):
    import numpy as np
    from skyline_viewshed.core.base.errors import PhotoError
    from skyline_viewshed.core.io.photo import read_photo
    from skyline_viewshed.core.skyline.given import evidence_from_mask

    def read(content):
        path.write_bytes(content)
        try:
            evidence = evidence_from_mask(read_photo(str(path), 1600).pixels, 4000, 3000)
        except PhotoError as error:
            assert_sentence(error)
            return
        assert np.isfinite(evidence.probability).all()

    return read


def table_reader(path):
    import numpy as np
    from skyline_viewshed.core.base.errors import UnreadableFeaturesError
    from skyline_viewshed.core.base.photo_names import owners
    from skyline_viewshed.core.io.features import read_features

    def read(content):
        path.write_bytes(content)
        try:
            features, _ = read_features(str(path))
        except UnreadableFeaturesError as error:
            assert_sentence(error)
            return
        for feature in features:
            assert isinstance(feature.photo, str) and feature.kind in ("point", "line", "polygon")
            assert all(part.ndim == 2 and np.isfinite(part).all() for part in feature.parts)
        owners((feature.photo for feature in features), ["IMG_1.jpg"])

    return read


def dem_reader(path):
    import numpy as np
    from skyline_viewshed.core.base.errors import ObserverError, TerrainError
    from skyline_viewshed.core.base.terrain import Window
    from skyline_viewshed.core.io.raster import open_dem

    side_files = [path.with_name(path.name + end) for end in (".aux.xml", ".ovr", ".msk")]

    def read(content):
        path.write_bytes(content)
        for file in side_files:
            file.unlink(missing_ok=True)
        try:
            dem = open_dem(str(path))
            values = dem.read(Window(0, 0, 64, 64).clipped(dem.shape))
            position = dem.position_of(0.0, 0.0)
            if np.isfinite(position).all():
                dem.frame(*map(float, position), 1000.0)
        except (TerrainError, ObserverError) as error:
            assert_sentence(error)
            return
        assert values.dtype == np.float32 and not np.isinf(values).any()

    return read


def assert_sentence(error):
    """A refusal must tell a user what to do."""
    assert str(error).endswith((".", ".)")) and len(str(error)) < 1000, str(error)


def seeds(target):
    """Yield small files of each kind: made ones, and the real samples where they are."""
    if target == "tables":
        yield from table_seeds()
    elif target == "dem":
        yield from dem_seeds()
    else:
        wanted = ("HEIF",) if target.startswith("heif") else ("PNG", "JPEG", "TIFF") if target == "masks" else ALL_KINDS
        yield from picture_seeds(wanted)
        for sample in sorted(DATA.rglob("*")) if target != "masks" else ():
            heif = sample.suffix.lower() == ".heic"
            if sample.is_file() and heif >= target.startswith("heif") and sample.stat().st_size < SAMPLE_BYTES:
                yield sample.read_bytes()


ALL_KINDS = ("JPEG", "HEIF", "PNG", "TIFF", "WEBP")


def picture_seeds(kinds):
    """Small pictures by Pillow, with all tags that we read."""
    code = """
import io, sys, base64, json
from PIL import Image
from PIL.TiffImagePlugin import IFDRational as R
try:
    import pillow_heif
    pillow_heif.register_heif_opener()
except ImportError:
    pass
tags = Image.Exif()
tags[0x010F], tags[0x0110], tags[0x0112], tags[0x0132] = "Maker", "Model", 6, "2026:06:01 12:00:00"
tags.get_ifd(0x8769).update({0x9003: "2026:06:01 12:00:00", 0x920A: R(343, 50), 0xA002: 96, 0xA003: 64,
    0xA20E: R(9000, 1), 0xA20F: R(9000, 1), 0xA210: 2, 0xA404: R(1, 1), 0xA405: 24})
tags.get_ifd(0x8825).update({1: "N", 2: (46.0, 30.0, 12.5), 3: "E", 4: (8.0, 1.0, 2.0), 5: b"\\0", 6: 2000.5,
    16: "T", 17: 12.25, 31: 4.5})
made = []
for kind in sys.argv[1:]:
    for mode in ("RGB", "L"):
        picture = Image.linear_gradient("L").resize((96, 64)).convert(mode)
        memory = io.BytesIO()
        try:
            picture.save(memory, kind, exif=tags)
        except Exception:
            continue
        made.append(base64.b64encode(memory.getvalue()).decode())
json.dump(made, sys.stdout)
"""
    import base64

    # In a process of its own: here the packages that draw may be blocked for the reader's sake.
    done = subprocess.run([sys.executable, "-c", code, *kinds], capture_output=True, check=True)
    for text in json.loads(done.stdout):
        yield base64.b64decode(text)


def table_seeds():
    """One small file of each format that read_features knows."""
    yield b"photo,x,y,label,feature,kind\na.jpg,10.5,20,peak,1,point\na.jpg,11,-3e1,,2,line\na.jpg,4,5,,2,line\n"
    yield "photo;x;y\nHöhe.jpg;1;2\n".encode()
    yield b'filename,region_shape_attributes,region_attributes\na.jpg,"{""name"":""point"",""cx"":1,""cy"":2}","{}"\n'
    ring = [[0, 0], [4, 0], [4, 3]]
    yield json.dumps({"imagePath": "IMG_1.jpg", "shapes": [
        {"label": "a", "points": ring, "shape_type": kind} for kind in ("polygon", "rectangle", "circle", "linestrip")
    ]}).encode()  # fmt: skip
    yield json.dumps({"images": [{"id": 1, "file_name": "IMG_1.jpg"}], "categories": [{"id": 2, "name": "ice"}],
        "annotations": [{"image_id": 1, "category_id": 2, "segmentation": [[0, 0, 4, 0, 4, 3]]},
                        {"image_id": 1, "keypoints": [1, 2, 2]}, {"image_id": 1, "bbox": [1, 2, 3, 4]}],
    }).encode()  # fmt: skip
    box = {"x": 1, "y": 2, "width": 3, "height": 4, "cx": 1, "cy": 2, "rx": 3, "ry": 4}
    shapes = [{"name": name, **box} for name in ("point", "rect", "ellipse")]
    shapes.append({"name": "polygon", "all_points_x": [0, 4, 4], "all_points_y": [0, 0, 3]})
    regions = [{"shape_attributes": shape, "region_attributes": {"kind": "ice"}} for shape in shapes]
    yield json.dumps({"_via_img_metadata": {"k": {"filename": "IMG_1.jpg", "regions": regions}}}).encode()
    kinds = {"Point": [1, 2], "MultiPoint": [[1, 2]], "LineString": ring, "Polygon": [ring], "MultiPolygon": [[ring]]}
    yield json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"photo": "IMG_1.jpg"}, "geometry": {"type": kind, "coordinates": places}}
        for kind, places in kinds.items()
    ]}).encode()  # fmt: skip


def dem_seeds():
    """Small elevation models in the formats that people have."""
    import numpy as np
    from osgeo import gdal
    from skyline_viewshed.demo.dem_file import write_dem

    folder = Path(tempfile.mkdtemp(prefix="skyline-seeds-"))
    heights = np.add.outer(np.arange(48.0), np.arange(40.0)) * 10 + 500
    write_dem(str(folder / "dem.tif"), heights, 90.0, 8.0, 46.0)
    plain = gdal.Translate(str(folder / "plain.tif"), str(folder / "dem.tif"), creationOptions=["COMPRESS=NONE"])
    for name, driver in (("cog.tif", "COG"), ("grid.asc", "AAIGrid"), ("dem.vrt", "VRT"), ("dem.png", "PNG")):
        options = {"outputType": gdal.GDT_UInt16} if driver == "PNG" else {}
        gdal.Translate(str(folder / name), plain, format=driver, **options)
    gdal.Warp(str(folder / "degrees.tif"), plain, dstSRS="EPSG:4326", outputType=gdal.GDT_Int16)
    del plain
    for file in sorted(folder.glob("*.*")):
        if file.suffix in (".tif", ".asc", ".vrt", ".png"):
            yield file.read_bytes()


if __name__ == "__main__":
    main()
