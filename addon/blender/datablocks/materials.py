"""Our materials, whatever the model: a group node with its sockets set, wired to the output, and the record kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from ...errors import FacetFilmError
from ...finishes import of_group
from ..compat import enable_nodes, set_refraction
from .groups import (
    EEVEE_OUTPUT,
    VERSION_KEY,
    edited,
    group_id,
    group_of,
    input_names,
    inputs_named,
    model_of_group,
    node_group,
    output_named,
    settled,
    socket_named,
)
from .locked import is_editable
from .pictures import image_in, image_of, key_of, sockets_of_image, values_of_image

if TYPE_CHECKING:  # loading it is left to the first material, as enabling waits for what is imported here
    from ...models.record import Record

__all__ = ["RECORD_KEY", "STANDIN_KEY", "baked_of", "create", "exchange_group", "finish_node", "finish_of", "found_in",
           "in_solid_view", "is_measured", "model_of", "our_node", "parameters_of", "realisation_of", "record_of",
           "record_of_node", "remove_standin", "require_name", "write", "write_node"]

RECORD_KEY = "facet_film"
STANDIN_KEY = "facet_film_standin"
"""Of the nodes that are there for exporters alone; what it holds says which numbers they are of."""
NODE_WIDTH = 240
FEED_WIDTH = 200
METALS_FROM = 0.1, 0.3
"""Largest normal reflectance from which a surface counts as a metal in the Solid viewport, and quite as one."""
METALNESS = 0.4
"""Of a metal there, by eye."""


# --- A record into a material ---

def create(record: Record, name: str | None = None, material: bpy.types.Material | None = None) -> bpy.types.Material:
    """A new material of a record, or an existing one made over.

    name  of the material; by default the record's title, also for one that still bears its old record's
    """
    if material is None:
        material = bpy.data.materials.new(name or record.title)
    elif name or material.name.rsplit(".", 1)[0] == baked_of(material).get("title"):
        material.name = name or record.title
    write(material, record)
    return material


def require_name(name) -> None:
    """Raise FacetFilmError for what cannot be a material's name; None is none."""
    if name is not None and (not isinstance(name, str) or not name):
        raise FacetFilmError("name must be a text with at least one letter, not {text!r}.", text=name)


def write(material: bpy.types.Material, record: Record) -> None:
    """Make the material what the record says, in place of what fed its surface.

    Links into a node of ours that is there already stay.
    """
    enable_nodes(material)
    node = our_node(material)
    if node is None:
        material.node_tree.nodes.clear()
        node = material.node_tree.nodes.new("ShaderNodeGroup")
        node.width = NODE_WIDTH
    remove_standin(material)
    write_node(material.node_tree, node, record)
    model = model_of_group(record.group)
    set_refraction(material, model.refracts(record.parameters), model.sheet(record.parameters))
    material[RECORD_KEY] = record.to_json()
    _show_in_viewport(material, record)


def remove_standin(material: bpy.types.Material) -> None:
    """Take away the nodes that stand in for a material in exporters: they are of what it was."""
    for node in [node for node in material.node_tree.nodes if STANDIN_KEY in node]:
        material.node_tree.nodes.remove(node)


def write_node(tree: bpy.types.NodeTree, node: bpy.types.Node, record: Record) -> None:
    """Make one of our group nodes what the record says: its group, its values, and the nodes that feed it."""
    model, there = model_of_group(record.group), _feeding(node)
    group = model.group(record.group)
    image = image_of(model.picture(record.parameters, record.viewing)) if group.pictured else None
    if not _keeps(node.node_tree, group, image):
        _set_group(tree, node, node_group(record.group, image, whole=node.node_tree))
    elif is_editable(node.node_tree):
        settled(node.node_tree)  # which another Blender may have written
    values = {**model.written(record.parameters, record.realisation), **sockets_of_image(image_in(node.node_tree))}
    inputs = inputs_named(node)
    for name, value in values.items():
        inputs[name].default_value = value
    from ...finishes.feeding import feeds
    _write_feeds(tree, node, there, (*model.feeds(record.parameters), *feeds(record)))


def _keeps(tree, group, image):
    """Whether a node that has this tree needs no other for a group: it is the current one, or someone edited it."""
    if group_id(tree) != group.identifier:
        return False
    current = tree.get(VERSION_KEY) == group.version and key_of(image_in(tree)) == key_of(image)
    return current or edited(tree)


def _show_in_viewport(material, record):
    """Colour, metalness and gloss for the Solid viewport."""
    seen = model_of_group(record.group).look(record.parameters, None)
    colour, metallic = in_solid_view(seen)
    material.diffuse_color = (*map(float, colour), 1.0)
    material.metallic = metallic
    material.roughness = float(seen.slope) ** 0.5


def in_solid_view(seen):
    """(linear RGB, metalness) of a Look in the Solid viewport, whose few lamps leave a metal nothing to mirror.

    Wholly metallic it would be black there but for its highlights; METALNESS shows them and its colour.  That is as of
    light reflected twice, as in a metal's hollows: reflected once, copper looks like clay and steel like chromium.

    >>> from ...models.model import Look
    >>> in_solid_view(Look((0.9, 0.6, 0.5), (0.9, 0.6, 0.5), 1.0, 0.1, (0.0, 0.0, 0.0)))
    ([0.81, 0.36, 0.25], 0.4)
    >>> in_solid_view(Look((0.5, 0.2, 0.1), (0.04, 0.04, 0.04), 0.5, 0.1, (0.48, 0.18, 0.08)))
    ([0.5, 0.2, 0.1], 0.0)
    """
    low, high = METALS_FROM
    metal = seen.specular * min(max((max(seen.mirror) - low) / (high - low), 0.0), 1.0)
    colour = [whole * (1.0 + metal * (once - 1.0)) for whole, once in zip(seen.colour, seen.mirror)]
    return colour, METALNESS * float(metal)


def _write_feeds(tree, node, there, feeds):
    """Have just these groups of ours feed the node, in place of those that did; what else is plugged in stays."""
    for identifier, feed in there.items():
        if identifier not in {wanted.group for wanted in feeds}:
            _remove_feed(tree, node, feed)
    for number, wanted in enumerate(feeds):
        feed = there.get(wanted.group) or _new_feed(tree, node, wanted.group, number)
        for name, value in wanted.values.items():
            socket_named(feed, name).default_value = value
        _link_feed(tree, node, feed, wanted.links)


def _remove_feed(tree, node, feed):
    """Take a feed away; what was plugged into an input of the same name as the node's goes back to that."""
    fed = {link.to_socket.name for link in tree.links if link.from_node == feed and link.to_node == node}
    back = [(link.from_socket, link.to_socket.name) for link in tree.links
            if link.to_node == feed and link.to_socket.name in fed]
    tree.nodes.remove(feed)
    for source, name in back:
        tree.links.new(source, socket_named(node, name))


def _new_feed(tree, node, identifier, number):
    feed = tree.nodes.new("ShaderNodeGroup")
    feed.node_tree = node_group(identifier)
    feed.label = feed.node_tree.name
    feed.location = (node.location.x - (FEED_WIDTH + 80) * (number + 1), node.location.y)
    feed.width = FEED_WIDTH
    return feed


def _link_feed(tree, node, feed, links):
    for link in [link for link in tree.links if link.from_node == feed and link.to_node == node]:
        if (link.from_socket.name, link.to_socket.name) not in links.items():
            tree.links.remove(link)
    for output, name in links.items():
        target = socket_named(node, name)
        if target.is_linked and target.links[0].from_node != feed and name in input_names(feed.node_tree):
            tree.links.new(target.links[0].from_socket, socket_named(feed, name))
        tree.links.new(output_named(feed, output), target)


def _feeding(node):
    """{group's id: node} of the groups of ours that feed the node and are no material themselves."""
    found = {}
    for link in [link for socket in node.inputs if socket.is_linked for link in socket.links]:
        tree = getattr(link.from_node, "node_tree", None)
        if group_of(group_id(tree)) is not None and found_in(tree) is None:
            found[group_id(tree)] = link.from_node
    return found


# --- A record out of a material ---

def record_of(material: bpy.types.Material) -> Record:
    """What one of our materials is made of, as its nodes hold it now.

    Textures on a socket are not seen.  Raises FacetFilmError for a material
    that is not ours, and where someone set sockets to what cannot be.
    """
    node = our_node(material)
    if node is None:
        raise FacetFilmError("{material} is not a material of Facet & Film: make one with create_material() "
                             "or Bake Spectral Preset.", material=material.name)
    from ...models.record import from_json
    return from_json(material.get(RECORD_KEY, ""), record_of_node(node))


def record_of_node(node: bpy.types.Node) -> Record:
    """What one of our group nodes holds: parameters, and how they are rendered."""
    from ...models.record import Record
    identifier = group_id(node.node_tree)
    model, realisation = found_in(node.node_tree)
    feeding = _feeding(node)
    feeds = {name: (_values(feed), _outputs_to(node, feed)) for name, feed in feeding.items()}
    values = {**_values(node), **values_of_image(image_in(node.node_tree))}
    marks = next((name for name in feeds if of_group(name)), None)
    if marks is None:
        finish, controls = "", {}
    else:
        finish, controls = of_group(marks).name, _controls(marks, feeds[marks], values)
    return Record(model.name, realisation, identifier, node.node_tree.get(VERSION_KEY, 0), model.read(values, feeds),
                  finish=finish, controls=controls)


def _outputs_to(node, feed):
    """Names of a feed's outputs that are linked to the node."""
    return {link.from_socket.name for link in node.id_data.links if link.from_node == feed and link.to_node == node}


def _controls(group, fed, values):
    """The controls of a finish's group; what it holds of the material's own sockets goes among the values."""
    from ...finishes.feeding import changed_controls
    of_feed, outputs = fed
    shared = {name for name in outputs if name in values and name in of_feed}
    values.update({name: of_feed[name] for name in shared})
    return changed_controls(group, of_feed, shared)


def _values(node):
    """{socket: value} of a group node."""
    found = {}
    for name, socket in inputs_named(node).items():
        value = socket.default_value
        found[name] = tuple(value) if hasattr(value, "__len__") else value
    return found


def parameters_of(material):
    """The parameters that one of our materials holds; textures on a socket are not seen."""
    return record_of_node(our_node(material)).parameters


def baked_of(material):
    """What was baked into a material, ready for JSON; {} for others."""
    if RECORD_KEY not in material:
        return {}
    from ...models.record import baked_in
    return baked_in(material.get(RECORD_KEY, ""))


def finish_of(material):
    """Name of a material's finish, or ""; what panels draw at each redraw."""
    from ...finishes.feeding import held
    from ...models.record import finish_in
    node = finish_node(material)
    return held(finish_in(material.get(RECORD_KEY, "")), of_group(group_id(node.node_tree)).name if node else "")


def finish_node(material):
    """The node that leaves the marks of a material's finish, or None."""
    node = our_node(material)
    feeding = _feeding(node) if node else {}
    return next((feed for name, feed in feeding.items() if of_group(name)), None)


def is_measured(material):
    """Whether a spectrum was baked into a material."""
    return "illuminant" in baked_of(material)


def our_node(material):
    """The node of one of our groups that the material renders with, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.bl_idname == "ShaderNodeGroup" and found_in(node.node_tree) is not None:
            return node
    return None


def found_in(tree):
    """(Model, realisation) of a node group, or None for one that renders no material of ours."""
    identifier = group_id(tree)
    model = model_of_group(identifier)
    realisation = model and model.realisation_of(identifier)
    return (model, realisation[0]) if realisation else None


def model_of(material):
    """The Model of a material, or None for one that is not ours."""
    node = our_node(material)
    return found_in(node.node_tree)[0] if node else None


def realisation_of(material):
    """Name of a material's realisation, or None for one that is not ours."""
    node = our_node(material)
    return found_in(node.node_tree)[1] if node else None


# --- Groups of nodes, exchanged ---

def exchange_group(tree, node, group):
    """Put another version of its group into a node; values and links stay, outputs of the same name too.

    What the other version holds in sockets of other names is read as parameters.
    """
    targets = [(link.from_socket.name, link.to_socket) for output in node.outputs for link in output.links]
    known, values = input_names(node.node_tree), _written_anew(node)
    _set_values(tree, node, group)
    for name in input_names(group):
        if name in values and name not in known:
            socket_named(node, name).default_value = values[name]
    for name, target in targets:
        found = next((output for output in node.outputs if output.name == name), None)
        if found is not None:
            tree.links.new(found, target)


def _written_anew(node):
    """{socket: value} of a node of ours as this version has them; {} for one that renders no material."""
    if found_in(node.node_tree) is None:
        return {}
    model, realisation = found_in(node.node_tree)
    try:
        return model.written(record_of_node(node).parameters, realisation)
    except FacetFilmError:
        return {}


def _set_group(tree, node, group):
    """Give the node this group; values and links go over to sockets of the same name."""
    if node.node_tree == group:
        return
    was_output = node.node_tree is None or _feeds_output(node)
    targets = [link.to_socket for output in node.outputs[:1] for link in output.links]
    _set_values(tree, node, group)
    if was_output:
        _wire_outputs(tree, node)
    else:
        for target in targets:
            tree.links.new(node.outputs[0], target)


def _feeds_output(node):
    return any(link.to_node.bl_idname == "ShaderNodeOutputMaterial" for output in node.outputs for link in output.links)


def _set_values(tree, node, group):
    """Give the node this group with the values and links that it had."""
    values, sources = {}, {}
    if node.node_tree is not None:
        for name, socket in inputs_named(node).items():
            if hasattr(socket, "default_value"):
                value = socket.default_value
                values[name] = tuple(value) if hasattr(value, "__len__") else value
            if socket.is_linked:
                sources[name] = socket.links[0].from_socket
    node.node_tree = group
    node.label = group.name
    for name in input_names(group):
        if name in values:
            socket_named(node, name).default_value = values[name]
        if name in sources:
            tree.links.new(sources[name], socket_named(node, name))


def _wire_outputs(tree, node):
    """One material output for all engines, or one for Cycles and one for EEVEE where the group has two shaders."""
    for output in [n for n in tree.nodes if n.bl_idname == "ShaderNodeOutputMaterial"]:
        if output.inputs[0].is_linked and output.inputs[0].links[0].from_node != node:
            continue
        tree.nodes.remove(output)
    wanted = {"ALL": 0}
    if len(node.outputs) > 1 and node.outputs[1].name == EEVEE_OUTPUT:
        wanted = {"CYCLES": 0, "EEVEE": 1}
    for target, index in wanted.items():
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        if index == 0:
            output.is_active_output = True  # whatever other outputs there are
        output.target = target
        output.location = (node.location.x + NODE_WIDTH + 60, node.location.y - 160 * index)
        tree.links.new(node.outputs[index], output.inputs[0])
