"""What the shell's commands print for people."""

__all__ = ["baked", "checked", "columns", "finishes", "fitted", "found", "illuminants", "presets", "record", "spread",
           "swatch", "ways"]

SHOWN_DEGREES = (0, 30, 60, 75, 80, 85, 89)
CHANNELS = ("red", "green", "blue")


def presets(records):
    """A line a preset.

    records  Presets
    """
    return columns([(p.name, p.title, p.kind, p.dataset or ("estimated" if p.measured else "not measured"))
                    for p in records])


def record(made):
    """A material as its parameters, and what is to be said about it.

    made  an addon.models.record.Record
    """
    rows = [("finish", made.finish)] if made.finish else []
    rows += [(name, _words(value)) for name, value in made.parameters.to_dict().items()]
    return "\n".join([f"{made.title} ({made.model})", columns(rows, "  "),
                      *(f"  {note}" for note in filter(None, [made.baked.get("note")]))])


def _words(value):
    """A parameter's value; of a list of lists, those between commas."""
    if not isinstance(value, list):
        return f"{value:g}" if isinstance(value, float) else str(value)
    return (", " if value and isinstance(value[0], list) else " ").join(map(_words, value))


def finishes(found):
    """A line a finish.

    found  Finishes
    """
    return columns([(finish.name, finish.title, " ".join(f"{m:g}" for m, _ in finish.slopes),
                     f"{finish.anisotropy:g}" if finish.anisotropy else "", finish.source) for finish in found])


def illuminants(titles):
    """A line an illuminant.

    titles  what each is, by name
    """
    return columns(list(titles.items()))


def found(results, limit):
    """A line a material that a search found, and a line a measurement below them.

    results  addon.catalogue.search.Results
    """
    said = [f"Nothing is called {results.missing!r}. The nearest:"] if results.missing else []
    materials = results.materials[:limit]
    measurements = results.measurements[:limit - len(materials)]
    if materials:
        said.append(columns([(entry.id, entry.title, entry.kind, _covered(entry)) for entry in materials]))
    if measurements:
        rows = [(entry.id, entry.title, entry.kind, _covered(entry)) for entry in measurements]
        said += ["Measurements:", columns(rows, "  ")]
    return "\n".join(said)


def _covered(entry):
    return "" if entry.covers_visible else "part of the visible only"


def baked(bake):
    """A bake as a table.

    bake  an addon.bake.Bake
    """
    source, low_high = bake.source, "{:.0f} to {:.0f} nm".format(*bake.source.wavelength_range_nm)
    held = "" if source.covers_visible else "; held beyond, where the visible goes on"
    rows = [
        ("", *CHANNELS),
        ("F0", *numbers(bake.f0)),
        ("F82 tint", *numbers(bake.f82_tint)),
        ("n", *numbers(bake.conductor.n)),
        ("k", *numbers(bake.conductor.k)),
    ]
    facts = [
        ("dataset", f"{source.dataset}, {low_high}, {source.licence}{held}"),
        ("citation", source.citation),
        ("colour", _colour(bake) + _white(bake)),
        ("fit", f"n and k ({bake.conductor.formula}) within {bake.conductor.delta_e_2000_max:.3f} "
                f"CIEDE2000 from 0 to 89°, F82 within {bake.f82.delta_e_2000_max:.3f}"),
        ("curve", f"{len(bake.fresnel.cos_theta)} points"),
        ("gamut", _gamut(bake.gamut)),
    ]
    facts += [("read as", line) for line in source.assumed]
    if bake.medium != 1.0:
        facts.append(("outside", str(bake.medium)))
    if bake.estimated not in ("", source.citation):
        facts.append(("estimated", bake.estimated))
    return "\n".join([bake.title, columns(rows, "  "), columns(facts, "  ")])


def _white(bake):
    if bake.adapted:
        return ", adapted"
    if max(bake.white) - min(bake.white) < 0.01:
        return ""
    return ", in which white is " + " ".join(f"{channel:.2f}" for channel in bake.white)


def _gamut(gamut):
    if not gamut.outside:
        return "inside"
    return f"outside: {gamut.method}, channels changed by up to {gamut.largest_change:.3f}"


def checked(check):
    """A check as a table.

    check  an addon.bake.Check
    """
    rows = [("", *CHANNELS)]
    for title, given, measured in (("F0", check.f0, check.against_f0), ("F82", check.f82, check.against_f82),
                                   ("F82 tint", check.f82_tint, check.against_f82_tint)):
        rows += [(title, *numbers(given)), ("  measured", *numbers(measured))]
    curve = [("cos", *CHANNELS)]
    curve += [(f"{c:.3f}", *numbers(rgb)) for c, rgb in zip(check.fresnel.cos_theta, check.fresnel.rgb)]
    return "\n".join([
        f"{check.given} against {check.against} ({check.dataset}), {_colour(check)}",
        columns(rows, "  "),
        f"  CIEDE2000 {check.delta_e_2000_normal:.2f} at 0°, at most {check.delta_e_2000_max:.2f} "
        f"(at {check.at_degrees:.0f}°)",
        "  curve", columns(curve, "    ")])


def fitted(fit):
    """A fit as a table.

    fit  an addon.measured.Fit
    """
    rows = [(name, " ".join(f"{x:.4g}" for x in _flat(value)) if isinstance(value, list) else _rounded(value))
            for name, value in fit.parameters.to_dict().items()]
    samples = f"{fit.used} used, {fit.rejected} left out"
    tried = ", ".join(f"{name} {difference:.2f}" for name, difference in fit.tried.items())
    facts = [("colour", f"CIEDE2000 {fit.mean:.2f} on average, below {fit.p95:.1f} in 95 % of the picture, in a light "
                        "that was not fitted to"),
             ("in Standard", f"{fit.standard['exact']:.2f}; in Blender 4.5 {fit.standard['blender-4.5']:.2f}"),
             ("worst", f"{fit.worst:.1f} where it is seen {fit.worst_degrees:.0f}° from its normal"),
             ("samples", samples), ("tried", f"{tried}, in the lights that were fitted to"),
             ("verdict", fit.verdict), *(("read as", note) for note in fit.notes)]
    return "\n".join([f"{fit.title} ({fit.file}, {fit.form}): {fit.model}, {fit.fresnel}", columns(rows, "  "),
                      columns(facts, "  ")])


def _flat(value):
    return [x for item in value for x in (_flat(item) if isinstance(item, list) else [item])]


def _rounded(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def swatch(title, strip, colours):
    """Colours face on, a line a place.

    strip    an addon.models.model.Swatch
    colours  each place's #rrggbb
    """
    rows = [(f"{place:.3g} {strip.unit}", colour) for place, colour in zip(strip.places, colours)]
    return "\n".join([f"{title} over {strip.over}", columns(rows, "  ")])


def spread(found):
    """Measurements of one material, a line each.

    found  an addon.bake.Spread
    """
    rows = [("dataset", "F0 red", "green", "blue", "CIEDE2000 at 0°", "at most", "")]
    for one in found.measurements:
        differences = (f"{one.delta_e_2000_normal:.2f}", f"{one.delta_e_2000_max:.2f}")
        rows.append((one.dataset, *numbers(one.f0), *differences, one.title))
    return "\n".join([
        f"{found.material}, {len(found.measurements)} measurements, "
        f"differences from {found.reference}, {_colour(found)}",
        columns(rows, "  "),
        f"  farthest apart: {found.farthest[0]} and {found.farthest[1]}, "
        f"CIEDE2000 {found.farthest_delta_e_2000:.2f} at 0°"])


def ways(found):
    """The ways to a colour over angle, three lines each.

    found  an addon.bake.Ways
    """
    rows = [("", "", *(f"{angle}°" for angle in SHOWN_DEGREES))]
    for way in found.ways:
        for i, channel in enumerate(CHANNELS):
            shown = [f"{way.rgb[angle][i]:.3f}" for angle in SHOWN_DEGREES]
            rows.append((way.title if i == 0 else "", channel, *shown))
    errors = [(way.title, f"CIEDE2000 at most {way.delta_e_2000_max:.2f} (at {way.at_degrees:.0f}°)")
              for way in found.ways[1:]]
    return "\n".join([f"{found.title} ({found.dataset}), {_colour(found)}", columns(rows, "  "),
                      "  from exact", columns(errors, "    ")])


def _colour(found):
    return f"{found.space}, illuminant {found.illuminant}, observer {found.observer}"


def numbers(values):
    """Numbers with four decimals.

    >>> numbers((0.5, 1))
    ['0.5000', '1.0000']
    """
    return [f"{value:.4f}" for value in values]


def columns(rows, indent=""):
    """Rows of text cells as lines whose cells stand below each other.

    >>> print(columns([("a", "b"), ("long", "c")]))
    a     b
    long  c
    """
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths)) for row in rows)
    return "\n".join((indent + line).rstrip() for line in lines)
