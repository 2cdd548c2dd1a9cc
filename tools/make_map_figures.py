"""Make the figures of docs/photo-to-map.md from what its commands leave in build/photo-to-map.

PYTHONPATH=build/plugins python tools/make_map_figures.py
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from osgeo import gdal, ogr
from PIL import Image

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "plugins"))
from skyline_viewshed.core.draw_raster import draw_dot, draw_line  # noqa: E402
from skyline_viewshed.core.hillshade import hillshade  # noqa: E402

RUN, IMAGES = ROOT / "build" / "photo-to-map", ROOT / "docs" / "images"
DEM = ROOT / "build" / "demo" / "sample" / "dem" / "mountains.tif"
EXTENT = (-6700.0, 5000.0, -3700.0, 8200.0)
"""West, south, east, north of the map, around the camera and the front [m in the DEM's CRS]."""
WIDTH_PX = 640


def main():
    IMAGES.mkdir(parents=True, exist_ok=True)
    photo = Image.open(RUN / "pictures" / "midday.png").convert("RGB")
    save(photo.crop((0, 380, 900, 960)), "photo-to-map-photo.png")
    save(Image.fromarray(map_of_the_front()), "photo-to-map-map.png")
    strip = Image.open(RUN / "panorama" / "panorama_2.png").convert("RGB")
    save(strip.crop((500, 480, 1700, strip.height)), "photo-to-map-panorama.png")


def save(image, name):
    """Write a figure of at most 640 pixels and 160 colours: pages stay light."""
    image.thumbnail((640, 640))
    image.quantize(160, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(IMAGES / name, optimize=True)
    print(name, (IMAGES / name).stat().st_size // 1024, "kB")


def map_of_the_front():
    """Hillshade, draped photograph, front and error ellipses."""
    west, south, east, north = EXTENT
    height = round(WIDTH_PX * (north - south) / (east - west))
    warp = {"outputBounds": EXTENT, "width": WIDTH_PX, "height": height, "format": "MEM", "resampleAlg": "cubicspline"}
    dem = gdal.Warp("", str(DEM), **warp).ReadAsArray()
    cell = (east - west) / WIDTH_PX
    shade = np.nan_to_num(hillshade(dem, (cell, cell))).astype(float)
    grey = 90 + 150 * shade / max(shade.max(), 1e-6)
    pixels = np.repeat(grey[..., None], 3, axis=2).astype(np.uint8)
    draped = gdal.Warp("", str(RUN / "draped.tif"), **{**warp, "resampleAlg": "near"}).ReadAsArray()
    seen = draped[3] == 255
    pixels[seen] = draped[:3].transpose(1, 2, 0)[seen]
    pixels = np.ascontiguousarray(pixels)

    def place(x, y):
        return (np.asarray(x) - west) / cell - 0.5, (north - np.asarray(y)) / cell - 0.5

    for x, y in chains("ellipses"):
        draw_line(pixels, *place(x, y), (255, 235, 120), 2, casing_px=1)
    for x, y in chains("lines"):
        draw_line(pixels, *place(x, y), (255, 154, 31), 3, casing_px=1)
    draw_dot(pixels, *(float(v) for v in place(*camera())), 5, (255, 255, 255))
    return pixels


def chains(layer):
    """Vertices of each line or outer ring of a layer."""
    data = ogr.Open(str(RUN / f"{layer}.gpkg"))
    found = []
    features = data.GetLayer()
    for feature in features:
        pending = [feature.GetGeometryRef().Clone()]
        while pending:
            geometry = pending.pop()
            if geometry.GetGeometryCount():
                pending += [geometry.GetGeometryRef(k).Clone() for k in range(geometry.GetGeometryCount())]
            else:
                points = np.array(geometry.GetPoints())
                found.append((points[:, 0], points[:, 1]))
    return found


def camera():
    """Place of the midday photo in the DEM's CRS."""
    from skyline_viewshed.core.io.raster import open_dem

    data = ogr.Open(str(RUN / "oriented.gpkg"))
    layer = data.GetLayer()
    layer.SetAttributeFilter("filename = 'midday'")
    feature = layer.GetNextFeature()
    point = feature.GetGeometryRef()
    dem = open_dem(str(DEM))
    col, row = (float(v) for v in dem.pixel_of(point.GetX(), point.GetY()))
    x0, dx, _, y0, _, dy = dem.geotransform
    return x0 + dx * (col + 0.5), y0 + dy * (row + 0.5)


if __name__ == "__main__":
    main()
