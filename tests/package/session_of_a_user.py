"""What a user does with the zip, in a Blender with an empty profile: install, use, disable, enable, remove.

    BLENDER_USER_RESOURCES=EMPTY_FOLDER python session_of_a_user.py ZIP REPORT

Started by test_installed.py; REPORT is written as JSON and says what was seen at each step.
"""

import json
import os
import sys
import traceback
from pathlib import Path

import bpy
from traces import traces

MODULE = "bl_ext.user_default.facet_film"
ZIP, REPORT = sys.argv[1:]


def installed_folder():
    return Path(bpy.utils.user_resource("EXTENSIONS")) / "user_default" / "facet_film"


def installed_files():
    folder = installed_folder()
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*")
                  if path.is_file() and path.suffix != ".pyc")


def surface_of(material):
    """What an untouched eye sees in the node editor: the node that feeds the surface, and its values."""
    output = next(node for node in material.node_tree.nodes if node.bl_idname == "ShaderNodeOutputMaterial")
    links = output.inputs["Surface"].links
    node = links[0].from_node if links else None
    values = {socket.name: list(socket.default_value) if hasattr(socket.default_value, "__len__")
              else socket.default_value for socket in node.inputs if hasattr(socket, "default_value")}
    return {"node": node.bl_idname, "values": values, "inner": sorted(set(kinds_in(node)))}


def kinds_in(node):
    """The kinds of nodes in a group node and in the groups within it."""
    for inner in node.node_tree.nodes if getattr(node, "node_tree", None) else ():
        yield inner.bl_idname
        yield from kinds_in(inner)


def go_through(report):
    """Every step, noting what is seen as it goes."""
    before = traces()
    bpy.ops.extensions.package_install_files(filepath=ZIP, repo="user_default", enable_on_install=True)
    report["enabled"] = MODULE in bpy.context.preferences.addons and MODULE in sys.modules
    report["added"] = sorted(traces() - before)
    report["files"] = installed_files()

    from bl_ext.user_default.facet_film.addon import api
    target = bpy.context.active_object
    target.data.materials.clear()
    report["result"] = sorted(bpy.ops.facet_film.bake_preset(preset="copper"))
    report["material"] = target.active_material.name
    report["surface"] = surface_of(target.active_material)
    report["conductor"] = api.bake("copper").to_dict()["conductor"]
    groups = len(bpy.data.node_groups)
    bpy.ops.facet_film.bake_preset(preset="gold")
    report["groups"] = [groups, len(bpy.data.node_groups)]
    report["files_after_use"] = installed_files()

    bpy.ops.preferences.addon_disable(module=MODULE)
    report["left"] = sorted(traces() ^ before)
    report["surface_when_disabled"] = surface_of(target.active_material)["node"]
    bpy.ops.preferences.addon_enable(module=MODULE)
    report["added_again"] = sorted(traces() - before)
    repositories = [repository.module for repository in bpy.context.preferences.extensions.repos]
    bpy.ops.extensions.package_uninstall(repo_index=repositories.index("user_default"), pkg_id="facet_film")
    report["left_when_removed"] = sorted(traces() ^ before)
    report["folder_left"] = installed_folder().exists()


def main():
    report = {"failure": ""}
    try:
        go_through(report)
    except Exception:
        report["failure"] = traceback.format_exc()
    Path(REPORT).write_text(json.dumps(report), encoding="utf-8")
    # Blender can hang at its exit over what an add-on leaves behind, and the report says more.
    os._exit(0)


main()
