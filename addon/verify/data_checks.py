"""The checks of the measured data: every preset's fit, and what a renderer makes of it against the spectrum."""

import numpy as np

from .. import api
from ..bake import bake
from ..bake.colour import delta_e_2000, lab
from ..bake.reflected import Viewing, reflect
from ..blender import compat
from ..catalogue import presets
from . import scenes
from .checks import Check, Figure, Outcome, Picture

__all__ = ["checks", "table_of_presets"]

METALS = ("copper", "gold", "aluminium", "titanium")
NARROW = ((0.02, 1.0),)
"""A slope so small that a sphere in an even world shows F(N·V)."""

RESOLUTION, SAMPLES = 32, 64
RIM = 0.25
MOST_EXACT, MOST_NATIVE = 0.5, {"exact": 0.5, "blender-4.5": 4.0}
RENDERED = 0.5


def checks(realisations):
    """The checks of the bake, and of its colours as these realisations render them."""
    found = [Check("data", "", "fits of all presets", "n and k fitted to each preset's Fresnel curve, or F0 and F82 "
                   "where they come closer: largest CIEDE2000 over angle, for the exact equation and for this "
                   "Blender's own", fits)]
    for realisation in realisations:
        for metal in METALS:
            found.append(Check("data", realisation, f"colours of {metal}", "a nearly smooth sphere in an even white "
                               "world against the measured spectrum at every angle: CIEDE2000 where N·V is above 0.25",
                               rendered_colours, {"preset": metal}))
    return found


def measured_presets():
    """The presets that have a spectrum."""
    return [preset for preset in presets.all_presets().values() if preset.measured]


def table_of_presets():
    """(name, kind, dataset, largest CIEDE2000 of n and k, by this Blender's own equation, of F0 and F82) of each."""
    native = compat.conductor_formula()
    rows = []
    for preset in measured_presets():
        exact = bake(preset.name, formula="exact")
        own = exact if native == "exact" else bake(preset.name, formula=native)
        rows.append((preset.title, preset.kind, exact.source.dataset, exact.conductor.delta_e_2000_max,
                     own.conductor.delta_e_2000_max, exact.f82.delta_e_2000_max))
    return rows


def fits(_realisation, rendered, _parameters):
    """rendered  "worse_by" spoils the fits by so many CIEDE2000, to see the check fail"""
    rows = table_of_presets()
    worse = rendered.get("worse_by", 0.0)
    exact = max(min(row[3], row[5]) for row in rows) + worse
    native = max(min(row[4], row[5]) for row in rows) + worse
    return Outcome((Figure("largest CIEDE2000, exact equation", exact, MOST_EXACT),
                    Figure("largest CIEDE2000, this Blender's equation", native,
                           MOST_NATIVE[compat.conductor_formula()])))


def rendered_colours(realisation, rendered, parameters):
    """What the preset looks like under the observer and illuminant that it was baked for."""
    scene = scenes.empty_scene(RESOLUTION, samples=SAMPLES, osl=realisation.startswith("osl"))
    scenes.add_sphere(api.create_material(realisation=realisation, slopes=NARROW, specular=1.0, sampling_width=0.0,
                                          **rendered))
    scenes.set_world(scene, 1.0)
    picture = scenes.render(scene)
    normals, mask = scenes.pixel_normals(RESOLUTION, subsamples=3)
    mask &= normals[..., 2].min(axis=2) > RIM
    space = compat.working_space()
    reference = np.zeros_like(picture)
    curve = reflect(parameters["preset"], Viewing(space=space)).mapped_at
    cosines = np.linspace(RIM, 1.0, 64)
    colours = curve(cosines)
    for channel in range(3):
        reference[mask, channel] = np.interp(normals[mask][..., 2], cosines, colours[:, channel]).mean(axis=1)
    picture[~mask] = 0.0
    difference = delta_e_2000(lab(picture[mask], space), lab(reference[mask], space))
    return Outcome((Figure("largest CIEDE2000", float(difference.max()), RENDERED),
                    Figure("mean CIEDE2000", float(difference.mean()), 0.5 * RENDERED)), Picture(reference, picture))
