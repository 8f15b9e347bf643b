"""Makes records: of a preset or measurement, of another realisation, of the same measurement baked again."""

from collections.abc import Callable, Mapping
from typing import Any

from ..catalogue.resolving import of_stack, resolve
from ..errors import FacetFilmError, choice
from . import DEFAULT, named, names
from .finishing import under_finish
from .model import Renderer
from .parameters import Colour
from .realisations import realisation_chosen
from .record import Record, Source

USUAL = "usual"
"""In place of a realisation: the preset's own, or "fast"."""
ANY_RENDERER = Renderer()
"""The exact formula and Rec.709: what Blender 5 has by default."""

__all__ = ["USUAL", "exported", "made", "of_other_words", "rebaked", "renewed", "switched"]


def made(model: str | None = None, preset: Any = None, realisation: str = USUAL, renderer: Renderer = ANY_RENDERER,
         viewing: Mapping[str, Any] | None = None, finish: str = "", **parameters: Any) -> Record:
    """The Record of a preset or measurement, with some parameters of one's own.

    model        name of a model; by default the preset's
    preset       what :func:`addon.catalogue.resolving.resolve` understands; None for the parameters alone
    realisation  one that the model has, by either of its names ("fast" or "standard", "exact" or "reference", …); by
                 default the preset's own, as "dispersive" of diamond, else "fast"
    renderer     whose formula and working space the numbers are for
    viewing      options of :func:`addon.bake.bake`: illuminant, observer, space, adapt, gamut, medium
    finish       name of a finish, over the preset's own surface; "" for that
    parameters   of the model, over the preset's own and the finish's

    Raises FacetFilmError for an unknown name, a preset of another model, or a value out of range.

    >>> made(preset="nacre").model, made(preset="copper", specular=0.5).parameters.specular
    ('layered_rgb', 0.5)
    """
    if model is not None:
        choice("model", model, names())
    resolved = None if preset is None else resolve(preset)
    chosen = named(model or (resolved and resolved.preset.model) or DEFAULT)
    resolved = _what_it_is_made_of(chosen, resolved, parameters)
    if realisation == USUAL:
        realisation = _usual(chosen, resolved)
    realisation = realisation_chosen(realisation, chosen.realisations)
    finish, parameters = under_finish(finish, chosen, parameters)
    if resolved is None:
        checked = chosen.parameters().changed(**parameters)
        return _with_group(Record(chosen.name, realisation, "", 0, checked, finish=finish), chosen)
    _require_of(chosen, resolved)
    options = _viewing(chosen, resolved, renderer, viewing)
    baked = chosen.bake(resolved, options, realisation, renderer)
    typed = _typed_colours(chosen, resolved, options.get("space", renderer.space))
    checked = chosen.parameters().changed(**{**baked.parameters, **typed}).changed(**parameters)
    record = Record(chosen.name, realisation, "", 0, checked, _source(resolved), options, baked.facts, finish)
    return _with_group(record, chosen, baked.variant)


def switched(record: Record, realisation: str, renderer: Renderer = ANY_RENDERER) -> Record:
    """The Record by another realisation; everything that the user set stays.

    Where what was baked is still as it was, it is baked again for what the
    other realisation evaluates.

    >>> switched(made(preset="nacre"), "exact").group
    'layered_rgb_exact'
    """
    model = named(record.model)
    realisation = realisation_chosen(realisation, model.realisations)
    if record.measured and model.as_baked(record.parameters, record.baked):
        return rebaked(record.changed(realisation=realisation), renderer, record.viewing, only=("n", "k"))
    _, variant = model.realisation_of(record.group)
    return _with_group(record.changed(realisation=realisation), model, variant)


def rebaked(record: Record, renderer: Renderer = ANY_RENDERER, viewing: Mapping[str, Any] | None = None, *,
            only: tuple[str, ...] = ()) -> Record:
    """The Record whose measurement is baked again; what the bake does not give stays as the user set it.

    viewing  options of :func:`addon.bake.bake`; by default those it was baked with, in the renderer's space
    only     the parameters to take from the new bake; by default all that the model bakes

    Raises FacetFilmError for a record without a measurement.
    """
    if not record.measured:
        raise FacetFilmError("{material} holds no measurement: bake a measured preset first.", material=record.title)
    model = named(record.model)
    resolved = resolve(record.source.meant())
    options = _viewing(model, resolved, renderer, _same(record, renderer) if viewing is None else viewing)
    baked = model.bake(resolved, options, record.realisation, renderer)
    followed = [name for name, option in model.follows.items() if options[option] != record.viewing.get(option)]
    new = {name: baked.parameters[name] for name in only or (*model.baked_names, *followed)}
    found = record.changed(parameters=record.parameters.changed(**new), viewing=options, baked=baked.facts)
    return _with_group(found, model, baked.variant)


def _same(record, renderer):
    """The options that a record was baked with, in the renderer's space."""
    return {**record.viewing, "space": renderer.space}


def of_other_words(record: Record, words: str, renderer: Renderer = ANY_RENDERER, *,
                   progress: Callable[[float], Any] | None = None) -> Record:
    """The Record made of something else, its model's parameter made_of; what else the user set stays where it can.

    words     such as another stack of layers
    progress  function that is told the share that is done, of what may take seconds

    Raises FacetFilmError for words that cannot be made, and for a record of a model without such a parameter.

    >>> film = of_other_words(made(preset="TiO2 0-200 nm / Ti", roughness=0.1), "SiO2 300-400 nm / Si")
    >>> film.parameters.stack, film.parameters.thickness, film.parameters.roughness
    ('SiO2 300-400 nm / Si', 350.0, 0.1)
    """
    model = named(record.model)
    if not model.made_of:
        raise FacetFilmError("{material} is not made of what a text says: name a material of another model.",
                             material=record.title)
    words = getattr(record.parameters.changed(**{model.made_of: words}), model.made_of)
    resolved = of_stack(words, getattr(record.parameters, model.own_data, ""))
    options = _viewing(model, resolved, renderer, _same(record, renderer))
    if model.work_ahead and progress:
        model.work_ahead(resolved, options, progress)
    baked = model.bake(resolved, options, record.realisation, renderer)
    made_of = record.parameters.changed(**{name: baked.parameters[name] for name in model.baked_names})
    parameters = made_of.changed(**model.no_longer(made_of, baked))
    found = record.changed(parameters=parameters, source=_source(resolved), viewing=options, baked=baked.facts)
    return _with_group(found, model, baked.variant)


def renewed(record: Record, renderer: Renderer = ANY_RENDERER) -> Record:
    """A Record from elsewhere for this renderer: groups of this version, and baked again where its numbers are for
    another.

    What the user set stays; n and k that are still as baked follow the renderer's formula.
    """
    return switched(record, record.realisation, renderer)


def exported(record: Record, form: str) -> str:
    """The text of a record in a form that its model has.

    Raises FacetFilmError for another form, and for a record without a measurement where the form holds one.
    """
    model = named(record.model)
    choice("form", form, model.forms)
    if model.measured and not record.measured:
        raise FacetFilmError("{material} holds no measurement: bake a measured preset first.", material=record.title)
    return model.write_form(form, record)


def _with_group(record, model, variant=0):
    group = model.group_of(record.realisation, variant)
    return record.changed(group=group.identifier, version=group.version)


def _usual(model, resolved):
    """The realisation that a preset of the model is made by where none is named."""
    own = resolved is not None and resolved.preset.model == model.name and resolved.preset.realisation
    return own or next(iter(model.realisations))


def _require_of(model, resolved):
    """Raise the error of a preset that another model's materials are made of."""
    preset = resolved.preset
    if preset.model not in ("", model.name) and not (model.measured and resolved.constants is not None):
        raise FacetFilmError("{preset} is a preset of {model}: leave the model out, or name that one.",
                             preset=preset.title, model=preset.model)
    if not preset.model and not model.measured:
        raise FacetFilmError("{model} takes no measurement: name one of its presets, or another model.",
                             model=model.title)


def _what_it_is_made_of(model, resolved, parameters):
    """The Resolved; that of the words in the parameter that says what the material is made of, taken from among them.

    Raises FacetFilmError for two answers.
    """
    if not model.made_of:
        return resolved
    words = parameters.pop(model.made_of, None)
    if resolved is None:
        checked = model.parameters() if words is None else model.parameters(**{model.made_of: words})
        return resolve(getattr(checked, model.made_of))
    if words is not None:
        raise FacetFilmError("A preset and {name} both say what the material is made of: give one of them.",
                             name=model.made_of)
    return resolved


def _typed_colours(model, resolved, space):
    """The colours that a preset states, which are linear Rec.709, in a space; without those that the bake works out."""
    from ..bake.colour import converted
    stated = {} if resolved.is_own else resolved.preset.parameters
    return {row.name: converted(stated[row.name], "Rec.709", space) for row in model.parameters.TABLE
            if isinstance(row, Colour) and row.name in stated and row.name not in model.baked_names}


def _viewing(model, resolved, renderer, viewing):
    """All options of a bake, the file's working space where none is named; of what is stated and not measured the space
    alone, and {} where a model has none.
    """
    if resolved.constants is None and not model.picture:
        return {"space": renderer.space} if model.baked_names else {}
    from ..bake.reflected import Viewing
    found = Viewing(**{"space": renderer.space, **(viewing or {})})
    return {"illuminant": found.illuminant, "observer": found.observer, "space": found.space, "adapt": found.adapt,
            "gamut": found.gamut, "medium": _named_medium(found.medium)}


def _named_medium(medium):
    """A medium as a record keeps it: its index, or its name."""
    dataset = getattr(medium, "dataset", medium)
    if dataset != medium and resolve(medium).is_own:
        raise FacetFilmError("The medium outside is named by its index, a preset or a dataset; {medium} is a "
                             "measurement of your own: give its index.", medium=dataset)
    return dataset


def _source(resolved):
    if not resolved.is_own:
        model = resolved.preset.model and named(resolved.preset.model)
        own = resolved.preset.parameters.get(model.own_data, "") if model else ""
        return Source(resolved.preset.name, own)
    from ..export import spectrum_csv
    return Source(resolved.constants.dataset, spectrum_csv(resolved.constants))
