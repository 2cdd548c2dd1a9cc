"""Photo to map and back on real photographs whose pose others have measured."""

from __future__ import annotations

import csv
import json
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px, focal_of_fov_px
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.mapping.monoplot import place_pixels
from skyline_viewshed.core.mapping.peaks import own_ground_m, snap_to_summit
from skyline_viewshed.core.mapping.projecting import Places, PlaceState, project_places
from skyline_viewshed.core.mapping.sightings import find_sightings, place_of_height

pytestmark = pytest.mark.data

SUMMITS = (
    ("Everest", 27.9881, 86.9250, 8849),
    ("Lhotse", 27.9617, 86.9333, 8516),
    ("Nuptse", 27.9664, 86.8897, 7864),
    ("Ama Dablam", 27.8614, 86.8613, 6812),
    ("Thamserku", 27.7903, 86.7881, 6608),
    ("Kangtega", 27.7950, 86.8183, 6782),
)


def truth(folder):
    with open(folder / "truth.csv", encoding="utf-8") as file:
        return {row["photo"]: row for row in csv.DictReader(file)}


def numbers(row, *names):
    return [float(row[name]) for name in names]


def path_points(data):
    """Vertices of SVG path data; of curves, the end points."""
    x = y = 0.0
    points, command = [], "M"
    values = {"m": 2, "l": 2, "h": 1, "v": 1, "c": 6, "s": 4, "z": 0}
    tokens = re.findall(r"[a-zA-Z]|-?\d*\.?\d+(?:e-?\d+)?", data)
    while tokens:
        if tokens[0].isalpha():
            command = tokens.pop(0)
        count = values[command.lower()]
        given, tokens = [float(t) for t in tokens[:count]], tokens[count:]
        base = (x, y) if command.islower() else (0.0, 0.0)
        if command.lower() == "h":
            x = base[0] + given[0]
        elif command.lower() == "v":
            y = base[1] + given[0]
        elif count:
            x, y = base[0] + given[-2], base[1] + given[-1]
        if count:
            points.append((x, y))
    return np.array(points)


def traced_skyline(path, width_px):
    """Vertices of the traced skyline in pixels of the picture, counted from its corner."""
    root = ET.parse(path).getroot()
    scale = width_px / float(root.get("width").replace("px", ""))
    layer = next(g for g in root.iter("{http://www.w3.org/2000/svg}g") if g.get("id") == "horizon")
    found = []
    for item in layer.iter():
        if item.tag.endswith("path"):
            found.append(path_points(item.get("d")))
        elif item.tag.endswith("polyline"):
            found.append(np.array([float(v) for v in re.findall(r"-?[\d.]+", item.get("points"))]).reshape(-1, 2))
    return [points * scale for points in found]


def published_horizon(path, row):
    """Azimuth and elevation angle of the horizon's published points, by geodesy of its own (ECEF)."""
    with open(path, encoding="utf-8") as file:
        features = json.load(file)["features"]
    places = np.array([p for f in features for p in f["geometry"]["coordinates"]])

    def ecef(lon, lat, height):
        lon, lat = np.radians(lon), np.radians(lat)
        n = 6378137.0 / np.sqrt(1 - 0.00669437999014 * np.sin(lat) ** 2)
        return np.array([(n + height) * np.cos(lat) * np.cos(lon), (n + height) * np.cos(lat) * np.sin(lon),
                         (n * (1 - 0.00669437999014) + height) * np.sin(lat)])  # fmt: skip

    lon, lat, height = numbers(row, "longitude_deg", "latitude_deg", "height_ellipsoidal_m")
    d = ecef(*places.T) - ecef(lon, lat, height)[:, None]
    lo, la = np.radians(lon), np.radians(lat)
    east = -np.sin(lo) * d[0] + np.cos(lo) * d[1]
    north = -np.sin(la) * np.cos(lo) * d[0] - np.sin(la) * np.sin(lo) * d[1] + np.cos(la) * d[2]
    up = np.cos(la) * np.cos(lo) * d[0] + np.cos(la) * np.sin(lo) * d[1] + np.sin(la) * d[2]
    flat = np.hypot(east, north)
    refraction = 0.13 * flat / (2 * 6_371_000.0)  # the ray's bend lifts far ground
    return np.degrees(np.arctan2(east, north)) % 360, np.degrees(np.arctan2(up, flat) + refraction)


@pytest.mark.parametrize("photo", ["AK03b_20080621_201611.JPG", "AK10_20090803_195410.JPG"])
def test_traced_skyline_and_published_pose_reproduce_the_published_horizon(shared_data, photo):
    row = truth(shared_data / "columbia")[photo]
    width, height, fx, fy = numbers(row, "width_px", "height_px", "fx_px", "fy_px")
    camera = Camera(int(width), int(height), fx, *numbers(row, "cx_offset_px", "cy_offset_px", "k1", "k2"))
    pose = Pose(*numbers(row, "heading_deg", "pitch_deg", "roll_deg"))
    terrain_free_view = open_view_without_terrain(camera, pose)
    station = photo.split("_")[0]
    azimuth, elevation = published_horizon(shared_data / "columbia" / "horizons" / f"{station}.geojson", row)
    order = np.argsort(azimuth)
    residual = []
    for line in traced_skyline(shared_data / "columbia" / "traces" / photo.replace("JPG", "svg"), width):
        x, y = line.T - 0.5
        # The published pixels are not square: fy / fx is 1.005 and 1.001.
        y = camera.centre_px[1] + (y - camera.centre_px[1]) * fx / fy
        inside = (x > 0) & (x < width - 1) & (y > 0) & (y < height - 1)
        at_azimuth, at_elevation = terrain_free_view(x[inside], y[inside])
        residual.append(at_elevation - np.interp(at_azimuth, azimuth[order], elevation[order], period=360))
    residual = np.concatenate(residual)
    assert residual.size > 200
    assert np.median(np.abs(residual)) < 0.1


def open_view_without_terrain(camera, pose):
    from skyline_viewshed.core.base.camera import unproject

    return lambda x, y: unproject(camera, pose, x, y)


@pytest.fixture(scope="module")
def aletsch(shared_data):
    from skyline_viewshed.core.io.raster import open_dem

    folder = shared_data / "aletsch"
    dem = open_dem(folder / "dem" / "AletschGlacierDEM.tiff")
    row = truth(folder)["07861v.jpg"]
    from skyline_viewshed.core.io.photo import read_metadata

    metadata = read_metadata(folder / "photos" / "07861v.jpg")
    size = metadata.width_px, metadata.height_px
    lat, lon, eye, hfov = numbers(row, "latitude_deg", "longitude_deg", "height_orthometric_m", "given_hfov_deg")
    camera = Camera(*size, focal_of_fov_px(size[0], hfov))
    pose = Pose(*numbers(row, "heading_deg", "pitch_deg", "roll_deg"))
    view = open_view(dem, PosedPhoto(camera, pose, Observer(lon, lat, eye_elevation_m=eye)), 15_000.0)
    with open(folder / "gcps.csv", encoding="utf-8") as file:
        points = np.array([[float(v) for v in r.values()] for r in csv.DictReader(file)])
    x0, dx, _, y0, _, dy = dem.geotransform
    east, north = view.frame.to_local((points[:, 2] - x0) / dx - 0.5, (points[:, 3] - y0) / dy - 0.5)
    return dem, view, points, east, north


def test_the_control_points_of_aletsch_are_met_within_the_residual_of_the_known_pose(aletsch):
    dem, view, points, east, north = aletsch
    shown = project_places(dem, view, Places(east, north, points[:, 4]))
    off = np.hypot(shown.x_px - points[:, 0], shown.y_px - points[:, 1])
    # The pose is good to about 1 degree, which is 16 pixels of this picture.
    per_degree = view.camera.focal_px * np.radians(1)
    assert np.median(off) < 0.6 * per_degree and off.max() < 1.5 * per_degree
    assert (shown.state != PlaceState.OUTSIDE).all() and (shown.state == PlaceState.VISIBLE).sum() >= 8


def test_the_pixels_of_aletsch_land_near_their_control_points(aletsch):
    dem, view, points, east, north = aletsch
    placed = place_pixels(dem, view, points[:, 0], points[:, 1])
    distance = np.hypot(east, north)
    ground = placed.hits.on_ground
    assert ground.sum() >= 6
    turn = np.abs(difference(placed.azimuth_deg, np.degrees(np.arctan2(east, north))))
    assert np.median(turn) < 0.6
    share = np.abs(placed.hits.distance_m[ground] / distance[ground] - 1)
    assert np.median(share) < 0.15


def khumbu_view(shared_data, photo, row):
    from skyline_viewshed.core.io.photo import read_metadata
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(shared_data / "khumbu" / "dem" / "khumbu.tif")
    metadata = read_metadata(shared_data / "khumbu" / "photos" / photo)
    size = metadata.width_px, metadata.height_px
    camera = Camera(*size, focal_from_35mm_px(*size, float(row["focal_length_35mm"])))
    pose = Pose(*numbers(row, "heading_deg", "pitch_deg", "roll_deg"))
    place = numbers(row, "longitude_deg", "latitude_deg")
    return dem, open_view(dem, PosedPhoto(camera, pose, Observer(*place)), 60_000.0)


@pytest.mark.parametrize(
    ("photo", "expected"),
    [
        ("IMG_2195.HEIC", {"Everest", "Lhotse", "Nuptse"}),
        ("IMG_2209.HEIC", {"Everest", "Lhotse"}),
        ("IMG_2250.HEIC", {"Everest", "Lhotse", "Nuptse", "Ama Dablam"}),
        ("IMG_2332.HEIC", {"Ama Dablam"}),
        ("IMG_2528.HEIC", {"Lhotse"}),
        ("IMG_2622.HEIC", {"Ama Dablam"}),
        ("IMG_2203.HEIC", set()),
    ],
)
def test_the_named_summits_of_the_khumbu_are_found_in_their_photos(shared_data, photo, expected):
    row = truth(shared_data / "khumbu")[photo]
    dem, view = khumbu_view(shared_data, photo, row)
    seen, own, places = set(), own_ground_m(view.frame), []
    for name, latitude, longitude, height in SUMMITS:
        east, north = view.frame.to_local(*dem.pixel_of(longitude, latitude))
        places.append(place_of_height(dem, view.frame, (float(east), float(north)), float(height)))
        east, north, top = snap_to_summit(dem, view.frame, float(east), float(north), height)
        shown = project_places(
            dem, view, Places(np.array([east]), np.array([north]), np.array([float(height)]), own_ground_m=own)
        )
        if shown.visible[0]:
            seen.add(name)
    assert seen == expected
    sightings = find_sightings(dem, view, places)
    assert {SUMMITS[sighting.place][0] for sighting in sightings} == expected, "a search finds what the labels show"
