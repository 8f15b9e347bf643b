"""The OSL realisations of Cook and Torrance: the formula itself, and native closures."""

from ..osl import build_script

__all__ = ["build", "build_fast"]


def build(builder):
    """The formula itself."""
    from . import MODEL
    build_script(builder, MODEL, "osl", _tangent)


def build_fast(builder):
    """Native closures."""
    from . import MODEL
    build_script(builder, MODEL, "osl_fast", _tangent)


def _tangent(sockets):
    """The surface's own tangent where nothing is plugged in, which a script does not get to know by itself."""
    return {"Tangent": sockets.tangent.builder.tangent(sockets.tangent)}
