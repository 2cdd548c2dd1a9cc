"""Evidence on drawn scenes with known skyline, on bad pictures, without OpenCV, and on real photographs."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base import imaging
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.skyline.evidence import SkylineOptions, shipped_weights, skyline_evidence


def ridge_rows(width, height, mean=0.4, swing=0.12):
    x = np.arange(width) / width
    return height * (mean + swing * np.sin(7 * x) + 0.3 * swing * np.sin(31 * x + 1))


def graded_sky(width, height, top):
    """A sky that pales downwards, (H, W, 3)."""
    down = np.arange(height)[:, None, None] / height
    return np.broadcast_to(np.array(top) + 60 * down * np.array([1.0, 0.8, 0.2]), (height, width, 3)).copy()


def rock_texture(rng, width, height):
    """Grain of several scales, about 0."""
    return sum(imaging.gaussian_blur(rng.normal(size=(height, width)), s) * s for s in (0.7, 2.0, 5.0))


def mountain_scene(width=512, height=384, seed=0, row_px=None, haze=0.0, grain=3.0):
    """Graded sky, a far and a near range with rock texture of several scales, grain; uint8 RGB and the rows."""
    rng = np.random.default_rng(seed)
    row_px = ridge_rows(width, height) if row_px is None else row_px
    y = np.arange(height)[:, None]
    picture = graded_sky(width, height, (110, 150, 215))
    rock = 26 * rock_texture(rng, width, height)
    light = np.clip(95 + 1.6 * rock, 10, 235)[..., None] * np.array([1.0, 0.97, 0.92])
    far = light * (1 - haze) + haze * np.array([165.0, 185, 220])
    near = 0.55 * light * np.array([0.8, 1.0, 0.6])
    terrain = y >= row_px
    picture[terrain] = far[terrain]
    foot = y > row_px + 0.3 * height
    picture[foot] = near[foot]
    return np.clip(picture + rng.normal(0, grain, picture.shape), 0, 255).astype(np.uint8), np.ceil(row_px)


def plain_before_a_range(edge_px=230, height=384, width=512):
    """A pale range under a blue sky behind the straight edge of a dark plain; uint8 RGB and the range's rows."""
    rng = np.random.default_rng(4)
    row_px = ridge_rows(width, height, 0.5, 0.06)
    y = np.arange(height)[:, None]
    picture = graded_sky(width, height, (120, 160, 215))
    picture[(y >= row_px) & (y < edge_px)] += 35 * np.array([1.0, 0.9, 0.6])
    rock = 20 * rock_texture(rng, width, height)
    picture[edge_px:] = (np.clip(45 + rock, 5, 120)[..., None] * np.array([0.8, 1.0, 0.6]))[edge_px:]
    return np.clip(picture + rng.normal(0, 2, picture.shape), 0, 255).astype(np.uint8), np.ceil(row_px)


@pytest.fixture(scope="module")
def clear():
    """An ordinary scene, its rows and its evidence, made once."""
    pixels, truth = mountain_scene()
    return pixels, truth, skyline_evidence(pixels)


def rows_off(evidence, truth):
    """Absolute error of the best line at believed columns [rows of the reduced picture]."""
    height, width = evidence.probability.shape
    columns = (np.arange(width) + 0.5) * len(truth) / width - 0.5
    scale = height / evidence.height_px
    return np.abs(evidence.best.row_px - np.interp(columns, np.arange(len(truth)), truth) * scale)


def test_a_pale_range_behind_a_dark_plain_is_kept_as_the_rival():
    """Without the network, which sees the range at once."""
    pixels, truth = plain_before_a_range()
    evidence = skyline_evidence(pixels, SkylineOptions(use_network=False))
    assert np.median(np.abs(evidence.best.row_px - 230)) < 2, "the plain stands out; if not, this scene is no test"
    assert np.median(np.abs(evidence.rival.best.row_px - truth)) < 2
    assert evidence.rival.rival is None
    total = evidence.rival.probability.sum(axis=0) + evidence.rival.leaves_frame
    np.testing.assert_allclose(total, 1, atol=1e-3)


def test_an_empty_sky_holds_no_rival(clear):
    assert clear[2].rival is None


@pytest.mark.parametrize(
    ("size", "haze"), [((512, 384), 0.5), ((384, 512), 0.0), ((1200, 800), 0.5), ((300, 200), 0.0)]
)
def test_a_drawn_ridge_is_found_to_a_row(size, haze):
    """Landscape, portrait, larger and smaller than the working size, clear and hazy."""
    pixels, truth = mountain_scene(*size, haze=haze)
    evidence = skyline_evidence(pixels)
    off = rows_off(evidence, truth)
    assert np.median(off) <= 1
    assert np.mean(off < 4) > 0.9
    assert evidence.best.valid.mean() > 0.9
    assert (evidence.width_px, evidence.height_px) == size


def test_every_column_is_a_distribution(clear):
    """Sums to one, none negative, float32."""
    probability = clear[2].probability
    assert probability.dtype == np.float32
    assert probability.min() >= 0
    np.testing.assert_allclose(probability.sum(0), 1, atol=1e-4)


def test_a_reduced_copy_keeps_the_full_size(clear):
    """Only the sizes differ from the evidence of the copy itself."""
    pixels, _, own = clear
    evidence = skyline_evidence(pixels, width_px=4096, height_px=3072)
    assert (evidence.width_px, evidence.height_px) == (4096, 3072)
    np.testing.assert_array_equal(evidence.probability, own.probability)


def test_the_mirrored_picture_has_the_mirrored_skyline(clear):
    """Nothing prefers left or right."""
    pixels, _, evidence = clear
    straight = evidence.best.row_px
    mirrored = skyline_evidence(np.ascontiguousarray(pixels[:, ::-1])).best.row_px[::-1]
    assert np.mean(np.abs(straight - mirrored) <= 1) > 0.95


def test_a_grey_picture_still_has_a_skyline(clear):
    """Photochroms and black-and-white scans carry no colour."""
    pixels, truth, _ = clear
    grey = np.repeat(imaging.to_grey(pixels)[..., None], 3, 2)
    assert np.median(rows_off(skyline_evidence(grey), truth)) <= 1


def test_a_ridge_that_leaves_the_frame_is_told_apart():
    """Where the mountain is cut by the upper edge the column names no row, is masked, and says that it is cut."""
    row_px = ridge_rows(512, 384, 0.1, 0.25)
    pixels, _ = mountain_scene(row_px=row_px)
    evidence = skyline_evidence(pixels)
    cut, seen = row_px < -8, row_px > 12
    assert cut.sum() > 50
    assert np.mean(evidence.probability.max(0)[cut] < 0.1) > 0.7
    assert np.mean(evidence.best.confidence[cut] == 0) > 0.7
    assert np.mean(evidence.leaves_frame[cut] > 0.5) > 0.7
    assert np.mean(evidence.leaves_frame[seen] < 0.1) > 0.9
    assert np.mean(evidence.best.confidence[seen] > 0.3) > 0.8


def test_a_frame_is_cut_off_and_flat(clear):
    """White border: the skyline inside is found, the columns of the border are flat."""
    pixels, truth, _ = clear
    framed = np.pad(pixels, ((20, 30), (25, 25), (0, 0)), constant_values=250)
    evidence = skyline_evidence(framed)
    height, width = evidence.probability.shape
    scale = width / framed.shape[1]
    top, bottom, left, right = evidence.crop
    assert np.abs(np.subtract(evidence.crop, np.array([20, 30, 25, 25]) * scale)).max() <= 1.5
    np.testing.assert_allclose(evidence.probability[:, :left], 1 / height, rtol=1e-5)
    assert not evidence.best.valid[:left].any()
    assert not evidence.best.valid[width - right :].any()
    inner = np.interp(np.arange(left, width - right) / scale - 25, np.arange(512), truth) * scale + 20 * scale
    assert np.median(np.abs(evidence.best.row_px[left : width - right] - inner)) <= 1.5


def test_sky_and_ridge_scores_lie_on_their_sides(clear):
    """Sky-like above and ground-like below the line; interior ridges only below it."""
    _, truth, evidence = clear
    y = np.arange(384)[:, None]
    assert np.mean(evidence.sky_score[y < truth - 3] > 0) > 0.9
    assert np.mean(evidence.sky_score[y > truth + 3] < 0) > 0.9
    assert evidence.ridge_score[y < truth - 12].max() < 0.05
    assert evidence.ridge_score[y > truth + 12].max() > 0.3


BAD = {
    "black": np.zeros((300, 400, 3), np.uint8),
    "white": np.full((300, 400, 3), 255, np.uint8),
    "grey": np.full((300, 400, 3), 128, np.uint8),
    "one pixel": np.zeros((1, 1, 3), np.uint8),
    "one row": np.zeros((1, 4000, 3), np.uint8),
    "one column": np.zeros((4000, 1, 3), np.uint8),
    "ribbon": np.random.default_rng(0).integers(0, 256, (20, 4000, 3), dtype=np.uint8),
}


@pytest.mark.parametrize("name", BAD)
def test_pictures_without_content_are_refused_in_a_sentence(name):
    """One colour, or too small."""
    with pytest.raises(SkylineNotFoundError, match="Use a photo that shows a mountain skyline"):
        skyline_evidence(BAD[name])


def degenerate():
    rng = np.random.default_rng(1)
    y, x = np.mgrid[:240, :320]
    return {
        "pure noise": rng.integers(0, 256, (240, 320, 3)),
        "two colours": np.where((y < 120)[..., None], 255, 0) * np.ones(3),
        "two colours, side by side": np.where((x < 100)[..., None], 255, 0) * np.ones(3),
        "gradient down": (y * 255 / 240)[..., None] * np.ones(3),
        "gradient across": (x * 255 / 320)[..., None] * np.ones(3),
        "chessboard": (((y // 16 + x // 16) % 2) * 255)[..., None] * np.ones(3),
        "one bright pixel": ((y == 100) & (x == 100))[..., None] * 255 * np.ones(3),
        "one odd pixel on grey": 128 + ((y == 3) & (x == 5))[..., None] * 4 * np.ones(3),
        "smallest": rng.integers(0, 256, (24, 24, 3)),
    }


@pytest.mark.parametrize("name", degenerate())
def test_degenerate_pictures_give_finite_probabilities(name):
    """No crash, no NaN, proper distributions."""
    evidence = skyline_evidence(degenerate()[name].astype(np.uint8))
    assert np.isfinite(evidence.probability).all()
    np.testing.assert_allclose(evidence.probability.sum(0) + evidence.leaves_frame, 1, atol=1e-3)
    assert np.isfinite(evidence.best.row_px).all()
    assert np.isfinite(evidence.sky_score).all()
    assert np.isfinite(evidence.ridge_score).all()


def test_the_map_of_sky_follows_the_ridge_and_leaves_out_a_border(clear):
    """The framed picture has 20 white pixels on each side; without the network there is no map."""
    picture, rows, evidence = clear
    framed = np.pad(picture, ((20, 20), (20, 20), (0, 0)), constant_values=255)
    sky = skyline_evidence(framed, SkylineOptions(work_px=10_000)).sky_map
    assert np.isnan(sky[:4]).all() and np.isnan(sky[:, -4:]).all()
    whole = evidence.sky_map
    y = (np.arange(len(whole)) + 0.5)[:, None] * len(picture) / len(whole)
    across = rows[(np.arange(whole.shape[1]) * picture.shape[1]) // whole.shape[1]]
    assert whole[y < across - 12].mean() > 0.9
    assert whole[y > across + 12].mean() < 0.1
    assert skyline_evidence(picture, SkylineOptions(use_network=False)).sky_map is None


def test_pure_noise_is_not_believed(clear):
    """Confidence stays far below that of a clear ridge."""
    noise = skyline_evidence(np.random.default_rng(2).integers(0, 256, (240, 320, 3)).astype(np.uint8))
    assert noise.best.confidence.mean() < 0.6 * clear[2].best.confidence.mean()


def test_without_the_sky_network_a_clear_ridge_is_still_found(clear):
    """The colours are learned along the edges then."""
    with_network, without = (skyline_evidence(clear[0], SkylineOptions(use_network=use)) for use in (True, False))
    assert np.mean(np.abs(with_network.best.row_px - without.best.row_px) <= 1) > 0.95


def test_without_opencv_the_evidence_is_the_same(monkeypatch):
    """The SciPy twins lead to the same line and nearly the same probabilities."""
    pixels, _ = mountain_scene(900, 600)
    fast = skyline_evidence(pixels)
    monkeypatch.setattr(imaging, "_cv2", lambda: None)
    plain = skyline_evidence(pixels)
    assert np.mean(np.abs(fast.best.row_px - plain.best.row_px) <= 1) > 0.98
    assert np.abs(fast.probability - plain.probability).sum(0).mean() < 0.05


def test_other_weights_take_the_place_of_the_shipped_ones(clear):
    """All weight on "high up": the line follows."""
    weights = {**dict.fromkeys(shipped_weights(), 0.0), "row": 60.0}
    evidence = skyline_evidence(clear[0], SkylineOptions(weights=weights))
    assert np.median(evidence.best.row_px) > 370


@pytest.mark.parametrize("wrong", [{"work_px": 10}, {"temper": 0}, {"jump_share": 1}, {"colour_passes": 0}])
def test_options_out_of_range_are_refused(wrong):
    """Programming errors."""
    with pytest.raises(ValueError):
        replace(SkylineOptions(), **wrong)


@pytest.mark.data
def test_the_scanned_photochrom_loses_its_border_and_keeps_its_ridge(shared_data):
    """Aletsch: white border and caption cut, ridge within the upper third, and no people."""
    from PIL import Image

    pixels = np.asarray(Image.open(shared_data / "aletsch" / "photos" / "07861v.jpg").convert("RGB"))
    evidence = skyline_evidence(pixels)
    height = evidence.probability.shape[0]
    assert all(8 <= side <= 25 for side in evidence.crop)
    inner = slice(evidence.crop[2] + 2, -evidence.crop[3] - 2)
    assert np.mean(evidence.best.valid[inner]) > 0.9
    assert (evidence.best.row_px[inner] < 0.3 * height).all()


@pytest.mark.data
@pytest.mark.parametrize("name", ["AK10_20090803_195410", "AK03b_20080621_201611"])
def test_the_hand_traced_skylines_of_columbia_are_met(shared_data, name):
    """Layer `horizon` of the owners' traces, which the weights have never seen."""
    from PIL import Image

    pixels = np.asarray(Image.open(shared_data / "columbia" / "photos" / f"{name}.JPG").convert("RGB"))
    evidence = skyline_evidence(pixels)
    height, width = evidence.probability.shape
    truth = traced_rows(shared_data / "columbia" / "traces" / f"{name}.svg", width)
    traced = np.isfinite(truth) & (truth > 4) & evidence.best.valid
    assert traced.sum() > 0.4 * width
    assert np.median(np.abs(evidence.best.row_px - truth)[traced]) < 0.01 * height


def traced_rows(path, width):
    """The trace's row per column of a picture `width` pixels wide, NaN between and beyond its strokes."""
    text = path.read_text()
    layer = text[text.index('<g id="horizon"') :]
    layer = layer[: layer.index("</g>")]
    scale = width / float(re.search(r'viewBox="0 0 ([\d.]+)', text).group(1))
    strokes = [np.array(numbers(line)).reshape(-1, 2) for line in re.findall(r'points="([^"]*)"', layer)]
    strokes += [path_points(line) for line in re.findall(r'\sd="([^"]*)"', layer)]
    rows = np.full(width, np.nan)
    for x, y in (stroke.T * scale for stroke in strokes):
        order = np.argsort(x, kind="stable")
        part = np.interp(np.arange(width) + 0.5, x[order], y[order], left=np.nan, right=np.nan)
        rows = np.where(np.isfinite(part), part, rows)
    return rows


def numbers(text):
    return [float(n) for n in re.findall(r"-?\d*\.?\d+", text)]


def path_points(line):
    """End points of an SVG path of straight pieces and cubic curves."""
    here, points = np.zeros(2), []
    for command, text in re.findall(r"([MmLlHhVvCcSs])([^MmLlHhVvCcSs]*)", line):
        size = {"H": 1, "V": 1, "C": 6, "S": 4}.get(command.upper(), 2)
        for values in np.array(numbers(text)).reshape(-1, size):
            start = here if command.islower() else np.zeros(2)
            if command in "Hh":
                here = np.array([start[0] + values[0], here[1]])
            elif command in "Vv":
                here = np.array([here[0], start[1] + values[0]])
            else:
                here = start + values[-2:]
            points.append(here)
    return np.array(points)
