"""Speed and memory of the Photo view: frames of the live horizon, opening a photograph, browsing many.

Usage: bench_panel.py [--photos 300] [--data ../shared/data]

The photographs are simulated and written as HEIC and JPEG of 12 megapixels, so that anybody can repeat the run; with
`--data`, a real HEIC of 12 megapixels is opened as well. Everything runs in real widgets, offscreen. Writes
build/panel.json.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "build" / "plugins"), str(ROOT / "tests")]

from qgis.PyQt.QtCore import QEvent, QEventLoop, QObject, Qt  # noqa: E402

SIDE_PX = (4032, 3024)
HEADINGS = 2
"""Different pictures that are written; the folder holds copies of them."""


class Desk:
    """A main window with a map canvas, as much of QGIS as the panel needs."""

    def __init__(self):
        from qgis.gui import QgsMapCanvas
        from qgis.PyQt.QtWidgets import QMainWindow

        self.window = QMainWindow()
        self.canvas = QgsMapCanvas(self.window)
        self.window.setCentralWidget(self.canvas)
        self.window.resize(1500, 900)
        self.window.show()

    def mainWindow(self):
        """Return the window."""
        return self.window

    def mapCanvas(self):
        """Return the map."""
        return self.canvas

    def activeLayer(self):
        """Return no layer: the first that fits is taken."""
        return

    def addDockWidget(self, area, dock):
        """Dock the panel."""
        self.window.addDockWidget(area, dock)

    def removeDockWidget(self, dock):
        """Undock the panel."""
        self.window.removeDockWidget(dock)


def resident_mb():
    """Memory of this process [MB]."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def make_photos(folder, count):
    """Write a DEM and photographs of 12 megapixels; return the DEM's path and the rows of their points."""
    import numpy as np
    from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
    from skyline_viewshed.core.base.model import PhotoMetadata
    from skyline_viewshed.core.base.terrain import Observer
    from skyline_viewshed.core.io.raster import open_dem
    from skyline_viewshed.core.io.vector import PointRow
    from skyline_viewshed.core.io.write_photo import write_photo
    from skyline_viewshed.core.simulate.render import render_view
    from skyline_viewshed.core.simulate.scene import SceneOptions
    from skyline_viewshed.demo.dem_file import write_dem
    from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

    mountains = make_mountains(5, MountainOptions(size=320, cell_m=75.0))
    path = folder / "dem.tif"
    write_dem(str(path), mountains.elevation_m, 75.0, 8.0, 46.5)
    dem = open_dem(str(path))
    place = tuple(map(float, dem.position_of(198, 122)))
    small = Camera(1008, 756, focal_from_35mm_px(1008, 756, 28.0))
    rows = []
    for number in range(HEADINGS):
        pose = Pose(number * 360.0 / HEADINGS, 2.0, 0.5)
        view = render_view(dem, Observer(*place, 2.0), small, pose, SceneOptions(number))
        pixels = np.kron(view.pixels, np.ones((4, 4, 1), np.uint8))
        suffix = ".heic" if number % 2 else ".jpg"
        first = folder / f"view{number}{suffix}"
        write_photo(str(first), pixels, PhotoMetadata("", *SIDE_PX, focal_length_35mm=28.0))
        for copy in range(number, count, HEADINGS):
            photo = folder / f"photo{copy:04d}{suffix}"
            photo.symlink_to(first)
            values = {"photo": str(photo), "heading": pose.heading_deg, "pitch": 2.0, "roll": 0.5,
                      "hfov": small.hfov_deg, "vfov": small.vfov_deg, "status": "accepted",
                      "heading_2": pose.heading_deg + 4.0, "heading_3": (pose.heading_deg - 5.0) % 360}  # fmt: skip
            aside = 0.01 * (copy % 100), 0.01 * (copy // 100)  # every photograph has its own eye and horizon
            position = tuple(map(float, dem.position_of(198 + aside[0], 122 + aside[1])))
            rows.append(PointRow((*position, 0.0), values))
    return path, rows


def open_panel(folder, dem, rows):
    """Open the panel on the points."""
    from panel_hand import Hand
    from qgis.core import QgsProject, QgsRasterLayer, QgsSettings, QgsVectorLayer
    from skyline_viewshed.core.io.vector import point_fields, write_points
    from skyline_viewshed.panel.controller import PhotoView

    QgsSettings().remove("skyline_viewshed")
    points = folder / "photos.gpkg"
    write_points(points, point_fields(), rows)
    layer, raster = QgsVectorLayer(str(points), "photos", "ogr"), QgsRasterLayer(str(dem), "dem")
    QgsProject.instance().addMapLayers([layer, raster])
    desk = Desk()
    desk.canvas.setDestinationCrs(raster.crs())
    desk.canvas.setExtent(raster.extent())
    view = PhotoView(desk)
    view.open()
    view.dock.setMinimumWidth(900)
    hand = Hand(view)
    hand.settle()
    return view, hand


class Paints(QObject):
    """Counts the paintings of a widget."""

    def __init__(self, widget):
        super().__init__(widget)
        self.count = 0
        widget.installEventFilter(self)

    def eventFilter(self, watched, event):
        """Count."""
        self.count += event.type() == QEvent.Type.Paint
        return False


def frames(view, hand, count=120):
    """Milliseconds of each frame of a drag, by the clock and of the processor: from the mouse to the painted picture.

    All of Qt's work counts, that on the labels and on the map too.
    """
    from qgis.PyQt.QtWidgets import QApplication

    for kind in ("horizon", "skyline", "crests", "alternatives"):
        view.dock.switches[kind].setChecked(True)
    hand.press("correct")
    hand.settle()
    paints, left = Paints(hand.canvas), Qt.MouseButton.LeftButton
    width, height = hand.canvas.size_px
    hand.send(QEvent.Type.MouseButtonPress, hand.at(width / 2, height / 2), left, left)
    taken, used = [], []
    for step in range(count):
        place = hand.at(width / 2 + 4 * step, height / 2 + step)
        before, start, worked = paints.count, time.perf_counter(), time.thread_time()
        hand.send(QEvent.Type.MouseMove, place, Qt.MouseButton.NoButton, left)
        while paints.count == before:
            QApplication.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
        taken.append(1000 * (time.perf_counter() - start))
        used.append(1000 * (time.thread_time() - worked))
    hand.send(QEvent.Type.MouseButtonRelease, place, left, Qt.MouseButton.NoButton)
    hand.press("undo")
    return sorted(taken), sorted(used)


def opening(view, fid):
    """Seconds until a photograph is shown, and the longest time for which Qt's loop did not turn [ms]."""
    from qgis.PyQt.QtWidgets import QApplication

    view.session.pictures.clear()
    start = last = time.perf_counter()
    worst = 0.0
    view.select(fid)
    while view.session.picture is None:
        QApplication.processEvents()
        now = time.perf_counter()
        worst, last = max(worst, now - last), now
        time.sleep(0.001)
    return time.perf_counter() - start, 1000 * worst


def browse(view, hand, count):
    """Show one photograph after the other; seconds per photograph, and memory before, on the way and after [MB]."""
    ids = view.session.photos.ids()
    before, start, memory = resident_mb(), time.perf_counter(), []
    for fid in ids[:count]:
        view.select(fid)
        hand.settle()
        memory.append(resident_mb())
    seconds = (time.perf_counter() - start) / count
    return seconds, before, memory[count // 6], memory[count // 2], memory[-1], view.session.pictures.size / 1e6


def real_opening(path):
    """Decode a real photograph; processor seconds, and memory of the picture [MB]."""
    from skyline_viewshed.panel.model.pictures import open_picture

    start = time.thread_time()
    picture = open_picture(str(path))
    return time.thread_time() - start, picture.size / 1e6


def main():
    """Run everything and print it."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--photos", type=int, default=300)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data")
    arguments = parser.parse_args()
    from qgis.core import QgsApplication

    application = QgsApplication([], True)
    application.initQgis()
    result = {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        dem, rows = make_photos(folder, arguments.photos)
        view, hand = open_panel(folder, dem, rows)
        for name, times in zip(("wall", "cpu"), frames(view, hand)):
            result[f"frame_{name}_median_ms"] = times[len(times) // 2]
            result[f"frame_{name}_95_ms"] = times[int(0.95 * len(times))]
        ids = view.session.photos.ids()
        suffixes = {fid: Path(path).suffix for fid, (path, _) in view.session.photos.files().items()}
        for suffix in (".heic", ".jpg"):
            fid = next(f for f in ids[2:] if suffixes[f] == suffix)
            result[f"open_{suffix[1:]}_s"], result[f"open_{suffix[1:]}_longest_stall_ms"] = opening(view, fid)
        result["browse_s"], *memory = browse(view, hand, arguments.photos)
        names = ("memory_before_mb", "memory_sixth_mb", "memory_half_mb", "memory_after_mb", "pictures_mb")
        result.update(zip(names, memory))
        real = next(iter(sorted(arguments.data.glob("khumbu/photos/*.HEIC"))), None)
        if real is not None:
            result["real_heic_cpu_s"], result["real_heic_mb"] = real_opening(real)
        view.remove()
    for key, value in result.items():
        print(f"{key:28} {value:.2f}")
    (ROOT / "build").mkdir(exist_ok=True)
    (ROOT / "build" / "panel.json").write_text(json.dumps(result, indent=1), encoding="utf-8")
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
