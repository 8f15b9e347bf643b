"""Fresnel curves against other people's libraries: tmm for the reflectance, colour-science for its colour."""

import colour
import numpy as np
import pytest
import tmm

from addon.bake.reflected import mirror_spectra, reflect
from addon.reflectance.fresnel import conductor
from addon.spectra.observers import WAVELENGTH_NM

ANGLES = np.radians([0.0, 30.0, 60.0, 75.0, 85.0, 89.0])
INDICES = [(0.2, 3.9), (0.92, 2.45), (2.9, 3.1), (1.5, 0.0), (0.05, 0.3), (4.0, 0.02)]


def by_tmm(n, k, angle):
    """Unpolarised reflectance of the bare surface."""
    return np.mean([tmm.coh_tmm(p, [1.0, n + 1j * k], [np.inf, np.inf], angle, 500.0)["R"] for p in "sp"])


@pytest.mark.parametrize("n, k", INDICES)
def test_reflectance_is_that_of_tmm(n, k):
    expected = [by_tmm(n, k, angle) for angle in ANGLES]
    np.testing.assert_allclose(conductor(np.cos(ANGLES), n, k), expected, rtol=1e-9)


def test_the_comparison_with_tmm_fails_for_another_index():
    assert abs(conductor(np.cos(1.3), 0.93, 2.45) - by_tmm(0.92, 2.45, 1.3)) > 1e-4


@pytest.mark.parametrize("preset", ["copper", "gold", "crown_glass"])
@pytest.mark.parametrize("angle", [0.0, 60.0, 82.0])
def test_colours_are_those_of_tmm_and_colour_science(preset, angle):
    """Spectra by tmm every 5 nm, integrated by colour-science under D65: within 0.1 CIEDE2000 of ours."""
    mirror = reflect(preset)
    some = slice(0, None, 5)
    spectrum = [by_tmm(n, k, np.radians(angle)) for n, k in zip(mirror.n[some], mirror.k[some])]
    shape = colour.SpectralShape(360, 780, 5)
    xyz = colour.sd_to_XYZ(colour.SpectralDistribution(spectrum, WAVELENGTH_NM[some]),
                           colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(shape),
                           colour.SDS_ILLUMINANTS["D65"].copy().align(shape), method="Integration") / 100.0
    ours = mirror_spectra(np.cos(np.radians([angle])), mirror.n, mirror.k)[0] @ mirror.viewing.weights
    white = np.array([0.31270, 0.32900])
    theirs = colour.XYZ_to_Lab(xyz, white)
    found = colour.XYZ_to_Lab(colour.RGB_to_XYZ(ours, "ITU-R BT.709", apply_cctf_decoding=False), white)
    assert colour.delta_E(found, theirs, method="CIE 2000") < 0.1
