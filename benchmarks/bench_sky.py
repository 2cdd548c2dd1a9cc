"""The sky network on pictures that did not train it: its edge against the masks, and seconds per picture.

    make bench-sky DATA=folder

DATA is the folder of real data; scored are the 30 pictures of `skyline-masks` and the held-out pictures of `sky/mmp`
and `sky/uav` (`tools/sky/held_out.json`; of the drone all frames of one recording). The network's edge is, in each
column, the row that best parts sky above from ground below. Errors are medians over the columns of a picture, in
pixels of a picture 1024 high. Pixels count within 2 % of the height of the true edge, where they are hardest. Writes
build/sky.json, and with --overlays FOLDER a PNG of every picture; --pictures FOLDER draws those without masks.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw
from skyline_viewshed.core.base.imaging import shrink_to
from skyline_viewshed.core.skyline.network import load_layers, resized, sky_log_odds

ROOT = Path(__file__).resolve().parent.parent
HELD_OUT = ROOT / "tools" / "sky" / "held_out.json"
REFERENCE_PX = 1024
NEAR_SHARE = 0.02
ODDS_LIMIT = 6.0


def labelled(folder):
    """Yield set, picture's path, label (255 ground, 0 sky, 128 ignore) of everything that is scored."""
    names = json.loads(HELD_OUT.read_text(encoding="utf-8"))
    for source in ("mmp", "uav"):
        for name in names[source]:
            path = folder / "sky" / source / "images" / f"{name}.jpg"
            yield source, path, _grey(folder / "sky" / source / "labels" / f"{name}.png")
    masks = {path.stem: path for path in (folder / "skyline-masks" / "masks").iterdir()}
    for path in sorted((folder / "skyline-masks" / "images").iterdir()):
        yield "skyline-masks", path, _filled(_grey(masks[path.stem]) > 127)


def _filled(mountain):
    """Label from a mask of mountain only: ground from its upper edge down; columns without one are ignored."""
    height = len(mountain)
    row = np.where(mountain.any(0), mountain.argmax(0), height)
    label = np.where(np.arange(height)[:, None] >= row, 255, 0)
    label[:, row > 0.97 * height] = 128  # specks at a mask's lower edge are no skyline
    return label


def _grey(path):
    return np.asarray(Image.open(path).convert("L"))


def true_edge(label):
    """First ground row of each column; NaN where it has none, or where the rows above it are not all sky."""
    ground = label == 255
    row = np.where(ground.any(0), ground.argmax(0), len(label))
    clear = np.array([(label[:r, i] == 0).all() for i, r in enumerate(row)])
    return np.where(clear & (row < len(label)) & (row > 0), row, np.nan)


def network_edge(odds, height, width):
    """Row in each column that best parts sky above from ground below, first ground row (W,) of a picture's rows."""
    odds = np.clip(resized(odds, height, width), -ODDS_LIMIT, ODDS_LIMIT)
    gain = np.concatenate([np.zeros((1, width)), np.cumsum(odds, 0, dtype=float)])
    return gain.argmax(0)


def score(path, label):
    """Figures of one picture."""
    pixels = np.asarray(Image.open(path).convert("RGB"))
    start = time.process_time()
    odds = sky_log_odds(pixels)
    spent = time.process_time() - start
    height, width = label.shape
    truth = true_edge(label)
    error = np.abs(network_edge(odds, height, width) - truth)[np.isfinite(truth)] / height
    near = np.abs(np.arange(height)[:, None] + 0.5 - truth) < NEAR_SHARE * height
    right = (resized(odds, height, width) > 0) == (label == 0)
    return {
        "image": path.name,
        "median_px": float(np.median(error)) * REFERENCE_PX if len(error) else None,
        "columns_below_1_percent": float((error < 0.01).mean()) if len(error) else None,
        "pixels_right": float(right[label != 128].mean()),
        "pixels_right_near_edge": float(right[near].mean()) if near.any() else None,
        "seconds": spent,
    }


def summary(results):
    """Figures of one set."""
    pick = {key: np.array([r[key] for r in results if r[key] is not None]) for key in results[0] if key != "image"}
    return {
        "images": len(results),
        "mean_of_medians_px": float(pick["median_px"].mean()),
        "median_of_medians_px": float(np.median(pick["median_px"])),
        "worst_median_px": float(pick["median_px"].max()),
        "images_below_1_percent": float((pick["median_px"] < 0.01 * REFERENCE_PX).mean()),
        "columns_below_1_percent": float(pick["columns_below_1_percent"].mean()),
        "pixels_right": float(pick["pixels_right"].mean()),
        "pixels_right_near_edge": float(pick["pixels_right_near_edge"].mean()),
        "median_seconds": float(np.median(pick["seconds"])),
    }


def line_of(name, figures):
    """One set's figures in a sentence."""
    return (
        f"{name:14}{figures['images']:4} images: medians' mean {figures['mean_of_medians_px']:.1f} px, median "
        f"{figures['median_of_medians_px']:.1f}, worst {figures['worst_median_px']:.1f}; images below 1 % "
        f"{figures['images_below_1_percent']:.0%}, columns {figures['columns_below_1_percent']:.0%}; pixels right "
        f"{figures['pixels_right']:.1%}, near the edge {figures['pixels_right_near_edge']:.1%}; "
        f"{figures['median_seconds'] * 1000:.0f} ms CPU each"
    )


def ground_probability(log_odds, height_px, width_px):
    """Probability that each pixel of a picture of a given size is ground, float32 (H, W), from `sky_log_odds`."""
    return 1 / (1 + np.exp(np.clip(resized(log_odds, height_px, width_px), -30, 30)))


def overlay(path, out):
    """Draw what the network believes over a picture: red is ground, the line its edge."""
    pixels = shrink_to(np.asarray(Image.open(path).convert("RGB")), 640)
    odds = sky_log_odds(pixels)
    height, width = pixels.shape[:2]
    ground = ground_probability(odds, height, width)[..., None]
    tinted = pixels * (1 - 0.45 * ground) + np.array([255, 0, 0]) * 0.45 * ground
    picture = Image.fromarray(np.clip(tinted, 0, 255).astype(np.uint8))
    line = list(enumerate(network_edge(odds, height, width).tolist()))
    ImageDraw.Draw(picture).line(line, fill=(255, 255, 0), width=1)
    out.mkdir(parents=True, exist_ok=True)
    picture.save(out / f"{path.stem}.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder with skyline-masks and sky")
    parser.add_argument("--overlays", type=Path, help="draw every scored picture into this folder")
    parser.add_argument(
        "--pictures", type=Path, nargs="*", default=[], help="draw these too, or those in these folders"
    )
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "sky.json")
    options = parser.parse_args()
    load_layers()
    results = {}
    for source, path, label in labelled(options.data):
        results.setdefault(source, []).append(score(path, label))
        if options.overlays:
            overlay(path, options.overlays / source)
    summaries = {source: summary(found) for source, found in results.items()}
    for source, figures in summaries.items():
        print(line_of(source, figures))
    for given in options.pictures:
        for path in sorted(given.iterdir()) if given.is_dir() else [given]:
            overlay(path, (options.overlays or ROOT / "build" / "sky") / path.parent.parent.name)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(json.dumps({"summary": summaries, "images": results}, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
