"""Finishes: what was done to a surface, whatever it is made of.

A finish says how rough a surface is and, where it leaves marks, which node group varies that over the surface.  It goes
on the materials of every model whose table has a roughness.  What makes its group is a module here with a TABLE of
inputs, what it DRIVES, and a build().  DRIVES names sockets of the material's own group: an output of the group feeds
each, and where it has an input of the same name, that takes the socket's value and gives it back, varied.
"""

from ..models.model import Group
from .finish import Finish, all_finishes, find, names, of_group

__all__ = ["GROUPS", "Finish", "all_finishes", "build", "find", "names", "of_group"]

GROUPS = (
    Group("finish_brushed", "Brushed", 1, "brushed.build", "Parallel streaks, for Roughness, Normal and Tangent"),
    Group("finish_brushed_circular", "Brushed Circular", 1, "circular.build",
          "Streaks in circles, for Roughness, Normal and Tangent"),
    Group("finish_sandblasted", "Sandblasted", 1, "sandblasted.build", "An even, fine grain, for Roughness and Normal"),
    Group("finish_hammered", "Hammered", 1, "hammered.build", "Shallow dimples, for Roughness and Normal"),
    Group("finish_cast", "Cast", 1, "cast.build", "The skin of a sand mould, for Roughness and Normal"),
    Group("finish_scratched", "Scratched", 1, "scratched.build", "Fine scratches, for Roughness and Normal"),
    Group("finish_smudged", "Smudged", 1, "smudged.build", "Fingerprints and wipe marks, for Roughness"),
    Group("finish_worn_edges", "Worn Edges", 1, "worn.build", "Edges rubbed bright, for Roughness and Tint"),
)
"""Every node group of a finish."""


def build(group, builder):
    """Build a Group of GROUPS into a GroupBuilder."""
    from importlib import import_module
    module, _, function = group.build.partition(".")
    getattr(import_module(f".{module}", __name__), function)(builder)
