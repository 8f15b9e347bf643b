"""The door for scripts in Blender: bake a measured material, make a Cycles material of it.

>>> from addon import api                                                     # doctest: +SKIP
>>> material = api.create_material(preset="copper", slopes=[(0.2, 1.0)])      # doctest: +SKIP
"""

from .errors import FacetFilmError, choice
from .parameters import CookTorrance

__all__ = ["bake", "create_fresnel_ramp", "create_material", "MODELS"]

MODELS = ("cook_torrance",)
FAR_OFF = 1.0
"""CIEDE2000 from which a conductor's fit is given up where F82 comes closer."""


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
    checked, record, by_f82 = cook_torrance_from_preset(preset, parameters)
    if material is None:
        material = bpy.data.materials.new(name or record.get("title") or "Cook-Torrance")
    apply_cook_torrance(material, checked, realisation, record, by_f82=by_f82)
    return material


def create_fresnel_ramp(preset, **options):
    """The node group that holds a preset's Fresnel curve over N.V, for use in any shader.

    preset, options as :func:`bake` has them.  Returns a bpy.types.ShaderNodeTree,
    the same one for the same curve.  Raises FacetFilmError for an unknown preset.
    """
    from .blender.ramps import fresnel_ramp_group
    return fresnel_ramp_group(bake(preset, **options))


def cook_torrance_from_preset(preset, parameters):
    """Checked parameters of a preset with some overridden, the record of what was baked, and whether
    F82 is the closure that comes closer.

    Blender 4.5's conductor misses dielectrics by several CIEDE2000; F82 does not,
    and takes the n and k of the exact equation.
    """
    if preset is None:
        return CookTorrance().changed(**parameters), {}, False
    baked = bake(preset)
    by_f82 = baked.best == "f82" and baked.conductor.delta_e_2000_max > FAR_OFF
    if by_f82:
        baked = bake(preset, formula="exact")
    defaults = CookTorrance().changed(**baked.cook_torrance_parameters())
    return defaults.changed(**parameters), baked.to_dict(), by_f82
