"""Our node groups in the open file: found again by id and version, so that they never multiply."""

import functools
from pathlib import Path

import bpy

from ... import models
from ...models.realisations import REALISATIONS
from ...nodes import newcomers
from .. import compat
from .fingerprints import ID_KEY, fingerprint, fingerprint_0_1_0
from .locked import is_editable
from .parts import as_marked, drop_unused_parts, mark_parts, merge_parts
from .pictures import image_in, image_of, key_of, put_image

__all__ = ["EEVEE_OUTPUT", "LIBRARY", "all_groups", "build_group", "edited", "forget", "group_id", "group_of",
           "input_names", "inputs_named", "is_bringing", "library_file", "mark", "merge_groups", "model_of_group",
           "node_group", "read_ahead", "settled", "socket_named"]

LIBRARY = Path(__file__).parents[3] / "node_groups" / "groups"
"""The groups as tools/build_groups.py built them: appending one takes milliseconds, building one seconds; and of a file
with several Blender reads them all."""

EEVEE_OUTPUT = "EEVEE"
VERSION_KEY = "facet_film_version"
FINGERPRINT_KEY = "facet_film_fingerprint_2"
FINGERPRINT_KEY_0_1_0 = "facet_film_fingerprint"


_bringing = []


def is_bringing():
    """Whether a group is being brought in from our own library, and nobody has appended anything."""
    return bool(_bringing)


@functools.lru_cache(maxsize=1)
def _owners():
    """{group's id: (Model, Group)} of all models, and of the finishes, which belong to no Model."""
    from ...finishes.groups import GROUPS
    found = {group.identifier: (model, group) for model in models.all_models() for group in model.groups}
    return {**found, **{group.identifier: (None, group) for group in GROUPS}}


def forget():
    """Ask the models anew, after one was put on their path or taken off it."""
    _owners.cache_clear()


def all_groups():
    """Every Group of every model, and those of the finishes."""
    return [group for _, group in _owners().values()]


def group_of(identifier):
    """The Group with this id, or None for an id that is none of ours."""
    return _owners()[identifier][1] if identifier in _owners() else None


def model_of_group(identifier):
    """The Model that a group's id belongs to, or None; the groups of finishes belong to none."""
    return _owners()[identifier][0] if identifier in _owners() else None


def node_group(identifier, image=None, whole=None, known=None):
    """The group with this id in the current version, brought in where the file has none as we made it.

    image  that a pictured group shows; by default that of its model's default parameters
    whole  a group that is known to be as we made it
    known  fingerprints of parts that were taken already

    A group that a user has edited is left alone and not reused.
    """
    model, group = _owners()[identifier]
    known = {} if known is None else known
    if group.pictured:
        image = image or image_of(model.picture(model.parameters(), {}))
    ours = [tree for tree in bpy.data.node_groups if tree.get(ID_KEY) == identifier
            and tree.get(VERSION_KEY) == group.version and not tree.library]
    shown = [tree for tree in ours if not group.pictured or key_of(image_in(tree)) == key_of(image)]
    same = [tree for tree in shown if not edited(tree, known)]
    if same:
        return settled(_merged(same, group, image))
    if not group.pictured:
        return _brought(model, group, image)
    like = whole if whole in ours else next((tree for tree in ours if not edited(tree, known)), None)
    return _copied(like, image, known) if like else _brought(model, group, image)


def _brought(model, group, image):
    """A group that the file has none of, from the library or built."""
    before = set(bpy.data.node_groups)
    tree = _from_library(group) or build_group(group.identifier)
    merge_parts(as_marked(set(bpy.data.node_groups) - before))
    if FINGERPRINT_KEY not in tree:
        if group.osl:
            _show_without_osl(tree, node_group(_without_osl(model, group), image))
        if group.stand_in:
            _add_eevee_output(tree, node_group(group.stand_in, image))
        mark(tree, group)
    if group.pictured:
        put_image(tree, image)
    merge_parts()
    return settled(tree)


def settled(tree):
    """The group, its links as this Blender takes them."""
    model = model_of_group(group_id(tree))
    if model is not None and model.newcomers:
        newcomers.settle(tree, compat.has_native_film())
    return tree


def _copied(like, image, known):
    """A copy of a pictured group with another image, which also the groups in it have that are shown in its place."""
    tree = like.copy()
    put_image(tree, image)
    for node in tree.nodes:
        shown = group_of(group_id(getattr(node, "node_tree", None)))
        if shown is not None and shown.pictured:
            node.node_tree = node_group(shown.identifier, image, known=known)
    return tree


def mark(tree, group):
    """Note in a group, once it is whole, which one it is and what it computes."""
    tree[ID_KEY] = group.identifier
    tree[VERSION_KEY] = group.version
    tree[FINGERPRINT_KEY] = fingerprint(tree)


def _merged(trees, group, image):
    """The first of equal groups, in the place of the others: what was dragged or pasted in brings its own."""
    first, *others = trees
    for tree in others:
        tree.user_remap(first)
        bpy.data.node_groups.remove(tree)
    if others and group.stand_in:
        node_group(group.stand_in, image)  # the others brought one of that, too
    if others:
        drop_unused_parts()
    return first


def merge_groups(trees=None):
    """Make one of equal groups of ours, among these trees or all of the file: what comes in brings its own."""
    found = bpy.data.node_groups if trees is None else trees
    ours = {(tree[ID_KEY], image_in(tree)) for tree in found if _is_current(tree)}
    for identifier, image in ours:
        if sum(tree.get(ID_KEY) == identifier for tree in bpy.data.node_groups) > 1:
            node_group(identifier, image)


def _is_current(tree):
    group = group_of(tree.get(ID_KEY))
    return group is not None and is_editable(tree) and tree.get(VERSION_KEY) == group.version


def edited(tree, known=None):
    """Whether someone changed one of our groups since it was made.

    known  fingerprints of parts that were taken already
    """
    if FINGERPRINT_KEY in tree:
        return tree[FINGERPRINT_KEY] != fingerprint(tree, known)
    return tree.get(FINGERPRINT_KEY_0_1_0) != fingerprint_0_1_0(tree)


def build_group(identifier):
    """The group with this id built from its formulas, without a second shader for EEVEE."""
    from ...nodes.builder import GroupBuilder
    model, group = _owners()[identifier]
    builder = GroupBuilder(group.name)
    if model is None:
        from ...finishes.groups import build
        build(group, builder)
    else:
        model.build(identifier, builder)
    tree = builder.finish()
    mark_parts(part.tree for part in builder.parts.values())
    merge_parts()
    return tree


def library_file(identifier):
    """Where the library holds the group with this id; those of the finishes, which are small, are in one file."""
    return LIBRARY / f"{identifier if model_of_group(identifier) else 'finishes'}.blend"


def _from_library(group):
    """The group appended from the library, or None where the library does not hold it."""
    file = library_file(group.identifier)
    if not file.exists():
        return None
    before = set(bpy.data.libraries)
    tree = _appended(bpy.data, file, group)
    for library in set(bpy.data.libraries) - before:
        bpy.data.libraries.remove(library)  # appending leaves an entry from which nothing is linked
    return tree


def _appended(data, file, group):
    """The group out of a file of the library, in the open file's data or other."""
    _bringing.append(group)
    try:
        with data.libraries.load(str(file), link=False) as (_, target):
            target.node_groups = [group.name]
    finally:
        _bringing.pop()
    return target.node_groups[0]


def read_ahead(identifier):
    """Have Blender read a group of the library, beside the open file: the first time takes a quarter longer."""
    file = library_file(identifier)
    if file.exists():
        with bpy.data.temp_data() as beside:
            _appended(beside, file, group_of(identifier))


def _add_eevee_output(tree, fast):
    """Give the group a second shader, Standard with the same inputs, for an EEVEE material output."""
    output = _output_of(tree)
    stand_in = _nested(tree, fast, output.location.y - 300)
    item = tree.interface.new_socket(EEVEE_OUTPUT, description="The Standard realisation, for an EEVEE material output",
                                     in_out="OUTPUT", socket_type="NodeSocketShader")
    target = next(socket for socket in output.inputs if socket.identifier == item.identifier)
    tree.links.new(stand_in.outputs[0], target)


def _show_without_osl(tree, other):
    """Have a group show another one with the same inputs in place of its script, where no script runs.

    There the script's output Runs does not exist, and what it is linked to keeps a value of its own: 0.
    """
    output = _output_of(tree)
    script = output.inputs[0].links[0].from_node
    mix = tree.nodes.new("ShaderNodeMixShader")
    mix.location = output.location
    output.location.x += 200
    fac, without, with_osl = mix.inputs
    fac.default_value = 0.0
    tree.links.new(script.outputs["Runs"], fac)
    tree.links.new(_nested(tree, other, output.location.y - 600).outputs[0], without)
    tree.links.new(script.outputs["BSDF"], with_osl)
    tree.links.new(mix.outputs[0], output.inputs[0])


def _without_osl(model, group):
    """The id of the group that shows what the script of this one does."""
    realisation, variant = model.realisation_of(group.identifier)
    return model.group_of(REALISATIONS[realisation].without_osl, variant).identifier


def _output_of(tree):
    return next(node for node in tree.nodes if node.bl_idname == "NodeGroupOutput")


def _nested(tree, group, height):
    """A node of a group in another one, fed by its inputs of the same names."""
    inputs, node = tree.nodes.new("NodeGroupInput"), tree.nodes.new("ShaderNodeGroup")
    node.node_tree = group
    node.location = (_output_of(tree).location.x - 260, height)
    inputs.location = (node.location.x - 260, height)
    for name in input_names(group):
        tree.links.new(_output_named(inputs, tree, name), socket_named(node, name))
    return node


def group_id(tree):
    """The id of one of our groups, or None."""
    return tree.get(ID_KEY) if tree is not None else None


def input_names(tree):
    """Names of a group's input sockets, in their order."""
    return [item.name for item in tree.interface.items_tree
            if item.item_type == "SOCKET" and item.in_out == "INPUT"]


def socket_named(node, name):
    """The input of a group node that belongs to the interface socket of this name.

    The interface's names are data of ours, never translated; the node's socket
    is then taken by identifier.
    """
    return _by_interface(node.inputs, node.node_tree, name, "INPUT")


def inputs_named(node):
    """{name of the interface socket: input} of a group node."""
    of_identifier = {socket.identifier: socket for socket in node.inputs}
    return {item.name: of_identifier[item.identifier] for item in node.node_tree.interface.items_tree
            if item.item_type == "SOCKET" and item.in_out == "INPUT"}


def output_named(node, name):
    """The output of a group node that belongs to the interface socket of this name."""
    return _by_interface(node.outputs, node.node_tree, name, "OUTPUT")


def _output_named(group_input, tree, name):
    return _by_interface(group_input.outputs, tree, name, "INPUT")


def _by_interface(sockets, tree, name, in_out):
    for item in tree.interface.items_tree:
        if item.item_type == "SOCKET" and item.in_out == in_out and item.name == name:
            return next(socket for socket in sockets if socket.identifier == item.identifier)
    raise KeyError(name)
