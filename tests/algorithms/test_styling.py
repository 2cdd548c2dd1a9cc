"""How outputs look when QGIS loads them: each style of a raster fits the values that it is for."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from qgis.core import QgsProcessingContext, QgsProject, QgsRasterLayer
from qgis.PyQt.QtGui import QColor
from skyline_viewshed.algorithms.shared.styling import STYLES, dress_file, style_on_completion
from skyline_viewshed.core.base.status import STATUSES
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.viewshed_raster import LayerStack, write_layers

pytestmark = pytest.mark.qgis


@pytest.fixture
def dressed(scene, tmp_path):
    """Make a raster of the given bands in a folder, dress it, and load it as a user does."""

    def make(style, *bands):
        dem, window = open_dem(str(scene.dem)), Window(10, 20, *np.shape(bands[0]))
        path, names = tmp_path / "a.b.tif", {f"band {number}": "m" for number in range(len(bands))}
        layers = LayerStack(names, [(window, [np.float32(band) for band in bands])])
        write_layers(str(path), dem, window, layers, "mark")
        dress_file(str(path), style)
        layer = QgsRasterLayer(str(path), "dressed")
        assert layer.isValid()
        return layer

    return make


def colour_of(layer):
    """Function that gives the colour of a value; it keeps the layer alive, to which the ramp belongs."""

    def colour(value):
        shaded, *rgba = layer.renderer().shader().rasterShaderFunction().shade(value)
        assert shaded, value
        return QColor(*rgba)

    return colour


def legend(layer):
    return [item.label for item in layer.renderer().shader().rasterShaderFunction().colorRampItemList()]


def test_ground_that_surely_is_not_shown_is_transparent_and_colours_deepen(dressed):
    layer = dressed("probability", [[0.0, 0.5, 1.0, np.nan]])
    colour = colour_of(layer)
    assert colour(0.0).alpha() == 0
    chances = [colour(value) for value in np.linspace(0.1, 1, 10)]
    assert [c.alpha() for c in chances] == sorted(c.alpha() for c in chances) and chances[-1].alpha() == 255
    light = [c.lightness() for c in chances]
    assert light == sorted(light, reverse=True)
    assert legend(layer) == ["0", "0.1", "0.5", "0.9", "1"]


def test_layers_show_the_height_above_the_line_of_sight_in_two_hues(dressed):
    bands = [[[5.0, 6.0]], [[1.0, 2.0]], [[-3.0, 9999.0]], [[1.0, 2.0]], [[1.0, 2.0]]]
    for count in (3, 5):  # without a pose there are three
        layer = dressed("layers", *bands[:count])
        assert layer.renderer().band() == 3
        colour = colour_of(layer)
        for low, high in ((-0.01, 0.0), (-150, 3), (-5000, 9999)):
            hidden, seen = colour(low), colour(high)
            assert hidden.blue() >= hidden.red() and seen.red() > seen.blue(), (low, high)
        assert all("seen" in label or "hidden" in label for label in legend(layer))
        assert [label for label in legend(layer) if re.search(r"\d", label) and " m" not in label] == []


def test_the_sky_s_colours_go_from_dark_to_light_over_the_whole_range(dressed):
    colour = colour_of(dressed("sky_view", [[0.0, 1.0]]))
    light = [colour(value).lightness() for value in np.linspace(0, 1, 21)]
    assert light == sorted(light) and light[0] < 40 and light[-1] > 220
    assert light[-1] - light[14] > 60, "most ground sees more than 0.7"


def test_one_photo_s_raster_shows_what_is_seen(dressed):
    layer = dressed("seen", [[0.0, 1.0]])
    colour = colour_of(layer)
    assert colour(0.0).alpha() == 0 and colour(1.0).alpha() == 255 and legend(layer) == ["not seen", "seen"]


def test_a_style_of_the_user_s_own_stays(tmp_path):
    (tmp_path / "a.qml").write_text("mine")
    dress_file(str(tmp_path / "a.tif"), "seen")
    assert (tmp_path / "a.qml").read_text() == "mine"
    dress_file(str(tmp_path / "b.tif"), "seen")
    assert (tmp_path / "b.qml").read_text(encoding="utf-8") == (STYLES / "seen.qml").read_text(encoding="utf-8")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.qml", "b.qml"]


def test_a_style_that_cannot_be_written_is_an_error_in_words(tmp_path):
    from skyline_viewshed.core.base.errors import OutputError

    (tmp_path / "file").write_text("no folder")
    with pytest.raises(OutputError, match="cannot be written"):
        dress_file(str(tmp_path / "file" / "a.tif"), "seen")


def test_the_sky_view_raster_is_dressed_when_it_is_loaded(dressed, scene):
    layer, context = dressed("seen", [[0.25, 1.0]]), QgsProcessingContext()
    path, details = layer.source(), QgsProcessingContext.LayerDetails("sky", QgsProject.instance(), "SKY_VIEW")
    context.addLayerToLoadOnCompletion(path, details)
    style_on_completion(context, path, "sky_view", "Sky view factor")
    context.layerToLoadOnCompletionDetails(path).postProcessor().postProcessLayer(layer, context, None)
    assert legend(layer)[0] == "0" and len(legend(layer)) == 6


def test_styles_have_classes_at_their_ends_as_the_dialog_of_symbology_shows_them():
    for path in STYLES.glob("*.qml"):
        for end in re.findall(r'classificationM(?:in|ax)="([^"]*)"', path.read_text(encoding="utf-8")):
            assert math.isfinite(float(end)), path.name


def test_the_style_of_oriented_photos_has_a_colour_for_each_status():
    text = (STYLES / "oriented.qml").read_text(encoding="utf-8")
    categories = [dict(re.findall(r'(\w+)="([^"]*)"', found)) for found in re.findall(r"<category ([^>]*)/>", text)]
    assert [category["value"] for category in categories] == list(STATUSES)
    assert len({category["symbol"] for category in categories}) == len(STATUSES)
