"""The door for scripts in Blender: bake a measured material, make a Cycles material of it.

>>> from addon import api                                                     # doctest: +SKIP
>>> material = api.create_material(preset="copper", slopes=[(0.2, 1.0)])      # doctest: +SKIP
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from . import finishes, models
from .models.realisations import REALISATIONS

if TYPE_CHECKING:
    import bpy

    from .bake import Bake
    from .measured import Fit
    from .models.record import Record

__all__ = ["FINISHES", "MODELS", "REALISATIONS", "apply_finish", "bake", "common_face", "create_fresnel_ramp",
           "create_material", "export", "fit", "principled_twin", "ready_for_export", "rebake", "record_of",
           "switch_realisation"]

MODELS = models.names()
FINISHES = finishes.names()


def bake(preset: Any, **options: Any) -> Bake:
    """Bake a measured material for this Blender and the open file; a :class:`addon.bake.Bake`.

    preset   what :func:`addon.catalogue.resolving.resolve` understands: a preset's
             name or alias, a dataset such as "main/Cu/Johnson", a file, OpticalConstants
    options  as :func:`addon.bake.bake` has them; `formula` is by default the
             conductor Fresnel that this Blender evaluates, `space` the file's
             scene-linear space.

    Raises FacetFilmError for an unknown preset or option.
    """
    from .bake import bake as bake_spectrum
    from .blender import compat
    return bake_spectrum(preset, **{**compat.renderer()._asdict(), **options})


def create_material(model: str | None = None, *, preset: Any = None, realisation: str = "usual",
                    name: str | None = None, material: bpy.types.Material | None = None,
                    viewing: Mapping[str, Any] | None = None,
                    finish: str | None = None, **parameters: Any) -> bpy.types.Material:
    """A Cycles material.

    model        a name of MODELS; by default that of the preset, else "cook_torrance"
    preset       preset's name or alias; or a dataset, a file of yours or OpticalConstants; None for the parameters
                 alone
    realisation  "standard" (clean and fast), "reference" (the published formula itself, slower and noisier), "osl" (the
                 formula as an OSL script), "osl_standard" (Standard as an OSL script), "dispersive" (of clear
                 materials: with the colours of the rainbow); by default the one that the preset is meant for, else
                 "standard".  Where Open Shading Language is off, a material by OSL shows "reference" or "standard"
                 instead, and a warning says so.  Files know them as "fast", "exact" and "osl_fast", which go as well
    name         of the new material; by default the preset's title
    material     an existing bpy.types.Material to be made over, in place of a new one
    viewing      options of :func:`bake` as a dict: illuminant, observer, space, adapt, gamut; for what is measured
    finish       a name of FINISHES: see docs/finishes.md; "" for the preset's own surface; by default that of the
                 material that is made over
    parameters   of the model, over the preset's own and the finish's: see docs/parameters.md

    Returns the bpy.types.Material.  Raises FacetFilmError, before anything is
    made or changed, for an unknown name, a value out of range, a material that
    is linked, or a realisation that this Blender cannot compile.
    """
    from .blender import compat
    from .blender.datablocks import locked, materials
    from .models.finishing import kept_finish
    from .models.making import made
    if material is not None:
        locked.require_editable(material)
    materials.require_name(name)
    record = made(model, preset, realisation, compat.renderer(), viewing, finish or "", **parameters)
    if finish is None and materials.our_node(material) is not None:
        record = kept_finish(materials.record_of(material), record)
    _require_osl(record.realisation)
    _warn_without_osl(record.realisation)
    return materials.create(record, name, material)


def fit(path: str, *, progress: Callable[[float], Any] | None = None, **options: Any) -> Fit:
    """A model fitted to a measured BRDF; a :class:`addon.measured.Fit`.  It needs no Blender.

    path      of a .bsdf of RGL-EPFL (isotropic, RGB), a .binary of MERL, or a text of points
    progress  function that is told the share that is done, 0 to 1; where it gives False the fit stops
    options   fresnel: "best", "f0", "n_k" or "curve"; slopes: 1 to 3; distribution: "beckmann" or "gaussian"

    Raises FacetFilmError for a file that cannot be used, an unknown option, and where it was stopped.

    >>> material = api.create_material(preset=api.fit("satin_purple_rgb.bsdf").preset())       # doctest: +SKIP
    """
    from .measured import fit as fit_measured
    return fit_measured(path, progress=progress, **options)


def switch_realisation(material: bpy.types.Material, realisation: str) -> None:
    """Render one of our materials by another realisation; everything that the user set stays.

    material     a bpy.types.Material made by :func:`create_material`
    realisation  "standard", "reference", "osl", "osl_standard" or, of clear materials, "dispersive"

    Where n and k are still as baked and the other realisation evaluates another
    Fresnel formula (Blender 4.5), they are baked again for it.  Raises
    FacetFilmError for a material that is not ours or linked, or an unknown realisation.
    """
    from .blender import compat
    from .blender.datablocks import locked, materials
    from .models.making import switched
    record = materials.record_of(material)
    locked.require_editable(material)
    new = switched(record, realisation, compat.renderer())
    _require_osl(new.realisation)
    _warn_without_osl(new.realisation)
    materials.write(material, new)


def apply_finish(material: bpy.types.Material, finish: str) -> None:
    """Give one of our materials another finish; what it is made of stays.

    material  a bpy.types.Material made by :func:`create_material`
    finish    a name of FINISHES; "" for the preset's own surface

    Raises FacetFilmError for an unknown finish, with the nearest ones, a material whose model has no roughness, and
    one that is not ours or linked.
    """
    from .blender.datablocks import locked, materials
    from .models.finishing import finished
    record = materials.record_of(material)
    locked.require_editable(material)
    materials.write(material, finished(record, finish))


def common_face(inside: bpy.types.Material, outside: bpy.types.Material | None,
                name: str | None = None) -> bpy.types.Material:
    """A new material for the face where two clear bodies touch, such as water and its glass, which is to be there once.

    inside   material of the body that the face's normals point out of: the water's
    outside  material of the other body, the glass's; None for air
    name     of the new material; by default "Water against Window glass"

    Raises FacetFilmError for a material that is not ours, or not clear.

    >>> wall = api.common_face(water, glass)                                                   # doctest: +SKIP
    """
    from .blender.datablocks import materials
    from .models.touching import touching
    materials.require_name(name)
    record = touching(materials.record_of(inside), outside and materials.record_of(outside))
    return materials.create(record, name or f"{inside.name} against {outside.name if outside else 'air'}")


def rebake(material: bpy.types.Material, viewing: Mapping[str, Any] | None = None) -> None:
    """Bake the measurement of one of our materials again; what the user set beside it stays.

    viewing  options of :func:`bake`; by default those it was baked with, in the file's scene-linear space

    Raises FacetFilmError for a material without a measurement, or a linked one.
    """
    from .blender import compat
    from .blender.datablocks import locked, materials
    from .models.making import rebaked
    record = materials.record_of(material)
    locked.require_editable(material)
    materials.write(material, rebaked(record, compat.renderer(), viewing))


def record_of(material: bpy.types.Material) -> Record:
    """What one of our materials is made of, as its nodes hold it now: an :class:`addon.models.record.Record`.

    Raises FacetFilmError for a material that is not ours.
    """
    from .blender.datablocks import materials
    return materials.record_of(material)


def export(material: bpy.types.Material, form: str) -> str:
    """One of our materials for other programs: what its node holds now, in the light that it was baked in.

    form  one that its model has: "json", "csv", "spectrum_csv", "materialx"

    Returns text.  Raises FacetFilmError for a material that is not ours, or another form.
    """
    from .models.making import exported
    return exported(record_of(material), form)


def principled_twin(material: bpy.types.Material, name: str | None = None) -> bpy.types.Material:
    """A new material of one Principled BSDF that comes closest to one of ours, as its node holds it now.

    name  of the new material; by default that of the material and "Principled"

    Fitted for the least CIEDE2000 over the angles that a ball shows; the mean and what is lost stand in its custom
    properties "facet_film_delta_e" and "facet_film_lost".  For engines and bakers that know no closures of ours.

    Raises FacetFilmError for a material that is not ours.
    """
    from .blender.datablocks import materials, principled
    materials.require_name(name)
    return principled.twin_of(material, name)


def ready_for_export(materials: Iterable[bpy.types.Material] | None = None) -> dict[str, dict[str, tuple[str, ...]]]:
    """Put what FBX, OBJ and other exporters read into materials of ours: a Principled BSDF that nothing renders.

    materials  by default all of this file that are ours and may be changed

    In a window File, Export does this by itself; glTF and USD do without.  Returns, for each material's name, what FBX
    and OBJ lose of it, as {"FBX": sentences, "OBJ": sentences}.  The nodes go again with the next change through a door
    of this extension; after a change of sockets call it again.

    Raises FacetFilmError for a material that is not ours, and for one that is linked.
    """
    from .blender.exporters import standins
    from .export import lost_in
    chosen = standins.ours() if materials is None else list(materials)
    found = {material.name: standins.renew(material) for material in chosen}
    return {name: {form: lost_in(standin, form) for form in ("FBX", "OBJ")} for name, standin in found.items()}


def create_fresnel_ramp(preset: Any, **options: Any) -> bpy.types.NodeTree:
    """The node group that holds a preset's Fresnel curve over N.V, for use in any shader.

    preset, options as :func:`bake` has them.  Returns a bpy.types.ShaderNodeTree,
    the same one for the same curve.  Raises FacetFilmError for an unknown preset.
    """
    from .blender.datablocks.ramps import fresnel_ramp_group
    return fresnel_ramp_group(bake(preset, **options))


def _require_osl(realisation):
    from .nodes.osl_compiler import require_osl
    if REALISATIONS[realisation].osl:
        require_osl()


def _warn_without_osl(realisation):
    """Tell the script that called what the open scene shows in place of an OSL script, where it runs none."""
    import bpy

    from .blender.missing import why_no_script_runs
    why = why_no_script_runs(bpy.context.scene, realisation)
    if why:
        warnings.warn(why, stacklevel=3)
