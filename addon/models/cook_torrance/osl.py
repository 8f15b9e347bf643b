"""The OSL realisations of Cook and Torrance: the formula itself, and native closures."""

from ..osl import build_script

__all__ = ["build", "build_fast"]


def build(builder):
    """The formula itself."""
    from . import MODEL
    build_script(builder, MODEL, "osl")


def build_fast(builder):
    """Native closures."""
    from . import MODEL
    build_script(builder, MODEL, "osl_fast")
