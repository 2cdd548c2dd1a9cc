"""What the core says when something is wrong, in the user's language.

The core knows no Qt and speaks English. Its sentences stand here as templates for the translator;
`tests/test_translations.py` holds them to the core's source.
"""

from __future__ import annotations

import re
from functools import lru_cache

from .i18n import mark, marked

SENTENCES = (
    mark("GPS position"),
    mark("focal length (35 mm equivalent)"),
    mark("Give it by the geometry of a photo point layer."),
    mark("Give the horizontal field of view in HFOV_FIELD."),
    mark("Give its fields of view in HFOV_FIELD."),
    mark(
        "Writing words into pictures needs a TrueType font, and none of DejaVu Sans, Arial, Liberation Sans or "
        "Helvetica is installed. Install one, for instance the package fonts-dejavu-core, or a newer Pillow."
    ),
    mark("The photo {a} cannot be read: {b}"),
    mark("The photo has no {a}. {b}"),
    mark("No boundary between sky and terrain was found."),
    mark("{a} Use a photo that shows a mountain skyline, or supply a sky mask or a drawn skyline."),
    mark(
        "The position {a}, {b} (latitude, longitude) lies outside the DEM. Use a DEM that covers it, or correct the "
        "photo's coordinates."
    ),
    mark(
        "The DEM has no elevation (nodata) at {a}, {b} (latitude, longitude). Fill the void, use another DEM, or give "
        "the eye's elevation in HEIGHT_FIELD."
    ),
    mark("The image features {a} cannot be read: {b}"),
    mark("The coordinate reference system {a} is not understood. Assign a valid one."),
    mark("No transformation is known from {a} to {b}."),
    mark("it is none of LabelMe, COCO, VIA or GeoJSON. Export it in one of these, or as CSV with photo, x, y."),
    mark("it has no columns x and y (pixels). Name them so, and photo for the file."),
    mark("it is larger than 200 MB. Split it by photograph."),
    mark("it is no text in UTF-8. Export it as JSON or CSV."),
    mark("it cannot be opened ({a})."),
    mark("it is no valid JSON. Export it again."),
    mark("line {a} has no numbers for x and y."),
    mark("line {a} is incomplete ({b})."),
    mark("an entry is incomplete ({a})."),
    mark("its content is no JPEG, HEIC, PNG, TIFF or WebP picture. Export it as JPEG."),
    mark("the file is empty. Copy it again from its source."),
    mark("it has no pixels. Copy it again from its source."),
    mark("its {a} x {b} pixels are more than {c} megapixels. Reduce the picture first."),
    mark("it ends too early or its directory is damaged. Copy it again from its source."),
    mark("it is a folder or a device, not a file."),
    mark("there is no such file. Check the path."),
    mark("The recorded coordinates are not numbers (no GPS fix) and were ignored."),
    mark("The recorded coordinates lie outside the globe and were ignored."),
    mark("The recorded coordinates are 0, 0 (no GPS fix) and were ignored."),
    mark("The hemisphere is not recorded; north and east were assumed where it is missing."),
    mark("The 35 mm equivalent was derived from the focal length and the focal plane resolution."),
    mark(
        "The picture is a part of what the camera took: a 35 mm equivalent of {a} mm was used instead of {b} mm. Give "
        "the horizontal field of view in HFOV_FIELD where it is known better."
    ),
    mark("The folder {a} cannot be listed: {b}. Check the path."),
    mark("it is too large for this computer's memory. Reduce the picture."),
    mark("The DEM {a} is not a raster that GDAL can read. Choose an elevation raster."),
    mark("The DEM {a} has {b} band(s), and no band {c}."),
    mark("Band {a} of {b} holds complex numbers, not elevations."),
    mark("The DEM {a} has no coordinate reference system on the Earth. Assign the right one (gdal_edit -a_srs)."),
    mark("The DEM {a} is not georeferenced. Warp it to a CRS first (gdalwarp)."),
    mark("The DEM {a} is rotated against its CRS. Warp it upright first (gdalwarp)."),
    mark("The DEM {a} does not exist. Check the path."),
    mark("The DEM {a} cannot be placed. {b}"),
    mark("The DEM {a} is damaged ({b}). Copy it again."),
    mark("Band {a} of the DEM {b} has no valid cell. Choose another DEM."),
    mark("The file {a} cannot be written: {b}. Choose another folder or free some space."),
    mark("nothing was written"),
    mark("The photo {a} cannot be written: name it .jpg or .heic."),
    mark("The photo {a} cannot be written: {b}. Choose another folder or free some space."),
    mark(
        "The line that stands out most is a near crest by the DEM; the fainter line behind it was taken for the "
        "skyline."
    ),
    mark("Landmark {a} is met to within {b}."),
    mark("{a} pixels"),
    mark("{a} degrees"),
    mark("The recorded altitude lies {a} m {b} the DEM's surface; the DEM was used."),
    mark("The recorded altitude lies {a} m {b} the DEM's surface and was used."),
    mark("The recorded altitude counts from the ellipsoid and not from the sea; the DEM was used."),
    mark("above"),
    mark("below"),
    mark(
        "In {a} % of the frame the DEM ends or has voids before higher terrain can be excluded; a larger DEM would "
        "make the heading surer."
    ),
    mark(
        "Hardly any column of the picture shows a boundary between sky and terrain. Use a photo with a skyline, or "
        "supply a sky mask or a drawn skyline."
    ),
    mark("The DEM has no terrain around this position. Use a DEM that reaches farther."),
    mark(
        "A skyline was found in only {a} % of the columns. Use a photo that shows more of the skyline, or supply a sky "
        "mask or a drawn skyline."
    ),
    mark("The paper's method does not test its answer: compare the overlay, or use the robust method."),
    mark("The skyline or the DEM's horizon is a straight line, which cannot be matched."),
    mark("The fit is weak. Look at the overlay; an approximate heading, a landmark or a sky mask would decide it."),
    mark("The horizon is almost straight here, which fits many headings. Give an approximate heading or a landmark."),
    mark("The horizon fits along {a} % of the columns, and no other heading comes near."),
    mark(
        "No heading explains the skyline. Check position and field of view, or give a sky mask, a drawn skyline, a "
        "landmark or an approximate heading."
    ),
    mark("{a} fits nearly as well. Compare the overlays, or give an approximate heading or a landmark."),
    mark("{a} needs the Python package {b}. {c}"),
    mark("The picture is only {a} x {b} pixels."),
    mark("The picture has a single colour."),
    mark("The drawn skyline has fewer than two points."),
    mark("The supplied skyline or sky mask has no change from sky to terrain."),
    mark("The picture has no smooth region above a rough one."),
    mark("The DEM's coordinate system folds sight lines here; use a projected one such as UTM."),
    mark(
        "The DEM's coordinate system bends sight lines too strongly here (close to a pole of its grid). Use a DEM in "
        "a projected coordinate system, such as UTM or polar stereographic."
    ),
)
"""Sentences, and parts of them, with names in braces for what varies."""


@lru_cache(maxsize=1)
def _patterns():
    """Each template as a regular expression; the ones with most fixed text come first."""
    found = []
    for template in sorted(SENTENCES, key=lambda text: -len(re.sub(r"\{\w\}", "", text))):
        pattern = re.sub(r"\\\{(\w)\\\}", r"(?P<\1>.+)", re.escape(template))
        found.append((re.compile(pattern, re.DOTALL), template))
    return found


def in_users_language(sentence):
    """A sentence of the core in the user's language; unchanged where no template fits it."""
    for pattern, template in _patterns():
        match = pattern.fullmatch(sentence)
        if match:
            parts = {name: in_users_language(part) for name, part in match.groupdict().items()}
            return marked(template).format(**parts)
    return sentence
