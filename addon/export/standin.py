"""A material as programs with base colour, metalness and roughness know it, and what each format has of that."""

import math
from typing import NamedTuple

from ..reflectance.fresnel import index_from_normal

__all__ = ["HAS", "LOST", "LOST_THERE", "Standin", "gltf", "index_of", "lost_in", "openpbr", "plain", "preview_surface",
           "principled"]

LOST = {
    "facets": "The facets' distribution becomes GGX, whose highlights have wider tails.",
    "slopes": "Several slopes become one of the same rms.",
    "film": "The film's colors over the angle become two: face on and at 82°.",
    "field": "A thickness that varies becomes its middle.",
    "shadows": "Shadows and caustics are the other program's own.",
    "look": "What this material does with light has no counterpart there: its color and gloss at a glance remain.",
}
"""What shaders of base colour and metalness do not have."""

LOST_THERE = {
    "edge": "A metal's color towards the edge is lost there.",
    "ior": "The index of refraction is lost there: 1.5 is taken.",
    "transmission": "What is seen through arrives opaque there.",
    "attenuation": "Absorption over the depth is lost there: the color is that of the mean depth.",
    "abbe": "Dispersion is lost there.",
    "anisotropy": "Anisotropy is lost there.",
    "film": "Interference in the clear film is lost there.",
}
"""What only some formats have, and the sentence where one lacks it."""

HAS = {
    "glTF": ("ior", "transmission", "attenuation", "abbe", "anisotropy", "film"),
    "UsdPreviewSurface": ("ior", "transmission"),
    "OBJ": ("ior", "transmission", "anisotropy"),
    "FBX": (),
}
"""A format -> what it has of LOST_THERE, as Blender's exporters write it."""

USUAL_INDEX, USUAL_F0, LARGEST_F0 = 1.5, 0.04, 0.08
"""The index that formats without one mean, its normal reflectance, and the largest that a Specular IOR Level gives."""

SEEN = 0.01
"""Of an index, or of an edge's tint: less than that is not said to be lost."""

FAINT = 0.02
"""What the strongest channel loses over a glTF volume's distance.  By Beer and Lambert's law, which glTF has, any
distance says the same; where colours are pale so does Blender's import, which takes (1 − colour)/distance.
"""


class Standin(NamedTuple):
    """Colours are linear Rec.709, lengths metres.

    base          colour of the metal, or of the diffuse part
    metallic      0 to 1
    roughness     its square is the rms slope of the facets
    edge          tint of a metal's reflection at 82°
    base_alone    base colour for programs without an edge tint
    ior           index of the coat or body
    specular      factor on the coat's F0: 0 where there is none
    transmission  share that passes into the body
    thin_walled   whether the mesh is one sheet
    attenuation   (colour of white light after the distance, distance), or None
    thickness     of the body where a format wants one depth
    abbe          V_d of the body, or None
    anisotropy, rotation  of the facets, 0 to 1
    film          (thickness in nm, index) of an interfering film, or None
    delta_e       mean CIEDE2000 from the material over a ball's angles with the edge tint, and without
    lost          sentences on what no such shader has
    """

    base: tuple
    metallic: float = 0.0
    roughness: float = 0.5
    edge: tuple = (1.0, 1.0, 1.0)
    base_alone: tuple = ()
    ior: float = 1.5
    specular: float = 1.0
    transmission: float = 0.0
    thin_walled: bool = False
    attenuation: tuple | None = None
    thickness: float = 0.0
    abbe: float | None = None
    anisotropy: float = 0.0
    rotation: float = 0.0
    film: tuple | None = None
    delta_e: tuple = (0.0, 0.0)
    lost: tuple = ()


def index_of(f0):
    """The index of refraction with a normal reflectance.

    >>> round(index_of(0.04), 3)
    1.5
    """
    return float(index_from_normal(f0))


def principled(standin):
    """{socket of a Principled BSDF: value}; sockets that a Blender lacks are left out by whoever sets them."""
    s = standin
    found = {"Base Color": (*s.base, 1.0), "Metallic": s.metallic, "Roughness": s.roughness, "IOR": s.ior,
             "Specular IOR Level": 0.5 * s.specular, "Specular Tint": (*s.edge, 1.0), "Anisotropic": s.anisotropy,
             "Anisotropic Rotation": s.rotation, "Transmission Weight": s.transmission}
    if s.transmission > 0.0:
        found["Base Color"] = (*(_through(s) if not s.thin_walled else s.base), 1.0)
    if s.film:
        found.update({"Thin Film Thickness": s.film[0], "Thin Film IOR": s.film[1]})
    return found


def plain(standin):
    """{socket: value} of the Principled BSDF for exporters that read numbers off it and know no edge tint: FBX, OBJ."""
    found = {**principled(standin), "Specular Tint": (1.0, 1.0, 1.0, 1.0)}
    if standin.metallic > 0.0 and standin.base_alone:
        found["Base Color"] = (*standin.base_alone, 1.0)
    if _by_level(standin):
        found.update({"IOR": USUAL_INDEX, "Specular IOR Level": 0.5 * _f0(standin) / USUAL_F0})
    return found


def _by_level(standin):
    """Whether the gloss of what is opaque is said by a level, which more formats have than an index."""
    return standin.transmission == 0.0 and standin.metallic < 1.0 and _f0(standin) <= LARGEST_F0


def _f0(standin):
    return standin.specular * ((standin.ior - 1.0) / (standin.ior + 1.0)) ** 2


def lost_in(standin, form):
    """The sentences on what a format of HAS loses of a material: what none of them has, and what this one lacks.

    >>> lost_in(Standin((1.0, 1.0, 1.0), ior=1.333, transmission=1.0), "FBX")[1]
    'What is seen through arrives opaque there.'
    """
    s = standin
    clear = s.transmission > 0.0
    held = {
        "edge": s.metallic > 0.0 and min(s.edge) < 1.0 - SEEN,
        "ior": s.metallic < 1.0 and abs(s.ior - USUAL_INDEX) > SEEN and not _by_level(s),
        "transmission": clear, "abbe": clear and s.abbe is not None, "anisotropy": s.anisotropy > 0.0,
        "attenuation": clear and not s.thin_walled and s.attenuation is not None and min(s.attenuation[0]) < 1.0,
        "film": s.film is not None}
    return (*s.lost, *(said for what, said in LOST_THERE.items() if held[what] and what not in HAS[form]))


def _through(standin):
    """Colour of white light after a body that is `thickness` deep; a Principled BSDF takes its root at each face."""
    if standin.attenuation is None:
        return standin.base
    colour, distance = standin.attenuation
    share = standin.thickness / distance
    return tuple(base * max(channel, 1e-6) ** share for base, channel in zip(standin.base, colour))


def gltf(standin):
    """(pbrMetallicRoughness, extensions) of glTF 2.0: numbers alone."""
    s = standin
    core = {"baseColorFactor": [*(s.base_alone or s.base), 1.0], "metallicFactor": s.metallic,
            "roughnessFactor": s.roughness}
    found = {}
    if s.metallic < 1.0:
        found["KHR_materials_ior"] = {"ior": s.ior}
        found["KHR_materials_specular"] = {"specularFactor": s.specular}  # without it Blender drops the index
    if s.transmission > 0.0:
        found["KHR_materials_transmission"] = {"transmissionFactor": s.transmission}
        if not s.thin_walled:
            found["KHR_materials_volume"] = _volume(s)
            if s.abbe:
                found["KHR_materials_dispersion"] = {"dispersion": 20.0 / s.abbe}
    if s.anisotropy > 0.0:
        found["KHR_materials_anisotropy"] = {"anisotropyStrength": s.anisotropy,
                                             "anisotropyRotation": 6.283185307179586 * s.rotation}
    if s.film:
        found["KHR_materials_iridescence"] = {
            "iridescenceFactor": 1.0, "iridescenceIor": s.film[1], "iridescenceThicknessMaximum": s.film[0]}
    return core, found


def _volume(standin):
    found = {"thicknessFactor": max(standin.thickness, 1e-4)}
    if standin.attenuation is not None:
        colour, distance = standin.attenuation
        share = math.log(1.0 - FAINT) / min(math.log(max(min(colour), 1e-6)), math.log(1.0 - FAINT))
        found.update(attenuationColor=[channel**share for channel in colour], attenuationDistance=distance * share)
    return found


def preview_surface(standin):
    """{input of UsdPreviewSurface: value}."""
    s = standin
    colour = _through(s) if s.transmission > 0.0 and not s.thin_walled else s.base_alone or s.base
    return {"diffuseColor": colour, "metallic": s.metallic, "roughness": s.roughness,
            "ior": s.ior if s.specular > 0.0 else 1.0, "opacity": 1.0 - s.transmission}


def openpbr(standin):
    """{input of open_pbr_surface: value}, which MaterialX and USD take by the same names."""
    s = standin
    found = {"base_color": s.base, "base_metalness": s.metallic, "specular_weight": max(s.specular, s.metallic),
             "specular_roughness": s.roughness, "specular_ior": s.ior,
             "specular_color": s.edge if s.metallic > 0.0 else (1.0, 1.0, 1.0)}
    if s.anisotropy > 0.0:
        found["specular_roughness_anisotropy"] = s.anisotropy
    if s.transmission > 0.0:
        found.update(transmission_weight=s.transmission, geometry_thin_walled=s.thin_walled)
        if s.attenuation is not None:
            found.update(transmission_color=tuple(s.attenuation[0]), transmission_depth=s.attenuation[1])
        if s.abbe:
            found.update(transmission_dispersion_scale=1.0, transmission_dispersion_abbe_number=s.abbe)
    if s.film:
        found.update(thin_film_weight=1.0, thin_film_thickness=s.film[0] / 1000.0, thin_film_ior=s.film[1])
    return found
