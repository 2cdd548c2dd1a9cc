"""Fit the skyline weights: a conditional logit on simulated photographs and hand-made masks.

    python tools/fit_skyline.py MASKS [--scenes 88] [--variants 4]

MASKS contains `images` and `masks` (white is mountain). Simulated photographs come from `benchmarks/simulated_cases.py`
and are kept in `build/skyline_teacher`. Each picture is used as it is and in a few variants (cropped so that the ridge
leaves the frame, other aspect, exposure, haze, colour cast, grey, grain, JPEG), so that the weights do not learn the
look of one camera. The colour features are those of three rounds along the edges (`learn_sky`). The extraction learns
the colours once more from its own first result; the masks show that the same weights suit it then. The fit maximises,
per column, the log of

    0.95 x (probability within a Gaussian of 1.2 rows around the true row) + 0.05 / rows

with a ridge penalty on standardised weights. The tool writes `core/skyline/weights.json`, fitted to everything, and
`benchmarks/skyline_folds.json`: five more fits, each without a fifth of the masked pictures, which `bench_skyline.py`
uses to score that fifth.
"""

from __future__ import annotations

import argparse
import io
import json
import sys
import time
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.optimize import minimize
from skyline_viewshed.core.base import imaging
from skyline_viewshed.core.skyline.appearance import measure
from skyline_viewshed.core.skyline.colour import learn_sky
from skyline_viewshed.core.skyline.features import boundary_features

ROOT = Path(__file__).resolve().parent.parent
WORK_PX = 512
FOLDS = 5
COLUMN_STEP = 16
SIGMA_ROWS, TRUSTED, RIDGE = 1.2, 0.95, 0.02
SCENE_SEED = 90_210
SHAPES = ((384, 512), (341, 512), (512, 384), (384, 512), (288, 512))


def masked_pictures(folder):
    """Yield name, pixels and the first mountain row per column (NaN if none)."""
    for path in sorted((Path(folder) / "images").iterdir()):
        pixels = np.asarray(Image.open(path).convert("RGB"))
        mask = np.asarray(Image.open(Path(folder) / "masks" / path.name).convert("L")) > 127
        row = np.where(mask.any(0), mask.argmax(0), np.nan)
        # Specks at the lower edge of a mask are not a skyline.
        yield path.name, pixels, np.where(row < 0.97 * len(mask), row, np.nan)


def simulated_pictures(count, folder):
    """Yield name, pixels and the first terrain row per column where it is visible; rendered once, then kept."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    from simulated_cases import dem_paths, draw_case, terrain_of
    from skyline_viewshed.core.simulate.render import render_view

    folder.mkdir(parents=True, exist_ok=True)
    paths = dem_paths(folder / "dems")
    for index in range(count):
        kept = folder / f"scene_{index:04d}.npz"
        if not kept.exists():
            try:
                case = draw_case(SCENE_SEED, index, "full", paths, 768)
                terrain = terrain_of(case.dem_path, case.factor, case.detail_seed, case.roughness)
                view = render_view(terrain, case.observer, case.camera, case.pose, case.scene)
            except (RuntimeError, ValueError) as error:
                print(f"scene {index}: {error}", flush=True)
                continue
            row = np.where(view.skyline_visible, np.floor(view.skyline_row_px) + 1, np.nan)
            np.savez_compressed(kept, pixels=view.pixels, row=row)
        with np.load(kept) as data:
            yield kept.stem, data["pixels"], data["row"]


def resample(pixels, row, height, width):
    """Shrink a picture and its truth; return the float32 picture and the row per column."""
    shape = min(height, pixels.shape[0]), min(width, pixels.shape[1])
    small = imaging.shrink(pixels, shape[1], shape[0])
    known = np.isfinite(row)
    centre = (np.arange(shape[1]) + 0.5) * len(row) / shape[1] - 0.5
    rows = np.interp(centre, np.flatnonzero(known), row[known]) * shape[0] / pixels.shape[0]
    trusted = np.interp(centre, np.arange(len(row)), known.astype(float)) > 0.99
    rows = np.where(rows < 0.5, 0, rows)
    return small, np.where(trusted & (rows < 0.98 * shape[0]), rows, np.nan)


def whole(pixels, row):
    """Return the picture unchanged, at working size."""
    factor = min(1.0, WORK_PX / max(pixels.shape[:2]))
    return resample(pixels, row, round(pixels.shape[0] * factor), round(pixels.shape[1] * factor))


def variant(pixels, row, generator):
    """Crop, squeeze, flip and degrade a picture at random."""
    height, width = pixels.shape[:2]
    crop_w, crop_h = int(width / generator.uniform(1, 1.8)), int(height / generator.uniform(1, 1.8))
    left = generator.integers(0, width - crop_w + 1)
    if generator.random() < 0.4:  # so that part of the ridge leaves the frame
        top = int(np.nanquantile(row, generator.uniform(0, 0.6)) + generator.uniform(-20, 15))
    else:
        top = generator.integers(0, max(int(np.nanmin(row)) - 20, 0) + 1)
    top = int(np.clip(top, 0, height - crop_h))
    shape = SHAPES[generator.integers(0, len(SHAPES))]
    crop = np.ascontiguousarray(pixels[top : top + crop_h, left : left + crop_w])
    rows = row[left : left + crop_w] - top
    if np.isfinite(rows).sum() < 40:
        return None
    small, rows = resample(crop, rows, *shape)
    if generator.random() < 0.5:
        small, rows = small[:, ::-1], rows[::-1]
    return _spoil(small / 255, generator), rows


def _spoil(rgb, generator):
    """Change exposure, contrast, white balance and saturation; add haze, grain and compression."""
    rgb = np.maximum(rgb, 0) ** np.exp(generator.normal(0, 0.25)) * np.exp(generator.normal(0, 0.15))
    rgb = rgb * np.exp(generator.normal(0, 0.04, 3))
    grey = rgb.mean(2, keepdims=True)
    colourless = generator.random() < 0.1
    rgb = grey + (rgb - grey) * (0 if colourless else np.exp(generator.normal(0, 0.3)))
    if colourless and generator.random() < 0.5:
        rgb = rgb * (1.05, 0.95, 0.75)  # sepia
    if generator.random() < 0.4:
        haze = generator.uniform(0, 0.5)
        rgb = rgb * (1 - haze) + haze * generator.uniform(0.5, 0.95)
    grain = generator.choice([0, 0, 0.01, 0.025])
    if grain:
        noise = imaging.gaussian_blur(generator.normal(0, 1, rgb.shape), generator.choice([0.0, 0.7]))
        rgb = rgb + grain * noise / noise.std()
    bytes_ = (np.clip(rgb, 0, 1) * 255).astype(np.uint8)
    if generator.random() < 0.4:
        buffer = io.BytesIO()
        Image.fromarray(bytes_).save(buffer, "JPEG", quality=int(generator.integers(40, 95)))
        bytes_ = np.asarray(Image.open(buffer))
    return bytes_.astype(np.float32)


def training_columns(small, rows, offset):
    """Features (n, H, F) of every 16th column whose truth is known, their rows, and the names of the features."""
    appearance = measure(small)
    features = boundary_features(appearance, learn_sky(appearance))
    columns = np.arange(offset % COLUMN_STEP, small.shape[1], COLUMN_STEP)
    columns = columns[np.isfinite(rows[columns])]
    stack = np.stack([values[:, columns].T for values in features.values()], -1)
    return np.ascontiguousarray(stack, np.float32), rows[columns], list(features)


def gather(pictures, variants, seed):
    """List of (name, features, rows) over all pictures and their variants."""
    out, names = [], None
    for index, (name, pixels, row) in enumerate(pictures):
        if np.isfinite(row).sum() < 60:
            continue
        for turn in range(variants + 1):
            generator = np.random.Generator(np.random.PCG64([seed, index, turn]))
            made = whole(pixels, row) if turn == 0 else variant(pixels, row, generator)
            if made is None or min(made[0].shape[:2]) < 100:
                continue
            features, rows, names = training_columns(*made, 5 + 7 * turn)
            if len(rows) >= 3:
                out.append((name, features, rows))
    return out, names


def column_loss(score, rows):
    """Negative log-likelihood per column and its gradient by score, both (n, H) -> (n,), (n, H)."""
    score = score - score.max(1, keepdims=True)
    probability = np.exp(score)
    probability /= probability.sum(1, keepdims=True)
    height = score.shape[1]
    bell = np.exp(-0.5 * ((np.arange(height) - rows[:, None]) / SIGMA_ROWS) ** 2)
    near = (probability * bell).sum(1)
    value = TRUSTED * near + (1 - TRUSTED) / height
    gradient = -(TRUSTED / value)[:, None] * probability * (bell - near[:, None])
    return -np.log(value), gradient


def fit(pictures, start=None, iterations=80):
    """Fit the weights (F,) by L-BFGS; every picture counts the same."""
    count = pictures[0][1].shape[2]
    variance = np.mean([features.reshape(-1, count).var(0) for _, features, _ in pictures], 0)
    scale = np.sqrt(variance) + 1e-6

    def loss(standard):
        weights = (standard / scale).astype(np.float32)
        total, gradient = 0.0, np.zeros(count)
        for _, features, rows in pictures:
            value, slope = column_loss((features @ weights).astype(float), rows)
            share = 1 / (len(rows) * len(pictures))
            total += share * value.sum()
            gradient += share * np.tensordot(slope.astype(np.float32), features, ((0, 1), (0, 1))) / scale
        return total + RIDGE / 2 * standard @ standard, gradient + RIDGE * standard

    first = np.zeros(count) if start is None else start * scale
    result = minimize(loss, first, jac=True, method="L-BFGS-B", options={"maxiter": iterations})
    return result.x / scale, float(result.fun)


def table(names, weights):
    return {name: float(f"{weight:.4g}") for name, weight in zip(names, weights)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("masks")
    parser.add_argument("--scenes", type=int, default=88)
    parser.add_argument("--variants", type=int, default=4)
    parser.add_argument("--out", default=str(ROOT))
    options = parser.parse_args()
    start = time.time()
    teacher = simulated_pictures(options.scenes, ROOT / "build" / "skyline_teacher")
    scenes, names = gather(teacher, max(options.variants // 4, 0), 2)
    masks, names = gather(masked_pictures(options.masks), options.variants, 1)
    print(f"{len(masks)} masked and {len(scenes)} simulated pictures in {time.time() - start:.0f} s", flush=True)
    weights, value = fit(masks + scenes)
    print(f"all: loss {value:.4f} after {time.time() - start:.0f} s", flush=True)
    origin = (
        f"Conditional logit, tools/fit_skyline.py: {len(scenes)} simulated pictures (core/simulate/render.py over real "
        f"and procedural DEMs) and {len(masks)} variants of 30 photographs with hand-corrected masks "
        "(staunton-golding/MountainMappingProject, photographs from Unsplash; not part of this package)."
    )
    path = Path(options.out) / "core" / "skyline" / "weights.json"
    path.write_text(json.dumps({"origin": origin, "loss": round(value, 4), "weights": table(names, weights)}, indent=1))
    order = sorted({name for name, _, _ in masks})
    folds = []
    for fold in range(FOLDS):
        held_out = order[fold::FOLDS]
        part, value = fit([p for p in masks if p[0] not in held_out] + scenes, None, 80)
        folds.append({"held_out": held_out, "weights": table(names, part)})
        print(f"without fold {fold}: loss {value:.4f} after {time.time() - start:.0f} s", flush=True)
    path = Path(options.out) / "benchmarks" / "skyline_folds.json"
    path.write_text(json.dumps({"origin": origin, "folds": folds}, indent=1))


if __name__ == "__main__":
    main()
