"""Parameters that several algorithms share, each defined once: label, unit, range and tooltip."""

from __future__ import annotations

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterBand,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterDistance,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsUnitTypes,
)

from .i18n import tr
from .raster_parameter import RasterParameter

METHODS = ("robust", "paper")
COMPASS_USES = ("ignore", "prior")
SECTORS = ("photo frame", "heading wedge", "full circle")
CHOSEN_STATUSES = ("accepted", "confirmed", "ambiguous", "rejected")
"""Statuses that a later step can use; a photo that failed has no heading."""


def advanced(parameter):
    """Move a parameter below 'Advanced'.

    One with a default becomes optional too: QGIS calls a model invalid in which a mandatory parameter has no value, so
    each advanced parameter added later would break the models that users saved before.
    """
    flags = parameter.flags() | QgsProcessingParameterDefinition.Flag.FlagAdvanced
    if parameter.defaultValue() is not None and not parameter.isDestination():
        flags |= QgsProcessingParameterDefinition.Flag.FlagOptional
    parameter.setFlags(flags)
    return parameter


def explained(parameter, text):
    """Give a parameter its tooltip."""
    parameter.setHelp(text)
    return parameter


def photo_source(name="INPUT", optional=False):
    """Point layer of photographs."""
    return explained(
        QgsProcessingParameterFeatureSource(
            name, tr("Photo points"), [QgsProcessing.SourceType.TypeVectorPoint], optional=optional
        ),
        tr(
            "One point per photograph, in any coordinate system, for example from Import geotagged photos. "
            "The point is the camera's position. If a point has no geometry, the position recorded in the "
            "photograph is used."
        ),
    )


def photo_field(parent="INPUT", name="PHOTO_FIELD"):
    """Field with the photograph's path."""
    return explained(
        QgsProcessingParameterField(
            name,
            tr("Field with the photo's path"),
            "photo",
            parent,
            QgsProcessingParameterField.DataType.String,
            optional=True,
        ),
        tr("Full path of the photograph; a relative path counts from the layer's or the project's folder."),
    )


def number_field(name, label, text, default=None, parent="INPUT"):
    """Optional numeric field; NULL means that no value is given."""
    return explained(
        QgsProcessingParameterField(
            name, label, default, parent, QgsProcessingParameterField.DataType.Numeric, optional=True
        ),
        text,
    )


def dem(name="DEM"):
    """Elevation model."""
    return explained(
        RasterParameter(name, tr("Elevation model (DEM)")),
        tr(
            "Any raster with heights in metres and a coordinate system, projected or geographic. It should "
            "extend to the mountains that are visible."
        ),
    )


def band(name="BAND", parent="DEM"):
    """Band of the elevation model."""
    return explained(
        advanced(QgsProcessingParameterBand(name, tr("DEM band"), 1, parent, True)), tr("Band that holds the heights.")
    )


def dem_units():
    """Units of a DEM's heights, as the core calls them (None: that of the file) and as the user sees them."""
    return (
        (None, tr("as the file says")),
        ("metres", tr("metres")),
        ("feet", tr("feet (0.3048 m)")),
        ("us-ft", tr("US survey feet")),
        ("decimetres", tr("decimetres")),
        ("centimetres", tr("centimetres")),
        ("millimetres", tr("millimetres")),
        ("kilometres", tr("kilometres")),
    )


def dem_unit(name="DEM_UNIT"):
    """Choice of the unit of the heights."""
    parameter = QgsProcessingParameterEnum(
        name, tr("Unit of the heights"), [label for _, label in dem_units()], defaultValue=0, optional=True
    )
    text = tr(
        "Unit of the heights in the elevation model. Many files in feet or decimetres do not say so; without any unit "
        "in the file, metres are assumed."
    )
    return explained(advanced(parameter), text)


def horizon_distance_text():
    """Tooltip of the search range of a skyline."""
    return tr(
        "Maximum distance of the mountains on the skyline, in metres on the ground. The paper method uses at "
        "most 15 km."
    )


def method(name="METHOD", text=None):
    """Choice of the robust solver or the published method."""
    return explained(
        QgsProcessingParameterEnum(
            name, tr("Method"), [tr("robust"), tr("paper (as published)")], defaultValue=METHODS.index("robust")
        ),
        text
        or tr(
            "Robust: exact camera geometry, a search over all headings, and an error bar. Paper: the "
            "published correlation of skylines on a flat earth, for comparison; it does not use the "
            "compass, hints, landmarks, drawn skylines or masks."
        ),
    )


def compass(tested=True):
    """Choice whether the recorded heading may be used; `tested` if a sample tests the compass of each camera."""
    uses = [tr("ignore"), tr("use as a hint")]
    text = tr(
        "Ignore: the heading is found without the compass. Hint: the compass heading is a prior, wide "
        "enough for the usual errors of phones; a clear skyline overrules it."
    )
    if tested:
        text = tr(
            "Ignore: no reading counts by itself; photos of a walk that are oriented together still compare their "
            "readings, which alone gives no heading. Hint: the compass heading is a prior, wide enough for the usual "
            "errors of phones; a clear skyline overrules it. If a camera has four or more photos, a sample of them is "
            "oriented first; if its compass often contradicts the skylines, it counts for less."
        )
    parameter = QgsProcessingParameterEnum(
        "COMPASS", tr("Recorded compass heading"), uses, defaultValue=COMPASS_USES.index("ignore")
    )
    return explained(parameter, text)


def distance(name, label, default, text, minimum=0.0, optional=False):
    """Length in metres, whatever the layers' CRS."""
    parameter = QgsProcessingParameterDistance(name, label, default, None, optional, minimum)
    parameter.setDefaultUnit(QgsUnitTypes.DistanceUnit.DistanceMeters)
    return explained(parameter, text)


def number(name, label, default, text, minimum=None, maximum=None, optional=False, integer=False):
    """Plain number."""
    kind = QgsProcessingParameterNumber.Type.Integer if integer else QgsProcessingParameterNumber.Type.Double
    parameter = QgsProcessingParameterNumber(name, label, kind, default, optional)
    if minimum is not None:
        parameter.setMinimum(minimum)
    if maximum is not None:
        parameter.setMaximum(maximum)
    return explained(parameter, text)


def eye_height(default=1.7):
    """Height of the camera above the ground."""
    return distance(
        "EYE_HEIGHT", tr("Camera height above ground (m)"), default, tr("Metres above the elevation model.")
    )


def max_distance(default, text=None):
    """Range of the search or of the viewshed."""
    text = text or tr("Distance from the camera in metres on the ground. Terrain beyond is ignored.")
    return distance("MAX_DISTANCE", tr("Maximum distance (m)"), default, text, minimum=1.0)


def refraction(default):
    """Refraction coefficient."""
    return number(
        "REFRACTION",
        tr("Refraction coefficient"),
        default,
        tr(
            "Share of the earth's curvature that refraction compensates; 0.13 is usual. The curvature "
            "itself is always applied."
        ),
        minimum=0.0,
        maximum=0.99,
    )


def sector(name="SECTOR"):
    """Choice of the directions that the viewshed covers."""
    return explained(
        QgsProcessingParameterEnum(
            name,
            tr("Area"),
            [tr("photo frame"), tr("heading wedge"), tr("full circle")],
            defaultValue=SECTORS.index("photo frame"),
        ),
        tr(
            "Photo frame: ground inside the picture, with pitch, roll and both fields of view. Heading wedge: all "
            "ground within the horizontal field of view. Full circle: all that can be seen from the place."
        ),
    )


def statuses(name="STATUSES"):
    """Choice of the oriented photographs that a later step uses; see `statuses.relied_on`."""
    words = [tr("accepted"), tr("confirmed"), tr("ambiguous"), tr("rejected")]
    reliable = [CHOSEN_STATUSES.index(status) for status in ("accepted", "confirmed")]
    return explained(
        advanced(
            QgsProcessingParameterEnum(
                name, tr("Photos by status"), words, allowMultiple=True, defaultValue=reliable, optional=True
            )
        ),
        tr(
            "Photos whose field status has one of these values are used; the log counts those that are left out. "
            "Photos of a layer without this field are all used."
        ),
    )


def points_out(name, label, kind=QgsProcessing.SourceType.TypeVectorPoint, optional=False, create=True, *, text):
    """Vector output."""
    parameter = QgsProcessingParameterFeatureSink(name, label, kind, optional=optional)
    parameter.setCreateByDefault(create)
    return explained(parameter, text)


def raster_out(name, label, optional=False, create=True, *, text):
    """Raster output."""
    parameter = QgsProcessingParameterRasterDestination(name, label, optional=optional)
    parameter.setCreateByDefault(create)
    return explained(parameter, text)


def report_out(name="REPORT", create=True):
    """HTML report, which opens from the results viewer."""
    parameter = QgsProcessingParameterFileDestination(
        name, tr("Report"), tr("HTML files (*.html)"), optional=True, createByDefault=create
    )
    return explained(
        parameter,
        tr(
            "One self-contained HTML file with figures, numbers and advice for each photo or point. From 201 photos "
            "on, the file is an index with a map, filters and thumbnails, and the cards are pages in a folder "
            "beside it."
        ),
    )


def folder_out(name, label, text, optional=True, create=False):
    """Folder of files."""
    parameter = QgsProcessingParameterFolderDestination(name, label, optional=optional, createByDefault=create)
    return explained(parameter, text)


def folder_in(name, label, text, optional=False):
    """Folder that is read."""
    return explained(
        QgsProcessingParameterFile(name, label, QgsProcessingParameterFile.Behavior.Folder, optional=optional),
        text,
    )
