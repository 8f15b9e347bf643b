"""What an exporter is told of a material: its stand-in, and what of it is lost."""

from bpy.app.translations import pgettext_rpt as rpt_

from ..datablocks.materials import our_node
from ..datablocks.principled import standin_of_material
from .bodies import mean_depth

__all__ = ["told_of"]


def told_of(material):
    """The addon.export.standin.Standin of a material as its node holds it now, or None for one that is not ours.

    What is plugged into the node is among what is lost: other programs do not run it.  A body that colours the light
    is as deep as those of the file are on average, where that can be measured.
    """
    node = our_node(material)
    if node is None:
        return None
    found = standin_of_material(material)
    if found.transmission > 0.0 and not found.thin_walled:
        found = found._replace(thickness=mean_depth(material) or found.thickness)
    plugged = [socket.name for socket in node.inputs if socket.is_linked]
    if not plugged:
        return found
    behind = rpt_("What is plugged into {:s} stays behind").format(", ".join(plugged))
    return found._replace(lost=(*found.lost, behind + "."))
