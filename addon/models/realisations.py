"""The ways from a formula to a Cycles material.  Read when Blender starts, so it loads nothing."""

from ..errors import choice

__all__ = ["NAMES", "REALISATIONS", "Realisation", "realisation_chosen", "realisation_named"]


class Realisation:
    """A way from a formula to a Cycles material.

    title        what people call it
    tip          one sentence on when to take it
    native       whether the renderer's own closures draw it, with its own Fresnel term
    osl          whether it is a script, which needs Open Shading Language
    without_osl  name of the realisation that a script's material shows where Open Shading Language is off
    """

    def __init__(self, title, tip, *, native=False, osl=False, without_osl=""):
        self.title, self.tip, self.native, self.osl, self.without_osl = title, tip, native, osl, without_osl


REALISATIONS = {
    "fast": Realisation("Standard", "Clean and fast, on every device and in EEVEE: the one to take first", native=True),
    "exact": Realisation("Reference", "The published formula itself, on every device: slower and noisier, to compare "
                                      "with; EEVEE shows Standard"),
    "dispersive": Realisation("Dispersive", "Every wavelength refracted by its own index, for rainbows in gems and "
                                            "prisms; noisier, and EEVEE shows it without them", native=True),
    "osl": Realisation("OSL", "The published formula as an OSL script: needs Open Shading Language switched on in the "
                              "Render properties, on the CPU or OptiX; EEVEE shows Standard", osl=True,
                       without_osl="exact"),
    "osl_fast": Realisation("OSL Standard", "Standard as an OSL script: needs Open Shading Language switched on",
                            native=True, osl=True, without_osl="fast"),
}
"""Every realisation that a model may have, by its name."""
NAMES = {"standard": "fast", "reference": "exact", "osl_standard": "osl_fast"}
"""The names that people know them by, beside those that scripts and files have used from the start."""


def realisation_named(name):
    """The name in REALISATIONS of a realisation by either of its names; others as they are.

    >>> realisation_named("reference"), realisation_named("fast")
    ('exact', 'fast')
    """
    return NAMES.get(name, name) if isinstance(name, str) else name


def realisation_chosen(name, valid):
    """The name in REALISATIONS of one of the valid ones, by either of its names.

    >>> realisation_chosen("standard", ("fast", "exact"))
    'fast'
    >>> realisation_chosen("referense", ("fast", "exact"))
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: realisation 'referense' is unknown; did you mean 'reference'? Valid: 'standard', \
'reference'.
    """
    known_as = {found: shown for shown, found in NAMES.items()}
    found = realisation_named(name)
    if not isinstance(found, str) or found not in valid:
        choice("realisation", name, [known_as.get(one, one) for one in valid])
    return found
