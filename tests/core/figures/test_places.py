import numpy as np
from skyline_viewshed.core.figures.places import NOTHING, RED, score_map


def test_scores_become_cells_and_the_best_place_a_red_mark():
    row, col = np.mgrid[:20, :30]
    longitude, latitude = 8 + col.ravel() * 0.003, 46 - row.ravel() * 0.003 * np.cos(np.radians(46))
    score = -np.hypot(col - 25, row - 4).ravel().astype(float)
    score[0] = -np.inf
    picture = score_map(longitude, latitude, score, 0.003 * 111_195 * np.cos(np.radians(46)), [(8.075, 45.9917)])
    assert picture.dtype == np.uint8 and picture.shape[1] / picture.shape[0] == 1.5
    assert tuple(picture[2, 2]) == NOTHING
    assert (np.abs(picture.astype(int) - RED).sum(axis=2) < 20).sum() > 100
    assert picture[-5, 5].sum() < picture[4 * 30 + 15, 20 * 30 + 15].sum()
