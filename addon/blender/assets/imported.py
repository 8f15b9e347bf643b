"""Materials of ours that are appended or dragged in.

Each brings its own copy of its group, which becomes one with the file's.  And where n and k are for another Blender's
conductor Fresnel (4.5 evaluates another than 5.0 and later; the asset library holds one set of numbers), or for another
working space than the file's, they are baked again.
"""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat
from ..datablocks.fingerprints import ID_KEY
from ..datablocks.groups import VERSION_KEY, group_of, is_bringing, node_group
from ..datablocks.locked import is_editable
from ..datablocks.materials import baked_of, our_node, record_of, write
from ..datablocks.pictures import image_in
from ..datablocks.spaces import bring, is_foreign

__all__ = ["attach", "detach"]


@bpy.app.handlers.persistent
def _after_import(imported, *_):
    if is_bringing():
        return
    arrived = [item.id for item in imported.import_items if item.id is not None]
    ours = [one for one in arrived if isinstance(one, bpy.types.Material) and is_editable(one)]
    strangers = [one for one in ours if is_foreign(one)]
    materials = [one for one in ours if _is_for_another_blender(one) and one not in strangers]
    trees = {(one.get(ID_KEY), image_in(one)) for one in arrived
             if isinstance(one, bpy.types.NodeTree) and _is_current(one)}
    for material in materials:
        _renew(material)
    for material in strangers:
        _bring(material)
    for identifier, image in trees:
        if sum(one.get(ID_KEY) == identifier for one in bpy.data.node_groups) > 1:
            node_group(identifier, image)


def _is_for_another_blender(material):
    if our_node(material) is None:
        return False
    fit = baked_of(material).get("conductor")
    return fit is not None and fit["formula"] != compat.conductor_formula()


def _is_current(tree):
    group = group_of(tree.get(ID_KEY))
    return group is not None and is_editable(tree) and tree.get(VERSION_KEY) == group.version


def _renew(material):
    """Bake a material again for this Blender, where what was baked is still as it was."""
    from ...models.making import renewed
    write(material, renewed(record_of(material), compat.renderer()))


def _bring(material):
    """Bring a material into the file's space; one whose measurement is not to be had stays, and the panel says so."""
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
