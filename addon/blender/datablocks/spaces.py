"""Materials of ours whose numbers are for another scene-linear space than the file's, and bringing them into it."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from .. import compat
from .locked import is_editable
from .materials import RECORD_KEY, our_node, record_of, write

__all__ = ["bring", "brought", "foreign_materials", "is_foreign", "said_of_space", "shown_space", "space_of"]


def space_of(material):
    """The scene-linear space that was baked into a material, or ""."""
    if material is None or RECORD_KEY not in material or our_node(material) is None:
        return ""
    from ...models.record import space_in
    return space_in(material.get(RECORD_KEY, ""))


def is_foreign(material):
    """Whether a material's numbers are for another space than the file's."""
    return space_of(material) not in ("", compat.working_space())


def foreign_materials():
    """Those of this file that are, and may be changed."""
    return [material for material in bpy.data.materials if is_editable(material) and is_foreign(material)]


def brought(material):
    """The Record of a material in the file's space."""
    from ...models.moving import moved
    return moved(record_of(material), compat.renderer(), colours=not compat.converts_colours())


def bring(material):
    """Bring a material into the file's space."""
    write(material, brought(material))


def shown_space(space):
    """What people call a space; one that was measured has no name."""
    return space if " " not in space else iface_("a space of its own")


def said_of_space(material):
    """In a sentence that a material is for another space than the file's, or an empty text."""
    if not is_foreign(material):
        return ""
    return rpt_("{:s} was baked for {:s}, but this file's working space is {:s}: its colors are off").format(
        material.name, shown_space(space_of(material)), shown_space(compat.working_space()))
