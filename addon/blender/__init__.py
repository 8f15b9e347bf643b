"""The Blender side: thin, one thing a file."""

from importlib import import_module

__all__ = ["on_demand"]


def on_demand(package):
    """The ``__getattr__`` of a package whose modules load when they are first asked for, as ``package.module``.

    What Blender loads at its start names the package alone.
    """
    def module(name):
        if name.startswith("__"):
            raise AttributeError(name)
        return import_module(f".{name}", package)
    return module
