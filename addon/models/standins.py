"""What a record is to programs that know base colour, metalness and roughness alone."""

import numpy as np

from ..bake.colour import converted
from ..bake.standin_fit import COS_THETA, fit_dielectric
from ..export.standin import LOST, Standin, index_of
from . import named
from .making import ANY_RENDERER, renewed
from .moving import moved, space_of
from .parameters import Colour
from .record import Record

__all__ = ["standin_of", "under_an_even_sky"]

RINGS, SPOKES = 96, 192
"""Directions that the light of an even sky is taken from."""


def standin_of(record: Record, space: str = "Rec.709") -> Standin:
    """The Standin of a record, tuned or not.

    space  of the colours of a record that nothing was baked into

    >>> from .making import made
    >>> standin_of(made(preset="gold")).metallic
    1.0
    """
    model, here = named(record.model), renewed(record)
    if space_of(here):
        here = moved(here, ANY_RENDERER)
    else:
        colours = {row.name: converted(getattr(here.parameters, row.name), space, ANY_RENDERER.space)
                   for row in here.parameters.TABLE if isinstance(row, Colour)}
        here = here.changed(parameters=here.parameters.changed(**colours))
    if model.standin is not None:
        return model.standin(here)
    look = model.look(here.parameters, None)
    seen = np.clip(under_an_even_sky(model, here.parameters), 0.0, 1.0)
    fit = fit_dielectric(seen, 0.04)
    return Standin(fit.base, roughness=min(float(look.slope) ** 0.5, 1.0), ior=max(index_of(fit.beside[0]), 1.0),
                   delta_e=(fit.delta_e_mean,) * 2, lost=(LOST["look"],))


def under_an_even_sky(model, parameters):
    """Linear RGB that an even sky of radiance 1 shows on a material of a model at COS_THETA, ``(24, 3)``.

    Of its evaluate, over directions that lie even in the projected solid angle.
    """
    sine = np.sqrt((np.arange(RINGS) + 0.5) / RINGS)[:, None]
    azimuth = 2.0 * np.pi * (np.arange(SPOKES) + 0.5) / SPOKES
    light = np.stack(np.broadcast_arrays(sine * np.cos(azimuth), sine * np.sin(azimuth), np.sqrt(1.0 - sine**2)), -1)
    light = light.reshape(-1, 3)
    up = np.broadcast_to([0.0, 0.0, 1.0], light.shape)
    return np.pi * np.stack([
        model.evaluate(parameters, up, np.broadcast_to([np.sqrt(1.0 - c * c), 0.0, c], light.shape), light).mean(axis=0)
        for c in COS_THETA])
