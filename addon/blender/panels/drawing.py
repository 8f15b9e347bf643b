"""Pieces that several panels draw: sentences in lines, a group's parameters with their units."""

import functools
import textwrap

from bpy.app.translations import pgettext_iface as iface_

from ..datablocks.groups import group_id, model_of_group

__all__ = ["draw_facts", "draw_parameters", "draw_sentence"]

PIXELS_A_LETTER = 6.5


def draw_sentence(layout, text, icon, region=None):
    """A long sentence in a box, as labels of one line each that fit the region."""
    box = layout.box().column(align=True)
    for number, line in enumerate(textwrap.wrap(text, _letters(region))):
        box.label(text=line, icon=icon if number == 0 else "BLANK1", translate=False)


def _letters(region):
    import bpy
    scale = bpy.context.preferences.system.ui_scale or 1.0
    width = region.width if region else 0
    return max(24, int((width / scale - 70) / PIXELS_A_LETTER)) if width else 52


def draw_facts(layout, facts, region=None):
    """Names on the left, values on the right; long values in several lines."""
    column = layout.column(align=True)
    for name, value in facts:
        lines = textwrap.wrap(value, max(20, int(_letters(region) * 0.65))) or [""]
        for number, line in enumerate(lines):
            row = column.split(factor=0.33)
            left = row.row()
            left.alignment = "RIGHT"
            left.label(text=iface_(name) if number == 0 else "", translate=False)
            row.label(text=line, translate=False)


def units_of(tree):
    """{socket: its unit} of one of our groups, for those that Blender does not show by itself, as it does
    for angles.
    """
    identifier = group_id(tree)
    model = model_of_group(identifier)
    return _units(model, identifier) if model else {}


@functools.cache
def _units(model, identifier):
    fed = "" if model.realisation_of(identifier) else identifier
    return {socket.name: socket.unit for row in model.parameters.TABLE if row.group == fed
            for socket in row.sockets() if socket.unit}


def draw_parameters(layout, node):
    """The sockets of a group node with their units, each with the button that plugs a node in."""
    layout.use_property_split = True
    layout.use_property_decorate = False
    column = layout.column()
    units = units_of(node.node_tree)
    for socket in node.inputs:
        if socket.hide_value or not hasattr(socket, "default_value"):
            continue
        unit = units.get(socket.name)
        shown = iface_(socket.name) + (f" ({unit})" if unit else "")
        row = column.row(align=True)
        if socket.is_linked:
            row.label(text=f"{shown}: {socket.links[0].from_node.label or socket.links[0].from_node.name}",
                      icon="LINKED", translate=False)
        else:
            row.prop(socket, "default_value", text=shown, translate=False)
        row.template_node_link(node.id_data, node, socket)
