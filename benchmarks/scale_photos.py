"""Photographs and terrain for bench_scale.py: pictures, repeated at jittered places, over a DEM of 100 tiles.

Either the photographs of khumbu-trek over its DEM, or photographs of four regions and views cut from them
(bench_views.py), so that as many pictures as wanted differ, over the four DEMs.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import cv2
import numpy as np
import skyline_viewshed as sv
from osgeo import gdal
from PIL import Image
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.match.prior import camera_prior

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bench_accuracy import dem_of, read_truth, request_of  # noqa: E402
from bench_many import SETS  # noqa: E402
from bench_views import SHAPES, inside, spoil, view_of  # noqa: E402

TILES = 10
JITTER_M = 300.0
SOURCE_PX = 2400
KNOWN = "photographs.json"
FINER, MIRRORED_CELLS = 3, 2600


def prepare(folder, data, pixels, distinct, fine):
    """Write tiles, the VRT that joins them, reduced photographs, and the list of these.

    Parameters
    ----------
    folder, data : Path
    pixels : int
        Long side of the pictures.
    distinct : int or None
        Number of pictures that differ; None takes the photographs of khumbu-trek.
    fine : bool
        Make the cells of the DEMs smaller and mirror them at their edges; see `finer`.
    """
    sets = SETS[:1] if distinct is None else SETS
    side = TILES if distinct is None else round(TILES / np.sqrt(len(sets)))
    tiles = [tile for name in sets for tile in cut(opened(dem_of(data / name), fine), folder, name, side)]
    gdal.BuildVRT(str(folder / "tiles.vrt"), tiles, resolution="highest", resampleAlg="bilinear").FlushCache()
    known = []
    for name in sets:
        for line in read_truth(data / name):
            request = request_of(data / name, line)
            known.append(entry(request, reduced(request.path, folder, pixels)))
    known = known[:distinct]
    generator, originals = np.random.default_rng(11), list(known)
    while len(known) < (distinct or 0):
        known.append(view_from(originals[len(known) % len(originals)], folder, pixels, generator, len(known)))
    (folder / KNOWN).write_text(json.dumps(known, indent=1), encoding="utf-8")


def opened(source, fine):
    """Open a DEM, or make a finer one of it."""
    dataset = gdal.Open(str(source))
    return finer(dataset) if fine else dataset


def finer(dataset):
    """Make a DEM of a third of the cell size that reaches 100 km, as one of 1 arc-second does, by mirroring it."""
    shares = {"widthPct": 100 * FINER, "heightPct": 100 * FINER, "resampleAlg": "cubic"}
    small = gdal.Translate("", dataset, format="MEM", **shares)
    heights = np.pad(np.round(small.ReadAsArray(), 1), MIRRORED_CELLS, mode="symmetric")
    west, width, _, north, _, height = small.GetGeoTransform()
    made = gdal.GetDriverByName("MEM").Create("", *heights.shape[::-1], 1, gdal.GDT_Float32)
    made.SetGeoTransform([west - MIRRORED_CELLS * width, width, 0, north - MIRRORED_CELLS * height, 0, height])
    made.SetProjection(small.GetProjection())
    made.GetRasterBand(1).WriteArray(heights)
    return made


def cut(dataset, folder, name, side):
    """Cut a DEM into side x side compressed tiles and return their paths."""
    rows, cols = (np.linspace(0, size, side + 1).astype(int) for size in (dataset.RasterYSize, dataset.RasterXSize))
    tiles = []
    for row, (top, bottom) in enumerate(zip(rows[:-1].tolist(), rows[1:].tolist())):
        for col, (left, right) in enumerate(zip(cols[:-1].tolist(), cols[1:].tolist())):
            tiles.append(str(folder / f"{name}-{row}-{col}.tif"))
            window = [left, top, right - left, bottom - top]
            gdal.Translate(tiles[-1], dataset, srcWin=window, creationOptions=["COMPRESS=DEFLATE", "TILED=YES"])
    return tiles


def reduced(source, folder, pixels):
    """Write a photograph at a reduced size, with its metadata, and return the path."""
    picture = Image.open(source)
    path = folder / Path(source).name
    exif = picture.info.get("exif", b"")
    picture.thumbnail((pixels, pixels))
    picture.save(path, quality=90, exif=exif)
    return str(path)


def entry(request, path):
    """Describe a photograph by the path of its reduced picture, its own path, its place and its lens."""
    recorded = sv.read_metadata(request.path)
    known = request if recorded.longitude_deg is None else recorded
    place = known.longitude_deg, known.latitude_deg
    return {"path": path, "source": request.path, "place": place, "hfov_deg": request.hfov_deg,
            "focal_length_35mm": request.focal_length_35mm}  # fmt: skip


def view_from(original, folder, pixels, generator, number):
    """Cut a view at random out of a photograph, write it, and describe it."""
    photo = read_photo(original["source"], SOURCE_PX)
    metadata = photo.metadata
    if original["focal_length_35mm"] is not None:
        metadata = replace(metadata, focal_length_35mm=original["focal_length_35mm"])
    whole = SimpleNamespace(camera=camera_prior(metadata, original["hfov_deg"]).camera, pose=Pose(0.0))
    while True:
        shape, share = generator.choice(SHAPES), generator.uniform(0.4, 0.85)
        width, height = (pixels, int(pixels / shape)) if shape > 1 else (int(pixels * shape), pixels)
        hfov_deg = 2 * np.degrees(np.arctan(share * min(shape, 1.0) * np.tan(np.radians(whole.camera.hfov_deg / 2))))
        camera = Camera(width, height, focal_of_fov_px(width, hfov_deg))
        turn = generator.uniform(-0.4, 0.4, 2) * (whole.camera.hfov_deg, whole.camera.vfov_deg)
        pose = Pose(float(turn[0]), float(turn[1]), float(generator.normal(0, 4)))
        if inside(whole, camera, pose):
            break
    path = folder / f"view-{number}.jpg"
    picture = spoil(view_of(photo.pixels, whole, camera, pose), generator)
    cv2.imencode(".jpg", np.ascontiguousarray(picture[..., ::-1]))[1].tofile(path)
    return {**original, "path": str(path), "hfov_deg": float(camera.hfov_deg), "focal_length_35mm": None}


def requests(folder, count):
    """Return `count` requests for the pictures in turn, at jittered places, the same ones in every run."""
    known = json.loads((folder / KNOWN).read_text(encoding="utf-8"))
    rng, found = np.random.default_rng(7), []
    for index in range(count):
        one = known[index % len(known)]
        east, north = rng.uniform(-JITTER_M, JITTER_M, 2) / 111_195.0
        longitude, latitude = one["place"]
        place = float(longitude + east / np.cos(np.radians(latitude))), float(latitude + north)
        lens = {"hfov_deg": one["hfov_deg"], "focal_length_35mm": one["focal_length_35mm"]}
        found.append(sv.PhotoRequest(one["path"], *place, **lens))
    return found
