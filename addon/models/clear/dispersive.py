"""Dispersive: every path has one wavelength of its own, from entry to exit."""

from ...operands import less
from ..parameters import add_inputs
from .frosted import frosted
from .parameters import TABLE
from .polished import polished
from .surfaces import FROSTED, given, mixed, sheet, with_straight_shadows

__all__ = ["build"]


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "dispersive")
    at = given(builder, sockets)
    body = mixed(builder, less(FROSTED, sockets.roughness), polished(builder, sockets, at),
                 frosted(builder, sockets, at))
    solid = with_straight_shadows(builder, sockets, at, body)
    builder.output("BSDF", mixed(builder, sockets.thin, solid, sheet(builder, sockets, at)))
