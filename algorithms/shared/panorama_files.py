"""Panorama drawings of a run: names and photo frames of each point, then PNG and SVG."""

from __future__ import annotations

from pathlib import Path

from ...core.base.camera import Camera, Pose
from ...core.base.posed import PosedPhoto
from .i18n import marked, tr
from .outputs import write_whole
from .photo_points import PoseReading, photo_point, pose_values
from .picture_files import PictureFolder, warn_unreadable

SAME_PLACE_M = 100.0
"""Photos taken within this distance of a point are shown in its panorama."""


class PanoramaFolder:
    """Draws and writes panoramas.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`.
    terrain : core.io.raster.Dem
    summits : Summitry
    photos : list of PointRow
        Photos whose frames are drawn where they were taken.
    """

    def __init__(self, algorithm, parameters, context, terrain, summits, photos):
        self.path = Path(algorithm.parameterAsString(parameters, "FOLDER", context))
        self.terrain, self.summits, self.count = terrain, summits, 0
        self._names, self._feedback = PictureFolder(str(self.path)), context.feedback()
        self._layout = {
            "left_deg": algorithm.parameterAsDouble(parameters, "LEFT", context),
            "pixels_per_degree": algorithm.parameterAsDouble(parameters, "SCALE", context),
            "exaggeration": algorithm.parameterAsDouble(parameters, "EXAGGERATION", context),
        }
        self.photos = photos

    def write(self, row, observer, panorama, options):
        """Write one point's panorama and return the view all around from which it is drawn."""
        from ...core.base.view import open_view
        from ...core.figures.panorama import PanoramaLayout, lay_out_panorama, panorama_pixels, panorama_svg
        from ...core.figures.raster import encode_png

        anywhere = PosedPhoto(Camera(1, 1, 1.0), Pose(0.0), observer)
        view = open_view(self.terrain, anywhere, options.max_distance_m, options.refraction_coefficient)
        layout = PanoramaLayout(**self._layout)
        labels, frames = self._labels(view, options), self._frames(view)
        drawing = lay_out_panorama(panorama, labels, frames, layout, marked)
        if self._feedback is not None:
            warn_unreadable(self._feedback, row.name, [label.words for label in labels] + [f.words for f in frames])
        stem = self._names.stem(f"{tr('panorama')}_{row.feature.id()}.png")
        write_whole(self.path / f"{stem}.png", encode_png(panorama_pixels(drawing), quickly=True))
        write_whole(self.path / f"{stem}.svg", panorama_svg(drawing, row.name))
        self.count += 1
        return view

    def _labels(self, view, options):
        from ...core.figures.panorama import PanoramaLabel
        from ...core.mapping.sightline import SightOptions

        sight = SightOptions(
            max_distance_m=options.max_distance_m, refraction_coefficient=options.refraction_coefficient
        )
        shown = self.summits.shown(view, sight, all_round=True)
        return [
            PanoramaLabel(summit.mark.words, summit.azimuth_deg, summit.elevation_deg)
            for summit in shown
            if summit.visible
        ]

    def _frames(self, view):
        from ...core.base.camera import unproject
        from ...core.base.view import outline_px
        from ...core.figures.panorama import PanoramaFrame

        frames = []
        for row in self.photos:
            posed = photo_point(row, pose_values(row.feature), PoseReading(level=True)).posed
            if posed is None or not self._near(view, posed.observer):
                continue
            name = row.feature["photo"] if row.feature.fields().lookupField("photo") >= 0 else row.name
            outline = unproject(posed.camera, posed.pose, *outline_px(posed.camera))
            frames.append(PanoramaFrame(Path(str(name)).stem, *outline))
        return frames

    def _near(self, view, observer):
        east, north = view.frame.to_local(*self.terrain.pixel_of(observer.longitude_deg, observer.latitude_deg))
        return float(east) ** 2 + float(north) ** 2 <= SAME_PLACE_M**2
