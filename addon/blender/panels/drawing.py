"""Pieces that several panels draw: sentences in lines, a group's parameters with their units."""

import functools
import textwrap

from bpy.app.translations import pgettext_iface as iface_

from .. import datablocks

__all__ = ["draw_facts", "draw_parameters", "draw_sentence", "draw_socket"]

PIXELS_A_LETTER = 6.5


def draw_sentence(layout, text, icon, region=None):
    """A long sentence in a box, as labels of one line each that fit the region."""
    box = layout.box().column(align=True)
    for number, line in enumerate(_wrapped(text, _letters(region))):
        box.label(text=line, icon=icon if number == 0 else "BLANK1", translate=False)


@functools.lru_cache(maxsize=256)
def _wrapped(text, letters):
    """Lines of a text, which is the same at nearly every redraw."""
    return textwrap.wrap(text, letters)


def _letters(region):
    import bpy
    scale = bpy.context.preferences.system.ui_scale or 1.0
    width = region.width if region else 0
    return max(24, int((width / scale - 70) / PIXELS_A_LETTER)) if width else 52


def draw_facts(layout, facts, region=None):
    """Names on the left, values on the right; long values in several lines."""
    column = layout.column(align=True)
    for name, value in facts:
        lines = _wrapped(value, max(20, int(_letters(region) * 0.65))) or [""]
        for number, line in enumerate(lines):
            row = column.split(factor=0.33)
            left = row.row()
            left.alignment = "RIGHT"
            left.label(text=iface_(name) if number == 0 else "", translate=False)
            row.label(text=line, translate=False)


def described(tree):
    """{socket's name: its addon.models.parameters.Socket} of one of our groups."""
    identifier = datablocks.groups.group_id(tree)
    model = datablocks.groups.model_of_group(identifier)
    return _described(model, identifier) if model else {}


@functools.cache
def _described(model, identifier):
    fed = "" if model.realisation_of(identifier) else identifier
    return {socket.name: socket for row in model.parameters.TABLE if row.group == fed for socket in row.sockets()}


def draw_parameters(layout, node):
    """The sockets of a group node, each with its unit and the button that plugs a node in; some in closed panels."""
    layout.use_property_split = True
    layout.use_property_decorate = False
    bodies = {"": layout.column()}
    known = described(node.node_tree)
    for socket in node.inputs:
        if socket.hide_value or not hasattr(socket, "default_value"):
            continue
        panel = known[socket.name].panel if socket.name in known else ""
        if panel not in bodies:
            bodies[panel] = _closed_panel(layout, node, panel)
        if bodies[panel] is not None:
            draw_socket(bodies[panel], node, socket, known.get(socket.name))


def _closed_panel(layout, node, title):
    """The column of a panel within a panel, or None while it is closed."""
    header, body = layout.panel(f"facet_film_{datablocks.groups.group_id(node.node_tree)}_{title}", default_closed=True)
    header.label(text=iface_(title), translate=False)
    return body


def draw_socket(column, node, socket, known):
    """A socket's value, or what is plugged into it; with its unit, and what else its value means."""
    shown = iface_(socket.name) + (f" ({known.unit})" if known and known.unit else "")
    row = column.row(align=True)
    if socket.is_linked:
        row.label(text=f"{shown}: {socket.links[0].from_node.label or socket.links[0].from_node.name}",
                  icon="LINKED", translate=False)
    else:
        beside = f" ({known.beside(socket.default_value)})" if known and known.beside else ""
        row.prop(socket, "default_value", text=shown + beside, translate=False)
    row.template_node_link(node.id_data, node, socket)
