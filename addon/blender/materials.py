"""Our materials, whatever the model: a group node with its sockets set, wired to the output."""

import json

from . import cook_torrance_material, layered_material
from .compat import enable_nodes
from .groups import EEVEE_OUTPUT, group_id, input_names, node_group, socket_named

__all__ = ["MODELS", "apply", "switch", "rebake", "exchange_group", "our_node", "model_of", "realisation_of",
           "parameters_of", "record_of", "found_in"]

MODELS = {"cook_torrance": cook_torrance_material, "layered_rgb": layered_material}
"""Model -> module with GROUP_OF, F82_GROUP_OF, write, read and show_in_viewport."""

RECORD_KEY = "facet_film"
NODE_WIDTH = 240


def apply(material, model, parameters, realisation, record, *, by_f82=False):
    """Make the material one of this model and these parameters, in place of what fed its surface.

    record is kept in the material as JSON: what was baked, from which dataset,
    with which error.  Links into a node of ours that is there already stay.
    """
    module = MODELS[model]
    group = node_group((module.F82_GROUP_OF if by_f82 else module.GROUP_OF)[realisation])
    enable_nodes(material)
    node = our_node(material)
    if node is None:
        material.node_tree.nodes.clear()
        node = material.node_tree.nodes.new("ShaderNodeGroup")
        node.width = NODE_WIDTH
    _set_group(material.node_tree, node, group)
    module.write(node, parameters)
    material[RECORD_KEY] = json.dumps(record)
    module.show_in_viewport(material, parameters)


def switch(material, realisation, *, by_f82=False):
    """Render one of our materials by another realisation, keeping every value and link that the user set."""
    module = MODELS[model_of(material)]
    group = node_group((module.F82_GROUP_OF if by_f82 else module.GROUP_OF)[realisation])
    _set_group(material.node_tree, our_node(material), group)


def rebake(material, parameters, record):
    """Write parameters and record of a new bake into one of our materials."""
    module = MODELS[model_of(material)]
    module.write(our_node(material), parameters)
    material[RECORD_KEY] = json.dumps(record)
    module.show_in_viewport(material, parameters)


def exchange_group(tree, node, group):
    """Put another version of its group into a node; values and links stay, outputs of the same name too."""
    targets = [(link.from_socket.name, link.to_socket) for output in node.outputs for link in output.links]
    _set_values(tree, node, group)
    for name, target in targets:
        found = next((output for output in node.outputs if output.name == name), None)
        if found is not None:
            tree.links.new(found, target)


def _set_group(tree, node, group):
    """Give the node this group; values and links go over to sockets of the same name."""
    if node.node_tree == group:
        return
    _set_values(tree, node, group)
    _wire_outputs(tree, node)


def _set_values(tree, node, group):
    """Give the node this group with the values and links that it had."""
    values, sources = {}, {}
    if node.node_tree is not None:
        for name in input_names(node.node_tree):
            socket = socket_named(node, name)
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
        output.target = target
        output.location = (node.location.x + NODE_WIDTH + 60, node.location.y - 160 * index)
        tree.links.new(node.outputs[index], output.inputs[0])


def our_node(material):
    """The node of one of our groups that the material renders with, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.bl_idname == "ShaderNodeGroup" and found_in(node.node_tree) is not None:
            return node
    return None


def found_in(tree):
    """(model, realisation) of a node group, or None for one that is not a material of ours."""
    identifier = group_id(tree)
    for model, module in MODELS.items():
        for groups in (module.GROUP_OF, module.F82_GROUP_OF):
            for realisation, group in groups.items():
                if group == identifier:
                    return model, realisation
    return None


def model_of(material):
    """"cook_torrance" or "layered_rgb", or None for a material that is not ours."""
    node = our_node(material)
    return found_in(node.node_tree)[0] if node else None


def realisation_of(material):
    """"fast", "exact", "osl" or "osl_fast", or None for a material that is not ours."""
    node = our_node(material)
    return found_in(node.node_tree)[1] if node else None


def parameters_of(material):
    """The parameters that one of our materials holds; textures on a socket are not seen."""
    return MODELS[model_of(material)].read(our_node(material))


def record_of(material):
    """What was baked into the material, as create_material wrote it; empty for others."""
    try:
        return json.loads(material.get(RECORD_KEY, "{}"))
    except (TypeError, ValueError):
        return {}
