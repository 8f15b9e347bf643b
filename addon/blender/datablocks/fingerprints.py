"""Fingerprints of node groups: short texts that change with what a group computes and with its interface.

They do not change with the Blender that reads the group, so that a group is known again in any.
"""

import hashlib
import struct

from ...nodes.newcomers import deferred
from .. import compat

__all__ = ["fingerprint", "fingerprint_0_1_0", "fingerprint_of_part"]


def _single(*numbers):
    """Numbers in single precision, as sockets hold them."""
    return struct.unpack(f"{len(numbers)}f", struct.pack(f"{len(numbers)}f", *numbers))


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
    "ShaderNodeLightPath": (), "ShaderNodeObjectInfo": (), "ShaderNodeFloatCurve": (), "ShaderNodeRGBCurve": (),
    "ShaderNodeValToRGB": (), "ShaderNodeFresnel": (), "ShaderNodeClamp": ("clamp_type",),
    "ShaderNodeVectorTransform": ("vector_type", "convert_from", "convert_to"),
    "ShaderNodeTexImage": ("interpolation", "projection", "extension"), "ShaderNodeBsdfTransparent": (),
    "NodeGroupInput": (), "NodeGroupOutput": (), "ShaderNodeGroup": (), "NodeReroute": (),
}
"""Settings of nodes that decide what they compute, by type of node; a test says which a group of ours lacks here."""

IDLE = {
    "PHYSICAL_CONDUCTOR": {"Base Color": (0.617, 0.577, 0.540, 1.0), "Edge Tint": (0.695, 0.726, 0.770, 1.0)},
    "F82": {"IOR": _single(2.757, 2.513, 2.231), "Extinction": _single(3.867, 3.404, 3.009)},
}
"""What the sockets of a Metallic BSDF stand at that do nothing with its kind of Fresnel: Blender converts them where a
file's space changes.
"""

OF_SOCKETS = ("socket_type", "default_value", "min_value", "max_value", "subtype", "hide_value", "identifier")
"""What counts of a socket of the interface; its tooltip does not."""

SETTLED = 1e-5
"""How far a colour's channel may be off three digits and still be them."""

ID_KEY, PART_KEY = "facet_film_id", "facet_film_part"
"""What is kept in our groups: which one it is; and in the parts of them, what they compute."""


def fingerprint(tree, known=None):
    """Of a group's nodes, links, values and interface, and of the parts in it.

    known  fingerprints of parts that were taken already
    """
    digest, known = hashlib.sha256(), {} if known is None else known
    for item in tree.interface.items_tree:
        facts = [item.item_type, item.name, item.parent.name]
        if item.item_type == "SOCKET":
            facts += [item.in_out, *(_shown(getattr(item, name, None)) for name in OF_SOCKETS)]
        digest.update(repr(facts).encode())
    for node in tree.nodes:
        if node.bl_idname != "NodeFrame":
            digest.update(repr(_of_node(node, known)).encode())
    waiting = {f"{node.name}.{fed}": ".".join(source) for node in tree.nodes for fed, source in deferred(node).items()}
    for link in tree.links:
        source, fed = _ends(link)
        if fed not in waiting:
            digest.update(f"{source}>{fed}".encode())
    for fed, source in sorted(waiting.items()):
        digest.update(f"{source}>{fed}".encode())
    return digest.hexdigest()[:16]


def _of_node(node, known):
    kind = node.bl_idname
    facts = [node.name, kind, *(getattr(node, name) for name in SETTINGS.get(kind, ()))]
    if kind == "ShaderNodeMix" and node.factor_mode != "UNIFORM":
        facts.append(node.factor_mode)
    if kind == "ShaderNodeGroup" and node.node_tree is not None:
        facts.append(node.node_tree.get(ID_KEY) or fingerprint_of_part(node.node_tree, known))
    if kind == "ShaderNodeScript" and node.script is not None:
        facts.append(hashlib.sha256(node.script.as_string().encode()).hexdigest())
    if kind in ("ShaderNodeFloatCurve", "ShaderNodeRGBCurve"):  # the three of a colour are alike
        facts.append([tuple(round(x, 5) for x in point.location) for point in node.mapping.curves[0].points])
    if kind == "ShaderNodeValToRGB":  # its colours are converted where a file's space changes
        facts.append([node.color_ramp.interpolation, *(round(stop.position, 5) for stop in node.color_ramp.elements)])
    idle = IDLE.get(getattr(node, "fresnel_type", ""), {})
    facts += [(socket.identifier, _shown(idle.get(socket.identifier, socket.default_value)))
              for socket in _valued(node)]
    return facts


def fingerprint_of_part(tree, known):
    """The fingerprint of a group inside others that has no id of ours, which is kept in `known` by its name."""
    if tree.name not in known:
        known[tree.name] = fingerprint(tree, known)
    return known[tree.name]


def _valued(node):
    """The inputs of a node whose own value counts."""
    waiting = deferred(node)
    return [socket for socket in node.inputs
            if not socket.is_linked and hasattr(socket, "default_value") and not compat.is_unused_newcomer(socket)
            and not (waiting and socket.identifier in waiting)]


def _shown(value):
    if not hasattr(value, "__len__") or isinstance(value, str):
        return value
    return tuple(map(_settled, value)) if len(value) == 4 else tuple(value)


def _settled(x):
    """A colour's channel without what is left of a conversion between working spaces: greys stay grey but for that."""
    near, = _single(round(x, 3))
    return near if abs(x - near) < SETTLED else x


def _ends(link):
    """Where a link comes from, and what it feeds."""
    return (f"{link.from_node.name}.{link.from_socket.identifier}",
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
        digest.update(">".join(_ends(link)).encode())
    return digest.hexdigest()[:16]
