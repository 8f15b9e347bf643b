"""What the first preset needs, loaded while Blender is idle: no start-up and no click waits for it."""

import bpy

__all__ = ["when_idle", "forget", "load"]

_asked = []


def when_idle():
    """Load once, as soon as the window has nothing else to do: called where the button that needs it is drawn."""
    if not _asked and not bpy.app.background:
        _asked.append(True)
        bpy.app.timers.register(load, persistent=True)  # opening a file drops the others


def forget():
    """Load no more, if it has not come to that yet."""
    _asked.clear()
    if bpy.app.timers.is_registered(load):
        bpy.app.timers.unregister(load)


def load():
    """Bake a preset and read its group, and forget both: modules and tables are there from then on, and Blender knows
    where it has what it reads groups with.
    """
    from ... import api  # noqa: F401  (and what the operator takes of its own, when it comes to that)
    from ...models.making import made
    from ...nodes import osl_compiler  # noqa: F401
    from .. import missing  # noqa: F401
    from ..datablocks import materials, untouched  # noqa: F401
    from ..datablocks.groups import read_ahead
    from . import picker  # noqa: F401
    read_ahead(made(preset="copper").group)
