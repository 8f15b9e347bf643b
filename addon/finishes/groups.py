"""The node groups of the finishes; the modules that build them stand beside this one."""

from importlib import import_module

from ..models.model import Group

__all__ = ["GROUPS", "build"]

GROUPS = (
    Group("finish_brushed", "Brushed", 4, "brushed.build",
          "Parallel streaks, for Roughness, Normal, Tangent and Diffuse Color"),
    Group("finish_brushed_circular", "Brushed Circular", 4, "circular.build",
          "Streaks in circles, for Roughness, Normal, Tangent and Diffuse Color"),
    Group("finish_sandblasted", "Sandblasted", 5, "sandblasted.build",
          "An even, fine grain, for Roughness, Normal and Diffuse Color"),
    Group("finish_hammered", "Hammered", 4, "hammered.build", "Shallow dimples, for Roughness and Normal"),
    Group("finish_cast", "Cast", 3, "cast.build", "The skin of a sand mould, for Roughness and Normal"),
    Group("finish_scratched", "Scratched", 5, "scratched.build",
          "Scratches and hairlines, for Roughness, Normal and Diffuse Color"),
    Group("finish_smudged", "Smudged", 5, "smudged.build",
          "Fingerprints and wipe marks, for Roughness and Diffuse Color"),
    Group("finish_worn_edges", "Worn Edges", 4, "worn.build", "Edges rubbed bright, for Roughness and Tint"),
)
"""Every node group of a finish."""


def build(group, builder):
    """Build a Group of GROUPS into a GroupBuilder."""
    module, _, function = group.build.partition(".")
    getattr(import_module(f".{module}", __package__), function)(builder)
