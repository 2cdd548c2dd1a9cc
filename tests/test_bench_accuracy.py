import csv
import json
import shutil
import sys

import pytest
from skyline_viewshed.core.batch import PhotoRequest, orient_request
from skyline_viewshed.core.io.raster import open_dem


@pytest.fixture(scope="module")
def bench():
    from pathlib import Path

    sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks"))
    import bench_accuracy

    return bench_accuracy


@pytest.fixture(scope="module")
def folder(scene, tmp_path_factory):
    """The layout that the benchmark reads, with one photo that needs the table's position."""
    root = tmp_path_factory.mktemp("bench")
    shutil.copytree(scene.folder, root / "photos")
    shutil.copy(scene.odd / "no_gps.jpg", root / "photos")
    (root / "dem").mkdir()
    shutil.copy(scene.dem, root / "dem")
    with open(root / "truth.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(
            [
                "photo",
                "group",
                "latitude_deg",
                "longitude_deg",
                "heading_deg",
                "pitch_deg",
                "roll_deg",
                "given_hfov_deg",
            ]
        )
        for name, place in (("north.jpg", "north"), ("west.jpg", "west"), ("no_gps.jpg", "west")):
            longitude, latitude = scene.positions[place]
            pose = scene.truth[place]
            writer.writerow([name, "good", latitude, longitude, pose.heading_deg, pose.pitch_deg, pose.roll_deg, ""])
        writer.writerow(["missing.jpg", "hard", 46.5, 8.0, "", "", "", ""])
    return root


def test_the_benchmark_measures_through_the_same_entry_and_writes_its_report(bench, folder, tmp_path, capsys):
    output = tmp_path / "out" / "accuracy.json"
    bench.main([str(folder), "--output", str(output), "--no-paper"])
    report = json.loads(output.read_text())
    rows = {row["photo"]: row for row in report["photos"]}
    assert all(abs(rows[name]["error_deg"]) < 0.5 for name in ("north.jpg", "west.jpg", "no_gps.jpg"))
    assert rows["missing.jpg"]["status"] == "failed"
    assert report["summary"]["all"]["photos"] == 3
    assert report["summary"]["all"]["< 0.5"] == 3
    assert rows["north.jpg"]["compass_error_deg"] == pytest.approx(6.0, abs=0.01)
    same = orient_request(
        PhotoRequest(str(folder / "photos" / "north.jpg")), open_dem(str(next((folder / "dem").iterdir())))
    )
    assert rows["north.jpg"]["heading_deg"] == pytest.approx(same.orientation.best.pose.heading_deg, abs=1e-9)
    printed = capsys.readouterr().out
    assert "north.jpg" in printed
    assert "compass alone" in printed


def test_counts_treat_a_photo_without_answer_as_wrong(bench):
    rows = [{"error_deg": 0.2}, {"error_deg": -2.0}, {"error_deg": None}]
    counts = bench._counts(rows, "error_deg")
    assert (counts["< 0.5"], counts["< 3"], counts["< 10"], counts["photos"]) == (1, 2, 2, 3)


def test_risk_is_counted_among_the_surest(bench):
    rows = [{"p_correct": p, "error_deg": e} for p, e in ((0.99, 0.1), (0.9, 0.2), (0.5, 50.0), (0.2, 80.0))]
    assert [entry["wrong"] for entry in bench.risk_coverage(rows)] == [0, 0, 1, 2]


def test_a_folder_without_exactly_one_raster_is_refused(bench, tmp_path):
    (tmp_path / "dem").mkdir()
    with pytest.raises(SystemExit, match="exactly one raster"):
        bench.dem_of(tmp_path)
