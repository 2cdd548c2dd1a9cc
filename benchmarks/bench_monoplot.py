"""Measure monoplotting on simulated photographs: `make bench-monoplot [SCENES=60] [SEED=1]`.

Each scene is rendered from procedural mountains with exact ground truth for every pixel. Pixels are then placed on
the map twice:

- *geometry*: with the true pose, position and DEM, which leaves only the method's own error against the renderer;
- *real life*: with pose, focal length, position and eye height drawn from `ERRORS`, and a DEM that differs from the
  ground by smooth noise of 3 m. The benchmark counts how often the error ellipses for 50, 68 and 90 % contain the
  truth.

It reports the median and 90 % ground error against distance and incidence angle, the coverage of the ellipses, and the
share of pixels flagged as lying at an edge. It writes `build/monoplot.json`.
"""

from __future__ import annotations

import argparse
import json
import time
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy.ndimage import gaussian_filter
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.curvature import METRES_PER_DEGREE
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.base.uncertainty import PoseUncertainty
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.mapping.monoplot import EllipseOptions, ground_ellipses, place_pixels
from skyline_viewshed.core.mapping.projecting import Places, project_places
from skyline_viewshed.core.mapping.sightline import SightOptions
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains
from skyline_viewshed.demo.viewpoint import ViewpointOptions, find_view

RANGE_M = 12_000.0
DISTANCES_M = (0, 500, 1000, 2000, 4000, 8000, 12_000)
INCIDENCES_DEG = (0, 45, 60, 70, 80, 85, 90)
COVERAGES = (0.5, 0.68, 0.9)
PIXELS = 250
ERRORS = PoseUncertainty(0.5, 0.2, 0.3, 0.01, 5.0, 2.0, 3.0)
"""Uncertainty of the published figures; the defaults are larger, for photographs of which less is known."""


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=Path, default=Path("build/monoplot.json"))
    given = parser.parse_args(arguments)
    started, rows = time.perf_counter(), []
    for index in range(given.scenes):
        rows.append(measure(given.seed, index))
        print(f"scene {index + 1}/{given.scenes}: {len(rows[-1]['distance_m'])} pixels on the ground", flush=True)
    pixels = {key: np.concatenate([row[key] for row in rows]) for key in rows[0]}
    report = summarise(pixels)
    report.update(scenes=given.scenes, seed=given.seed, seconds=round(time.perf_counter() - started, 1))
    print(table(report))
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.write_text(json.dumps(report, indent=1), encoding="utf-8")
    print(f"written: {given.output}")


@lru_cache(maxsize=1)
def mountains(seed):
    return make_mountains(seed, MountainOptions(size=384, cell_m=30.0))


def measure(seed, index):
    """Place the pixels of one scene; return arrays per pixel."""
    random = np.random.default_rng([seed, index])
    terrain = mountains(seed + index // 12)
    width = 480
    camera = Camera(width, 360, focal_of_fov_px(width, random.uniform(20, 70)))
    options = ViewpointOptions(eye_height_m=30.0, near_m=800.0, range_m=RANGE_M, roll_sigma_deg=1.5, tries=400)
    observer, pose = find_view(terrain, camera, random, terrain.position_of, options)
    pose = replace(pose, pitch_deg=pose.pitch_deg - 0.2 * camera.vfov_deg)  # ground rather than sky
    seen = render_view(terrain, observer, camera, pose)
    x, y = random.integers(0, width, 4 * PIXELS), random.integers(0, 360, 4 * PIXELS)
    ground = np.flatnonzero(np.isfinite(seen.distance_m[y, x]) & (seen.distance_m[y, x] > 60))[:PIXELS]
    x, y = x[ground].astype(float), y[ground].astype(float)
    truth = [field[y.astype(int), x.astype(int)].astype(float) for field in (seen.east_m, seen.north_m)]
    result = geometry(terrain, observer, camera, pose, x, y, truth)
    result.update(real_life(terrain, observer, camera, pose, x, y, truth, random))
    return result


def geometry(terrain, observer, camera, pose, x, y, truth):
    """Compute the errors if everything is known, and project the places back to pixels."""
    view = open_view(terrain, PosedPhoto(camera, pose, observer), RANGE_M)
    placed = place_pixels(terrain, view, x, y, SightOptions(max_distance_m=RANGE_M))
    back = project_places(terrain, view, Places(placed.hits.east_m, placed.hits.north_m))
    return {
        "distance_m": np.hypot(*truth),
        "incidence_deg": placed.incidence_deg,
        "geometry_m": np.hypot(placed.hits.east_m - truth[0], placed.hits.north_m - truth[1]),
        "round_trip_px": np.hypot(back.x_px - x, back.y_px - y),
    }


def real_life(terrain, observer, camera, pose, x, y, truth, random):
    """Compute errors and ellipses with an uncertain pose, position and DEM."""
    off = random.standard_normal(7) * ERRORS.sigmas
    noise = gaussian_filter(random.standard_normal(terrain.shape), 8.0)
    dem = replace(terrain, elevation_m=(terrain.elevation_m + noise * (ERRORS.dem_m / noise.std())).astype(np.float32))
    true_eye_m = open_view(terrain, PosedPhoto(camera, pose, observer), RANGE_M).eye_elevation_m
    eye = true_eye_m + random.standard_normal() * ERRORS.eye_m
    per_degree = METRES_PER_DEGREE
    place = (
        observer.longitude_deg + off[4] / per_degree / np.cos(np.radians(terrain.latitude_deg)),
        observer.latitude_deg + off[5] / per_degree,
    )
    photo = PosedPhoto(
        replace(camera, focal_px=camera.focal_px * float(np.exp(off[3]))),
        Pose(pose.heading_deg + off[0], pose.pitch_deg + off[1], pose.roll_deg + off[2]),
        Observer(*place, eye_elevation_m=eye),
        ERRORS,
    )
    believed = open_view(dem, photo, RANGE_M)
    options = SightOptions(max_distance_m=RANGE_M)
    placed = place_pixels(dem, believed, x, y, options)
    east, north = truth[0] - placed.hits.east_m - off[4], truth[1] - placed.hits.north_m - off[5]
    result = {"error_m": np.hypot(east, north)}
    for coverage in COVERAGES:
        ellipse = ground_ellipses(dem, believed, placed, EllipseOptions(coverage), options)
        angle = np.radians(ellipse.azimuth_deg)
        along, across = east * np.sin(angle) + north * np.cos(angle), east * np.cos(angle) - north * np.sin(angle)
        inside = (along / ellipse.semi_major_m) ** 2 + (across / ellipse.semi_minor_m) ** 2 <= 1
        result[f"inside_{round(100 * coverage)}"] = inside
    result.update(major_m=ellipse.semi_major_m, p_other=ellipse.p_other, on_ground=placed.hits.on_ground)
    return result


def summarise(pixels):
    """Compute tables by distance and incidence, and the coverage."""
    placed = pixels["on_ground"] & np.isfinite(pixels["major_m"])
    report = {
        "pixels": int(placed.size),
        "round_trip_px_head_on": quantiles(pixels["round_trip_px"][pixels["incidence_deg"] < 80]),
        "sky_by_mistake": float((~pixels["on_ground"]).mean()),
        "at_edge": float((pixels["p_other"][placed] > 0.05).mean()),
        "coverage": coverage_of(pixels, placed & (pixels["p_other"] <= 0.05)),
        "coverage_at_edges": coverage_of(pixels, placed & (pixels["p_other"] > 0.05)),
        "geometry": quantiles(pixels["geometry_m"]),
    }
    for key, edges in (("distance_m", DISTANCES_M), ("incidence_deg", INCIDENCES_DEG)):
        report[f"by_{key}"] = [line(pixels, placed, key, low, high) for low, high in zip(edges[:-1], edges[1:])]
    return report


def line(pixels, placed, key, low, high):
    """Compute one row of a table."""
    mine = placed & (pixels[key] >= low) & (pixels[key] < high)
    sure = mine & (pixels["p_other"] <= 0.05)
    return {
        "from": low, "to": high, "pixels": int(mine.sum()),
        "geometry_m": quantiles(pixels["geometry_m"][mine]),
        "error_m": quantiles(pixels["error_m"][mine]),
        "major_m": quantiles(pixels["major_m"][mine]),
        "at_edge": float((pixels["p_other"][mine] > 0.05).mean()) if mine.any() else None,
        "inside_90": float(pixels["inside_90"][sure].mean()) if sure.any() else None,
    }  # fmt: skip


def coverage_of(pixels, mine):
    """Share of the true places inside the ellipses, for each stated coverage."""
    if not mine.any():
        return None
    return {str(c): float(pixels[f"inside_{round(100 * c)}"][mine].mean()) for c in COVERAGES}


def quantiles(values):
    """Return the median and the 90 % quantile of the known values."""
    values = values[np.isfinite(values)]
    return [float(v) for v in np.quantile(values, (0.5, 0.9))] if values.size else None


def table(report):
    """Format the report for a terminal."""

    def pair(values):
        return f"{values[0]:8.1f} /{values[1]:8.1f}" if values else f"{'-':>18}"

    lines = [
        f"{report['pixels']} pixels of {report['scenes']} simulated photographs, {report['seconds']} s",
        f"method alone against the renderer: {pair(report['geometry'])} m (median / 90 %)",
        f"pixel -> map -> pixel, incidence below 80 degrees: {report['round_trip_px_head_on'][0]:.4f} / "
        f"{report['round_trip_px_head_on'][1]:.4f} px",
        f"coverage of the ellipses: {report['coverage']}, at edges {report['coverage_at_edges']}; "
        f"{100 * report['at_edge']:.1f} % of the pixels are warned of as edges, "
        f"{100 * report['sky_by_mistake']:.1f} % taken for sky",
        "",
    ]
    for key in ("distance_m", "incidence_deg"):
        lines.append(f"{key:>16}   pixels    method alone (m)       real life (m)    ellipse major (m)  edge  in 90 %")
        for row in report[f"by_{key}"]:
            share = "-" if row["inside_90"] is None else f"{row['inside_90']:.2f}"
            edge = "-" if row["at_edge"] is None else f"{row['at_edge']:.2f}"
            lines.append(
                f"{row['from']:>7} - {row['to']:<6} {row['pixels']:>8}  {pair(row['geometry_m'])}  "
                f"{pair(row['error_m'])}   {pair(row['major_m'])}  {edge:>4}  {share:>6}"
            )
        lines.append("")
    return "\n".join(lines)


if __name__ == "__main__":
    main()
