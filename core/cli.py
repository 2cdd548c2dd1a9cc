"""The command line: `skyline-viewshed orient PHOTOS DEM -o photos.gpkg`, for servers and scripts without QGIS.

All work is done through `core.api`, and for many photographs `core.cluster`.
"""

from __future__ import annotations

import argparse
import logging
import os
import signal
import sys
from collections import Counter, deque
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from . import api
from .base.errors import Cancelled, SkylineViewshedError
from .base.optional import require
from .base.status import RELIABLE
from .base.terminal import Bar, Quietly
from .cluster import RowsOfChunk, rows_with_files, spread_over
from .io.horizon_table import write_horizon
from .io.whole_file import check_folder, unused_name
from .many import OrientJob
from .pipeline import COMPASS_USES, METHODS
from .trusting import with_trust

PROGRAM = "skyline-viewshed"
ANSWERED, SOME_FAILED, WRONG_USAGE, INTERRUPTED = 0, 1, 2, 130
TO_OPTIONS = {
    "Give longitude_deg and latitude_deg.": "Give it by --position.",
    "hfov_deg": "--hfov",
    "eye_elevation_m": "--eye-elevation", "DEM_UNIT": "--dem-unit", "(COMPASS)": "(--compass prior)",
}  # fmt: skip
"""What messages call the arguments of functions, and what the options are called."""

EXAMPLES = """\
examples:
  skyline-viewshed orient photos/ dem.tif -o photos.gpkg
  skyline-viewshed orient photos/ dem.tif -o photos.gpkg --report report.html --viewsheds seen/
  skyline-viewshed orient a.jpg b.heic dem.tif -o photos.csv --compass prior --max-distance 60000
  skyline-viewshed horizon dem.tif 8.0 46.5 -o horizon.csv
  skyline-viewshed viewshed dem.tif 8.0 46.5 -o seen.tif --heading 120 --hfov 60

exit codes:
  0  every photo got an answer (accepted, ambiguous or rejected)
  1  some photos failed; the messages and the field "message" say why
  2  wrong arguments, an unusable DEM, or an output that cannot be written
  130  interrupted; no file is left half-written
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and give the exit code."""
    given = _parser().parse_args(arguments)
    bar = Bar(sys.stderr, given.quiet)
    before = signal.signal(signal.SIGINT, bar.interrupt)
    logger = logging.getLogger(__name__.split(".")[0])
    log: logging.Handler = logging.NullHandler()
    try:
        log = logging.FileHandler(given.log, encoding="utf-8") if given.log else log
        logger.addHandler(log)
        return given.run(given, bar)
    except (Cancelled, KeyboardInterrupt):
        bar.say(f"{PROGRAM}: interrupted", always=True)
        return INTERRUPTED
    except (SkylineViewshedError, ValueError, OSError) as error:
        bar.say(f"{PROGRAM}: {_in_options(str(error))}", always=True)
        return WRONG_USAGE
    finally:
        bar.clear()
        logger.removeHandler(log)
        log.close()
        signal.signal(signal.SIGINT, before)


class Run:
    """Orients the photographs one by one; on the way it collects their rows and writes their viewsheds."""

    def __init__(self, given: argparse.Namespace, bar: Bar) -> None:
        self.given, self.bar, self.dem = given, bar, _dem(given)
        self.paths, self.options = _photos(given.photos, given.recursive), _options(given)
        self.statuses: Counter[str] = Counter()
        self.rows: list[Any] = []
        self._stems: set[str] = set()

    def __length_hint__(self) -> int:
        return len(self.paths)

    def __iter__(self) -> Iterator[api.OrientedPhoto]:
        from .batch import PhotoRequest, doubt_of_heights
        from .io.vector import photo_row

        doubt = doubt_of_heights([PhotoRequest(os.fspath(path)) for path in self.paths], self.dem)
        if doubt:
            self.bar.say(f"{PROGRAM}: {_in_options(doubt)}", always=True)
        self.bar.label = f"of {len(self.paths)} photos"
        photos = api.orient_many(
            self.paths, self.dem, options=self.options, progress=self.bar, workers=self.given.workers,
            client=_client(self.given), joint=self.given.joint, **_facts(self.given),
        )  # fmt: skip
        for number, photo in enumerate(photos, start=1):
            self.statuses[photo.status] += 1
            self.rows.append(photo_row(photo, self.given.max_distance))
            name, failed = os.path.basename(photo.path), photo.status == "failed"
            heading = "" if photo.heading_deg is None else f", heading {photo.heading_deg:.1f}°"
            line = f"{number}/{len(self.paths)} {name}: {photo.status}{heading}"
            self.bar.say(f"{PROGRAM}: {name}: {_in_options(photo.message)}" if failed else line, always=failed)
            if self.given.viewsheds and photo.view is not None:
                if photo.status in RELIABLE or self.given.doubtful:
                    self._write_viewshed(photo)
                else:
                    self.bar.say(f"{number}/{len(self.paths)} no viewshed, as it is {photo.status}; see --doubtful")
            if self.bar.cancelled():
                raise Cancelled
            yield photo

    def _write_viewshed(self, photo: api.OrientedPhoto) -> None:
        stem = unused_name(Path(photo.path).stem, self._stems)
        options = api.ViewshedOptions(max_distance_m=self.given.viewshed_distance)
        try:
            seen = api.viewshed(self.dem, photo, options=options, progress=Quietly(self.bar))
            facts = {"PHOTO": photo.path, "HEADING": photo.heading_deg}
            api.save_viewshed(seen, self.dem, self.given.viewsheds / f"{stem}.tif", facts)
        except api.PhotoError as error:
            self.bar.say(f"{PROGRAM}: {os.path.basename(photo.path)}: {_in_options(str(error))}", always=True)


def orient(given: argparse.Namespace, bar: Bar) -> int:
    """Orient photographs and write points, report and viewsheds."""
    require("osgeo.ogr", "Writing points")
    from .io.vector import driver_of, point_fields, write_points

    driver_of(given.output)
    for path in filter(None, (given.output, given.report)):
        check_folder(path)
    if given.results:
        rows = _rows_of_chunks(given, bar)
        write_points(given.output, point_fields(), rows)
        return _summed_up(Counter(str(row.values["status"]) for row in rows), given, bar)
    run = Run(given, bar)
    if given.viewsheds:
        given.viewsheds.mkdir(parents=True, exist_ok=True)
    if given.report:
        facts = {"DEM": Path(given.dem).name, "Method": given.method, "Compass": given.compass}
        api.save_report(run, given.report, facts={**facts, "Search range (m)": f"{given.max_distance:g}"})
    else:
        deque(run, maxlen=0)
    write_points(given.output, point_fields(), run.rows)
    return _summed_up(run.statuses, given, bar)


def _summed_up(statuses: Counter[str], given: argparse.Namespace, bar: Bar) -> int:
    counts = ", ".join(f"{count} {status}" for status, count in sorted(statuses.items()))
    bar.say(f"{sum(statuses.values())} photos: {counts}. Written to {given.output}.")
    return SOME_FAILED if statuses["failed"] else ANSWERED


def _rows_of_chunks(given: argparse.Namespace, bar: Bar) -> list[Any]:
    """Orient so many photographs that only their points are kept, and go on where an earlier run ended."""
    if given.report or given.viewsheds or given.joint:
        raise ValueError("--results keeps the points only; leave out --report, --viewsheds and --joint, or --results")
    tasks = [(api.PhotoRequest(path, **_facts(given)), None) for path in _photos(given.photos, given.recursive)]
    client = _client(given)
    job, orient_all = OrientJob(_dem(given), _options(given)), spread_over(client, given.workers)
    job, _ = with_trust(job, tasks, orient_all, Quietly(bar), given.results)
    return list(rows_with_files(RowsOfChunk(job, given.max_distance), tasks, given.results, client, given.workers, bar))


def _client(given: argparse.Namespace) -> Any:
    return require("distributed", "Working on a Dask cluster").Client(given.scheduler) if given.scheduler else None


def _options(given: argparse.Namespace) -> api.OrientOptions:
    return api.OrientOptions(given.method, given.compass, api.HorizonOptions(max_distance_m=given.max_distance))


def _dem(given: argparse.Namespace) -> Any:
    return api.open_dem(given.dem, given.band, None, given.dem_unit)


def horizon(given: argparse.Namespace, bar: Bar) -> int:
    """Write the horizon of a place as CSV."""
    if given.output:
        check_folder(given.output)
    place = api.Observer(given.longitude, given.latitude, given.eye_height, given.eye_elevation)
    options = api.HorizonOptions(max_distance_m=given.max_distance)
    write_horizon(api.horizon_profile(_dem(given), place, options, bar), given.output, sys.stdout)
    return ANSWERED


def viewshed(given: argparse.Namespace, bar: Bar) -> int:
    """Write the ground seen from a place as a GeoTIFF."""
    check_folder(given.output)
    dem = _dem(given)
    place = api.Observer(given.longitude, given.latitude, given.eye_height, given.eye_elevation)
    sector = None if given.heading is None else api.Wedge(given.heading, given.hfov or 60.0)
    options = api.ViewshedOptions(max_distance_m=given.max_distance, target_height_m=given.target_height)
    seen = api.viewshed(dem, place, sector, options, bar)
    api.save_viewshed(seen, dem, given.output)
    bar.say(repr(seen).strip("<>"))
    return ANSWERED


def _facts(given: argparse.Namespace) -> dict[str, Any]:
    longitude, latitude = given.position or (None, None)
    return {
        "longitude_deg": longitude, "latitude_deg": latitude, "prefer_photo_position": True, "hfov_deg": given.hfov,
        "focal_length_35mm": given.focal_length_35mm, "eye_height_m": given.eye_height,
        "eye_elevation_m": given.eye_elevation, "use_altitude": given.use_altitude,
    }  # fmt: skip


def _photos(given: Sequence[str], recursive: bool) -> list[str]:
    paths: list[str] = []
    for path in given:
        paths += api.list_photos(path, recursive) if os.path.isdir(path) else [path]
    if not paths:
        raise ValueError(f"no photograph (JPEG, HEIC) lies in {', '.join(given)}; try --recursive or another folder")
    return paths


def _in_options(message: str) -> str:
    for theirs, ours in TO_OPTIONS.items():
        message = message.replace(theirs, ours)
    return message


def _parser() -> argparse.ArgumentParser:
    from .. import __version__

    parser = argparse.ArgumentParser(
        PROGRAM,
        description="Find which way mountain photographs look, and the ground that they show.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    _add_orient(commands)
    _add_place(commands, "horizon", "compute the horizon around a place", horizon, api.HorizonOptions())
    seen = _add_place(commands, "viewshed", "compute the ground seen from a place", viewshed, api.ViewshedOptions())
    seen.add_argument("--heading", type=float, metavar="DEG", help="limit the view to a sector around this azimuth")
    seen.add_argument("--hfov", type=float, metavar="DEG", help="width of that sector (default: 60)")
    seen.add_argument("--target-height", type=float, default=0.0, metavar="M", help="above ground (default: 0)")
    return parser


def _add_orient(commands: Any) -> None:
    text = "Orient photographs by their skylines, and write points with headings, intervals and messages."
    plain = argparse.RawDescriptionHelpFormatter
    parser = commands.add_parser(
        "orient", help="orient photographs", description=text, epilog=EXAMPLES, formatter_class=plain
    )
    parser.set_defaults(run=orient)
    parser.add_argument("photos", nargs="+", metavar="PHOTOS", help="photographs, or folders of them")
    parser.add_argument("dem", metavar="DEM", help="elevation model, any raster that GDAL reads")
    parser.add_argument("-o", "--output", type=Path, required=True, help="points: .gpkg, .geojson, .csv or .parquet")
    parser.add_argument("--report", type=Path, metavar="HTML", help="write a report with figures")
    parser.add_argument("--viewsheds", type=Path, metavar="FOLDER", help="the ground in view, a GeoTIFF per photo")
    parser.add_argument("--doubtful", action="store_true", help="also viewsheds of photos that were not accepted")
    parser.add_argument("--recursive", action="store_true", help="include the folders inside folders")
    parser.add_argument("--method", choices=METHODS, default="robust", help="default: robust")
    parser.add_argument("--compass", choices=COMPASS_USES, default="ignore", help="recorded headings (default: ignore)")
    parser.add_argument("--position", type=float, nargs=2, metavar=("LON", "LAT"), help="of photos without GPS")
    parser.add_argument("--hfov", type=float, metavar="DEG", help="horizontal field of view, for all photos")
    parser.add_argument("--focal-length-35mm", type=float, metavar="MM", help="35 mm equivalent, for all photos")
    parser.add_argument("--workers", type=int, default=0, metavar="N", help="processes (default: all cores but one)")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster that does the work (tcp://...)")
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="chunks, from which a repeated run goes on")
    parser.add_argument("--joint", action="store_true", help="solve the photos of a walk together")
    parser.add_argument("--use-altitude", action="store_true", help="put the eye at the recorded altitude")
    far, text = api.ViewshedOptions().max_distance_m, "range of viewsheds (default: %(default)g)"
    parser.add_argument("--viewshed-distance", type=float, default=far, metavar="M", help=text)
    _add_common(parser, api.HorizonOptions())


def _add_place(commands: Any, name: str, text: str, run: Any, defaults: Any) -> argparse.ArgumentParser:
    parser = commands.add_parser(name, help=text, description=f"{text[0].upper()}{text[1:]}.")
    parser.set_defaults(run=run)
    parser.add_argument("dem", metavar="DEM", help="elevation model, any raster that GDAL reads")
    parser.add_argument("longitude", type=float, metavar="LON", help="WGS 84")
    parser.add_argument("latitude", type=float, metavar="LAT", help="WGS 84")
    needed = name == "viewshed"
    parser.add_argument("-o", "--output", type=Path, required=needed, help=".tif" if needed else ".csv, else stdout")
    _add_common(parser, defaults)
    return parser


def _add_common(parser: argparse.ArgumentParser, defaults: Any) -> None:
    parser.add_argument("--band", type=int, default=1, help="of the elevation model (default: 1)")
    parser.add_argument("--dem-unit", metavar="UNIT", help="of the heights: feet, dm, ... or metres per unit")
    parser.add_argument("--eye-height", type=float, default=1.7, metavar="M", help="above the DEM (default: 1.7)")
    parser.add_argument("--eye-elevation", type=float, metavar="M", help="absolute, in place of the eye height")
    text = "search range (default: %(default)g)"
    parser.add_argument("--max-distance", type=float, default=defaults.max_distance_m, metavar="M", help=text)
    parser.add_argument("--log", metavar="FILE", help="write the details of unexpected errors")
    parser.add_argument("-q", "--quiet", action="store_true", help="say only what went wrong")
