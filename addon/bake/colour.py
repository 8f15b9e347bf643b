"""From tristimulus values to linear RGB, and the colour difference CIEDE2000."""

import functools
import re

import numpy as np

from ..columns import columns
from ..errors import FacetFilmError, choice
from ..spectra import illuminants, observers

__all__ = ["SPACES", "canonical_space", "converted", "rgb_to_xyz", "space_to_space", "space_of_matrix",
           "spectral_weights", "lab", "delta_e_2000", "BRADFORD"]

D65 = (0.3127, 0.3290)
SPACES = {
    "Rec.709": (((0.64, 0.33), (0.30, 0.60), (0.15, 0.06)), D65),
    "Rec.2020": (((0.708, 0.292), (0.170, 0.797), (0.131, 0.046)), D65),
    "ACEScg": (((0.713, 0.293), (0.165, 0.830), (0.128, 0.044)), (0.32168, 0.33767)),
}
"""Chromaticities x, y of the primaries and of the white of the scene-linear spaces."""

ALIASES = {
    "rec709": "Rec.709", "bt709": "Rec.709", "709": "Rec.709", "srgb": "Rec.709", "linsrgb": "Rec.709",
    "linear": "Rec.709", "rec2020": "Rec.2020", "bt2020": "Rec.2020", "2020": "Rec.2020", "acescg": "ACEScg",
    "ap1": "ACEScg", "aces": "ACEScg",
}
"""What people call the spaces: letters and digits only, without "linear" before or after."""
NEAREST = {"p3": "Rec.2020", "displayp3": "Rec.2020", "dcip3": "Rec.2020", "p3d65": "Rec.2020", "adobergb": "Rec.2020",
           "ap0": "ACEScg", "aces20651": "ACEScg", "prophoto": "ACEScg", "romm": "ACEScg"}
"""Spaces that are not there, and the one that comes nearest."""

MEASURED = "primaries"
"""How the text of a measured space begins: x, y of red, green, blue and white follow."""
SAME_SPACE = 2e-3
"""Difference of matrices to XYZ up to which a measured space is one of SPACES: two versions of sRGB's are in use."""

BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])


def canonical_space(space):
    """The name that SPACES has for a space, however it is spelt, or the text of a measured one.

    Raises FacetFilmError for a space that is not there, with the nearest.

    >>> canonical_space("Linear Rec.709"), canonical_space("sRGB"), canonical_space("AP1")
    ('Rec.709', 'Rec.709', 'ACEScg')
    """
    if isinstance(space, str) and (space in SPACES or _measured(space) is not None):
        return space
    plain = re.sub("[^a-z0-9]", "", str(space).lower())
    plain = plain if plain == "linear" else re.sub("linear|scene|itur?|encoded", "", plain)
    if plain in NEAREST:
        raise FacetFilmError("{name} {value!r} is unknown; did you mean {near}? Valid: {valid}.", name="space",
                             value=space, near=(NEAREST[plain],), valid=", ".join(map(repr, SPACES)))
    return choice("space", ALIASES.get(plain, space), SPACES)


def space_of_matrix(matrix):
    """The scene-linear space with a matrix ``(3, 3)`` from linear RGB to XYZ, in which white is that of D65.

    Returns one of SPACES, or a text that :func:`rgb_to_xyz` takes: "primaries" with x and y of red, green, blue and
    white.  Raises FacetFilmError for a matrix that is none of a space.

    >>> space_of_matrix(rgb_to_xyz("ACEScg"))
    'ACEScg'
    >>> space_of_matrix(rgb_to_xyz("Rec.709")[:, [1, 0, 2]])
    'primaries 0.300000 0.600000 0.640000 0.330000 0.150000 0.060000 0.312700 0.329000'
    """
    matrix = np.array(matrix, float)
    for space in SPACES:
        if np.abs(matrix - rgb_to_xyz(space)).max() <= SAME_SPACE:
            return space
    colours = np.concatenate([matrix.T, [matrix.sum(axis=1)]])
    sums = colours.sum(axis=1)
    if not np.isfinite(matrix).all() or np.linalg.matrix_rank(matrix) < 3 or np.abs(sums).min() < 1e-6:
        raise FacetFilmError("The scene-linear space of this file has no three primaries; choose another OpenColorIO "
                             "configuration, or name a space.")
    return " ".join([MEASURED, *(f"{x:.6f}" for x in (colours[:, :2] / sums[:, None]).ravel())])


def space_to_space(space_from, space_to):
    """Matrix ``(3, 3)`` that takes linear RGB of one space to another.

    >>> bool(np.allclose(space_to_space("Rec.709", "ACEScg") @ np.ones(3), 1.0))
    True
    """
    return np.linalg.solve(rgb_to_xyz(space_to), rgb_to_xyz(space_from))


def converted(rgb, space_from, space_to):
    """A surface's colour ``(3,)`` of one space in another, brought into [0, 1], as a tuple.

    >>> converted((1.0, 1.0, 1.0), "Rec.709", "ACEScg"), converted((0.2, 0.3, 0.4), "Rec.709", "Rec.709")
    ((1.0, 1.0, 1.0), (0.2, 0.3, 0.4))
    """
    if space_from == space_to:
        return tuple(rgb)
    return tuple(np.clip(np.round(space_to_space(space_from, space_to) @ np.array(rgb), 7), 0.0, 1.0).tolist())


def _measured(space):
    """x and y of red, green, blue and white, ``(4, 2)``, of the text of a measured space; None for another text."""
    first, _, numbers = space.partition(" ")
    try:
        found = np.array(numbers.split(), float)
    except ValueError:
        return None
    return found.reshape(4, 2) if first == MEASURED and found.shape == (8,) else None


def _xyz_of(x_y):
    x, y = x_y
    return np.array([x / y, 1.0, (1.0 - x - y) / y])


def adaptation(white_from, white_to):
    """Matrix ``(3, 3)`` that takes XYZ seen under one white to the other, by Bradford's transform.

    white_from, white_to  XYZ of the whites, ``(3,)``

    >>> np.allclose(adaptation(np.ones(3), np.ones(3)), np.eye(3))
    True
    """
    gain = (BRADFORD @ white_to) / (BRADFORD @ white_from)
    return np.linalg.inv(BRADFORD) @ (gain[:, None] * BRADFORD)


@functools.cache
def rgb_to_xyz(space="Rec.709"):
    """Matrix ``(3, 3)`` from linear RGB to XYZ in which white is that of D65.

    A space with another white, ACEScg, is adapted to D65 by Bradford's
    transform, as Blender's colour management does: its neutral is D65's white
    in every space, and one material looks alike in all.  That of a measured space
    is as it was measured.

    Raises FacetFilmError for an unknown space.

    >>> rgb_to_xyz("Rec.709")[1].round(4).tolist()
    [0.2126, 0.7152, 0.0722]
    """
    measured = _measured(space) if space not in SPACES else None
    if measured is not None:
        return _matrix_of(measured[:3], measured[3])
    primaries, white = SPACES[choice("space", space, SPACES)]
    matrix = _matrix_of(primaries, white)
    return matrix if white == D65 else adaptation(_xyz_of(white), _xyz_of(D65)) @ matrix


def _matrix_of(primaries, white):
    columns = np.stack([_xyz_of(x_y) for x_y in primaries], axis=1)
    return columns * np.linalg.solve(columns, _xyz_of(white))


@functools.lru_cache(maxsize=64)
def spectral_weights(illuminant="D65", observer="1931", space="Rec.709", adapt=False):
    """What each nm of a reflectance spectrum adds to linear RGB, ``(421, 3)``.

    reflectance ``(…, 421)`` @ weights is RGB, with Y = 1 for a perfect
    reflector.  adapt: by Bradford's transform from the illuminant's white to
    D65, so that a perfect reflector is neutral; without, the illuminant tints.

    Raises FacetFilmError for an unknown illuminant, observer or space.

    >>> spectral_weights().sum(axis=0).round(3).tolist()
    [1.0, 1.0, 1.0]
    """
    to_rgb = np.linalg.inv(rgb_to_xyz(space))
    xyz = observers.colour_matching_functions(observer) * illuminants.power(illuminant)[:, None]
    xyz /= xyz[:, 1].sum()
    if adapt:
        to_rgb = to_rgb @ adaptation(xyz.sum(axis=0), _xyz_of(D65))
    return xyz @ to_rgb.T


def lab(rgb, space="Rec.709"):
    """CIE 1976 L*a*b* of linear RGB ``(…, 3)`` against the white of the space, ``(…, 3)``.

    >>> lab(np.ones(3)).round(6).tolist()
    [100.0, 0.0, 0.0]
    """
    ratio = rgb @ (rgb_to_xyz(space) / _xyz_of(D65)[:, None]).T
    t = np.where(ratio > (6 / 29) ** 3, np.cbrt(np.maximum(ratio, 0.0)), ratio * (29 / 6) ** 2 / 3 + 4 / 29)
    x, y, z = t[..., 0], t[..., 1], t[..., 2]
    return np.stack([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)], axis=-1)


def delta_e_2000(lab_1, lab_2):
    """The colour difference CIEDE2000 of two L*a*b*, ``(…, 3)`` and ``(…, 3)`` to ``(…)``.

    Sharma, Wu and Dalal, "The CIEDE2000 Color-Difference Formula:
    Implementation Notes, Supplementary Test Data, and Mathematical
    Observations", Color Research and Application 30(1), 2005; their equation
    numbers below.

    >>> round(float(delta_e_2000(np.array([50, 2.6772, -79.7751]), np.array([50, 0, -82.7485]))), 4)
    2.0425
    """
    l_1, a_1, b_1 = columns(lab_1)
    l_2, a_2, b_2 = columns(lab_2)
    c7 = (0.5 * (np.hypot(a_1, b_1) + np.hypot(a_2, b_2))) ** 7
    g = 1.5 - 0.5 * np.sqrt(c7 / (c7 + 25.0**7))  # (4), with the 1 of (5)
    a_1, a_2 = a_1 * g, a_2 * g
    c_1, c_2 = np.hypot(a_1, b_1), np.hypot(a_2, b_2)
    h_1, h_2 = np.arctan2(b_1, a_1), np.arctan2(b_2, a_2)
    grey = c_1 * c_2 == 0.0
    turn = h_2 - h_1
    turn = np.where(grey, 0.0, turn - 2.0 * np.pi * np.round(turn / (2.0 * np.pi)))  # (10)
    d_h = 2.0 * np.sqrt(c_1 * c_2) * np.sin(0.5 * turn)  # (11)
    l_mean, c = 0.5 * (l_1 + l_2), 0.5 * (c_1 + c_2)
    h = np.where(grey, h_1 + h_2, h_1 + 0.5 * turn)  # (14)
    t = (1.0 - 0.17 * np.cos(h - np.pi / 6) + 0.24 * np.cos(2.0 * h)
         + 0.32 * np.cos(3.0 * h + np.pi / 30) - 0.20 * np.cos(4.0 * h - 63.0 * np.pi / 180))  # (15)
    from_50 = (l_mean - 50.0) ** 2
    s_l = 1.0 + 0.015 * from_50 / np.sqrt(20.0 + from_50)  # (18)
    s_c, s_h = 1.0 + 0.045 * c, 1.0 + 0.015 * c * t  # (19), (20)
    degrees = np.degrees(h) % 360.0
    r_c = 2.0 * np.sqrt(c**7 / (c**7 + 25.0**7))  # (17)
    r_t = -np.sin(np.radians(60.0 * np.exp(-((degrees - 275.0) / 25.0) ** 2))) * r_c  # (16), (21)
    d_l, d_c, d_h = (l_2 - l_1) / s_l, (c_2 - c_1) / s_c, d_h / s_h
    return np.sqrt(np.maximum(d_l**2 + d_c**2 + d_h**2 + r_t * d_c * d_h, 0.0))  # (22)
