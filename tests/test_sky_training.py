"""What trains and measures the sky network, as far as it needs no PyTorch: pictures, weather, benchmark."""

from __future__ import annotations

import json
import sys

import cv2
import numpy as np
import pytest
from scripts import ROOT, script

GROUND, IGNORE, SKY = 255, 128, 0


@pytest.fixture(scope="module", autouse=True)
def sky_tools():
    """The modules of tools/sky import one another by their bare names."""
    sys.path.insert(0, str(ROOT / "tools" / "sky"))
    yield
    sys.path.remove(str(ROOT / "tools" / "sky"))


@pytest.fixture(scope="module")
def sky_folder(tmp_path_factory):
    """Two sets of three drawn pictures each: sky above row 80 of 200, two ignored rows, ground."""
    folder = tmp_path_factory.mktemp("sky")
    generator = np.random.default_rng(1)
    for source in ("mmp", "uav"):
        for kind in ("images", "labels"):
            (folder / source / kind).mkdir(parents=True)
        for index in range(3):
            pixels = np.full((200, 200, 3), (230, 170, 110)) + generator.normal(0, 2, (200, 200, 3))
            pixels[80:] = (60, 80, 90) + generator.normal(0, 25, (120, 200, 1))
            label = np.where(np.arange(200)[:, None] < 79, SKY, GROUND) * np.ones((1, 200))
            label[79:81] = IGNORE
            cv2.imwrite(str(folder / source / "images" / f"drawn{index}.jpg"), np.clip(pixels, 0, 255).astype(np.uint8))
            cv2.imwrite(str(folder / source / "labels" / f"drawn{index}.png"), label.astype(np.uint8))
    return folder


@pytest.fixture(scope="module")
def pictures(sky_folder):
    return script("tools/sky/data.py").load(sky_folder, "mmp")


def test_pictures_come_in_rgb_with_their_labels(pictures):
    assert [p.name for p in pictures] == ["drawn0", "drawn1", "drawn2"]
    first = pictures[0]
    assert first.pixels[:70].mean((0, 1)) == pytest.approx((110, 170, 230), abs=3)
    assert [int(first.label[row, 5]) for row in (0, 80, 199)] == [SKY, IGNORE, GROUND]


def test_every_picture_of_a_set_is_as_likely_as_its_fellows(sky_folder, pictures):
    data = script("tools/sky/data.py")
    chances = data.draw_weights(pictures + data.load(sky_folder, "uav"))
    assert chances.sum() == pytest.approx(1)
    assert chances[:3] / chances[3:] == pytest.approx(data.SET_WEIGHTS["mmp"] / data.SET_WEIGHTS["uav"])


def test_of_a_drone_recording_all_frames_or_none_are_held_out():
    """Here one whole recording; names do not repeat."""
    held_out = json.loads((ROOT / "tools" / "sky" / "held_out.json").read_text())
    assert {name.split("-")[0] for name in held_out["uav"]} == {"e5"}
    assert len(set(held_out["mmp"])) == len(held_out["mmp"]) == 28


def test_samples_keep_sky_and_ground_apart(pictures):
    """Over forty samples: the shape asked for, no weight where unknown, blue never called ground in fair weather."""
    augment, skies = script("tools/sky/augment.py"), script("tools/sky/skies.py")
    generator = np.random.default_rng(3)
    patches = [skies.sky_patch(p) for p in pictures]
    assert all(patch.shape[0] >= 40 and patch.shape[1] == 200 for patch in patches)
    chances = np.full(3, 1 / 3)
    skies_seen = []
    for index in range(40):
        shape = augment.SHAPES[index % len(augment.SHAPES)]
        pixels, sky, weight = augment.sample(generator, pictures, chances, patches, shape)
        assert pixels.shape == (*shape, 3)
        assert pixels.dtype == np.uint8
        assert sky.shape == weight.shape == shape
        assert np.isfinite(weight).all()
        assert weight.max() <= 1 + augment.BOUNDARY_WEIGHT
        skies_seen.append(sky[weight > 0].mean())
    assert 0.15 < np.mean(skies_seen) < 0.7


def test_cloud_before_the_ridge_becomes_sky_and_its_rim_is_ignored():
    skies = script("tools/sky/skies.py")
    label = np.full((60, 50), GROUND, np.uint8)
    label[:20] = SKY
    opacity = np.zeros((60, 50), np.float32)
    opacity[:26] = 1.0
    opacity[26:30] = 0.5
    opacity[45:50] = 1.0  # a cloud of its own, wholly before terrain
    found = skies._behind_cloud(label, opacity)
    assert (found[:26] == SKY).all()
    assert (found[26:30] == IGNORE).all()
    assert (found[30:45] == GROUND).all()
    assert (found[45:50] == IGNORE).all()


def test_flags_change_the_picture_and_figures_the_label(pictures):
    clutter = script("tools/sky/clutter.py")
    generator = np.random.default_rng(4)
    image, label = pictures[0].pixels.astype(np.float32), pictures[0].label
    assert (clutter.add_flags(generator, image) != image).any()
    changed, figures = clutter.add_figures(generator, image, label)
    drawn = figures != label
    assert drawn.any()
    assert (figures[drawn] == GROUND).all()
    assert (changed[figures == SKY] == image[figures == SKY]).mean() > 0.9


def test_the_benchmark_finds_a_drawn_edge(tmp_path):
    """A mask of mountain only, as in `skyline-masks`: ground below it, columns without mountain ignored."""
    bench = script("benchmarks/bench_sky.py")
    mountain = np.zeros((100, 5), bool)
    mountain[40:60, :4] = True
    label = bench._filled(mountain)
    assert (label[40:, :4] == GROUND).all()
    assert (label[:40, :4] == SKY).all()
    assert (label[:, 4] == IGNORE).all()
    np.testing.assert_array_equal(bench.true_edge(label), [40, 40, 40, 40, np.nan])
    odds = np.where(np.arange(25)[:, None] < 10, 5.0, -5.0) * np.ones((1, 6))
    np.testing.assert_array_equal(bench.network_edge(odds.astype(np.float32), 100, 5), 40)


def test_probability_is_certain_at_the_extremes():
    odds = np.array([[1000.0, -1000.0], [0.0, 0.0]], np.float32)
    np.testing.assert_allclose(
        script("benchmarks/bench_sky.py").ground_probability(odds, 2, 2), [[0, 1], [0.5, 0.5]], atol=1e-6
    )
