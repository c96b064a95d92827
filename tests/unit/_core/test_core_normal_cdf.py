"""Distribution function of the normal distribution, against SciPy's."""

import numpy as np
from scipy.special import ndtr

from skinshade._core.normal_cdf import normal_cdf
from skinshade.shading.direct import relief_bump
from tolerances import NORMAL_CDF, NORMAL_CDF_TAIL


def test_it_is_that_of_scipy_at_and_between_the_nodes_of_the_table():
    x = np.concatenate([np.linspace(-12.0, 12.0, 200_001), np.arange(-5, 6) / 256.0, [-1e9, 1e9]])
    assert np.abs(normal_cdf(x) - ndtr(x)).max() <= NORMAL_CDF.value


def test_it_is_a_half_at_0_and_symmetric_about_it():
    x = np.random.default_rng(0).normal(0.0, 3.0, (40, 25, 3))
    assert normal_cdf(np.zeros(())) == 0.5
    assert np.abs(normal_cdf(x) + normal_cdf(-x) - 1.0).max() <= NORMAL_CDF.value


def test_its_lower_tail_has_a_small_relative_error():
    x = np.linspace(-37.0, 0.0, 100_001)
    assert np.abs(normal_cdf(x) / ndtr(x) - 1.0).max() <= NORMAL_CDF_TAIL.value


def test_the_light_of_relief_that_subtracts_the_tail_is_not_negative():
    cosine = np.linspace(-1.0, 1.0, 20_001)
    for slope in (1e-3, 0.02, 0.03, 0.1, 0.5):
        assert relief_bump(cosine, np.array(slope)).min() >= 0.0
