"""The verification's statistics against scipy's, and its pictures against another reader."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import stats

from addon.export.png import png
from addon.verify import pictures
from addon.verify.checks import Picture
from addon.verify.statistics import student_t_limit, z_test


@pytest.mark.parametrize("degrees", [1, 2, 3, 5, 6, 11, 30])
def test_limits_are_those_of_students_distribution(degrees):
    for probability in (1e-6, 1e-3, 0.05, 0.5):
        assert student_t_limit(probability, degrees) == pytest.approx(stats.t.isf(probability / 2, degrees), rel=1e-8)


def test_z_test_passes_as_often_as_it_says():
    random = np.random.default_rng(5)
    passed = [z_test(2.0 + 0.1 * random.normal(size=(6, 40)), np.full(40, 2.0), alpha=0.1).passed for _ in range(1000)]
    assert np.mean(passed) == pytest.approx(0.9, abs=0.03)


def test_z_test_notices_one_value_that_is_off():
    pictures_of = 2.0 + 0.1 * np.random.default_rng(5).normal(size=(6, 40))
    pictures_of[:, 7] += 1.0
    assert not z_test(pictures_of, np.full(40, 2.0)).passed


def test_pictures_are_png():
    pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 3), np.uint8)
    assert np.array_equal(np.array(Image.open(io.BytesIO(png(pixels)))), pixels)


def test_strip_shows_reference_render_and_difference():
    reference = np.full((96, 96, 3), 0.5)
    shown = pictures.strip(Picture(reference, 0.5 * reference, times=2.0))
    assert shown.shape == (96, 3 * 96 + 2 * pictures.GAP, 3)
    assert shown[0, 0, 0] == 255 and 100 < shown[0, 120, 0] < 255 and shown[0, -1, 0] == 255
