"""Facet & Film: measured metals and layered films for Cycles."""

__all__ = ["register", "unregister"]


def register():
    """Register classes and menus with Blender; nothing is read and nothing else is imported."""
    from .blender import registration
    registration.register()


def unregister():
    """Take back what register() did."""
    from .blender import registration
    registration.unregister()
