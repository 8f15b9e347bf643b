"""The panel of the material's finish: which one, and the controls of its marks."""

import bpy

from .. import datablocks, panels
from ..operators.finish import shown_finish
from .material import MaterialPanel

__all__ = ["CLASSES"]


class FACET_FILM_PT_finish(MaterialPanel, bpy.types.Panel):
    """What was done to the surface, whatever it is made of"""

    bl_label = "Finish"
    bl_parent_id = "FACET_FILM_PT_material"

    @classmethod
    def poll(cls, context):
        """Shown for materials of ours whose model has a roughness."""
        model = datablocks.materials.model_of(context.material)
        if model is None:
            return False
        from ...finishes.feeding import takes
        return takes(model)

    def draw(self, context):
        """A menu of the finishes, and the sockets of the node that leaves the marks."""
        material, layout = context.material, self.layout
        layout.enabled = not datablocks.locked.why_locked(material)
        layout.operator_menu_enum("facet_film.apply_finish", "finish", text=shown_finish(material), translate=False)
        node = datablocks.materials.finish_node(material)
        if node is not None:
            panels.drawing.draw_parameters(layout, node)


CLASSES = (FACET_FILM_PT_finish,)
