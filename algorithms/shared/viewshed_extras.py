"""Additional results of a viewshed: layers per cell, probabilities, and how much of the frame the DEM explains."""

from __future__ import annotations

from dataclasses import dataclass

from ...core.base.errors import PhotoError
from ...core.base.messages import Message
from ...core.base.uncertainty import PoseUncertainty
from . import parameters as shared
from .feedback import StillProgress, warn
from .fields import FieldSpec
from .i18n import tr
from .styling import dress_file

LAYER_CELLS = 80_000_000
"""Most cells of a window with layers and probabilities. They take ten bytes per cell, so that a larger window would
exceed the gigabyte of memory that we promise."""

HORIZON_STEP_DEG = 0.25
LEVELS = {"p90_m2": 0.9, "p50_m2": 0.5}


def add_extra_parameters(algorithm):
    """Declare the smallest area, the folders of layers and probabilities, and the errors."""
    parameters = [
        shared.number(
            "MIN_AREA",
            tr("Smallest area (m²)"),
            0.0,
            tr("Smaller parts of a polygon are removed, and smaller holes are filled. 0 keeps everything."),
            minimum=0.0,
        ),
        shared.folder_out(
            "LAYERS",
            tr("Folder for layers per photo"),
            tr(
                "One float GeoTIFF per photo with named bands: distance (m), elevation angle (°), height "
                "above the line of sight (m; if negative, a target must be this much higher to be visible) "
                "and, if the pose is known, column and row in the picture (px). Nodata outside the area and "
                "range."
            ),
        ),
        shared.folder_out(
            "PROBABILITIES",
            tr("Folder for probabilities per photo"),
            tr(
                "One GeoTIFF per photo with the probability (0 to 1) that the picture shows a cell, "
                "given the intervals of the pose and the errors below. Requires the area photo frame, "
                "and takes about five times as long."
            ),
        ),
    ]
    for parameter in (*parameters, *error_parameters()):
        algorithm.addParameter(shared.advanced(parameter))


def error_parameters():
    """Parameters of the errors, for probabilities."""
    usual = PoseUncertainty()
    return [
        shared.distance(
            "POSITION_ERROR",
            tr("Error of positions (m)"),
            usual.position_m,
            tr("Standard deviation along each axis, for probabilities."),
        ),
        shared.distance(
            "DEM_ERROR",
            tr("Error of the DEM (m)"),
            usual.dem_m,
            tr("Standard deviation of a cell's height relative to the terrain in front of it, for probabilities."),
        ),
        shared.number(
            "PITCH_ERROR",
            tr("Error of the pitch (°)"),
            usual.pitch_deg,
            tr("Standard deviation, for probabilities. Used if the photo has no interval of its pitch."),
            minimum=0.0,
            maximum=45.0,
        ),
        shared.number(
            "ROLL_ERROR",
            tr("Error of the roll (°)"),
            usual.roll_deg,
            tr(
                "Standard deviation, for probabilities. Used if the photo has no interval of its roll. It "
                "mainly affects ground far from the picture's centre."
            ),
            minimum=0.0,
            maximum=45.0,
        ),
        shared.number(
            "FOCAL_ERROR",
            tr("Error of the focal length (%)"),
            100 * usual.focal_relative,
            tr("Standard deviation, for probabilities. Used if the photo has no interval of its field of view."),
            minimum=0.0,
            maximum=30.0,
        ),
    ]


@dataclass(frozen=True)
class ExtraOptions:
    """Folders (empty: not requested), and the uncertainty of everything except the heading."""

    layers: str
    probabilities: str
    uncertainty: PoseUncertainty


def extra_options(algorithm, parameters, context):
    """Options from the parameters; evaluated once, as each evaluation of a temporary folder returns a different one."""
    folders = [algorithm.parameterAsString(parameters, name, context) for name in ("LAYERS", "PROBABILITIES")]
    names = ("POSITION_ERROR", "DEM_ERROR", "PITCH_ERROR", "ROLL_ERROR", "FOCAL_ERROR")
    position, dem, pitch, roll, focal = (algorithm.parameterAsDouble(parameters, name, context) for name in names)
    errors = {"position_m": position, "dem_m": dem, "pitch_deg": pitch, "roll_deg": roll}
    return ExtraOptions(*folders, PoseUncertainty(**errors, focal_relative=focal / 100))


def extra_fields():
    """Fields that are added to the polygons."""
    return [
        FieldSpec("terr_share", "real", tr("Share of the picture that the DEM explains as ground")),
        FieldSpec("p90_m2", "real", tr("Ground shown with a probability of 0.9 or more (m²)")),
        FieldSpec("p50_m2", "real", tr("Ground shown with a probability of 0.5 or more (m²)")),
    ]


def layer_names():
    """Names of the bands in the order of `core.viewshed.layers.LAYERS`."""
    return [
        tr("distance"),
        tr("elevation angle"),
        tr("height above the line of sight"),
        tr("column in the photograph"),
        tr("row in the photograph"),
    ]


class Extras:
    """Computes and writes the results photo by photo; a repeated run does not compute complete results again.

    Parameters
    ----------
    viewer : Viewer
    options : ExtraOptions
    feedback : QgsProcessingFeedback
    """

    def __init__(self, viewer, options, feedback):
        self.viewer, self.dem, self.options, self.feedback = viewer, viewer.dem, options, feedback
        self._horizons, self._progress = {}, StillProgress(feedback)

    @property
    def folders(self):
        """Folders that are written to, by the names of their parameters."""
        found = {"LAYERS": self.options.layers, "PROBABILITIES": self.options.probabilities}
        return {name: folder for name, folder in found.items() if folder}

    def of(self, point, seen, horizon=None):
        """Write the requested results for one viewshed and return the known values of `extra_fields` by name.

        Parameters
        ----------
        point : PhotoPoint
        seen : Viewshed
        horizon : HorizonProfile or None
            Horizon around the eye, if it has been computed already.
        """
        too_large = seen.window.rows * seen.window.cols > LAYER_CELLS
        if self.folders and too_large:
            fault = Message(
                "No layers and probabilities: the area has more than {count} million cells. Take a shorter maximum "
                "distance.",
                count=LAYER_CELLS // 1_000_000,
            )
            warn(self.feedback, point.name, fault)
        if self.options.layers and not too_large:
            self._write_layers(point, seen)
        values = self._terrain_share(point, seen, horizon)
        if self.options.probabilities and not too_large:
            values.update(self._write_probabilities(point, seen))
        return values

    def _write_layers(self, point, seen):
        from ...core.io.viewshed_raster import LayerStack, fingerprint, stored_facts, write_layers
        from ...core.viewshed.layers import LAYERS, clearance, sector_layers

        photo, observer = point.posed, point.observer
        path = self.viewer.file_of(point, self.options.layers)
        lens = (None, None) if photo is None else (photo.camera, photo.pose)
        mark = fingerprint(self.dem, observer, seen.sector, seen.options, "layers", *lens)
        if stored_facts(path, mark) is not None:
            self.feedback.pushInfo(tr("{name}: taken from {path}").format(name=point.name, path=path))
        else:
            lifted = clearance(self.dem, observer, seen.sector, seen.options, self._progress)
            strips = sector_layers(self.dem, seen, lifted, photo)
            bands = dict(zip(layer_names(), LAYERS[: 3 if photo is None else 5]))
            facts = {"PHOTO": point.path or ""}
            write_layers(path, self.dem, seen.window, LayerStack(bands, strips), mark, facts)
        dress_file(path, "layers")

    def _terrain_share(self, point, seen, horizon):
        """Share of the frame that points below the DEM's horizon."""
        from ...core.horizon.horizon import HorizonOptions, horizon_profile
        from ...core.viewshed.layers import terrain_share
        from ...core.viewshed.sector import PhotoFrame

        if not isinstance(seen.sector, PhotoFrame):
            return {}
        if horizon is None:
            observer, range_ = point.observer, seen.options
            if observer not in self._horizons:
                options = HorizonOptions(
                    azimuth_step_deg=HORIZON_STEP_DEG,
                    max_distance_m=range_.max_distance_m,
                    refraction_coefficient=range_.refraction_coefficient,
                )
                # Photos from one place follow one another.
                self._horizons = {observer: horizon_profile(self.dem, observer, options, self._progress)}
            horizon = self._horizons[observer]
        share, _ = terrain_share(seen.sector.camera, seen.sector.pose, horizon)
        return {"terr_share": share}

    def _write_probabilities(self, point, seen):
        from ...core.io.viewshed_raster import LayerStack, fingerprint, stored_facts, write_layers
        from ...core.viewshed.probability import visibility_probability
        from ...core.viewshed.sector import PhotoFrame

        if not isinstance(seen.sector, PhotoFrame):
            text = Message("No probabilities: they need the area photo frame, with pitch and vertical field of view.")
            warn(self.feedback, point.name, text)
            return {}
        photo = point.posed
        path = self.viewer.file_of(point, self.options.probabilities)
        mark = fingerprint(self.dem, photo.observer, seen.sector, seen.options, "probabilities", photo.uncertainty)
        stored = stored_facts(path, mark)
        if stored is not None:
            self.feedback.pushInfo(tr("{name}: taken from {path}").format(name=point.name, path=path))
            dress_file(path, "probability")
            return {name: float(stored[name.upper()]) for name in LEVELS}
        try:
            found = visibility_probability(self.dem, photo, seen.options, progress=self._progress)
        except PhotoError as error:
            warn(self.feedback, point.name, error.message)
            return {}
        areas = {name: found.area_m2(level) for name, level in LEVELS.items()}
        facts = {"PHOTO": point.path or "", **{name.upper(): repr(area) for name, area in areas.items()}}
        strips = [(found.window, [found.values])]
        bands = {tr("probability that the photograph shows the cell"): "1"}
        write_layers(path, self.dem, found.window, LayerStack(bands, strips), mark, facts)
        dress_file(path, "probability")
        return areas
