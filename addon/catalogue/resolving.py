"""What a word means: a preset, an alias, a dataset, a file or pasted text.  The only place that decides it."""

import json
import os
from typing import NamedTuple

from ..errors import FacetFilmError
from ..spectra import names, observers
from ..spectra.optical_constants import OpticalConstants, dataset_of_address, load
from . import presets
from .presets import Preset

__all__ = ["Resolved", "is_stack", "layer", "layers_in", "of_stack", "require_measured", "resolve", "resolve_widely"]

OWN = "file:"
"""What the dataset of a measurement of the user's own begins with."""


class Resolved(NamedTuple):
    """What a word means.

    preset     the Preset; for a dataset, file or text one without a model
    constants  its OpticalConstants, or None where it was not measured
    """

    preset: Preset
    constants: OpticalConstants | None

    @property
    def is_own(self):
        """Whether the measurement is the user's, which no database holds."""
        return self.constants is not None and not self.preset.model and not _is_dataset(self.preset.dataset)


def resolve(what, choose=()):
    """The Resolved of whatever names a material.

    what    a preset's name, alias or title; a dataset's id "shelf/book/page", or the address of its page; the path of a
            file, a table of several lines as text; a stack of layers such as "SiO2 0-1000 nm / Si";
            OpticalConstants, a Preset or a Resolved
    choose  of a file that holds or can mean several things: which, as :func:`addon.spectra.readers.read_file` has it

    A preset's name is that preset, whatever file lies in the folder.  Raises FacetFilmError, with what comes nearest.

    >>> resolve("Cu").preset.name, resolve("main/Cu/Johnson").preset.kind
    ('copper', 'metal')
    >>> resolve("nacre").constants is None
    True
    """
    if isinstance(what, Resolved):
        return what
    if isinstance(what, Preset):
        return Resolved(what, presets.constants(what))
    if isinstance(what, OpticalConstants):
        return Resolved(_unnamed(what), what)
    if not isinstance(what, str):
        raise FacetFilmError("A material is a preset's name or a dataset's id, not {value!r}.", value=what)
    from ..spectra import readers
    if "\n" in what:
        return resolve(readers.read_text(what, choose=choose))
    if is_stack(what):
        return of_stack(what)
    if what.lower().endswith(readers.SUFFIXES) and not _is_address(what):
        return resolve(readers.read_file(what, choose))
    try:
        return _named(what)
    except FacetFilmError:
        if os.path.isfile(what):
            return resolve(readers.read_file(what, choose))
        raise


def is_stack(text):
    """Whether a text is meant as layers in the notation of addon.bake.stack_notation: has a bar, or slashes with spaces
    around.

    >>> is_stack("SiO2 0-1000 nm / Si"), is_stack("main/Cu/Johnson")
    (True, False)
    """
    return isinstance(text, str) and (" / " in text or "|" in text)


def _is_address(what):
    """Whether what looks like a file is none, and names a dataset of the database."""
    return not os.path.exists(what) and dataset_of_address(what) is not None


def resolve_widely(what):
    """The same; words that name nothing are the best that a search finds of what has a dataset.

    >>> resolve_widely("babar gold").preset.dataset
    'main/Au/Babar'
    """
    try:
        return resolve(what)
    except FacetFilmError:
        from .search import search
        worded = isinstance(what, str) and what.count("/") < 2 and not is_stack(what)
        found = [entry for entry in search(what, 20) if entry.dataset] if worded else ()
        if not found:
            raise
        return resolve(found[0].dataset)


def require_measured(what):
    """The Resolved of a material that was measured.

    Raises FacetFilmError for a preset that was not, and as :func:`resolve` does.
    """
    found = resolve(what)
    if found.constants is None:
        raise FacetFilmError("{preset} was not measured: it is a preset of {model}, which has no spectrum to bake. "
                             "Make a material of it, or name a measured preset such as 'copper'.",
                             preset=found.preset.title, model=found.preset.model)
    return found


def _named(word):
    """A preset's or a dataset's."""
    if "/" in word:
        constants = load(word)
        return Resolved(_unnamed(constants), constants)
    try:
        preset = presets.find(word)
    except FacetFilmError:
        from .search import search
        fitting = search(word, 4, guess=False) if word.strip() else []
        if not fitting:
            raise
        some = ", ".join(repr(found.id) for found in fitting[:3]) + (", …" if len(fitting) > 3 else "")
        raise FacetFilmError("preset {preset!r} is unknown; what fits these words: {found}.",
                             preset=word, found=some) from None
    return Resolved(preset, presets.constants(preset))


def of_stack(text, held=""):
    """The Resolved of a stack of layers in words, checked; see addon.bake.stack_notation.

    held  measurements of the user's own that stand for words of it, as :func:`layers_in` reads them: they go before
          files, which may be on another computer

    Its preset holds those that the stack has beside its words, so that it can be baked again where no file is.
    """
    from .. import models
    from ..bake.film_curve import is_curve, knots_of
    from ..bake.stack_notation import parse, written
    own = ""
    if is_curve(text):
        knots_of(text)
    else:
        stack = parse(text, layers_in(held))
        text, own = written(stack), _own_layers(stack)
    model = next(model for model in models.all_models() if model.made_of == "stack")
    parameters = {model.made_of: text, **({model.own_data: own} if own else {})}
    return Resolved(Preset(text, text, "iridescent", model=model.name, parameters=parameters), None)


def layer(word):
    """The OpticalConstants of a layer of a stack: a dataset, a file or a measured preset; FacetFilmError for others."""
    return require_measured(word).constants


def layers_in(held):
    """A look-up of layers as :func:`layer`, which knows measurements of the user's own first.

    held  JSON, {word: fields of its OpticalConstants}; "" for none

    >>> held = '{"my oxide": {"wavelength_nm": [400, 700], "n": [2.0, 1.9], "k": [0.0, 0.0], "dataset": "file:mine"}}'
    >>> layers_in(held)("my oxide").at(550.0)[0].item()
    1.95
    """
    own = {word: OpticalConstants(**fields) for word, fields in json.loads(held).items()} if held else {}
    return lambda word: own[word] if word in own else layer(word)


def _own_layers(stack):
    """The JSON of what is the user's own of a Stack, or ""."""
    own = {word: {"wavelength_nm": constants.wavelength_nm.tolist(), "n": constants.n.tolist(),
                  "k": constants.k.tolist(), "dataset": constants.dataset, "title": constants.title,
                  "citation": constants.citation, "licence": constants.licence, "range_nm": list(constants.range_nm),
                  "has_k": constants.has_k, "normal_only": constants.normal_only}
           for word, constants in stack.layers if constants.dataset.startswith(OWN)}
    return json.dumps(own, ensure_ascii=False) if own else ""


def _unnamed(constants):
    mean_k = float(constants.at(observers.WAVELENGTH_NM)[1].mean())
    kind = names.kind_of(constants.dataset, mean_k) if _is_dataset(constants.dataset) else "measured"
    return Preset(constants.dataset, constants.title or constants.dataset, kind, dataset=constants.dataset)


def _is_dataset(identifier):
    return identifier.count("/") >= 2 and not identifier.startswith(OWN)
