"""Make the figures of docs/photo-to-map.md, and of the algorithms' help, from the outputs of that page's commands.

Usage: PYTHONPATH=build/plugins python tools/make_map_figures.py
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from osgeo import gdal, ogr
from PIL import Image

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "plugins"))
from skyline_viewshed.core.figures.hillshade import hillshade  # noqa: E402
from skyline_viewshed.core.figures.raster import LineStyle, draw_dot, draw_line, encode_jpeg, resized, tint  # noqa: E402

RUN, IMAGES, HELP = ROOT / "build" / "photo-to-map", ROOT / "docs" / "images", ROOT / "icons" / "help"
DEM = ROOT / "build" / "demo" / "sample" / "dem" / "mountains.tif"
EXTENT = (-6700.0, 5000.0, -3700.0, 8200.0)
"""West, south, east, north of the map, around the camera and the front [m in the DEM's CRS]."""
WIDE = (-10_500.0, 4500.0, 4500.0, 14_300.0)
"""The same for everything that both photographs show."""
WIDTH_PX, HELP_PX = 640, 420


def main():
    IMAGES.mkdir(parents=True, exist_ok=True)
    photo = Image.open(RUN / "pictures" / "midday.png").convert("RGB")
    save(photo.crop((0, 380, 900, 960)), "photo-to-map-photo.png")
    front = with_front(*ground(EXTENT, "draped"), EXTENT)
    save(Image.fromarray(front), "photo-to-map-map.png")
    strip = Image.open(RUN / "panorama" / "panorama_2.png").convert("RGB")
    save(strip.crop((500, 480, 1700, strip.height)), "photo-to-map-panorama.png")
    help_picture("pixeltomap", front)
    help_picture("maptopixel", np.asarray(photo.crop((60, 500, 760, 960))))
    help_picture("drapephoto", ground(WIDE, "draped")[0])
    help_picture("photocoverage", ground(WIDE, "count")[0])
    help_picture("panorama", np.asarray(strip.crop((500, 480, 1700, strip.height))))
    help_picture("labelpeaks", np.asarray(Image.open(RUN / "labelled" / "midday.png").convert("RGB"))[200:520, :640])
    help_picture("whichphotos", found())


def help_picture(name, pixels):
    """Write the picture in an algorithm's help."""
    height = round(HELP_PX * pixels.shape[0] / pixels.shape[1])
    (HELP / f"{name}.jpg").write_bytes(encode_jpeg(resized(np.ascontiguousarray(pixels), HELP_PX, height), 80))
    print(f"icons/help/{name}.jpg")


def found():
    """Draw the photograph with the requested place."""
    pixels = np.array(Image.open(ROOT / "build" / "demo" / "sample" / "photos" / "midday.jpg").convert("RGB"))
    turn = np.linspace(0, 2 * np.pi, 60)
    draw_line(pixels, 198 + 42 * np.cos(turn), 865 + 42 * np.sin(turn), (217, 72, 15), 7, LineStyle(casing_px=2))
    return pixels[480:, :640]


def save(image, name):
    """Write a figure of at most 640 pixels and 160 colours, so that pages stay small."""
    image.thumbnail((640, 640))
    image.quantize(160, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(IMAGES / name, optimize=True)
    print(name, (IMAGES / name).stat().st_size // 1024, "kB")


def ground(extent, layer):
    """Draw a hillshade with the draped photographs or the counts over it; also return the size of its cells [m]."""
    west, south, east, north = extent
    height = round(WIDTH_PX * (north - south) / (east - west))
    warp = {"outputBounds": extent, "width": WIDTH_PX, "height": height, "format": "MEM"}
    dem = gdal.Warp("", str(DEM), resampleAlg="cubicspline", **warp).ReadAsArray()
    cell = (east - west) / WIDTH_PX
    shade = np.nan_to_num(hillshade(dem, (cell, cell))).astype(float)
    grey = 90 + 150 * shade / max(shade.max(), 1e-6)
    pixels = np.repeat(grey[..., None], 3, axis=2).astype(np.uint8)
    over = gdal.Warp("", str(RUN / f"{layer}.tif"), resampleAlg="near", **warp).ReadAsArray()
    if layer == "draped":
        seen = over[3] == 255
        pixels[seen] = over[:3].transpose(1, 2, 0)[seen]
    else:
        for count, colour in ((1, (255, 196, 0)), (2, (216, 27, 96))):
            tint(pixels, 0.6 * (over == count), colour)
    return np.ascontiguousarray(pixels), cell


def with_front(pixels, cell, extent):
    """Draw front, error ellipse and camera on a map."""

    def place(x, y):
        return (np.asarray(x) - extent[0]) / cell - 0.5, (extent[3] - np.asarray(y)) / cell - 0.5

    for x, y in chains("ellipses"):
        draw_line(pixels, *place(x, y), (255, 235, 120), 2, LineStyle(casing_px=1))
    for x, y in chains("lines"):
        draw_line(pixels, *place(x, y), (255, 154, 31), 3, LineStyle(casing_px=1))
    draw_dot(pixels, *(float(v) for v in place(*camera())), 5, (255, 255, 255))
    return pixels


def chains(layer):
    """Read the vertices of each line or outer ring of a layer."""
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
    """Position of the midday photo in the DEM's CRS."""
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
