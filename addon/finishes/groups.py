"""The node groups of the finishes; the modules that build them stand beside this one."""

from importlib import import_module

from ..models.model import Group

__all__ = ["GROUPS", "build"]

GROUPS = (
    Group("finish_brushed", "Brushed", 5, "brushed.build",
          "Parallel streaks, for Roughness, Normal, Tangent and Diffuse Color"),
    Group("finish_brushed_circular", "Brushed Circular", 5, "circular.build",
          "Streaks in circles, for Roughness, Normal, Tangent and Diffuse Color"),
    Group("finish_sandblasted", "Sandblasted", 6, "sandblasted.build",
          "An even, fine grain, for Roughness, Normal and Diffuse Color"),
    Group("finish_hammered", "Hammered", 5, "hammered.build", "Shallow dimples, for Roughness and Normal"),
    Group("finish_cast", "Cast", 4, "cast.build", "The skin of a sand mould, for Roughness and Normal"),
    Group("finish_scratched", "Scratched", 6, "scratched.build",
          "Scratches and hairlines, for Roughness, Normal and Diffuse Color"),
    Group("finish_smudged", "Smudged", 6, "smudged.build",
          "Fingerprints and wipe marks, for Roughness and Diffuse Color"),
    Group("finish_worn_edges", "Worn Edges", 5, "worn.build", "Edges rubbed bright, for Roughness and Tint"),
)
"""Every node group of a finish."""


def build(group, builder):
    """Build a Group of GROUPS into a GroupBuilder."""
    module, _, function = group.build.partition(".")
    getattr(import_module(f".{module}", __package__), function)(builder)
