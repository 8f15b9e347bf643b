"""Materials of ours that are appended or dragged in.

Each brings its own copy of its group, which becomes one with the file's, and the name that its asset is found by, which
becomes its title.  And three things are baked again: n and k for another Blender's conductor Fresnel (4.5 evaluates
another than 5.0 and later; the asset library holds one set of numbers), what is for another working space than the
file's, and a material whose colours are an image of its own, for which the library holds a stand-in.
"""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat, datablocks

__all__ = ["STAND_IN_KEY", "attach", "detach", "renew"]

STAND_IN_KEY = "facet_film_stand_in"
"""Marks a material of the library that shows another's image until it is brought in."""


@bpy.app.handlers.persistent
def _after_import(imported, *_):
    if datablocks.groups.is_bringing():
        return
    arrived = [item.id for item in imported.import_items if item.id is not None]
    materials = [one for one in arrived if isinstance(one, bpy.types.Material) and _is_ours(one)]
    trees = [one for one in arrived if isinstance(one, bpy.types.NodeTree)]
    for material in materials:
        renew(material)
    for tree in trees:
        if datablocks.groups.group_id(tree) and datablocks.locked.is_editable(tree):
            datablocks.groups.settled(tree)
    datablocks.groups.merge_groups(trees)


def _is_ours(material):
    return datablocks.locked.is_editable(material) and datablocks.materials.our_node(material) is not None


def renew(material):
    """Name a material as what it is, and bake it again where what it holds is for another Blender, another working
    space, or another's.
    """
    from ...models.making import made, renewed
    from ..datablocks.spaces import is_foreign
    from .names import title_of
    baked = datablocks.materials.baked_of(material)
    if material.name != title_of(material.name) and title_of(material.name) == baked.get("title"):
        material.name = baked["title"]
    if STAND_IN_KEY in material:
        del material[STAND_IN_KEY]
        datablocks.materials.write(material, made(preset=baked["name"], renderer=compat.renderer()))
    elif is_foreign(material):
        _bring(material)
    elif baked.get("conductor", {}).get("formula", compat.conductor_formula()) != compat.conductor_formula():
        datablocks.materials.write(material, renewed(datablocks.materials.record_of(material), compat.renderer()))


def _bring(material):
    """Bring a material into the file's space; one whose measurement is not to be had stays, and the panel says so."""
    from ..datablocks.spaces import bring
    try:
        bring(material)
    except FacetFilmError as error:
        print(error.said(rpt_))


def attach():
    """Look at what is imported from now on."""
    bpy.app.handlers.blend_import_post.append(_after_import)


def detach():
    """No longer."""
    bpy.app.handlers.blend_import_post.remove(_after_import)
