"""Annotated pictures of a run: one PNG and one SVG per photo, each complete or absent."""

from __future__ import annotations

from pathlib import Path

from ...core.base.errors import MissingPackageError, PhotoError
from ...core.io.whole_file import unused_name
from .feedback import warn
from .i18n import marked, tr
from .outputs import write_whole

PREVIEW_PX = 1600


class PictureFolder:
    """Folder of annotated pictures; does nothing if none are requested.

    Parameters
    ----------
    folder : str
        Empty for none.
    """

    def __init__(self, folder):
        self.folder, self.count, self._taken = Path(folder) if folder else None, 0, set()

    def stem(self, name):
        """File name without suffix, not used before in this folder."""
        stem = "".join(c if c.isalnum() or c in "-_. " else "_" for c in Path(name).stem) or "photo"
        return unused_name(stem, self._taken)

    def annotate(self, photo, points, strokes, feedback):
        """Write one photo with its marks; a photo that cannot be read or drawn gets a warning."""
        if self.folder is None:
            return
        from ...core.figures.annotate import annotate, annotation_pixels, annotation_svg
        from ...core.figures.raster import encode_png
        from ...core.io.photo import read_photo

        if not photo.path:
            warn(feedback, photo.name, tr("The point names no photo, so there is no picture to draw on."))
            return
        try:
            picture = read_photo(photo.path, PREVIEW_PX)
            drawn = annotate(picture.pixels, picture.metadata.width_px, points, strokes)
            stem = self.stem(photo.name)
            write_whole(self.folder / f"{stem}.png", encode_png(annotation_pixels(drawn), quickly=True))
            write_whole(self.folder / f"{stem}.svg", annotation_svg(drawn, marked))
            self.count += 1
            warn_unreadable(feedback, photo.name, [point.words for point in points])
        except (PhotoError, MissingPackageError) as error:
            warn(feedback, photo.name, error.message)


def warn_unreadable(feedback, picture, names):
    """Warn of names with characters that no installed font has."""
    from ...core.figures.fonts import missing_characters

    unreadable = [name for name in names if missing_characters(name)]
    if unreadable:
        text = tr(
            "No installed font has all characters of {names}, so the PNG shows boxes; the SVG is right. Install a font "
            "for this script, for example a Noto Sans, and run again."
        )
        shown = ", ".join(unreadable[:5]) + (" ..." if len(unreadable) > 5 else "")
        warn(feedback, picture, text.format(names=shown))
