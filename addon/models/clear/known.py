"""What was found of the absorption of the presets' datasets in the usual light, so that a click does not wait for it to
be found again.

clear.table is made by tools/build_clear_facts.py; what is not in it is worked out.
"""

import functools

from ...bake.clear_absorption import Attenuation
from ...spectra import tables as packed

__all__ = ["NAME", "attenuation", "attenuations"]

NAME = "clear"
SAME = 1e-9
"""Share by which the sum of a spectrum may differ from that of the one that was fitted: another is another's."""


@functools.cache
def attenuations():
    """{dataset whose k it is: (sum of α in 1/m, its Attenuation)}."""
    if not (packed.DIRECTORY / f"{NAME}.table").exists():
        return {}
    return {dataset: (total, Attenuation(tuple(sigma), tuple(colour), distance, delta_e))
            for dataset, total, sigma, colour, distance, delta_e in packed.part(NAME, "attenuations")["rows"]}


def attenuation(dataset, alpha):
    """The Attenuation of an absorption spectrum ``(421,)`` in 1/m, where it is known by its dataset; else None.

    >>> from ...bake.clear_absorption import alpha_of
    >>> from ...spectra.optical_constants import load
    >>> glass = alpha_of(load("glass/soda-lime/Rubin-clear"))
    >>> round(attenuation("glass/soda-lime/Rubin-clear", glass).distance, 3)
    0.113
    >>> attenuation("glass/soda-lime/Rubin-clear", 2.0 * glass) is None
    True
    """
    total, found = attenuations().get(dataset, (0.0, None))
    return found if abs(alpha.sum() - total) <= SAME * total else None
