"""Panorama drawings of a run: names and photo frames of each point, then PNG and SVG."""

from __future__ import annotations

from pathlib import Path

from ...core.base.camera import Camera, Pose, focal_of_fov_px
from .fields import is_null
from .i18n import marked, tr
from .layers import read_points
from .outputs import write_whole
from .picture_files import PictureFolder
from .views import value_of

SAME_PLACE_M = 100.0
"""Photos taken this near to a point are shown in its panorama."""


class PanoramaFolder:
    """Draws and writes panoramas.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`.
    terrain : core.io.raster.Dem
    summits : Summitry
    """

    def __init__(self, algorithm, parameters, context, terrain, summits):
        self.path = Path(algorithm.parameterAsString(parameters, "FOLDER", context))
        self.terrain, self.summits, self.count = terrain, summits, 0
        self._names = PictureFolder(str(self.path))
        self._layout = {
            "left_deg": algorithm.parameterAsDouble(parameters, "LEFT", context),
            "pixels_per_degree": algorithm.parameterAsDouble(parameters, "SCALE", context),
            "exaggeration": algorithm.parameterAsDouble(parameters, "EXAGGERATION", context),
        }
        self.photos = []
        if not is_null(parameters.get("PHOTOS")):
            self.photos = read_points(algorithm, parameters, context, "PHOTOS")[1]

    def write(self, row, observer, panorama, options):
        """Write one point's panorama; gives the view all round that it is drawn from."""
        from ...core.base.view import open_view
        from ...core.figures.panorama import lay_out_panorama, panorama_pixels, panorama_svg
        from ...core.figures.raster import encode_png

        view = open_view(
            self.terrain, observer, Camera(1, 1, 1.0), Pose(0.0), options.max_distance_m,
            options.refraction_coefficient,
        )  # fmt: skip
        drawing = lay_out_panorama(
            panorama, self._labels(view, options), self._frames(view), **self._layout, say=marked
        )
        stem = self._names.stem(f"{tr('panorama')}_{row.feature.id()}.png")
        write_whole(self.path / f"{stem}.png", encode_png(panorama_pixels(drawing), quickly=True))
        write_whole(self.path / f"{stem}.svg", panorama_svg(drawing, row.name))
        self.count += 1
        return view

    def _labels(self, view, options):
        from ...core.figures.panorama import PanoramaLabel
        from ...core.mapping.sightline import SightOptions
        from .views import PhotoView

        sight = SightOptions(
            max_distance_m=options.max_distance_m, refraction_coefficient=options.refraction_coefficient
        )
        place = PhotoView(None, "", None, view, None, self.terrain, False, None)
        shown = self.summits.shown(place, sight, all_round=True)
        return [
            PanoramaLabel(summit.mark.words, summit.azimuth_deg, summit.elevation_deg)
            for summit in shown
            if summit.visible
        ]

    def _frames(self, view):
        from ...core.base.view import outline_px
        from ...core.figures.panorama import PanoramaFrame

        frames = []
        for photo in self.photos:
            camera, pose = _camera_of(photo.feature), _pose_of(photo.feature)
            if camera is None or pose is None or photo.longitude_deg is None or not self._near(view, photo):
                continue
            from ...core.base.camera import unproject

            name = photo.feature["photo"] if photo.feature.fields().lookupField("photo") >= 0 else photo.name
            frames.append(PanoramaFrame(Path(str(name)).stem, *unproject(camera, pose, *outline_px(camera))))
        return frames

    def _near(self, view, photo):
        east, north = view.frame.to_local(*self.terrain.pixel_of(photo.longitude_deg, photo.latitude_deg))
        return float(east) ** 2 + float(north) ** 2 <= SAME_PLACE_M**2


def _camera_of(feature):
    hfov, vfov = value_of(feature, "hfov"), value_of(feature, "vfov")
    if hfov is None or not 0 < hfov < 180:
        return None
    focal = focal_of_fov_px(4000, hfov)
    height = 3000 if vfov is None or not 0 < vfov < 180 else focal / focal_of_fov_px(1.0, vfov)
    return Camera(4000, max(round(height), 1), focal)


def _pose_of(feature):
    heading = value_of(feature, "heading")
    if heading is None:
        return None
    return Pose(heading, value_of(feature, "pitch") or 0.0, value_of(feature, "roll") or 0.0)
