"""What a notebook shows of an oriented photograph: the overlay and one line of facts."""

from __future__ import annotations

import base64

from ..base.errors import MissingPackageError
from .overlay import overlay_image
from .raster import encode_jpeg
from .text import escape

WIDTH_PX = 720


def photo_html(photo):
    """Give the overlay of an `OrientedPhoto` with its facts below, as HTML; the facts alone without a picture."""
    facts = f"<div>{escape(repr(photo).strip('<>'), 2000)}</div>"
    if photo.preview is None:
        return facts
    try:
        picture = base64.b64encode(encode_jpeg(overlay_image(photo, WIDTH_PX))).decode("ascii")
    except MissingPackageError:
        return facts
    return f'<img src="data:image/jpeg;base64,{picture}" alt="Overlay" width="{WIDTH_PX}">{facts}'
