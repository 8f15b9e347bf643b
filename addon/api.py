"""The door for scripts in Blender: bake a measured material, make a Cycles material of it.

>>> from addon import api                                                     # doctest: +SKIP
>>> material = api.create_material(preset="copper", slopes=[(0.2, 1.0)])      # doctest: +SKIP
"""

from .errors import FacetFilmError, choice
from .parameters import REALISATIONS, CookTorrance

__all__ = ["bake", "create_fresnel_ramp", "create_material", "measurement_of", "rebake", "rebaked",
           "switch_realisation", "MODELS", "REALISATIONS"]

MODELS = ("cook_torrance", "layered_rgb")
FAR_OFF = 1.0
"""CIEDE2000 from which a conductor's fit is given up where F82 comes closer."""

OWN_DATA = "own_data"
"""Of a material's record: the spectrum that the user brought, as CSV."""

NATIVE_FRESNEL = ("fast", "osl_fast")
"""Realisations whose Fresnel term is the renderer's own."""


def bake(preset, **options):
    """Bake a measured material for this Blender and the open file; a :class:`addon.bake.Bake`.

    preset   preset name or alias, a dataset such as "main/Cu/Johnson", or OpticalConstants
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
                    viewing=None, **parameters):
    """A Cycles material of one of the models.

    model        "cook_torrance", or "layered_rgb"
    preset       preset name or alias, or for Cook-Torrance a dataset or OpticalConstants (a file of yours, read by
                 :func:`addon.spectra.readers.read`); None for the parameters alone
    realisation  "fast" (native closures), "exact" (the formula, nodes alone), "osl" (the formula, by OSL)
                 or "osl_fast" (closures, by OSL)
    name         of the new material; by default the preset's title
    material     an existing bpy.types.Material to be made over, in place of a new one
    viewing      options of :func:`bake` as a dict: illuminant, observer, space, adapt, gamut; Cook-Torrance only
    parameters   of the model, over the preset's own: see :class:`addon.parameters.CookTorrance`
                 and :class:`addon.layered_parameters.LayeredRGB`

    Returns the bpy.types.Material.  Raises FacetFilmError, before anything is
    made or changed, for an unknown name, a value out of range, or a realisation
    that this Blender cannot compile.
    """
    import bpy

    from .blender import materials
    choice("model", model, MODELS)
    choice("realisation", realisation, REALISATIONS)
    if name is not None and (not isinstance(name, str) or not name):
        raise FacetFilmError("name must be a text with at least one letter, not {text!r}.", text=name)
    by_f82 = False
    if model == "layered_rgb":
        checked, record = layered_from_preset(preset, parameters)
    else:
        checked, record, by_f82 = cook_torrance_from_preset(preset, parameters, realisation, viewing)
    _require_osl(realisation)
    title = record.get("title") or TITLES[model]
    if material is None:
        material = bpy.data.materials.new(name or title)
    elif name or material.name.rsplit(".", 1)[0] == materials.record_of(material).get("title"):
        material.name = name or title  # one that still bears its preset's title takes the new one's
    materials.apply(material, model, checked, realisation, record, by_f82=by_f82)
    return material


TITLES = {"cook_torrance": "Cook-Torrance", "layered_rgb": "Layered RGB"}


def switch_realisation(material, realisation):
    """Render one of our materials by another realisation; everything that the user set stays.

    material     a bpy.types.Material made by :func:`create_material`
    realisation  "fast", "exact", "osl" or "osl_fast"

    Where n and k are still as baked and the other realisation evaluates another
    Fresnel formula (Blender 4.5), they are baked again for it.  Raises
    FacetFilmError for a material that is not ours, or an unknown realisation.
    """
    from .blender import materials
    choice("realisation", realisation, REALISATIONS)
    model = materials.model_of(material)
    if model is None:
        raise FacetFilmError("{material} is not a material of Facet & Film: make one with create_material() "
                             "or Bake Spectral Preset.", material=material.name)
    _require_osl(realisation)
    baked_again = _baked_again(material, realisation) if model == "cook_torrance" else None
    if baked_again is None:
        materials.switch(material, realisation)
        return
    baked, by_f82 = baked_again
    parameters = materials.parameters_of(material).changed(n=baked.conductor.n, k=baked.conductor.k)
    materials.switch(material, realisation, by_f82=by_f82)
    materials.rebake(material, parameters, _record(baked, measurement_of(materials.record_of(material))))


def rebaked(material, viewing=None):
    """(parameters, record, by_f82) of one of our materials whose measurement is baked again; nothing is changed.

    viewing  options of :func:`bake`; by default those it was baked with

    n, k and the diffuse colour are new; all else stays as the user set it.
    Raises FacetFilmError for a material without a measurement.
    """
    from .blender import materials
    record = materials.record_of(material)
    if materials.model_of(material) != "cook_torrance" or "conductor" not in record:
        raise FacetFilmError("{material} holds no measurement: bake a Cook-Torrance preset first.", material=material.name)
    options = _viewing_of(record) if viewing is None else viewing
    baked, by_f82 = _baked_for(measurement_of(record), materials.realisation_of(material), options)
    new = baked.cook_torrance_parameters()
    parameters = materials.parameters_of(material).changed(n=new["n"], k=new["k"], diffuse=new["diffuse"])
    return parameters, _record(baked, measurement_of(record)), by_f82


def rebake(material, viewing=None):
    """Bake the measurement of one of our materials again, as :func:`rebaked` describes, and write it in."""
    from .blender import materials
    parameters, record, by_f82 = rebaked(material, viewing)
    materials.switch(material, materials.realisation_of(material), by_f82=by_f82)
    materials.rebake(material, parameters, record)


def create_fresnel_ramp(preset, **options):
    """The node group that holds a preset's Fresnel curve over N.V, for use in any shader.

    preset, options as :func:`bake` has them.  Returns a bpy.types.ShaderNodeTree,
    the same one for the same curve.  Raises FacetFilmError for an unknown preset.
    """
    from .blender.ramps import fresnel_ramp_group
    return fresnel_ramp_group(bake(preset, **options))


def cook_torrance_from_preset(preset, parameters, realisation, viewing=None):
    """Checked parameters of a preset with some overridden, the record of what was baked, and whether
    F82 is the closure that comes closer."""
    if preset is None:
        return CookTorrance().changed(**parameters), {}, False
    baked, by_f82 = _baked_for(preset, realisation, viewing or {})
    defaults = CookTorrance().changed(**baked.cook_torrance_parameters())
    return defaults.changed(**parameters), _record(baked, preset), by_f82


def measurement_of(record):
    """What a material's record was baked from, to bake it again: a name, or the user's own OpticalConstants."""
    if OWN_DATA not in record:
        return record["name"]
    from .spectra.readers import read_text
    return read_text(record[OWN_DATA], record["source"]["dataset"].removeprefix("file:"))


def _record(baked, preset):
    """What was baked, with the points of a user's own measurement, which no database holds."""
    record = baked.to_dict()
    if not isinstance(preset, str):
        from .export import spectrum_csv
        record[OWN_DATA] = spectrum_csv(preset)
    return record


def layered_from_preset(preset, parameters):
    """Checked parameters of a layered preset with some overridden, and what to keep of the preset."""
    from .layered_parameters import LayeredRGB
    from .layered_presets import layered_preset
    if preset is None:
        return LayeredRGB().changed(**parameters), {}
    found = layered_preset(preset)
    record = {"model": "layered_rgb", "name": preset, "title": found.title, "kind": found.kind, "note": found.note}
    return found.layered_rgb().changed(**parameters), record


def _baked_for(preset, realisation, options):
    """The bake whose n and k belong to what the realisation evaluates, and whether that is F82.

    The formulas take the exact equation.  So does F82, which Fast takes for a
    dielectric where Blender 4.5's conductor misses it by several CIEDE2000.
    """
    from .blender import compat
    exact = bake(preset, **options, formula="exact")
    if realisation not in NATIVE_FRESNEL:
        return exact, False
    baked = exact if compat.conductor_formula() == "exact" else bake(preset, **options)
    by_f82 = baked.best == "f82" and baked.conductor.delta_e_2000_max > FAR_OFF
    return (exact, True) if by_f82 else (baked, False)


def _baked_again(material, realisation):
    """The bake of the material's measurement for another realisation, and whether it is for F82.

    None where n and k are no longer as baked.
    """
    from .blender import materials
    record = materials.record_of(material)
    if not record or not _as_baked(materials.parameters_of(material), record):
        return None
    return _baked_for(measurement_of(record), realisation, _viewing_of(record))


def _viewing_of(record):
    """The options that a record was baked with."""
    options = {option: record[option] for option in ("illuminant", "observer", "space")}
    return {**options, "gamut": record["gamut"]["method"], "adapt": record["adapted"]}


def _as_baked(parameters, record):
    """Whether n and k are still those of the record."""
    found, baked = (*parameters.n, *parameters.k), (*record["conductor"]["n"], *record["conductor"]["k"])
    return all(abs(a - b) <= 1e-5 * max(1.0, abs(b)) for a, b in zip(found, baked))


def _require_osl(realisation):
    if realisation in ("osl", "osl_fast"):
        from .nodes.osl_compiler import why_no_osl
        reason = why_no_osl()
        if reason:
            raise FacetFilmError(reason)
