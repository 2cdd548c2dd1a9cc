"""Compare skylines with hand-made masks: median vertical error per photograph, ours and the paper's.

    make bench-skyline DATA=folder        folder/images, folder/masks (white is mountain)

Only columns whose mask has an upper edge count. Trees and cars against the sky are black in such masks, so the
median of an image's columns is reported, not the mean. Pictures that the weights were fitted to
(`benchmarks/skyline_folds.json`) are scored with a fit that excluded them. The benchmark writes build/skyline.json.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np
from PIL import Image
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.paper.skyline import extract_skyline_paper
from skyline_viewshed.core.skyline.evidence import SkylineOptions, skyline_evidence

ROOT = Path(__file__).resolve().parent.parent
METHODS = ("robust", "paper")


def mask_rows(path):
    """First mountain row per column, NaN if the mask has none, and the mask's height [pixels]."""
    mask = np.asarray(Image.open(path).convert("L")) > 127
    row = np.where(mask.any(0), mask.argmax(0), np.nan)
    # Specks at the lower edge of a mask are not a skyline.
    return np.where(row < 0.97 * len(mask), row, np.nan), len(mask)


def skyline_rows(pixels, method, weights, width, height):
    """First terrain row in each of `width` columns of a picture `height` rows high, and the CPU time [s]."""
    start = time.process_time()
    try:
        if method == "paper":
            found = extract_skyline_paper(pixels)
        else:
            found = skyline_evidence(pixels, SkylineOptions(weights=weights)).best
    except SkylineNotFoundError:
        return np.full(width, np.nan), time.process_time() - start
    spent = time.process_time() - start
    columns = (np.arange(width) + 0.5) * found.width_px / width - 0.5
    # Rows of first terrain pixels are edges, which scale without the half-pixel offset of pixel centres.
    return np.interp(columns, np.arange(found.width_px), found.row_px) * height / found.height_px, spent


def held_out_weights():
    """Map the name of each picture to the weights of the fit that excluded it."""
    path = ROOT / "benchmarks" / "skyline_folds.json"
    folds = json.loads(path.read_text(encoding="utf-8"))["folds"] if path.exists() else []
    return {name: fold["weights"] for fold in folds for name in fold["held_out"]}


def measure(image, mask, weights):
    """Measure the errors of both methods on one picture."""
    truth, height = mask_rows(mask)
    pixels = np.asarray(Image.open(image).convert("RGB"))
    result = {"image": image.name, "height_px": height, "cross_validated": weights is not None}
    for method in METHODS:
        found, spent = skyline_rows(pixels, method, weights, len(truth), height)
        known = np.isfinite(truth)
        error = np.where(np.isfinite(found), np.abs(found - truth), height)[known]
        result[method] = {
            "median_px": float(np.median(error)),
            "median_percent": float(np.median(error)) / height * 100,
            "columns_below_1_percent": float((error < 0.01 * height).mean()),
            "columns_below_3_percent": float((error < 0.03 * height).mean()),
            "seconds": spent,
        }
    return result


def summary(results, method):
    """Compute the figures of one method over all pictures."""
    pick = {key: np.array([r[method][key] for r in results]) for key in results[0][method]}
    return {
        "images": len(results),
        "median_of_medians_px": float(np.median(pick["median_px"])),
        "mean_of_medians_px": float(pick["median_px"].mean()),
        "worst_median_px": float(pick["median_px"].max()),
        "images_below_1_percent": float((pick["median_percent"] < 1).mean()),
        "columns_below_1_percent": float(pick["columns_below_1_percent"].mean()),
        "columns_below_3_percent": float(pick["columns_below_3_percent"].mean()),
        "mean_seconds": float(pick["seconds"].mean()),
    }


def line_of(method, figures):
    """Format the figures of one method as a sentence."""
    return (
        f"{method:7}median of medians {figures['median_of_medians_px']:.1f} px, mean "
        f"{figures['mean_of_medians_px']:.1f}, worst {figures['worst_median_px']:.1f}; images below 1 % of the height "
        f"{figures['images_below_1_percent']:.0%}; columns below 1 % {figures['columns_below_1_percent']:.0%}, 3 % "
        f"{figures['columns_below_3_percent']:.0%}; {figures['mean_seconds']:.2f} s CPU each"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, help="folder with images and masks")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "skyline.json")
    options = parser.parse_args()
    weights = held_out_weights()
    masks = {path.stem: path for path in (options.data / "masks").iterdir()}
    images = [path for path in sorted((options.data / "images").iterdir()) if path.stem in masks]
    if not images:
        raise SystemExit(f"{options.data} has no images with masks of the same name")
    print(f"{'image':24}{'robust px':>10}{'%':>7}{'paper px':>10}{'%':>7}")
    results = []
    for image in images:
        result = measure(image, masks[image.stem], weights.get(image.name))
        results.append(result)
        robust, paper = result["robust"], result["paper"]
        print(
            f"{image.name[:23]:24}{robust['median_px']:10.1f}{robust['median_percent']:7.2f}"
            f"{paper['median_px']:10.1f}{paper['median_percent']:7.2f}"
            + ("" if result["cross_validated"] else "   shipped weights"),
            flush=True,
        )
    summaries = {method: summary(results, method) for method in METHODS}
    for method, figures in summaries.items():
        print(line_of(method, figures))
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(json.dumps({"summary": summaries, "images": results}, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
