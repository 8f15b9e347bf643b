"""A bake as settings of a Principled BSDF, which glTF and USD exporters understand."""

from ..reflectance.fresnel import index_from_normal

__all__ = ["principled_settings"]

LARGEST_DIELECTRIC_K = 0.1
"""k below which F is a dielectric's: k² is less than 0.2 % of (n+1)² there."""


def principled_settings(bake, *, slopes, specular=1.0, diffuse=(0.0, 0.0, 0.0), anisotropy=0.0, rotation=0.0):
    """Values for the sockets of a Principled BSDF, by identifier.

    A conductor: metallic = s, base colour = F0 and specular tint = F82 tint as
    fitted, so that F is Blender's F82 model.  Where d is not 0 its diffuse
    part takes the colour F0, as Principled has one base colour; that is exact
    for materials whose specular and diffuse have the same colour, such as
    Cook and Torrance's Table I.
    A dielectric (k below 0.1 in every channel): IOR for the mean F0, and base
    colour = d·(π Rd).
    Roughness = √m, m² = Σ wj mj²: the rms slope of all facets together.

    bake      a Bake
    slopes    (m, w) pairs: rms slope of the facets, and its share
    specular  the mirror's share s
    diffuse   linear RGB of π·Rd
    anisotropy, rotation  of the slopes, which Principled has as well

    >>> from addon.bake import bake
    >>> principled_settings(bake("copper"), slopes=[(0.2, 1.0)])["Metallic"]
    1.0
    """
    slope = sum(w * m * m for m, w in slopes) ** 0.5
    shape = {"Roughness": min(slope ** 0.5, 1.0), "Anisotropic": anisotropy, "Anisotropic Rotation": rotation}
    if max(bake.conductor.k) < LARGEST_DIELECTRIC_K:
        mean_f0 = sum(bake.normal_rgb) / 3.0
        base = [(1.0 - specular) * channel for channel in diffuse]
        return {"Base Color": (*base, 1.0), "Metallic": 0.0, **shape,
                "IOR": float(index_from_normal(mean_f0)), "Specular IOR Level": 0.5 * specular,
                "Specular Tint": (1.0, 1.0, 1.0, 1.0)}
    return {"Base Color": (*bake.f82.f0, 1.0), "Metallic": float(specular), **shape,
            "Specular IOR Level": 0.5 if specular == 1.0 else 0.0,
            "Specular Tint": (*bake.f82.tint, 1.0)}
