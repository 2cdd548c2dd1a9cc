import numpy as np
from skyline_viewshed.core.simulate.roughness import fractal_field, roughness


def test_steep_ground_is_rougher():
    ramp = np.arange(128.0)[None, :] * np.array([[0.0], [8.0]]).repeat(64, axis=0)
    rough = roughness(ramp, 10.0, 40.0, seed=3)
    assert np.std(rough[80:120]) > 10 * np.std(rough[10:50])


def test_a_field_is_the_same_for_the_same_seed():
    assert np.array_equal(fractal_field(4, 2.0, 64, 16), fractal_field(4, 2.0, 64, 16))
    assert not np.array_equal(fractal_field(4, 2.0, 64, 16), fractal_field(5, 2.0, 64, 16))
