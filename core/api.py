"""The public face: what `import skyline_viewshed as sv` offers to scripts, notebooks and the command line.

All of it works without QGIS; what reads or writes rasters and vector files needs GDAL, and says so. Angles are degrees,
clockwise from true north; lengths are metres; pixels count from 0 at the centre of the first one.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from datetime import datetime
from functools import partial
from operator import length_hint
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from .base.camera import Camera, Pose, focal_of_fov_px
from .base.errors import Cancelled, PhotoError, SkylineViewshedError, TerrainError
from .base.imaging import shrink_to
from .base.landmark_hint import LandmarkHint
from .base.model import HorizonProfile, OrientedPhoto, Photo, PhotoMetadata
from .base.optional import require
from .base.posed import PosedPhoto
from .base.progress import ProgressLike, as_progress, subtask
from .base.terrain import ArrayTerrain, Observer
from .base.view import open_view
from .base.viewed import Viewshed
from .batch import PREVIEW_PX, PhotoRequest, orient_request
from .cluster import spread_over
from .figures.notebook import photo_html
from .figures.overlay import overlay_image
from .horizon import horizon as horizons
from .horizon.horizon import HorizonOptions
from .io.folder import list_photos
from .io.photo import read_metadata, read_photo
from .io.report_file import ReportFile
from .many import JOINT_PART, OrientJob, answers_of, together_or_alone
from .mapping.monoplot import place_pixels
from .mapping.sightline import SightOptions
from .pipeline import OrientOptions
from .report.audit import DeviceAudit, audit, reading_of
from .report.report import ReportWriter
from .simulate.example import example_terrain
from .simulate.render import render_view
from .simulate.scene import SceneOptions
from .trusting import trusted_outcomes
from .viewshed import viewshed as viewsheds
from .viewshed.sector import FullCircle, PhotoFrame, Wedge
from .viewshed.viewshed import ViewshedOptions

if TYPE_CHECKING:
    from PIL.Image import Image

    from .io.raster import Dem

    DemLike = Union[Dem, ArrayTerrain]
    Sector = Union[FullCircle, Wedge, PhotoFrame]

__all__ = [
    "ArrayTerrain", "Cancelled", "DeviceAudit", "FullCircle", "HorizonOptions", "HorizonProfile", "LandmarkHint",
    "Observer", "OrientOptions", "OrientedPhoto", "Photo", "PhotoError", "PhotoMetadata", "PhotoRequest",
    "PosedPhoto", "SceneOptions", "SkylineViewshedError", "TerrainError", "Viewshed", "ViewshedOptions", "Wedge",
    "compass_audit", "dem_from_array", "example_terrain", "horizon_profile", "list_photos", "open_dem", "orient",
    "orient_many", "overlay", "place", "read_metadata", "read_photo", "save_points", "save_report", "save_viewshed",
    "simulate", "viewshed",
]  # fmt: skip

PathLike = Union[str, "os.PathLike[str]"]
PhotoLike = Union[PathLike, np.ndarray, Photo, PhotoRequest]
"""A file, pixels (H, W, 3), a `Photo`, or a file with what is known about it."""

IN_PYTHON = {
    "Supply it as a point in a photo point layer.": "Give longitude_deg and latitude_deg.",
    "HFOV_FIELD": "hfov_deg",
    "HEIGHT_FIELD": "eye_elevation_m",
    "USE_ALTITUDE": "use_altitude",
}
"""What messages call the parameters of QGIS algorithms, and what those are called here."""


def open_dem(path: PathLike, band: int = 1, crs: str | None = None, unit: str | float | None = None) -> Dem:
    """Open an elevation model in a file; it is read in windows, never as a whole. Needs GDAL.

    Parameters
    ----------
    path : str or Path
        Anything that GDAL reads as a raster with a CRS: GeoTIFF, COG, HGT, VRT, ...
    band : int
        Counted from 1.
    crs : str or None
        WKT or "EPSG:..." in place of the file's own.
    unit : str, float or None
        Unit of the heights ("feet", "us-ft", "dm", ...), or metres per unit; None means that of the file.

    Raises
    ------
    TerrainError
        The raster cannot serve as an elevation model.
    MissingPackageError
        GDAL's Python package is not installed.

    Examples
    --------
    >>> open_dem("dem.tif")
    <Dem dem.tif: 320 x 320 cells of 75 x 75, unknown>
    """
    require("osgeo.gdal", "Reading an elevation model from a file")
    from .io import dem_reading, raster

    return raster.open_dem(os.fspath(path), band, crs, dem_reading.DemReading(unit=unit))


def dem_from_array(
    elevation_m: Any, cell_m: float, longitude_deg: float = 0.0, latitude_deg: float = 0.0
) -> ArrayTerrain:
    """Make an elevation model of an array; its columns point to true north.

    Parameters
    ----------
    elevation_m : (R, C) array
        Row 0 is the northernmost; NaN or masked where unknown [m].
    cell_m : float
        Side of a cell [m].
    longitude_deg, latitude_deg : float
        WGS 84 position of the array's centre [degrees].

    Examples
    --------
    >>> north, east = np.mgrid[5000:-5001:-100, -5000:5001:100]
    >>> dem_from_array(1500 - np.hypot(east, north) / 5, cell_m=100, longitude_deg=8, latitude_deg=46.5)
    <ArrayTerrain: 101 x 101 cells of 100 m, 86 to 1500 m, centre 8.00000, 46.50000>
    """
    elevation = np.ma.filled(np.ma.asarray(elevation_m).astype(np.float32), np.nan)
    if elevation.ndim != 2 or min(elevation.shape) < 2 or not np.isfinite(elevation).any():
        raise ValueError(f"elevations need two dimensions and a finite value, not an array of {elevation.shape}")
    if not cell_m > 0:
        raise ValueError(f"the side of a cell must be positive, not {cell_m}")
    return ArrayTerrain(elevation, float(cell_m), float(longitude_deg), float(latitude_deg))


def orient(
    photo: PhotoLike,
    dem: DemLike,
    *,
    method: str | None = None,
    compass: str | None = None,
    options: OrientOptions | None = None,
    progress: ProgressLike = None,
    **facts: Any,
) -> OrientedPhoto:
    """Find the direction the camera faced, how certain that is, and which horizon the photograph shows.

    Parameters
    ----------
    photo : str, Path, (H, W, 3) uint8 array, Photo or PhotoRequest
        A file brings its position and focal length; pixels need `longitude_deg`, `latitude_deg` and `hfov_deg`.
    dem : Dem or ArrayTerrain
    method : str or None
        'robust' (the default) or 'paper'.
    compass : str or None
        'ignore' (the default) or 'prior', which takes a recorded heading as a hint.
    options : OrientOptions or None
        Everything else; `method` and `compass` override it.
    progress : callable or Progress or None
    **facts
        What is known of this photograph, by the names of `PhotoRequest`: `longitude_deg`, `latitude_deg`, `hfov_deg`,
        `eye_elevation_m`, `heading_deg`, `landmarks`, ...

    Returns
    -------
    OrientedPhoto
        A photograph at fault gives status 'failed' and a message, and no exception.

    Raises
    ------
    TerrainError
        The elevation model as a whole cannot be used.

    Examples
    --------
    >>> dem = example_terrain()
    >>> pixels = simulate(dem, (8.0, 46.5), heading_deg=300, pitch_deg=3, hfov_deg=60)
    >>> photo = orient(pixels, dem, longitude_deg=8.0, latitude_deg=46.5, hfov_deg=60)
    >>> photo.status, round(photo.heading_deg)
    ('accepted', 300)
    """
    chosen = _options(method, compass, options)
    request, taken = _task(photo, chosen, facts)
    return _in_python(orient_request(request, dem, chosen, progress=as_progress(progress), photo=taken))


# parameters: each is a name that callers write; a Dask client alone says where the work is done
def orient_many(
    photos: PathLike | Iterable[PhotoLike],
    dem: DemLike,
    *,
    method: str | None = None,
    compass: str | None = None,
    options: OrientOptions | None = None,
    progress: ProgressLike = None,
    workers: int = 1,
    client: Any = None,
    joint: bool = False,
    **facts: Any,
) -> Iterator[OrientedPhoto]:
    """Orient many photographs; photographs of one station share its horizon.

    With compass='prior' a sample of them tests the compass of each camera first, and one that often contradicts the
    skylines counts for less than in `orient`.

    Parameters
    ----------
    photos : folder, or iterable of what `orient` takes
    dem, method, compass, options, progress, **facts
        As for `orient`; `progress` covers the whole run, and facts hold for all photographs.
    workers : int
        Processes: 1 is this one, 0 all cores but one as far as memory allows. The answers are the same.
    client : dask.distributed.Client or None
        Does the work on a Dask cluster, whose workers must reach the files by the same paths. See docs/scale.md.
        With compass='prior' this process reads up to 60 of the files too.
    joint : bool
        Solve the photographs of a walk together (docs/walks.md); all results stay in memory (3 MB each) until the end.

    Yields
    ------
    OrientedPhoto
        In order. No photograph ends the run: where even the program itself fails, the status is 'failed'.

    Examples
    --------
    >>> dem = example_terrain()
    >>> pixels = [simulate(dem, (8.0, 46.5), heading_deg=h, pitch_deg=3, hfov_deg=60) for h in (290, 300)]
    >>> [round(p.heading_deg) for p in orient_many(pixels, dem, longitude_deg=8.0, latitude_deg=46.5, hfov_deg=60)]
    [290, 300]
    """
    chosen, whole, listed = _options(method, compass, options), as_progress(progress), _listed(photos)
    tasks, orient_all = [_task(photo, chosen, facts) for photo in listed], spread_over(client, workers)
    job, outcomes = trusted_outcomes(
        OrientJob(dem, chosen), tasks, orient_all, subtask(whole, 0.0, JOINT_PART if joint else 1.0)
    )
    together: Iterable[OrientedPhoto] = answers_of(outcomes, tasks)
    if joint:
        again, part = partial(orient_all, job), subtask(whole, JOINT_PART, 1.0)
        together, _ = together_or_alone(tasks, list(together), again, part, job.options)
    for index, oriented in enumerate(together):
        yield _in_python(oriented)
        if joint or index + 1 == len(listed):
            whole.report(1.0)


def horizon_profile(
    dem: DemLike,
    observer: Observer | Sequence[float],
    options: HorizonOptions | None = None,
    progress: ProgressLike = None,
) -> HorizonProfile:
    """Compute the boundary between sky and terrain around a place.

    Parameters
    ----------
    dem : Dem or ArrayTerrain
    observer : Observer or (longitude, latitude)
        WGS 84 [degrees]; without an elevation of its own the eye is 1.7 m above the elevation model.
    options : HorizonOptions or None
    progress : callable or Progress or None

    Examples
    --------
    >>> horizon = horizon_profile(example_terrain(), (8.0, 46.5))
    >>> horizon
    <HorizonProfile: 3600 azimuths, eye at 2116 m, horizon at ...>
    >>> west = horizon.elevation_deg[horizon.azimuth_deg == 270.0]
    """
    return horizons.horizon_profile(dem, _observer(observer), options or HorizonOptions(), as_progress(progress))


def viewshed(
    dem: DemLike,
    view: OrientedPhoto | PosedPhoto | Observer | Sequence[float],
    sector: Sector | None = None,
    options: ViewshedOptions | None = None,
    progress: ProgressLike = None,
) -> Viewshed:
    """Find the ground that a photograph shows, or that is seen from a place.

    Parameters
    ----------
    dem : Dem or ArrayTerrain
    view : OrientedPhoto, PosedPhoto, Observer or (longitude, latitude)
    sector : FullCircle, Wedge, PhotoFrame or None
        Part of the view that counts; None takes the frame of a photograph, and else the full circle.
    options : ViewshedOptions or None
        Range, target height, ...
    progress : callable or Progress or None

    Returns
    -------
    Viewshed
        `visible` is an array of bools over `window`, a part of the elevation model's grid.

    Raises
    ------
    ValueError
        The photograph has no heading.

    Examples
    --------
    >>> dem = example_terrain()
    >>> viewshed(dem, (8.0, 46.5), options=ViewshedOptions(max_distance_m=5000))
    <Viewshed: 116 x 116 cells, 1612 seen, about 13.1 km², range 5 km, eye at 2116 m>
    """
    if isinstance(view, OrientedPhoto):
        view = _view(view)
    observer = view.observer if isinstance(view, PosedPhoto) else _observer(view)
    if sector is None:
        sector = PhotoFrame(view.camera, view.pose) if isinstance(view, PosedPhoto) else FullCircle()
    return viewsheds.viewshed(dem, observer, sector, options or ViewshedOptions(), as_progress(progress))


def place(
    view: OrientedPhoto | PosedPhoto, dem: DemLike, x_px: Any, y_px: Any, max_distance_m: float = 60_000.0
) -> tuple[np.ndarray, np.ndarray]:
    """Find where pixels lie on the map; `photo.view.place(dem, x_px, y_px)` does the same.

    Parameters
    ----------
    view : OrientedPhoto or PosedPhoto
    dem : Dem or ArrayTerrain
    x_px, y_px : array
        Pixels of the full upright picture.
    max_distance_m : float
        Nothing farther is looked at [m].

    Returns
    -------
    longitude_deg, latitude_deg : array
        WGS 84 [degrees]; NaN for sky, and where the elevation model ends.

    Raises
    ------
    ValueError
        A pixel lies outside the picture.

    Examples
    --------
    >>> dem = example_terrain()
    >>> pixels = simulate(dem, (8.0, 46.5), heading_deg=300, pitch_deg=3, hfov_deg=60)
    >>> photo = orient(pixels, dem, longitude_deg=8.0, latitude_deg=46.5, hfov_deg=60)
    >>> longitude, latitude = photo.view.place(dem, [400, 400], [450, 10])
    >>> [f"{degrees:.2f}" for degrees in longitude]
    ['7.98', 'nan']
    """
    posed = _view(view) if isinstance(view, OrientedPhoto) else view
    opened = open_view(dem, posed, max_distance_m)
    x_px, y_px = np.broadcast_arrays(np.asarray(x_px, float), np.asarray(y_px, float))
    outside = int(np.count_nonzero(~opened.frames(x_px, y_px)))
    if outside:
        size = f"{posed.camera.width_px} x {posed.camera.height_px}"
        raise ValueError(f"{outside} of {x_px.size} pixels lie outside the picture of {size} pixels")
    placed = place_pixels(dem, opened, x_px.ravel(), y_px.ravel(), SightOptions(max_distance_m=max_distance_m))
    longitude, latitude = dem.position_of(*opened.frame.to_pixel(placed.hits.east_m, placed.hits.north_m))
    return np.reshape(longitude, x_px.shape), np.reshape(latitude, x_px.shape)


def overlay(photo: OrientedPhoto, width_px: int = 1280, evidence: bool = True, legend: bool = True) -> Image:
    """Draw the extracted skyline and the DEM's horizon over the photograph.

    Parameters
    ----------
    photo : OrientedPhoto
    width_px : int
        Of the drawing [pixels].
    evidence : bool
        Tint the rows where the skyline may lie.
    legend : bool
        Name the colours, with the headings.

    Returns
    -------
    PIL.Image.Image
        A notebook shows it; `save` writes it, and `np.asarray` gives its pixels.

    Examples
    --------
    >>> dem = example_terrain()
    >>> pixels = simulate(dem, (8.0, 46.5), heading_deg=300, pitch_deg=3, hfov_deg=60)
    >>> overlay(orient(pixels, dem, longitude_deg=8.0, latitude_deg=46.5, hfov_deg=60), width_px=400).size
    (400, 300)
    """
    pixels = overlay_image(photo, width_px, evidence, legend)
    return require("PIL.Image", "Drawing and writing pictures").fromarray(pixels)


def simulate(
    dem: DemLike,
    observer: Observer | Sequence[float],
    scene: SceneOptions | None = None,
    size_px: tuple[int, int] = (800, 600),
    **pose: float,
) -> np.ndarray:
    """Draw what a camera would see of an elevation model: for examples, tests and planning.

    Parameters
    ----------
    dem : Dem or ArrayTerrain
    observer : Observer or (longitude, latitude)
    scene : SceneOptions or None
        Light, weather and ground cover; None is a clear day.
    size_px : (width, height)
    **pose
        `heading_deg`, `pitch_deg`, `roll_deg` (each 0) and `hfov_deg` (60).

    Returns
    -------
    (H, W, 3) uint8 array

    Examples
    --------
    >>> simulate(example_terrain(), (8.0, 46.5), heading_deg=300, size_px=(160, 120)).shape
    (120, 160, 3)
    """
    angles = {"heading_deg": 0.0, "pitch_deg": 0.0, "roll_deg": 0.0, "hfov_deg": 60.0}
    if unknown := set(pose) - set(angles):
        raise TypeError(f"simulate() knows {', '.join(angles)}, not {', '.join(sorted(unknown))}")
    angles.update(pose)
    camera = Camera(*size_px, focal_of_fov_px(size_px[0], angles.pop("hfov_deg")))
    return render_view(dem, _observer(observer), camera, Pose(**angles), scene).pixels


def save_points(photos: Iterable[OrientedPhoto], path: PathLike, max_distance_m: float | None = None) -> None:
    """Write oriented photographs as points with the fields that QGIS's layers have. Needs GDAL.

    Parameters
    ----------
    photos : iterable of OrientedPhoto
    path : str or Path
        Ending in .gpkg, .geojson or .csv; written whole or not at all.
    max_distance_m : float or None
        Range that the run used, for the field `radius` [m]; None takes the default of `HorizonOptions`.

    Examples
    --------
    >>> save_points([orient("north.jpg", open_dem("dem.tif"))], "photos.gpkg")
    """
    require("osgeo.ogr", "Writing points")
    from .io.vector import photo_row, point_fields, write_points

    reach_m = HorizonOptions().max_distance_m if max_distance_m is None else max_distance_m
    write_points(path, point_fields(), [photo_row(photo, reach_m) for photo in photos])


def save_report(
    photos: Iterable[OrientedPhoto],
    path: PathLike,
    title: str = "Oriented photos",
    facts: dict[str, Any] | None = None,
) -> None:
    """Write the report, one HTML page with a card for each photograph. `photos` may be a generator.

    From 201 photographs on, the page is an index with a map, and the cards are pages in the folder `<name>_files`.

    Parameters
    ----------
    photos : iterable of OrientedPhoto
    path : str or Path
        Of the HTML page; written whole or not at all.
    title : str
    facts : dict or None
        Names and values of the run's settings, for the page's end.

    Examples
    --------
    >>> save_report(orient_many(["north.jpg"], open_dem("dem.tif")), "report.html")
    """
    document, count = ReportFile(os.fspath(path)), length_hint(photos)
    with ReportWriter(document, title, facts, created=datetime.now(), expected_photos=count) as report:
        for photo in photos:
            report.add(photo)


def compass_audit(photos: Iterable[OrientedPhoto]) -> list[DeviceAudit]:
    """Judge the compasses of a collection: bias, spread, worthless and turned readings, and drift of each device.

    Examples
    --------
    >>> devices = compass_audit(orient_many(["north.jpg"], open_dem("dem.tif")))
    """
    return audit(filter(None, map(reading_of, photos)))


def save_viewshed(seen: Viewshed, dem: Dem, path: PathLike, facts: dict[str, Any] | None = None) -> None:
    """Write a viewshed as a GeoTIFF on the elevation model's grid: 1 seen, 0 not seen, 255 unknown. Needs GDAL.

    Parameters
    ----------
    seen : Viewshed
    dem : Dem
        From `open_dem`; the one that the viewshed was computed on.
    path : str or Path
        Written whole or not at all.
    facts : dict or None
        Further names and values for the file's header.

    Examples
    --------
    >>> dem = open_dem("dem.tif")
    >>> save_viewshed(viewshed(dem, orient("north.jpg", dem)), dem, "seen.tif")
    """
    require("osgeo.gdal", "Writing a raster")
    from .io.viewshed_raster import fingerprint, write_viewshed

    eye = Observer(seen.frame.longitude_deg, seen.frame.latitude_deg, eye_elevation_m=seen.eye_elevation_m)
    mark = fingerprint(dem, eye, seen.sector, seen.options)
    write_viewshed(os.fspath(path), seen, dem, mark, {"SOFTWARE": "Skyline Viewshed", **(facts or {})})


def _options(method: str | None, compass: str | None, options: OrientOptions | None) -> OrientOptions:
    options = options or OrientOptions()
    return replace(options, method=method or options.method, compass=compass or options.compass)


def _task(photo: PhotoLike, options: OrientOptions, facts: dict) -> tuple[PhotoRequest, Photo | None]:
    request = replace(photo, **facts) if isinstance(photo, PhotoRequest) else PhotoRequest(_path(photo), **facts)
    return request, _taken(photo, None if options.method == "paper" else PREVIEW_PX)


def _in_python(oriented: OrientedPhoto) -> OrientedPhoto:
    """Name this module's arguments in the message, in place of the parameters of QGIS algorithms."""
    message = oriented.message
    for theirs, ours in IN_PYTHON.items():
        message = message.replace(theirs, ours)
    return replace(oriented, orientation=replace(oriented.orientation, message=message))


def _taken(photo: PhotoLike, max_side_px: int | None) -> Photo | None:
    """Give the picture where it is in memory already, reduced as a file would be."""
    if isinstance(photo, (str, os.PathLike, PhotoRequest)):
        return None
    if not isinstance(photo, Photo):
        pixels = np.asarray(photo)
        if pixels.dtype != np.uint8 or pixels.ndim != 3 or pixels.shape[2] < 3:
            raise TypeError(f"pixels must be a uint8 array (H, W, 3), not {pixels.dtype} {pixels.shape}")
        photo = Photo(PhotoMetadata("", pixels.shape[1], pixels.shape[0]), pixels[..., :3])
    if max_side_px is not None and max(photo.pixels.shape[:2]) > max_side_px:
        photo = replace(photo, pixels=np.rint(shrink_to(photo.pixels, max_side_px)).astype(np.uint8))
    return photo


def _path(photo: PhotoLike) -> str:
    if isinstance(photo, (str, os.PathLike)):
        return os.fspath(photo)
    return photo.path if isinstance(photo, PhotoRequest) else photo.metadata.path if isinstance(photo, Photo) else ""


def _listed(photos: PathLike | Iterable[PhotoLike]) -> list[PhotoLike]:
    if isinstance(photos, (str, os.PathLike)):
        return list(list_photos(photos)) if os.path.isdir(photos) else [photos]
    return list(photos)


def _observer(place: Observer | Sequence[float]) -> Observer:
    if isinstance(place, Observer):
        return place
    longitude, latitude = place
    return Observer(float(longitude), float(latitude))


def _view(photo: OrientedPhoto) -> PosedPhoto:
    if photo.view is None:
        raise ValueError(f"the photograph has no heading: {photo.message}")
    return photo.view


# The two methods need rooms that the values themselves, in `base`, must not know.
PosedPhoto.place = place
OrientedPhoto._repr_html_ = photo_html
