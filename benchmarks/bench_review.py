"""How much of a reviewer's time the Photo view takes: an archive is reviewed with real key presses.

Usage: bench_review.py [--photos 500] [--look 0] [--data ../shared/data]

Real photographs (half of them HEIC of 12 megapixels) with their true poses are repeated under other names until there
are enough. The reviewer presses a key, waits until the next photograph is painted with the DEM's horizon on it, looks
for `--look` seconds, at least until the extracted skyline is painted too, and presses the next key. Everything runs in
real widgets, offscreen. The aim of 500 photographs an hour is 7.2 s for each. Writes build/review.json. Fails if a
verdict is wrong or a person has less than 5 s on average.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import sys
import tempfile
import time
from itertools import chain, zip_longest
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from bench_panel import ROOT, open_panel, resident_mb
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest

AN_HOUR_S = 3600.0
TARGET = 500
"""Photographs an hour."""

LOOK_S = 5.0
"""What a person needs to judge a photograph [s]."""

SETS = ("khumbu", "khumbu-trek")
"""Photographs of one valley, so that one DEM serves all."""

VERDICTS = {Qt.Key.Key_A: "accepted", Qt.Key.Key_R: "rejected", Qt.Key.Key_D: "doubtful"}
TICK_MS = 2


def archive(data, folder, count):
    """Link `count` photographs of known pose into a folder; return the DEM's path and the rows of their points."""
    from skyline_viewshed.core.io.vector import PointRow

    columns = []
    for name in SETS:
        with open(data / name / "truth.csv", encoding="utf-8") as file:
            good = [row for row in csv.DictReader(file) if row["group"] == "good"]
        columns.append([(data / name / "photos" / row["photo"], row) for row in good])
    longest = max(map(len, columns))
    columns = [[column[k % len(column)] for k in range(longest)] for column in columns]
    turns, rows = list(chain(*zip_longest(*columns))), []
    for number in range(count):
        path, row = turns[number % len(turns)]
        photo = folder / f"{number:04d}_{path.name}"
        photo.symlink_to(path.resolve())
        values = {"photo": str(photo), "status": "accepted"}
        values.update({key: float(row[f"{key}_deg"]) for key in ("heading", "pitch", "roll")})
        rows.append(PointRow((float(row["longitude_deg"]), float(row["latitude_deg"]), 0.0), values))
    return data / SETS[1] / "dem" / "dem.tif", rows


def seconds_until(known, canvas, start):
    """Seconds from `start` until something is known and the picture has been painted with it."""
    while not known():
        QTest.qWait(TICK_MS)
    canvas.repaint()
    return time.perf_counter() - start


def review(view, hand, look_s):
    """Press keys until every photograph has a verdict.

    Returns
    -------
    list of (shown_s, judged_s, complete_s, memory_mb)
        From the key until the next photograph is painted; with the DEM's horizon; with the extracted skyline too.
    """
    session, canvas = view.session, hand.canvas
    ids, keys, times = session.photos.ids(), list(VERDICTS), []
    hand.press("review")
    hand.settle()
    for number, (fid, following) in enumerate(zip(ids, ids[1:])):
        if session.item.fid != fid:
            raise AssertionError(f"photograph {fid} should be shown, not {session.item.fid}")
        start = time.perf_counter()
        hand.key(keys[number % len(keys)])
        known = (
            lambda following=following: session.item.fid == following and session.picture is not None,
            lambda: session.ground is not None and any(line.kind == "horizon" for line in canvas.lines),
            lambda: session.evidence is not None and any(line.kind == "skyline" for line in canvas.lines),
        )
        shown = seconds_until(known[0], canvas, start)
        judged = shown if known[1]() else seconds_until(known[1], canvas, start)
        complete = judged if known[2]() else seconds_until(known[2], canvas, start)
        times.append((shown, judged, complete, resident_mb()))
        looked_s = time.perf_counter() - start - judged
        QTest.qWait(round(1000 * max(look_s - looked_s, 0.0)))
    hand.key(keys[(len(ids) - 1) % len(keys)])
    return times


def verdict_faults(layer, ids):
    """Photographs whose verdict is not that of the key that was pressed."""
    texts = list(VERDICTS.values())
    return [fid for k, fid in enumerate(ids) if layer.getFeature(fid)["review"] != texts[k % len(texts)]]


def main():
    """Review, and print what the panel took."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--photos", type=int, default=TARGET)
    parser.add_argument("--look", type=float, default=0.0)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data")
    arguments = parser.parse_args()
    import numpy as np
    from qgis.core import QgsApplication

    application = QgsApplication([], True)
    application.initQgis()
    with tempfile.TemporaryDirectory() as name:
        dem, rows = archive(arguments.data, Path(name), arguments.photos)
        view, hand = open_panel(Path(name), dem, rows)
        start = time.perf_counter()
        shown, judged, complete, memory = np.array(review(view, hand, arguments.look)).T
        whole, layer, ids = time.perf_counter() - start, view.session.photos.layer, view.session.photos.ids()
        wrong = verdict_faults(layer, ids)
        layer.rollBack()
        room = AN_HOUR_S / TARGET - LOOK_S
        result = {"photographs": len(ids), "whole_s": whole}
        for label, times in (("shown", shown), ("judged", judged), ("complete", complete)):
            result.update({f"{label}_median_s": np.median(times), f"{label}_95_s": np.quantile(times, 0.95),
                           f"{label}_most_s": times.max()})  # fmt: skip
        tenth = max(len(judged) // 10, 1)
        result.update(
            judged_first_tenth_s=np.median(judged[:tenth]),
            judged_last_tenth_s=np.median(judged[-tenth:]),
            memory_first_tenth_mb=np.median(memory[:tenth]),
            memory_last_tenth_mb=np.median(memory[-tenth:]),
            memory_most_mb=memory.max(),
            share_within_room=np.mean(judged <= room),
            left_to_look_s=AN_HOUR_S / TARGET - judged.mean(),
            wrong_verdicts=len(wrong),
        )
        view.remove()
    for key, value in result.items():
        print(f"{key:24} {value:.2f}")
    (ROOT / "build").mkdir(exist_ok=True)
    (ROOT / "build" / "review.json").write_text(json.dumps(result, indent=1, default=float), encoding="utf-8")
    sys.stdout.flush()
    os._exit(0 if not wrong and result["left_to_look_s"] >= LOOK_S else 1)


if __name__ == "__main__":
    main()
