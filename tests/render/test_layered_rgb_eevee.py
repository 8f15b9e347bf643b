"""The layered model in EEVEE: Standard is made of nodes that EEVEE has, and stands in for the others there."""

import pytest

from addon import api
from addon.blender.datablocks.groups import EEVEE_OUTPUT, node_group

ONLY_IN_CYCLES = {"ShaderNodeScript", "ShaderNodeBsdfMetallic", "ShaderNodeBevel", "ShaderNodeAmbientOcclusion"}


def nodes_of(tree):
    """Every node of a tree and of the groups in it."""
    for node in tree.nodes:
        yield node
        if getattr(node, "node_tree", None):
            yield from nodes_of(node.node_tree)


def test_fast_is_made_of_nodes_that_eevee_has():
    kinds = {node.bl_idname for node in nodes_of(node_group("layered_rgb_fast"))}
    assert not kinds & ONLY_IN_CYCLES
    assert {"ShaderNodeBsdfAnisotropic", "ShaderNodeBsdfDiffuse"} <= kinds


@pytest.mark.parametrize("realisation", ["exact", "osl", "osl_fast"])
def test_fast_stands_in_for_the_others(realisation):
    """An output of its own for EEVEE, fed by the closures of Standard and by no script."""
    material = api.create_material("layered_rgb", preset="nacre", realisation=realisation)
    outputs = {node.target: node for node in material.node_tree.nodes
               if node.bl_idname == "ShaderNodeOutputMaterial"}
    assert set(outputs) == {"CYCLES", "EEVEE"}
    link, = outputs["EEVEE"].inputs["Surface"].links
    assert link.from_socket.name == EEVEE_OUTPUT
    inner = link.from_node.node_tree
    ending = next(node for node in inner.nodes if node.bl_idname == "NodeGroupOutput" and node.is_active_output)
    stand_in = ending.inputs[EEVEE_OUTPUT].links[0].from_node
    assert stand_in.node_tree == node_group("layered_rgb_fast")
    assert len(stand_in.inputs["Refractive Index"].links) == 1
