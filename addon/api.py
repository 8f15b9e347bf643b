"""The door for scripts in Blender: bake a measured material, make a Cycles material of it.

>>> from addon import api                                                     # doctest: +SKIP
>>> material = api.create_material(preset="copper", slopes=[(0.2, 1.0)])      # doctest: +SKIP
"""

from .errors import FacetFilmError, choice
from .parameters import CookTorrance

__all__ = ["bake", "create_material", "MODELS"]

MODELS = ("cook_torrance",)


def bake(preset, **options):
    """Bake a measured material for this Blender and the open file; a :class:`addon.bake.Bake`.

    preset   preset name or alias, or a dataset such as "main/Cu/Johnson"
    options  as :func:`addon.bake.bake` has them; `formula` is by default the
             conductor Fresnel that this Blender evaluates, `space` the file's
             scene-linear space.

    Raises FacetFilmError for an unknown preset or option.
    """
    from .bake import bake as bake_spectrum
    from .blender import compat
    options.setdefault("formula", compat.conductor_formula())
    options.setdefault("space", compat.working_space())
    return bake_spectrum(preset, **options)


def create_material(model="cook_torrance", *, preset=None, realisation="fast", name=None, material=None,
                    **parameters):
    """A Cycles material of one of the models.

    model        "cook_torrance"
    preset       preset name or alias, or a dataset; None for the parameters alone
    realisation  "fast"
    name         of the new material; by default the preset's title
    material     an existing bpy.types.Material to be made over, in place of a new one
    parameters   of the model, over the preset's own: see :class:`addon.parameters.CookTorrance`

    Returns the bpy.types.Material.  Raises FacetFilmError, before anything is
    made or changed, for an unknown name or a value out of range.
    """
    import bpy

    from .blender.materials import GROUP_OF, apply_cook_torrance
    choice("model", model, MODELS)
    choice("realisation", realisation, GROUP_OF)
    if name is not None and (not isinstance(name, str) or not name):
        raise FacetFilmError(f"name must be a text with at least one letter, not {name!r}.")
    checked, record = cook_torrance_from_preset(preset, parameters)
    if material is None:
        material = bpy.data.materials.new(name or record.get("title") or "Cook-Torrance")
    apply_cook_torrance(material, checked, realisation, record)
    return material


def cook_torrance_from_preset(preset, parameters):
    """Checked parameters of a preset with some of them overridden, and the record of what was baked."""
    if preset is None:
        return CookTorrance().changed(**parameters), {}
    baked = bake(preset)
    defaults = CookTorrance().changed(**baked.cook_torrance_parameters())
    return defaults.changed(**parameters), baked.to_dict()
