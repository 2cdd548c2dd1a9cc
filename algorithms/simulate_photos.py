"""Points with a pose and a DEM -> photographs as they would look from there."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

from qgis.core import QgsProcessingOutputNumber, QgsProcessingParameterEnum

from ..core.base.camera import Camera, Pose, focal_of_fov_px
from ..core.base.errors import PhotoError
from ..core.base.progress import subtask
from ..core.io.whole_file import unused_name
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import is_null
from .shared.i18n import tr
from .shared.layers import read_points
from .shared.outputs import make_folder_of

POSE_FIELDS = ("HEADING_FIELD", "PITCH_FIELD", "ROLL_FIELD", "HFOV_FIELD", "HEIGHT_FIELD")
FORMATS = ("jpg", "heic")
DEFAULT_HFOV_DEG = 65.0
DIAGONAL_MM = 43.2666


class SimulatePhotos(DemAlgorithm):
    """Render the view of a camera."""

    ID = "simulatephotos"
    GROUP_ID = "checks"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Simulate photos")

    def tags(self):
        """Search words."""
        return tr("render,view,panorama,synthetic,photo,preview,test data").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Realistic photographs of the terrain from points with a heading")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Renders sun, snow, haze, sky and clouds over the elevation model and writes real JPEG or HEIC files "
                "with position, compass heading and focal length, for planning photographs, for tests and for practice."
            ),
            tr(
                "Heading, pitch and roll come from fields (NULL: 0 for pitch and roll; points without a heading are "
                "skipped). The same seed gives the same pictures. The compass heading written is the exact one."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        points = shared.photo_source()
        points.setDescription(tr("Points with heading"))
        self.addParameter(points)
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        for parameter in pose_parameters():
            self.addParameter(parameter)
        for name, label, default in (("WIDTH", tr("Width (px)"), 1600), ("HEIGHT", tr("Height (px)"), 1200)):
            text = tr("Size of the upright picture.")
            self.addParameter(shared.number(name, label, default, text, 64, 12000, integer=True))
        image_format = QgsProcessingParameterEnum("FORMAT", tr("Format"), ["JPEG", "HEIC"], defaultValue=0)
        self.addParameter(shared.explained(image_format, tr("HEIC needs the Python package pillow-heif.")))
        for parameter in scene_parameters():
            self.addParameter(shared.advanced(parameter))
        self.addParameter(shared.advanced(shared.eye_height()))
        self.addParameter(
            shared.folder_out(
                "FOLDER",
                tr("Folder of photographs"),
                tr("Folder in which the pictures are saved."),
                optional=False,
                create=True,
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))

    def compute(self, parameters, context, feedback):
        """Render point by point; each file is complete before the next begins."""
        _, rows = read_points(self, parameters, context, "INPUT", None, POSE_FIELDS)
        size = tuple(self.parameterAsInt(parameters, name, context) for name in ("WIDTH", "HEIGHT"))
        suffix = FORMATS[self.parameterAsEnum(parameters, "FORMAT", context)]
        eye_height_m = self.parameterAsDouble(parameters, "EYE_HEIGHT", context)
        folder = Path(self.parameterAsString(parameters, "FOLDER", context))
        dem, scene, taken, count = self.dem.open(), scene_of(self, parameters, context), set(), 0
        for index, row in enumerate(rows):
            announce(feedback, row.name, index, len(rows))
            part = subtask(FeedbackProgress(feedback), index / len(rows), (index + 1) / len(rows))
            if None in (row.longitude_deg, row.numbers["HEADING_FIELD"]):
                warn(feedback, row.name, tr("The point has no usable position or no heading."))
                continue
            target = folder / f"{stem_of(row, taken)}.{suffix}"
            make_folder_of(str(target))
            try:
                simulate(dem, row, size, eye_height_m, scene, target, part)
                count += 1
            except PhotoError as error:
                warn(feedback, row.name, error.message)
        return {"FOLDER": str(folder), "COUNT": count}


def pose_parameters():
    """Field parameters in the order of `POSE_FIELDS`."""
    field = shared.number_field
    heading = field("HEADING_FIELD", tr("Field with the heading (°)"), tr("True, clockwise from north."), "heading")
    others = [
        field("PITCH_FIELD", tr("Field with the pitch (°)"), tr("Up is positive. NULL: 0."), "pitch"),
        field("ROLL_FIELD", tr("Field with the roll (°)"), tr("Right side down is positive. NULL: 0."), "roll"),
        field("HFOV_FIELD", tr("Field with the horizontal field of view (°)"), tr("NULL: 65 degrees."), "hfov"),
        field(
            "HEIGHT_FIELD",
            tr("Field with the camera's elevation (m)"),
            tr("Absolute elevation in the DEM's height system. NULL: DEM plus camera height."),
        ),
    ]
    return [heading, *map(shared.advanced, others)]


def scene_parameters():
    """Options of the scene; defaults are the core's."""
    from ..core.simulate.scene import CLOUDS, FOREGROUNDS, SceneOptions

    scene = SceneOptions()
    clouds = QgsProcessingParameterEnum(
        "CLOUDS",
        tr("Clouds"),
        [tr("none"), tr("behind the ridge"), tr("lid over the ridge"), tr("fog"), tr("in the valley")],
        defaultValue=CLOUDS.index(scene.clouds),
    )
    foreground = QgsProcessingParameterEnum(
        "FOREGROUND",
        tr("Foreground"),
        [tr("none"), tr("trees"), tr("people")],
        defaultValue=FOREGROUNDS.index(scene.foreground),
    )
    number, angle = shared.number, tr("Degrees.")
    share = tr("Share of the picture's width that is covered, 0 to 1.")
    line = tr("Elevation. If this is empty, it is derived from the relief in view.")
    return [
        number("SEED", tr("Seed"), scene.seed, tr("The same number gives the same picture."), 0, integer=True),
        shared.explained(clouds, tr("Weather of the scene.")),
        number("CLOUD_SHARE", tr("Share of clouds"), scene.cloud_share, share, 0, 1),
        shared.explained(foreground, tr("Objects near the camera.")),
        number("FOREGROUND_SHARE", tr("Share of foreground"), scene.foreground_share, share, 0, 1),
        number("SUN_AZIMUTH", tr("Azimuth of the sun (°)"), scene.sun_azimuth_deg, angle, 0, 360),
        number("SUN_ELEVATION", tr("Elevation of the sun (°)"), scene.sun_elevation_deg, angle, -5, 90),
        shared.distance(
            "VISIBILITY", tr("Visual range (m)"), scene.visibility_m, tr("Smaller values give more haze."), 100
        ),
        shared.distance(
            "MAX_DISTANCE", tr("Maximum distance (m)"), scene.range_m, tr("Terrain beyond is left out."), 100
        ),
        number("SNOW_LINE", tr("Snow line (m)"), None, line, optional=True),
        number("TREE_LINE", tr("Tree line (m)"), None, line, optional=True),
        number("NOISE", tr("Sensor noise"), scene.noise, tr("Standard deviation at mid-grey, in 8-bit steps."), 0, 50),
    ]


def scene_of(algorithm, parameters, context):
    """Scene options of the core from the parameters."""
    from ..core.simulate.scene import CLOUDS, FOREGROUNDS, SceneOptions

    def number(name):
        return algorithm.parameterAsDouble(parameters, name, context)

    def optional(name):
        return None if is_null(parameters.get(name)) else number(name)

    return SceneOptions(
        seed=algorithm.parameterAsInt(parameters, "SEED", context),
        clouds=CLOUDS[algorithm.parameterAsEnum(parameters, "CLOUDS", context)],
        cloud_share=number("CLOUD_SHARE"),
        foreground=FOREGROUNDS[algorithm.parameterAsEnum(parameters, "FOREGROUND", context)],
        foreground_share=number("FOREGROUND_SHARE"),
        sun_azimuth_deg=number("SUN_AZIMUTH"),
        sun_elevation_deg=number("SUN_ELEVATION"),
        visibility_m=number("VISIBILITY"),
        range_m=number("MAX_DISTANCE"),
        snow_line_m=optional("SNOW_LINE"),
        tree_line_m=optional("TREE_LINE"),
        noise=number("NOISE"),
    )


def simulate(dem, row, size, eye_height_m, scene, path, progress):
    """Render one photo and write it."""
    from ..core.base.model import PhotoMetadata
    from ..core.base.terrain import Observer
    from ..core.io.write_photo import write_photo
    from ..core.simulate.render import render_view

    width, height = size
    focal_px = focal_of_fov_px(width, row.numbers["HFOV_FIELD"] or DEFAULT_HFOV_DEG)
    heading = row.numbers["HEADING_FIELD"] % 360
    pose = Pose(heading, row.numbers["PITCH_FIELD"] or 0.0, row.numbers["ROLL_FIELD"] or 0.0)
    observer = Observer(row.longitude_deg, row.latitude_deg, eye_height_m, row.numbers["HEIGHT_FIELD"])
    view = render_view(dem, observer, Camera(width, height, focal_px), pose, scene, progress)
    metadata = PhotoMetadata(
        str(path),
        width,
        height,
        latitude_deg=row.latitude_deg,
        longitude_deg=row.longitude_deg,
        altitude_m=view.eye_elevation_m,
        altitude_reference="sea level",
        focal_length_35mm=focal_px * DIAGONAL_MM / (width**2 + height**2) ** 0.5,
        compass_heading_deg=heading,
        compass_reference="T",
        taken_at=datetime(2026, 7, 1, 9, 0, 0),
        camera="Skyline Simulator",
    )
    write_photo(str(path), view.pixels, metadata)


def stem_of(row, taken):
    """Unique file name of a point: its photo's name, its name, or its number."""
    names = {name.lower(): name for name in row.feature.fields().names()}
    values = [row.feature[names[name]] for name in ("photo", "filename", "name") if name in names]
    stem = next((Path(str(value)).stem for value in values if not is_null(value)), f"photo_{row.feature.id()}")
    return unused_name(stem, taken)
