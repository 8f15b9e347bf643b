"""Half vector and difference vector: the angles that measured BRDFs are tabled over.

S. Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation",
Eurographics Workshop on Rendering, 1998: θh is the angle of the half vector
from the normal, θd and φd are those of the light about the half vector.
Radians; unit vectors ``(N, 3)``, the normal along z.
"""

import numpy as np

from ..columns import columns

__all__ = ["STEEPEST", "angles_of", "directions_of", "grid", "solid_angle"]

STEEPEST = np.radians(80.0)
"""Of the grid: towards grazing measurements are hardly any."""


def directions_of(theta_h, theta_d, phi_d):
    """(V, L) of the angles, ``(N, 3)`` each; φ of the half vector is 0.

    >>> v, l = directions_of(np.array([0.0]), np.array([0.5]), np.array([0.0]))
    >>> (v + l).round(6).tolist(), l.round(3).tolist()
    ([[0.0, 0.0, 1.755165]], [[0.479, 0.0, 0.878]])
    """
    x, y, z = np.sin(theta_d) * np.cos(phi_d), np.sin(theta_d) * np.sin(phi_d), np.cos(theta_d)
    sine, cosine = np.sin(theta_h), np.cos(theta_h)

    def turned(x, y):
        return np.stack([cosine * x + sine * z, y, cosine * z - sine * x], axis=-1)
    return turned(-x, -y), turned(x, y)


def angles_of(v, l):
    """(θh, θd, φd) of directions: θh and θd in [0, π/2], φd in [0, π), as V and L may be exchanged.

    >>> v, l = directions_of(np.array([0.4]), np.array([0.3]), np.array([1.2]))
    >>> [round(float(angle[0]), 6) for angle in angles_of(v, l)]
    [0.4, 0.3, 1.2]
    """
    h = v + l
    h = h / np.linalg.norm(h, axis=-1, keepdims=True)
    (h_x, h_y, h_z), (l_x, l_y, l_z) = columns(h), columns(l)
    across = np.hypot(h_x, h_y)
    turned, length = across > 1e-12, np.maximum(across, 1e-12)
    cosine, sine = np.where(turned, h_x / length, 1.0), np.where(turned, h_y / length, 0.0)
    along = cosine * l_x + sine * l_y
    y = cosine * l_y - sine * l_x
    x = h_z * along - across * l_z
    z = across * along + h_z * l_z
    return np.arctan2(across, h_z), np.arctan2(np.hypot(x, y), z), np.arctan2(y, x) % np.pi


def solid_angle(theta_h, d_theta_h, theta_d):
    """What a cell even in θd and φd counts in ∫∫ dωv dωl, up to a factor: 4 cos θd dωh dωd."""
    return np.sin(theta_h) * d_theta_h * np.sin(theta_d) * np.cos(theta_d)


def grid(halves=32, differences=12, turns=8):
    """(V, L, weight) of the grid that fits sample: θh even in its square root, none beyond 80° from the normal.

    weight  share of the solid angles, ``(N,)``, sum 1
    """
    t = (np.arange(halves) + 0.5) / halves
    theta_h, theta_d, phi_d = (a.ravel() for a in np.meshgrid(
        t * t * np.pi / 2.0, (np.arange(differences) + 0.5) / differences * np.radians(88.0),
        (np.arange(turns) + 0.5) / turns * np.pi, indexing="ij"))
    v, l = directions_of(theta_h, theta_d, phi_d)
    weight = solid_angle(theta_h, np.sqrt(theta_h), theta_d)
    seen = np.minimum(v[:, 2], l[:, 2]) > np.cos(STEEPEST)
    return v[seen], l[seen], weight[seen] / weight[seen].sum()
