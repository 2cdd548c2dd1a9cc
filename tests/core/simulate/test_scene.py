from __future__ import annotations

import pytest
from skyline_viewshed.core.simulate.scene import SceneOptions


@pytest.mark.parametrize(
    "wrong", [{"clouds": "rain"}, {"foreground": "cows"}, {"range_m": 0}, {"noise": -1}, {"cloud_share": 2}]
)
def test_senseless_options_are_refused(wrong):
    with pytest.raises(ValueError, match="must"):
        SceneOptions(**wrong)
