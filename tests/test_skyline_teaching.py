"""The skyline benchmark and the tool that fits its weights, on small drawn pictures."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image
from scipy.optimize import check_grad
from scripts import ROOT, script


@pytest.fixture(scope="module")
def teacher():
    return script("tools/fit_skyline.py")


def drawn(seed, height=240, width=320):
    """Sky over rough ground, uint8 RGB, and the first ground row per column."""
    rng = np.random.default_rng(seed)
    row = np.ceil(height * (0.4 + 0.1 * np.sin(np.arange(width) / width * 6 + seed)))
    picture = np.full((height, width, 3), (120.0, 160.0, 220.0)) + rng.normal(0, 2, (height, width, 3))
    ground = np.arange(height)[:, None] >= row
    picture[ground] = (90, 85, 60) + rng.normal(0, 30, (ground.sum(), 1))
    return np.clip(picture, 0, 255).astype(np.uint8), row


@pytest.fixture(scope="module")
def mask_folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("masks")
    for kind in ("images", "masks"):
        (folder / kind).mkdir()
    for seed in range(3):
        pixels, row = drawn(seed)
        Image.fromarray(pixels).save(folder / "images" / f"drawn{seed}.png")
        mask = (np.arange(240)[:, None] >= row).astype(np.uint8) * 255
        Image.fromarray(mask).save(folder / "masks" / f"drawn{seed}.png")
    return folder


def test_the_benchmark_measures_both_methods(mask_folder, tmp_path):
    """As the Makefile calls it: a line per picture, a summary per method, and the JSON."""
    out = tmp_path / "build" / "skyline.json"
    run = subprocess.run(
        [sys.executable, str(ROOT / "benchmarks" / "bench_skyline.py"), str(mask_folder), "--out", str(out)],
        env={**os.environ, "PYTHONPATH": str(ROOT / "build" / "plugins")},
        capture_output=True,
        text=True,
        check=True,
    )
    report = json.loads(out.read_text())
    assert [r["image"] for r in report["images"]] == ["drawn0.png", "drawn1.png", "drawn2.png"]
    assert not any(r["cross_validated"] for r in report["images"])
    assert report["summary"]["robust"]["median_of_medians_px"] <= 1.5
    assert report["summary"]["robust"]["images_below_1_percent"] == 1
    assert report["summary"]["paper"]["images"] == 3
    assert run.stdout.count("drawn") == 3
    assert "paper" in run.stdout


def test_pictures_that_taught_are_scored_by_weights_that_never_saw_them():
    """Five folds, no picture twice, every table complete."""
    from skyline_viewshed.core.skyline.evidence import shipped_weights

    held_out = script("benchmarks/bench_skyline.py").held_out_weights()
    folds = json.loads((ROOT / "benchmarks" / "skyline_folds.json").read_text())["folds"]
    assert len(held_out) == sum(len(fold["held_out"]) for fold in folds) == 30
    assert all(set(weights) == set(shipped_weights()) for weights in held_out.values())
    assert len({json.dumps(fold["weights"]) for fold in folds}) == len(folds) == 5


def test_the_loss_has_the_gradient_that_the_fit_is_told(teacher):
    """Finite differences on random scores."""
    rows = np.array([3.2, 7.0])
    shape = (2, 12)

    def value(flat):
        return teacher.column_loss(flat.reshape(shape), rows)[0].sum()

    def slope(flat):
        return teacher.column_loss(flat.reshape(shape), rows)[1].ravel()

    start = np.random.default_rng(0).normal(size=24)
    assert check_grad(value, slope, start) < 1e-6


def test_the_fit_finds_the_one_feature_that_tells(teacher):
    """Of four features one peaks at the true row; it gets nearly all the weight."""
    rng = np.random.default_rng(1)
    pictures = []
    for name in "abc":
        rows = rng.integers(5, 35, 30).astype(float)
        features = rng.normal(size=(30, 40, 4)).astype(np.float32)
        features[..., 2] += 4 * np.exp(-0.5 * (np.arange(40) - rows[:, None]) ** 2)
        pictures.append((name, features, rows))
    weights, loss = teacher.fit(pictures)
    assert weights.argmax() == 2
    assert np.abs(np.delete(weights, 2)).max() < 0.15 * weights[2]
    assert loss < np.log(40)


def test_variants_keep_the_truth_on_the_boundary(teacher):
    """After cropping, squeezing, flipping and spoiling, it is still brighter above the row than below."""
    checked = 0
    for seed in range(12):
        pixels, row = drawn(seed, 480, 640)
        made = teacher.variant(pixels, row, np.random.default_rng(seed))
        if made is None:
            continue
        picture, rows = made
        assert rows.shape == (picture.shape[1],)
        for x in np.flatnonzero(np.isfinite(rows) & (rows > 12) & (rows < len(picture) - 14))[::9]:
            y = int(rows[x])
            assert picture[y - 9 : y - 2, x, 2].mean() > picture[y + 3 : y + 10, x, 2].mean()
            checked += 1
    assert checked > 100


def test_resampling_scales_first_rows_as_edges(teacher):
    """Row 100 of 400 is row 25 of 100: edges carry no half pixel."""
    pixels = np.zeros((400, 400, 3), np.uint8)
    pixels[100:] = 200
    small, rows = teacher.resample(pixels, np.full(400, 100.0), 100, 100)
    np.testing.assert_allclose(rows, 25)
    assert (small[24] == 0).all()
    assert (small[25] == 200).all()
