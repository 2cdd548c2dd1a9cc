"""The simulated benchmark and the demo's sample: drawn once, drawn alike, with truth that holds."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from scripts import script
from skyline_viewshed.core.base.camera import Camera, Pose, project
from skyline_viewshed.core.base.terrain import Observer, Window, bilinear, eye_elevation_m
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.demo.mountains import MountainOptions


def table_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def cases():
    return script("benchmarks/simulated_cases.py")


@pytest.fixture(scope="module")
def small_dems(cases, tmp_path_factory):
    """One small procedural DEM in place of all."""
    cases.PROCEDURAL = (MountainOptions(size=256, cell_m=90.0),)
    cases.REAL_DEMS = ()
    return cases.dem_paths(tmp_path_factory.mktemp("dems"))


def test_a_case_is_drawn_alike_every_time_and_levels_keep_their_promise(cases, small_dems):
    full = [cases.draw_case(5, index, "full", small_dems, 160) for index in range(6)]
    assert full[3] == cases.draw_case(5, 3, "full", small_dems, 160)
    assert full[3] != cases.draw_case(6, 3, "full", small_dems, 160)
    assert max(case.gps_error_m for case in full) > 3
    assert all(case.gps_error_m <= 100 and abs(case.pose.roll_deg) <= 8 for case in full)
    assert min(case.hfov_deg for case in full) + 10 < max(case.hfov_deg for case in full) < 90
    perfect = cases.draw_case(5, 0, "perfect", small_dems, 160)
    assert perfect.gps_error_m == 0 and perfect.factor == 1
    assert perfect.metadata.latitude_deg == pytest.approx(perfect.observer.latitude_deg, abs=1e-9)


def test_adverse_scenes_hold_what_went_wrong_on_real_photographs(cases, small_dems):
    drawn = [cases.draw_case(5, index, "adverse", small_dems, 160) for index in range(24)]
    assert all(case.scene.clouds in ("behind", "lid") and case.scene.foreground != "none" for case in drawn)
    assert all(case.scene.cloud_share >= 0.4 for case in drawn)
    assert 8 < max(abs(case.pose.roll_deg) for case in drawn) <= 15
    assert max(case.hfov_deg for case in drawn) > 80
    assert "adverse" not in cases.ORDINARY


def test_exact_and_clean_scenes_differ_by_the_mountain_alone(cases, small_dems):
    exact, clean = (cases.draw_case(5, 2, level, small_dems, 160) for level in ("exact", "clean"))
    assert (exact.factor, exact.roughness) == (1, 0.0)
    assert clean.factor > 1 and clean.roughness > 0
    assert exact.camera == clean.camera and exact.metadata.focal_length_35mm == clean.metadata.focal_length_35mm
    assert abs(exact.pose.roll_deg) <= 3 and 0 < exact.gps_error_m < 20


def test_a_taken_case_reads_back_with_the_truth_of_its_row(cases, small_dems, tmp_path):
    case = cases.draw_case(5, 1, "perfect", small_dems, 200)
    path, view = cases.take(case, str(tmp_path))
    row = cases.truth_row(case, view)
    json.dumps(row)
    photo = read_photo(path)
    assert photo.pixels.shape == (row["height_px"], row["width_px"], 3)
    assert photo.metadata.focal_length_35mm == row["focal_length_35mm"]
    # The highest terrain point of the DEM lies on or below the skyline of its own column.
    dem = open_dem(case.dem_path)
    frame = dem.frame(row["true_longitude_deg"], row["true_latitude_deg"], 60_000.0)
    elevation = dem.read(Window(0, 0, *dem.shape))
    assert eye_elevation_m(dem, frame, case.observer) == pytest.approx(row["eye_elevation_m"], abs=0.01)
    assert np.isfinite(bilinear(elevation, frame.row_px, frame.col_px))
    known = np.isfinite(view.skyline_row_px)
    assert known.mean() == pytest.approx(row["skyline_share"])


def test_the_dump_holds_photographs_skylines_and_statistics(cases, small_dems, tmp_path):
    bench = script("benchmarks/bench_simulated.py")
    bench.dump(tmp_path, 3, 5, small_dems, ["clean", "full"], 160)
    rows = table_of(tmp_path / "truth.csv")
    lines = (tmp_path / "truth.jsonl").read_text(encoding="utf-8").splitlines()
    assert [json.loads(line)["photo"] for line in lines] == [row["photo"] for row in rows]
    assert {row["group"] for row in rows} == {"clean", "full"}
    for row in rows:
        assert (tmp_path / "photos" / row["photo"]).exists()
        truth = np.load(tmp_path / "rows" / (Path(row["photo"]).stem + ".npz"))
        assert truth["skyline_row_px"].shape == truth["skyline_visible"].shape == (int(row["width_px"]),)


def test_the_summary_counts_what_it_says(cases):
    bench = script("benchmarks/bench_simulated.py")

    def row(error, p, status="accepted", covered=True, group="full"):
        return {
            "error_deg": error,
            "p_correct": p,
            "status": status,
            "covered": covered,
            "group": group,
            "clouds": "none",
            "foreground": "none",
            "hfov_deg": 50.0,
            "dem": "a/b.tif",
        }

    rows = [row(0.1, 0.97), row(-0.4, 0.96), row(5.0, 0.92, covered=False), row(None, None, "rejected", None)]
    rows.append(row(0.05, 0.99, group="perfect"))
    summary = bench.summarise(rows)
    full = summary["levels"]["full"]
    assert (full["photos"], full["within_0.2"], full["within_0.5"], full["within_3"]) == (4, 0.25, 0.5, 0.5)
    assert full["accepted_wrong"] == 1 and full["coverage_90"] == pytest.approx(2 / 3)
    assert summary["levels"]["perfect"]["within_0.2"] == 1.0
    assert summary["levels"]["clean"] == {"photos": 0}
    kept = {(r["from"], r["to"]): (r["photos"], r["kept"]) for r in summary["reliability"]}
    assert kept == {(0.9, 0.95): (1, 0.0), (0.95, 0.99): (2, 1.0)}
    bench.print_summary(summary)


def test_the_demos_sample_has_photographs_that_show_their_truth(tmp_path, monkeypatch):
    sample = script("tools/make_sample.py")
    monkeypatch.setattr(
        sample, "MOUNTAINS", MountainOptions(size=256, cell_m=90.0, longitude_deg=8.0, latitude_deg=46.5)
    )
    monkeypatch.setattr(sample, "SHOTS", (("one.jpg", 320, 240, 30, 0.0, {}), ("two.heic", 240, 320, 28, 3.0, {})))
    rows = sample.make_sample(tmp_path, seed=7)
    found = table_of(tmp_path / "truth.csv")
    assert [row["photo"] for row in found] == [row["photo"] for row in rows]
    assert list(found[0]) == list(sample.COLUMNS)
    dem = open_dem(str(tmp_path / "dem" / "mountains.tif"))
    for row in found:
        photo = read_photo(str(tmp_path / "photos" / row["photo"]))
        assert photo.metadata.latitude_deg == pytest.approx(float(row["latitude_deg"]), abs=1e-6)
        _assert_the_dems_skyline_shows(dem, photo, row)


def _assert_the_dems_skyline_shows(dem, photo, row):
    """Above the DEM's horizon, as the true pose projects it, the picture is brighter (sky) than below."""
    height, width = photo.pixels.shape[:2]
    camera = Camera(width, height, np.hypot(width, height) * float(row["focal_length_35mm"]) / np.hypot(36, 24))
    observer = Observer(float(row["longitude_deg"]), float(row["latitude_deg"]))
    profile = horizon_profile(dem, observer, HorizonOptions(max_distance_m=40_000.0))
    pose = Pose(*(float(row[key]) for key in ("heading_deg", "pitch_deg", "roll_deg")))
    x, y = project(camera, pose, profile.azimuth_deg, profile.elevation_deg)
    inside = np.isfinite(x) & (x >= 0) & (x <= width - 1) & (y > 12) & (y < height - 12)
    assert inside.sum() > 50
    col, line = np.rint(x[inside]).astype(int), np.rint(y[inside]).astype(int)
    blue = photo.pixels[..., 2].astype(float)
    step = np.abs(blue[line - 8, col] - blue[line + 8, col])
    flat = np.abs(blue[line - 12, col] - blue[line - 4, col])
    assert np.median(step) > 3 * np.median(flat)
