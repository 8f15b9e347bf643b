"""A material as a MaterialX document of standard nodes, with nothing but Python's own library.

The material is what Cook-Torrance Standard is in Cycles: s·Σ wj·mirror(mj) +
d·diffuse, once with a conductor_bsdf by n and k and once with a
generalized_schlick_bsdf by F0 and F82 tint.  MaterialX's only distribution is
GGX; its roughness is the facets' rms slope m.  Beside them, and for models
that have no such closures, stands an open_pbr_surface by the Standin.
"""

import re
import xml.etree.ElementTree as ElementTree

from ..errors import FacetFilmError
from ..reflectance.slopes import along_across
from .standin import openpbr

__all__ = ["COLOUR_SPACES", "materialx", "materialx_of_standin", "require_exact"]

COLOUR_SPACES = {"Rec.709": "lin_rec709", "ACEScg": "acescg"}
"""MaterialX's standard names of our spaces: what was baked for another is baked again for the first."""


def materialx(bake, *, slopes, specular=1.0, diffuse=(0.0, 0.0, 0.0), anisotropy=0.0, rotation=0.0, standin=None):
    """MaterialX 1.39 text with two materials of a Bake, "NAME_conductor" and "NAME_f82", and "NAME_openpbr".

    bake       a Bake whose n and k are for the formula "exact", which MaterialX evaluates
    slopes     (m, w) pairs: rms slope of the facets, and its share
    specular   the mirror's share s; the rest is diffuse
    diffuse    linear RGB of π·Rd
    anisotropy, rotation  of the slopes, and of the tangent that they are along, in turns
    standin    the Standin of "NAME_openpbr", or None for none

    color82 of generalized_schlick_bsdf is the F82 tint: a factor on Schlick's
    curve at cos θ = 1/7, as in Kutz, Hašan and Edmondson 2021.  Raises
    FacetFilmError for n and k that are for another formula.

    >>> from addon.bake import bake
    >>> "generalized_schlick_bsdf" in materialx(bake("copper"), slopes=[(0.2, 1.0)])
    True
    """
    require_exact(bake)
    root = _document(bake.space, f"{bake.title}; {bake.source.dataset}; {bake.source.citation}; {bake.source.licence}")
    name = _name_of(bake.name)
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
    if standin is not None:
        _openpbr(root, f"{name}_openpbr", standin)
    return _text(root)


def require_exact(bake):
    """Raise FacetFilmError for a Bake whose n and k are for another formula than the one that MaterialX evaluates."""
    if bake.conductor.formula != "exact":
        raise FacetFilmError("MaterialX evaluates the exact conductor Fresnel, but these n and k were fitted "
                             f"for {bake.conductor.formula!r}; bake with the formula 'exact'.")


def materialx_of_standin(name, comment, standin, *, film=None):
    """MaterialX 1.39 text with "NAME_openpbr", an open_pbr_surface, and with "NAME_conductor" where there is a film.

    name, comment  of the material
    standin        the Standin, in linear Rec.709
    film           (n, k, m, thickness in nm, index): a film on a conductor, as conductor_bsdf's thin film has it

    >>> from .standin import Standin
    >>> "open_pbr_surface" in materialx_of_standin("glass", "Glass", Standin((1.0, 1.0, 1.0), transmission=1.0))
    True
    """
    root, name = _document("Rec.709", comment), _name_of(name)
    _openpbr(root, f"{name}_openpbr", standin)
    if film is not None:
        n, k, m, thickness, index = film
        _material(root, f"{name}_conductor", "conductor_bsdf", ([((m, m), 1.0)], 1.0, (0.0,) * 3, None), [
            ("ior", "color3", n, {"colorspace": "none"}), ("extinction", "color3", k, {"colorspace": "none"}),
            ("thinfilm_thickness", "float", (thickness,), {}), ("thinfilm_ior", "float", (index,), {})])
    return _text(root)


def _openpbr(root, name, standin):
    """Append an open_pbr_surface and its material; its colours are linear Rec.709, whatever the document's are."""
    inputs = []
    for key, value in openpbr(standin).items():
        if isinstance(value, tuple):
            inputs.append((key, "color3", value, {"colorspace": COLOUR_SPACES["Rec.709"]}))
        else:
            inputs.append((key, "boolean" if isinstance(value, bool) else "float", (value,), {}))
    surface = _node(root, "open_pbr_surface", f"{name}_surface", "surfaceshader", inputs)
    _linked(root, "surfacematerial", name, "material", "surfaceshader", surfaceshader=surface)


def _document(space, comment):
    """A document's root, which says where the numbers are from."""
    root = ElementTree.Element("materialx", version="1.39", colorspace=COLOUR_SPACES[space])
    root.append(ElementTree.Comment(" " + _comment(comment) + " "))
    return root


def _text(root):
    ElementTree.indent(root)
    return '<?xml version="1.0"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def _name_of(name):
    """A name as MaterialX allows it."""
    name = re.sub(r"\W", "_", name, flags=re.ASCII)
    return name if re.match("[A-Za-z]", name) else "material_" + name


def _comment(words):
    """Words as one line that may stand in a comment."""
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
        value = ", ".join(_shown(number) for number in numbers)
        ElementTree.SubElement(node, "input", name=input_name, type=of_type, value=value, **more)
    return name


def _shown(value):
    return str(value).lower() if isinstance(value, bool) else f"{value:.6g}"


def _linked(root, kind, name, output, of_type, **links):
    """Append a node whose inputs come from other nodes; its name."""
    node = ElementTree.SubElement(root, kind, name=name, type=output)
    for input_name, source in links.items():
        ElementTree.SubElement(node, "input", name=input_name, type=of_type, nodename=source)
    return name
