"""What the panels draw, without a window: a stand-in for Blender's layouts, which exist only while it draws one."""

from types import SimpleNamespace

import bpy

__all__ = ["Layout", "drawn", "properties_editor"]


class Layout:
    """Takes what panels call of a bpy.types.UILayout.

    texts       labels and the texts of buttons, in order
    operators   names of the operators that have a button
    properties  names of the properties that are shown; each is read, as Blender does to show it
    enabled     whether what is in it can be used
    """

    enabled = True

    def __init__(self, parent=None):
        for name in ("texts", "operators", "properties"):
            setattr(self, name, getattr(parent, name) if parent else [])

    def row(self, *_arguments, **_options):
        """A part of this layout."""
        return Layout(self)

    column = box = split = grid_flow = row

    def panel(self, _name, default_closed=False):
        """(head, body) of a part that opens and closes; Blender gives no body of one that is closed."""
        return Layout(self), None if default_closed else Layout(self)

    def label(self, *, text="", **_options):
        """Note the text."""
        self.texts.append(text)

    def operator(self, name, text="", **_options):
        """Note the button; what is set on what comes back is not checked."""
        self.operators.append(name)
        self.texts.append(text)
        return SimpleNamespace()

    def operator_menu_enum(self, name, _property, text="", **_options):
        """Note the button."""
        return self.operator(name, text)

    def prop(self, data, name, text="", **_options):
        """Read the property, and note what it is called where that is not its own name."""
        getattr(data, name)
        self.properties.append(name)
        if text:
            self.texts.append(text)

    prop_menu_enum = template_icon_view = prop

    def template_icon(self, *_arguments, **_options):
        """Nothing to note."""

    template_node_link = separator = menu = popover = template_asset_shelf_popover = template_list = template_icon


def properties_editor(target=None, material=None):
    """The context of the Properties editor, on an object and its material; by default the active ones."""
    target = target or bpy.context.active_object
    return SimpleNamespace(
        object=target, active_object=target, material=material or getattr(target, "active_material", None),
        selected_objects=[target] if target else [], scene=bpy.context.scene, window_manager=bpy.context.window_manager,
        preferences=bpy.context.preferences, region=SimpleNamespace(width=400))


def drawn(panel, context):
    """The Layout that a panel fills, or None where its poll hides it."""
    if hasattr(panel, "poll") and not panel.poll(context):
        return None
    layout = Layout()
    if hasattr(panel, "draw_header_preset"):
        panel.draw_header_preset(SimpleNamespace(layout=layout), context)
    panel.draw(SimpleNamespace(layout=layout), context)
    return layout
