"""The stand-in in a material's nodes: a Principled BSDF for exporters that have no hooks and read numbers off one.

FBX's takes the one that is plugged into any material output, OBJ's too.  So a material of ours gets one with an output
of its own, which is not the active one, so that nothing renders it.  It is made, or made anew, when File, Export opens
in a window; scripts call addon.api.ready_for_export.
"""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from ..compat import working_space

if TYPE_CHECKING:
    from ...export.standin import Standin

__all__ = ["forget", "next_one", "ours", "renew", "stale", "when_export_opens"]

ABOVE = 180
"""How far over the material's own node it is: nodes open downwards."""

_waiting = []


def stale():
    """The materials of this file that are ours, may be changed, and hold no stand-in of what they are now."""
    return [material for material in ours() if _is_stale(material)]


def _is_stale(material):
    try:
        return _held(material) != _stamp(material)
    except FacetFilmError:  # its sockets hold what cannot be: its card says so
        return False


def ours():
    """The materials of this file that are ours, and may be changed."""
    return [material for material in bpy.data.materials
            if datablocks.locked.is_editable(material) and datablocks.materials.our_node(material) is not None]


def renew(material: bpy.types.Material) -> Standin:
    """Give one of our materials the stand-in of what its node holds now; the addon.export.standin.Standin of that.

    Raises FacetFilmError for a material that is not ours, and for one that is linked.
    """
    from .told import told_of
    datablocks.locked.require_editable(material)
    stamp, found = _stamp(material), told_of(material)
    datablocks.materials.remove_standin(material)
    tree, node = material.node_tree, datablocks.materials.our_node(material)
    frame, shader, output = (_new(tree, kind, stamp) for kind in (
        "NodeFrame", "ShaderNodeBsdfPrincipled", "ShaderNodeOutputMaterial"))
    frame.label = iface_("For exporters, not rendered")
    tree.links.new(shader.outputs[0], output.inputs[0])
    for column, one in enumerate((shader, output)):
        one.parent, one.hide = frame, True
        one.location = (node.location.x + 300 * column, node.location.y + ABOVE)
        for socket in one.inputs:
            socket.hide = not socket.is_linked
    _set(shader, found)
    return found


def _new(tree, kind, stamp):
    node = tree.nodes.new(kind)
    node[datablocks.materials.STANDIN_KEY] = stamp
    node.select = False
    return node


def _set(shader, standin):
    """The numbers as they are: such formats mean Rec.709, whatever space the file works in."""
    from ...export import plain
    sockets = {socket.identifier: socket for socket in shader.inputs}
    for identifier, value in plain(standin).items():
        if identifier in sockets:
            sockets[identifier].default_value = value


def _held(material):
    """The stamp of the stand-in that a material has, or ""."""
    key = datablocks.materials.STANDIN_KEY
    return next((node[key] for node in material.node_tree.nodes if key in node), "")


def _stamp(material):
    """Of what a stand-in is made from."""
    said = f"{datablocks.materials.record_of(material).to_json()} {working_space()}"
    return hashlib.sha256(said.encode()).hexdigest()[:16]


# --- File, Export ---

def when_export_opens():
    """What is stale is made anew while the user chooses a format."""
    if not bpy.app.timers.is_registered(next_one):
        bpy.app.timers.register(next_one)


def next_one():
    """One material a turn, so that the menu stays quick."""
    if not _waiting:
        _waiting.extend(material.name for material in stale())
    if _waiting:
        material = bpy.data.materials.get(_waiting.pop())
        if material is not None and datablocks.materials.our_node(material) is not None:
            _say(material, renew(material))
    return 0.0 if _waiting else None


def _say(material, standin):
    from ...export import lost_in
    for form in ("FBX", "OBJ"):
        for sentence in lost_in(standin, form):
            print(f"{material.name}, {form}: {rpt_(sentence)}")


def forget():
    """Make no more, where some are due."""
    _waiting.clear()
    if bpy.app.timers.is_registered(next_one):
        bpy.app.timers.unregister(next_one)
