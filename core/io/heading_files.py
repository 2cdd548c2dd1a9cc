"""Headings as text for other programs: an XMP sidecar per photograph, KML with PhotoOverlays, and a CSV table.

The texts are made here and written elsewhere; nothing here touches a photograph.
"""

from __future__ import annotations

import csv
import io
import os
import zipfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

from ..base.angles import wrap_360

TOOLKIT = "Skyline Viewshed"
"""Marks a sidecar as ours, so that it may be replaced; those of other programs are left alone."""

NEAR_M = 50.0
"""Distance at which Google Earth draws the picture; nearer pictures flicker, farther ones hide the ground [m]."""

COLUMNS = (
    ("photo", None),
    ("longitude", 7),
    ("latitude", 7),
    ("elevation_m", 1),
    ("heading_deg", 2),
    ("heading_lo_deg", 2),
    ("heading_hi_deg", 2),
    ("pitch_deg", 2),
    ("roll_deg", 2),
    ("hfov_deg", 2),
    ("vfov_deg", 2),
    ("p_correct", 3),
    ("status", None),
)
"""Columns of the table, and their decimals."""


@dataclass(frozen=True)
class PhotoHeading:
    """What is known of one photograph's direction; None where unknown.

    Attributes
    ----------
    photo : str
        Path of the photograph.
    heading_deg : float
        Clockwise from true north [degrees].
    longitude, latitude : float or None
        WGS 84 [degrees].
    elevation_m : float or None
        Elevation of the camera [m].
    pitch_deg, roll_deg, hfov_deg, vfov_deg : float or None
        See docs/nomenclature.md [degrees].
    heading_lo_deg, heading_hi_deg, p_correct : float or None
    status : str or None
    """

    photo: str
    heading_deg: float
    longitude: float | None = None
    latitude: float | None = None
    elevation_m: float | None = None
    pitch_deg: float | None = None
    roll_deg: float | None = None
    hfov_deg: float | None = None
    vfov_deg: float | None = None
    heading_lo_deg: float | None = None
    heading_hi_deg: float | None = None
    p_correct: float | None = None
    status: str | None = None


def xmp_text(shot: PhotoHeading) -> str:
    """Compose the XMP sidecar of a photograph.

    The heading is EXIF's GPSImgDirection, against true north. `Camera` is Pix4D's namespace, whose pitch is 0 for a
    camera that looks straight down and 90 for one that looks at the horizon. Our own namespace has the pitch against
    the horizontal, the interval and the status.
    """
    heading = _rounded_heading(shot.heading_deg)
    tags = {
        "exif:GPSImgDirection": f"{round(heading * 100)}/100",
        "exif:GPSImgDirectionRef": "T",
        "Camera:Yaw": f"{heading:.2f}",
        "Camera:Pitch": None if shot.pitch_deg is None else f"{90 + shot.pitch_deg:.2f}",
        "Camera:Roll": _words(shot.roll_deg, 2),
        "skyline:Pitch": _words(shot.pitch_deg, 2),
        "skyline:HeadingLow": _words(shot.heading_lo_deg, 2),
        "skyline:HeadingHigh": _words(shot.heading_hi_deg, 2),
        "skyline:Status": shot.status,
    }
    attributes = "\n    ".join(f"{name}={quoteattr(value)}" for name, value in tags.items() if value is not None)
    return (
        '<?xpacket begin="\ufeff" id="W5M0MpCehiHzreSzNTczkc9d"?>\n'
        f'<x:xmpmeta xmlns:x="adobe:ns:meta/" x:xmptk="{TOOLKIT}">\n'
        ' <rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">\n'
        '  <rdf:Description rdf:about=""\n'
        '    xmlns:exif="http://ns.adobe.com/exif/1.0/"\n'
        '    xmlns:Camera="http://pix4d.com/camera/1.0/"\n'
        '    xmlns:skyline="https://github.com/skyline-viewshed/ns/1.0/"\n'
        f"    {attributes}/>\n"
        " </rdf:RDF>\n</x:xmpmeta>\n"
        '<?xpacket end="w"?>\n'
    )


def is_ours(sidecar: str | os.PathLike) -> bool:
    """Tell whether a sidecar may be replaced: it does not exist yet, or we wrote it; not if it cannot be read."""
    try:
        return f'x:xmptk="{TOOLKIT}"' in Path(sidecar).read_text(encoding="utf-8", errors="replace")
    except FileNotFoundError:
        return True
    except OSError:
        return False


def csv_text(shots: Iterable[PhotoHeading]) -> str:
    """Compose the table, with as many decimals as the values deserve."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([name for name, _ in COLUMNS])
    for shot in shots:
        row = []
        for name, decimals in COLUMNS:
            value = getattr(shot, name)
            if name == "heading_deg":
                value = _rounded_heading(value)
            row.append("" if value is None else value if decimals is None else f"{value:.{decimals}f}")
        writer.writerow(row)
    return text.getvalue()


def kml_text(shots: Sequence[PhotoHeading], hrefs: Sequence[str], title: str) -> str:
    """Compose a KML document with a PhotoOverlay for each photograph of known position.

    Parameters
    ----------
    shots : sequence of PhotoHeading
    hrefs : sequence of str
        Address of each photograph's picture, as the KML file sees it.
    title : str
        Name of the document.

    Returns
    -------
    str
    """
    overlays = [_overlay(shot, href) for shot, href in zip(shots, hrefs) if shot.longitude is not None]
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<kml xmlns="http://www.opengis.net/kml/2.2">\n'
        f"<Document>\n<name>{escape(title)}</name>\n{''.join(overlays)}</Document>\n</kml>\n"
    )


def _overlay(shot: PhotoHeading, href: str) -> str:
    """Compose one PhotoOverlay; KML's tilt is 90 at the horizon, its roll has our sense."""
    position = f"{shot.longitude:.7f},{shot.latitude:.7f},{shot.elevation_m or 0.0:.1f}"
    mode = "clampToGround" if shot.elevation_m is None else "absolute"
    across = (shot.hfov_deg or 60.0) / 2
    along = (shot.vfov_deg or 45.0) / 2
    about = [f"{_rounded_heading(shot.heading_deg):.1f}°", shot.status or ""]
    return (
        f"<PhotoOverlay>\n<name>{escape(Path(shot.photo).name)}</name>\n"
        f"<description>{escape(' '.join(about).strip())}</description>\n"
        f"<Camera><longitude>{shot.longitude:.7f}</longitude><latitude>{shot.latitude:.7f}</latitude>"
        f"<altitude>{shot.elevation_m or 0.0:.1f}</altitude>"
        f"<heading>{_rounded_heading(shot.heading_deg):.2f}</heading>"
        f"<tilt>{90 + (shot.pitch_deg or 0.0):.2f}</tilt><roll>{shot.roll_deg or 0.0:.2f}</roll>"
        f"<altitudeMode>{mode}</altitudeMode></Camera>\n"
        f"<Icon><href>{escape(href)}</href></Icon>\n"
        f"<ViewVolume><leftFov>{-across:.2f}</leftFov><rightFov>{across:.2f}</rightFov>"
        f"<bottomFov>{-along:.2f}</bottomFov><topFov>{along:.2f}</topFov><near>{NEAR_M:g}</near></ViewVolume>\n"
        f"<Point><altitudeMode>{mode}</altitudeMode><coordinates>{position}</coordinates></Point>\n"
        "<shape>rectangle</shape>\n</PhotoOverlay>\n"
    )


def kmz_bytes(kml: str, pictures: Iterable[tuple[str, bytes]]) -> bytes:
    """Pack a KML document and its JPEG pictures (name, bytes) into one file."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("doc.kml", kml)
        for name, data in pictures:
            archive.writestr(name, data, zipfile.ZIP_STORED)
    return packed.getvalue()


def _rounded_heading(heading_deg: float) -> float:
    """Give the heading with two decimals in [0, 360)."""
    return float(wrap_360(round(float(wrap_360(heading_deg)), 2)))


def _words(value: float | None, decimals: int) -> str | None:
    return None if value is None else f"{value:.{decimals}f}"
