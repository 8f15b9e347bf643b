"""A bake as a MaterialX document, with nothing but the standard library.

The material is what Cook-Torrance Fast is in Cycles: s·Σ wj·mirror(mj) +
d·diffuse, once with a conductor_bsdf by n and k and once with a
generalized_schlick_bsdf by F0 and F82 tint.  MaterialX's only distribution is
GGX; its roughness is the facets' rms slope m.
"""

import re
import xml.etree.ElementTree as ElementTree

from ..errors import FacetFilmError
from ..reflectance.slopes import along_across

__all__ = ["materialx", "COLOUR_SPACES"]

COLOUR_SPACES = {"Rec.709": "lin_rec709", "Rec.2020": "lin_rec2020", "ACEScg": "acescg"}
"""MaterialX's names; Rec.2020 is not in its standard list, applications know it by their own."""


def materialx(bake, *, slopes, specular=1.0, diffuse=(0.0, 0.0, 0.0), anisotropy=0.0, rotation=0.0):
    """MaterialX 1.39 text with two materials of a Bake, "NAME_conductor" and "NAME_f82".

    bake       a Bake whose n and k are for the formula "exact", which MaterialX evaluates
    slopes     (m, w) pairs: rms slope of the facets, and its share
    specular   the mirror's share s; the rest is diffuse
    diffuse    linear RGB of π·Rd
    anisotropy, rotation  of the slopes, and of the tangent that they are along, in turns

    color82 of generalized_schlick_bsdf is the F82 tint: a factor on Schlick's
    curve at cos θ = 1/7, as in Kutz, Hašan and Edmondson 2021.  Raises
    FacetFilmError for n and k that are for another formula.

    >>> from addon.bake import bake
    >>> "generalized_schlick_bsdf" in materialx(bake("copper"), slopes=[(0.2, 1.0)])
    True
    """
    if bake.conductor.formula != "exact":
        raise FacetFilmError("MaterialX evaluates the exact conductor Fresnel, but these n and k were fitted "
                             f"for {bake.conductor.formula!r}; bake with the formula 'exact'.")
    root = ElementTree.Element("materialx", version="1.39", colorspace=COLOUR_SPACES[bake.space])
    root.append(ElementTree.Comment(" " + _comment(bake) + " "))
    name = re.sub(r"\W", "_", bake.name, flags=re.ASCII)
    name = name if re.match("[A-Za-z]", name) else "material_" + name
    stretched = [(tuple(map(float, along_across(m, anisotropy))), w) for m, w in slopes]
    surface = (stretched, specular, diffuse, _turned(root, name, rotation) if anisotropy and rotation else None)
    _material(root, f"{name}_conductor", "conductor_bsdf", surface, [
        ("ior", "color3", bake.conductor.n, {"colorspace": "none"}),
        ("extinction", "color3", bake.conductor.k, {"colorspace": "none"})])
    _material(root, f"{name}_f82", "generalized_schlick_bsdf", surface, [
        ("color0", "color3", bake.f82.f0, {}),
        ("color82", "color3", bake.f82.tint, {}),
        ("color90", "color3", (1.0, 1.0, 1.0), {}),
        ("exponent", "float", (5.0,), {})])
    ElementTree.indent(root)
    return '<?xml version="1.0"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def _comment(bake):
    """Where the numbers are from, as one line that may stand in a comment."""
    words = f"{bake.title}; {bake.source.dataset}; {bake.source.citation}; {bake.source.licence}"
    printable = "".join(c if c.isprintable() else " " for c in words)
    return re.sub("-{2,}", "-", " ".join(printable.split())).strip("-")


def _material(root, name, mirror, surface, fresnel):
    """Append one material: its lobes, their sum, surface and surfacematerial."""
    slopes, specular, diffuse, tangent = surface
    lobes = []
    for j, (along_and_across, w) in enumerate(slopes, 1):
        inputs = [("weight", "float", (specular * w,), {}), *fresnel,
                  ("roughness", "vector2", along_and_across, {})]
        lobes.append(_node(root, mirror, f"{name}_lobe_{j}", "BSDF", inputs))
        if tangent:
            ElementTree.SubElement(root[-1], "input", name="tangent", type="vector3", nodename=tangent)
    if specular < 1.0:
        lobes.append(_node(root, "oren_nayar_diffuse_bsdf", f"{name}_diffuse", "BSDF", [
            ("weight", "float", (1.0 - specular,), {}), ("color", "color3", diffuse, {})]))
    total = lobes[0]
    for j, lobe in enumerate(lobes[1:], 1):
        total = _linked(root, "add", f"{name}_sum_{j}", "BSDF", "BSDF", in1=total, in2=lobe)
    surface = _linked(root, "surface", f"{name}_surface", "surfaceshader", "BSDF", bsdf=total)
    _linked(root, "surfacematerial", name, "material", "surfaceshader", surfaceshader=surface)


def _turned(root, name, rotation):
    """Append the tangent, turned about the normal; its name."""
    for kind in ("tangent", "normal"):
        ElementTree.SubElement(root, kind, name=f"{name}_{kind}", type="vector3")
    turned = f"{name}_turned_tangent"
    node = ElementTree.SubElement(root, "rotate3d", name=turned, type="vector3")
    for input_name, of_type, source in (("in", "vector3", {"nodename": f"{name}_tangent"}),
                                        ("amount", "float", {"value": f"{360.0 * rotation:.6g}"}),
                                        ("axis", "vector3", {"nodename": f"{name}_normal"})):
        ElementTree.SubElement(node, "input", name=input_name, type=of_type, **source)
    return turned


def _node(root, kind, name, output, inputs):
    """Append a node with values on its inputs, [(name, type, numbers, more attributes) …]; its name."""
    node = ElementTree.SubElement(root, kind, name=name, type=output)
    for input_name, of_type, numbers, more in inputs:
        value = ", ".join(f"{number:.6g}" for number in numbers)
        ElementTree.SubElement(node, "input", name=input_name, type=of_type, value=value, **more)
    return name


def _linked(root, kind, name, output, of_type, **links):
    """Append a node whose inputs come from other nodes; its name."""
    node = ElementTree.SubElement(root, kind, name=name, type=output)
    for input_name, source in links.items():
        ElementTree.SubElement(node, "input", name=input_name, type=of_type, nodename=source)
    return name
