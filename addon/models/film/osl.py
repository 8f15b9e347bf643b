"""The OSL realisation of films: the formula as a script, with nodes beside it that look its colours up.

A script cannot read an image that is packed into a file.  So it stands in the group twice: the first draws a facet and
gives its V·H, the table is looked up there, and the second draws the same facet and has the colour.
"""

from ...operands import less, part, where
from .exact import looks_at
from .lookup import absorbed
from .surface import Surface

__all__ = ["build"]


def build(builder):
    """Build the group."""
    from . import MODEL
    surface = Surface(builder, "osl")
    file = MODEL.folder / f"{MODEL.name}.osl"
    tangent = {"Tangent": _tangent(builder, surface.sockets.tangent, surface.sockets.anisotropy)}
    v_h = builder.script(file, tangent, "VH")
    seen = {"SeenFacet": surface.look(v_h), "SeenView": surface.look(surface.n_v),
            "SeenAbsorbed": absorbed(builder, surface.n_v, surface.table)}
    for number, m in ((1, surface.m), (2, surface.second)):
        seen[f"SeenMiddle{number}"], seen[f"SeenLeast{number}"] = looks_at(builder, surface.n_v, m, surface.table)
    builder.output("BSDF", builder.script(file, {**tangent, **seen}))


@part("Tangent of the Script")
def _tangent(builder, tangent, anisotropy):
    """The surface's own tangent where nothing is plugged in, which a script does not get to know by itself; none where
    nothing turns on it.
    """
    return where(less(0.0, anisotropy), builder.tangent(tangent), (0.0, 0.0, 0.0))
