"""What the shell's commands do: each takes the parsed options and gives its text, or (text, exit status)."""

from ..errors import FacetFilmError, number
from ..export import json_text
from . import text as shown

__all__ = ["bake_command", "check_command", "fit_command", "list_command", "search_command", "spread_command",
           "swatch_command", "verify_command", "ways_command"]

SHOWN_COLOURS = 9
"""Of a strip, in a table or JSON."""
VIEWING = ("illuminant", "observer", "space", "adapt", "gamut", "medium")
SURFACE = ("finish", "roughness", "tint", "anisotropy", "rotation")
FORMS = ("json", "csv", "spectrum_csv", "materialx")


def _given(options, *names):
    """The options of these names that the command has, as keywords."""
    return {name: getattr(options, name) for name in names if hasattr(options, name)}


def _json(value):
    return json_text(value).rstrip()


def list_command(options):
    """The presets of all models, the finishes, or the illuminants."""
    if options.what == "finishes":
        from ..finishes import all_finishes
        found = all_finishes()
        if options.json:
            return _json([{**vars(finish), "controls": dict(finish.controls)} for finish in found])
        return shown.finishes(found)
    if options.what == "illuminants":
        from ..spectra import illuminants
        titles = {name: illuminants.title(name) for name in illuminants.names()}
        return _json(titles) if options.json else shown.illuminants(titles)
    from ..catalogue import presets
    found = presets.all_presets().values()
    if options.json:
        return _json([{"name": p.name, "title": p.title, "kind": p.kind, "model": p.model, "dataset": p.dataset,
                       "aliases": p.aliases, "estimated": p.estimated} for p in found])
    return shown.presets(found)


def bake_command(options):
    """Colours and parameters of a material; of one that was not measured the parameters alone."""
    from ..catalogue.resolving import resolve
    from ..export import write_text
    resolved = resolve(options.material, options.choose)
    surface = _given(options, *SURFACE)
    if _is_a_curve(resolved) and not surface:
        written = _form(options, resolved)
    else:
        written = _made(options, resolved, surface)
    if options.output is None:
        return written
    return "Wrote " + write_text(options.output, written + "\n")


def _is_a_curve(resolved):
    """Whether a measurement is baked alone, as a curve over the angle; other models bake a whole material of it."""
    from ..models import DEFAULT, named
    return resolved.constants is not None and named(resolved.preset.model or DEFAULT).facts is not None


def _form(options, resolved):
    """A measured curve in the form that was asked for."""
    from .. import export
    from ..bake import bake
    baked = bake(resolved, **_given(options, *VIEWING, "formula", "from_normal_reflectance"))
    if options.csv:
        return export.curve_csv(baked).rstrip()
    if options.spectrum_csv:
        return export.spectrum_csv(resolved.constants).rstrip()
    if options.json:
        from ..models import DEFAULT, named
        return _json(named(resolved.preset.model or DEFAULT).facts(resolved, baked))
    if options.materialx:
        from ..models.making import exported, made
        export.require_exact(baked)
        return exported(made(preset=resolved, viewing=_given(options, *VIEWING)), "materialx").rstrip()
    return shown.baked(baked)


def _made(options, resolved, surface):
    """What was baked into a material, in the form that was asked for; of one that was not measured its parameters.

    surface  {parameter: value} that takes the place of the preset's own
    """
    from ..models.making import exported, made
    record = made(preset=resolved, viewing=_given(options, *VIEWING), **surface)
    form = next((form for form in FORMS if getattr(options, form) and (surface or form != "json")), None)
    if form == "json" and not record.measured:
        return _json(record.to_dict())
    if form and record.measured:
        return exported(record, form).rstrip()
    if form:
        raise FacetFilmError("{preset} was not measured: it has parameters and no curve. Leave the form out, or take "
                             "--json.", preset=resolved.preset.title)
    if not options.json:
        return shown.record(record)
    return _json(record.baked if record.measured else record.to_dict())


def swatch_command(options):
    """A material's colours over what they depend on, as a table, JSON or a picture."""
    from ..catalogue.resolving import resolve
    from ..export import swatch_picture, write_bytes
    from ..models import named
    from ..models.making import made
    record = made(preset=resolve(options.material, options.choose), viewing=_given(options, *VIEWING))
    draw = named(record.model).swatch
    if draw is None:
        raise FacetFilmError("{material} is no measurement, and its colours depend on the place as well: a strip of "
                             "them would say nothing.", material=record.title)
    swatch = draw(record, swatch_picture.COLUMNS if options.output else SHOWN_COLOURS)
    if options.output:
        return "Wrote " + write_bytes(options.output, swatch_picture.swatch_png(swatch, options.space))
    colours = swatch_picture.swatch_hex(swatch, options.space)
    if options.json:
        return _json({"title": record.title, "over": swatch.over, "unit": swatch.unit, "places": swatch.places.tolist(),
                      "rgb": swatch.rgb.tolist(), "space": options.space, "srgb": colours})
    return shown.swatch(record.title, swatch, colours)


def search_command(options):
    """The materials that fit some words."""
    from ..catalogue.search import look_up
    number("--limit", options.limit, 1)
    words = " ".join(options.text)
    found = look_up(words, options.limit)
    entries = [*found.materials, *found.measurements][:options.limit]
    if options.json:
        return _json([entry._asdict() for entry in entries])
    if not entries:
        raise FacetFilmError(
            f"Nothing fits {words!r}; try a material, an author or a formula, such as 'gold babar'.")
    return shown.found(found, options.limit)


def check_command(options):
    """How far given numbers or a material are from a measured one."""
    from ..bake import check
    from ..catalogue.resolving import resolve
    given = _given(options, *VIEWING, "formula", "n", "k", "f0", "tint")
    given.update({name: _colour(given[name]) for name in ("f0", "tint") if given.get(name)})
    found = check(resolve(options.against, options.choose),
                  preset=options.material and resolve(options.material, options.choose), **given)
    return _json(found.to_dict()) if options.json else shown.checked(found)


def _colour(words):
    """A colour of the command line: three numbers, or one word such as "#ffd98b"."""
    if len(words) == 1:
        return words[0]
    try:
        return tuple(float(word) for word in words)
    except ValueError:
        raise FacetFilmError(f"A colour is three numbers, or one such as '#ffd98b', not {' '.join(words)!r}.") from None


def spread_command(options):
    """All measurements of a material."""
    from ..bake import spread
    found = spread(options.material, **_given(options, *VIEWING))
    return _json(found.to_dict()) if options.json else shown.spread(found)


def ways_command(options):
    """The paper's ways to a colour."""
    from ..bake import ways
    from ..catalogue.resolving import resolve
    found = ways(resolve(options.material, options.choose), **_given(options, *VIEWING))
    return _json(found.to_dict()) if options.json else shown.ways(found)


def fit_command(options):
    """A model fitted to a measured BRDF."""
    from ..export.writing import write_bytes
    from ..measured import fit
    found = fit(options.file, fresnel=options.fresnel, slopes=options.slopes, distribution=options.distribution)
    said = _json(found.to_dict()) if options.json else shown.fitted(found)
    if options.picture:
        from ..measured.picture import picture
        written = write_bytes(options.picture, picture(found))
        return said if options.json else f"{said}\n  wrote {written}"
    return said


def verify_command(options):
    """The verification; status 1 where it is not green."""
    from ..verify import verify
    green, said = verify(options.output, device=options.device, only=options.only, record=options.json,
                         say=lambda line: print(line, flush=True))
    return said, 0 if green else 1
