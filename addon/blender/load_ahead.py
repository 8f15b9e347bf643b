"""What the first preset needs, loaded while Blender is idle: enabling does not wait for it, and no click does."""

import bpy

__all__ = ["attach", "detach", "load"]


def attach():
    """Load once, as soon as the window has nothing else to do; without a window nobody clicks."""
    if not bpy.app.background:
        bpy.app.timers.register(load, persistent=True)  # opening a file drops the others


def detach():
    """Load no more, if it has not come to that yet."""
    if bpy.app.timers.is_registered(load):
        bpy.app.timers.unregister(load)


def load():
    """Bake a preset and forget it: the modules and the tables are there from then on."""
    from ..bake import bake
    bake("copper")
