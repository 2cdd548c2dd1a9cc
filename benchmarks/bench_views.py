"""Measure views cut from real photographs.

`make bench-views DATA=folder [COUNT=6] [SEED=1] [COMPASS=ignore|prior] [JOINT=1]`.

A photograph whose pose is known contains every narrower view from the same place exactly, since a turn of the camera is
a homography. From each photograph of the group `good` in `folder/truth.csv` (see bench_accuracy.py) COUNT views are
drawn at random, with fields of view from a third of the photograph's, rolls up to 8 degrees, pictures in four shapes,
ridges that leave the frame, changed exposure, veil, grain and JPEG, and a focal length that is off by 1.5 %. They show
real skies, snow and rock under new poses: they are harder than the photographs, and closer to them than simulated ones.
Views of one photograph are not independent of each other, and their truth is that of the photograph's own fit, moved to
its known heading. With COMPASS=prior each view gets a compass heading with the spread and the faults that
`core.match.prior` assumes. With JOINT=1 the views of each photograph are also solved together, as `JOINT` does with
the photographs of a walk; the results alone are kept beside. The benchmark writes `build/views.json`.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
from skyline_viewshed.core.base.angles import difference, wrap_360
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, project, unproject
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.batch import PhotoRequest, orient_request
from skyline_viewshed.core.eyes import HorizonCache, other_eyes
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.many import look_again
from skyline_viewshed.core.match.prior import WIDE, CompassOptions, HeadingPrior, camera_prior, compass_prior
from skyline_viewshed.core.pipeline import Hints, OrientOptions, Setting, orient_photo
from skyline_viewshed.core.workers.pool import Outcome

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bench_accuracy import dem_of, read_truth, request_of  # noqa: E402
from bench_simulated import BINS, accuracy, reliability  # noqa: E402

SOURCE_PX, LONG_SIDE_PX = 2400, 1000
SHAPES = (4 / 3, 3 / 2, 3 / 4, 16 / 9)
ROLL_SIGMA_DEG, LARGEST_ROLL_DEG = 4.0, 8.0
FOCAL_SIGMA = 0.015
LEAST_SKYLINE = 0.6
"""Smallest share of the columns in which the horizon must lie inside the frame."""
TRIES = 400


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder with truth.csv, photos/ and dem/, or a folder of such folders")
    parser.add_argument("--count", type=int, default=6, help="views of each photograph")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--compass", choices=("ignore", "prior"), default="ignore")
    parser.add_argument("--joint", action="store_true", help="also solve the views of each photograph together")
    parser.add_argument("--pictures", type=Path, help="keep the views in this folder")
    parser.add_argument("--output", type=Path, default=Path("build/views.json"))
    given = parser.parse_args(arguments)
    folders = [given.data]
    if not (given.data / "truth.csv").exists():
        folders = sorted(path.parent for path in given.data.glob("*/truth.csv"))
    rows = []
    for folder in folders:
        for row in measure(folder, given):
            rows.append(row)
            print(line_of(row), flush=True)
    summary = {folder.name: accuracy([r for r in rows if r["folder"] == folder.name]) for folder in folders}
    report = {
        "seed": given.seed,
        "compass": given.compass,
        "views": rows,
        "summary": {**summary, "all": accuracy(rows)},
    }
    report["reliability"] = reliability(rows)
    if given.joint:
        report["summary"]["all, each alone"] = accuracy([r["alone"] for r in rows])
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.write_text(json.dumps(report, indent=1), encoding="utf-8")
    for name, counts in report["summary"].items():
        print(name, ", ".join(f"{k} {v:.2f}" if isinstance(v, float) else f"{k} {v}" for k, v in counts.items()))
    for low, high in zip(BINS, BINS[1:]):
        held = [r for r in rows if r["p_correct"] is not None and low <= r["p_correct"] < high]
        if held:
            right = np.mean([abs(r["error_deg"]) < 3 for r in held])
            print(f"p_correct {low:.2f} to {min(high, 1):.2f}: {len(held)} views, {right:.2f} right")
    print(f"written: {given.output}")


def measure(folder, given):
    """Yield the row of every view of a folder's photographs."""
    dem, cache, options = open_dem(str(dem_of(folder))), HorizonCache(), OrientOptions()
    for line in read_truth(folder):
        if line["group"] != "good":
            continue
        base = orient_request(request_of(folder, line), dem, options, cache)
        if base.orientation.best is None:
            print(f"{line['photo']}: has no pose to start from", flush=True)
            continue
        observer = Observer(base.longitude_deg, base.latitude_deg)
        photo = read_photo(str(Path(folder) / "photos" / line["photo"]), SOURCE_PX)
        with cache.station():
            horizon = cache.profile(dem, observer, options.horizon)
            inner = cache.inner(dem, observer, options.inner)
            eyes = other_eyes(dem, observer, horizon, photo.metadata.altitude_m, options, cache)
        views = []
        for number in range(given.count):
            # Each view has its own generator, so that a change of the base pose by hundredths of a degree affects few.
            generator = np.random.default_rng([given.seed, number, *line["photo"].encode()])
            drawn = draw_view(base, generator)
            if drawn is None:
                continue
            camera, pose = drawn
            pixels = spoil(view_of(photo.pixels, base.orientation.best, camera, pose), generator)
            heading = float(wrap_360(line["heading_deg"] + pose.heading_deg - base.orientation.best.pose.heading_deg))
            hints = (
                Hints(heading=compass_prior(read_compass(heading, generator))) if given.compass == "prior" else Hints()
            )
            metadata = replace(photo.metadata, width_px=camera.width_px, height_px=camera.height_px)
            known = camera.hfov_deg * np.exp(generator.normal(0, FOCAL_SIGMA))
            started = time.process_time()
            setting = Setting(observer, camera_prior(metadata, known), hints, horizon, inner, other_eyes=eyes)
            view = replace(photo, metadata=metadata, pixels=pixels)
            oriented = replace(orient_photo(view, dem, setting, options), preview=pixels)
            spent = time.process_time() - started
            if given.pictures:
                given.pictures.mkdir(parents=True, exist_ok=True)
                name = given.pictures / f"{Path(line['photo']).stem}_{number}.jpg"
                cv2.imencode(".jpg", np.ascontiguousarray(pixels[..., ::-1]))[1].tofile(name)
            row = row_of(folder, line, number, camera, pose, heading, oriented.orientation, spent)
            views.append((view, setting, oriented, row, (folder, line, number, camera, pose, heading)))
        yield from together(views, dem, given.compass) if given.joint and views else (row for *_, row, _ in views)


def together(views, dem, compass):
    """Solve the views of one photograph together; each row keeps the row of the view alone."""
    options = OrientOptions(compass=compass)
    tasks = [(PhotoRequest(str(number)), (view, setting)) for number, (view, setting, *_) in enumerate(views)]

    def orient_all(tasks, _):
        for request, (view, setting) in tasks:
            prior = HeadingPrior(request.heading_deg, request.heading_tolerance_deg / 2, 0.01)
            hinted = replace(setting, hints=Hints(heading=prior))
            yield Outcome(replace(orient_photo(view, dem, hinted, options), preview=view.pixels))

    found = look_again(tasks, [oriented for _, _, oriented, *_ in views], orient_all, SILENT, options)
    for (*_, row, case), oriented in zip(views, found):
        yield {**row_of(*case, oriented.orientation, row["cpu_s"]), "alone": row}


def draw_view(base, generator):
    """Draw a camera and pose whose picture lies inside the photograph and shows its horizon; None if none is found."""
    best = base.orientation.best
    azimuth = np.arange(0, 360, 0.05)
    elevation = np.interp(azimuth, base.horizon.azimuth_deg, base.horizon.elevation_deg, period=360)
    for _ in range(TRIES):
        shape, share = generator.choice(SHAPES), generator.uniform(0.3, 0.85)
        share *= min(shape, 1.0)
        width = LONG_SIDE_PX if shape > 1 else int(LONG_SIDE_PX * shape)
        hfov_deg = 2 * np.degrees(np.arctan(share * np.tan(np.radians(best.camera.hfov_deg / 2))))
        camera = Camera(width, int(width / shape), focal_of_fov_px(width, hfov_deg))
        pose = Pose(
            float(wrap_360(best.pose.heading_deg + generator.uniform(-0.5, 0.5) * best.camera.hfov_deg)),
            best.pose.pitch_deg + generator.uniform(-0.4, 0.4) * best.camera.vfov_deg,
            float(np.clip(generator.normal(0, ROLL_SIGMA_DEG), -LARGEST_ROLL_DEG, LARGEST_ROLL_DEG)),
        )
        if inside(best, camera, pose) and _skyline_share(camera, pose, azimuth, elevation) >= LEAST_SKYLINE:
            return camera, pose
    return None


def inside(best, camera, pose):
    """Tell whether a view lies inside a photograph of known camera and pose."""
    x = np.array([0, camera.width_px - 1, camera.width_px - 1, 0], float)
    y = np.array([0, 0, camera.height_px - 1, camera.height_px - 1], float)
    x, y = project(best.camera, best.pose, *unproject(camera, pose, x, y))
    return bool(((x >= 0) & (x <= best.camera.width_px - 1) & (y >= 0) & (y <= best.camera.height_px - 1)).all())


def _skyline_share(camera, pose, azimuth_deg, elevation_deg):
    x, y = project(camera, pose, azimuth_deg, elevation_deg)
    seen = (x >= 0) & (x < camera.width_px) & (y >= 0) & (y < camera.height_px)
    return len(np.unique(x[seen].astype(int) // 10)) * 10 / camera.width_px


def view_of(pixels, best, camera, pose):
    """Resample a photograph of known camera and pose, `best`, to another camera and pose, (H, W, 3) float32."""
    height, width = pixels.shape[:2]
    x, y = np.meshgrid(np.arange(camera.width_px, dtype=float), np.arange(camera.height_px, dtype=float))
    x, y = project(best.camera.scaled(width, height), best.pose, *unproject(camera, pose, x.ravel(), y.ravel()))
    shape = camera.height_px, camera.width_px
    maps = x.reshape(shape).astype(np.float32), y.reshape(shape).astype(np.float32)
    return cv2.remap(np.ascontiguousarray(pixels), *maps, cv2.INTER_LINEAR).astype(np.float32)


def spoil(picture, generator):
    """Change exposure and contrast, put a veil over a third of the pictures, add grain and JPEG artefacts; uint8."""
    picture = 255 * np.clip(picture / 255 * generator.uniform(0.7, 1.25), 0, 1) ** generator.uniform(0.8, 1.25)
    if generator.random() < 1 / 3:
        veil = generator.uniform(0.3, 0.7)
        picture = picture * (1 - veil) + np.array([205, 212, 222]) * veil
    picture = np.clip(picture + generator.normal(0, generator.uniform(0, 6), picture.shape), 0, 255).astype(np.uint8)
    quality = [cv2.IMWRITE_JPEG_QUALITY, int(generator.uniform(40, 92))]
    return cv2.imdecode(cv2.imencode(".jpg", picture, quality)[1], cv2.IMREAD_COLOR)


def read_compass(heading_deg, generator, options=CompassOptions()):  # noqa: B008 - frozen
    """Draw the reading of a phone's compass: the core's spread, quarter and half turns, and useless readings."""
    quarter, half = options.quarter_turn_share, options.half_turn_share
    chance = generator.random()
    if chance < options.outlier_share:
        return float(generator.uniform(0, 360))
    chance -= options.outlier_share
    turn = 90 if chance < quarter else -90 if chance < 2 * quarter else 180 if chance < 2 * quarter + half else 0
    spread = options.sigma_deg * (WIDE if generator.random() < options.wide_share else 1.0)
    return float(wrap_360(heading_deg + turn + generator.normal(0, spread)))


def row_of(folder, line, number, camera, pose, heading_deg, answer, cpu_s):
    """Combine the answer for one view with its truth."""
    best, covered = answer.best, None
    if best is not None and answer.heading_lo_deg is not None:
        covered = bool(
            (heading_deg - answer.heading_lo_deg) % 360 <= (answer.heading_hi_deg - answer.heading_lo_deg) % 360
        )
    return {
        "folder": folder.name,
        "photo": line["photo"],
        "view": number,
        "hfov_deg": camera.hfov_deg,
        "roll_deg": pose.roll_deg,
        "truth_deg": heading_deg,
        "error_deg": None if best is None else float(difference(best.pose.heading_deg, heading_deg)),
        "status": answer.status,
        "p_correct": answer.p_correct,
        "covered": covered,
        "cpu_s": cpu_s,
    }


def line_of(row):
    """Format one result as a line of text."""
    if "alone" in row:
        return f"{line_of(row['alone'])} together {line_of({k: v for k, v in row.items() if k != 'alone'})[44:]}"
    error = "   none" if row["error_deg"] is None else f"{row['error_deg']:7.2f}"
    sure = "  - " if row["p_correct"] is None else f"{row['p_correct']:.2f}"
    return (
        f"{row['photo'][:26]:26} {row['view']:2d} hfov {row['hfov_deg']:3.0f} roll {row['roll_deg']:5.1f}"
        f" error {error} p {sure} {row['status']:9} {row['cpu_s']:.1f} s"
    )


if __name__ == "__main__":
    main()
