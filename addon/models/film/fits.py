"""How the film model is fitted to measured BRDFs whose colour changes with the angle: F free between knots."""

import numpy as np

from ...bake.film_curve import curve_in_words
from ...reflectance.film_facets import ROUGHEST_FITTED
from ..fitted import UP, Form
from .formulas import standard

__all__ = ["DEGREES", "Curve"]

DEGREES = (0.0, 15.0, 30.0, 45.0, 60.0, 72.0, 83.0, 90.0)
"""Where a curve has its knots: angles between light and facet."""
BEND_WEIGHTS = np.array([1.0, 1.0, 1.0, 1.0, 0.3, 0.1])[:, None]


class Curve(Form):
    """F over the angle as the model's table has it, on facets of one slope or two; see addon.bake.film_curve."""

    name = "curve"
    low_f, high_f = (0.0,) * len(DEGREES), (1.0,) * len(DEGREES)
    most_slopes = 2
    tried = 1
    roughest = ROUGHEST_FITTED

    def facets(self, slopes, kept):
        """Its roughness and the second slope; a curve has no thickness."""
        found = {"roughness": kept(slopes[0][0] ** 0.5), "thickness": 0.0}
        for m, w in slopes[1:]:
            found.update(second_ratio=kept(m / slopes[0][0]), second_weight=kept(w))
        return found

    def standard(self, parameters, v, l, formula):
        """The same in every Blender."""
        return standard(parameters, UP, v, l)

    def fresnel(self, rows, kept):
        """The curve in words."""
        return {"stack": curve_in_words(DEGREES, [tuple(map(kept, row)) for row in rows])}

    def bends(self, p):
        """Second differences of the knots, less of those at grazing, where every curve bends up."""
        return (np.diff(self._rows(p), 2, axis=0) * BEND_WEIGHTS).ravel()

    def rows_of(self, f0):
        """Schlick's curve."""
        cosine = np.cos(np.radians(DEGREES))[:, None]
        return f0 + (1.0 - f0) * (1.0 - cosine) ** 5

    def reflectance_of(self, rows):
        """The first knot."""
        return rows[0]
