"""All that an add-on could leave in Blender; for the sessions, which run outside the checkout."""

import gc

import bpy
import bpy.utils.previews

__all__ = ["traces", "datablocks", "timers_of"]


def traces():
    """Classes, operators, menu entries, handlers, properties, kept values, shortcuts, previews, asset libraries."""
    seen = {f"type {name}" for name in dir(bpy.types)}
    seen |= {f"operator {room}.{name}" for room in dir(bpy.ops) for name in dir(getattr(bpy.ops, room))}
    for name in dir(bpy.types):
        cls = getattr(bpy.types, name)
        if not hasattr(cls, "bl_rna"):
            continue
        draw_functions = getattr(getattr(cls, "draw", None), "_draw_funcs", ())
        # Blender lists its own drawing too, as soon as anyone adds to it.
        seen |= {f"entry in {name}: {function.__module__}.{function.__qualname__}" for function in draw_functions
                 if function.__module__.startswith("bl_ext.")}
        seen |= {f"property {name}.{key}" for key in cls.bl_rna.properties.keys()}
    for name in dir(bpy.app.handlers):
        handlers = getattr(bpy.app.handlers, name)
        if isinstance(handlers, list):
            seen |= {f"handler {name}: {getattr(handler, '__module__', '')}" for handler in handlers}
    for owner in (*bpy.data.window_managers, *bpy.data.scenes, *bpy.data.workspaces):
        kept = owner.bl_system_properties_get() if hasattr(owner, "bl_system_properties_get") else None
        seen |= {f"value {owner.name}: {key}" for key in (*owner.keys(), *(kept.keys() if kept else ()))}
    seen |= {f"shortcut {keymap.name}: {item.idname}" for keys in bpy.context.window_manager.keyconfigs
             for keymap in keys.keymaps for item in keymap.keymap_items}
    seen |= {f"previews {identifier}" for identifier in bpy.utils.previews._uuid_open}
    # From 5.1 on ours is switched off: taken out and added again in one session, 5.2 would show nothing of it.
    seen |= {f"library {library.name}" for library in bpy.context.preferences.filepaths.asset_libraries
             if getattr(library, "enabled", True)}
    return seen


def datablocks():
    """How many of each kind the file holds."""
    return {name: len(getattr(bpy.data, name)) for name in dir(bpy.data)
            if isinstance(getattr(bpy.data, name), bpy.types.bpy_prop_collection)}


def timers_of(prefix):
    """Functions of modules of this name that Blender's timers hold: everything else of a module is gone or its own."""
    return sorted({f"{found.__module__}.{found.__qualname__}" for found in gc.get_objects()
                   if callable(found) and str(getattr(found, "__module__", "")).startswith(prefix)
                   and _is_timer(found)})


def _is_timer(function):
    try:
        return bpy.app.timers.is_registered(function)
    except (TypeError, ValueError):
        return False
