"""From a measured material to a clear one: its index, its dispersion, its absorption."""

import numpy as np

from ...bake.clear_absorption import CLEAR, alpha_of, attenuation_of
from ...bake.clear_index import index_of
from ...bake.reflected import Viewing, index_of_medium
from ...reflectance.fresnel import dielectric
from ...reflectance.transmission import LAMBDA_D
from ...spectra import observers, optical_constants
from ..model import Baked, Look
from . import known
from .parameters import Clear

__all__ = ["absorbing", "bake_for", "facts_of", "look"]

K_FROM, ABBE = "k_from", "abbe"
"""Of a preset's parameters what the bake reads: the dataset whose k it is, or "none"; V_d where a maker states it."""

SEEN = 0.02
"""Metres of a body that a small picture shows."""


def bake_for(resolved, viewing):
    """The Baked of a measured material.

    resolved  an addon.catalogue.resolving.Resolved with constants
    viewing   options of addon.bake.reflected.Viewing
    """
    index, attenuation = found_in(resolved, viewing)
    own = {name: value for name, value in resolved.preset.parameters.items() if name in Clear.__dataclass_fields__}
    parameters = {"ior": min(max(index.d, 1.0), 10.0), "cauchy_b": index.b, "cauchy_c": index.c,
                  "absorption": attenuation.sigma, "outside": _n_d(index_of_medium(Viewing(**viewing).medium)), **own}
    return Baked(parameters, facts_of(resolved, viewing, index, attenuation))


def _n_d(n):
    """At the d line, of one n or of n ``(421,)``."""
    return float(np.interp(1e3 * LAMBDA_D, observers.WAVELENGTH_NM, np.broadcast_to(n, observers.WAVELENGTH_NM.shape)))


def found_in(resolved, viewing):
    """(Index, Attenuation) of a measured material."""
    index = index_of(resolved.constants, resolved.preset.parameters.get(ABBE))
    k = absorbing(resolved)
    return index, CLEAR if k is None else _attenuation(k, Viewing(**viewing))


def _attenuation(k, viewing):
    alpha = alpha_of(k)
    of_a_preset = known.attenuation(k.dataset, alpha) if viewing == Viewing() else None
    return of_a_preset or attenuation_of(alpha, viewing)


def absorbing(resolved):
    """The OpticalConstants whose k is the body's, or None where none was measured or what was is no absorption."""
    k_from = resolved.preset.parameters.get(K_FROM)
    if k_from == "none":
        return None
    found = optical_constants.load(k_from) if k_from else resolved.constants
    return found if found.has_k else None


def facts_of(resolved, viewing, index, attenuation):
    """All that was baked, ready for JSON."""
    preset, constants, k = resolved.preset, resolved.constants, absorbing(resolved)
    return {
        "name": preset.name, "title": preset.title, "kind": preset.kind,
        "note": " ".join(filter(None, (preset.note, preset.estimated, _in_words(index, attenuation, k)))),
        "ior": {"d": index.d, "cauchy": list(index.terms), "error_max": index.error_max},
        "abbe": index.abbe,
        "attenuation": {"sigma_per_m": list(attenuation.sigma), "colour": list(attenuation.colour),
                        "distance_m": attenuation.distance, "delta_e_2000_max": attenuation.delta_e},
        **viewing,
        "source": {"dataset": constants.dataset, "k_dataset": k.dataset if k else "", "citation": constants.citation,
                   "licence": constants.licence}}


def _in_words(index, attenuation, k):
    said = f"n_d {index.d:.4f}" + (f", V_d {index.abbe:.1f}" if index.abbe else ", no dispersion in the data")
    if k is None:
        return said + "; no absorption was measured."
    if attenuation.distance is None:
        return said + "; absorbs nothing that is seen."
    return said + (f"; half the light is left after {attenuation.distance:.3g} m, colours over depth within CIEDE2000 "
                   f"{attenuation.delta_e:.1f}.")


def look(parameters):
    """The Look of a Clear: what two centimetres let through."""
    p = parameters
    dyed = -np.log(np.maximum(p.depth_colour, 1e-6)) / p.depth
    through = np.exp(-p.concentration * SEEN * (np.array(p.absorption) + dyed)) * np.array(p.tint)
    f0 = float(dielectric(1.0, p.ior))
    return Look(through, np.full(3, f0), f0, max(p.roughness**2, 0.001), through)
