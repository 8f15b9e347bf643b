"""Fingerprints of node groups: short texts that change with what a group computes and with its interface.

They do not change with the Blender that reads the group, so that a group is known again in any.
"""

import hashlib

from .. import compat

__all__ = ["fingerprint", "fingerprint_0_1_0"]

SETTINGS = {
    "ShaderNodeMath": ("operation", "use_clamp"), "ShaderNodeVectorMath": ("operation",),
    "ShaderNodeMix": ("data_type", "clamp_factor"), "ShaderNodeTexWhiteNoise": ("noise_dimensions",),
    "ShaderNodeVectorRotate": ("rotation_type",), "ShaderNodeBsdfMetallic": ("distribution", "fresnel_type"),
    "ShaderNodeBsdfAnisotropic": ("distribution",), "ShaderNodeTangent": ("direction_type", "axis"),
    "ShaderNodeScript": ("mode",), "ShaderNodeTexNoise": ("noise_dimensions", "noise_type", "normalize"),
    "ShaderNodeBump": ("invert",), "ShaderNodeMixShader": (), "ShaderNodeAddShader": (), "ShaderNodeBsdfDiffuse": (),
    "ShaderNodeSeparateXYZ": (), "ShaderNodeCombineXYZ": (), "ShaderNodeNewGeometry": (), "ShaderNodeTexCoord": (),
    "ShaderNodeBsdfGlass": ("distribution",), "ShaderNodeBsdfRefraction": ("distribution",),
    "ShaderNodeTexVoronoi": ("voronoi_dimensions", "feature", "distance", "normalize"),
    "ShaderNodeAmbientOcclusion": ("samples", "inside", "only_local"),
    "ShaderNodeLightPath": (), "ShaderNodeFloatCurve": (),
    "ShaderNodeVectorTransform": ("vector_type", "convert_from", "convert_to"),
    "ShaderNodeTexImage": ("interpolation", "projection", "extension"), "ShaderNodeBsdfTransparent": (),
    "NodeGroupInput": (), "NodeGroupOutput": (), "ShaderNodeGroup": (), "NodeReroute": (),
}
"""Settings of nodes that decide what they compute, by type of node; a test says which a group of ours lacks here."""

OF_SOCKETS = ("socket_type", "default_value", "min_value", "max_value", "subtype", "hide_value", "identifier")
"""What counts of a socket of the interface; its tooltip does not."""

ID_KEY = "facet_film_id"


def fingerprint(tree):
    """Of a group's nodes, links, values and interface."""
    digest = hashlib.sha256()
    for item in tree.interface.items_tree:
        facts = [item.item_type, item.name, item.parent.name]
        if item.item_type == "SOCKET":
            facts += [item.in_out, *(_shown(getattr(item, name, None)) for name in OF_SOCKETS)]
        digest.update(repr(facts).encode())
    for node in tree.nodes:
        if node.bl_idname != "NodeFrame":
            digest.update(repr(_of_node(node)).encode())
    for link in tree.links:
        digest.update(_of_link(link).encode())
    return digest.hexdigest()[:16]


def _of_node(node):
    kind = node.bl_idname
    facts = [node.name, kind, *(getattr(node, name) for name in SETTINGS.get(kind, ()))]
    if kind == "ShaderNodeGroup" and node.node_tree is not None:
        facts.append(node.node_tree.get(ID_KEY, node.node_tree.name))
    if kind == "ShaderNodeScript" and node.script is not None:
        facts.append(hashlib.sha256(node.script.as_string().encode()).hexdigest())
    if kind == "ShaderNodeFloatCurve":
        facts.append([tuple(round(x, 5) for x in point.location) for point in node.mapping.curves[0].points])
    facts += [(socket.identifier, _shown(socket.default_value)) for socket in _valued(node)]
    return facts


def _valued(node):
    """The inputs of a node whose own value counts."""
    return [socket for socket in node.inputs
            if not socket.is_linked and hasattr(socket, "default_value") and not compat.is_unused_newcomer(socket)]


def _shown(value):
    return tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


def _of_link(link):
    return (f"{link.from_node.name}.{link.from_socket.identifier}>"
            f"{link.to_node.name}.{link.to_socket.identifier}")


def fingerprint_0_1_0(tree):
    """As 0.1.0 took it, without interface, settings and scripts: to know whether someone edited a group of
    its files.
    """
    digest = hashlib.sha256()
    for node in tree.nodes:
        if node.bl_idname == "NodeFrame":
            continue
        digest.update(f"{node.name} {node.bl_idname} {getattr(node, 'operation', '')}".encode())
        for socket in _valued(node):
            digest.update(f"{socket.identifier}{_shown(socket.default_value)}".encode())
    for link in tree.links:
        digest.update(_of_link(link).encode())
    return digest.hexdigest()[:16]
