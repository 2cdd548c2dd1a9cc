"""Run every algorithm under a handicap, in a separate process.

    handicaps.py MODE SCENE FOLDER [ALGORITHM...]

MODE `offline` runs each algorithm with all its outputs in FOLDER, and any attempt to open an internet socket ends the
process with SIGSYS. The other modes run it once for each output, which cannot be written: `full` (FOLDER is on a
separate disk, which is filled), `limit` (no file can grow, the closest alternative if mounting a disk is not allowed)
or `closed` (FOLDER becomes read-only). Prints a JSON object: for each case the message, and the state of the results.
"""

from __future__ import annotations

import ctypes
import json
import os
import platform
import resource
import struct
import sys
from contextlib import suppress
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MODE, SCENE, FOLDER = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
CHOSEN = sys.argv[4:]
LIMIT_BYTES = 64
OLDER = b"older"


def main():
    from qgis.core import QgsApplication

    application = QgsApplication([], False)
    application.initQgis()
    sys.path.insert(0, str(ROOT / "build" / "plugins"))
    sys.path.append(str(Path(QgsApplication.pkgDataPath()) / "python" / "plugins"))
    from processing.core.Processing import Processing
    from skyline_viewshed.processing_provider.provider import SkylineViewshedProvider

    Processing.initialize()
    provider = SkylineViewshedProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    cases = {name: given for name, given in inputs().items() if not CHOSEN or name in CHOSEN}
    print(json.dumps(run_offline(provider, cases) if MODE == "offline" else run_spoiled(provider, cases)))
    sys.stdout.flush()
    os._exit(0)  # the exit of QGIS itself is not under test


def run_offline(provider, cases):
    """Run each algorithm with all outputs and return {algorithm: (message, paths of the outputs)}."""
    forbid_internet()
    found = {}
    for name, given in cases.items():
        outputs = {item.name(): str(path_of(provider.algorithm(name), item)) for item in outputs_of(provider, name)}
        found[name] = run(provider.algorithm(name), {**given, **outputs}), list(outputs.values())
    return found


def run_spoiled(provider, cases):
    """Run each algorithm once for each output and return {algorithm:output: result of `one_case`}."""
    spoil_folder([path_of(provider.algorithm(name), output) for name in cases for output in outputs_of(provider, name)])
    found = {}
    for name, given in cases.items():
        outputs = outputs_of(provider, name)
        # Only the outputs that every run has need a path; the others are left out.
        others = {item.name(): "TEMPORARY_OUTPUT" for item in outputs if not is_optional(item)}
        for output in outputs:
            found[f"{name}:{output.name()}"] = one_case(provider.algorithm(name), {**given, **others}, output)
    return found


def outputs_of(provider, name):
    return [item for item in provider.algorithm(name).parameterDefinitions() if item.isDestination()]


def is_optional(definition):
    from qgis.core import QgsProcessingParameterDefinition

    return bool(definition.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional)


def path_of(algorithm, output):
    kind = type(output).__name__
    suffix = {"QgsProcessingParameterFeatureSink": ".gpkg", "QgsProcessingParameterRasterDestination": ".tif",
              "QgsProcessingParameterFileDestination": ".html"}.get(kind, "")  # fmt: skip
    return FOLDER / f"{algorithm.name()}_{output.name().lower()}{suffix}"


def spoil_folder(paths):
    """Put older results in place; then remove the free space, or the right to write."""
    for path in paths:
        if path.suffix:
            path.write_bytes(OLDER)
    if MODE == "closed":
        FOLDER.chmod(0o555)
    if MODE == "full":
        with suppress(OSError), open(FOLDER / "filler", "wb", buffering=0) as file:
            for _ in range(10_000):  # a small disk; a large one could belong to somebody
                file.write(bytes(4096))


def one_case(algorithm, parameters, output):
    """Run with one output in FOLDER and return (message, whether the older result is unchanged, new files)."""
    path, before = path_of(algorithm, output), set(FOLDER.rglob("*"))
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    if MODE == "limit":
        sys.dont_write_bytecode = True  # Python would leave half a module, and fail on it next time
        resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT_BYTES, limits[1]))
    said = run(algorithm, {**parameters, output.name(): str(path)})
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    new = sorted(str(item.relative_to(FOLDER)) for item in set(FOLDER.rglob("*")) - before)
    return said, not path.suffix or path.read_bytes() == OLDER, new


def run(algorithm, parameters):
    """Run and return the message; layers that QGIS would load are released."""
    import processing
    from qgis.core import QgsProcessingException, QgsProcessingFeedback

    feedback = QgsProcessingFeedback(False)
    try:
        processing.run(algorithm.id(), parameters, feedback=feedback)
    except QgsProcessingException as error:
        return f"{error}\n{feedback.textLog()}"
    except Exception as error:
        return f"Traceback {error!r}"
    return "succeeded"


def forbid_internet():
    """Make the kernel end this process, with all its threads, at the first socket of an internet family.

    This is a seccomp filter, since Python itself can block only Python's sockets. Exits with 77 if that is refused.
    """
    audit, seccomp, socket = {"x86_64": (0xC000003E, 317, 41), "aarch64": (0xC00000B7, 277, 198)}.get(
        platform.machine(), (0, 0, 0)
    )
    load, equal, leave = 0x20, 0x15, 0x06
    program = [
        (load, 0, 0, 4), (equal, 0, 6, audit), (load, 0, 0, 0), (equal, 0, 4, socket), (load, 0, 0, 16),
        (equal, 1, 0, 2), (equal, 0, 1, 10), (leave, 0, 0, 0x80000000), (leave, 0, 0, 0x7FFF0000),
    ]  # fmt: skip
    code = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *line) for line in program))
    program = ctypes.create_string_buffer(struct.pack("HxxxxxxP", len(program), ctypes.addressof(code)))
    libc = ctypes.CDLL(None, use_errno=True)
    no_new_privileges, set_filter, all_threads = 38, 1, 1
    if (
        not audit
        or libc.prctl(no_new_privileges, 1, 0, 0, 0)
        or libc.syscall(seccomp, set_filter, all_threads, program)
    ):
        os._exit(77)
    if os.environ.get("TRY_INTERNET"):
        import socket as internet

        internet.socket()


def inputs():
    """Parameters of each algorithm, for a job as small as possible."""
    from qgis.PyQt.QtCore import QVariant

    scene = json.loads((SCENE / "scene.json").read_text())
    real, text = QVariant.Double, QVariant.String
    pose = ("heading", "pitch", "roll", "hfov", "vfov")
    photo = [scene["photo"], *(scene[name] for name in pose)]
    fields = [("photo", text), *((name, real) for name in pose)]
    at = f"Point({scene['longitude']!r} {scene['latitude']!r})"
    points = layer("Point?crs=EPSG:4326", fields, [(at, photo)])
    west, south = scene["longitude"] - 0.004, scene["latitude"] - 0.003
    around = f"{west},{west + 0.008},{south},{south + 0.006} [EPSG:4326]"
    ahead = layer("Point?crs=EPSG:4326", [("name", text)], [(scene["seen"], ["x"])])
    drawn = [("photo", text), ("x", real), ("y", real), ("label", text)]
    pixels = layer("NoGeometry", drawn, [(None, [scene["photo"], 400, 500, "slope"])])
    line = scene["line"]
    table = SCENE / "drawn.csv"
    table.write_text(f"photo,x,y,feature,kind\n{line}")
    common = {"INPUT": points, "DEM": scene["dem"], "MAX_DISTANCE": 3000}
    names = ("x_extracted", "y_extracted", "x_synthetic", "y_synthetic", "width", "height", "hfov", "vfov")
    offsets = [("photo", text), *((name, real) for name in names)]
    offsets = layer("NoGeometry", offsets, [(None, ["a", 100, 200, 150, 190, 1000, 500, 60.0, 30.0])])
    return {
        "importphotos": {"FOLDER": str(SCENE / "odd")},
        "locatephotos": {
            "FOLDER": scene["folder"],
            "DEM": scene["dem"],
            "SPACING": 2000,
            "MAX_DISTANCE": 5000,
            "RADIUS": 1500,
        },
        "positioncheck": {"INPUT": points, "DEM": scene["dem"], "RADIUS": 100, "MAX_DISTANCE": 5000},
        "orientability": {"INPUT": points, "DEM": scene["dem"], "HFOVS": "60", "MAX_DISTANCE": 5000, "EXTENT": around},
        "expectedaccuracy": {"INPUT": points, "DEM": scene["dem"], "PHOTOS": 1},
        "positionphotos": {"FOLDER": str(SCENE / "odd"), "TRACK": track()},
        "orientphotos": {"INPUT": points, "DEM": scene["dem"]},
        "photoviewshed": {"FOLDER": scene["folder"], "DEM": scene["dem"], "MAX_DISTANCE": 3000},
        "directedviewshed": common,
        "exportheadings": {"INPUT": points},
        "extractskyline": {"INPUT": points},
        "horizonprofile": {"INPUT": points, "DEM": scene["dem"], "MAX_DISTANCE": 3000},
        "simulatephotos": {"INPUT": points, "DEM": scene["dem"], "WIDTH": 200, "HEIGHT": 150},
        "measureoffsets": {"INPUT": offsets},
        "drapephoto": common,
        "labelpeaks": {**common, "PEAKS": ahead},
        "maptopixel": {**common, "FEATURES": ahead, "NAME_FIELD": "name"},
        "pixeltomap": {**common, "PIXELS": pixels, "PIXEL_FILE": str(table)},
        "panorama": {**common, "PEAKS": ahead},
        "photocoverage": common,
        "whichphotos": {**common, "PLACES": ahead, "NAME_FIELD": "name"},
    }


def track():
    """Line of a walk; its M values are seconds since 1970."""
    return layer("LineStringM?crs=EPSG:4326", [], [("LineStringM (8 46.5 0, 8.1 46.5 3600)", [])])


def layer(kind, fields, rows):
    """Layer in memory from rows of (WKT or None, attributes), in the project."""
    from map_layers import memory_layer
    from qgis.core import QgsProject

    return QgsProject.instance().addMapLayer(memory_layer(kind, fields, rows, crs=""))


if __name__ == "__main__":
    main()
