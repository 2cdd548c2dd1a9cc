from dataclasses import dataclass, replace

import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.match.refine import RefineOptions, refine
from skyline_viewshed.core.match.turn import TurnOptions, _peak, turn


@dataclass(frozen=True)
class Ground:
    """Inner evidence that likes one heading: a parabola of a given height, 0 beyond its width."""

    heading_deg: float
    height: float
    width_deg: float = 2.0

    def score(self, trials):
        off = difference(trials[:, 0], self.heading_deg) / self.width_deg
        return self.height * np.maximum(1 - np.square(off), 0.0)


@pytest.fixture(scope="module")
def objective(match_scenes):
    return match_scenes.scene(6, 200.0, 2.0, 1.0).objective(options=RefineOptions(iterations=12))


@pytest.fixture(scope="module")
def fitted(objective):
    trials, _ = refine(objective, np.array([[200.5, 2.5, 0.5, 0.0, 0.0]]), 3.0)
    trials, _ = refine(objective, trials, 1.0)
    return trials[0]


def test_ground_without_a_word_leaves_the_answer_alone(objective, fitted):
    trial = turn(objective, Ground(200.0, 0.0), fitted, 1.0)
    assert trial[0] == pytest.approx(fitted[0], abs=0.05)
    assert objective.score(trial[None], 1.0)[0] >= objective.score(fitted[None], 1.0)[0] - 1e-12


@pytest.mark.parametrize("side_deg", [-0.9, 0.9])
def test_strong_ground_draws_the_answer_to_its_side(objective, fitted, side_deg):
    weak = turn(objective, Ground(200.0 + side_deg, 0.3), fitted, 3.0)
    strong = turn(objective, Ground(200.0 + side_deg, 60.0), fitted, 3.0)
    assert 0 <= np.sign(side_deg) * (weak[0] - fitted[0]) < abs(side_deg)
    assert strong[0] == pytest.approx(200.0 + side_deg, abs=0.06)


def test_the_share_tells_how_far(objective, fitted):
    moved = [turn(objective, Ground(200.9, 1.0), fitted, 3.0, TurnOptions(share=share))[0] for share in (0.0, 0.5, 1.0)]
    assert moved[0] == pytest.approx(fitted[0], abs=0.05)
    assert moved[0] <= moved[1] + 1e-6 <= moved[2] + 2e-6
    assert moved[2] > moved[0]


def test_the_turn_ends_at_its_reach(objective, fitted):
    trial = turn(objective, Ground(204.0, 1e3, 6.0), fitted, 3.0, TurnOptions(reach_deg=1.0, step_deg=0.25))
    assert trial[0] == pytest.approx(fitted[0] + 1.0, abs=1e-6)


def test_the_parabola_finds_a_top_between_the_steps():
    x = np.arange(-3, 4)
    assert _peak(-np.square(x - 0.3)) == pytest.approx(0.3)
    assert _peak(np.arange(5.0)) == 0, "at the edge there is no parabola"
    assert _peak(np.zeros(5)) == 0


def test_options_without_sense_are_refused():
    for wrong in ({"reach_deg": -1.0}, {"step_deg": 0.0}, {"share": 1.5}):
        with pytest.raises(ValueError, match="make no sense"):
            replace(TurnOptions(), **wrong)
