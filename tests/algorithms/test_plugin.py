"""What the desktop shows after the plugin is enabled: a button, a menu entry, and once a message."""

from __future__ import annotations

from unittest.mock import MagicMock

import pytest
from qgis.core import QgsSettings

pytestmark = pytest.mark.qgis


@pytest.fixture
def desktop(provider, monkeypatch):
    """The plugin in a desktop that records what it is asked for; the provider is that of the whole session."""
    from skyline_viewshed import classFactory
    from skyline_viewshed.plugin import GREETED

    QgsSettings().remove(GREETED)
    iface = MagicMock()
    iface.mainWindow.return_value = None
    plugin = classFactory(iface)
    monkeypatch.setattr(plugin, "initProcessing", lambda: setattr(plugin, "provider", provider))
    yield iface, plugin
    QgsSettings().remove(GREETED)


def test_a_button_a_menu_entry_and_one_message_say_where_to_begin(desktop):
    iface, plugin = desktop
    for _ in range(2):
        plugin.initGui()
        buttons = [call.args[0] for call in iface.addToolBarIcon.call_args_list[-2:]]
        assert [button.text() for button in buttons] == ["Photos to viewsheds", "Photo view"]
        assert not any(button.icon().isNull() for button in buttons)
        menu = [call.args for call in iface.addPluginToMenu.call_args_list[-2:]]
        assert menu == [("Skyline Viewshed", button) for button in buttons]
        plugin.provider = None
        plugin.unload()
        for button in buttons:
            iface.removeToolBarIcon.assert_any_call(button)
            iface.removePluginMenu.assert_any_call("Skyline Viewshed", button)
    (call,) = iface.messageBar.return_value.pushMessage.call_args_list
    assert "toolbox" in call.args[1]


def test_the_button_opens_the_dialog_that_does_everything(desktop, monkeypatch):
    from qgis import processing

    _, plugin = desktop
    opened = MagicMock()
    monkeypatch.setattr(processing, "createAlgorithmDialog", opened)
    plugin.initGui()
    plugin.start.trigger()
    assert opened.call_args.args[0] == "skylineviewshed:photoviewshed"
    opened.return_value.show.assert_called_once()
    plugin.provider = None
    plugin.unload()
